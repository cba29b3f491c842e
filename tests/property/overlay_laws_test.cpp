// Tests laws that fill rules and boolean operations obey.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "minksum/boolean.hpp"
#include "minksum/measure.hpp"
#include "minksum/resolve.hpp"
#include "property/sums.hpp"
#include "reference/validity.hpp"
#include "support/data.hpp"
#include "support/messes.hpp"

namespace {

using namespace minksum;
using namespace minksum::test;

constexpr std::uint64_t kCases = 400;

void expect_area_laws(const Region& a, const Region& b) {
  const Rational shared = area(intersect(a, b));
  EXPECT_EQ(area(unite(a, b)) + shared, area(a) + area(b));
  EXPECT_EQ(area(subtract(a, b)) + shared, area(a));
}

// Expects the laws as plain bools, because comparing regions would print megabytes.
void expect_laws(const Region& a, const Region& b) {
  const Region both = unite(a, b);
  const Region shared = intersect(a, b);
  const Region rest = subtract(a, b);
  const Region either = symmetric_difference(a, b);
  EXPECT_TRUE(unite(rest, shared) == unite(a, a));
  EXPECT_TRUE(unite(rest, subtract(b, a)) == either);
  EXPECT_TRUE(subtract(both, shared) == either);
  EXPECT_TRUE(both == unite(b, a));
  EXPECT_TRUE(shared == intersect(b, a));
  EXPECT_TRUE(subtract(both, b) == rest);
  EXPECT_TRUE(intersect(rest, b).empty());
  EXPECT_TRUE(contains(both, a));
  EXPECT_TRUE(contains(a, shared));
  EXPECT_TRUE(contains(b, a) == rest.empty());
}

TEST(OverlayLaws, BooleansOfRandomPairs) {
  for (std::uint64_t seed = 1; seed <= kCases && !HasFailure(); ++seed) {
    Random random(seed);
    const Pair pair = random_pair(random);
    SCOPED_TRACE(note(seed, pair));
    expect_laws(pair.p, pair.q);
    expect_area_laws(pair.p, pair.q);
  }
}

TEST(OverlayLaws, BooleansOfSums) {
  for (std::uint64_t seed = 1; seed <= kCases && !HasFailure(); ++seed) {
    Random random(seed);
    const Pair pair = random_pair(random);
    SCOPED_TRACE(note(seed, pair));
    // The sums with a third region have vertices with many different denominators.
    const Region third = scaled(random_polygon(random), Rational(1, random.between(2, 9)));
    const Region a = minkowski_sum(pair.p, third);
    const Region b = moved(minkowski_sum(pair.q, third), Rational(random.between(-9, 9), 7), 1);
    expect_laws(a, b);
    expect_area_laws(a, b);
    EXPECT_EQ(unite(minkowski_sum(pair.p, third), minkowski_sum(pair.q, third)),
              minkowski_sum(unite(pair.p, pair.q), third));
    EXPECT_EQ(reference::canonical_fault(symmetric_difference(a, b)), "");
  }
}

TEST(OverlayLaws, RulesDoNotAskHowRingsAreWritten) {
  for (std::uint64_t seed = 1; seed <= 5 * kCases && !HasFailure(); ++seed) {
    Random random(seed);
    const Geometry mess = random_mess(random);
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + to_text(mess));
    // The other form has other first vertices, more straight vertices, and another order of parts.
    Geometry other;
    std::vector<Polygon> polygons;
    for (const std::size_t p : mess.region.polygons()) polygons.push_back(mess.region.polygon(p));
    const auto rewrite = [&](Ring& ring) {
      std::rotate(ring.begin(), ring.begin() + random.below(static_cast<int>(ring.size())),
                  ring.end());
      const Point& last = ring.back();
      ring.push_back({(last.x + ring[0].x) / 2, (last.y + ring[0].y) / 2});
    };
    for (Polygon& polygon : polygons) {
      rewrite(polygon.outer);
      std::for_each(polygon.holes.begin(), polygon.holes.end(), rewrite);
    }
    std::reverse(polygons.begin(), polygons.end());
    other.region = Region(polygons);
    other.polylines = mess.polylines;
    for (Polyline& line : other.polylines) std::reverse(line.begin(), line.end());
    other.points.assign(mess.points.rbegin(), mess.points.rend());
    for (const FillRule rule : {FillRule::kAutomatic, FillRule::kEvenOdd, FillRule::kNonZero,
                                FillRule::kPositive, FillRule::kNegative}) {
      Options options;
      options.fill = rule;
      EXPECT_EQ(to_text(resolve(mess, options)), to_text(resolve(other, options)));
    }
  }
}

// Unions of moved copies of large outlines divide cells many times.
TEST(OverlayLaws, BooleansOfOutlines) {
  const auto folder = data_path();
  if (!folder) return;
  for (const char* name : {"gis/switzerland_10m.wkt", "gis/greece_10m.wkt", "paper/monkey.wkt",
                           "hard/spiky_100a.wkt", "cgal/norway.wkt"}) {
    const auto file = *folder / name;
    if (!std::filesystem::exists(file)) continue;
    SCOPED_TRACE(name);
    const Region a = read_wkt(file);
    const Box box = *bounding_box(a);
    const Rational width = box.max.x - box.min.x;
    for (const Rational& part : {Rational(1, 7), Rational(1, 1000)}) {
      expect_laws(a, moved(a, width * part, width * part * part));
    }
  }
}

}  // namespace
