// Tests uses of sums by law and by definition: morphology, no-fit polygons, depth and location.
// MINKSUM_PAIRS is the number of pairs.
#include <gtest/gtest.h>

#include <cmath>

#include "minksum/boolean.hpp"
#include "minksum/depth.hpp"
#include "minksum/morphology.hpp"
#include "minksum/no_fit.hpp"
#include "minksum/resolve.hpp"
#include "minksum/transform.hpp"
#include "reference/membership.hpp"
#include "support/generators.hpp"
#include "support/polygon_kinds.hpp"
#include "support/shapes.hpp"

namespace minksum {
namespace {

using test::Random;

const int kPairs = test::count_from_environment(250);

Geometry as_geometry(const Region& region) { return {region, {}, {}}; }

Region at(const Region& region, const Point& x) {
  return transform(region, Affine::translation(x.x, x.y));
}

/// Returns a point of the grid of halves around a box from 0 to 24.
Point random_point(Random& random) {
  return {Rational(random.between(-30, 60), 2), Rational(random.between(-30, 60), 2)};
}

std::string message(const test::Pair& pair) {
  return pair.kind + "\n" + test::to_text(pair.p) + "\n" + test::to_text(pair.q);
}

TEST(PointLocator, AgreesWithTheReference) {
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    const Region region = test::random_region(random);
    const PointLocator locator(as_geometry(region));
    for (int k = 0; k < 60; ++k) {
      const Point x = random_point(random);
      const auto expected = reference::locate(reference::to_pt(x), region);
      const auto found = locator.locate(x);
      EXPECT_EQ(static_cast<int>(found), static_cast<int>(expected))
          << test::to_text(region) << ' ' << x.x << ' ' << x.y;
    }
    for (std::size_t v = 0; v < region.vertex_count(); ++v) {
      EXPECT_EQ(locator.locate(region.point(v)), Location::kBoundary);
    }
  }
}

TEST(PointLocator, KnowsThinParts) {
  const PointLocator locator({test::rectangle(0, 0, 4, 4), {{{4, 2}, {8, 2}, {8, 5}}}, {{9, 9}}});
  EXPECT_EQ(locator.locate({6, 2}), Location::kBoundary);
  EXPECT_EQ(locator.locate({8, 4}), Location::kBoundary);
  EXPECT_EQ(locator.locate({9, 9}), Location::kBoundary);
  EXPECT_EQ(locator.locate({7, 3}), Location::kOutside);
  EXPECT_EQ(locator.locate({2, 2}), Location::kInside);
  EXPECT_EQ(PointLocator(Geometry{}).locate({0, 0}), Location::kOutside);
}

TEST(Erosion, IsWhatItsDefinitionSays) {
  Random random(2);
  Options tight;
  tight.tight = true;
  int inside = 0;
  for (int i = 0; i < kPairs; ++i) {
    const Region a = test::scaled(test::random_region(random), Rational(2));
    const Region b = test::random_region(random);
    const Geometry erosion = erode(as_geometry(a), as_geometry(b), tight);
    const PointLocator locator(erosion);
    const auto expect = [&](const Point& x) {
      const bool fits = contains(a, at(b, x));
      inside += fits ? 1 : 0;
      EXPECT_EQ(locator.locate(x) != Location::kOutside, fits) << test::to_text(a) << '\n'
                                                               << test::to_text(b) << '\n'
                                                               << x.x << ' ' << x.y;
    };
    for (int k = 0; k < 40; ++k) expect(random_point(random));
    for (std::size_t v = 0; v < erosion.region.vertex_count(); ++v) expect(erosion.region.point(v));
    for (const Point& point : erosion.points) expect(point);
    for (const Polyline& line : erosion.polylines) {
      for (const Point& point : line) expect(point);
    }
  }
  EXPECT_GT(inside, 100);
}

TEST(Morphology, Laws) {
  Random random(3);
  for (int i = 0; i < kPairs; ++i) {
    const test::Pair pair = test::random_pair(random);
    const Geometry a = as_geometry(test::scaled(pair.p, Rational(3)));
    const Geometry b = as_geometry(pair.q);
    const Region plain = resolve(a).region;
    const Geometry opened = open(a, b);
    const Geometry closed = close(a, b);
    EXPECT_TRUE(contains(plain, opened.region)) << message(pair);
    EXPECT_TRUE(contains(closed.region, plain)) << message(pair);
    EXPECT_EQ(open(opened, b), opened) << message(pair);
    EXPECT_EQ(close(closed, b), closed) << message(pair);
    // With the origin in B, erosion shrinks and dilation grows.
    const Point corner = pair.q.point(0);
    const Geometry origin = transform(b, Affine::translation(-corner.x, -corner.y));
    EXPECT_TRUE(contains(plain, erode(a, origin).region)) << message(pair);
    EXPECT_TRUE(contains(dilate(a, origin).region, plain)) << message(pair);
  }
}

// In a box, the erosion by B is what the dilation of the complement by −B leaves.
TEST(Morphology, Duality) {
  Random random(4);
  for (int i = 0; i < kPairs; ++i) {
    const test::Pair pair = test::random_pair(random);
    const Region a = test::scaled(pair.p, Rational(2));
    const Region box = test::rectangle(-9000, -9000, 9000, 9000);
    const Region inner = test::rectangle(-4000, -4000, 4000, 4000);
    const Region around = minkowski_sum(subtract(box, a), reflect(pair.q));
    EXPECT_EQ(subtract(inner, around), erode(as_geometry(a), as_geometry(pair.q)).region)
        << message(pair);
  }
}

TEST(NoFitPolygon, SaysHowPlacedPartsStand) {
  Random random(5);
  int counts[3] = {0, 0, 0};
  for (int i = 0; i < kPairs; ++i) {
    const test::Pair pair = test::random_pair(random);
    std::optional<Point> chosen;
    if (i % 2 == 0) chosen = Point{Rational(1, 3), Rational(-2)};
    const Point reference = chosen.value_or(pair.q.point(0));
    const NoFitPolygon nfp(as_geometry(pair.p), as_geometry(pair.q), chosen);
    const auto expect = [&](const Point& t) {
      const Region placed = at(pair.q, {t.x - reference.x, t.y - reference.y});
      const bool overlap = !intersect(pair.p, placed).empty();
      const bool meet = reference::contains_sum(pair.p, reflect(placed),
                                                {reference::Number(0), reference::Number(0)});
      const Contact expected = overlap ? Contact::kOverlapping
                               : meet  ? Contact::kTouching
                                       : Contact::kFree;
      EXPECT_EQ(nfp.contact(t), expected) << message(pair) << '\n' << t.x << ' ' << t.y;
      ++counts[static_cast<int>(expected)];
    };
    for (int k = 0; k < 30; ++k) {
      const Point x = random_point(random);
      expect({x.x + reference.x, x.y + reference.y});
    }
    for (const Point& point : nfp.geometry().points) expect(point);
    for (const Polyline& line : nfp.geometry().polylines) {
      for (const Point& point : line) expect(point);
    }
  }
  for (const int count : counts) EXPECT_GT(count, 50);
}

TEST(InnerFitPolygon, AnExactFitIsAPoint) {
  const Geometry sheet = as_geometry(test::rectangle(0, 0, 1000, 1000));
  const Geometry fit = inner_fit_polygon(sheet, as_geometry(test::rectangle(5, 7, 1005, 1007)));
  EXPECT_TRUE(fit.region.empty());
  EXPECT_TRUE(fit.polylines.empty());
  EXPECT_EQ(fit.points, (std::vector<Point>{{0, 0}}));
  const Geometry slide = inner_fit_polygon(sheet, as_geometry(test::rectangle(0, 0, 1000, 10)));
  EXPECT_EQ(slide.polylines, (std::vector<Polyline>{{{0, 0}, {0, 990}}}));
  EXPECT_TRUE(inner_fit_polygon(sheet, as_geometry(test::rectangle(0, 0, 1001, 1))).empty());
}

TEST(PenetrationDepth, ItsVectorSeparatesAndLessDoesNot) {
  Random random(6);
  int overlapping = 0;
  for (int i = 0; i < kPairs; ++i) {
    const test::Pair pair = test::random_pair(random);
    const Point shift = random_point(random);
    const Region b = at(pair.q, shift);
    const auto depth = penetration_depth(as_geometry(pair.p), as_geometry(b));
    ASSERT_TRUE(depth.has_value());
    EXPECT_EQ(depth->overlapping, !intersect(pair.p, b).empty()) << message(pair);
    EXPECT_EQ(depth->squared,
              depth->vector.x * depth->vector.x + depth->vector.y * depth->vector.y);
    const auto after = penetration_depth(as_geometry(pair.p), as_geometry(at(b, depth->vector)));
    EXPECT_FALSE(after->overlapping) << message(pair);
    EXPECT_EQ(after->squared, Rational(0)) << message(pair);
    const Rational less(999, 1000);
    const Point shorter{depth->vector.x * less, depth->vector.y * less};
    if (!depth->overlapping) {
      if (depth->squared.sign() == 0) continue;
      EXPECT_TRUE(intersect(pair.p, at(b, shorter)).empty()) << message(pair);
      continue;
    }
    ++overlapping;
    EXPECT_FALSE(intersect(pair.p, at(b, shorter)).empty()) << message(pair);
    // No other direction is shorter.
    const Rational tenth(depth->distance * 0.999 / 5);
    for (const auto& [x, y] :
         {std::pair{5, 0}, {-5, 0}, {0, 5}, {0, -5}, {3, 4}, {-3, 4}, {3, -4}, {-3, -4}}) {
      const Point way{Rational(x) * tenth, Rational(y) * tenth};
      EXPECT_FALSE(intersect(pair.p, at(b, way)).empty()) << message(pair);
    }
  }
  EXPECT_GT(overlapping, 15);
}

/// Returns whether the named vertex lies on the named edge after B is moved by `shift`.
bool touch(const Region& a, const Region& b, const Point& shift, const EdgeOrigin& contact) {
  const Region moved = at(b, shift);
  const bool edge_of_a = contact.edge_operand == Operand::kFirst;
  const Region& with_edge = edge_of_a ? a : moved;
  const Point p = (edge_of_a ? moved : a).point(contact.vertex);
  std::size_t next = contact.edge + 1;
  for (std::size_t ring = 0; ring < with_edge.ring_count(); ++ring) {
    const IndexRange vertices = with_edge.vertices_of(ring);
    if (next == vertices.front() + vertices.size()) {
      next = vertices.front();
      break;
    }
  }
  const Point u = with_edge.point(contact.edge);
  const Point w = with_edge.point(next);
  const Point d{w.x - u.x, w.y - u.y};
  const Point e{p.x - u.x, p.y - u.y};
  const Rational along = d.x * e.x + d.y * e.y;
  return (d.x * e.y - d.y * e.x).sign() == 0 && along.sign() >= 0 && along <= d.x * d.x + d.y * d.y;
}

TEST(PenetrationDepth, NamesWhatTouches) {
  Random random(61);
  int named = 0;
  for (int i = 0; i < 3 * kPairs; ++i) {
    test::Pair pair = test::random_pair(random);
    if (i % 3 == 0) {  // the edges of both have the same directions
      pair.p = test::rectangle(0, 0, random.between(1, 9), random.between(1, 9));
      pair.q = test::random_cells(random, 4, 4, false, true);
    }
    const Region b = at(pair.q, random_point(random));
    if (pair.p.empty() || b.empty()) continue;
    const auto depth = penetration_depth(as_geometry(pair.p), as_geometry(b));
    if (!depth->contact) continue;
    ++named;
    EXPECT_TRUE(touch(pair.p, b, depth->vector, *depth->contact)) << message(pair);
  }
  EXPECT_GT(named, 2 * kPairs);
}
TEST(PenetrationDepth, NamesTheFeaturesInContact) {
  const Region wall = test::rectangle(0, 0, 10, 10);
  const Region wedge = test::make_polygon({{9, 5}, {20, 0}, {20, 10}});
  const auto depth = penetration_depth(as_geometry(wall), as_geometry(wedge));
  ASSERT_TRUE(depth && depth->contact);
  EXPECT_TRUE(depth->overlapping);
  EXPECT_EQ(depth->vector, (Point{1, 0}));
  EXPECT_EQ(depth->contact->edge_operand, Operand::kFirst);
  EXPECT_EQ(depth->contact->edge, 1U);
  EXPECT_EQ(depth->contact->vertex, 0U);
}

TEST(TimeOfImpact, IsTheFirstContact) {
  Random random(7);
  int hits = 0;
  for (int i = 0; i < kPairs; ++i) {
    const test::Pair pair = test::random_pair(random);
    const Region b = at(pair.q, {Rational(40), Rational(random.between(-20, 30))});
    const Point direction{Rational(-1), Rational(random.between(-2, 2), 3)};
    const auto time = time_of_impact(as_geometry(pair.p), as_geometry(b), direction);
    const auto placed = [&](const Rational& f) {
      return at(b, {direction.x * f, direction.y * f});
    };
    const auto stands = [&](const Rational& f) {
      return penetration_depth(as_geometry(pair.p), as_geometry(placed(f)));
    };
    if (time && time->sign() == 0) {
      const auto now = stands(Rational(0));
      EXPECT_TRUE(now->overlapping || now->squared.sign() == 0) << message(pair);
      continue;
    }
    if (time) {
      ++hits;
      EXPECT_EQ(stands(*time)->squared, Rational(0)) << message(pair);
    }
    for (int k = 0; k < 20; ++k) {
      const Rational f = time ? *time * Rational(k, 20) : Rational(5 * k);
      const auto before = stands(f);
      EXPECT_FALSE(before->overlapping || before->squared.sign() == 0) << message(pair);
    }
  }
  EXPECT_GT(hits, 25);
  EXPECT_THROW((void)time_of_impact({}, {}, {0, 0}), Error);
}

}  // namespace
}  // namespace minksum
