#include "minksum/round.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "machine/cancellation.hpp"
#include "minksum/resolve.hpp"
#include "overlay/tight_places.hpp"
#include "region/map_points.hpp"
#include "rounding/round_region.hpp"
#include "rounding/thin_sides.hpp"
#include "validation/fault.hpp"

namespace minksum {
namespace {

Target target_of(const RoundRequest& request) {
  if (request.decimals && (*request.decimals < 0 || *request.decimals > kMaxDecimals)) {
    refuse_input("digits after the point are not from 0 to 4096");
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

/// Rounds every point by itself. `largest` becomes the largest distance of a move, rounded up.
Geometry with_rounded_thin_parts(const Geometry& exact, Region region, const Target& target,
                                 Cancellation& cancellation, double& largest) {
  return mapped(exact, std::move(region), [&](const Point& p) {
    cancellation.check(32 * work_of(p));
    Point q = nearest_point(p, target);
    const auto off = [](const Rational& a, const Rational& b) {
      const Rational difference = a < b ? b - a : a - b;
      return difference.sign() == 0 ? 0 : rounded_up(difference);
    };
    const double move = length_of(off(p.x, q.x), off(p.y, q.y));
    if (move != 0) largest = std::max(largest, rounded_up(move));
    return q;
  });
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
  Region region = round_region(geometry.region, target, request, r);
  Cancellation cancellation(request.options, Stage::kRounding);
  double moved = 0;
  Geometry result =
      with_rounded_thin_parts(geometry, std::move(region), target, cancellation, moved);
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

Geometry round_geometry(const Geometry& geometry, const Target& target, const RoundRequest& request,
                        RoundingReport& report) {
  if (!geometry.has_thin_parts()) {
    return Geometry(round_region(geometry.region, target, request, report));
  }
  if (request.side == RoundingSide::kNearest) {
    return round_to_nearest(geometry, target, request, report);
  }
  // The ways to a side rely on parts that meet at ends alone.
  require_valid(geometry.region, -1, request.options);
  const Geometry exact = resolve(geometry, request.options);
  return request.side == RoundingSide::kOutside ? round_outside(exact, target, request, report)
                                                : round_inside(exact, target, request, report);
}

}  // namespace

const char* to_string(RoundingSide side) {
  static constexpr std::array kNames{"nearest", "outside", "inside"};
  return name_of(side, kNames);
}

Rounded detailed_round(const Geometry& geometry, const RoundOptions& target,
                       const Options& options) {
  const RoundRequest request{target.side, target.decimals, part_of(options)};
  const Target places = target_of(request);
  require_enumerator(target.side, RoundingSide::kInside, "side");
  Cancellation(options, Stage::kRounding).look();
  Rounded result;
  result.geometry = round_geometry(geometry, places, request, result.report);
  // Both are upper bounds.
  result.report.largest_move = std::min(result.report.largest_move, result.report.bound);
  result.report.topology_kept = topology(result.geometry.region) == topology(geometry.region) &&
                                result.geometry.polylines.size() == geometry.polylines.size() &&
                                result.geometry.points.size() == geometry.points.size();
  return result;
}

Rounded detailed_round(const Region& region, const RoundOptions& target, const Options& options) {
  return detailed_round(Geometry(region), target, options);
}

Region round(const Region& region, const RoundOptions& target, const Options& options) {
  return detailed_round(region, target, options).geometry.region;
}

Geometry round(const Geometry& geometry, const RoundOptions& target, const Options& options) {
  return detailed_round(geometry, target, options).geometry;
}

Geometry round_with_tight_places(const Geometry& geometry, const RoundOptions& target,
                                 const Options& options) {
  const Geometry set = resolve(geometry, options);
  Geometry result = round(set, target, options);
  if (!overlay::keeps_tight_places(geometry, set, options)) return result;
  RoundOptions nearest = target;
  nearest.side = RoundingSide::kNearest;
  Geometry tight = round(overlay::tight_places_of(geometry), nearest, options);
  return overlay::with_tight_places(std::move(result), std::move(tight));
}

}  // namespace minksum
