// Defines what predicates are about: sites, sum vertices, segments, crossings and probes.
#pragma once

#include <cstdint>

#include "exact/axis.hpp"
#include "exact/fraction.hpp"

namespace minksum {

/// A vertex of either operand. The vertices of the first operand come first. An edge has the id of
/// its first vertex.
using SiteId = std::uint32_t;
inline constexpr SiteId kNoSite = 0xFFFFFFFFU;

/// The sum of a vertex of the first operand and one of the second.
struct SumVertex {
  SiteId first;
  SiteId second;
  friend bool operator==(const SumVertex&, const SumVertex&) = default;
};

/// Returns the sum vertex of two sites of different operands, in either order.
constexpr SumVertex sum_vertex(SiteId a, SiteId b) {
  return a < b ? SumVertex{a, b} : SumVertex{b, a};
}

/// An edge of one operand, moved by a vertex of the other.
struct Segment {
  SiteId edge;
  SiteId vertex;
  friend bool operator==(const Segment&, const Segment&) = default;
};

/// A point on a segment: the crossing with a segment that is not parallel, or a sum vertex on the
/// segment.
struct PointOnSegment {
  bool is_crossing;
  Segment other;
  SumVertex vertex;
};

/// A point of the arrangement: a sum vertex, or the crossing of two segments.
struct NodePoint {
  bool is_crossing;
  Segment first;  ///< used with `second` if the point is a crossing
  Segment second;
  SumVertex vertex;
  /// Returns the vertex, or the start of the first of the two segments.
  [[nodiscard]] SumVertex vertex_or_start() const {
    return is_crossing ? sum_vertex(first.edge, first.vertex) : vertex;
  }
};

/// The point at numerator / 2^shift along a segment, moved off to its right by less than any
/// distance. The point is also moved ahead by less than that again, so that it is in general
/// position to everything (docs/pipeline.md, "Filters").
struct Probe {
  static constexpr int kMaxShift = 60;
  Segment segment;
  std::int64_t numerator;  ///< 0 < numerator < 2^shift
  int shift;               ///< at most kMaxShift
  const Fraction* exact = nullptr;  ///< used instead where kMaxShift bits are too few
};

}  // namespace minksum
