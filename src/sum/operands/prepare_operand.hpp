// Prepares one operand for sums: validates it, or walks along it if it is thin, and sorts its
// directions.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "minksum/geometry.hpp"
#include "minksum/testing.hpp"
#include "validation/prepared_operand.hpp"

namespace minksum {

/// Fills `operand` from `region`, which must live as long. `operand` may be used only if `faults`
/// stays empty. Only `arithmetic` and `filter` of `options` are used.
/// O(n log n) for n vertices, plus close pairs of edges for the validation.
void prepare_operand(const Region& region, const SumSettings& options, std::size_t max_faults,
                     Cancellation& cancellation, OperandScratch& scratch, PreparedOperand& operand,
                     std::vector<Fault>& faults);

/// Fills `operand` from the union of the polylines that `walks` goes along, as `prepare_operand`
/// does from polygons.
///
/// A walk is the boundary of the polyline made a little wider, in the limit. At each vertex within
/// it turns left on one side and right on the other. At both ends it turns left by half a circle.
/// The pipeline asks no more of a ring: see docs/pipeline.md, "How are polylines and points
/// added?". O(n log n).
void prepare_thin_operand(const Region& walks, const SumSettings& options,
                          Cancellation& cancellation, OperandScratch& scratch,
                          PreparedOperand& operand);

/// Sorts an operand's edges by direction.
void sort_directions(Cancellation& cancellation, OperandScratch& scratch, PreparedOperand& operand);

}  // namespace minksum
