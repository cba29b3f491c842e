// Finds covered cells by winding number, on a tree of cells.
#include <algorithm>
#include <limits>
#include <span>

#include "sum/cover/cover.hpp"

namespace minksum {
namespace {

/// The root's side in units.
constexpr std::int64_t kUnits = std::int64_t{1} << 24;
/// Cells with no more segments than this are left to the arrangement.
constexpr std::int32_t kFewSegments = 8;
/// Dividing ends after this many divisions in turn of which each left more than three quarters of
/// the segments near two quarters or more.
constexpr int kMostFutile = 4;

class Divider {
 public:
  Divider(const Operands& o, Cancellation& cancellation, CoverScratch& scratch, Cover& cover)
      : o_(o),
        cancellation_(cancellation),
        reflex_(scratch.reflex.segments),
        vectors_(scratch.vectors),
        stack_(scratch.stack),
        known_(scratch.known),
        cover_(cover) {}

  void run(std::span<const Segment> reduced, std::int32_t side) {
    take_known();
    lay_grid(side);
    cover_.active = true;
    cover_.divided = true;
    cover_.leaves.clear();
    cover_.leaf_segments.clear();
    stack_.grow(reduced.size() + reflex_.size() + SegmentStack::kStride, cancellation_);
    load(reduced, 0);
    load(reflex_, reduced.size());
    const std::size_t end = stack_.fill_up(reduced.size() + reflex_.size());
    const QuadCell root{kUnits / 2, kUnits / 2, kUnits / 2};
    std::int32_t winding = 0;
    in_pieces(end, cancellation_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        winding += winding_step_along_ray(root, i, stack_);
      }
    });
    if (side == 1) {
      std::fill(stack_.mask.begin(), stack_.mask.begin() + static_cast<std::ptrdiff_t>(end), 1);
      return add_leaf({0, 0, 1, 0}, 0, end, 1);
    }
    divide({root, 0, end, winding, 0}, side);
  }

 private:
  struct Cell {
    QuadCell square;
    std::size_t begin;  ///< the cell's list is [begin, end)
    std::size_t end;
    std::int32_t winding;  ///< winding number of the rounded chains at the centre
    int futile;
  };

  /// Remembers the cells that are covered already, because these stay covered.
  void take_known() {
    knows_ = cover_.active;
    if (!knows_) return;
    known_grid_ = cover_.grid;
    std::swap(known_, cover_.covered);
  }
  /// Whether the cells that were covered before contain a square with its margin.
  [[nodiscard]] bool is_known(std::int32_t column, std::int32_t row, std::int32_t side) const {
    constexpr std::int32_t kMostRows = 32;  // larger squares are divided first
    constexpr double kMargin = 4 * UniformGrid::kMargin;
    if (!knows_) return false;
    const double cell = cover_.grid.cell;
    const std::int32_t first = known_grid_.column((column - kMargin) * cell);
    const std::int32_t last = known_grid_.column((column + side + kMargin) * cell);
    const std::int32_t low = known_grid_.row((row - kMargin) * cell);
    const std::int32_t high = known_grid_.row((row + side + kMargin) * cell);
    if (high - low >= kMostRows) return false;
    for (std::int32_t j = low; j <= high; ++j) {
      for (std::int32_t i = first; i <= last; i = (i | 63) + 1) {
        const std::int32_t end = std::min(last, i | 63);
        const std::uint64_t wanted = ~std::uint64_t{0} >> (63 - (end - i)) << (i & 63);
        if ((~known_.row(j)[i >> 6] & wanted) != 0) return false;
      }
    }
    return true;
  }

  void lay_grid(int side) {
    const Vec<double> extent = o_.sum_extent();
    const double longer = std::max(extent.x, extent.y) * (1 + 0x1p-20);
    UniformGrid& grid = cover_.grid;
    grid.cell = longer / side;
    grid.inverse = 1 / grid.cell;
    grid.columns = static_cast<std::int32_t>(extent.x * grid.inverse) + 1;
    grid.rows = static_cast<std::int32_t>(extent.y * grid.inverse) + 1;
    cover_.covered.reset(grid.columns, grid.rows);
    scale_ = grid.inverse * static_cast<double>(kUnits / side);
    units_per_cell_ = kUnits / side;
    margin_ = static_cast<std::int64_t>(static_cast<double>(units_per_cell_) * 4 *
                                        UniformGrid::kMargin);
  }
  [[nodiscard]] float rounded(double x) const {
    return static_cast<float>(static_cast<std::int32_t>(x * scale_ + 0.5));
  }
  /// Puts segments on the stack from `first` on. The reduced convolution must start at 0; other
  /// segments are traversed backwards.
  void load(std::span<const Segment> segments, std::size_t first) {
    std::size_t i = first;
    visit_in_pieces(segments, cancellation_, [&](const Segment& s) {
      const auto& [x, y, dx, dy, next] = o_.sites;
      const auto [e, v] = s;
      const SiteId f = next[e];
      const float ax = rounded(x[e] + x[v]);
      const float ay = rounded(y[e] + y[v]);
      const float bx = rounded(x[f] + x[v]);
      const float by = rounded(y[f] + y[v]);
      if (first == 0) {
        stack_.segment[i] = {ax, ay, bx - ax, by - ay};
      } else {
        stack_.segment[i] = {bx, by, ax - bx, ay - by};
      }
      stack_.id[i] = first == 0 ? static_cast<std::int32_t>(i) : -1;
      ++i;
    });
  }

