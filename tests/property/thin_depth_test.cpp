// Tests depth and distance of polylines and points against their edges, one by one: by definition.
// MINKSUM_PAIRS is the number of pairs.
#include <gtest/gtest.h>

#include <algorithm>

#include "minksum/depth.hpp"
#include "minksum/locate.hpp"
#include "minksum/transform.hpp"
#include "support/generators.hpp"
#include "support/polygon_kinds.hpp"
#include "support/shapes.hpp"

namespace minksum {
namespace {

using test::Random;

const int kThinPairs = test::count_from_environment(400);

struct Piece {
  Point a;
  Point b;
};

Point minus(const Point& p, const Point& q) { return {p.x - q.x, p.y - q.y}; }
Rational dot(const Point& p, const Point& q) { return p.x * q.x + p.y * q.y; }
Rational cross(const Point& p, const Point& q) { return p.x * q.y - p.y * q.x; }

/// Returns all edges, and points as edges of no length.
std::vector<Piece> pieces_of(const Geometry& geometry) {
  std::vector<Piece> pieces;
  const Region& region = geometry.region;
  for (std::size_t ring = 0; ring < region.ring_count(); ++ring) {
    const IndexRange vertices = region.vertices_of(ring);
    const std::size_t end = vertices.front() + vertices.size();
    for (const std::size_t v : vertices) {
      pieces.push_back({region.point(v), region.point(v + 1 < end ? v + 1 : vertices.front())});
    }
  }
  for (const Polyline& line : geometry.polylines) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) pieces.push_back({line[i], line[i + 1]});
  }
  for (const Point& point : geometry.points) pieces.push_back({point, point});
  return pieces;
}

Rational squared_distance(const Point& p, const Piece& piece) {
  const Point d = minus(piece.b, piece.a);
  const Rational whole = dot(d, d);
  Rational t = whole.sign() == 0 ? Rational(0) : dot(minus(p, piece.a), d) / whole;
  t = std::clamp(t, Rational(0), Rational(1));
  const Point off = minus(p, {piece.a.x + d.x * t, piece.a.y + d.y * t});
  return dot(off, off);
}

bool cross_each_other(const Piece& p, const Piece& q) {
  const auto side = [](const Piece& piece, const Point& x) {
    return cross(minus(piece.b, piece.a), minus(x, piece.a)).sign();
  };
  return side(p, q.a) * side(p, q.b) < 0 && side(q, p.a) * side(q, p.b) < 0;
}

Rational squared_distance(const Geometry& a, const Geometry& b) {
  const auto within = [](const Geometry& area, const std::vector<Piece>& pieces) {
    if (area.region.empty()) return false;
    const PointLocator locator(Geometry{area.region, {}, {}});
    return std::any_of(pieces.begin(), pieces.end(), [&](const Piece& piece) {
      return locator.locate(piece.a) != Location::kOutside;
    });
  };
  const std::vector<Piece> of_a = pieces_of(a);
  const std::vector<Piece> of_b = pieces_of(b);
  if (within(a, of_b) || within(b, of_a)) return Rational(0);
  std::optional<Rational> least;
  for (const Piece& p : of_a) {
    for (const Piece& q : of_b) {
      if (cross_each_other(p, q)) return Rational(0);
      for (const Rational& found : {squared_distance(p.a, q), squared_distance(p.b, q),
                                    squared_distance(q.a, p), squared_distance(q.b, p)}) {
        if (!least || found < *least) least = found;
      }
    }
  }
  return *least;
}

Geometry at(const Geometry& geometry, const Point& by) {
  return transform(geometry, Affine::translation(by.x, by.y));
}

Point random_point(Random& random, int size) {
  return {Rational(random.between(-size, size), 2), Rational(random.between(-size, size), 2)};
}

/// Returns points, polylines, both, or an area with or without them.
Geometry random_shape(Random& random, bool with_area) {
  Geometry shape;
  if (with_area && random.between(0, 1) == 0) {
    shape.region = random.between(0, 1) == 0 ? test::rectangle(0, 0, 7, 5)
                                             : test::make_polygon({{0, 0}, {9, 1}, {3, 3}, {2, 8}});
  }
  const auto kind = random.between(shape.region.empty() ? 1 : 0, 3);
  if ((kind & 1) != 0) {
    Polyline line;
    for (auto left = random.between(2, 4); left > 0; --left) {
      line.push_back(random_point(random, 12));
    }
    shape.polylines.push_back(line);
  }
  for (auto left = (kind & 2) != 0 ? random.between(1, 3) : 0; left > 0; --left) {
    shape.points.push_back(random_point(random, 12));
  }
  return shape;
}

