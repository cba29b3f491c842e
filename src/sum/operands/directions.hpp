// The exact order of edge directions.
#pragma once

#include "sum/operands/prepare_operand.hpp"

namespace minksum {

/// 0 for directions in [0, π), 1 for [π, 2π).
inline int half_circle(Predicates& predicates, SiteId edge) {
  const Sign dy = predicates.component(edge, Axis::kY);
  if (dy != kZero) return dy == kPositive ? 0 : 1;
  return predicates.component(edge, Axis::kX) == kPositive ? 0 : 1;
}

/// Order counter-clockwise from the positive x axis: negative if `a` comes first, zero if parallel.
inline Sign compare_directions(Predicates& predicates, SiteId a, SiteId b) {
  const int half_a = half_circle(predicates, a);
  const int half_b = half_circle(predicates, b);
  if (half_a != half_b) return half_a < half_b ? kNegative : kPositive;
  return -predicates.cross(a, b);
}

/// The same, by the keys where they tell.
inline Sign compare_directions(Predicates& predicates, bool keys_tell, const KeyedEdge& a,
                               const KeyedEdge& b) {
  if (keys_tell && a.key - b.key > 2 * kKeyError) return kPositive;
  if (keys_tell && b.key - a.key > 2 * kKeyError) return kNegative;
  return compare_directions(predicates, a.edge, b.edge);
}

}  // namespace minksum
