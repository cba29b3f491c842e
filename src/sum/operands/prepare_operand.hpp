// One operand, ready for sums: validated, or walked along if it is thin, its directions sorted.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "minksum/geometry.hpp"
#include "validation/prepared_operand.hpp"

namespace minksum {

/// Fills `operand` from `region`, which must live as long. Of `options`, `arithmetic` and `filter`
/// count. Without any fault the operand is complete; otherwise it may not be used.
/// O(n log n) for n vertices, plus close pairs of edges for the validation.
void prepare_operand(const Region& region, const Options& options, std::size_t max_faults,
                     Cancellation& cancellation, OperandScratch& scratch, PreparedOperand& operand,
                     std::vector<Fault>& faults);

/// A region whose polygons are walks: each polyline from its start to its end and back, a ring
/// without area. Polylines are as in a resolved Geometry: simple, without straight vertices. A
/// closed one is cut at its first vertex.
void walk_there_and_back(std::span<const Polyline> polylines, Cancellation& cancellation,
                         Region& walks);

/// The same as `prepare_operand` for the union of the polylines that `walks` goes along.
///
/// A walk is the boundary of the polyline made a little wider, in the limit: on one side of each
/// vertex it turns left, on the other one right, and at both ends it turns left by half a circle.
/// That is all that the pipeline asks of a ring: docs/pipeline.md, "Thin operands". The other
/// operand must have area. O(n log n).
void prepare_thin_operand(const Region& walks, const Options& options, Cancellation& cancellation,
                          OperandScratch& scratch, PreparedOperand& operand);

/// Sorts edges by direction.
void sort_directions(Cancellation& cancellation, OperandScratch& scratch, PreparedOperand& operand);

}  // namespace minksum
