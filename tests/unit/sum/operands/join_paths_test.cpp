// Tests that joined paths are the same set, with the fewest ends, and that sums of them are right.
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "minksum/boolean.hpp"
#include "minksum/minkowski_sum.hpp"
#include "minksum/resolve.hpp"
#include "minksum/testing.hpp"
#include "sum/operands/operands.hpp"
#include "support/geometries.hpp"
#include "support/random.hpp"

namespace minksum {
namespace {

using namespace minksum::test;

std::vector<Polyline> joined(const Geometry& geometry) {
  Cancellation never;
  return join_paths(resolve(geometry).polylines, never);
}
std::size_t count_vertices(const std::vector<Polyline>& paths) {
  std::size_t count = 0;
  for (const Polyline& path : paths) count += path.size();
  return count;
}

/// Expects that no path goes straight on through a vertex, which would be taken for an end.
void expect_bent(const std::vector<Polyline>& paths) {
  for (const Polyline& path : paths) {
    for (std::size_t k = 1; k + 1 < path.size(); ++k) {
      const Geometry corner{{}, {{path[k - 1], path[k], path[k + 1]}}, {}};
      EXPECT_EQ(resolve(corner).polylines[0].size(), 3U) << to_text(corner);
    }
  }
}

TEST(JoinPaths, WhatGoesStraightOnIsOnePath) {
  struct Case {
    std::vector<Outline> given;
    std::size_t paths;
    std::size_t vertices;
  };
  const std::vector<Case> cases = {
      {{{{0, 0}, {4, 4}}, {{0, 4}, {4, 0}}}, 2, 4},                    // a cross
      {{{{0, 0}, {9, 0}}, {{3, 0}, {3, 5}}}, 2, 4},                    // a T
      {{{{0, 0}, {1, 5}}, {{0, 0}, {2, 5}}, {{0, 0}, {3, 5}}}, 2, 5},  // three arms
      {{{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}}}, 1, 5},              // a square
      {{{{0, 0}, {4, 4}, {4, 0}, {0, 4}, {0, 0}}}, 1, 5},              // it crosses itself
      {{{{2, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {2, 0}}, {{2, 0}, {2, -3}}}, 2, 7},
      {{{{0, 0}, {9, 0}}, {{0, 0}, {0, 9}}, {{-9, 0}, {0, 0}}, {{0, -9}, {0, 0}}}, 2, 4},
  };
  for (const Case& c : cases) {
    const Geometry lines = make_lines(c.given);
    const std::vector<Polyline> paths = joined(lines);
    EXPECT_EQ(paths.size(), c.paths) << to_text(lines);
    EXPECT_EQ(count_vertices(paths), c.vertices) << to_text(lines);
    EXPECT_EQ(resolve(Geometry{{}, paths, {}}), resolve(lines));
  }
}

/// At each point, at most one path ends, and no path goes straight on through a vertex.
TEST(JoinPaths, FewEndsAreLeft) {
  Random random(61);
  for (int i = 0; i < 300; ++i) {
    const Geometry lines = resolve(random_thin(random, random.between(2, 12)));
    const std::vector<Polyline> paths = joined(lines);
    EXPECT_EQ(resolve(Geometry{{}, paths, lines.points}), lines);
    std::map<std::string, int> ends;
    for (const Polyline& path : paths) {
      ASSERT_GE(path.size(), 2U);
      if (path.front() != path.back()) {
        ++ends[to_text({{}, {}, {path.front()}})];
        ++ends[to_text({{}, {}, {path.back()}})];
      }
    }
    expect_bent(paths);
    for (const auto& [at, count] : ends) EXPECT_EQ(count, 1) << at << ' ' << to_text(lines);
  }
}

/// Lines cross so near each other that doubles do not tell their crossings apart.
TEST(JoinPaths, CrossingsMayBeNearerThanDoublesTell) {
  Random random(63);
  const Rational tiny = *Rational::parse("1e-40");
  for (int i = 0; i < 300; ++i) {
    Geometry lines;
    for (int k = 0; k < 6; ++k) {
      const Rational dx = random.between(-9, 9);
      const Rational dy = random.between(-9, 9);
      const Rational x = Rational(1, 3) + tiny * Rational(random.between(-1, 1));
      const Rational y = Rational(1, 3) + tiny * Rational(random.between(-1, 1));
      lines.polylines.push_back({{x - dx, y - dy}, {x + dx, y + dy}});
    }
    lines = resolve(lines);
    const std::vector<Polyline> paths = joined(lines);
    EXPECT_EQ(resolve(Geometry{{}, paths, lines.points}), lines);
    expect_bent(paths);
  }
}

/// Sums of two segments need no paths, so their union is a second way.
TEST(JoinPaths, SumsAreUnionsOfSumsOfEdges) {
  Random random(62);
  const auto edges_of = [](const Geometry& lines) {
    std::vector<Geometry> edges;
    for (const Polyline& line : lines.polylines) {
      for (std::size_t k = 1; k < line.size(); ++k)
        edges.push_back({{}, {{line[k - 1], line[k]}}, {}});
    }
    return edges;
  };
  for (int i = 0; i < 200; ++i) {
    const int size = random.between(2, 5);
    Geometry p = resolve(random_thin(random, size));
    Geometry q = resolve(random_thin(random, size));
    p.points.clear();
    q.points.clear();
    std::vector<Geometry> sums;
    for (const Geometry& e : edges_of(p)) {
      for (const Geometry& f : edges_of(q)) sums.push_back(minkowski_sum(e, f));
    }
    const Geometry expected = unite(sums);
    for (const Method method : {Method::kReduced, Method::kSigned}) {
      SumSettings options;
      options.method = method;
      EXPECT_EQ(minkowski_sum(p, q, options), expected) << to_text(p) << '\n' << to_text(q);
    }
  }
}

}  // namespace
}  // namespace minksum
