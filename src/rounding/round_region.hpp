// Rounds a region in one of two ways: vertex by vertex, or by snapping.
#pragma once

#include <optional>

#include "minksum/round.hpp"
#include "rounding/round_vertices.hpp"

namespace minksum {

/// What `round` was asked for.
struct RoundRequest {
  RoundingSide side = RoundingSide::kNearest;
  std::optional<int> decimals;
  Options options;  ///< of every part of the work
};

/// Returns √2 · length, rounded up.
[[nodiscard]] double diagonal(double length);
/// Returns half of a double's last place at the magnitude of the largest coordinate, or half a
/// decimal step.
[[nodiscard]] double half_place(const RoundedVertices& vertices, const Target& target);

/// Returns a valid region in canonical form, by the OGC's rules. A polygon whose interior is cut
/// becomes several. Throws Error(kBadInput) if the region is not valid.
[[nodiscard]] Region canonical(const Region& region, const RoundRequest& request);

/// Rounds vertex by vertex. Returns nothing if the result is not valid or not on the right side.
/// This function and the next two leave `topology_kept` of the report unset.
[[nodiscard]] std::optional<Region> round_by_vertices(const Region& region, const Target& target,
                                                      const RoundRequest& request,
                                                      RoundingReport& report);

/// Snap-rounds the set. To the outside, it is grown first, so that all becomes area. To the inside,
/// it is shrunk first, and must not have thin parts.
[[nodiscard]] Geometry round_by_snapping(const Geometry& geometry, const Target& target,
                                         const RoundRequest& request, RoundingReport& report);

/// Rounds by vertices if that works, and by snapping otherwise.
[[nodiscard]] Region round_region(const Region& region, const Target& target,
                                  const RoundRequest& request, RoundingReport& report);

}  // namespace minksum
