// Operands whose coordinates fit no integer grid of fixed width.
#pragma once

#include <span>

#include "validation/prepared_operand.hpp"

namespace minksum {

/// Approximations of rational coordinates are scaled to about so many bits: that keeps squares and
/// fifth powers of extents in a double's range.
inline constexpr int kRationalExtentBits = 60;

/// The coordinates of all vertices as given.
void load_rationals(const Region& region, Cancellation& cancellation,
                    RationalCoordinates& rationals);
/// Sets box and bits.
void measure_rationals(Cancellation& cancellation, RationalCoordinates& rationals);
/// An operand's coordinates of these sites, whatever holds them.
[[nodiscard]] RationalCoordinates rationals_of(const PreparedOperand& operand,
                                               std::span<const SiteId> sites,
                                               Cancellation& cancellation);
/// The power of two that scales the larger of the extents to kRationalExtentBits bits.
[[nodiscard]] int rational_exponent(std::span<const Vec<BigRational>> extents);

}  // namespace minksum
