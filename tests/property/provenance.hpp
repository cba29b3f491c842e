// Tests whether the origins of a sum's edges are true.
#pragma once

#include <string>

#include "minksum/region.hpp"

namespace minksum::test {

/// Returns the first wrong origin of `sum` = P ⊕ Q in words; empty if all are right. An origin
/// names an edge, which must be the first of a straight run of edges of one operand. That run,
/// moved by the named vertex of the other operand, must hold the beginning of the sum's edge and
/// have its direction. Rings of operands are taken with the interior on the left.
[[nodiscard]] std::string provenance_fault(const Region& p, const Region& q, const Region& sum);

}  // namespace minksum::test
