// Tests that the sweep over boxes finds every overlapping pair once, and no pair that is far apart.
#include "spatial/box_pairs.hpp"

#include <gtest/gtest.h>

#include <map>

#include "support/random.hpp"

namespace {

using namespace minksum;
using minksum::test::Random;

struct Box {
  double x0, y0, x1, y1;
};
struct Plane {
  double width;
  double height;
};

/// Makes a random box. Most are small; some are points, segments, or as large as the plane.
Box random_box(Random& random, const Plane& plane, double size) {
  const auto unit = [&] { return random.below(1 << 20) / double{(1 << 20) - 1}; };
  const auto range = [&](double most, double& low, double& high) {
    const double reach = random.one_in(5) ? 0 : random.one_in(20) ? 1 : size * unit();
    low = unit() * (1 - reach) * most;
    high = std::min(low + reach * most, most);
  };
  Box box{};
  range(plane.width, box.x0, box.x1);
  range(plane.height, box.y0, box.y1);
  return box;
}

/// Returns the gap between two boxes as a share of the plane; at most 0 if they overlap.
double gap(const Box& a, const Box& b, const Plane& least) {
  const auto part = [](double distance, double whole) {
    return distance <= 0 ? 0 : distance / whole;
  };
  return std::max(part(std::max(a.x0 - b.x1, b.x0 - a.x1), least.width),
                  part(std::max(a.y0 - b.y1, b.y0 - a.y1), least.height));
}

void expect_pairs(const std::vector<Box>& boxes, const Plane& plane, const Plane& resolved,
                  double doubt, BoxPairScratch& scratch) {
  BoxPairs pairs(plane.width, plane.height, doubt, scratch);
  for (const Box& box : boxes) pairs.add(box.x0, box.y0, box.x1, box.y1);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> found;
  Cancellation never;
  ASSERT_TRUE(pairs.sort(never, {}));
  const std::size_t tasks = 1 + boxes.size() % 4;
  for (std::size_t task = 0; task < tasks; ++task) {
    pairs.for_each([&](std::uint32_t a, std::uint32_t b) { ++found[std::minmax(a, b)]; }, never,
                   false, task, tasks);
  }
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
      const double apart = gap(boxes[i], boxes[j], resolved);
      const auto at = found.find({i, j});
      const int times = at == found.end() ? 0 : at->second;
      if (apart == 0) {
        EXPECT_EQ(times, 1) << i << " " << j;
      }
      if (apart > 0x1p-12) {
        EXPECT_EQ(times, 0) << i << " " << j;
      }
      EXPECT_LE(times, 1);
    }
  }
}

TEST(BoxPairs, FindsWhatOverlapsOnceAndNothingFarApart) {
  Random random(1);
  BoxPairScratch scratch;
  for (const int count : {0, 1, 2, 7, 8, 9, 17, 40, 300}) {
    for (const double size : {0.002, 0.05, 0.5}) {
      for (const double scale : {1.0, 0x1p-800, 0x1p60}) {
        const Plane plane{3 * scale, 2 * scale};
        std::vector<Box> boxes;
        for (int i = 0; i < count; ++i) boxes.push_back(random_box(random, plane, size));
        expect_pairs(boxes, plane, plane, 0, scratch);
      }
    }
  }
}

TEST(BoxPairs, ColumnsHoldManyAtOnePlace) {
  BoxPairScratch scratch;
  std::vector<Box> boxes;
  for (int i = 0; i < 100; ++i) {
    const double y = i / 128.0;
    boxes.push_back({0.5, y, i % 3 == 0 ? 1.0 : 0.5, y + 1 / 256.0});
  }
  expect_pairs(boxes, {1, 1}, {1, 1}, 0, scratch);
}

/// The plane has no height, or less than the boxes' errors, so only x tells.
TEST(BoxPairs, FlatPlanesAndDoubts) {
  Random random(2);
  BoxPairScratch scratch;
  for (const double height : {0.0, 0x1p-30}) {
    const Plane plane{1, height};
    std::vector<Box> boxes;
    for (int i = 0; i < 60; ++i) boxes.push_back(random_box(random, plane, 0.1));
    expect_pairs(boxes, plane, {1, 1}, 0x1p-28, scratch);
  }
}

/// The boxes overlap only because each may be off by the doubt.
TEST(BoxPairs, RoundsOutwardsByMoreThanTheDoubt) {
  BoxPairScratch scratch;
  const double doubt = 0x1p-22;
  const std::vector<Box> boxes{{0, 0, 0.5, 1}, {0.5 + 2 * doubt, 0, 1, 1}};
  BoxPairs pairs(1, 1, doubt, scratch);
  for (const Box& box : boxes) pairs.add(box.x0, box.y0, box.x1, box.y1);
  int found = 0;
  Cancellation never;
  ASSERT_TRUE(pairs.sort(never, {}));
  pairs.for_each([&](std::uint32_t, std::uint32_t) { ++found; }, never, false);
  EXPECT_EQ(found, 1);
}

/// Counts the pairs that are visited where each box may overlap so many in x, and so many at all.
std::size_t count_pairs(const std::vector<Box>& boxes, const BoxPairs::Most& most) {
  BoxPairScratch scratch;
  BoxPairs pairs(1, 1, 0, scratch);
  for (const Box& box : boxes) pairs.add(box.x0, box.y0, box.x1, box.y1);
  std::size_t found = 0;
  Cancellation never;
  if (!pairs.sort(never, most)) return 0;
  pairs.for_each([&](std::uint32_t, std::uint32_t) { ++found; }, never, false);
  return found;
}

TEST(BoxPairs, VisitsNoneWhereThereAreTooMany) {
  // Boxes above one another, which do not overlap.
  std::vector<Box> boxes;
  for (int i = 0; i < 100; ++i) boxes.push_back({0, i / 100.0, 1, (i + 0.5) / 100.0});
  boxes.push_back({0, 0, 1, 1});
  EXPECT_EQ(count_pairs(boxes, {}), 100U);
  EXPECT_EQ(count_pairs(boxes, {.in_x = 51}), 100U);
  EXPECT_EQ(count_pairs(boxes, {.in_x = 49}), 0U);
  EXPECT_EQ(count_pairs(boxes, {.overlaps = 2}), 100U);
  // Boxes that are small beside the plane, and all lie in one place.
  std::vector<Box> crowd;
  for (int i = 0; i < 100; ++i) crowd.push_back({i * 1e-9, 0, (i + 0.5) * 1e-9, 1e-9});
  EXPECT_EQ(count_pairs(crowd, {.overlaps = 51}), 100U * 99 / 2);
  EXPECT_EQ(count_pairs(crowd, {.overlaps = 40}), 0U);
}

}  // namespace
