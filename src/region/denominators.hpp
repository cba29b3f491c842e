// Finds common denominators of a region's coordinates.
#pragma once

#include <vector>

#include "machine/cancellation.hpp"
#include "minksum/region.hpp"
#include "region/rational_access.hpp"

namespace minksum {

/// Returns the least common multiple of positive integers.
BigInteger least_common_multiple(BigInteger common, std::vector<BigInteger> values,
                                 Cancellation& cancellation);
/// Returns the smallest positive integer whose product with each coordinate that is a double or a
/// finite decimal is an integer.
BigInteger finite_denominator(const Region& region, Cancellation& cancellation);
/// Returns the smallest such integer for all coordinates.
BigInteger least_common_denominator(const Region& region, Cancellation& cancellation);

}  // namespace minksum
