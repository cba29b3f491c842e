// Tests the call for sums of geometries: how it reads operands, what it refuses and reports.
#include <gtest/gtest.h>

#include <string>

#include "minksum/minkowski_sum.hpp"
#include "minksum/resolve.hpp"
#include "minksum/testing.hpp"
#include "support/geometries.hpp"
#include "support/polygon_kinds.hpp"
#include "support/random.hpp"

namespace {

using namespace minksum;
using namespace minksum::test;

const Region kBowTie = make_polygon({{0, 0}, {4, 4}, {4, 0}, {0, 4}});
const Region kSquare = rectangle(0, 0, 2, 2);

SumSettings with_fill(FillRule rule) {
  SumSettings options;
  options.fill = rule;
  return options;
}

TEST(GeometrySum, OriginsAreThereIfOperandsAreUsedAsGiven) {
  const Geometry square{kSquare, {}, {}};
  const Geometry sum = minkowski_sum(square, square);
  EXPECT_TRUE(sum.region.has_origins());
  EXPECT_EQ(sum.region, minkowski_sum(kSquare, kSquare));
  EXPECT_FALSE(minkowski_sum(Geometry{kBowTie, {}, {}}, square).region.has_origins());
  EXPECT_FALSE(minkowski_sum(square, make_lines({{{0, 0}, {1, 3}}})).region.has_origins());
  EXPECT_FALSE(minkowski_sum(square, make_lines({}, {{0, 0}})).region.has_origins());
  EXPECT_FALSE(
      minkowski_sum(square, square, with_fill(FillRule::kNonZero)).region.has_origins());
}

TEST(GeometrySum, FillRulesSayWhatRingsMean) {
  // Two rings of one direction are nested: the inner one is a hole by parity, but not by winding.
  Region nested;
  nested.begin_polygon();
  for (const std::int64_t k : {0, 3}) {
    nested.begin_ring();
    for (const auto& [x, y] : Outline{{k, k}, {9 - k, k}, {9 - k, 9 - k}, {k, 9 - k}}) {
      nested.add_vertex(x, y);
    }
  }
  const Geometry p{nested, {}, {}};
  const Geometry q{rectangle(0, 0, 1, 1), {}, {}};
  const Region solid = rectangle(0, 0, 10, 10);
  const Region hollow =
      make_polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{{4, 4}, {4, 6}, {6, 6}, {6, 4}}});
  const auto sum = [&](FillRule rule) { return to_text(minkowski_sum(p, q, with_fill(rule))); };
  EXPECT_EQ(sum(FillRule::kNonZero), to_text(solid));
  EXPECT_EQ(sum(FillRule::kPositive), to_text(solid));
  EXPECT_EQ(sum(FillRule::kEvenOdd), to_text(hollow));
  EXPECT_EQ(sum(FillRule::kAutomatic), to_text(hollow));
  EXPECT_EQ(sum(FillRule::kStrict), to_text(hollow));
}

TEST(GeometrySum, SpikesAreSweptUnlessRegularized) {
  const Geometry spiked{make_polygon({{0, 0}, {4, 0}, {9, 0}, {4, 0}, {4, 4}, {0, 4}}), {}, {}};
  const Geometry unit{rectangle(0, 0, 1, 1), {}, {}};
  EXPECT_EQ(to_text(minkowski_sum(spiked, unit)),
            to_text(make_polygon({{0, 0}, {10, 0}, {10, 1}, {5, 1}, {5, 5}, {0, 5}})));
  SumSettings options;
  options.regularize = true;
  EXPECT_EQ(to_text(minkowski_sum(spiked, unit, options)), to_text(rectangle(0, 0, 5, 5)));
}

