// Tests that few listed segments with many hidden ones give the same sum as all segments, and that
// crossings are the same cell by cell and among all pairs.
#include "sum/arrangement/visible_segments.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "minksum/transform.hpp"
#include "region/map_points.hpp"
#include "sum/filters/filters.hpp"
#include "sum/output/output.hpp"
#include "support/generators.hpp"
#include "support/geometries.hpp"
#include "support/polygon_kinds.hpp"
#include "unit/sum/prepare_operands.hpp"

namespace minksum {
namespace {

using test::Random;

/// Runs the stages up to the cover, from all segments and from a sample.
struct CoveredSum {
  SumSettings options;
  Operands operands;
  ConvolutionScratch convolution_scratch;
  Convolution all;
  Convolution sample;
  CoverScratch scratch;
  Cover cover;

  CoveredSum() = default;
  CoveredSum(const Region& p, const Region& q, int grid) {
    options.grid = grid;
    test::prepare_operands(p, q, options, operands);
    find_cover();
  }
  void find_cover() {
    Cancellation never;
    reduced_convolution(operands, options.limits, never, convolution_scratch, all);
    reduced_convolution_or_sample(operands, options.limits, 0, never, convolution_scratch, sample);
    cover_interior(operands, options, never, scratch, sample, cover);
  }
};

/// Runs the pipeline after the cover. Crossings are looked for cell by cell, or among all pairs.
Region sum_of(const CoveredSum& c, const Convolution& convolution, bool by_cells) {
  Cancellation never;
  Predicates predicates(c.operands.sites, *c.operands.kernel, c.operands.bounds, never);
  ArrangementScratch arrangement_scratch;
  Arrangement arrangement;
  Cover cover = c.cover;
  cover.by_cells = by_cells;
  arrange(c.operands, convolution, cover, c.options, predicates, arrangement_scratch, arrangement);
  LoopScratch loop_scratch;
  Loops loops;
  find_loops(c.operands, arrangement, never, loop_scratch, loops);
  BoxTrees trees;
  FilteredLoops filtered;
  filter_loops(c.operands, arrangement, loops, predicates, trees, filtered);
  OutputScratch output_scratch;
  Boundary boundary;
  extract_rings(c.operands, arrangement, loops, filtered, predicates, output_scratch, boundary);
  Region sum;
  write_region(c.operands, arrangement, boundary, never, output_scratch, sum);
  return sum;
}

/// Returns whether all cells of a segment's box, up to rounding, are covered.
bool is_hidden(const CoveredSum& c, const Segment& s) {
  const auto& [x, y, dx, dy, next] = c.operands.sites;
  const UniformGrid& grid = c.cover.grid;
  const auto range = [](double a, double b, double cell) {
    const double dust = std::min(0x1p-10 * cell, std::abs(b - a) / 2);
    return std::pair(std::min(a, b) + dust, std::max(a, b) - dust);
  };
  const SiteId f = next[s.edge];
  const auto [left, right] = range(x[s.edge] + x[s.vertex], x[f] + x[s.vertex], grid.cell.x);
  const auto [low, high] = range(y[s.edge] + y[s.vertex], y[f] + y[s.vertex], grid.cell.y);
  for (std::int32_t j = grid.row(low); j <= grid.row(high); ++j) {
    for (std::int32_t i = grid.column(left); i <= grid.column(right); ++i) {
      if (!c.cover.is_covered(i, j)) return false;
    }
  }
  return true;
}

/// Whether one of the segments is the same edge at the same vertex, with the operands exchanged.
bool has_copy(const Operands& o, std::span<const Segment> segments, const Segment& s) {
  const auto other = [&](SiteId site) { return site < o.split ? site + o.split : site - o.split; };
  return std::find(segments.begin(), segments.end(), Segment{other(s.edge), other(s.vertex)}) !=
         segments.end();
}

/// Compares the visible segments with all of them; returns how many are hidden.
std::size_t expect_others_are_hidden(const CoveredSum& c, const std::string& what) {
  VisibleScratch scratch;
  Cancellation never;
  const auto visible = visible_segments(c.operands, c.sample, c.cover, {}, never, scratch);
  std::size_t seen = 0;
  for (const Segment& segment : c.all.segments) {
    if (seen < visible.size() && visible[seen] == segment) {
      ++seen;
    } else {
      EXPECT_TRUE(is_hidden(c, segment) ||
                  (c.operands.equal && has_copy(c.operands, visible, segment)))
          << what << ": edge " << segment.edge << " at vertex " << segment.vertex;
    }
  }
  EXPECT_EQ(seen, visible.size()) << what << ": one does not belong, or is out of order";
  return c.all.segments.size() - visible.size();
}

/// Compares for a cover that has cells and for which only a sample was listed.
bool compare(const CoveredSum& c, const std::string& what, std::size_t& hidden) {
  EXPECT_EQ(check(c.sample, c.operands, false), std::nullopt) << what;
  const Region sum = sum_of(c, c.all, true);
  EXPECT_TRUE(sum_of(c, c.all, false) == sum) << what;
  if (c.sample.listed()) {
    EXPECT_EQ(c.sample.segments, c.all.segments) << what;
    return false;
  }
  hidden += expect_others_are_hidden(c, what);
  EXPECT_TRUE(sum_of(c, c.sample, true) == sum) << what;
  EXPECT_TRUE(sum_of(c, c.sample, false) == sum) << what;
  return true;
}

TEST(VisibleSegments, HaveNoCopiesInSumsOfEqualOperands) {
  Random random(test::seed_from_environment(12));
  std::size_t hidden = 0;
  int covers = 0;
  for (int i = 0; i < 12; ++i) {
    const Region p = i % 2 == 0 ? test::random_two_opt(random, 40 + 20 * i, 1000)
                                : test::random_with_holes(random, 40, 3);
    const Region moved = transform(p, Affine::translation(random.between(-9, 9), 1));
    const CoveredSum c(p, moved, 50);
    EXPECT_TRUE(c.operands.equal);
    EXPECT_FALSE(CoveredSum(p, transform(p, Affine::scaling(2)), 50).operands.equal);
    if (!compare(c, std::to_string(i), hidden)) continue;
    ++covers;
    VisibleScratch scratch;
    Cancellation never;
    const Operands& o = c.operands;
    const auto visible = visible_segments(o, c.all, c.cover, {}, never, scratch);
    for (const Segment& s : visible) {
      const DirectionRank rank = o.rank[s.edge];
      const bool parallel = rank == o.rank[s.vertex] || rank == o.rank[o.previous[s.vertex]];
      EXPECT_TRUE(parallel || !has_copy(o, visible, s));
    }
  }
  EXPECT_GE(covers, 6);
  EXPECT_GE(hidden, 1000U);
}

TEST(VisibleSegments, AreAllThatAreNotHidden) {
  Random random(test::seed_from_environment(11));
  std::size_t hidden = 0;
  int covers = 0;
  for (int i = 0; i < 40; ++i) {
    const Region p = i % 2 == 0 ? test::random_two_opt(random, 20 + 4 * i, 1000)
                                : test::random_with_holes(random, 24, 3);
    const Region q = i % 3 == 0 ? test::random_with_holes(random, 20, 2)
                                : test::random_two_opt(random, 10 + 4 * i, 300 + 10 * i);
    for (const int grid : {16, 50, 200}) {
      const std::string what = std::to_string(i) + " on grid " + std::to_string(grid);
      covers += compare(CoveredSum(p, q, grid), what, hidden) ? 1 : 0;
    }
  }
  EXPECT_GE(covers, 60);
  EXPECT_GE(hidden, 20000U);
}

TEST(VisibleSegments, OfSmallDegeneratePairs) {
  Random random(test::seed_from_environment(12));
  std::size_t hidden = 0;
  int covers = 0;
  for (int i = 0; i < 1500; ++i) {
    const test::Pair pair = test::random_pair(random);
    if (pair.p.empty() || pair.q.empty()) continue;
    covers += compare(CoveredSum(pair.p, pair.q, 30), pair.kind, hidden) ? 1 : 0;
  }
  EXPECT_GE(covers, 500);
  EXPECT_GE(hidden, 1000U);
}

/// Each operand's square fits into the other's hole, so both holes stay, but they never meet.
TEST(VisibleSegments, OfTwoWithHoles) {
  const Region p =
      test::make_region({{{{0, 0}, {60, 0}, {61, 62}, {1, 60}}, {{2, 2}, {3, 12}, {4, 4}, {12, 3}}},
                         {{{70, 0}, {71, 1}, {70, 2}}}});
  const Region q =
      test::make_region({{{{0, 0}, {50, 1}, {51, 50}, {1, 49}}, {{2, 3}, {2, 13}, {4, 5}, {13, 3}}},
                         {{{60, 0}, {61, 1}, {60, 2}}}});
  std::size_t hidden = 0;
  const CoveredSum c(p, q, 20);
  ASSERT_EQ(c.operands.rings.size(), 6U);
  EXPECT_TRUE(compare(c, "two with holes", hidden));
  EXPECT_GE(hidden, 1U);
}

TEST(VisibleSegments, AlongAPolyline) {
  Random random(test::seed_from_environment(13));
  std::size_t hidden = 0;
  int covers = 0;
  for (int i = 0; i < 20; ++i) {
    CoveredSum c;
    c.options.grid = 40;
    OperandScratch scratch;
    std::array<PreparedOperand, 2> prepared;
    std::vector<Fault> faults;
    const Region area = test::random_two_opt(random, 60, 400);
    Cancellation never;
    prepare_operand(area, c.options, 1, never, scratch, prepared[0], faults);
    ASSERT_TRUE(faults.empty());
    test::Outline line;
    for (int k = 0; k < 30; ++k) {
      line.push_back({static_cast<std::int64_t>(random.below(400)), 14 * k});
    }
    Region walk;
    walk_there_and_back(test::make_lines({line}).polylines, never, walk);
    prepare_thin_operand(walk, c.options, never, scratch, prepared[1]);
    combine_operands(prepared[0], prepared[1], c.options, NarrowHoles::kFill, never, c.operands);
    c.find_cover();
    covers += compare(c, "polyline " + std::to_string(i), hidden) ? 1 : 0;
  }
  EXPECT_GE(covers, 10);
  EXPECT_GE(hidden, 1000U);
}

TEST(VisibleSegments, SamplesHaveOneOfEachStep) {
  Random random(14);
  for (const int size : {3, 5, 20, 100, 300}) {
    const Region p = test::random_two_opt(random, size, 2000);
    const Region q = test::random_two_opt(random, size + 7, 2000);
    const CoveredSum c(p, q, 16);
    for (const std::uint64_t many : {0U, 1U, 7U, 1000U, 5000U}) {
      ConvolutionScratch scratch;
      Convolution sample;
      Cancellation never;
      reduced_convolution_or_sample(c.operands, {}, many, never, scratch, sample);
      EXPECT_EQ(sample.listed(), many >= c.all.segments.size());
      EXPECT_EQ(sample.size, c.all.segments.size());
      EXPECT_GE(sample.segments.size(), sample.size / sample.step);
      EXPECT_LE(sample.segments.size(), sample.size / sample.step + 1);
      for (std::size_t i = 0; i < sample.segments.size(); ++i) {
        const std::span turn = std::span(c.all.segments).subspan(i * sample.step);
        const std::span first = turn.first(std::min<std::size_t>(sample.step, turn.size()));
        EXPECT_NE(std::ranges::find(first, sample.segments[i]), first.end()) << many << ": " << i;
      }
      EXPECT_TRUE(sample.step <= 2 ||
                  (sample.segments.size() >= kSample && sample.segments.size() < 2 * kSample));
    }
  }
}

TEST(VisibleSegments, TooManyAreAnError) {
  Random random(15);
  const CoveredSum c(test::random_two_opt(random, 100, 1000),
                     test::random_two_opt(random, 100, 1000), 50);
  ASSERT_FALSE(c.sample.listed());
  VisibleScratch scratch;
  Limits limits;
  limits.max_segments = 20;
  Cancellation never;
  EXPECT_THROW((void)visible_segments(c.operands, c.sample, c.cover, limits, never, scratch),
               Error);
}

TEST(VisibleSegments, CanBeStopped) {
  Random random(16);
  const CoveredSum c(test::random_two_opt(random, 400, 3000),
                     test::random_star_shaped(random, 3000, 9000), 400);
  ASSERT_FALSE(c.sample.listed());
  VisibleScratch scratch;
  int asked = 0;
  Options options;
  options.cancel = CancelToken::polling([&] {
    return ++asked > 1;  // the first time is before it begins
  });
  Cancellation cancellation(options);
  EXPECT_THROW((void)visible_segments(c.operands, c.sample, c.cover, {}, cancellation, scratch),
               Error);
  EXPECT_EQ(asked, 2);
}

}  // namespace
}  // namespace minksum
