// CGAL's reduced convolution behind an interface without CGAL.
#pragma once

#include "minksum/region.hpp"

namespace minksum::oracle {

struct CgalSum {
  Region sum;          ///< canonical, exact
  double seconds = 0;  ///< of the sum alone, operands converted before
};

/// P ⊕ Q of two regions of one polygon each, by CGAL's Minkowski_sum_by_reduced_convolution_2 with
/// exact constructions. Holes that the other operand is too wide or too high for are filled first:
/// CGAL 5.5's own filter corrupts memory, so it is not used. Throws std::runtime_error if an
/// operand has several parts, std::logic_error if CGAL's rings do not link up to a boundary.
[[nodiscard]] CgalSum cgal_sum(const Region& p, const Region& q);

/// "CGAL 5.5.1"
[[nodiscard]] const char* cgal_version();

}  // namespace minksum::oracle
