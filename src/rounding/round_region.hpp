// The ways to round a region: vertex by vertex, or by snapping.
#pragma once

#include <optional>

#include "minksum/round.hpp"
#include "rounding/round_vertices.hpp"

namespace minksum {

/// √2 · length, rounded up.
[[nodiscard]] double diagonal(double length);
/// Half of a double's last place at the magnitude of the largest coordinate, or half a decimal
/// step.
[[nodiscard]] double half_place(const RoundedVertices& vertices, const Target& target);

/// A valid region in canonical form by OGC's rules: cut interiors in pieces of their own.
/// Throws Error(kBadInput) if it is not valid.
[[nodiscard]] Region canonical(const Region& region, const RoundOptions& options);

/// Vertex by vertex; nothing if that is not valid, or not safe. The report lacks `topology_kept`,
/// and so it does below.
[[nodiscard]] std::optional<Region> round_by_vertices(const Region& region, const Target& target,
                                                      const RoundOptions& options,
                                                      RoundingReport& report);

/// Snap-rounds the set: as it is to the nearest; grown, so that all becomes area, to the outside;
/// shrunk to the inside, for which there must not be thin parts.
[[nodiscard]] Geometry round_by_snapping(const Geometry& geometry, const Target& target,
                                         const RoundOptions& options, RoundingReport& report);

/// By vertices if that can be, else by snapping.
[[nodiscard]] Region round_region(const Region& region, const Target& target,
                                  const RoundOptions& options, RoundingReport& report);

}  // namespace minksum
