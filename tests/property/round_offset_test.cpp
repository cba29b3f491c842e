// Tests discs by their definition, and round offsets by distances of sampled points and by law.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "minksum/boolean.hpp"
#include "minksum/measure.hpp"
#include "minksum/resolve.hpp"
#include "minksum/transform.hpp"
#include "property/offsets.hpp"
#include "reference/membership.hpp"

namespace minksum {
namespace {

using namespace test;

/// Returns the exact squared distance of x from the segment ab. It goes to the foot of the
/// perpendicular if that is on the segment, else to an end.
Rational squared_distance(const Point& x, const Point& a, const Point& b) {
  const Rational dx = b.x - a.x, dy = b.y - a.y;
  Rational t(0);
  if (const Rational length = dx * dx + dy * dy; length.sign() > 0) {
    t = ((x.x - a.x) * dx + (x.y - a.y) * dy) / length;
    if (t.sign() < 0) t = 0;
    if (t > Rational(1)) t = 1;
  }
  const Rational ex = x.x - a.x - t * dx, ey = x.y - a.y - t * dy;
  return ex * ex + ey * ey;
}

/// Returns the squared distance to the nearest point of all boundaries and thin parts.
Rational squared_distance_to_lines(const Point& x, const Geometry& set) {
  std::optional<Rational> best;
  const auto take = [&](const Point& a, const Point& b) {
    const Rational d = squared_distance(x, a, b);
    if (!best || d < *best) best = d;
  };
  for (const std::size_t polygon : set.region.polygons()) {
    for (const std::size_t ring : set.region.rings_of(polygon)) {
      const IndexRange range = set.region.vertices_of(ring);
      Point before = set.region.point(range.front() + range.size() - 1);
      for (const std::size_t v : range) {
        take(before, set.region.point(v));
        before = set.region.point(v);
      }
    }
  }
  for (const Polyline& line : set.polylines) {
    for (std::size_t i = 1; i < line.size(); ++i) take(line[i - 1], line[i]);
  }
  for (const Point& point : set.points) take(point, point);
  return *best;
}

/// Returns whether x belongs to the region, its boundary included, by the tests' own reference.
bool belongs(const Point& x, const Region& region) {
  return reference::locate(reference::to_pt(x), region) != reference::Side::kOutside;
}

/// Returns whether x is in the true offset by d: within |d| of the set, or that deep in its area.
bool in_true_offset(const Point& x, const Geometry& set, const Rational& d) {
  const bool inside = !set.region.empty() && belongs(x, set.region);
  const Rational distance = squared_distance_to_lines(x, set);
  if (d.sign() >= 0) return inside || distance <= d * d;
  return inside && distance >= d * d;
}

Point random_point(Random& random) {
  return {Rational(random.between(-60, 90), 3), Rational(random.between(-60, 90), 3)};
}

// -- Discs -----------------------------------------------------------------------------------

/// Expects a convex disc with the origin inside and all vertices within `outer`. All of its
/// boundary must be beyond `inner`, by distances to segments.
void expect_disc(const Region& disc, const Rational& inner, const Rational& outer) {
  ASSERT_EQ(disc.ring_count(), 1U);
  const std::size_t n = disc.vertex_count();
  for (std::size_t v = 0; v < n; ++v) {
    const Point a = disc.point(v), b = disc.point((v + 1) % n), c = disc.point((v + 2) % n);
    EXPECT_LE(a.x * a.x + a.y * a.y, outer * outer);
    EXPECT_GE(squared_distance({0, 0}, a, b), inner * inner);
    EXPECT_GT(((b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x)).sign(), 0);
  }
  EXPECT_TRUE(belongs({0, 0}, disc));
  EXPECT_EQ(resolve(of_area(disc)), of_area(disc));
  for (const auto& map : {Affine::quarter_turns(1), Affine{0, 1, 0, 1, 0, 0}}) {
    EXPECT_EQ(resolve(of_area(transform(disc, map))), of_area(disc));
  }
}

TEST(Disc, IsWithinItsTolerance) {
  const std::vector<Rational> radii{1,
                                    1000,
                                    Rational(1, 3),
                                    Rational(0.1),
                                    *Rational::parse("123.456"),
                                    *Rational::parse("7e-400"),
                                    *Rational::parse("12345678901234567890123e300")};
  for (const Rational& radius : radii) {
    for (const Rational& part : {Rational(5), Rational(1, 2), Rational(1, 3), Rational(1, 7),
                                 Rational(1, 20), Rational(1, 999)}) {
      const Rational t = radius * part;
      const Rational small = std::min(t, radius / Rational(2));
      for (const RoundingSide side : kRoundingSides) {
        const Region d = disc(radius, t, side);
        const Rational inner = side == RoundingSide::kOutside ? radius : radius - small;
        const Rational outer = side == RoundingSide::kInside ? radius : radius + small;
        expect_disc(d, inner, outer);
        const Box box = *bounding_box(d);
        EXPECT_EQ(box.max.x, radius);
        EXPECT_EQ(box.min.y, -radius);
        // No polygon between the two circles has fewer vertices.
        const double least = std::acos(-1.0) / std::acos((inner / outer).to_double());
        EXPECT_LE(static_cast<double>(d.vertex_count()),
                  1.02 * least + (side == RoundingSide::kNearest ? 6 : 4))
            << radius << ' ' << t << ' ' << to_string(side);
      }
    }
  }
}

TEST(Disc, ManyVertices) {
  const Region d = disc(1, *Rational::parse("2e-8"), RoundingSide::kOutside);
  EXPECT_GT(d.vertex_count(), 15500U);
  EXPECT_LT(d.vertex_count(), 16000U);
  expect_disc(d, 1, *Rational::parse("1.00000002"));
  for (const char* const tolerance : {"1e-13", "1e-400"}) {
    EXPECT_THROW((void)disc(1, *Rational::parse(tolerance)), Error);
  }
  EXPECT_THROW((void)disc(0, 1), Error);
  EXPECT_THROW((void)disc(-1, 1), Error);
  EXPECT_THROW((void)disc(1, 0), Error);
}

// -- Round offsets ---------------------------------------------------------------------------

TEST(RoundOffset, IsBetweenTrueOffsetsAtSampledPoints) {
  Random random(seed_from_environment(1));
  int counts[2] = {0, 0};
  for (int i = 0; i < count_from_environment(kShapes); ++i) {
    const Geometry a = i % 3 == 0 ? random_thin(random, 20) : of_area(random_region(random));
    const Geometry set = resolve(a);
    const Rational d(random.between(-9, 24), 4);
    const Rational t(random.between(1, 9), 20);
    if (d.sign() == 0) continue;
    for (const RoundingSide side : kRoundingSides) {
      const Geometry result = offset(a, d, round_to(side, t));
      EXPECT_FALSE(result.has_thin_parts());
      EXPECT_EQ(resolve(result), result);
      for (int k = 0; k < 12; ++k) {
        const Point x = random_point(random);
        const bool is = belongs(x, result.region);
        ++counts[is ? 1 : 0];
        const Rational low = side == RoundingSide::kOutside ? d : d - t;
        const Rational high = side == RoundingSide::kInside ? d : d + t;
        // The result lacks what has no area, so the test shrinks a little less.
        const Rational least = d.sign() < 0 ? low - Rational(1, 1000) : low;
        if (low.sign() == d.sign() && in_true_offset(x, set, least)) {
          EXPECT_TRUE(is) << message(a, d) << ' ' << x.x << ' ' << x.y;
        }
        if (high.sign() == d.sign() && !in_true_offset(x, set, high)) {
          EXPECT_FALSE(is) << message(a, d) << ' ' << x.x << ' ' << x.y;
        }
      }
    }
  }
  EXPECT_GT(counts[0], 50);
  EXPECT_GT(counts[1], 50);
}

TEST(RoundOffset, Laws) {
  Random random(seed_from_environment(2));
  for (int i = 0; i < count_from_environment(kShapes); ++i) {
    const Geometry a = i % 3 == 0 ? random_thin(random, 20) : of_area(random_region(random));
    const int sign = i % 2 == 0 || a.has_thin_parts() ? 1 : -1;
    const Rational d(random.between(1, 16) * sign, 8), e(random.between(1, 16) * sign, 8);
    const Rational t(random.between(1, 9), 100);
    const auto outside = [&](const Geometry& set, const Rational& by) {
      return offset(set, by, round_to(RoundingSide::kOutside, t));
    };
    const auto inside = [&](const Geometry& set, const Rational& by) {
      return offset(set, by, round_to(RoundingSide::kInside, t));
    };
    const Geometry out = outside(a, d), in = inside(a, d);
    EXPECT_TRUE(contains(out.region, in.region)) << message(a, d);
    // An offset by 2 t more contains it, unless 2 t changes the sign of the distance.
    EXPECT_TRUE(contains(inside(a, d + t + t).region, out.region) || (d + t + t).sign() != sign)
        << message(a, d);
    EXPECT_TRUE(contains(outside(out, e).region, inside(a, d + e).region)) << message(a, d);
    EXPECT_TRUE(contains(outside(a, d + e).region, inside(in, e).region)) << message(a, d);
    const Region plain = resolve(a).region;
    EXPECT_TRUE(sign > 0 ? contains(in.region, plain) : contains(plain, out.region));
    // An offset there and back is a closing or an opening.
    EXPECT_TRUE(sign > 0 ? contains(outside(out, -d).region, plain)
                         : contains(plain, inside(in, -d).region))
        << message(a, d);
    const Geometry nearest = offset(a, d, round_to(RoundingSide::kNearest, t));
    EXPECT_TRUE(contains(outside(a, d + t).region, nearest.region));
  }
}

}  // namespace
}  // namespace minksum
