// Tests that covered cells, with their margins, are inside the sum by the definition of a sum.
#include "sum/cover/cover.hpp"

#include <gtest/gtest.h>

#include "reference/membership.hpp"
#include "support/polygon_kinds.hpp"
#include "unit/sum/prepare_operands.hpp"

namespace minksum {
namespace {

using test::Random;

/// Runs the stages up to the cover.
struct Covered {
  SumSettings options;
  Cancellation never;
  Operands operands;
  ConvolutionScratch convolution_scratch;
  Convolution convolution;
  CoverScratch scratch;
  Cover cover;

  Covered(const Region& p, const Region& q, int grid) {
    options.grid = grid;
    test::prepare_operands(p, q, options, operands);
    reduced_convolution(operands, options.limits, never, convolution_scratch, convolution);
    cover_interior(operands, options, never, scratch, convolution, cover);
  }
  void divide(std::int32_t side) {
    divide_by_winding(operands, convolution, options.limits, side, never, scratch, cover);
  }
};

/// Returns the exact point of a position in cells of the grid. The operands have integers.
reference::Pt place(const Covered& c, double column, double row) {
  const reference::Number cell(c.cover.grid.cell);
  const reference::Number unit(c.operands.trace_unit);
  return {reference::Number(column) * cell * unit + reference::Number(c.operands.trace_origin.x),
          reference::Number(row) * cell * unit + reference::Number(c.operands.trace_origin.y)};
}

/// Tests a covered cell at its centre, at its corners moved outwards by the promised margin, and at
/// a random point.
void expect_inside(const Region& p, const Region& q, const Covered& c, Random& random,
                   const std::string& what) {
  constexpr double kMargin = 3 * UniformGrid::kMargin;
  const std::uint64_t count = c.cover.covered_count();
  if (count == 0) return;
  const std::uint64_t step = count / 12 + 1;
  std::uint64_t seen = 0;
  for (std::int32_t j = 0; j < c.cover.grid.rows; ++j) {
    for (std::int32_t i = 0; i < c.cover.grid.columns; ++i) {
      if (!c.cover.is_covered(i, j) || seen++ % step != 0) continue;
      for (const double y : {-kMargin, 1 + kMargin}) {
        for (const double x : {-kMargin, 1 + kMargin}) {
          EXPECT_TRUE(reference::contains_sum(p, q, place(c, i + x, j + y)))
              << what << ": corner of " << i << ' ' << j;
        }
      }
      const double x = static_cast<double>(random.below(1024)) / 1024;
      EXPECT_TRUE(reference::contains_sum(p, q, place(c, i + x, j + 0.5)))
          << what << ": " << i << ' ' << j;
    }
  }
}

struct NamedPair {
  std::string name;
  Region p;
  Region q;
};
std::vector<NamedPair> pairs() {
  Random random(7);
  std::vector<NamedPair> list;
  const auto star = [&](int spikes) { return test::spiky_star(random, spikes, 1000); };
  list.push_back({"stars", star(24), star(24)});
  list.push_back({"star and polygon", star(30), test::random_two_opt(random, 30, 300)});
  list.push_back({"combs", test::comb(12, 3, 100), test::turned(test::comb(9, 4, 90))});
  list.push_back({"spirals", test::spiral(7), test::scaled(test::spiral(5), Rational(2))});
  list.push_back({"polygons", test::random_two_opt(random, 50, 1000),
                  test::random_two_opt(random, 40, 800)});
  list.push_back({"stars of few directions", test::random_star_shaped(random, 50, 24),
                  test::random_star_shaped(random, 50, 24)});
  return list;
}

TEST(Cover, IsInside) {
  Random random(1);
  for (const auto& [name, p, q] : pairs()) {
    for (const int grid : {0, 16, 50}) {
      const Covered c(p, q, grid);
      EXPECT_EQ(check(c.cover, c.operands), std::nullopt) << name;
      expect_inside(p, q, c, random, name + " on grid " + std::to_string(grid));
    }
  }
}

/// Returns a ring mapped by (ax + by, cx + dy).
Region mapped(const Region& region, int a, int b, int c, int d) {
  test::Outline ring;
  for (const std::size_t v : region.vertices_of(0)) {
    const auto x = static_cast<std::int64_t>(region.x(v));
    const auto y = static_cast<std::int64_t>(region.y(v));
    ring.push_back({a * x + b * y, c * x + d * y});
  }
  return test::make_polygon(ring);
}

TEST(Cover, ByParallelogramsIsInside) {
  Random random(3);
  auto list = pairs();
  list.push_back({"sheared combs", mapped(test::comb(14, 3, 120), 11, 5, -2, 13),
                  mapped(test::comb(12, 3, 100), -3, -12, 11, 4)});
  for (const auto& [name, p, q] : list) {
    std::uint64_t covered = 0;
    for (const int grid : {16, 50, 150}) {
      Covered c(p, q, grid);
      c.cover.active = true;
      c.cover.divided = false;
      c.cover.covered.reset(c.cover.grid.columns, c.cover.grid.rows);
      cover_by_parallelograms(c.operands, c.never, c.scratch, c.cover);
      EXPECT_EQ(check(c.cover, c.operands), std::nullopt) << name;
      expect_inside(p, q, c, random, name + " on grid " + std::to_string(grid));
      covered = c.cover.covered_count();
    }
    EXPECT_GT(covered, 50U * 50U) << name;
  }
}

/// Returns a comb whose teeth are 600 to 1000 high, and narrower at the top.
Region uneven_comb(Random& random, int teeth) {
  test::Outline ring{{0, -100}, {10 * teeth, -100}};
  for (int x = 10 * teeth - 10; x >= 0; x -= 10) {
    const auto top = static_cast<std::int64_t>(600 + random.below(400));
    for (const test::Vertex& corner : test::Outline{{7, 0}, {6, top}, {3, top}, {1, 0}}) {
      ring.push_back({x + corner.x, corner.y});
    }
  }
  return test::make_polygon(ring);
}

TEST(Cover, ParallelogramsCoverWhatTranslatesCannot) {
  Random random(4);
  const Region p = uneven_comb(random, 128);
  const Region q = mapped(uneven_comb(random, 128), 0, -1, 1, 0);
  SumSettings options;
  Operands operands;
  test::prepare_operands(p, q, options, operands);
  CoverScratch scratch;
  Cover cover;
  cover.active = true;
  const Vec<double> extent = operands.sum_extent();
  cover.grid = UniformGrid::over(extent.x, extent.y, 160);
  cover.covered.reset(cover.grid.columns, cover.grid.rows, words_per_row(cover.grid.columns));
  Cancellation never;
  EXPECT_GT(rasterise(operands, cover.grid, never, scratch), 0);
  spread_rasters(never, scratch, cover);
  const std::uint64_t by_translates = cover.covered_count();
  cover_by_parallelograms(operands, never, scratch, cover);
  const auto cells = static_cast<std::uint64_t>(cover.grid.size());
  EXPECT_LT(by_translates, cells * 8 / 10);
  EXPECT_GT(cover.covered_count(), cells * 9 / 10);
}

TEST(Cover, DividedByWindingIsInside) {
  Random random(2);
  for (const auto& [name, p, q] : pairs()) {
    std::uint64_t covered = 0;
    for (const std::int32_t side : {1, 2, 8, 64, 512}) {
      Covered c(p, q, 8);
      c.divide(side);
      ASSERT_TRUE(c.cover.divided);
      EXPECT_EQ(check(c.cover, c.operands), std::nullopt) << name;
      expect_inside(p, q, c, random, name + " divided to " + std::to_string(side));
      covered = c.cover.covered_count();
    }
    EXPECT_GT(covered, 512U * 16U) << name;
  }
}

std::vector<std::uint64_t> words(const Cover& cover) {
  const auto all = cover.covered.words();
  return {all.begin(), all.end()};
}

/// Vectors that the machine lacks are left out, so on some machines this asserts nothing.
TEST(Cover, IsTheSameWithWiderVectors) {
  for (const auto& [name, p, q] : pairs()) {
    for (const int grid : {16, 50, 300}) {
      Covered plain(p, q, grid);
      plain.scratch.vectors = Vectors::kPlain;
      Covered wide(p, q, grid);
      for (const Vectors vectors : {Vectors::kAvx2, Vectors::kAvx512}) {
        if (vectors > widest_vectors()) continue;
        wide.scratch.vectors = vectors;
        for (Covered* c : {&plain, &wide}) {
          c->cover.divided = false;
          cover_interior(c->operands, c->options, c->never, c->scratch, c->convolution, c->cover);
        }
        EXPECT_EQ(words(plain.cover), words(wide.cover)) << name << " on grid " << grid;
        for (Covered* c : {&plain, &wide}) c->divide(256);
        EXPECT_EQ(words(plain.cover), words(wide.cover)) << name << " divided";
        EXPECT_EQ(plain.cover.leaf_segments, wide.cover.leaf_segments) << name;
      }
    }
  }
}

/// Every point near a reduced segment is in a covered cell or in a leaf that lists the segment.
TEST(Cover, LeavesListTheirSegments) {
  for (const auto& pair : pairs()) {
    const std::string& name = pair.name;
    Covered c(pair.p, pair.q, 8);
    c.divide(64);
    const auto& [x, y, dx, dy, next] = c.operands.sites;
    std::vector<std::vector<std::uint32_t>> leaves_at(64 * 64);
    std::uint32_t begin = 0;
    std::vector<std::vector<std::uint32_t>> list_of;
    for (const QuadtreeLeaf& leaf : c.cover.leaves) {
      for (std::int32_t j = leaf.row; j < leaf.row + leaf.side; ++j) {
        for (std::int32_t i = leaf.column; i < leaf.column + leaf.side; ++i) {
          leaves_at[static_cast<std::size_t>(j * 64 + i)].push_back(
              static_cast<std::uint32_t>(list_of.size()));
        }
      }
      list_of.emplace_back(c.cover.leaf_segments.begin() + begin,
                           c.cover.leaf_segments.begin() + leaf.end);
      begin = leaf.end;
    }
    std::uint64_t missing = 0;
    for (std::uint32_t s = 0; s < c.convolution.segments.size(); ++s) {
      const auto& [e, v] = c.convolution.segments[s];
      const Vec<double> a{x[e] + x[v], y[e] + y[v]};
      const Vec<double> b{x[next[e]] + x[v], y[next[e]] + y[v]};
      c.cover.grid.walk(a, b, 0, [&](std::int32_t i, std::int32_t j) {
        if (c.cover.is_covered(i, j)) return true;
        const auto& leaves = leaves_at[static_cast<std::size_t>(j * 64 + i)];
        EXPECT_EQ(leaves.size(), 1U) << name << ": leaves of a cell";
        for (const std::uint32_t leaf : leaves) {
          const auto& list = list_of[leaf];
          if (std::find(list.begin(), list.end(), s) == list.end()) ++missing;
        }
        return true;
      });
    }
    EXPECT_EQ(missing, 0U) << name;
  }
}

}  // namespace
}  // namespace minksum
