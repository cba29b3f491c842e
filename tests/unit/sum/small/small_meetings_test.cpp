// Tests that meetings of segments are as defined, by every kind of vectors.
#include "sum/small/small_meetings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "support/random.hpp"

namespace minksum {
namespace {

using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

struct MeetingSets {
  Pairs right;
  Pairs at_end;
  friend bool operator==(const MeetingSets&, const MeetingSets&) = default;
};

std::unique_ptr<SmallSegments> random_segments(test::Random& random, std::uint32_t count,
                                               int size) {
  auto s = std::make_unique_for_overwrite<SmallSegments>();
  s->size = count;
  for (std::uint32_t i = 0; i < count; ++i) {
    s->x[i] = random.between(4, size + 4);
    s->y[i] = random.between(4, size + 4);
    do {
      s->dx[i] = random.between(-4, 4);
      s->dy[i] = random.between(-4, 4);
    } while (s->dx[i] == 0 && s->dy[i] == 0);
  }
  s->left_out = 0;
  s->wide = false;
  s->in_part = false;
  s->finish(0);
  return s;
}

/// Returns the meetings of each segment s with others t by their definition. In `right`, t leads
/// from the left of s, or from s itself, to its right, behind the start of s. In `at_end`, t leads
/// from the end of s to the left, or both are on one line. Of the latter, those that lie elsewhere
/// may be missing.
MeetingSets defined(const SmallSegments& s) {
  MeetingSets result;
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
std::optional<MeetingSets> found(Vectors vectors, const SmallNumbers<Number>& numbers,
                                 const SmallSegments& s) {
  const auto meetings = std::make_unique<SmallMeetings>();
  if (!find_meetings_by(vectors, numbers, s, *meetings)) return std::nullopt;
  const auto lanes = sure_lanes(numbers);
  MeetingSets result;
  std::set<std::size_t> seen;
  for (std::uint32_t i = 0; i < s.size; ++i) {
    meetings->for_each_right(i, [&](std::uint32_t t, std::size_t number) {
      EXPECT_TRUE(seen.insert(number).second);
      EXPECT_TRUE(result.right.emplace(i, t).second);
    });
    meetings->for_each_at_end(i, [&](std::uint32_t t) {
      const auto end = [&](std::uint32_t k) {
        return plus(lanes.get(s.at(), k), lanes.get(s.way(), k));
      };
      const double turn = lanes.turn(lanes.get(s.way(), i), lanes.get(s.way(), t));
      if (turn != 0 && !are_equal(end(i), end(t))) {
        EXPECT_TRUE(result.at_end.emplace(i, t).second);
      }
    });
  }
  EXPECT_EQ(meetings->right_count, seen.size());
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
    const MeetingSets expected = defined(*s);
    if (expected.right.size() > count / 2) continue;  // too many meetings are given up
    for (const Vectors vectors : available()) {
      EXPECT_EQ(found(vectors, SmallNumbers<double>{}, *s), expected) << k;
      EXPECT_EQ(found(vectors, SmallNumbers<std::uint64_t>{}, *s), expected) << k;
    }
  }
}

/// Operands that have random segments as edges, each moved by nothing.
struct EdgesAndVertex {
  SmallOperand edges;
  SmallOperand vertex;
};

/// Makes all directions nearly equal. That changes no cross product, but doubles round the products
/// that it is the difference of. If the numbers are wide, doubles round coordinates, too, which are
/// multiplied by a power of two.
template <class Number>
void shear(SmallSegments& s, int bits, int twos, const SmallNumbers<Number>& numbers,
           EdgesAndVertex& operands) {
  const Int128 steep = Int128{1} << bits;
  const auto apply = [&](double& x, double& y) {
    Vec<Int128> whole{static_cast<Int128>(x), static_cast<Int128>(y)};
    whole.x += steep * whole.y;
    whole.y += steep * whole.x;
    x = std::ldexp(static_cast<double>(whole.x), twos);
    y = std::ldexp(static_cast<double>(whole.y), twos);
    return whole;
  };
  SmallOperand& edges = operands.edges;
  edges.size = 2 * s.size;
  edges.ends = {edges.size};
  edges.make_rows(edges.size, true, false);
  edges.steps = Int128{1} << twos;
  operands.vertex.size = 1;
  operands.vertex.ends = {1};
  operands.vertex.make_rows(1, true, false);
  operands.vertex.whole()[0] = {};
  s.operands = {&operands.vertex, &edges};
  for (std::uint32_t i = 0; i < s.size; ++i) {
    // Half of the segments do not tell which ends are the same.
    const bool known = i % 2 == 0;
    s.start[i] = known ? 1000 * s.x[i] + s.y[i] : -1.0 - 2 * i;
    s.end[i] = known ? 1000 * (s.x[i] + s.dx[i]) + s.y[i] + s.dy[i] : -2.0 - 2 * i;
    const Vec<Int128> start = apply(s.x[i], s.y[i]);
    const Vec<Int128> way = apply(s.dx[i], s.dy[i]);
    edges.whole()[std::size_t{2} * i] = start;
    edges.whole()[std::size_t{2} * i + 1] = {start.x + way.x, start.y + way.y};
    s.origin[i] = {2 * i, 0, true};
  }
  s.wide = std::is_same_v<Number, WideNumber>;
  s.in_part = false;
  s.finish(numbers.reach);
}

/// Expects that segments that are sheared meet as before.
template <class Number>
void expect_same_meetings(std::uint64_t seed, int bits, int twos,
                          const SmallNumbers<Number>& numbers) {
  test::Random random(seed);
  int compared = 0;
  for (int k = 0; k < 400; ++k) {
    const auto count = static_cast<std::uint32_t>(random.between(1, 64));
    const auto s = random_segments(random, count, random.between(6, 20) + static_cast<int>(count));
    const MeetingSets expected = defined(*s);
    if (expected.right.size() > count / 2) continue;  // too many meetings are given up
    EdgesAndVertex operands;
    shear(*s, bits, twos, numbers, operands);
    for (const Vectors vectors : available()) {
      // Where all pairs are near one another, and doubles decide none, many are given up.
      if (const auto met = found(vectors, numbers, *s)) {
        EXPECT_EQ(*met, expected) << k;
        compared += vectors == Vectors::kPlain ? 1 : 0;
      } else {
        EXPECT_GT(count, 16U);
      }
    }
  }
  EXPECT_GT(compared, 40);
}

TEST(SmallMeetings, AreTheSameWhereDoublesRound) {
  expect_same_meetings(7, 20, 0, SmallNumbers<std::uint64_t>{});
}

TEST(SmallMeetings, AreTheSameWhereDoublesRoundCoordinates) {
  // Coordinates have up to 250 bits. With few, doubles tell most signs.
  for (const int bits : {1, 10, 23, 24, 38, 39, 59}) {
    for (const int twos : {0, 7, 125}) {
      const double width = std::ldexp(128, 2 * bits + twos);
      expect_same_meetings(8, bits, twos, SmallNumbers<WideNumber>{0x1p-48 * width});
    }
  }
}

TEST(SmallMeetings, AreOfAnyNumberOfSegments) {
  test::Random random(4);
  const auto s = std::make_unique_for_overwrite<SmallSegments>();
  const auto order = std::make_unique<SmallOrder>();
  for (const std::uint32_t count : {65U, 127U, 128U, 500U, 513U, 1200U, 1536U, 5000U}) {
    const int size = static_cast<int>(count);
    // In random order, most blocks would be near one another.
    order->apply(*random_segments(random, count, size), {size + 8.0, size + 8.0}, 0, *s);
    const MeetingSets expected = defined(*s);
    for (const Vectors vectors : available()) {
      EXPECT_EQ(found(vectors, SmallNumbers<double>{}, *s), expected) << count;
    }
  }
}

TEST(SmallMeetings, AreGivenUpWhereThereAreMany) {
  test::Random random(5);
  const auto few = random_segments(random, 64, 2);
  const auto many = random_segments(random, 1000, 8);
  const auto meetings = std::make_unique<SmallMeetings>();
  for (const Vectors vectors : available()) {
    EXPECT_FALSE(find_meetings_by(vectors, SmallNumbers<double>{}, *few, *meetings));
    EXPECT_FALSE(find_meetings_by(vectors, SmallNumbers<double>{}, *many, *meetings));
  }
}

/// Orders 700 segments whose x coordinates are multiplied by a factor.
void expect_neighbours_together(double factor) {
  test::Random random(6);
  const auto s = random_segments(random, 700, 1000);
  for (std::uint32_t i = 0; i < s->size; ++i) {
    s->x[i] *= factor;
    s->dx[i] *= factor;
  }
  for (std::uint32_t i = 0; i < s->size; ++i) {
    s->origin[i] = {i, 0, true};
  }
  const auto ordered = std::make_unique_for_overwrite<SmallSegments>();
  const auto order = std::make_unique<SmallOrder>();
  order->apply(*s, {1008 * factor, 1008}, 0, *ordered);
  ASSERT_EQ(ordered->size, s->size);
  std::set<std::uint32_t> all;
  double way = 0;
  double way_before = 0;
  for (std::uint32_t k = 0; k < s->size; ++k) {
    const std::uint32_t i = ordered->origin[k].edge;
    EXPECT_TRUE(all.insert(i).second);
    EXPECT_EQ(ordered->x[k], s->x[i]);
    EXPECT_EQ(ordered->y[k], s->y[i]);
    EXPECT_EQ(ordered->dx[k], s->dx[i]);
    EXPECT_EQ(ordered->dy[k], s->dy[i]);
    if (k == 0) continue;
    const auto way_to = [&](const SmallSegments& of) {
      return std::abs(of.x[k] - of.x[k - 1]) / factor + std::abs(of.y[k] - of.y[k - 1]);
    };
    way += way_to(*ordered);
    way_before += way_to(*s);
  }
  EXPECT_LT(way, way_before / 4) << factor;
}

TEST(SmallOrder, PutsNeighboursTogether) {
  for (const double factor : {1.0, 0x1p-12, 0x1p20}) expect_neighbours_together(factor);
}

}  // namespace
}  // namespace minksum
