// Fuzzes uses of sums on any geometries. Bytes become two geometries, a fill rule and an operation.
// Morphology, offsets, placements and slices must keep their laws.
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "fuzz/geometry_reader.hpp"
#include "support/geometries.hpp"
#include "support/geometry_laws.hpp"

namespace {

using namespace minksum;

struct Case {
  Geometry a;
  Geometry b;
  FillRule fill;
  std::string what;
};

[[noreturn]] void fail(const Case& c, const std::string& law) {
  std::fprintf(stderr, "violated: %s, %s\nA %s\nB %s\nfill rule: %s\n", c.what.c_str(), law.c_str(),
               test::to_text(c.a).c_str(), test::to_text(c.b).c_str(), to_string(c.fill));
  std::abort();
}
void require(bool holds, const Case& c, const char* law) {
  if (!holds) fail(c, law);
}
void require_form(const Geometry& geometry, const Case& c) {
  const std::string fault = test::broken_form(geometry);
  if (!fault.empty()) fail(c, fault);
}

Geometry set_of(const Geometry& geometry, const Case& c) {
  return resolve(geometry, {.fill = c.fill});
}
Region area_of(const Geometry& geometry, const Case& c) {
  return resolve(geometry, {.fill = c.fill, .regularize = true}).region;
}
Region moved(const Region& region, const Point& by) {
  return transform(region, Affine::translation(by.x, by.y));
}
bool overlap(const Region& a, const Region& b) { return !intersect(a, b).empty(); }

void try_morphology(const Case& c, bool tight) {
  Options options;
  options.fill = c.fill;
  const Region a = area_of(c.a, c);
  const Geometry b = set_of(c.b, c);
  if (b.empty()) return;
  const Geometry eroded = erode(c.a, c.b, options);
  require_form(eroded, c);
  const Region box = test::rectangle(-900, -900, 900, 900);
  const Geometry around{subtract(box, a), {}, {}};
  require(subtract(test::rectangle(-400, -400, 400, 400),
                   minkowski_sum(around, reflect(b)).region) == eroded.region,
          c, "erosion is the complement of the complement's dilation");
  if (tight && !b.has_thin_parts()) {
    options.tight = true;
    const Geometry all = erode(c.a, c.b, options);
    require_form(all, c);
    require(all.region == eroded.region, c, "tight places add no area to an erosion");
    std::vector<Point> places = all.points;
    for (const Polyline& line : all.polylines) {
      places.insert(places.end(), line.begin(), line.end());
    }
    for (const Point& place : places) {
      require(contains(a, moved(b.region, place)), c, "the element fits where it has no play");
    }
    options.tight = false;
  }
  // Results are sets, so they are read as they are, whatever the rule was.
  const Geometry opened = open(c.a, c.b, options);
  require(contains(a, opened.region), c, "an opening is within the set");
  require(open(opened, b) == opened, c, "opening is idempotent");
  const Geometry closed = close(c.a, c.b, options);
  require(contains(closed.region, a), c, "a closing contains the set");
  require(close(closed, b) == closed, c, "closing is idempotent");
}

void try_offset(const Case& c, int kind, int size) {
  constexpr std::array kJoins{Join::kRound, Join::kMiter, Join::kSquare, Join::kBevel};
  constexpr std::array kCaps{Cap::kRound, Cap::kButt, Cap::kSquare};
  const Options reading{.fill = c.fill};
  OffsetOptions options;
  options.join = kJoins[static_cast<std::size_t>(kind % 4)];
  options.cap = kCaps[static_cast<std::size_t>(kind / 4 % 3)];
  options.miter_limit = Rational(2 + kind / 16 % 8, 2);
  const Rational distance(1 + size % 8, 1 + size / 8 % 4);
  options.tolerance = distance * Rational(1, 3 << (size / 32 % 4));
  const Region a = area_of(c.a, c);
  const Geometry grown = offset(c.a, distance, options, reading);
  require_form(grown, c);
  require(contains(grown.region, a), c, "grown it contains what was there");
  const Geometry shrunk = offset(c.a, -distance, options, reading);
  require_form(shrunk, c);
  require(contains(a, shrunk.region), c, "shrunk it is within what was there");
  if (options.join != Join::kRound || options.cap != Cap::kRound) return;
  const auto on = [&](RoundingSide side, const Rational& by) {
    options.side = side;
    return offset(c.a, by, options, reading).region;
  };
  require(contains(on(RoundingSide::kOutside, distance), on(RoundingSide::kInside, distance)), c,
          "the outer offset contains the inner one");
  require(contains(on(RoundingSide::kOutside, -distance), on(RoundingSide::kInside, -distance)), c,
          "shrunk, the outer offset contains the inner one");
}

void try_placements(const Case& c, int x, int y) {
  const Region a = area_of(c.a, c);
  const Region b = area_of(c.b, c);
  if (a.empty() || b.empty()) return;
  const NoFitPolygon nfp(c.a, c.b, Point{}, {.fill = c.fill});
  require_form({nfp.geometry().region, {}, {}}, c);  // tight places may lie in its area
  std::vector<Point> places = nfp.geometry().points;
  for (const Polyline& line : nfp.geometry().polylines) places.push_back(line.front());
  for (std::size_t v = 0; v < nfp.geometry().region.vertex_count(); v += 3) {
    places.push_back(nfp.geometry().region.point(v));
  }
  for (const Point& place : places) {
    require(nfp.contact(place) == Contact::kTouching, c, "on the no-fit polygon parts touch");
    require(!overlap(a, moved(b, place)), c, "on the no-fit polygon parts do not overlap");
  }
  const Point shift{Rational(x % 32 - 16, 2), Rational(y % 32 - 16, 2)};
  // Depth counts thin parts, which the no-fit polygon leaves out.
  const Geometry there(moved(b, shift));
  const bool overlapping = overlap(a, moved(b, shift));
  require((nfp.contact(shift) == Contact::kOverlapping) == overlapping, c,
          "inside the no-fit polygon parts overlap");
  const auto depth = penetration_depth(Geometry(a), there);
  if (!depth) fail(c, "two areas have a depth");
  require(depth->overlapping == overlapping, c, "depth tells whether parts overlap");
  const Point parted{shift.x + depth->vector.x, shift.y + depth->vector.y};
  require(nfp.contact(parted) == Contact::kTouching, c, "moved by the depth's vector parts touch");
  const Rational less(99, 100);
  const Point nearly{shift.x + depth->vector.x * less, shift.y + depth->vector.y * less};
  if (depth->squared.sign() != 0) {
    require(nfp.contact(nearly) == (overlapping ? Contact::kOverlapping : Contact::kFree), c,
            "moved a hair less they stand as before");
  }
  const Point direction{Rational(y % 5 - 2), Rational(x % 3 + 1)};
  const auto time = time_of_impact(Geometry(a), there, direction);
  const auto at = [&](const Rational& f) {
    return nfp.contact({shift.x + direction.x * f, shift.y + direction.y * f});
  };
  if (nfp.contact(shift) != Contact::kFree) {
    require(time && time->sign() == 0, c, "what touches has no time to impact");
  } else if (time) {
    require(at(*time) == Contact::kTouching, c, "at the time of impact parts touch");
    require(at(*time * less) == Contact::kFree, c, "before the time of impact they are apart");
  }
}

void try_slice(const Case& c, int degrees) {
  const Region robot = area_of(c.a, c);
  if (robot.empty()) return;
  const ConfigurationSpace space(c.a, c.b, {}, {.fill = c.fill});
  const Turn turn = nearest_turn(Rational(degrees * 3, 2), 0.5);
  const Slice slice = space.slice(turn, true);
  const Geometry turned{transform(robot, Affine::scaling(-1).after(turn.map())), {}, {}};
  require(slice.obstacles == minkowski_sum(set_of(c.b, c), turned), c, "a slice is a sum");
  require(!overlap(slice.obstacles.region, slice.free.region), c, "free space has no obstacles");
  const Box& box = space.boundary();
  const Region all(Polygon{{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}, {}});
  require(unite(slice.obstacles.region, slice.free.region) == all, c,
          "obstacles and free space are all there is");
  // Many slices share part of their work, and must stay the same.
  std::vector<Turn> turns;
  for (int k = 0; k < 8; ++k) turns.push_back(nearest_turn(turn.asked + Rational(7 * k), 0.5));
  const std::vector<Slice> slices = space.slices(turns, true);
  const Slice last = space.slice(turns.back(), true);
  for (const auto& [shared, single] :
       {std::pair(&slices.front(), &slice), {&slices.back(), &last}}) {
    require(shared->obstacles == single->obstacles && shared->free == single->free, c,
            "slices made together are as those made one by one");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::GeometryReader reader(data, size);
  const int first = reader.take();
  const int second = reader.take();
  const int third = reader.take();
  const Geometry a = reader.read();
  const Geometry b = reader.read();
  Case c{a, b, fuzz::fill_rule(first / 4), ""};
  try {
    switch (first % 4) {
      case 0:
        c.what = "morphology";
        try_morphology(c, second % 2 != 0);
        break;
      case 1:
        c.what = "offset";
        try_offset(c, second, third);
        break;
      case 2:
        c.what = "placements";
        try_placements(c, second, third);
        break;
      default:
        c.what = "slice";
        try_slice(c, second);
    }
  } catch (const std::exception& error) {
    fail(c, std::string("it can be done: ") + error.what());
  }
  return 0;
}
