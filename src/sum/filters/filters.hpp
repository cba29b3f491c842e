// Stage 6: which orientable loops bound the sum.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sum/filters/collision.hpp"
#include "sum/loops/loops.hpp"

namespace minksum {

enum class LoopState : std::uint8_t { kAccepted, kRejectedByNesting, kRejectedByCollision };

struct FilteredLoops {
  std::vector<LoopState> state;  ///< by loop
  std::uint64_t rejected_by_nesting = 0;
  std::uint64_t rejected_by_collision = 0;
};

/// Judges every loop. First by nesting (Behar and Lien, section IV-D): the sum of two connected
/// operands is connected, so inside its outer boundary no positive loop can be true. Then by one
/// collision test each. With several polygons in an operand islands are valid: collision alone
/// decides.
void filter_loops(const Operands& operands, const Arrangement& arrangement, const Loops& loops,
                  Predicates& predicates, BoxTrees& trees, FilteredLoops& filtered);

/// Whether each loop has a state and the counts agree, and each accepted loop's face is free by
/// tests at all its pieces; what is wrong, if not.
[[nodiscard]] std::optional<std::string> check(const FilteredLoops& filtered, const Loops& loops,
                                               const Arrangement& arrangement,
                                               const Operands& operands);

}  // namespace minksum
