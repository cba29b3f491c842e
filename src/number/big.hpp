// Numbers of any size, from Boost.Multiprecision.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

namespace minksum {

// Without expression templates: results of arithmetic have the type that the formulas name.
using BigInteger = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>,
                                             boost::multiprecision::et_off>;
using BigRational = boost::multiprecision::number<boost::multiprecision::cpp_rational_backend,
                                                  boost::multiprecision::et_off>;

}  // namespace minksum
