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
};

/// Returns the exact point of a position in cells of the grid. The operands have integers.
reference::Pt place(const Covered& c, double column, double row) {
  const Vec<double>& cell = c.cover.grid.cell;
  const reference::Number unit(c.operands.trace_unit);
  return {reference::Number(column) * reference::Number(cell.x) * unit +
              reference::Number(c.operands.trace_origin.x),
          reference::Number(row) * reference::Number(cell.y) * unit +
              reference::Number(c.operands.trace_origin.y)};
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
  list.push_back(
      {"polygons", test::random_two_opt(random, 50, 1000), test::random_two_opt(random, 40, 800)});
  list.push_back({"stars of few directions", test::random_star_shaped(random, 50, 24),
                  test::random_star_shaped(random, 50, 24)});
  return list;
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
/// Returns a ring that is 64 times as wide.
Region widened(const Region& region) { return mapped(region, 64, 0, 0, 1); }

TEST(Cover, IsInside) {
  Random random(1);
  auto list = pairs();
  list.push_back({"flat star and star", widened(test::spiky_star(random, 24, 100)),
                  test::spiky_star(random, 24, 1000)});
  for (const auto& [name, p, q] : list) {
    for (const int grid : {0, 16, 50}) {
      const Covered c(p, q, grid);
      EXPECT_EQ(check(c.cover, c.operands), std::nullopt) << name;
      expect_inside(p, q, c, random, name + " on grid " + std::to_string(grid));
    }
  }
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
      c.cover.covered.reset(c.cover.grid.columns, c.cover.grid.rows);
      EXPECT_GT(choose_long_edges(c.operands, c.cover.grid, c.scratch), 0);
      cover_by_parallelograms(c.never, c.scratch, c.cover);
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
  cover.grid = UniformGrid::over(extent, 160);
  cover.covered.reset(cover.grid.columns, cover.grid.rows, words_per_row(cover.grid.columns));
  Cancellation never;
  EXPECT_GT(rasterise(edges_of(operands), cover.grid, never, scratch), 0);
  spread_rasters(never, scratch, cover);
  const std::uint64_t by_translates = cover.covered_count();
  EXPECT_GT(choose_long_edges(operands, cover.grid, scratch), 0);
  cover_by_parallelograms(never, scratch, cover);
  const auto cells = static_cast<std::uint64_t>(cover.grid.size());
  EXPECT_LT(by_translates, cells * 8 / 10);
  EXPECT_GT(cover.covered_count(), cells * 9 / 10);
}

std::vector<std::uint64_t> words(const Cover& cover) {
  const auto all = cover.covered.words();
  return {all.begin(), all.end()};
}

TEST(Cover, IsTheSameOfFlatSums) {
  for (const auto& [name, p, q] : pairs()) {
    // Those of other pairs have cells that are not square, or are flat by another power of two.
    if (name != "stars" && name != "star and polygon" && name != "polygons") continue;
    for (const int grid : {50, 150}) {
      const Covered c(p, q, grid);
      const Covered flat(widened(p), widened(q), grid);
      EXPECT_EQ(flat.cover.grid.columns, c.cover.grid.columns) << name;
      EXPECT_EQ(flat.cover.grid.rows, c.cover.grid.rows) << name;
      EXPECT_EQ(words(flat.cover), words(c.cover)) << name;
    }
  }
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
          cover_interior(c->operands, c->options, c->never, c->scratch, c->convolution, c->cover);
        }
        EXPECT_EQ(words(plain.cover), words(wide.cover)) << name << " on grid " << grid;
      }
    }
  }
}

/// Returns how many crossings of visible segments an arrangement of all would count, by testing
/// each pair. Segments of the tests cross within cells.
double count_all(const Covered& c) {
  const auto& [x, y, dx, dy, next] = c.operands.sites;
  std::vector<Line> lines;
  for (const auto& [e, v] : c.convolution.segments) {
    lines.push_back({{x[e] + x[v], y[e] + y[v]}, {x[next[e]] + x[v], y[next[e]] + y[v]}});
  }
  double count = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const auto& [a, b] = lines[i];
      const auto& [d, e] = lines[j];
      const auto side = [](const Vec<double>& o, const Vec<double>& p, const Vec<double>& q) {
        return cross(Vec<double>{p.x - o.x, p.y - o.y}, Vec<double>{q.x - o.x, q.y - o.y});
      };
      if (side(a, b, d) * side(a, b, e) >= 0 || side(d, e, a) * side(d, e, b) >= 0) continue;
      const double t = side(d, e, a) / (side(d, e, a) - side(d, e, b));
      const Vec<double> at{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
      if (!c.cover.is_covered(c.cover.grid.column(at.x), c.cover.grid.row(at.y))) ++count;
    }
  }
  return count;
}

