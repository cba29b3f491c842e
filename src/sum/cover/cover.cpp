#include "sum/cover/cover.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "sum/cover/first_grid.hpp"

namespace minksum {
namespace {

// Prices are in words moved; moving a word takes some 0.14 ns. The prices from `kSegment` to
// `kLeastInCells`, without `kNearPairUnderCover`, were chosen among some twenty sets, by what 220
// pairs of shapes took, and compared with the prices before on 368 other pairs. Of 410
// sums without cells, four fifths took 0.67 to 2.3 times their price. Of 253 sums in cells, four
// fifths took 0.87 to 3.2 times their price.
constexpr double kSegment = 38;    ///< a segment, for each binary digit of their number
constexpr double kNearPair = 100;  ///< two whose boxes overlap
constexpr double kCrossing = 800;
/// Two whose boxes overlap, if all pairs are met and points in covered cells are left out. It was
/// chosen later. With any value from 150 to 250, the time of 220 sums was the same.
constexpr double kNearPairUnderCover = 200;
// In cells the first three take longer. Each row of cells that a segment passes has a price as
// well, and so has every sum in cells.
constexpr double kInCells = 1.15;
constexpr double kRowOfSegment = 110;
constexpr double kLeastInCells = 10000;
/// Clipping a segment follows a ring for some sites, in 50 ns.
constexpr double kClip = 360;
/// Rationals take far longer, even for what no cover saves.
constexpr double kRational = 4;
/// Looking takes 400 instructions for each segment of the sample: it is placed, walked along its
/// rows, and tried at some points.
constexpr double kLookAtSegment = 170;
constexpr double kRowOfParallelogram = 27;
/// Both rasters have four times as many words on the next grid, so hardly fewer are moved. Mostly 8
/// times as many are, but how many is known before they are paid.
constexpr double kGrowthOfWords = 4;
/// All grids together may cost this share of what the best one so far leaves. So grids that are
/// bought in vain cost no more. Parallelograms may cost this share of the meetings besides. What
/// they cost counts when the next grid is bought.
constexpr double kMostOfWhatIsLeft = 0.25;
/// After a grid that left more than `kWorthIt` of the price before it, few grids help. More are
/// bought only while all grids together cost at most this share. Without any more, one sum of
/// 136,052 segments took six times as long as by the best grid. Grids cost under 0.1 % of that
/// time. The same holds for parallelograms: one sum of 80,334 segments took four times the time
/// when none were tried again on finer grids.
constexpr double kMostInVain = 0.05;
constexpr double kWorthIt = 0.8;

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

/// What it takes to arrange what a cover leaves, if crossings are looked for cell by cell, or among
/// all pairs of segments.
struct ArrangementPrice {
  double by_cells;
  double by_pairs;
};
ArrangementPrice price_of_arrangement(const Operands& operands, double segments,
                                      const UniformGrid& grid, const Visibility& left) {
  const double rational = operands.kernel->rung() == Arithmetic::kArbitrary ? kRational : 1;
  const double visible = left.share * segments;
  const auto digits = static_cast<double>(std::bit_width(static_cast<std::uint64_t>(visible)));
  const double lines = rational * (kSegment * visible * digits + kCrossing * left.crossings);
  const double near = lines + kNearPair * left.near_in_uncovered;
  if (left.rows == 0) return {.by_cells = HUGE_VAL, .by_pairs = near};
  const double rows = std::min(left.rows, static_cast<double>(grid.size()) / 2);
  return {.by_cells = kInCells * near + kRowOfSegment * rows + kLeastInCells,
          .by_pairs = lines + kNearPairUnderCover * left.near_pairs};
}

/// Buys grids, each twice as fine as the one before, and marks the cells that translates cover.
///
/// Narrow shapes have no cells inside until cells are small, so finer grids are bought as long as
/// they are cheap beside what is left to the arrangement. A grid's price is known before it is
/// paid, once both operands are rasterised. Prices grow two to eight times from grid to grid, so
/// all grids together cost at most about twice the last one. Where many thin translates cover the
/// sum, segments crowd on every grid. There parallelograms are bought, until they do not help. What
/// is covered stays covered on the next grid.
class GridBuyer {
 public:
  GridBuyer(const Operands& operands, const Convolution& convolution, Cancellation& cancellation,
            CoverScratch& scratch, Cover& cover)
      : operands_(operands),
        grids_(edges_of(operands)),
        segments_(static_cast<double>(convolution.size)),
        sample_(take_sample(operands, convolution, scratch)),
        cancellation_(cancellation),
        scratch_(scratch),
        cover_(cover) {}

