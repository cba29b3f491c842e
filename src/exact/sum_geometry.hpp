// The things that predicates speak of: sites, sum vertices, convolution segments, crossings.
#pragma once

#include <cstdint>

#include "exact/big_integer.hpp"

namespace minksum {

/// A vertex of either operand; those of the first come first. An edge has its first vertex's id.
using SiteId = std::uint32_t;
inline constexpr SiteId kNoSite = 0xFFFFFFFFU;

enum class Axis : unsigned char { kX, kY };

/// The sum of a vertex of the first operand and one of the second.
struct SumVertex {
  SiteId first;
  SiteId second;
  friend bool operator==(const SumVertex&, const SumVertex&) = default;
};

/// The sum vertex of two sites of different operands, in either order.
constexpr SumVertex sum_vertex(SiteId a, SiteId b) {
  return a < b ? SumVertex{a, b} : SumVertex{b, a};
}

/// An edge of one operand, moved by a vertex of the other.
struct Segment {
  SiteId edge;
  SiteId vertex;
  friend bool operator==(const Segment&, const Segment&) = default;
};

/// A point on a segment, as what makes it: the crossing with a segment that is not parallel to it,
/// or a sum vertex that lies on it.
struct PointOnSegment {
  bool is_crossing;
  Segment other;
  SumVertex vertex;
};

/// A point of the arrangement: a sum vertex, or the crossing of two segments.
struct NodePoint {
  bool is_crossing;
  Segment first;  ///< with `second`, if it is a crossing
  Segment second;
  SumVertex vertex;
  /// The vertex, or where the first of the two segments starts.
  [[nodiscard]] SumVertex vertex_or_start() const {
    return is_crossing ? sum_vertex(first.edge, first.vertex) : vertex;
  }
};

/// The point at numerator / 2^shift along a segment, less than any distance off to its right, and
/// less than that again ahead: in general position to everything (docs/pipeline.md, "Filters").
struct Probe {
  static constexpr int kMaxShift = 60;
  Segment segment;
  std::int64_t numerator;  ///< 0 < numerator < 2^shift
  int shift;               ///< at most kMaxShift
  const BigRational* exact = nullptr;  ///< instead, where so few bits cannot tell the place
};

}  // namespace minksum
