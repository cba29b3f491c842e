// The exact order of edge directions.
#pragma once

#include "sum/operands/prepare_operand.hpp"

namespace minksum {

/// Returns 0 for directions in [0, π), and 1 for directions in [π, 2π).
inline int half_circle(Predicates& predicates, SiteId edge) {
  const Sign dy = predicates.component(edge, Axis::kY);
  if (dy != kZero) return dy == kPositive ? 0 : 1;
  return predicates.component(edge, Axis::kX) == kPositive ? 0 : 1;
}

/// Compares directions counter-clockwise from the positive x axis. Returns a negative sign if `a`
/// comes first, and zero if both are parallel and of one sense.
inline Sign compare_directions(Predicates& predicates, SiteId a, SiteId b) {
  const int half_a = half_circle(predicates, a);
  const int half_b = half_circle(predicates, b);
  if (half_a != half_b) return half_a < half_b ? kNegative : kPositive;
  return -predicates.cross(a, b);
}

/// Compares as above, but by the keys where these decide.
inline Sign compare_directions(Predicates& predicates, bool keys_tell, const KeyedEdge& a,
                               const KeyedEdge& b) {
  if (keys_tell && a.key - b.key > 2 * kKeyError) return kPositive;
  if (keys_tell && b.key - a.key > 2 * kKeyError) return kNegative;
  return compare_directions(predicates, a.edge, b.edge);
}

}  // namespace minksum
