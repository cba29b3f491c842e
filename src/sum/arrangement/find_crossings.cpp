// Finds all points that kept segments share, cell by cell.
#include <algorithm>
#include <cmath>
#include <utility>

#include "sum/arrangement/meet_segments.hpp"

namespace minksum {
namespace {

class CrossingFinder {
 public:
  CrossingFinder(const Cover& cover, const SumSettings& options, Predicates& predicates,
                 ArrangementScratch& scratch, Arrangement& arrangement)
      : cover_(cover),
        grid_(scratch.grid),
        cancellation_(predicates.cancellation()),
        scratch_(scratch),
        kept_(arrangement.kept),
        meeter_(scratch.grid, options, predicates, scratch, arrangement.kept) {}

  void run() {
    scratch_.crossings.clear();
    scratch_.events.clear();
    start_forest(scratch_.parent, 2 * kept_.size());
    start_forest(scratch_.line_parent, kept_.size());
    scratch_.lines_shared = false;
    if (cover_.divided) {
      solve_leaves();
    } else if (scratch_.swept) {
      solve_all();
    } else {
      solve_cells();
    }
  }

 private:
  using Items = std::span<const CellItem>;
  static constexpr std::size_t kFew = 64;  // comparing all pairs costs less than dividing
  static constexpr int kMaxDepth = 7;      // deeper down, a part's side nears the slack

  /// Makes each element its own root.
  void start_forest(std::vector<std::uint32_t>& parent, std::size_t size) {
    resize_in_pieces(parent, size, cancellation_);
    std::uint32_t next = 0;
    visit_in_pieces(parent, cancellation_, [&](std::uint32_t& p) { p = next++; });
  }

  /// Meets all pairs of segments whose boxes overlap, without cells.
  void solve_all() {
    meeter_.enter({});
    const std::span lines(kept_.data(), scratch_.line_count);
    BoxPairs pairs(scratch_.extent.x, scratch_.extent.y, meeter_.doubt(), scratch_.pairs);
    visit_in_pieces(lines, cancellation_, [&](const KeptSegment& s) {
      pairs.add(std::min(s.a.x, s.b.x), std::min(s.a.y, s.b.y), std::max(s.a.x, s.b.x),
                std::max(s.a.y, s.b.y));
    });
    pairs.for_each([&](KeptId s, KeptId t) { meeter_.meet(std::min(s, t), std::max(s, t)); },
                   cancellation_);
  }
  void solve_cells() {
    std::uint32_t begin = 0;
    for (const std::uint32_t cell : scratch_.cells) {
      const std::uint32_t end = scratch_.cell_end[cell];
      const auto columns = static_cast<std::uint32_t>(grid_.columns);
      solve_square(std::exchange(begin, end), end, static_cast<std::int32_t>(cell % columns),
                   static_cast<std::int32_t>(cell / columns), 1);
    }
  }
  void solve_leaves() {
    std::uint32_t begin = 0;
    for (std::size_t i = 0; i < cover_.leaves.size(); ++i) {
      const QuadtreeLeaf& leaf = cover_.leaves[i];
      const std::uint32_t end = scratch_.leaf_end[i];
      solve_square(std::exchange(begin, end), end, leaf.column, leaf.row, leaf.side);
    }
  }
  void solve_square(std::uint32_t begin, std::uint32_t end, std::int32_t column, std::int32_t row,
                    std::int32_t side) {
    const Items items(scratch_.in_cells.data() + begin, end - begin);
    cancellation_.check();
    if (items.size() < 2) return;
    row_ = row;
    column_ = column;
    // Larger squares are leaves: dividing them further was found to be of no use.
    solve(items, part_of_square(side), side == 1 ? 0 : kMaxDepth);
  }

  /// Returns a square's part of the plane. Neighbouring squares have a bound in common, equal to
  /// the last bit, so that all parts tile the plane.
  [[nodiscard]] PlanePart part_of_square(std::int32_t side) const {
    const auto bound = [&](std::int32_t i, std::int32_t count) {
      return i == 0 ? -HUGE_VAL : i >= count ? HUGE_VAL : i * grid_.cell;
    };
    return {bound(column_, grid_.columns), bound(row_, grid_.rows),
            bound(column_ + side, grid_.columns), bound(row_ + side, grid_.rows)};
  }

  void solve(Items items, const PlanePart& part, int depth) {
    if (items.size() <= kFew) return all_pairs(items, part);
    if (depth == kMaxDepth || !divide(items, part, depth)) sweep(items, part);
  }

  void all_pairs(Items items, const PlanePart& part) {
    meeter_.enter(part);
    cancellation_.check(items.size() * items.size() / 4);
    for (std::size_t i = 1; i < items.size(); ++i) {
      const std::uint64_t partner = items[i].box.partner();
      for (std::size_t j = 0; j < i; ++j) {
        if (items[j].box.overlaps(partner)) meeter_.meet(items[j].segment, items[i].segment);
      }
    }
  }