/// An estimate steers what is bought. It cannot make a sum wrong, but it can make it slow.
TEST(Cover, CrossingsAreEstimated) {
  Random random(5);
  for (const int spikes : {40, 80}) {
    const Region p = test::spiky_star(random, spikes, 1000);
    const Region q = test::spiky_star(random, spikes, 1000);
    for (const int grid : {1, 100}) {
      Covered c(p, q, grid);
      const Visibility seen =
          look(take_sample(c.operands, c.convolution, c.scratch), c.cover, c.never, c.scratch);
      const double counted = count_all(c);
      EXPECT_GT(counted, 1000);
      EXPECT_GT(seen.crossings, counted / 4) << spikes << " spikes on grid " << grid;
      EXPECT_LT(seen.crossings, counted * 4) << spikes << " spikes on grid " << grid;
    }
  }
}

/// Crossings are rare. They are missed if few segments are compared.
TEST(Cover, SampleOfManySegmentsIsLarge) {
  Random random(6);
  Covered c(test::spiky_star(random, 200, 1000), test::spiky_star(random, 200, 1000), 1);
  ConvolutionScratch scratch;
  Convolution counted;
  reduced_convolution_or_sample(c.operands, {}, 5000, c.never, scratch, counted);
  ASSERT_FALSE(counted.listed());
  ASSERT_GT(counted.size, 16 * kSample);
  for (const Convolution* convolution : {&c.convolution, &counted}) {
    const Sample sample = take_sample(c.operands, *convolution, c.scratch);
    EXPECT_EQ(sample.lines.size(), kSample);
    EXPECT_EQ(sample.step * kSample, static_cast<double>(convolution->size));
  }
}

TEST(Cover, UncoveredRowsTellCoveredBoxes) {
  constexpr std::int32_t kColumns = 150;
  constexpr std::int32_t kRows = 41;
  Random random(6);
  const auto below = [&](std::int32_t end) { return std::int32_t{random.below(end)}; };
  Cover cover;
  cover.active = true;
  cover.grid.columns = kColumns;
  cover.grid.rows = kRows;
  cover.covered.reset(kColumns, kRows);
  for (std::int32_t j = 0; j < kRows; ++j) {
    for (std::int32_t i = 0; i < kColumns; ++i) {
      if (below(300) != 0) cover.covered.set(i, j);
    }
  }
  Cancellation never;
  UncoveredRows uncovered;
  uncovered.unite(cover, never);
  int covered_boxes = 0;
  int crossing_words = 0;
  for (int box = 0; box < 4000; ++box) {
    const std::int32_t left = below(kColumns);
    const std::int32_t right = left + below(kColumns - left);
    const std::int32_t bottom = below(kRows);
    const std::int32_t top = bottom + below(kRows - bottom);
    bool all = true;
    for (std::int32_t j = bottom; j <= top; ++j) {
      for (std::int32_t i = left; i <= right; ++i) all = all && cover.is_covered(i, j);
    }
    ASSERT_EQ(uncovered.none_in(left, bottom, right, top), all);
    covered_boxes += all ? 1 : 0;
    crossing_words += all && right / 64 - left / 64 > 1 ? 1 : 0;
  }
  EXPECT_GT(covered_boxes, 400);
  EXPECT_GT(crossing_words, 10);
  // What lies beyond the grid is taken for its last cells.
  const bool last = cover.is_covered(kColumns - 1, kRows - 1);
  EXPECT_EQ(uncovered.none_in(kColumns - 1, kRows - 1, kColumns + 5, kRows + 5), last);
}

}  // namespace
}  // namespace minksum