TEST(GeometrySum, ThinSumsAreResolved) {
  const Geometry cross = minkowski_sum(make_lines({{{0, 0}, {4, 0}}}, {{0, 9}, {1, 9}}),
                                       make_lines({{{0, 0}, {2, 0}}, {{0, 0}, {0, 1}}}));
  // The sum is a rectangle, the paths that stick out of it, and the translates of the points above.
  EXPECT_EQ(to_text(cross),
            "MULTIPOLYGON (((0 0, 4 0, 4 1, 0 1, 0 0))) LINESTRING (0 10, 0 9, 1 9) "
            "LINESTRING (1 9, 1 10) LINESTRING (1 9, 3 9) LINESTRING (4 0, 6 0)");
}

/// Returns a path that crosses, covers and touches itself, turns back and repeats vertices.
Polyline tangle(Random& random, int count, int size) {
  Polyline path;
  while (static_cast<int>(path.size()) < count) {
    const int x = random.below(size);
    const int y = random.below(size);
    path.push_back({x, y});
    if (random.below(5) == 0) path.push_back(path.back());
    if (random.below(5) == 0 && path.size() > 2) path.push_back(path[path.size() - 2]);
    if (random.below(6) == 0) path.push_back(path.front());
    if (random.below(4) == 0) path.push_back({x + 2, y});
    if (random.below(4) == 0) path.push_back({x + 3, y});
  }
  return path;
}

TEST(GeometrySum, CrossingsOfPolylinesNeedNoVertices) {
  Random random(40401);
  for (int i = 0; i < 150; ++i) {
    const int size = i % 3 == 0 ? 5 : 40;
    Geometry p{{}, {tangle(random, 6, size), tangle(random, 3, size)}, {}};
    Geometry q{{}, {tangle(random, 6, size)}, {}};
    if (i % 4 == 1) p.region = random_two_opt(random, 8, size);
    if (i % 4 == 2) q = {random_two_opt(random, 8, size), {}, {}};
    if (i % 5 == 3) p.points.push_back({random.below(size), random.below(size)});
    // In resolved operands each crossing is a vertex.
    const Geometry expected = minkowski_sum(resolve(p), resolve(q));
    for (const Method method : {Method::kReduced, Method::kSigned}) {
      SumSettings options;
      options.method = method;
      options.check = true;
      EXPECT_EQ(minkowski_sum(p, q, options), expected) << to_text(p) << '\n' << to_text(q);
    }
  }
}

TEST(GeometrySum, PolylinesWithoutPolygonsStayWholeByEveryRule) {
  Random random(40402);
  const Geometry path{{}, {tangle(random, 40, 1000)}, {}};
  const Geometry expected = minkowski_sum(path, path);
  SumSettings options;
  options.limits.max_segments = 50'000;  // cut at its crossings, the path has over a million
  for (const FillRule rule : {FillRule::kNonZero, FillRule::kEvenOdd, FillRule::kPositive,
                              FillRule::kNegative, FillRule::kStrict}) {
    options.fill = rule;
    EXPECT_EQ(minkowski_sum(path, path, options), expected) << to_string(rule);
  }
}

TEST(GeometrySum, StrictRefusesWithThePlace) {
  const Geometry square{kSquare, {}, {}};
  const Geometry bow_tie{kBowTie, {}, {}};
  Workspace workspace;
  Geometry sum = square;
  const SumSettings strict = with_fill(FillRule::kStrict);
  for (const int operand : {0, 1}) {
    const Outcome outcome = minkowski_sum(operand == 0 ? bow_tie : square,
                                          operand == 0 ? square : bow_tie, strict, workspace, sum);
    ASSERT_FALSE(outcome.ok());
    EXPECT_EQ(outcome.error->code(), ErrorCode::kBadInput);
    EXPECT_EQ(outcome.error->culprit().operand, operand);
    EXPECT_EQ(outcome.error->culprit().ring, 0U);
    EXPECT_TRUE(sum.empty());
  }
  // The rule is also strict beside an empty operand, but thin parts are not faults.
  EXPECT_FALSE(minkowski_sum(bow_tie, Geometry{}, strict, workspace, sum).ok());
  Geometry flagged = square;
  flagged.polylines = make_lines({{{2, 2}, {5, 2}}}).polylines;
  ASSERT_TRUE(minkowski_sum(flagged, square, strict, workspace, sum).ok());
  EXPECT_EQ(to_text(sum), to_text(make_polygon(
                              {{0, 0}, {4, 0}, {4, 2}, {7, 2}, {7, 4}, {0, 4}})));
}

