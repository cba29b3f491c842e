// Tests that each entry of a table of no-fit polygons equals the one made alone.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "minksum/no_fit.hpp"
#include "minksum/resolve.hpp"
#include "minksum/transform.hpp"
#include "region/turned.hpp"
#include "support/degenerate_pairs.hpp"
#include "support/polygon_kinds.hpp"
#include "support/shapes.hpp"

namespace minksum {
namespace {

/// Returns a part as the table takes it: moved so that its first vertex is the origin, then turned.
Geometry placed(const Geometry& part, int quarters) {
  const Point reference = part.region.point(0);
  return transform(part, Affine::quarter_turns(quarters)
                             .after(Affine::translation(-reference.x, -reference.y)));
}

/// Compares all entries of a table of so many turns.
void expect_entries(const std::vector<Geometry>& parts, int turns) {
  Options options;
  options.threads = 1 + turns / 2;
  const NoFitTable table(parts, turns, options);
  options.tight = false;
  const NoFitTable areas(parts, turns, options);
  ASSERT_EQ(table.size(), parts.size());
  ASSERT_EQ(table.turns(), turns);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t j = 0; j < parts.size(); ++j) {
      for (int k = 0; k < turns * turns; ++k) {
        const int at = k / turns;
        const int by = k % turns;
        const Geometry expected = no_fit_polygon(placed(parts[i], at * (4 / turns)),
                                                 placed(parts[j], by * (4 / turns)));
        EXPECT_EQ(table.at({i, at}, {j, by}), expected)
            << i << " turned " << at << ", " << j << " turned " << by << ", of " << turns;
        EXPECT_EQ(areas.at({i, at}, {j, by}), (Geometry{expected.region, {}, {}}))
            << i << " turned " << at << ", " << j << " turned " << by << ", of " << turns;
      }
    }
  }
}

TEST(NoFitTable, IsTheSameOnManyThreads) {
  test::Random random(77003);
  std::vector<Geometry> parts;
  for (int i = 0; i < 12; ++i) {
    parts.push_back({test::random_two_opt(random, 30, 200), {}, {}});
  }
  Options options;
  for (const bool tight : {false, true}) {
    options.tight = tight;
    options.threads = 1;
    const NoFitTable one(parts, 4, options);
    options.threads = 3;
    const NoFitTable three(parts, 4, options);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      for (std::size_t j = 0; j < parts.size(); ++j) {
        EXPECT_EQ(one.at({i, 0}, {j, 1}), three.at({i, 0}, {j, 1})) << i << ", " << j;
      }
    }
  }
}

TEST(NoFitTable, HasWhatNoFitPolygonGives) {
  test::Random random(77001);
  for (int round = 0; round < 60; ++round) {
    std::vector<Geometry> parts;
    while (parts.size() < 3) {
      const test::DegeneratePair pair = test::random_degenerate_pair(random);
      for (const Geometry& part : {pair.p, pair.q}) {
        if (!resolve(part).region.empty()) parts.push_back(part);
      }
    }
    for (const int turns : {1, 2, 4}) expect_entries(parts, turns);
  }
}

TEST(NoFitTable, HasCrossingsWithDigits) {
  test::Random random(77002);
  for (int round = 0; round < 10; ++round) {
    std::vector<Geometry> parts;
    for (int i = 0; i < 3; ++i) parts.push_back({test::random_two_opt(random, 12, 50), {}, {}});
    expect_entries(parts, 4);
  }
}

TEST(NoFitTable, ReadsPartsByTheRule) {
  // The parts are a bow-tie, and a square with a spike that has no area.
  const Geometry bow_tie{test::make_polygon({{0, 0}, {2, 2}, {2, 0}, {0, 2}}), {}, {}};
  const Geometry spiked{
      test::make_polygon({{0, 0}, {1, 0}, {1, 1}, {3, 1}, {1, 1}, {0, 1}}), {}, {}};
  expect_entries({bow_tie, spiked}, 4);
}

TEST(NoFitTable, KnowsOriginsOfEitherPart) {
  const Geometry square{test::make_polygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}}), {}, {}};
  const Geometry triangle{test::make_polygon({{0, 0}, {3, 1}, {1, 2}}), {}, {}};
  const std::vector<Geometry> parts{square, triangle};
  const NoFitTable table(parts);
  for (const auto& [first, second] : {std::pair<std::size_t, std::size_t>{0, 1}, {1, 0}}) {
    const Geometry entry = table.at({first, 0}, {second, 0});
    ASSERT_TRUE(entry.region.has_origins());
    const std::array<const Region*, 2> operands{&parts[first].region, &parts[second].region};
    for (std::size_t v = 0; v < entry.region.vertex_count(); ++v) {
      const EdgeOrigin& origin = entry.region.origin(v);
      const bool edge_of_first = origin.edge_operand == Operand::kFirst;
      const Point edge = operands[edge_of_first ? 0 : 1]->point(origin.edge);
      const Point vertex = operands[edge_of_first ? 1 : 0]->point(origin.vertex);
      const Point at = entry.region.point(v);
      // The sum is fixed − moving. No edges are parallel, and both parts run counter-clockwise.
      const Point expected = edge_of_first ? Point{edge.x - vertex.x, edge.y - vertex.y}
                                           : Point{vertex.x - edge.x, vertex.y - edge.y};
      EXPECT_EQ(at, expected) << "vertex " << v << " of " << test::to_text(entry.region);
    }
  }
}

TEST(NoFitTable, SaysWhichPartIsBad) {
  const Geometry square{test::make_polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), {}, {}};
  const std::vector<Geometry> parts{square, square, {}};
  try {
    const NoFitTable table(parts);
    FAIL() << "a part without area was taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadInput);
    EXPECT_EQ(error.culprit().operand, 2);
  }
  const std::vector<Geometry> good{square};
  EXPECT_THROW(NoFitTable(good, 3), Error);
  const NoFitTable table(good);
  EXPECT_THROW((void)table.at({1, 0}, {0, 0}), Error);
  EXPECT_THROW((void)table.at({0, 0}, {0, 4}), Error);
  EXPECT_THROW((void)table.at({0, -1}, {0, 0}), Error);
}

TEST(NoFitTable, StopsWhenCancelled) {
  const std::vector<Geometry> parts(4, {test::rectangle(0, 0, 1, 1), {}, {}});
  Options options;
  options.cancel.emplace();
  options.cancel->cancel();
  for (const int threads : {1, 3}) {
    options.threads = threads;
    try {
      const NoFitTable table(parts, 4, options);
      FAIL() << "a cancelled table was made";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kCancelled);
    }
  }
}

TEST(Turned, TakesTheSmallestInteger) {
  constexpr std::int64_t kSmallest = std::numeric_limits<std::int64_t>::min();
  Region region;
  region.begin_polygon();
  region.begin_ring();
  region.add_vertex(kSmallest, kSmallest);
  region.add_vertex(std::int64_t{0}, kSmallest);
  region.add_vertex(std::int64_t{0}, std::int64_t{0});
  for (int quarters = -1; quarters < 4; ++quarters) {
    Cancellation never;
    EXPECT_EQ(turned(region, quarters, never),
              resolve({transform(region, Affine::quarter_turns(quarters)), {}, {}}).region);
  }
}

}  // namespace
}  // namespace minksum
