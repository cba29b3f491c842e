// Finds the segments that touch uncovered cells, and lists them cell by cell.
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>

#include "machine/share_by_key.hpp"
#include "sum/arrangement/place_segments.hpp"
#include "sum/arrangement/visible_segments.hpp"

namespace minksum {
namespace {

class Binner {
 public:
  Binner(const Operands& o, const Cover& cover, ArrangementScratch& scratch,
         Cancellation& cancellation, Arrangement& arrangement)
      : cancellation_(cancellation),
        o_(o),
        cover_(cover),
        covers_any_(cover.covers_any()),
        grid_(scratch.grid),
        scratch_(scratch),
        kept_(arrangement.kept) {}

  void run(const Convolution& convolution, const Limits& limits) {
    kept_.clear();
    std::span<const Segment> visible =
        covers_any_
            ? visible_segments(o_, convolution, cover_, limits, cancellation_, scratch_.visible)
            : convolution.segments;
    if (visible.size() >= kWorthOrdering) visible = order_along_rings(visible);
    if (cover_.clips) clip(visible);
    place(visible);
    join_lines(o_, cancellation_, scratch_.join, kept_);
    grid_ = cover_.grid;
    scratch_.covered = covers_any_;
    scratch_.by_cells = covers_any_ && cover_.by_cells;
    scratch_.extent = o_.sum_extent();
    if (covers_any_) keep_visible();
    scratch_.line_count = static_cast<KeptId>(kept_.size());
    append_members();
    if (scratch_.by_cells) sort_by_cells();
  }

 private:
  static constexpr std::size_t kWorthOrdering = 4096;  ///< fewer are near enough in memory anyway

  /// Orders segments by the sites of the operand that has more sites. Segments that are near in the
  /// plane are then near in memory, and so is all that is made of them up to the output.
  std::span<const Segment> order_along_rings(std::span<const Segment> segments) {
    const int longer = 2 * o_.split >= o_.size() ? 0 : 1;
    const auto site = [&](const Segment& s) {
      return o_.operand_of(s.edge) == longer ? s.edge : s.vertex;
    };
    BinScratch& memory = scratch_.bin;
    share_by_key(
        o_.size(), 1, [&](std::size_t) { return segments; },
        [&](std::size_t, const Segment& s) { return std::pair(site(s), s); }, cancellation_,
        memory.begin, memory.ordered);
    return memory.ordered;
  }

  /// Keeps the segments that touch an uncovered cell, and lists these cells if they are wanted.
  void keep_visible() {
    const UncoveredRows& uncovered = scratch_.visible.uncovered;
    constexpr std::uint64_t kUnitsOfSegment = 32;  // it passes some cells, in 300 ns
    const std::size_t tasks = tasks_for(kUnitsOfSegment * kept_.size(), cancellation_);
    auto& parts = scratch_.parts;
    parts.resize(tasks);
    share(tasks, cancellation_, [&](std::size_t task, std::size_t, Cancellation& own) {
      const std::size_t begin = begin_of(task, tasks, kept_.size());
      const std::size_t end = begin_of(task + 1, tasks, kept_.size());
      CellPart& part = parts[task];
      part.items.clear();
      KeptId count = 0;
      for (std::size_t i = begin; i < end; ++i) {
        const bool visible = scratch_.by_cells
                                 ? list_cells(uncovered, kept_[i], count, own, part.items)
                                 : is_visible(uncovered, kept_[i], own);
        if (visible) kept_[begin + count++] = kept_[i];
      }
      part.kept = count;
    });
    close_gaps();
  }
  /// Moves the segments of each part that stay to the end of those of the part before.
  void close_gaps() {
    auto& parts = scratch_.parts;
    KeptId count = 0;
    for (std::size_t task = 0; task < parts.size(); ++task) {
      parts[task].before = count;
      const std::size_t begin = begin_of(task, parts.size(), kept_.size());
      if (begin != count) {
        in_pieces(parts[task].kept, cancellation_, [&](std::size_t first, std::size_t last) {
          std::copy(kept_.data() + begin + first, kept_.data() + begin + last,
                    kept_.data() + count + first);
        });
      }
      count += parts[task].kept;
    }
    kept_.resize(count);
  }
  /// Whether a segment passes so many rows that leaving out some of them pays.
  [[nodiscard]] bool is_tall(const KeptSegment& s) const {
    constexpr double kTall = 8;  // of fewer, too few are left out
    const auto [a, b] = s.clipped();
    return std::abs(b.y - a.y) * grid_.inverse.y > kTall;
  }