  /// Divides a cell that is `side` cells of the grid wide.
  void divide(const Cell& cell, std::int32_t side) {
    cancellation_.check(8);
    const std::array<Tally, 4> tallies =
        classify(cell.square, margin_, cell.begin, cell.end, vectors_, cancellation_, stack_);
    const auto many = static_cast<std::int32_t>((cell.end - cell.begin) * 3 / 4);
    int crowded = 0;
    for (const Tally& tally : tallies) crowded += tally.near > many ? 1 : 0;
    const int futile = crowded >= 2 ? cell.futile + 1 : 0;
    const std::int64_t half = cell.square.half / 2;
    for (std::size_t k = 0; k < 4; ++k) {
      const QuadCell square{cell.square.x + ((k & 1) != 0 ? half : -half),
                            cell.square.y + ((k & 2) != 0 ? half : -half), half};
      const auto column = static_cast<std::int32_t>((square.x - half) / units_per_cell_);
      const auto row = static_cast<std::int32_t>((square.y - half) / units_per_cell_);
      if (column >= cover_.grid.columns || row >= cover_.grid.rows) continue;
      const Tally& tally = tallies[k];
      const std::int32_t winding = cell.winding + tally.winding;
      const QuadtreeLeaf leaf{column, row, side / 2, 0};
      if (winding > tally.losing + tally.doubtful || is_known(column, row, side / 2)) {
        mark(column, row, side / 2);
      } else if (tally.reduced == 0) {
        continue;
      } else if (side == 2 || tally.near <= kFewSegments || futile == kMostFutile) {
        add_leaf(leaf, cell.begin, cell.end, 1 << k);
      } else {
        const std::size_t end = copy(cell, 1 << k, static_cast<std::size_t>(tally.near));
        divide({square, cell.end, end, winding, futile}, side / 2);
      }
    }
  }

  /// Copies the entries whose masks have `bit` behind the cell's list. Returns where they end.
  std::size_t copy(const Cell& cell, std::int32_t bit, std::size_t count) {
    stack_.grow(cell.end + count + SegmentStack::kStride, cancellation_);
    std::size_t to = cell.end;
    in_pieces(cell.end - cell.begin, cancellation_, [&](std::size_t begin, std::size_t end) {
      to = stack_.copy(cell.begin + begin, cell.begin + end, bit, to);
    });
    return stack_.fill_up(to);
  }

  void add_leaf(QuadtreeLeaf leaf, std::size_t begin, std::size_t end, std::int32_t bit) {
    make_room(cover_.leaf_segments, end - begin, cancellation_);
    in_pieces(end - begin, cancellation_, [&](std::size_t from, std::size_t to) {
      for (std::size_t i = begin + from; i < begin + to; ++i) {
        if ((stack_.mask[i] & bit) != 0 && stack_.id[i] >= 0) {
          cover_.leaf_segments.push_back(static_cast<std::uint32_t>(stack_.id[i]));
        }
      }
    });
    if (cover_.leaf_segments.size() > std::numeric_limits<std::uint32_t>::max()) {
      throw Error(ErrorCode::kLimitExceeded, "segments pass 2^32 cells of a cover or more");
    }
    leaf.end = static_cast<std::uint32_t>(cover_.leaf_segments.size());
    cover_.leaves.push_back(leaf);
  }

  void mark(std::int32_t column, std::int32_t row, std::int32_t side) {
    const std::int32_t top = std::min(row + side, cover_.grid.rows);
    // Squares are aligned, so each row of a square lies in one word or fills whole words.
    const std::uint64_t bits = side < 64 ? ((std::uint64_t{1} << side) - 1) << (column & 63)
                                         : ~std::uint64_t{0};
    for (std::int32_t j = row; j < top; ++j) {
      std::uint64_t* words = cover_.covered.row(j);
      const auto last = static_cast<std::size_t>((column + side - 1) >> 6);
      for (auto w = static_cast<std::size_t>(column >> 6);
           w <= last && w < cover_.covered.words_per_row(); ++w) {
        words[w] |= bits;
      }
    }
  }

  const Operands& o_;
  Cancellation& cancellation_;
  std::span<const Segment> reflex_;
  Vectors vectors_;
  SegmentStack& stack_;
  Bitmap& known_;           ///< cells that were covered before the division
  UniformGrid known_grid_;  ///< the grid of `known_`
  bool knows_ = false;
  Cover& cover_;
  double scale_ = 1;
  std::int64_t units_per_cell_ = 1;
  std::int64_t margin_ = 0;  ///< four times the grid's
};

}  // namespace

void divide_by_winding(const Operands& operands, const Convolution& convolution,
                       const Limits& limits, std::int32_t side, Cancellation& cancellation,
                       CoverScratch& scratch, Cover& cover) {
  reflex_convolution(operands, limits, cancellation, scratch.convolution, scratch.reflex);
  Divider(operands, cancellation, scratch, cover).run(convolution.segments, side);
}

}  // namespace minksum
