// Mathematical morphology: dilation, erosion, opening and closing by a structuring element.
#pragma once

#include "minksum/export.h"
#include "minksum/minkowski_sum.hpp"

namespace minksum {

/// A ⊕ B = { a + b | a ∈ A, b ∈ B }: minkowski_sum by another name.
[[nodiscard]] MINKSUM_API Geometry dilate(const Geometry& a, const Geometry& b,
                                          const Options& options = {});

/// A ⊖ B = { x | x + B ⊆ A }: where B can be put inside A. B may have holes and thin parts, and
/// need not contain the origin; A's thin parts are dropped.
///
/// It is the complement of A's complement ⊕ −B, computed in a frame around A that is wide enough,
/// so that islands of a disconnected complement come out too. Exact, as minkowski_sum is. The
/// result is regularized, unless `options.tight` is true: then it has the points and polylines
/// where the element fits without play.
/// Throws Error(kBadInput) if B is empty (the erosion would be the whole plane), or has thin parts
/// while `options.tight` is true.
[[nodiscard]] MINKSUM_API Geometry erode(const Geometry& a, const Geometry& b,
                                         const Options& options = {});

/// A ∘ B = (A ⊖ B) ⊕ B: the union of all translates of B inside A. Idempotent; contained in A.
[[nodiscard]] MINKSUM_API Geometry open(const Geometry& a, const Geometry& b,
                                        const Options& options = {});

/// A • B = (A ⊕ B) ⊖ B: what no translate of −B outside A's sum can reach. Idempotent; contains A.
[[nodiscard]] MINKSUM_API Geometry close(const Geometry& a, const Geometry& b,
                                         const Options& options = {});

}  // namespace minksum
