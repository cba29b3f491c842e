// Tests that boxes in cells never miss an overlap, and the walk of a segment never misses a cell.
#include "sum/arrangement/cell_box.hpp"

#include <gtest/gtest.h>

#include <set>

#include "spatial/uniform_grid.hpp"
#include "support/polygon_kinds.hpp"

namespace {

using namespace minksum;
using minksum::test::Random;

double unit(Random& random) { return random.between(-400, 8192 + 400) / 8192.0; }

struct RandomBox {
  double x0, y0, x1, y1;
  explicit RandomBox(Random& random)
      : x0(unit(random)), y0(unit(random)), x1(unit(random)), y1(unit(random)) {
    if (x1 < x0) std::swap(x0, x1);
    if (y1 < y0) std::swap(y0, y1);
    if (random.one_in(4)) x1 = x0;
    if (random.one_in(4)) y1 = y0;
  }
  [[nodiscard]] CellBox rounded() const { return {x0, y0, x1, y1}; }
};
/// Returns how far apart two boxes are; negative if they overlap.
double gap(const RandomBox& a, const RandomBox& b) {
  return std::max({a.x0 - b.x1, b.x0 - a.x1, a.y0 - b.y1, b.y0 - a.y1});
}

TEST(CellBox, OverlapsExactlyWhereRoundedOutwards) {
  Random random(1);
  for (int i = 0; i < 200000; ++i) {
    const RandomBox a(random);
    const RandomBox b(random);
    const bool overlap = a.rounded().overlaps(b.rounded().partner());
    EXPECT_EQ(overlap, b.rounded().overlaps(a.rounded().partner()));
    if (gap(a, b) <= 0) {
      EXPECT_TRUE(overlap);
    }
    if (gap(a, b) > 5 * CellBox::kUnit) {
      EXPECT_FALSE(overlap);
    }
  }
}

TEST(CellBox, TheIntersectionOverlapsWhatAllThreeShare) {
  Random random(2);
  for (int i = 0; i < 200000; ++i) {
    const RandomBox a(random);
    const RandomBox b(random);
    const RandomBox c(random);
    if (!a.rounded().overlaps(b.rounded().partner())) continue;
    const CellBox both = a.rounded().within(b.rounded());
    const bool all = std::max({a.x0, b.x0, c.x0}) <= std::min({a.x1, b.x1, c.x1}) &&
                     std::max({a.y0, b.y0, c.y0}) <= std::min({a.y1, b.y1, c.y1});
    if (all) {
      EXPECT_TRUE(both.overlaps(c.rounded().partner()));
    }
    EXPECT_LE(both.left(), both.right());
  }
}

TEST(CellBox, CutsOffWhatIsFarAway) {
  const CellBox far(-1e9, -1e9, 1e9, 1e9);
  for (const double x : {-0.0625, 0.5, 1.0625}) {
    for (const double y : {-0.0625, 0.5, 1.0625}) {
      EXPECT_TRUE(far.overlaps(CellBox(x, y, x, y).partner()));
    }
  }
}

TEST(UniformGrid, WalkMeetsEveryCellNearTheSegment) {
  Random random(3);
  for (int i = 0; i < 4000; ++i) {
    const double stretch = i % 2 == 0 ? 1 : std::ldexp(1, random.between(-8, 8));
    const UniformGrid grid = UniformGrid::over({1000, 700}, 37, stretch);
    ASSERT_EQ(std::max(grid.columns, grid.rows), 38);
    const int spread = random.one_in(2) ? 20 : 1000;
    Vec<double> a{static_cast<double>(random.between(0, 1000)),
                  static_cast<double>(random.between(0, 700))};
    Vec<double> b{std::clamp(a.x + random.between(-spread, spread), 0.0, 1000.0),
                  std::clamp(a.y + random.between(-spread, spread), 0.0, 700.0)};
    if (random.one_in(5)) b.y = a.y;
    if (random.one_in(5)) b.x = a.x;
    std::set<std::pair<int, int>> met;
    grid.walk(a, b, UniformGrid::kMargin, [&](std::int32_t column, std::int32_t row) {
      EXPECT_TRUE(met.insert({column, row}).second);
      return true;
    });
    for (int k = 0; k <= 500; ++k) {
      const double t = k / 500.0;
      const int column = grid.column(a.x + t * (b.x - a.x));
      const int row = grid.row(a.y + t * (b.y - a.y));
      EXPECT_TRUE(met.contains({column, row})) << a.x << ' ' << a.y << ' ' << b.x << ' ' << b.y;
    }
  }
}

}  // namespace
