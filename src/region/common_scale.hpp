// Puts a region's coordinates on one integer grid, for its measures.
#pragma once

#include <cstdint>
#include <vector>

#include "machine/cancellation.hpp"
#include "minksum/rational.hpp"
#include "minksum/region.hpp"
#include "region/rational_access.hpp"

namespace minksum {

struct ScaledPoint {
  std::int64_t x;
  std::int64_t y;
};

/// Coordinates of all vertices in units of `unit`, a product of powers of two and ten.
struct CommonScale {
  Rational unit;
  std::vector<ScaledPoint> points;
};

/// Returns whether every coordinate is an integer below 2^61 in absolute value on one such grid. If
/// so, `scale` holds them.
bool find_common_scale(const Region& region, Cancellation& cancellation, CommonScale& scale);

/// Returns the least common multiple of positive integers.
BigInteger least_common_multiple(BigInteger common, std::vector<BigInteger> values,
                                 Cancellation& cancellation);
/// Returns the smallest positive integer whose product with each coordinate that is a double or a
/// finite decimal is an integer.
BigInteger finite_denominator(const Region& region, Cancellation& cancellation);
/// Returns the smallest such integer for all coordinates.
BigInteger least_common_denominator(const Region& region, Cancellation& cancellation);

}  // namespace minksum