  /// Chooses whether segments are clipped, and clips the sample then.
  void choose_clipping() {
    const ClippedShare left = see_clipped(operands_, sample_, cancellation_, scratch_);
    if (left.length == 1) return;
    const auto digits = static_cast<double>(std::bit_width(static_cast<std::uint64_t>(segments_)));
    // If a share of a segment's length is left, so is that share of its crossings with whole ones.
    // At most one crossing for each segment is counted. By that, 241 sums took 0.674 of the time on
    // the geometric mean, 0.677 with up to two crossings, 0.679 with any number, and the better way
    // each time 0.655.
    const double crossings = std::min(sample_.expected_crossings(operands_), segments_);
    const double saved = (1 - left.segments) * kSegment * segments_ * digits +
                         (1 - left.length * left.length) * kCrossing * crossings;
    if (saved <= kClip * segments_) return;
    cover_.clips = true;
    sample_ = clipped(operands_, sample_, cancellation_, scratch_);
  }
  /// Buys one grid, whatever it costs.
  void buy(int side) {
    static_cast<void>(rasterise(grids_.edges(), grids_.of(side), cancellation_, scratch_));
    mark(side, true);
    left_ = see();
    buy_parallelograms();
    cover_.by_cells = pays_by_cells(operands_, segments_, cover_.grid, left_);
  }
  /// Buys grids from one of `side` cells along a side on, as long as that pays. Keeps the
  /// one that leaves least, or none.
  void buy_from(int side) {
    if (is_sparse()) return;
    side = std::max(side, grids_.coarsest_useful_side());
    if (side > kFinestSide) return;
    left_ = {.share = sample_.share, .crossings = sample_.expected_crossings(operands_)};
    const double look = kLookAtSegment * std::min(static_cast<double>(sample_.lines.size()),
                                                  lines_compared(segments_));
    Visibility best = left_;
    UniformGrid best_grid = grids_.of(1);
    bool best_is_active = false;
    bool best_by_translates = true;
    bool helped = true;
    double next_words = 0;
    for (bool first = true; side <= kFinestSide; side *= 2, first = false) {
      const double affordable = (helped ? kMostOfWhatIsLeft : kMostInVain) * price_of(best);
      spent_ += look;
      const double rasters = grids_.price_of_rasters(grids_.of(side));
      if (spent_ + rasters + next_words > affordable) break;
      // Each grid after the first one inherits cells from one half as fine.
      const Rasters bought = rasterise_from(side, first ? affordable - spent_ : 0, segments_,
                                            grids_, cancellation_, scratch_);
      side = bought.side;
      spent_ += bought.spent + bought.words;
      if (spent_ > affordable) break;
      next_words = kGrowthOfWords * bought.words;
      mark(side, first);
      Visibility before = std::exchange(left_, see());
      buy_parallelograms();
      const double left = price_of(left_);
      // To look at all segments without a cover takes longest. It is not needed where the first
      // cover leaves less than they take at least.
      const bool surely_helps = first && left < price_of(without_cover(left_));
      if (first && !surely_helps) best = see_without_cover();
      // Estimates get better with fewer visible segments, and no cover makes crossings.
      before.crossings = std::max(before.crossings, left_.crossings);
      best.crossings = std::max(best.crossings, left_.crossings);
      if (surely_helps || left < price_of(best)) {
        best = left_;
        scratch_.best = cover_.covered;
        best_grid = cover_.grid;
        best_is_active = true;
        best_by_translates = cover_.by_translates;
      }
      // A cover that hides nothing yet may hide much on the next grid.
      helped = before.share >= 0.9 * sample_.share || left <= kWorthIt * price_of(before);
    }
    std::swap(cover_.covered, scratch_.best);
    cover_.grid = best_grid;
    cover_.active = best_is_active;
    cover_.by_translates = best_by_translates;
    cover_.by_cells = pays_by_cells(operands_, segments_, best_grid, best);
  }

 private:
  /// Whether a cover has nothing to save: there are at most four segments for each edge, and they
  /// hardly meet others. One operand is then small beside the other's features.
  [[nodiscard]] bool is_sparse() const {
    constexpr double kFewCrossings = 0.1;
    return segments_ <= 4.0 * static_cast<double>(operands_.size()) &&
           sample_.expected_crossings(operands_) <= kFewCrossings * segments_;
  }
  [[nodiscard]] Visibility see() { return look(sample_, cover_, cancellation_, scratch_); }
  [[nodiscard]] Visibility see_without_cover() {
    cover_.active = false;
    const Visibility all = see();
    cover_.active = true;
    return all;
  }
  /// Returns the least that is to be arranged without a cover, by what this one leaves.
  [[nodiscard]] Visibility without_cover(const Visibility& left) const {
    return {.share = sample_.share,
            .near_in_uncovered = left.near_in_uncovered,
            .crossings = left.crossings};
  }
  [[nodiscard]] double price_of(const Visibility& left) const {
    const ArrangementPrice price = price_of_arrangement(operands_, segments_, cover_.grid, left);
    const double clips = cover_.clips ? kClip * left.share / sample_.share * segments_ : 0;
    return clips + std::min(price.by_cells, price.by_pairs);
  }
  void mark(int side, bool first) {
    cover_.active = true;
    cover_.grid = grids_.of(side);
    std::swap(cover_.covered, scratch_.known);
    cover_.covered.reset(cover_.grid.columns, cover_.grid.rows, words_per_row(cover_.grid.columns));
    if (!first) inherit(scratch_.known, cover_.covered);
    spread_rasters(cancellation_, scratch_, cover_);
  }
  void buy_parallelograms() {
    const double rows = choose_long_edges(operands_, cover_.grid, scratch_);
    const Visibility meetings{.near_in_uncovered = left_.near_in_uncovered,
                              .crossings = left_.crossings};
    const double price = kRowOfParallelogram * rows;
    if (price > kMostOfWhatIsLeft * price_of(meetings)) return;
    if (!parallelograms_help_ && spent_ + price > kMostInVain * price_of(meetings)) return;
    const double before = price_of(left_);
    spent_ += price;
    cover_by_parallelograms(cancellation_, scratch_, cover_);
    cover_.by_translates = false;
    left_ = see();
    parallelograms_help_ = price_of(left_) <= kWorthIt * before;
  }

