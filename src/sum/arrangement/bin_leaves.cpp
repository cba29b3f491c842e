// Takes the segments of a divided cover from the lists of its leaves.
#include <algorithm>

#include "sum/arrangement/place_segments.hpp"

namespace minksum {
namespace {

constexpr KeptId kUnlisted = 0xFFFFFFFFU;
constexpr KeptId kListed = kUnlisted - 1;

/// Keeps each segment that a leaf lists once, in the convolution's order. `scratch.kept_id` is by
/// segment of the convolution; only the first of equal segments gets an id.
void keep_listed(const Operands& o, const Convolution& convolution, const Cover& cover,
                 Cancellation& cancellation, ArrangementScratch& scratch,
                 std::vector<KeptSegment>& kept) {
  auto& id_of = scratch.kept_id;
  assign_in_pieces(id_of, convolution.segments.size(), kUnlisted, cancellation);
  visit_in_pieces(cover.leaf_segments, cancellation, [&](std::uint32_t s) { id_of[s] = kListed; });
  const bool exact_sums = o.bounds.difference == 0;
  DuplicateFinder duplicates(scratch.hash_table, kept, cancellation);
  kept.clear();
  in_pieces(id_of.size(), cancellation, [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s) {
      if (id_of[s] == kUnlisted) continue;
      append(kept, place_segment(o, convolution.segments[s]), cancellation);
      kept.back().meets_cover = true;
      id_of[s] = static_cast<KeptId>(kept.size() - 1);
      if (exact_sums && duplicates.seen()) {
        kept.pop_back();
        id_of[s] = kUnlisted;
      }
    }
  });
}

/// Returns the box of a segment's part near a leaf. It is in units of the leaf's side, from the
/// leaf's lower left corner.
CellBox box_near(const KeptSegment& s, const UniformGrid& grid, const QuadtreeLeaf& leaf) {
  const CellLine line(s, grid.inverse);
  const Vec<double> a = line.start;
  const Vec<double> b{s.b.x * grid.inverse, s.b.y * grid.inverse};
  const double margin = CellBox::kReach * leaf.side;
  const double x0 = std::max(std::min(a.x, b.x), leaf.column - margin);
  const double x1 = std::min(std::max(a.x, b.x), leaf.column + leaf.side + margin);
  double y0 = std::min(a.y, b.y);
  double y1 = std::max(a.y, b.y);
  if (line.rise != 0) {
    const double at_x0 = line.height_at(x0);
    const double at_x1 = line.height_at(x1);
    y0 = std::max(y0, std::min(at_x0, at_x1));
    y1 = std::min(y1, std::max(at_x0, at_x1));
  }
  const double unit = 1.0 / leaf.side;  // a power of two
  return {(x0 - leaf.column) * unit, (y0 - leaf.row) * unit, (x1 - leaf.column) * unit,
          (y1 - leaf.row) * unit};
}

}  // namespace

void bin_leaves(const Operands& operands, const Convolution& convolution, const Cover& cover,
                Cancellation& cancellation, ArrangementScratch& scratch, Arrangement& arrangement) {
  scratch.grid = cover.grid;
  scratch.covered = true;
  scratch.extent = operands.sum_extent();
  keep_listed(operands, convolution, cover, cancellation, scratch, arrangement.kept);
  scratch.line_count = static_cast<KeptId>(arrangement.kept.size());
  scratch.in_cells.clear();
  scratch.leaf_end.clear();
  make_room(scratch.in_cells, cover.leaf_segments.size(), cancellation);
  std::uint32_t i = 0;
  for (const QuadtreeLeaf& leaf : cover.leaves) {
    for (; i < leaf.end; ++i) {
      cancellation.check(2);
      const KeptId id = scratch.kept_id[cover.leaf_segments[i]];
      if (id == kUnlisted) continue;
      scratch.in_cells.push_back({box_near(arrangement.kept[id], cover.grid, leaf), 0, id});
    }
    scratch.leaf_end.push_back(static_cast<std::uint32_t>(scratch.in_cells.size()));
  }
}

}  // namespace minksum