TEST(ThinDepth, IsWhatTheEdgesSay) {
  Random random(17);
  int overlapping = 0;
  int touching = 0;
  int apart = 0;
  for (int i = 0; i < kThinPairs; ++i) {
    const Geometry a = random_shape(random, true);
    const Geometry b = at(random_shape(random, i % 3 == 0), random_point(random, 20));
    const auto depth = penetration_depth(a, b);
    ASSERT_TRUE(depth.has_value());
    const Rational expected = squared_distance(a, b);
    SCOPED_TRACE(i);
    EXPECT_EQ(depth->squared, dot(depth->vector, depth->vector));
    if (!depth->overlapping) {
      ++(expected.sign() == 0 ? touching : apart);
      EXPECT_EQ(depth->squared, expected);
    } else {
      ++overlapping;
      EXPECT_EQ(expected.sign(), 0);
      EXPECT_GT(depth->squared.sign(), 0);
      // Whatever is shorter leaves them in contact.
      const Rational tenth(depth->distance * 0.999 / 5);
      for (const auto& [x, y] :
           {std::pair{5, 0}, {-5, 0}, {0, 5}, {0, -5}, {3, 4}, {-3, 4}, {3, -4}, {-4, -3}}) {
        const Point way{Rational(x) * tenth, Rational(y) * tenth};
        EXPECT_EQ(squared_distance(a, at(b, way)), Rational(0));
      }
    }
    // After the move they are in contact, and a short move, in some direction, parts them.
    const Geometry moved = at(b, depth->vector);
    EXPECT_EQ(squared_distance(a, moved), Rational(0));
    const auto after = penetration_depth(a, moved);
    EXPECT_FALSE(after->overlapping);
    EXPECT_EQ(after->squared, Rational(0));
  }
  EXPECT_GT(overlapping, kThinPairs / 10);
  EXPECT_GT(touching, kThinPairs / 80);
  EXPECT_GT(apart, kThinPairs / 10);
}

TEST(ThinDepth, SomeThatAreKnown) {
  const Geometry square(test::rectangle(0, 0, 4, 4));
  const auto inside = penetration_depth(square, Geometry({}, {}, {{3, 2}}));
  EXPECT_TRUE(inside->overlapping);
  EXPECT_EQ(inside->vector, (Point{1, 0}));
  EXPECT_FALSE(inside->contact.has_value());
  const auto corner = penetration_depth(square, Geometry({}, {}, {{4, 4}}));
  EXPECT_FALSE(corner->overlapping);
  EXPECT_EQ(corner->squared, Rational(0));
  const Geometry line({}, {{{0, 0}, {2, 2}}}, {});
  const auto crossing = penetration_depth(line, Geometry({}, {{{0, 2}, {2, 0}}}, {}));
  EXPECT_TRUE(crossing->overlapping);
  EXPECT_EQ(crossing->squared, Rational(2));
  const auto along = penetration_depth(line, Geometry({}, {{{1, 1}, {5, 5}}}, {}));
  EXPECT_FALSE(along->overlapping);
  EXPECT_EQ(along->squared, Rational(0));
  const auto points = penetration_depth(Geometry({}, {}, {{0, 0}}), Geometry({}, {}, {{3, 4}}));
  EXPECT_FALSE(points->overlapping);
  EXPECT_EQ(points->vector, (Point{-3, -4}));
  EXPECT_EQ(*time_of_impact(square, Geometry({}, {}, {{8, 2}}), {-2, 0}), Rational(2));
  EXPECT_EQ(*time_of_impact(Geometry({}, {}, {{0, 0}}), Geometry({}, {}, {{3, 6}}), {-1, -2}),
            Rational(3));
  EXPECT_FALSE(time_of_impact(line, Geometry({}, {}, {{8, 2}}), {1, 0}).has_value());
}

}  // namespace
}  // namespace minksum