  void clip(std::span<const Segment> segments) {
    const SegmentClipper clipper(o_);
    resize_in_pieces(scratch_.bin.clips, segments.size(), cancellation_);
    share_each(
        segments.size(), SegmentClipper::kUnits, cancellation_,
        [&](std::size_t i, Cancellation&) { scratch_.bin.clips[i] = clipper.clip(segments[i]); });
  }
  /// Places what clipping has left of segments.
  void place(std::span<const Segment> segments) {
    in_pieces(segments.size(), cancellation_, [&](std::size_t begin, std::size_t end) {
      make_room(kept_, end - begin, cancellation_);
      for (std::size_t i = begin; i < end; ++i) {
        const Clip clip = cover_.clips ? scratch_.bin.clips[i] : Clip{};
        if (!clip.is_empty()) kept_.push_back(place_segment(o_, segments[i], clip));
      }
    });
  }

  void append_members() {
    auto& join = scratch_.join;
    if (kept_.size() + join.members.size() > kMostNumbered) {
      throw Error(ErrorCode::kLimitExceeded, "more than 2^30 segments are left to arrange");
    }
    if (join.joined.empty()) return;
    for (KeptId s = 0; s < scratch_.line_count; ++s) {
      cancellation_.check();
      if (kept_[s].joined == 0) continue;
      JoinedSegments& joined = join.joined[kept_[s].joined - 1];
      const auto first = static_cast<KeptId>(kept_.size());
      make_room(kept_, joined.end - joined.first, cancellation_);
      kept_.insert(kept_.end(), join.members.begin() + joined.first,
                   join.members.begin() + joined.end);
      joined.first = first;
      joined.end = static_cast<KeptId>(kept_.size());
    }
  }

  /// Returns whether a segment is near an uncovered cell. Notes whether it may be near a covered
  /// one.
  bool is_visible(const UncoveredRows& uncovered, KeptSegment& s,
                  Cancellation& cancellation) const {
    if (is_tall(s)) {
      cancellation.check(8);
      s.meets_cover = true;
      return !is_hidden(cover_, uncovered, s.clipped());
    }
    const CellsNear near = cells_near(cover_, s.clipped(), Until::kBoth);
    s.meets_cover = near.covered;
    cancellation.check(1 + std::uint64_t{near.rows});
    return near.uncovered;
  }
  /// Appends an item for each uncovered cell near a segment. Returns whether there is one.
  bool list_cells(const UncoveredRows& uncovered, KeptSegment& s, KeptId id,
                  Cancellation& cancellation, std::vector<CellItem>& items) const {
    const std::size_t before = items.size();
    std::uint64_t rows = 0;
    const CellLine line(s, grid_);
    const auto visit = [&](const UniformGrid::RowSpan& span) {
      std::uint64_t any_covered = 0;
      cover_.covered.visit_words(
          span.row, span.left, span.right,
          [&](std::int32_t word, std::uint64_t covered, std::uint64_t wanted) {
            any_covered |= covered & wanted;
            for (std::uint64_t bits = wanted & ~covered; bits != 0; bits &= bits - 1) {
              append(items, item(id, line, span, 64 * word + std::countr_zero(bits)), cancellation);
            }
          });
      ++rows;
      s.meets_cover = s.meets_cover || any_covered != 0;
      return true;
    };
    const auto is_covered = [&](const UniformGrid::RowSpan& span, std::int32_t last_row) {
      const bool covered = uncovered.none_in(span.left, span.row, span.right, last_row);
      s.meets_cover = s.meets_cover || covered;
      return covered;
    };
    const auto [a, b] = s.clipped();
    if (is_tall(s)) {
      grid_.walk_rows_but(a, b, UniformGrid::kMargin, visit, is_covered);
    } else {
      grid_.walk_rows(a, b, UniformGrid::kMargin, visit);
    }
    // At once: a grid has kMaxSide columns and rows at the most, so a segment is done in time.
    cancellation.check(1 + rows + (items.size() - before));
    return items.size() > before;
  }
  [[nodiscard]] CellItem item(KeptId id, const CellLine& line, const UniformGrid::RowSpan& span,
                              std::int32_t i) const {
    constexpr double kMargin = UniformGrid::kMargin;
    const double x0 = std::max(span.x0, i - kMargin);
    const double x1 = std::min(span.x1, i + 1 + kMargin);
    double y0 = span.y0;
    double y1 = span.y1;
    if (line.rise != 0) {
      const double at_x0 = line.height_at(x0);
      const double at_x1 = line.height_at(x1);
      y0 = std::max(y0, std::min(at_x0, at_x1));
      y1 = std::min(y1, std::max(at_x0, at_x1));
    }
    const auto cell =
        static_cast<std::uint32_t>(span.row) * static_cast<std::uint32_t>(grid_.columns) +
        static_cast<std::uint32_t>(i);
    return {CellBox(x0 - i, y0 - span.row, x1 - i, y1 - span.row), cell, id};
  }

