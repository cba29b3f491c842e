// Fills the public Trace with what the stages made, in doubles.
#pragma once

#include "minksum/trace.hpp"
#include "sum/filters/filters.hpp"

namespace minksum {

void fill_trace(const Operands& operands, const Convolution& convolution, const Cover& cover,
                const Arrangement& arrangement, const Loops& loops, const FilteredLoops& filtered,
                Cancellation& cancellation, Trace& trace);

}  // namespace minksum
