// Tests that meetings of segments are as defined, by every kind of vectors.
#include "sum/small/small_meetings.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "support/random.hpp"

namespace minksum {
namespace {

using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

struct Meetings {
  Pairs right;
  Pairs at_end;
  friend bool operator==(const Meetings&, const Meetings&) = default;
};

std::unique_ptr<SmallSegments> random_segments(test::Random& random, std::uint32_t count,
                                               int size) {
  auto s = std::make_unique<SmallSegments>();
  s->size = count;
  for (std::uint32_t i = 0; i < count; ++i) {
    s->x[i] = random.between(4, size + 4);
    s->y[i] = random.between(4, size + 4);
    do {
      s->dx[i] = random.between(-4, 4);
      s->dy[i] = random.between(-4, 4);
    } while (s->dx[i] == 0 && s->dy[i] == 0);
  }
  s->finish();
  return s;
}

/// Returns the meetings of each segment s with others t by their definition. In `right`, t leads
/// from the left of s, or from s itself, to its right, behind the start of s. In `at_end`, t leads
/// from the end of s to the left, or both are on one line. Of the latter, those that lie elsewhere
/// may be missing.
Meetings defined(const SmallSegments& s) {
  Meetings result;
  for (std::uint32_t i = 0; i < s.size; ++i) {
    for (std::uint32_t t = 0; t < s.size; ++t) {
      if (t == i) continue;
      const auto side = [&](double x, double y) {
        return s.dx[i] * (y - s.y[i]) - s.dy[i] * (x - s.x[i]);
      };
      const double start = side(s.x[t], s.y[t]);
      const double end = side(s.x[t] + s.dx[t], s.y[t] + s.dy[t]);
      if (start == end) continue;
      // `way` is where t meets the line, as a share of the length of i. Both are multiplied by one
      // positive number, so that all are small integers.
      const double sign = start > end ? 1 : -1;
      const double whole = sign * (start - end) * (s.dx[i] * s.dx[i] + s.dy[i] * s.dy[i]);
      const double x = (s.x[t] - s.x[i]) * (start - end) + start * s.dx[t];
      const double y = (s.y[t] - s.y[i]) * (start - end) + start * s.dy[t];
      const double way = sign * (x * s.dx[i] + y * s.dy[i]);
      if (start >= 0 && end < 0 && way > 0 && way <= whole) result.right.emplace(i, t);
      if (start <= 0 && end > 0 && way == whole) result.at_end.emplace(i, t);
    }
  }
  return result;
}

/// Leaves out the meetings on one line and those at the end, which may be found or not.
template <class Number>
Meetings found(Vectors vectors, const SmallSegments& s) {
  const auto meetings = std::make_unique<SmallMeetings>();
  EXPECT_TRUE(find_meetings_by<Number>(vectors, s, *meetings));
  Meetings result;
  std::set<std::size_t> numbers;
  for (std::uint32_t i = 0; i < s.size; ++i) {
    meetings->for_each_right(i, [&](std::uint32_t t, std::size_t number) {
      EXPECT_TRUE(numbers.insert(number).second);
      EXPECT_TRUE(result.right.emplace(i, t).second);
    });
    meetings->for_each_at_end(i, [&](std::uint32_t t) {
      const Number turn = cross(whole_numbers<Number>({s.dx[i], s.dy[i]}),
                                whole_numbers<Number>({s.dx[t], s.dy[t]}));
      const bool ends_there =
          s.x[t] + s.dx[t] == s.x[i] + s.dx[i] && s.y[t] + s.dy[t] == s.y[i] + s.dy[i];
      if (turn != 0 && !ends_there) {
        EXPECT_TRUE(result.at_end.emplace(i, t).second);
      }
    });
  }
  EXPECT_EQ(meetings->right_count, numbers.size());
  return result;
}

std::vector<Vectors> available() {
  std::vector<Vectors> all{Vectors::kPlain};
  if (widest_vectors() != Vectors::kPlain) all.push_back(Vectors::kAvx2);
  if (widest_vectors() == Vectors::kAvx512) all.push_back(Vectors::kAvx512);
  return all;
}

TEST(SmallMeetings, AreTheSameByAllVectors) {
  test::Random random(3);
  for (int k = 0; k < 400; ++k) {
    const auto count = static_cast<std::uint32_t>(random.between(1, 64));
    const auto s = random_segments(random, count, random.between(6, 20) + static_cast<int>(count));
    const Meetings expected = defined(*s);
    if (expected.right.size() > count / 2) continue;  // too many meetings are given up
    for (const Vectors vectors : available()) {
      EXPECT_EQ(found<double>(vectors, *s), expected) << k;
      EXPECT_EQ(found<Int128>(vectors, *s), expected) << k;
    }
  }
}

/// Makes all directions nearly equal. That changes no cross product, but doubles round the products
/// that it is the difference of.
void shear(SmallSegments& s) {
  constexpr double kSteep = 0x1p20;
  for (std::uint32_t i = 0; i < s.size; ++i) {
    s.x[i] += kSteep * s.y[i];
    s.y[i] += kSteep * s.x[i];
    s.dx[i] += kSteep * s.dy[i];
    s.dy[i] += kSteep * s.dx[i];
  }
  s.finish();
}

TEST(SmallMeetings, AreTheSameWhereDoublesRound) {
  test::Random random(7);
  for (int k = 0; k < 400; ++k) {
    const auto count = static_cast<std::uint32_t>(random.between(1, 64));
    const auto s = random_segments(random, count, random.between(6, 20) + static_cast<int>(count));
    const Meetings expected = defined(*s);
    if (expected.right.size() > count / 2) continue;  // too many meetings are given up
    shear(*s);
    for (const Vectors vectors : available()) {
      EXPECT_EQ(found<Int128>(vectors, *s), expected) << k;
    }
  }
}

TEST(SmallMeetings, AreOfAnyNumberOfSegments) {
  test::Random random(4);
  const auto s = std::make_unique<SmallSegments>();
  const auto order = std::make_unique<SmallOrder>();
  for (const std::uint32_t count : {65U, 127U, 128U, 500U, 513U, 1200U, 1536U}) {
    const int size = static_cast<int>(count);
    // In random order, most blocks would be near one another.
    order->apply(*random_segments(random, count, size), size + 8, *s);
    const Meetings expected = defined(*s);
    for (const Vectors vectors : available()) {
      EXPECT_EQ(found<double>(vectors, *s), expected) << count;
    }
  }
}

TEST(SmallMeetings, AreGivenUpWhereThereAreMany) {
  test::Random random(5);
  const auto few = random_segments(random, 64, 2);
  const auto many = random_segments(random, 1000, 8);
  const auto meetings = std::make_unique<SmallMeetings>();
  for (const Vectors vectors : available()) {
    EXPECT_FALSE(find_meetings_by<double>(vectors, *few, *meetings));
    EXPECT_FALSE(find_meetings_by<double>(vectors, *many, *meetings));
  }
}

TEST(SmallOrder, PutsNeighboursTogether) {
  test::Random random(6);
  const auto s = random_segments(random, 700, 1000);
  for (std::uint32_t i = 0; i < s->size; ++i) {
    s->origin[i] = {static_cast<std::uint16_t>(i), 0, true};
  }
  const auto ordered = std::make_unique<SmallSegments>();
  const auto order = std::make_unique<SmallOrder>();
  order->apply(*s, 1008, *ordered);
  ASSERT_EQ(ordered->size, s->size);
  std::set<std::uint16_t> all;
  double way = 0;
  double way_before = 0;
  for (std::uint32_t k = 0; k < s->size; ++k) {
    const std::uint16_t i = ordered->origin[k].edge;
    EXPECT_TRUE(all.insert(i).second);
    EXPECT_EQ(ordered->x[k], s->x[i]);
    EXPECT_EQ(ordered->y[k], s->y[i]);
    EXPECT_EQ(ordered->dx[k], s->dx[i]);
    EXPECT_EQ(ordered->dy[k], s->dy[i]);
    if (k == 0) continue;
    way +=
        std::abs(ordered->x[k] - ordered->x[k - 1]) + std::abs(ordered->y[k] - ordered->y[k - 1]);
    way_before += std::abs(s->x[k] - s->x[k - 1]) + std::abs(s->y[k] - s->y[k - 1]);
  }
  EXPECT_LT(way, way_before / 4);
}

}  // namespace
}  // namespace minksum
