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
constexpr int kMaxSide = 2048;
static_assert(kMaxSide + 1 <= UniformGrid::kMaxSide);

/// Chooses the cells along the longer side of a grid without a cover. The grid has about a third as
/// many cells as there are segments.
int choose_plain_side(std::uint64_t segments) {
  const double side = 0.6 * std::sqrt(static_cast<double>(segments));
  return std::clamp(static_cast<int>(side), 1, kMaxSide / 8);
}
/// Chooses the cells along the longer side of the first grid with a cover. `refine` doubles them,
/// and `choose_division` chooses those of a divided grid. Moving bitmaps of s
/// cells a side costs in proportion to s^3. The share of segments that stay visible is in
/// proportion to 1 / s. The total cost is least where s^4 is in proportion to all segments.
int choose_side(std::uint64_t segments, const SumSettings& options) {
  if (options.grid > 0) return std::min(options.grid, kMaxSide);
  const double side = 12 * std::sqrt(std::sqrt(static_cast<double>(segments)));
  return std::min(static_cast<int>(side), kMaxSide);
}

/// Lays a grid, and marks the cells that translates cover.
void cover_on_grid(const Operands& operands, int side, Cancellation& cancellation,
                   CoverScratch& scratch, Cover& cover) {
  const Vec<double> extent = operands.sum_extent();
  cover.grid = UniformGrid::over(extent.x, extent.y, side);
  if (!cover.active) return;
  // An operand's raster may have one column more than the sum's grid; rows must be equally long.
  cover.covered.reset(cover.grid.columns, cover.grid.rows,
                      (static_cast<std::size_t>(cover.grid.columns) + 1 + 63) / 64);
  cover_by_translates(operands, cancellation, scratch, cover);
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

/// Estimates the price of a cover with twice as many cells along a side as the last one, in words
/// moved. Rasters have four times as many words then, and are moved twice as often.
double price_of_finer(const CoverScratch& scratch) {
  constexpr double kWordsPerRasterised = 16;  // filling a word costs as much as moving so many
  return 8 * static_cast<double>(scratch.words_moved) +
         4 * kWordsPerRasterised * static_cast<double>(scratch.words_rasterised);
}

// Narrow shapes have no cells inside until cells are small. A finer grid costs little where many
// segments would otherwise stay, or crowd in few cells. Refining goes on while each grid leaves
// clearly less than the one before. A grid may cost more where it leaves many crossings and no
// division is to take them away.
Visibility refine(const Operands& operands, std::uint64_t segments, const Sample& sample,
                  double crossings_to_divide, Cancellation& cancellation, int& side,
                  CoverScratch& scratch, Cover& cover) {
  constexpr double kTooManyVisible = 0.25;
  constexpr double kFewVisible = 0.1;
  constexpr double kCrowded = 4;
  constexpr double kWorthIt = 0.8;
  constexpr double kMaxWordsPerSegment = 100;
  constexpr double kWordsPerCrossing = 500;
  Visibility now = look(operands, sample, cover);
  const auto may_cost = [&](double words) {
    if (words <= kMaxWordsPerSegment * static_cast<double>(segments)) return true;
    return now.crossings <= crossings_to_divide && words <= kWordsPerCrossing * now.crossings;
  };
  while ((now.share > kTooManyVisible || (now.share > kFewVisible && now.crowding > kCrowded)) &&
         side * 2 <= kMaxSide && may_cost(price_of_finer(scratch))) {
    side *= 2;
    cover_on_grid(operands, side, cancellation, scratch, cover);
    const Visibility finer = look(operands, sample, cover);
    // A cover that hides nothing yet may hide much on the next grid.
    const bool enough = finer.share > kWorthIt * now.share && now.share < 0.9;
    now = finer;
    if (enough) break;
  }
  return now;
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
  if (!cover.active) cover_on_grid(operands, choose_plain_side(size), cancellation, scratch, cover);
  // A division costs about as much per segment as a few crossings. It cannot handle holes.
  const double crossings_to_divide = 3.5 * static_cast<double>(size);
  const bool divisible = !has_holes(operands.rings);
  bool crowded = false;
  if (cover.active) {
    const Sample sample = take_sample(convolution, scratch);
    int side = choose_side(size, options);
    cover_on_grid(operands, side, cancellation, scratch, cover);
    const Visibility seen =
        free_side ? refine(operands, size, sample, divisible ? crossings_to_divide : HUGE_VAL,
                           cancellation, side, scratch, cover)
                  : look(operands, sample, cover);
    crowded = seen.crossings > crossings_to_divide;
    if (crowded) {
      // Narrow shapes leave many crossings. For them, a coarse grid tells whether parallelograms
      // suffice.
      constexpr double kFewLeft = 0.2;
      if (divisible && side != choose_side(size, options)) {
        side = choose_side(size, options);
        cover_on_grid(operands, side, cancellation, scratch, cover);
      }
      cover_by_parallelograms(operands, cancellation, scratch, cover);
      cover.by_translates = false;
      crowded = look(operands, sample, cover).crossings > kFewLeft * static_cast<double>(size);
    }
    crowded = crowded && divisible;
  }
  cancellation.check(convolution.segments.size());
  if (cover.covered_count() == 0 || crowded) list();
  if (wanted && free_side && cover.covered_count() == 0) {
    crowded = divisible && size >= kSegmentsWorthDividing &&
              expected_crossings(operands, convolution.segments) > crossings_to_divide;
    // A fine grid without covered cells is of no use.
    cover.active = false;
    if (!crowded) cover_on_grid(operands, choose_plain_side(size), cancellation, scratch, cover);
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
