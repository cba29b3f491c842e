// Edges of one operand by the cells of a grid that they pass.
#pragma once

#include "spatial/uniform_grid.hpp"
#include "validation/prepared_operand.hpp"

namespace minksum {

/// To `scratch.in_cells`, cell by cell, each edge once in a cell; a cell's own begin at
/// `scratch.cell_begin[cell]` and end where the next cell's begin. A cell may hold edges that only
/// come near it. Linear in the edges and the cells that they pass; 2^32 of these or more are an
/// error of kLimitExceeded.
void bin_edges(const PreparedOperand& operand, const UniformGrid& grid, Cancellation& cancellation,
               OperandScratch& scratch);

}  // namespace minksum