TEST(GeometrySum, AWorkspaceServesAllKindsInTurn) {
  const std::vector<Geometry> operands{{kSquare, {}, {}},
                                       {kBowTie, {}, {}},
                                       make_lines({{{0, 0}, {3, 1}, {4, 5}}}, {{8, 8}}),
                                       make_lines({{{0, 0}, {5, 0}}}),
                                       make_lines({}, {{1, 2}, {3, 3}}),
                                       {}};
  Workspace workspace;
  Geometry sum;
  for (const Geometry& p : operands) {
    for (const Geometry& q : operands) {
      ASSERT_TRUE(minkowski_sum(p, q, Options{}, workspace, sum).ok());
      EXPECT_EQ(to_text(sum), to_text(minkowski_sum(p, q)));
      EXPECT_EQ(sum.empty(), p.empty() || q.empty());
    }
  }
}

TEST(GeometrySum, LimitsHoldForThinPartsToo) {
  SumSettings options;
  options.limits.max_segments = 3;
  Workspace workspace;
  Geometry sum;
  const Geometry square{kSquare, {}, {}};
  const Geometry zig = make_lines({{{0, 0}, {3, 1}, {0, 2}, {3, 3}}});
  const Geometry across = make_lines({{{0, 0}, {1, 0}}, {{0, 1}, {1, 1}}});
  const Geometry dots = make_lines({}, {{0, 0}, {5, 5}, {9, 9}});
  for (const auto& [p, q] : {std::pair{square, zig}, {zig, zig}, {across, across}, {square, dots},
                             {dots, zig}}) {
    for (const Method method : {Method::kReduced, Method::kSigned}) {
      options.method = method;
      const Outcome outcome = minkowski_sum(p, q, options, workspace, sum);
      ASSERT_FALSE(outcome.ok()) << to_text(p) << ' ' << to_text(q);
      EXPECT_EQ(outcome.error->code(), ErrorCode::kLimitExceeded);
      EXPECT_TRUE(sum.empty());
    }
  }
}

TEST(GeometrySum, StopsWhenAsked) {
  SumSettings options;
  options.cancel.emplace();
  options.cancel->cancel();
  Workspace workspace;
  Geometry sum;
  const Geometry lines = make_lines({{{0, 0}, {3, 1}}});
  const std::vector<Geometry> operands{{kSquare, {}, {}}, {kBowTie, {}, {}}, lines,
                                       make_lines({}, {{1, 1}})};
  for (const Geometry& p : operands) {
    const Outcome outcome = minkowski_sum(p, lines, options, workspace, sum);
    ASSERT_FALSE(outcome.ok()) << to_text(p);
    EXPECT_EQ(outcome.error->code(), ErrorCode::kCancelled);
  }
}

