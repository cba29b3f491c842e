// Tests that dividing crowds, and sorting strips, finds the crossings that all pairs have, and that
// crowds are not looked at cell by cell.
#include "sum/arrangement/crowds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "minksum/boolean.hpp"
#include "minksum/transform.hpp"
#include "support/polygon_kinds.hpp"
#include "support/random.hpp"
#include "support/shapes.hpp"
#include "unit/sum/prepare_operands.hpp"

namespace minksum {
namespace {

using test::Random;
using Pairs = std::vector<std::pair<KeptId, KeptId>>;

/// The segments of a convolution without a cover, and the memory to meet them.
struct Crowd {
  SumSettings settings;
  Operands operands;
  Convolution convolution;
  Cover cover;
  Cancellation never;
  ArrangementScratch scratch;
  Arrangement arrangement;

  Crowd(const Region& p, const Region& q) {
    test::prepare_operands(p, q, settings, operands);
    ConvolutionScratch convolution_scratch;
    reduced_convolution(operands, settings.limits, never, convolution_scratch, convolution);
    bin_segments(operands, convolution, cover, settings.limits, never, scratch, arrangement);
    scratch.parent.resize(2 * arrangement.kept.size());
    std::iota(scratch.parent.begin(), scratch.parent.end(), 0U);
    scratch.line_parent.resize(arrangement.kept.size());
    std::iota(scratch.line_parent.begin(), scratch.line_parent.end(), 0U);
  }
  [[nodiscard]] double extent() const { return std::max(scratch.extent.x, scratch.extent.y); }
};

/// Meets segments by `work(crowd, meeter)`. Returns the pairs that cross, and the roots of points
/// that are united.
template <class Work>
std::pair<Pairs, std::vector<std::uint32_t>> meetings(const Region& p, const Region& q, Work work) {
  Crowd crowd(p, q);
  Predicates predicates(crowd.operands.sites, *crowd.operands.kernel, crowd.operands.bounds,
                        crowd.never);
  Meetings found;
  SegmentMeeter meeter(crowd.extent(), crowd.settings, predicates, crowd.scratch,
                       crowd.arrangement.kept, found, true);
  work(crowd, meeter);
  Pairs pairs;
  for (const Crossing& c : found.crossings) pairs.push_back(std::minmax(c.first, c.second));
  std::sort(pairs.begin(), pairs.end());
  std::vector<std::uint32_t> roots;
  for (std::uint32_t point = 0; point < 2 * crowd.scratch.line_count; ++point) {
    roots.push_back(find_root(crowd.scratch.parent, point));
  }
  return {pairs, roots};
}

Region mapped(const Region& region, std::int64_t a, std::int64_t b, std::int64_t c,
              std::int64_t d) {
  return transform(region, Affine{a, b, 0, c, d, 0});
}

void expect_all_found(const Region& p, const Region& q) {
  const auto of_all_pairs = meetings(p, q, [](Crowd& crowd, SegmentMeeter& meeter) {
    meeter.enter({});
    for (KeptId t = 1; t < crowd.scratch.line_count; ++t) {
      for (KeptId s = 0; s < t; ++s) meeter.meet(s, t);
    }
  });
  const auto of_crowds = meetings(p, q, [](Crowd& crowd, SegmentMeeter& meeter) {
    CrowdScratch memory;
    CrowdFinder finder(crowd.extent(), crowd.arrangement.kept, meeter, memory, nullptr,
                       crowd.never);
    for (KeptId s = 0; s < crowd.scratch.line_count; ++s) finder.add(s, {});
    finder.solve({});
  });
  EXPECT_FALSE(of_all_pairs.first.empty());
  EXPECT_EQ(of_crowds.first, of_all_pairs.first);
  EXPECT_EQ(of_crowds.second, of_all_pairs.second);
}

TEST(Crowds, OfSpikes) {
  Random random(1);
  for (const int spikes : {5, 12, 24}) {
    SCOPED_TRACE(spikes);
    expect_all_found(test::spiky_star(random, spikes, 100000),
                     test::spiky_star(random, spikes, 90000));
  }
}

TEST(Crowds, OfStrips) {
  // Teeth of one comb pass the gaps of the other from side to side, upright and almost upright.
  const Region upright = test::comb(20, 3, 1000);
  expect_all_found(upright, mapped(test::comb(15, 2, 900), 0, -1, 1, 0));
  expect_all_found(mapped(upright, 1000, 1, 1, 1000),
                   mapped(test::comb(15, 2, 900), 1000, -3, 2, 1000));
}

TEST(Crowds, OfNearlyEqualLines) {
  // Needles whose long sides differ by a unit in a million cross far out, or not at all.
  Region needles;
  for (std::int64_t i = 0; i < 40; ++i) {
    needles.begin_polygon();
    needles.begin_ring();
    needles.add_vertex(-1000000, 10 * i);
    needles.add_vertex(1000000, 10 * i + i % 3);
    needles.add_vertex(1000000, 10 * i + i % 3 + 1);
  }
  Random random(2);
  expect_all_found(needles, test::spiky_star(random, 4, 50));
  expect_all_found(needles, mapped(needles, 1, 0, 0, -1));
}

TEST(Crowds, OfLongCoordinates) {
  // Sums of these are not exact in doubles, so places and offsets of lines have errors.
  Random random(3);
  const Region p = test::spiky_star(random, 10, 1000000);
  const Region q = test::comb(12, 5, 800000);
  const std::int64_t far = std::int64_t{1} << 36;
  expect_all_found(mapped(p, far, 1, -1, far), mapped(q, far, 3, 1, far));
}

// A square of this size with a notch near one corner, cut by another shape.
Region notched_square(std::int64_t size, const Region& notch) {
  Region square;
  square.begin_polygon();
  square.begin_ring();
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
    square.add_vertex(x * size, y * size);
  }
  return subtract(square, transform(notch, Affine{1, 0, 70, 0, 1, 30}));
}

TEST(Crowds, OfSizesFarApart) {
  // The segments of the small operand are nearer to one another than doubles of the sum's size
  // tell.
  for (const int bits : {30, 38, 50, 58}) {
    SCOPED_TRACE(bits);
    Random random(static_cast<std::uint64_t>(bits));
    const std::int64_t size = (std::int64_t{1} << bits) + 1;
    const Region star = test::spiky_star(random, 12, 50);
    expect_all_found(notched_square(size, star), star);
    const Region spikes = transform(test::spiky_star(random, 5, 1000), Affine::scaling(size));
    expect_all_found(spikes, test::comb(9, 2, 7));
    expect_all_found(test::comb(9, 2, 7), mapped(notched_square(size, star), 3, 1, -1, 3));
    // A side of the lower triangle passes the corner of the upper one.
    Region triangles;
    for (const auto& corners :
         {std::array<std::array<std::int64_t, 2>, 3>{{{0, 0}, {size / 3, size}, {-size / 2, size}}},
          {{{-size, -3}, {0, -size}, {size + 1, -2}}}}) {
      triangles.begin_polygon();
      triangles.begin_ring();
      for (const auto& [x, y] : corners) triangles.add_vertex(x, y);
    }
    expect_all_found(triangles, test::random_star_shaped(random, 60, 50));
  }
}

TEST(Crowds, OfThreeSizes) {
  Random random(5);
  const Region small = test::spiky_star(random, 8, 40);
  const Region middle = notched_square(std::int64_t{1} << 32, small);
  const Region huge = transform(notched_square(std::int64_t{1} << 61, small), Affine::scaling(8));
  expect_all_found(huge, unite(middle, transform(small, Affine{1, 0, -300, 0, 1, -200})));
  // On rationals of any size.
  expect_all_found(transform(huge, Affine::scaling(Rational(std::int64_t{1} << 62, 3))), middle);
}

/// Lists the segments that a cover leaves cell by cell. Returns whether cells are kept.
bool keeps_cells(const Region& p, const Region& q, int grid) {
  SumSettings settings;
  settings.grid = grid;
  Cancellation never;
  Operands operands;
  test::prepare_operands(p, q, settings, operands);
  ConvolutionScratch convolution_scratch;
  Convolution convolution;
  reduced_convolution(operands, settings.limits, never, convolution_scratch, convolution);
  CoverScratch cover_scratch;
  Cover cover;
  cover_interior(operands, settings, never, cover_scratch, convolution, cover);
  EXPECT_GT(cover.covered_count(), 0U);
  cover.by_cells = true;
  cover.clips = false;
  ArrangementScratch scratch;
  Arrangement arrangement;
  bin_segments(operands, convolution, cover, settings.limits, never, scratch, arrangement);
  EXPECT_GT(arrangement.kept.size(), 100U);
  return scratch.by_cells;
}

TEST(Crowds, CellsThatSegmentsCrowdAreGivenUp) {
  test::Random random(1);
  const Region star = test::spiky_star(random, 200, 1000);
  EXPECT_TRUE(keeps_cells(star, test::spiky_star(random, 200, 1000), 128));
  // At each of the star's convex vertices, long edges pass the same cells.
  const Region large = test::make_polygon({{0, 0}, {9000000, 300000}, {200000, 9900000}});
  EXPECT_FALSE(keeps_cells(large, star, 1024));
}

/// Slivers with one corner in common.
Region slivers(std::int64_t count, std::int64_t length) {
  Region result;
  for (std::int64_t i = 0; i < count; ++i) {
    result.begin_polygon();
    result.begin_ring();
    result.add_vertex(0, 0);
    result.add_vertex(length, 2 * i);
    result.add_vertex(length, 2 * i + 1);
  }
  return result;
}
/// Triangles with one corner in common, all around it.
Region fan(std::int64_t count, std::int64_t size) {
  const Region quarter = transform(slivers(count / 4, size), Affine{1, 0, 0, 0, size / count, 0});
  return unite(unite(quarter, mapped(quarter, -1, 0, 0, -1)),
               unite(mapped(quarter, 0, -1, 1, 0), mapped(quarter, 0, 1, -1, 0)));
}

// Such segments cross near the corner, deep inside the sum, where no grid is fine enough.
TEST(Crowds, PartsInsideTheSumAreLeftOut) {
  const Region triangle = test::make_polygon({{0, 0}, {30, 10}, {10, 20}});
  for (const Region& p : {slivers(500, 1000000), fan(600, 1000000000), fan(600, 1000000)}) {
    SumSettings settings;
    settings.check = true;
    const DetailedSum found = detailed_sum(p, triangle, settings);
    settings.threads = 3;
    settings.share_all = true;
    const DetailedSum shared = detailed_sum(p, triangle, settings);
    settings.cover = false;
    const DetailedSum whole = detailed_sum(p, triangle, settings);
    EXPECT_EQ(found.sum, whole.sum);
    EXPECT_EQ(found.sum, shared.sum);
    EXPECT_EQ(found.statistics.crossings, shared.statistics.crossings);
    EXPECT_EQ(found.statistics.by_filter, shared.statistics.by_filter);
    EXPECT_LT(found.statistics.crossings, whole.statistics.crossings / 2);
  }
}

}  // namespace
}  // namespace minksum