  /// Sorts items by cell, unless cells are too crowded. This counting sort only visits cells that
  /// have items. Each slice lists the cells of its items, in the order in which it comes to them.
  void sort_by_cells() {
    std::size_t count = 0;
    for (const CellPart& part : scratch_.parts) count += part.items.size();
    if (count > std::numeric_limits<std::uint32_t>::max()) {
      throw Error(ErrorCode::kLimitExceeded, "segments pass 2^32 cells of a grid or more");
    }
    const std::size_t slices = start_slices(count);
    const auto end_of = [&](std::size_t slice) -> auto& {
      return slice + 1 == slices ? scratch_.cell_end : scratch_.slices[slice].end;
    };
    const auto cells_of = [&](std::size_t slice) -> auto& {
      return slice == 0 ? scratch_.cells : scratch_.slices[slice].cells;
    };
    const auto visit_slice = [&](std::size_t slice, Cancellation& own, auto visit) {
      const auto& parts = scratch_.parts;
      visit_range(
          parts.size(), [&](std::size_t i) -> const auto& { return parts[i].items; },
          begin_of(slice, slices, count), begin_of(slice + 1, slices, count), own, visit);
    };
    share(slices, cancellation_, [&](std::size_t slice, std::size_t, Cancellation& own) {
      auto& end = end_of(slice);
      auto& cells = cells_of(slice);
      visit_slice(slice, own, [&](std::size_t, const CellItem& item) {
        if (end[item.cell] == 0) cells.push_back(item.cell);
        ++end[item.cell];
      });
    });
    for (std::size_t slice = 1; slice < slices; ++slice) {
      for (const std::uint32_t cell : cells_of(slice)) {
        bool is_new = true;
        for (std::size_t before = 0; before < slice; ++before) is_new &= end_of(before)[cell] == 0;
        if (is_new) scratch_.cells.push_back(cell);
      }
    }
    scratch_.by_cells = !are_crowded(count, scratch_.cells.size());
    if (!scratch_.by_cells) return;
    std::uint32_t begin = 0;
    for (const std::uint32_t cell : scratch_.cells) {
      for (std::size_t slice = 0; slice < slices; ++slice) {
        begin += std::exchange(end_of(slice)[cell], begin);
      }
    }
    resize_in_pieces(scratch_.in_cells, count, cancellation_);
    share(slices, cancellation_, [&](std::size_t slice, std::size_t, Cancellation& own) {
      auto& end = end_of(slice);
      visit_slice(slice, own, [&](std::size_t part, const CellItem& item) {
        CellItem& sorted = scratch_.in_cells[end[item.cell]++];
        sorted = item;
        sorted.segment += scratch_.parts[part].before;
      });
    });
  }

  /// Returns into how many slices to divide so many items. Sets all counts of all slices to zero.
  std::size_t start_slices(std::size_t items) {
    const auto cell_count = static_cast<std::size_t>(grid_.size());
    const std::size_t slices = slices_for<CellItem>(items, cell_count, cancellation_);
    scratch_.slices.resize(std::max(scratch_.slices.size(), slices));
    const auto clear = [&](const std::vector<std::uint32_t>& cells,
                           std::vector<std::uint32_t>& end) {
      for (const std::uint32_t cell : cells) {
        if (cell < end.size()) end[cell] = 0;
      }
    };
    // A sum that was cancelled may have left counts of cells that only the slices have listed.
    const auto start = [&](std::vector<std::uint32_t>& end, bool wanted) {
      clear(scratch_.cells, end);
      for (const CellSlice& slice : scratch_.slices) clear(slice.cells, end);
      if (wanted && end.size() < cell_count) resize_in_pieces(end, cell_count, cancellation_);
    };
    start(scratch_.cell_end, true);
    for (std::size_t slice = 0; slice < scratch_.slices.size(); ++slice) {
      start(scratch_.slices[slice].end, slice + 1 < slices);
    }
    for (CellSlice& slice : scratch_.slices) slice.cells.clear();
    scratch_.cells.clear();
    return slices;
  }

  /// Whether segments would meet one another again and again, because they run side by side through
  /// the same cells. An item shares its cell with `items` / `cells` items on average. For each
  /// segment, 12 of 998 sums have more than kMostShared such pairs. In cells these sums take 1.15
  /// to 2.96 times as long. 12 others have 128 to 256, and take 0.84 to 1.57 times as long.
  [[nodiscard]] bool are_crowded(std::size_t items, std::size_t cells) const {
    constexpr double kMostShared = 256;
    const auto many = static_cast<double>(items);
    return many * many > kMostShared * static_cast<double>(cells) * scratch_.line_count;
  }

  Cancellation& cancellation_;
  const Operands& o_;
  const Cover& cover_;
  bool covers_any_;
  UniformGrid& grid_;
  ArrangementScratch& scratch_;
  std::vector<KeptSegment>& kept_;
};

}  // namespace

void bin_segments(const Operands& operands, const Convolution& convolution, const Cover& cover,
                  const Limits& limits, Cancellation& cancellation, ArrangementScratch& scratch,
                  Arrangement& arrangement) {
  Binner(operands, cover, scratch, cancellation, arrangement).run(convolution, limits);
}

}  // namespace minksum
