// Declares what tells from the nesting of rings which of them are in a wrong place.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "validation/prepared_operand.hpp"

namespace minksum {

/// What is wrong with a ring's place.
struct Misplacement {
  bool in_other_hole = false;   ///< a hole inside another hole of its polygon
  bool out_of_outer = false;    ///< a hole outside its outer ring
  bool in_other_outer = false;  ///< an outer ring in another polygon, and in no hole of that
};

/// Returns the misplacement of each ring. `parent` has the smallest ring around each, or
/// RingSweep::kNoRing. Takes linear time.
[[nodiscard]] std::vector<Misplacement> misplaced_rings(std::span<const OperandRing> rings,
                                                        std::span<const std::uint32_t> parent,
                                                        Cancellation& cancellation);

}  // namespace minksum
