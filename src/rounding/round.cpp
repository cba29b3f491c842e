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

Target target_of(const RoundRequest& request) {
  if (request.decimals && (*request.decimals < 0 || *request.decimals > kMaxDecimals)) {
    throw Error(ErrorCode::kBadInput, "digits after the point are not from 0 to 4096");
  }
  return {request.decimals};
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
                          const RoundRequest& request, RoundingReport& r) {
  Geometry result;
  result.region = round_region(geometry.region, target, request, r);
  Cancellation cancellation(request.options, Stage::kRounding);
  const double moved = add_rounded_thin_parts(geometry, target, cancellation, result);
  result = resolve(result, part_of(request.options));
  // A path may end inside a region's edge. Rounded by itself, it would come off.
  const bool attached = !geometry.region.empty() && !geometry.polylines.empty();
  const bool moved_apart = attached && !(r.exact && moved == 0);
  if (!moved_apart && is_on_target(result, target, request.options)) {
    r.exact = r.exact && moved == 0;
    r.largest_move = std::max(r.largest_move, moved);
    r.bound = std::max(r.bound, thin_bound(geometry, target, cancellation));
    return result;
  }
  // The path came off, or thin parts cross at a point outside the target.
  r = RoundingReport{};
  return round_by_snapping(geometry, target, request, r);
}

Geometry round_thin(const Geometry& geometry, const Target& target, const RoundRequest& request,
                    RoundingReport& report) {
  switch (request.side) {
    case RoundingSide::kNearest:
      break;
    case RoundingSide::kOutside:
      return round_outside(geometry, target, request, report);
    case RoundingSide::kInside:
      return round_inside(geometry, target, request, report);
  }
  return round_to_nearest(geometry, target, request, report);
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

Rounded detailed_round(const Region& region, const RoundOptions& target, const Options& options) {
  const RoundRequest request{target.side, target.decimals, part_of(options)};
  const Target places = target_of(request);
  Cancellation(request.options, Stage::kRounding).look();
  Rounded result;
  result.geometry.region = round_region(region, places, request, result.report);
  // Both are upper bounds.
  result.report.largest_move = std::min(result.report.largest_move, result.report.bound);
  result.report.topology_kept = topology(result.geometry.region) == topology(region);
  return result;
}

Rounded detailed_round(const Geometry& geometry, const RoundOptions& target,
                       const Options& options) {
  if (!geometry.has_thin_parts()) return detailed_round(geometry.region, target, options);
  const RoundRequest request{target.side, target.decimals, part_of(options)};
  const Target places = target_of(request);
  Cancellation(request.options, Stage::kRounding).look();
  Rounded result;
  result.geometry = round_thin(geometry, places, request, result.report);
  result.report.largest_move = std::min(result.report.largest_move, result.report.bound);
  result.report.topology_kept = topology(result.geometry.region) == topology(geometry.region) &&
                                result.geometry.polylines.size() == geometry.polylines.size() &&
                                result.geometry.points.size() == geometry.points.size();
  return result;
}

Region round(const Region& region, const RoundOptions& target, const Options& options) {
  return detailed_round(region, target, options).geometry.region;
}

Geometry round(const Geometry& geometry, const RoundOptions& target, const Options& options) {
  return detailed_round(geometry, target, options).geometry;
}

}  // namespace minksum
