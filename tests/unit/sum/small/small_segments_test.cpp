// Tests that segments in the cover are found, and no others.
#include "sum/small/small_segments.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "support/random.hpp"

namespace minksum {
namespace {

/// Returns a cover of 100 by 80 cells, in which most are covered. A cell's side is 16.
Cover random_cover(test::Random& random) {
  Cover cover;
  cover.grid = UniformGrid::over({1599, 1279}, 100);
  cover.grid.cell = {16, 16};
  cover.grid.inverse = {1.0 / 16, 1.0 / 16};
  cover.active = true;
  cover.covered.reset(cover.grid.columns, cover.grid.rows, 2);
  for (std::int32_t j = 0; j < cover.grid.rows; ++j) {
    for (std::int32_t i = 0; i < cover.grid.columns; ++i) {
      if (random.between(0, 199) != 0) cover.covered.set(i, j);
    }
  }
  return cover;
}

// Lists 500 segments. Returns the lines of those that touch an uncovered cell.
std::vector<Line> list_random(test::Random& random, const Cover& cover, SmallSegments& s) {
  s.size = s.left_out = 0;
  s.wide = s.in_part = false;
  std::vector<Line> visible;
  for (int k = 0; k < 500; ++k) {
    const Vec<double> start{1.0 * random.between(0, 1599), 1.0 * random.between(0, 1279)};
    const Vec<double> end{1.0 * random.between(0, 1599), 1.0 * random.between(0, 1279)};
    const Vec<double> way = k % 2 == 0 ? minus(end, start) : Vec<double>{0, end.y - start.y};
    s.x[s.size] = start.x;
    s.y[s.size] = start.y;
    s.dx[s.size] = way.x;
    s.dy[s.size] = way.y;
    s.origin[s.size++] = {};
    const Line line{start, plus(start, way)};
    if (cells_near(cover, line, Until::kUncovered).uncovered) visible.push_back(line);
  }
  return visible;
}

TEST(SmallSegments, ThoseInTheCoverAreDropped) {
  test::Random random(1);
  const auto s = std::make_unique_for_overwrite<SmallSegments>();
  UncoveredRows uncovered;
  std::uint32_t hidden = 0;
  std::uint32_t seen = 0;
  for (int round = 0; round < 20; ++round) {
    const Cover cover = random_cover(random);
    const std::vector<Line> visible = list_random(random, cover, *s);
    drop_hidden(cover, uncovered, *s);
    ASSERT_EQ(s->size, visible.size());
    ASSERT_EQ(s->size + s->left_out, 500U);
    for (std::uint32_t i = 0; i < s->size; ++i) {
      ASSERT_EQ(s->x[i], visible[i].start.x);
      ASSERT_EQ(s->y[i], visible[i].start.y);
    }
    hidden += s->left_out;
    seen += s->size;
  }
  EXPECT_GT(hidden, 1000U);
  EXPECT_GT(seen, 1000U);
}

TEST(SmallSegments, ASampleTellsHowManyAreSeen) {
  test::Random random(2);
  const auto s = std::make_unique_for_overwrite<SmallSegments>();
  const auto sample = std::make_unique_for_overwrite<SmallSegments>();
  double told = 0;
  double seen = 0;
  for (int round = 0; round < 40; ++round) {
    const Cover cover = random_cover(random);
    const std::vector<Line> visible = list_random(random, cover, *s);
    const auto [share, whole] = take_sample(cover, *s, *sample);
    for (std::uint32_t i = 0; i < sample->size; ++i) {
      const Vec<double> start{sample->x[i], sample->y[i]};
      const Line line{start, plus(start, sample->way()[i])};
      ASSERT_TRUE(cells_near(cover, line, Until::kUncovered).uncovered);
    }
    ASSERT_EQ(s->size, 500U);
    ASSERT_LE(sample->size, share * 500);
    told += whole;
    seen += static_cast<double>(visible.size());
  }
  EXPECT_NEAR(told / seen, 1, 0.1);
}

}  // namespace
}  // namespace minksum
