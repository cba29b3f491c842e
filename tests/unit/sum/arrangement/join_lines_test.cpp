// Tests that overlapping segments of one direction are joined, and that their union stays the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

#include "minksum/minkowski_sum.hpp"
#include "minksum/resolve.hpp"
#include "minksum/testing.hpp"
#include "sum/arrangement/arrangement.hpp"
#include "support/polygon_kinds.hpp"
#include "support/shapes.hpp"
#include "unit/sum/prepare_operands.hpp"

namespace {

using namespace minksum;
using namespace minksum::test;

/// The covered part of each line, by line and direction, as maximal intervals along x + 1000 y. All
/// segments of the tests run along an axis.
using Union = std::map<std::tuple<double, double, double>, std::vector<std::pair<double, double>>>;
Union union_of(const std::vector<KeptSegment>& segments) {
  Union result;
  for (const KeptSegment& s : segments) {
    const bool across = s.d.y == 0;
    const double sense = across ? (s.d.x > 0 ? 1 : -1) : (s.d.y > 0 ? 2 : -2);
    auto [a, b] = across ? std::minmax(s.a.x, s.b.x) : std::minmax(s.a.y, s.b.y);
    result[{sense, across ? s.a.y : s.a.x, 0}].emplace_back(a, b);
  }
  for (auto& [line, intervals] : result) {
    std::sort(intervals.begin(), intervals.end());
    std::vector<std::pair<double, double>> merged;
    for (const auto& [a, b] : intervals) {
      if (!merged.empty() && a <= merged.back().second) {
        merged.back().second = std::max(merged.back().second, b);
      } else {
        merged.emplace_back(a, b);
      }
    }
    intervals = merged;
  }
  return result;
}

std::vector<KeptSegment> segments_of(const Operands& o, const Convolution& convolution) {
  std::vector<KeptSegment> kept;
  const auto& [x, y, dx, dy, next] = o.sites;
  for (const Segment& s : convolution.segments) {
    const SiteId f = next[s.edge];
    kept.push_back({{x[s.edge] + x[s.vertex], y[s.edge] + y[s.vertex]},
                    {x[f] + x[s.vertex], y[f] + y[s.vertex]},
                    {dx[s.edge], dy[s.edge]},
                    s,
                    0,
                    o.place[o.rank[s.edge]],
                    o.rank[s.edge],
                    false,
                    {}});
  }
  return kept;
}

/// Returns the parts that clips leave. Ends are whole steps but for a clip's margin.
std::vector<KeptSegment> clipped(std::vector<KeptSegment> segments) {
  for (KeptSegment& s : segments) {
    const auto [a, b] = s.clipped();
    s.a = {std::round(a.x), std::round(a.y)};
    s.b = {std::round(b.x), std::round(b.y)};
  }
  return segments;
}

/// Returns a comb whose teeth and gaps are two wide. The sum of two has many coinciding edges.
Region comb(int teeth) {
  std::vector<std::pair<int, int>> points{{0, 0}, {4 * teeth, 0}};
  for (int i = teeth - 1; i >= 0; --i) {
    for (const auto& p : {std::pair{4 * i + 4, 10}, {4 * i + 2, 10}, {4 * i + 2, 2}, {4 * i, 2}}) {
      if (i > 0 || p.first > 0) points.push_back(p);
    }
  }
  points.emplace_back(0, 2);
  Region region;
  region.begin_polygon();
  region.begin_ring();
  for (const auto& [x, y] : points) region.add_vertex(x, y);
  return region;
}

TEST(JoinLines, KeepsTheUnionAndItsMembersCoverIt) {
  const SumSettings options;
  Operands o;
  ConvolutionScratch convolution_scratch;
  Convolution convolution;
  prepare_operands(comb(9), comb(7), options, o);
  Cancellation never;
  reduced_convolution(o, options.limits, never, convolution_scratch, convolution);
  const std::vector<KeptSegment> before = segments_of(o, convolution);
  std::vector<KeptSegment> after = before;
  JoinScratch scratch;
  join_lines(o, never, scratch, after);
  EXPECT_LT(2 * after.size(), before.size());
  EXPECT_EQ(union_of(after), union_of(before));
  EXPECT_GE(scratch.joined.size(), 2U);
  for (const KeptSegment& s : after) {
    if (s.joined == 0) continue;
    const JoinedSegments& joined = scratch.joined[s.joined - 1];
    ASSERT_GE(joined.end - joined.first, 2U);
    const std::vector<KeptSegment> members(scratch.members.begin() + joined.first,
                                           scratch.members.begin() + joined.end);
    EXPECT_EQ(union_of(members), union_of({s}));
    EXPECT_EQ(members.front().segment, s.segment);
    EXPECT_EQ(members.back().segment, joined.last);
  }
}

TEST(JoinLines, JoinsWhatClippingLeaves) {
  Operands o;
  ConvolutionScratch convolution_scratch;
  Convolution convolution;
  prepare_operands(comb(9), comb(7), {}, o);
  Cancellation never;
  reduced_convolution(o, {}, never, convolution_scratch, convolution);
  Random random(3);
  for (int i = 0; i < 20; ++i) {
    std::vector<KeptSegment> kept = segments_of(o, convolution);
    // All edges are of even length, so halves end at whole steps.
    for (KeptSegment& s : kept) {
      s.clip = std::array{Clip{0, 1}, Clip{0, 0.5F}, Clip{0.5F, 1}}[random.next() % 3];
    }
    const Union before = union_of(clipped(kept));
    JoinScratch scratch;
    join_lines(o, never, scratch, kept);
    EXPECT_EQ(union_of(clipped(kept)), before);
    std::size_t intervals = 0;
    for (const auto& [line, on_line] : before) intervals += on_line.size();
    EXPECT_EQ(kept.size(), intervals);
    EXPECT_GE(scratch.joined.size(), 2U);
  }
}

/// Maps with determinant 1, so that vectors of few bits become long and nearly parallel. Doubles
/// then decide little.
Point sheared(const Point& p) {
  const Rational big(433494437);   // Fibonacci's, F(43)
  const Rational more(267914296);  // F(42)
  const Rational less(165580141);  // F(41)
  return {big * p.x + more * p.y, more * p.x + less * p.y};
}

TEST(JoinLines, SumsOfLargeCoordinatesAreImagesOfThoseOfSmallOnes) {
  Random random(7);
  int joined_sums = 0;
  for (int i = 0; i < 60; ++i) {
    const bool halves = i % 2 == 1;
    const Region p = random_cells(random, 5, 4, halves, false);
    const Region q = i % 3 == 0 ? comb(4) : random_cells(random, 3, 4, halves, false);
    const Region sum = minkowski_sum(p, q);
    for (const std::function<Point(const Point&)>& map :
         {std::function<Point(const Point&)>(sheared),
          std::function<Point(const Point&)>([](const Point& a) {
            const Rational factor(std::int64_t{1} << 40);
            return Point{a.x * factor, a.y * (factor - Rational(1))};
          })}) {
      const Region image_p = transformed(p, map);
      const Region image_q = transformed(q, map);
      Operands o;
      prepare_operands(image_p, image_q, {}, o);
      ConvolutionScratch scratch;
      Convolution convolution;
      Cancellation never;
      reduced_convolution(o, {}, never, scratch, convolution);
      ASSERT_GT(o.bits, 25);
      JoinScratch join;
      std::vector<KeptSegment> kept = segments_of(o, convolution);
      join_lines(o, never, join, kept);
      if (!join.joined.empty()) ++joined_sums;
      SumSettings options;
      options.check = true;
      EXPECT_EQ(minkowski_sum(image_p, image_q, options),
                resolve({transformed(sum, map), {}, {}}).region)
          << "case " << i;
    }
  }
  EXPECT_GT(joined_sums, 60);
}

TEST(JoinLines, SumsAreClippedAndJoined) {
  // Most of the comb's edges, moved by a corner of the square, are on few lines and inside the sum.
  SumSettings options;
  options.small = false;
  const Statistics counts = detailed_sum(comb(20), rectangle(0, 0, 70, 70), options).statistics;
  EXPECT_EQ(counts.convolution_segments, 125U);
  EXPECT_LT(counts.by_filter, 1000U);  // 7,078 where clipped segments are not joined
}

TEST(JoinLines, LeavesSegmentsOfManyDirections) {
  const SumSettings options;
  Operands o;
  ConvolutionScratch convolution_scratch;
  Convolution convolution;
  Random random(1);
  prepare_operands(random_two_opt(random, 40, 1000), random_two_opt(random, 40, 1000), options, o);
  Cancellation never;
  reduced_convolution(o, options.limits, never, convolution_scratch, convolution);
  std::vector<KeptSegment> kept = segments_of(o, convolution);
  JoinScratch scratch;
  join_lines(o, never, scratch, kept);
  EXPECT_TRUE(scratch.joined.empty());
  EXPECT_EQ(kept.size(), convolution.segments.size());
}

}  // namespace
