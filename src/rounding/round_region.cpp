#include "rounding/round_region.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "minksum/resolve.hpp"
#include "rounding/choose_side.hpp"
#include "rounding/grow.hpp"
#include "rounding/keep_topology.hpp"
#include "rounding/snap.hpp"
#include "validation/fault.hpp"

namespace minksum {
namespace {

/// Returns a length in the target's unit as a length, rounded up.
double in_units(double length, const Target& target) {
  if (length == 0 || !target.is_decimal()) return length;
  return rounded_up(length * rounded_up(target.unit()));
}

[[noreturn]] void refuse(const Region& region, const RoundRequest& request) {
  require_valid(region, -1, request.options);
  throw Error(ErrorCode::kInternal, "a valid region was found not to be valid", {}, "round");
}

Region resolved(const Region& region, const RoundRequest& request) {
  return resolve(Geometry(region), part_of(request.options)).region;
}

/// Returns the geometry to be snapped so that the result lies on the right side.
Geometry sided(const Geometry& geometry, const RoundRequest& request, const SnapGrid& grid) {
  Geometry base{canonical(geometry.region, request), geometry.polylines, geometry.points};
  const Rational half = grid.step() * Rational(1, 2);
  switch (request.side) {
    case RoundingSide::kNearest:
      break;
    case RoundingSide::kOutside:
      if (base.has_thin_parts()) return {grown(base, half, request.options), {}, {}};
      base.region = grown(base.region, half, request.options);
      break;
    case RoundingSide::kInside:
      base.region = shrunk(base.region, half, request.options);
      break;
  }
  return base;
}

}  // namespace

double diagonal(double length) { return rounded_up(length * std::sqrt(2.0)); }

double half_place(const RoundedVertices& vertices, const Target& target) {
  if (target.is_decimal()) return rounded_up(target.unit() * Rational(1, 2));
  double largest = 0;
  for (const RoundedVertex& v : vertices) {
    largest = std::max({largest, std::abs(v.x.value), std::abs(v.y.value)});
  }
  constexpr int kLowest = -1074;
  const int last_place = largest == 0 ? kLowest : std::max(std::ilogb(largest) - 52, kLowest);
  // Half of the smallest double is no double.
  return std::max(std::ldexp(1.0, last_place - 1), std::ldexp(1.0, kLowest));
}

Region canonical(const Region& region, const RoundRequest& request) {
  Cancellation cancellation(request.options, Stage::kRounding);
  TopologyCheck same = check_topology(region, region, cancellation);
  if (same.outcome == TopologyVerdict::kInvalid) refuse(region, request);
  if (same.outcome == TopologyVerdict::kCut) return resolved(same.region, request);
  return std::move(same.region);
}

std::optional<Region> round_by_vertices(const Region& region, const Target& target,
                                        const RoundRequest& request, RoundingReport& report) {
  Cancellation cancellation(request.options, Stage::kRounding);
  const RoundedVertices vertices = round_vertices(region, target, cancellation);
  report.exact = std::none_of(vertices.begin(), vertices.end(),
                              [](const RoundedVertex& v) { return v.moved(); });
  const bool sided = request.side != RoundingSide::kNearest && !report.exact;
  const double half = half_place(vertices, target);
  Sided moved;
  if (sided) {
    auto chosen = choose_side(region, request.side, target, vertices,
                              target.is_decimal() ? 1 : 2 * half, cancellation);
    if (!chosen) return {};
    moved = std::move(*chosen);
  } else {
    moved = {with_vertices(region, vertices, target, cancellation), largest_move(vertices)};
  }
  TopologyCheck checked = check_topology(region, moved.region, cancellation);
  if (checked.outcome == TopologyVerdict::kInvalid) return {};
  if (checked.outcome == TopologyVerdict::kCut) checked.region = resolved(checked.region, request);
  report.largest_move = in_units(moved.largest_move, target);
  report.bound = diagonal(half * (request.side != RoundingSide::kNearest ? 2 : 1));
  return std::move(checked.region);
}

Geometry round_by_snapping(const Geometry& geometry, const Target& target,
                           const RoundRequest& request, RoundingReport& report) {
  Cancellation cancellation(request.options, Stage::kRounding);
  const SnapGrid grid = snap_grid(geometry, target, cancellation);
  Geometry base = sided(geometry, request, grid);
  if (base.has_thin_parts()) base = resolve(base, part_of(request.options));
  Snapped snapped = snap(base, grid, cancellation);
  const double step = rounded_up(grid.step());
  const bool moved_first = request.side != RoundingSide::kNearest;
  report.snapped = true;
  report.exact = snapped.exact && !moved_first;
  report.largest_move =
      moved_first ? rounded_up(snapped.largest_move + diagonal(step / 2)) : snapped.largest_move;
  report.bound = diagonal(moved_first ? step : step / 2);
  return std::move(snapped.geometry);
}

Region round_region(const Region& region, const Target& target, const RoundRequest& request,
                    RoundingReport& report) {
  report = RoundingReport{};
  if (region.empty()) {
    report.exact = true;
    return {};
  }
  if (auto rounded = round_by_vertices(region, target, request, report)) return std::move(*rounded);
  return round_by_snapping(Geometry(region), target, request, report).region;
}

}  // namespace minksum
