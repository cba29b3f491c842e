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
/// Returns an operand's coordinates of these sites in a unit, as rationals in any case. A rational
/// operand has 1 as unit.
[[nodiscard]] RationalCoordinates rationals_of(const PreparedOperand& operand,
                                               std::span<const SiteId> sites, const GridUnit& unit,
                                               Cancellation& cancellation);
/// Returns the exponent of two that scales the larger of the extents to kRationalExtentBits bits.
[[nodiscard]] int rational_exponent(std::span<const Vec<Fraction>> extents);

}  // namespace minksum
