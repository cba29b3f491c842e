// Stage 6: decides which orientable loops bound the sum.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "minksum/trace.hpp"
#include "sum/filters/collision.hpp"
#include "sum/loops/loops.hpp"

namespace minksum {

using LoopState = Trace::LoopState;

struct FilteredLoops {
  std::vector<LoopState> state;  ///< by loop
  std::uint64_t rejected_by_nesting = 0;
  std::uint64_t rejected_by_collision = 0;
};

/// Decides for every loop whether it bounds the sum. The nesting filter comes first (Behar and
/// Lien, section IV-D): the sum of two connected operands is connected, so no positive loop inside
/// its outer boundary can bound it. One collision test decides each other loop. If an operand has
/// several polygons or polylines, or if both are thin, collision alone decides.
void filter_loops(const Operands& operands, const Arrangement& arrangement, const Loops& loops,
                  Predicates& predicates, BoxTrees& trees, FilteredLoops& filtered);

/// Returns what is wrong with the filtered loops, or nothing. Each loop must have a state, and the
/// counts must agree. A collision test at each piece must agree with its loop's state.
[[nodiscard]] std::optional<std::string> check(const FilteredLoops& filtered, const Loops& loops,
                                               const Arrangement& arrangement,
                                               const Operands& operands);

/// Returns a probe just to the right of a piece, about in its middle. `exact` holds the probe's
/// position if that needs more bits than a Probe has.
[[nodiscard]] Probe probe_on(const Arrangement& arrangement, const Piece& piece,
                             const Predicates& predicates, Fraction& exact);

}  // namespace minksum