TEST(GeometrySum, ThinPartsCoverTightPlaces) {
  const Region framed = make_polygon({{0, 0}, {6, 0}, {6, 6}, {0, 6}},
                                     {{{2, 2}, {2, 4}, {4, 4}, {4, 2}}});
  const Geometry square{rectangle(-1, -1, 1, 1), {}, {}};
  const Options options{.tight = true};
  const Region filled = rectangle(-1, -1, 7, 7);
  const DetailedSum closed = detailed_sum(Geometry{framed, {}, {}}, square, options);
  EXPECT_EQ(closed.sum.region, filled);
  EXPECT_EQ(to_text(closed.tight), to_text(make_lines({}, {{3, 3}})));
  // A point in the hole covers the tight place; one that is far away does not.
  for (const auto& [x, covers] : {std::pair{3, true}, {20, false}}) {
    const Geometry with_point{framed, {}, {Point{x, 3}}};
    const DetailedSum found = detailed_sum(with_point, square, options);
    EXPECT_EQ(found.sum.region.polygon_count(), covers ? 1U : 2U);
    EXPECT_EQ(found.tight.points.size(), covers ? 0U : 1U);
  }
  // A path along the hole belongs to the area there, and takes no tight place away. It does not
  // matter that it goes on through the area and crosses its edge.
  const Geometry with_path{framed, {{{2, 2}, {4, 2}, {3, -2}}}, {}};
  EXPECT_EQ(to_text(detailed_sum(with_path, square, options).tight),
            to_text(make_lines({}, {{3, 3}})));
  SumSettings by_winding{options};
  by_winding.method = Method::kSigned;
  const Geometry line = make_lines({{{0, 0}, {1, 1}}});
  EXPECT_THROW(static_cast<void>(detailed_sum(line, line, by_winding)), Error);
}

/// The pairs of edges of two tangles sweep most of their sum many times over. That is covered by
/// parallelograms.
TEST(GeometrySum, ACoverOfTangledPolylinesChangesNothing) {
  for (const int size : {6, 30, 1'000'000}) {
    Random random(static_cast<std::uint64_t>(size));
    const auto tangle = [&](int vertices) {
      Outline path;
      for (int i = 0; i < vertices; ++i) path.push_back({random.below(size), random.below(size)});
      return make_lines({path});
    };
    const Geometry p = tangle(30);
    const Geometry q = tangle(20);
    SumSettings bare;
    bare.cover = false;
    SumSettings covered;
    covered.grid = 200;
    SumSettings by_winding;
    by_winding.method = Method::kSigned;
    const std::string sum = to_text(minkowski_sum(p, q));
    EXPECT_EQ(sum, to_text(minkowski_sum(p, q, bare)));
    EXPECT_EQ(sum, to_text(minkowski_sum(p, q, covered)));
    EXPECT_EQ(sum, to_text(minkowski_sum(p, q, by_winding)));
  }
}

/// Nearly all that the vertices of a small path make of the edges of a far larger one is inside.
TEST(GeometrySum, SegmentsOfPolylinesAreClipped) {
  Random random(40403);
  const Geometry small{{}, {tangle(random, 60, 1000)}, {}};
  const Geometry path{{}, {tangle(random, 40, 1000)}, {}};
  const Geometry large = scaled(path, Rational(1000));
  SumSettings options;
  options.method = Method::kSigned;
  const Geometry expected = minkowski_sum(small, large, options);
  options.method = Method::kReduced;
  // 15,000 crossings are left. Without the cover nothing is clipped, and there are 160,000.
  options.limits.max_crossings = 40'000;
  EXPECT_EQ(minkowski_sum(small, large, options), expected);
  EXPECT_EQ(minkowski_sum(large, small, options), expected);
  options.cover = false;
  EXPECT_THROW(static_cast<void>(minkowski_sum(small, large, options)), Error);
}

TEST(GeometrySum, StatisticsAreThoseOfTheAreas) {
  Geometry flagged{kSquare, make_lines({{{2, 2}, {5, 2}}}).polylines, {}};
  for (const bool small : {true, false}) {
    SumSettings settings;
    settings.small = small;
    Statistics statistics = detailed_sum(flagged, flagged, settings).statistics;
    EXPECT_EQ(statistics.convolution_segments, 8U);
    EXPECT_EQ(statistics.small, small);
    EXPECT_GT(statistics.seconds, 0);
    statistics = detailed_sum(make_lines({{{0, 0}, {5, 2}}}), flagged, settings).statistics;
    EXPECT_EQ(statistics.convolution_segments, 0U);
  }
}

}  // namespace