  const Operands& operands_;
  GridsOfSum grids_;
  double segments_;
  Sample sample_;
  Cancellation& cancellation_;
  CoverScratch& scratch_;
  Cover& cover_;
  Visibility left_;
  double spent_ = 0;  ///< for all grids and parallelograms so far
  bool parallelograms_help_ = true;
};

}  // namespace

bool pays_by_cells(const Operands& operands, double segments, const UniformGrid& grid,
                   const Visibility& left) {
  const ArrangementPrice price = price_of_arrangement(operands, segments, grid, left);
  return price.by_cells < price.by_pairs;
}

EdgesOfOperands edges_of(const Operands& o) {
  const double* const x = o.sites.x.data();
  const double* const y = o.sites.y.data();
  const SiteId* const next = o.sites.next.data();
  return {{{x, y, next, 0, o.split, o.extent[0]}, {x, y, next, o.split, o.size(), o.extent[1]}}};
}

bool cover_cheaply(const EdgesOfOperands& edges, double segments, double price,
                   Cancellation& cancellation, CoverScratch& scratch, BoughtGrids& bought,
                   Cover& cover) {
  // Nothing is known of what a grid will hide, so it must be far cheaper than what all segments
  // take. With 0.22 and 0.15, 640 sums took 1.003 of the time, 15 of them under 0.77 and 34 over
  // 1.2. With 0.3 and 0.2, they took 1.015 of it.
  constexpr double kMostOfPrice = 0.15;
  constexpr double kMostForFiner = 0.1;
  const GridsOfSum grids(edges);
  int side = bought.side != 0 ? 2 * bought.side
                              : std::max(first_side(static_cast<std::uint64_t>(segments)),
                                         grids.coarsest_useful_side());
  if (side > kFinestSide) return false;
  if (bought.spent + grids.price_of_rasters(grids.of(side)) > kMostOfPrice * price) return false;
  auto [finest, spent, words] = rasterise_from(side, kMostForFiner * price - bought.spent, segments,
                                               grids, cancellation, scratch);
  side = finest;
  spent += bought.spent;
  while (2 * side <= kFinestSide) {
    const UniformGrid finer = grids.of(2 * side);
    const double more = grids.price_of_rasters(finer);
    if (spent + more + kGrowthOfWords * words > kMostForFiner * price) break;
    std::swap(scratch.raster, scratch.coarser_raster);
    const auto finer_words = static_cast<double>(rasterise(edges, finer, cancellation, scratch));
    spent += more;
    // Where cells begin to fit inside narrow shapes, more words are moved than was expected.
    if (spent + finer_words > kMostOfPrice * price) {
      std::swap(scratch.raster, scratch.coarser_raster);
      break;
    }
    side *= 2;
    words = finer_words;
  }
  bought = {side, spent};
  if (spent + words > 2 * kMostOfPrice * price) return false;
  bought.spent += words;
  const UniformGrid grid = grids.of(side);
  cover.active = words != 0;
  cover.grid = grid;
  cover.covered.reset(grid.columns, grid.rows, words_per_row(grid.columns));
  spread_rasters(cancellation, scratch, cover);
  return true;
}

void cover_interior(const Operands& operands, const SumSettings& options,
                    Cancellation& cancellation, CoverScratch& scratch, Convolution& convolution,
                    Cover& cover) {
  const std::uint64_t size = convolution.size;
  // The full convolution serves comparisons, so its whole arrangement is built. Translates of thin
  // operands have no cells inside, but their parallelograms have.
  const bool wanted =
      options.cover && options.method != Method::kFull && !operands.both_convex && size != 0;
  cover.by_translates = true;
  cover.active = false;
  cover.clips = false;
  cover.grid = UniformGrid::over(operands.sum_extent(), 1);
  if (wanted) {
    GridBuyer buyer(operands, convolution, cancellation, scratch, cover);
    buyer.choose_clipping();
    if (options.grid == 0) {
      buyer.buy_from(first_side(size));
    } else {
      buyer.buy(std::min(options.grid, kFinestSide));
    }
  }
  cancellation.check(convolution.segments.size());
  if (cover.covers_any()) return;
  if (!convolution.listed()) {
    reduced_convolution(operands, options.limits, cancellation, scratch.convolution, convolution);
  }
  if (options.grid != 0) return;
  // A fine grid without covered cells is of no use.
  cover.active = false;
  cover.grid = UniformGrid::over(operands.sum_extent(), 1);
}

}  // namespace minksum
