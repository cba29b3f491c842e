#include "minksum/round.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "machine/cancellation.hpp"
#include "minksum/resolve.hpp"
#include "rounding/round_region.hpp"
#include "rounding/thin_sides.hpp"

namespace minksum {
namespace {

constexpr int kMaxDecimals = 4096;

Target target_of(const RoundOptions& options) {
  if (options.decimals && (*options.decimals < 0 || *options.decimals > kMaxDecimals)) {
    throw Error(ErrorCode::kBadInput, "digits after the point are not from 0 to 4096");
  }
  return {options.decimals};
}

/// Lists how many rings each polygon has, sorted.
std::vector<std::size_t> topology(const Region& region) {
  std::vector<std::size_t> rings;
  for (const std::size_t polygon : region.polygons()) {
    if (!region.rings_of(polygon).empty()) rings.push_back(region.rings_of(polygon).size());
  }
  std::sort(rings.begin(), rings.end());
  return rings;
}

// -- Thin parts ----------------------------------------------------------------------------------
Point nearest_point(const Point& p, const Target& target) {
  const RoundedCoordinate x = nearest_place(p.x, target);
  const RoundedCoordinate y = nearest_place(p.y, target);
  if (!target.is_decimal() && !(std::isfinite(x.value) && std::isfinite(y.value))) {
    fail_beyond_doubles();
  }
  return {value_of(x, target), value_of(y, target)};
}

/// Rounds every point by itself. Returns the largest distance that any was moved, rounded up.
double add_rounded_thin_parts(const Geometry& exact, const Target& target,
                              Cancellation& cancellation, Geometry& result) {
  double largest = 0;
  const auto rounded = [&](const Point& p) {
    cancellation.check(32 * work_of(p));
    Point q = nearest_point(p, target);
    const auto off = [](const Rational& a, const Rational& b) {
      const Rational difference = a < b ? b - a : a - b;
      return difference.sign() == 0 ? 0 : rounded_up(difference);
    };
    const double move = length_of(off(p.x, q.x), off(p.y, q.y));
    if (move != 0) largest = std::max(largest, rounded_up(move));
    return q;
  };
  for (const Polyline& line : exact.polylines) {
    Polyline& copy = result.polylines.emplace_back();
    for (const Point& p : line) copy.push_back(rounded(p));
  }
  for (const Point& p : exact.points) result.points.push_back(rounded(p));
  return largest;
}

/// Bounds the distance of the nearest place from any point of the thin parts.
double thin_bound(const Geometry& geometry, const Target& target, Cancellation& cancellation) {
  RoundedVertices places;
  for_each_thin_point(geometry, [&](const Point& p) {
    cancellation.check(16 * work_of(p));
    RoundedVertex& place = places.emplace_back();
    place.x = nearest_place(p.x, target);
    place.y = nearest_place(p.y, target);
  });
  return diagonal(half_place(places, target));
}

Geometry round_to_nearest(const Geometry& geometry, const Target& target,
                          const RoundOptions& options, RoundingReport& r) {
  Geometry result;
  result.region = round_region(geometry.region, target, options, r);
  Cancellation cancellation(options.cancel);
  const double moved = add_rounded_thin_parts(geometry, target, cancellation, result);
  ResolveOptions resolving;
  resolving.cancel = options.cancel;
  result = resolve(result, resolving);
  // A path may end inside a region's edge. Rounded by itself, it would come off.
  const bool attached = !geometry.region.empty() && !geometry.polylines.empty();
  const bool moved_apart = attached && !(r.exact && moved == 0);
  if (!moved_apart && is_on_target(result, target, options.cancel)) {
    r.exact = r.exact && moved == 0;
    r.largest_move = std::max(r.largest_move, moved);
    r.bound = std::max(r.bound, thin_bound(geometry, target, cancellation));
    return result;
  }
  // The path came off, or thin parts cross at a point outside the target.
  r = RoundingReport{};
  return round_by_snapping(geometry, target, options, r);
}

Geometry round_thin(const Geometry& geometry, const Target& target, const RoundOptions& options,
                    RoundingReport& report) {
  switch (options.side) {
    case RoundingSide::kNearest:
      break;
    case RoundingSide::kOutside:
      return round_outside(geometry, target, options, report);
    case RoundingSide::kInside:
      return round_inside(geometry, target, options, report);
  }
  return round_to_nearest(geometry, target, options, report);
}

}  // namespace

const char* to_string(RoundingSide side) {
  switch (side) {
    case RoundingSide::kNearest:
      return "nearest";
    case RoundingSide::kOutside:
      return "outside";
    case RoundingSide::kInside:
      return "inside";
  }
  return "";
}

Region round(const Region& region, const RoundOptions& options, RoundingReport* report) {
  RoundingReport own;
  RoundingReport& r = report != nullptr ? *report : own;
  const Target target = target_of(options);
  Cancellation(options.cancel).look();
  Region result = round_region(region, target, options, r);
  r.largest_move = std::min(r.largest_move, r.bound);  // both are upper bounds
  r.topology_kept = topology(result) == topology(region);
  return result;
}

Geometry round(const Geometry& geometry, const RoundOptions& options, RoundingReport* report) {
  RoundingReport own;
  RoundingReport& r = report != nullptr ? *report : own;
  if (!geometry.has_thin_parts()) return {round(geometry.region, options, &r), {}, {}};
  const Target target = target_of(options);
  Cancellation(options.cancel).look();
  Geometry result = round_thin(geometry, target, options, r);
  r.largest_move = std::min(r.largest_move, r.bound);
  r.topology_kept = topology(result.region) == topology(geometry.region) &&
                    result.polylines.size() == geometry.polylines.size() &&
                    result.points.size() == geometry.points.size();
  return result;
}

}  // namespace minksum
