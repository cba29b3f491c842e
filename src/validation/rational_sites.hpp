// Handles operands whose coordinates fit no integer grid of fixed width.
#pragma once

#include <span>

#include "validation/prepared_operand.hpp"

namespace minksum {

/// Approximations of rational coordinates are scaled to about so many bits. This scale keeps
/// squares and fifth powers of extents in a double's range.
inline constexpr int kRationalExtentBits = 60;

/// Loads the coordinates of all vertices as given.
void load_rationals(const Region& region, Cancellation& cancellation,
                    RationalCoordinates& rationals);
/// Sets the box and the bits.
void measure_rationals(Cancellation& cancellation, RationalCoordinates& rationals);
/// Returns an operand's coordinates of these sites, as rationals in any case.
[[nodiscard]] RationalCoordinates rationals_of(const PreparedOperand& operand,
                                               std::span<const SiteId> sites,
                                               Cancellation& cancellation);
/// Returns the exponent of two that scales the larger of the extents to kRationalExtentBits bits.
[[nodiscard]] int rational_exponent(std::span<const Vec<Fraction>> extents);

}  // namespace minksum
