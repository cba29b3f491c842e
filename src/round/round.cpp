#include "minksum/round.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "minksum/resolve.hpp"
#include "minksum/validity.hpp"
#include "round/choose_side.hpp"
#include "round/grow.hpp"
#include "round/keep_topology.hpp"
#include "round/snap.hpp"

namespace minksum {
namespace {

constexpr int kMaxDecimals = 4096;

void stop_if_asked(const RoundOptions& options) {
  if (options.cancel && options.cancel->cancelled()) {
    throw Error(ErrorCode::kCancelled, "cancelled", {}, "round");
  }
}

Target target_of(const RoundOptions& options) {
  if (options.decimals && (*options.decimals < 0 || *options.decimals > kMaxDecimals)) {
    throw Error(ErrorCode::kBadInput, "digits after the point are not from 0 to 4096");
  }
  return {options.decimals};
}

/// How many holes each polygon has, sorted.
std::vector<std::size_t> topology(const Region& region) {
  std::vector<std::size_t> rings;
  for (const std::size_t polygon : region.polygons()) {
    if (!region.rings_of(polygon).empty()) rings.push_back(region.rings_of(polygon).size());
  }
  std::sort(rings.begin(), rings.end());
  return rings;
}

/// √2 · length, rounded up.
double diagonal(double length) { return rounded_up(length * std::sqrt(2.0)); }

/// Half of a double's last place at the magnitude of the largest coordinate, or half a decimal
/// step.
double half_place(const RoundedVertices& vertices, const Target& target) {
  if (target.is_decimal()) return rounded_up(target.unit() * Rational(1, 2));
  double largest = 0;
  for (const RoundedVertex& v : vertices) {
    largest = std::max({largest, std::abs(v.x.value), std::abs(v.y.value)});
  }
  constexpr int kLowest = -1074;
  const int last_place = largest == 0 ? kLowest : std::max(std::ilogb(largest) - 52, kLowest);
  // Half of the smallest double is none.
  return std::max(std::ldexp(1.0, last_place - 1), std::ldexp(1.0, kLowest));
}

/// A length in the target's unit, rounded up.
double in_units(double length, const Target& target) {
  if (length == 0 || !target.is_decimal()) return length;
  return rounded_up(length * rounded_up(target.unit()));
}

[[noreturn]] void refuse(const Region& region) {
  const auto faults = validate(region, 1);
  if (faults.empty()) {
    throw Error(ErrorCode::kInternal, "a legal region did not settle", {}, "round");
  }
  throw Error(ErrorCode::kBadInput, faults[0].message, faults[0].place);
}

Region resolved(const Region& region, const RoundOptions& options) {
  ResolveOptions resolving;
  resolving.cancel = options.cancel;
  Geometry geometry;
  geometry.region = region;
  return resolve(geometry, resolving).region;
}

/// A legal region in canonical form, valid by OGC's rules: cut interiors in pieces of their own.
Region canonical(const Region& region, const RoundOptions& options) {
  Settlement same = settle(region, region);
  if (same.outcome == Settled::kInvalid) refuse(region);
  if (same.outcome == Settled::kCut) return resolved(same.region, options);
  return std::move(same.region);
}

/// Vertex by vertex; nothing if that is not valid, or not safe.
std::optional<Region> round_by_vertices(const Region& region, const Target& target,
                                        const RoundOptions& options, RoundingReport& report) {
  const RoundedVertices vertices = round_vertices(region, target);
  report.exact = std::none_of(vertices.begin(), vertices.end(),
                              [](const RoundedVertex& v) { return v.moved(); });
  const bool sided = options.side != RoundingSide::kNearest && !report.exact;
  const double half = half_place(vertices, target);
  Sided moved;
  if (sided) {
    auto chosen =
        choose_side(region, options.side, target, vertices, target.is_decimal() ? 1 : 2 * half);
    if (!chosen) return {};
    moved = std::move(*chosen);
  } else {
    moved = {with_vertices(region, vertices, target), largest_move(vertices)};
  }
  stop_if_asked(options);
  Settlement settled = settle(region, moved.region);
  if (settled.outcome == Settled::kInvalid) return {};
  if (settled.outcome == Settled::kCut) settled.region = resolved(settled.region, options);
  report.largest_move = in_units(moved.largest_move, target);
  report.bound = diagonal(half * (options.side != RoundingSide::kNearest ? 2 : 1));
  return std::move(settled.region);
}

/// What is to be snapped so that the result lies on the right side.
Region sided(const Region& region, const RoundOptions& options, const SnapGrid& grid) {
  if (options.side == RoundingSide::kNearest) return region;
  const Rational half = grid.step() * Rational(1, 2);
  return options.side == RoundingSide::kOutside ? grown(region, half, options.cancel)
                                                : shrunk(region, half, options.cancel);
}

Geometry round_by_snapping(const Geometry& geometry, const Target& target,
                           const RoundOptions& options, RoundingReport& report) {
  const SnapGrid grid = snap_grid(geometry, target);
  Geometry base;
  base.region = sided(canonical(geometry.region, options), options, grid);
  base.polylines = geometry.polylines;
  base.points = geometry.points;
  ResolveOptions resolving;
  resolving.cancel = options.cancel;
  if (base.has_thin_parts()) base = resolve(base, resolving);
  stop_if_asked(options);
  Snapped snapped = snap(base, grid, options.cancel);
  const double step = rounded_up(grid.step());
  const bool moved_first = options.side != RoundingSide::kNearest;
  report.snapped = true;
  report.exact = snapped.exact && !moved_first;
  report.largest_move =
      moved_first ? rounded_up(snapped.largest_move + diagonal(step / 2)) : snapped.largest_move;
  report.bound = diagonal(moved_first ? step : step / 2);
  return std::move(snapped.geometry);
}

// -- Thin parts
// ------------------------------------------------------------------------------------
template <class Visit>
void for_each_thin_point(const Geometry& geometry, Visit visit) {
  for (const Polyline& line : geometry.polylines) std::for_each(line.begin(), line.end(), visit);
  std::for_each(geometry.points.begin(), geometry.points.end(), visit);
}

Point nearest_point(const Point& p, const Target& target) {
  const Place x = nearest_place(p.x, target);
  const Place y = nearest_place(p.y, target);
  if (!target.is_decimal() && !(std::isfinite(x.value) && std::isfinite(y.value))) {
    throw Error(ErrorCode::kBadInput, "a coordinate is beyond the largest double");
  }
  return {value_of(x, target), value_of(y, target)};
}

/// Every point by itself. Returns how far any was moved, rounded up.
double add_rounded_thin_parts(const Geometry& exact, const Target& target, Geometry& result) {
  double largest = 0;
  const auto rounded = [&](const Point& p) {
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

/// How far the nearest place can be from any point of the thin parts.
double thin_bound(const Geometry& geometry, const Target& target) {
  RoundedVertices places;
  for_each_thin_point(geometry, [&](const Point& p) {
    RoundedVertex& place = places.emplace_back();
    place.x = nearest_place(p.x, target);
    place.y = nearest_place(p.y, target);
  });
  return diagonal(half_place(places, target));
}

bool is_on_target(const Geometry& geometry, const Target& target) {
  const RoundedVertices vertices = round_vertices(geometry.region, target);
  bool all = std::none_of(vertices.begin(), vertices.end(),
                          [](const RoundedVertex& v) { return v.moved(); });
  for_each_thin_point(geometry,
                      [&](const Point& p) { all = all && nearest_point(p, target) == p; });
  return all;
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
  r = RoundingReport{};
  const Target target = target_of(options);
  stop_if_asked(options);
  Region result;
  if (region.empty()) {
    r.exact = true;
  } else if (auto rounded = round_by_vertices(region, target, options, r)) {
    result = std::move(*rounded);
  } else {
    Geometry geometry;
    geometry.region = region;
    result = round_by_snapping(geometry, target, options, r).region;
  }
  r.largest_move = std::min(r.largest_move, r.bound);  // both are upper bounds
  r.topology_kept = topology(result) == topology(region);
  return result;
}

Geometry round(const Geometry& geometry, const RoundOptions& options, RoundingReport* report) {
  RoundingReport own;
  RoundingReport& r = report != nullptr ? *report : own;
  Geometry result;
  result.region = round(geometry.region, options, &r);
  if (!geometry.has_thin_parts()) return result;
  const Target target = target_of(options);
  const double moved = add_rounded_thin_parts(geometry, target, result);
  ResolveOptions resolving;
  resolving.cancel = options.cancel;
  result = resolve(result, resolving);
  // A path may end in the middle of a region's edge: rounded by itself, it would come off.
  const bool attached = !geometry.region.empty() && !geometry.polylines.empty();
  const bool moved_apart = attached && !(r.exact && moved == 0);
  if (!moved_apart && is_on_target(result, target)) {
    r.exact = r.exact && moved == 0;
    r.largest_move = std::max(r.largest_move, moved);
    r.bound = std::max(r.bound, thin_bound(geometry, target));
  } else {
    // Or they cross where nothing of the target is.
    r = RoundingReport{};
    result = round_by_snapping(geometry, target, options, r);
    r.largest_move = std::min(r.largest_move, r.bound);
  }
  r.topology_kept = topology(result.region) == topology(geometry.region) &&
                    result.polylines.size() == geometry.polylines.size() &&
                    result.points.size() == geometry.points.size();
  return result;
}

}  // namespace minksum
