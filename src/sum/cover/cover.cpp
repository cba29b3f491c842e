#include "sum/cover/cover.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

namespace minksum {
namespace {

/// Below this many segments a cover costs more than it saves.
constexpr std::size_t kSegmentsWorthACover = 850;
constexpr std::size_t kSegmentsWorthDividing = 100;
constexpr int kMaxSide = 4096;
static_assert(kMaxSide + 1 <= UniformGrid::kMaxSide);

/// Chooses the cells along the longer side of the first grid. `buy_grids` doubles them, and
/// `choose_division` chooses those of a divided grid. Moving bitmaps of s cells a side costs in
/// proportion to s^3. The share of segments that stay visible is in proportion to 1 / s. The total
/// cost is least where s^4 is in proportion to all segments.
int choose_side(std::uint64_t segments, const SumSettings& options) {
  if (options.grid > 0) return std::min(options.grid, kMaxSide);
  const double side = 12 * std::sqrt(std::sqrt(static_cast<double>(segments)));
  return std::min(static_cast<int>(side), kMaxSide);
}

UniformGrid grid_of(const Operands& operands, int side) {
  const Vec<double> extent = operands.sum_extent();
  return UniformGrid::over(extent.x, extent.y, side);
}

Vec<double> at(const Operands& o, SiteId v) { return {o.sites.x[v], o.sites.y[v]}; }

/// A few of the segments; each stands for `step` of them.
struct Sample {
  std::span<const Segment> segments;
  std::uint64_t step;
};
Sample take_sample(const Convolution& convolution, CoverScratch& scratch) {
  if (!convolution.listed()) return {convolution.segments, convolution.step};
  const std::uint64_t step = convolution.size / kSample + 1;
  auto& sample = scratch.sample;
  sample.clear();
  for (std::uint64_t i = 0; i < convolution.size; i += step) {
    sample.push_back(convolution.segments[i]);
  }
  return {sample, step};
}

Visibility look(const Operands& o, const Sample& sample, const Cover& cover) {
  std::size_t visible = 0;
  std::size_t cells = 0;
  for (const auto& [e, v] : sample.segments) {
    const Vec<double> a = at(o, e);
    const Vec<double> b = at(o, o.sites.next[e]);
    const Vec<double> q = at(o, v);
    const std::size_t before = cells;
    cover.grid.walk({a.x + q.x, a.y + q.y}, {b.x + q.x, b.y + q.y}, UniformGrid::kMargin,
                    [&](std::int32_t column, std::int32_t row) {
                      cells += cover.is_covered(column, row) ? 0U : 1U;
                      return true;
                    });
    visible += cells > before ? 1U : 0U;
  }
  const double uncovered = static_cast<double>(static_cast<std::uint64_t>(cover.grid.size()) -
                                               cover.covered_count());
  const double crowding = static_cast<double>(cells * sample.step) / std::max(uncovered, 1.0);
  // About two of five pairs of lines through a cell cross in it.
  return {static_cast<double>(visible) / static_cast<double>(sample.segments.size()), crowding,
          0.2 * crowding * crowding * uncovered};
}

/// Returns 32 bits, each twice.
std::uint64_t doubled(std::uint64_t bits) {
  bits = (bits | bits << 16) & 0x0000FFFF0000FFFF;
  bits = (bits | bits << 8) & 0x00FF00FF00FF00FF;
  bits = (bits | bits << 4) & 0x0F0F0F0F0F0F0F0F;
  bits = (bits | bits << 2) & 0x3333333333333333;
  bits = (bits | bits << 1) & 0x5555555555555555;
  return bits | bits << 1;
}
/// Marks the four cells of each covered cell of the grid with half as many cells along a side.
void inherit(const Bitmap& coarse, Bitmap& fine) {
  for (std::int32_t j = 0; j < std::min(2 * coarse.rows(), fine.rows()); ++j) {
    const std::uint64_t* const from = coarse.row(j / 2);
    std::uint64_t* const to = fine.row(j);
    const std::size_t words = std::min(2 * coarse.words_per_row(), fine.words_per_row());
    for (std::size_t w = 0; w < words; ++w) to[w] = doubled(from[w / 2] >> (w % 2 * 32) & ~0U);
  }
}

/// Buys grids, from one of `side` cells along the longer side to one of `finest`, and marks the
/// cells that translates cover. Returns what is left.
///
/// Narrow shapes have no cells inside until cells are small, so finer grids are bought as long as
/// they are cheap beside what is left to the arrangement. A grid's price is known before it is
/// paid, once both operands are rasterised. Prices grow about eight times from grid to grid, so all
/// grids together cost little more than the last one. Where many thin translates cover the sum,
/// segments crowd on every grid. There parallelograms are bought, until they do not help. What is
/// covered stays covered on the next grid.
///
/// Prices are in words moved; moving a word takes about 0.3 ns. A visible segment takes some 150 ns
/// to arrange, and a crossing 250 ns. Both take some four times as long where sums are not exact in
/// doubles. A cell takes about 1.2 ns to rasterise and list, and 32 ns to look for parallelograms.
/// The next grid leaves half as many segments at best, so it may cost half of that saving.
Visibility buy_grids(const Operands& operands, std::uint64_t segments, const Sample& sample,
                     int side, int finest, Cancellation& cancellation, CoverScratch& scratch,
                     Cover& cover) {
  constexpr double kSegment = 500;
  constexpr double kCrossing = 800;
  constexpr double kCellOfParallelograms = 100;
  constexpr double kCell = 4;
  constexpr double kMostOfWhatIsLeft = 0.25;
  constexpr double kWorthIt = 0.8;
  const double inexact = operands.bounds.difference == 0 ? 1 : 4;
  const auto price_of = [&](const Visibility& left) {
    return inexact *
           (kSegment * left.share * static_cast<double>(segments) + kCrossing * left.crossings);
  };
  Visibility now{1, 0, 0};
  double affordable = HUGE_VAL;
  double least_price = 0;  // rasters have four times as many words, and are moved no less often
  bool parallelograms_help = true;
  for (bool first = true;; side *= 2, first = false) {
    const UniformGrid grid = grid_of(operands, side);
    const auto cells = static_cast<double>(grid.size());
    if (kCell * cells + least_price > affordable) return now;
    const auto words = static_cast<double>(rasterise(operands, grid, cancellation, scratch));
    if (kCell * cells + words > affordable) return now;
    least_price = 4 * words;
    cover.grid = grid;
    std::swap(cover.covered, scratch.known);
    cover.covered.reset(grid.columns, grid.rows, words_per_row(grid.columns));
    if (!first) inherit(scratch.known, cover.covered);
    spread_rasters(cancellation, scratch, cover);
    const double share = now.share;
    now = look(operands, sample, cover);
    if (parallelograms_help &&
        kCellOfParallelograms * cells <= kMostOfWhatIsLeft * price_of({0, 0, now.crossings})) {
      const double before = price_of(now);
      cover_by_parallelograms(operands, cancellation, scratch, cover);
      cover.by_translates = false;
      now = look(operands, sample, cover);
      parallelograms_help = price_of(now) <= kWorthIt * before;
    }
    affordable = kMostOfWhatIsLeft * price_of(now);
    // A grid that hides hardly more than the one before is the last. But a cover that hides nothing
    // yet may hide much on the next grid.
    const bool enough = now.share > kWorthIt * share && share < 0.9;
    if (enough || 2 * side > finest) return now;
  }
}

/// Chooses the cells along a side of the finest level, a power of two. Few cells are divided down
/// to that level.
std::int32_t choose_division(std::uint64_t segments, const SumSettings& options) {
  constexpr std::uint32_t kMostCells = 4096;
  const auto k = static_cast<double>(segments);
  const double wanted = options.grid > 0 ? options.grid : std::min(6.0 * std::sqrt(k), k / 8);
  return static_cast<std::int32_t>(
      std::min(std::bit_ceil(static_cast<std::uint32_t>(wanted)), kMostCells));
}

/// Estimates the number of crossings from the segments' extents in x and y. The estimate would be
/// the exact expectation if half of the segments were horizontal, half vertical, and all anywhere
/// in the box.
double expected_crossings(const Operands& o, std::span<const Segment> segments) {
  double across = 0;
  double up = 0;
  for (const Segment& segment : segments) {
    across += std::abs(o.sites.dx[segment.edge]);
    up += std::abs(o.sites.dy[segment.edge]);
  }
  const double area = o.sum_extent().x * o.sum_extent().y;
  return area > 0 ? across * up / area : 0;
}

/// Whether a cover has nothing to save, because edges have a segment or two each, which hardly meet
/// others. One operand is then small beside the other's features. `list()` lists the segments.
template <class List>
bool is_sparse(const Operands& operands, std::uint64_t size, List list) {
  constexpr double kFewCrossings = 0.1;
  return size <= std::uint64_t{4} * operands.size() &&
         expected_crossings(operands, list()) <= kFewCrossings * static_cast<double>(size);
}

}  // namespace

void cover_interior(const Operands& operands, const SumSettings& options,
                    Cancellation& cancellation, CoverScratch& scratch, Convolution& convolution,
                    Cover& cover) {
  const std::uint64_t size = convolution.size;
  const auto list = [&]() -> std::span<const Segment> {
    if (!convolution.listed()) {
      reduced_convolution(operands, options.limits, cancellation, scratch.convolution, convolution);
    }
    return convolution.segments;
  };
  const bool free_side = options.grid == 0;
  // The full convolution serves comparisons, so its whole arrangement is built. Translates of thin
  // operands have no cells inside, and the segments of two thin operands make no closed chains.
  const bool wanted = options.cover && options.method != Method::kFull &&
                      !operands.both_convex && !operands.both_thin() && size != 0;
  cover.divided = false;
  cover.by_translates = true;
  cover.active = wanted && (!free_side || (size >= kSegmentsWorthACover &&
                                           !is_sparse(operands, size, list)));
  if (!cover.active) cover.grid = grid_of(operands, 1);
  // A division costs about as much per segment as a few crossings. It cannot handle holes.
  const double crossings_to_divide = 3.5 * static_cast<double>(size);
  const bool divisible = !has_holes(operands.rings);
  bool crowded = false;
  if (cover.active) {
    const Sample sample = take_sample(convolution, scratch);
    const int side = choose_side(size, options);
    const int finest = free_side ? kMaxSide : side;
    const Visibility seen =
        buy_grids(operands, size, sample, side, finest, cancellation, scratch, cover);
    crowded = divisible && seen.crossings > crossings_to_divide;
  }
  cancellation.check(convolution.segments.size());
  if (cover.covered_count() == 0 || crowded) list();
  if (wanted && free_side && cover.covered_count() == 0) {
    crowded = divisible && size >= kSegmentsWorthDividing &&
              expected_crossings(operands, convolution.segments) > crossings_to_divide;
    // A fine grid without covered cells is of no use.
    cover.active = false;
    if (!crowded) cover.grid = grid_of(operands, 1);
  }
  if (!crowded) return;
  cover.by_translates = false;
  divide_by_winding(operands, convolution, options.limits, choose_division(size, options),
                    cancellation, scratch, cover);
}

Visibility look_at_sample(const Operands& operands, const Convolution& convolution,
                          const Cover& cover, CoverScratch& scratch) {
  return look(operands, take_sample(convolution, scratch), cover);
}

std::uint64_t Cover::covered_count() const {
  std::uint64_t count = 0;
  if (active) {
    for (const std::uint64_t word : covered.words()) {
      count += static_cast<std::uint64_t>(std::popcount(word));
    }
  }
  return count;
}

namespace {

std::optional<std::string> check_leaves(const Cover& cover) {
  std::uint32_t end = 0;
  for (const QuadtreeLeaf& leaf : cover.leaves) {
    if (leaf.column < 0 || leaf.row < 0 || leaf.column >= cover.grid.columns ||
        leaf.row >= cover.grid.rows || cover.is_covered(leaf.column, leaf.row)) {
      return "a leaf is where none can be";
    }
    if (leaf.end < end) return "the leaves' lists overlap";
    end = leaf.end;
  }
  if (end != cover.leaf_segments.size()) return "the leaves do not use up their lists";
  return std::nullopt;
}

}  // namespace

std::optional<std::string> check(const Cover& cover, const Operands& operands) {
  const UniformGrid& grid = cover.grid;
  const Vec<double> extent = operands.sum_extent();
  if (grid.columns * grid.cell < extent.x || grid.rows * grid.cell < extent.y) {
    return "the grid does not span the sum's box";
  }
  if (!cover.active) return std::nullopt;
  if (cover.divided) {
    if (const auto fault = check_leaves(cover)) return fault;
  }
  if (cover.covered.columns() != grid.columns || cover.covered.rows() != grid.rows) {
    return "the cover is not of the grid's size";
  }
  const std::int32_t right = grid.column(extent.x);
  const std::int32_t top = grid.row(extent.y);
  for (std::int32_t j = 0; j < grid.rows; ++j) {
    for (std::int32_t i = 0; i < grid.columns; ++i) {
      const bool at_border = i == 0 || j == 0 || i >= right || j >= top;
      if (at_border && cover.is_covered(i, j)) return "a cell at the border of the sum is covered";
    }
  }
  return std::nullopt;
}

}  // namespace minksum
