// Offers CGAL's reduced convolution by an interface without CGAL's headers.
#pragma once

#include "minksum/region.hpp"

namespace minksum::oracle {

struct CgalSum {
  Region sum;          ///< canonical, exact
  double seconds = 0;  ///< time of the sum alone, without converting operands
};

/// Returns P ⊕ Q of two regions of one polygon each, by CGAL's
/// Minkowski_sum_by_reduced_convolution_2 with exact constructions. Holes for which the other
/// operand is too wide or too high are filled first, because CGAL 5.5's own filter corrupts memory.
/// Throws std::runtime_error if an operand has several parts, and std::logic_error if CGAL's rings
/// do not link up to a boundary.
[[nodiscard]] CgalSum cgal_sum(const Region& p, const Region& q);

/// Returns a text such as "CGAL 5.5.1".
[[nodiscard]] const char* cgal_version();

}  // namespace minksum::oracle