  /// Meets all pairs whose boxes overlap, from left to right. Parts that dividing did not thin out
  /// are swept.
  void sweep(Items items, const PlanePart& part) {
    meeter_.enter(part);
    auto& order = scratch_.sweep_order;
    resize_in_pieces(order, items.size(), cancellation_);
    std::copy(items.begin(), items.end(), order.begin());
    std::sort(order.begin(), order.end(),
              cancellation_.counting([](const CellItem& a, const CellItem& b) {
                return a.box.left() < b.box.left();
              }));
    for (std::size_t i = 0; i < order.size(); ++i) {
      const CellItem& s = order[i];
      const std::uint32_t reach = s.box.right();
      const std::uint64_t partner = s.box.partner();
      std::size_t j = i + 1;
      for (; j < order.size() && order[j].box.left() <= reach; ++j) {
        if (order[j].box.overlaps(partner)) {
          const auto [first, second] = std::minmax(s.segment, order[j].segment);
          meeter_.meet(first, second);
        }
      }
      cancellation_.check(1 + (j - i) / 2);
    }
  }

  /// Solves the four quarters of a part. Does nothing and returns false if that would not separate
  /// much.
  bool divide(Items items, const PlanePart& part, int depth) {
    const double side = std::ldexp(grid_.cell, -depth - 1);
    const Vec<double> low{part.x0 > -HUGE_VAL ? part.x0 : column_ * grid_.cell,
                          part.y0 > -HUGE_VAL ? part.y0 : row_ * grid_.cell};
    const Vec<double> mid{low.x + side, low.y + side};
    const std::size_t level = static_cast<std::size_t>(depth) * 4;
    if (scratch_.stack.size() < level + 4) scratch_.stack.resize(level + 4);
    std::size_t total = 0;
    for (std::size_t quarter = 0; quarter < 4; ++quarter) {
      const bool right = (quarter & 1) != 0;
      const bool upper = (quarter & 2) != 0;
      const Vec<double> corner{right ? mid.x : low.x, upper ? mid.y : low.y};
      list_near(items, corner, side, scratch_.stack[level + quarter]);
      total += scratch_.stack[level + quarter].size();
    }
    // Crowds that no division separates are left to the sweep.
    if (total >= 3 * items.size()) return false;
    for (std::size_t quarter = 0; quarter < 4; ++quarter) {
      const bool right = (quarter & 1) != 0;
      const bool upper = (quarter & 2) != 0;
      const PlanePart child{right ? mid.x : part.x0, upper ? mid.y : part.y0,
                            right ? part.x1 : mid.x, upper ? part.y1 : mid.y};
      // The recursion may move the vector of vectors, not the lists themselves.
      const Items inside = scratch_.stack[level + quarter];
      if (inside.size() >= 2) solve(inside, child, depth + 1);
    }
    return true;
  }

  /// Lists the items that may touch a square, with their boxes' parts near the square.
  void list_near(Items items, const Vec<double>& low, double side, std::vector<CellItem>& near) {
    near.clear();
    const double slack = meeter_.slack();
    const Vec<double> centre{low.x + side / 2, low.y + side / 2};
    const auto cells = [&](double distance, double cell) {
      return distance * grid_.inverse - cell;
    };
    const CellBox square(cells(low.x - slack, column_), cells(low.y - slack, row_),
                         cells(low.x + side + slack, column_), cells(low.y + side + slack, row_));
    const std::uint64_t partner = square.partner();
    make_room(near, items.size(), cancellation_);
    visit_in_pieces(items, cancellation_, [&](const CellItem& item) {
      if (item.box.overlaps(partner) && near_box(kept_[item.segment], centre, side / 2 + slack)) {
        near.push_back({item.box.within(square), item.cell, item.segment});
      }
    });
  }

  /// Whether a segment's line may touch the box of this centre and half side. Errs on the side of
  /// yes.
  [[nodiscard]] static bool near_box(const KeptSegment& s, const Vec<double>& centre, double half) {
    const Vec<double> v{centre.x - s.a.x, centre.y - s.a.y};
    const double reach = (std::abs(s.d.x) + std::abs(s.d.y)) * half;
    return std::abs(cross(s.d, v)) <= reach * (1 + 0x1p-20);
  }

  const Cover& cover_;
  const UniformGrid& grid_;
  Cancellation& cancellation_;
  ArrangementScratch& scratch_;
  const std::vector<KeptSegment>& kept_;
  SegmentMeeter meeter_;
  std::int32_t column_ = 0;
  std::int32_t row_ = 0;
};

}  // namespace

void find_crossings(const Cover& cover, const SumSettings& options, Predicates& predicates,
                    ArrangementScratch& scratch, Arrangement& arrangement) {
  CrossingFinder(cover, options, predicates, scratch, arrangement).run();
  arrangement.crossings = scratch.crossings.size();
}

}  // namespace minksum
