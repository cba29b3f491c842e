// Declares mathematical morphology: dilation, erosion, opening and closing by a structuring
// element. Complexity is that of the sums and differences of which each of them is made.
#pragma once

#include "minksum/export.h"
#include "minksum/minkowski_sum.hpp"

namespace minksum {

/// Returns the dilation A ⊕ B = { a + b | a ∈ A, b ∈ B }. This is minkowski_sum by another name.
[[nodiscard]] MINKSUM_API Geometry dilate(const Geometry& a, const Geometry& b,
                                          const Options& options = {});

/// Returns the erosion A ⊖ B = { x | x + B ⊆ A }: where B can be put inside A. Both are read by
/// `options.fill`. B may have holes and thin parts, and need not contain the origin. A's thin parts
/// are dropped.
///
/// The erosion is the complement of the sum of A's complement and −B. It is computed, exactly, in a
/// frame around A that is wide enough to keep the islands of a disconnected complement. The result
/// has no thin parts, unless `options.tight` is true. Then it has the points and polylines at which
/// the element fits without play.
///
/// Throws Error: kBadInput with culprit operand 1 if B is empty (the erosion would be the whole
/// plane), or if it has thin parts while `options.tight` is true; whatever minkowski_sum and
/// `subtract` throw.
[[nodiscard]] MINKSUM_API Geometry erode(const Geometry& a, const Geometry& b,
                                         const Options& options = {});

/// Returns the opening A ∘ B = (A ⊖ B) ⊕ B: the union of all translates of B inside A. It lies
/// inside A, and opening it again changes nothing. Throws as `erode` does.
[[nodiscard]] MINKSUM_API Geometry open(const Geometry& a, const Geometry& b,
                                        const Options& options = {});

/// Returns the closing A • B = (A ⊕ B) ⊖ B: the points that no translate of −B covers without
/// meeting A. It contains the area of A, and all of A with tight places. Closing it again changes
/// nothing. Throws as `erode` does.
[[nodiscard]] MINKSUM_API Geometry close(const Geometry& a, const Geometry& b,
                                         const Options& options = {});

}  // namespace minksum
