// Step 2 of the signed method: the signed convolutions of pairs of rings, as closed chains.
//
// The source is Guibas, Ramshaw, Stolfi, "A kinetic framework for computational geometry", FOCS
// 1983.
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "machine/cancellation.hpp"
#include "minksum/region.hpp"
#include "second/signed_convolution/operands.hpp"

namespace minksum::signed_sum {

/// The sum of a vertex of one ring and a vertex of another.
struct VertexSum {
  std::uint32_t p = 0;
  std::uint32_t q = 0;
  friend auto operator<=>(const VertexSum&, const VertexSum&) = default;
};

/// An edge of one ring, moved by a vertex of the other. At a convex vertex it has the edge's
/// direction, and at a reflex vertex the reverse.
struct SignedSegment {
  VertexSum from;
  VertexSum to;
};

/// Returns the segments of the signed convolution of two rings. `count` is how many directions
/// there are. Throws Error(kLimitExceeded) if there are more than `most`.
[[nodiscard]] std::vector<SignedSegment> signed_segments(const DirectedRing& p,
                                                         const DirectedRing& q, DirectionRank count,
                                                         std::uint64_t most,
                                                         Cancellation& cancellation);

/// Links segments into closed chains, and adds them to the last polygon of `chains` as its rings.
/// Throws Error(kInternal) unless at each sum of vertices as many segments come in as go out. The
/// half-open rules for parallel edges must achieve this.
void link_segments(const DirectedRing& p, const DirectedRing& q,
                   std::vector<SignedSegment> segments, Cancellation& cancellation, Region& chains);

/// Returns the signed convolutions of all pairs of parts. Each ring is a closed chain, and the
/// region is a store of points only. Let ω be the sum of the chains' winding numbers at a point x
/// that lies on no chain. Then x is in the sum if ω > 0, and otherwise ω is 0.
///
/// Proof. Take a part A of P and a part B of Q. For two rings, the winding number around x is an
/// integral with respect to the Euler characteristic. It is that of the product of two winding
/// numbers: of the first ring, and of x minus the second. Holes of A count only if they are wider
/// and higher than B, and holes of B only if they are wider and higher than A. So at most one of
/// the two has holes that count; let it be A. Let A' be A with its other holes filled, and B' be
/// x - B with all its holes filled. Then all rings together have as winding number the Euler
/// characteristic of A' ∩ B'. A bounded component of the complement of A' ∩ B' would lie in B',
/// which has no holes, and would be a whole hole of A'. But that is wider than B'. So the Euler
/// characteristic is the count of components of A' ∩ B', which is 0 or more. It is 0 if and only if
/// A' and B' do not meet. Filling these holes does not change A ⊕ B. So x is not in A ⊕ B then.
///
/// A part that is a polyline has the winding number of the path: the integral counts the stretches
/// of x - path inside the other part, or its crossings with another path.
[[nodiscard]] Region signed_convolutions(const DirectedOperands& operands, std::uint64_t most,
                                         Cancellation& cancellation);

}  // namespace minksum::signed_sum
