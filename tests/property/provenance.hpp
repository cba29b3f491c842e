// Does every edge of a sum tell the truth about what made it?
#pragma once

#include <string>

#include "minksum/region.hpp"

namespace minksum::test {

/// The first lie among the origins of `sum` = P ⊕ Q, in words; empty if there is none. Checked for
/// each edge: the named straight run of edges of one operand, moved by the named vertex of the
/// other, holds the beginning of the edge and has its direction (rings of operands taken with the
/// interior on the left), and the named edge is the first of its straight run.
[[nodiscard]] std::string provenance_fault(const Region& p, const Region& q, const Region& sum);

}  // namespace minksum::test
