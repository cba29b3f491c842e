// Sorts the edges of one operand into the cells of a grid that they pass.
#pragma once

#include "spatial/uniform_grid.hpp"
#include "validation/prepared_operand.hpp"

namespace minksum {

/// Fills `scratch.in_cells` with the edges of all cells, cell by cell, each edge once in a cell.
/// The edges of a cell begin at `scratch.cell_begin[cell]`, and end where those of the next cell
/// begin. A cell may hold edges that only come near it. Takes linear time in the edges and the
/// cells that they pass. Throws kLimitExceeded if there are 2^32 entries or more.
void bin_edges(const PreparedOperand& operand, const UniformGrid& grid, Cancellation& cancellation,
               OperandScratch& scratch);

}  // namespace minksum
