// Tests fill rules and boolean operations against the definition, on very degenerate input.
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <vector>

#include "minksum/boolean.hpp"
#include "minksum/minkowski_sum.hpp"
#include "minksum/resolve.hpp"
#include "reference/brute_force_overlay.hpp"
#include "reference/validity.hpp"
#include "support/data.hpp"
#include "support/generators.hpp"
#include "support/messes.hpp"
#include "support/shapes.hpp"

namespace {

using namespace minksum;
using namespace minksum::test;
using reference::brute_force_boolean;
using reference::brute_force_resolve;
using reference::brute_force_unite;

constexpr std::array kRules = {FillRule::kAutomatic, FillRule::kEvenOdd, FillRule::kNonZero,
                               FillRule::kPositive, FillRule::kNegative};

struct Case {
  Geometry mess;
  FillRule rule = FillRule::kAutomatic;
  bool regularize = false;
};
Case random_case(Random& random) {
  Case c{random_mess(random), {}, random.one_in(4)};
  c.rule = kRules[static_cast<std::size_t>(random.below(kRules.size()))];
  return c;
}
Geometry resolved(const Geometry& geometry, FillRule rule, bool regularize = false) {
  Options options;
  options.fill = rule;
  options.regularize = regularize;
  return resolve(geometry, options);
}
Geometry resolved(const Case& c) { return resolved(c.mess, c.rule, c.regularize); }
std::string note(int number, const Case& c) {
  return "case " + std::to_string(number) + ", " + to_string(c.rule) +
         (c.regularize ? ", regularized\n" : "\n") + to_text(c.mess);
}
Random random_of_case(int number) {
  return Random(seed_from_environment(1) * 1000003 + static_cast<std::uint64_t>(number));
}

TEST(Overlay, ResolveIsAsByBruteForce) {
  const int count = count_from_environment(500);
  for (int i = 0; i < count && !HasFailure(); ++i) {
    Random random = random_of_case(i);
    const Case c = random_case(random);
    SCOPED_TRACE(note(i, c));
    const Geometry expected = brute_force_resolve(c.mess, c.rule, c.regularize);
    const Geometry result = resolved(c);
    EXPECT_EQ(to_text(result), to_text(expected));
    EXPECT_EQ(result, expected);
    EXPECT_EQ(reference::canonical_fault(result.region), "");
    EXPECT_EQ(to_text(resolved(result, FillRule::kAutomatic)), to_text(result));
    EXPECT_EQ(to_text(resolved(result, FillRule::kStrict)), to_text(result));
    const auto map = random_scaling(random);
    const Geometry scaled = resolved({transformed(c.mess, map), c.rule, c.regularize});
    EXPECT_EQ(to_text(scaled), to_text(transformed(expected, map)));
  }
}

TEST(Overlay, ResolveOfFractionsIsAsByBruteForce) {
  const int count = count_from_environment(500) / 10;
  for (int i = 0; i < count && !HasFailure(); ++i) {
    Random random = random_of_case(i);
    Case c = random_case(random);
    c.mess = transformed(c.mess, random_projection(random));
    SCOPED_TRACE(note(i, c));
    EXPECT_EQ(to_text(resolved(c)), to_text(brute_force_resolve(c.mess, c.rule, c.regularize)));
  }
}

// Rings of valid regions mean the same by any rule that ignores their direction.
TEST(Overlay, ValidRegionsAreWhatTheyAre) {
  const int count = count_from_environment(500);
  for (int i = 0; i < count && !HasFailure(); ++i) {
    Random random = random_of_case(i);
    const Region region = random_region(random);
    const Geometry geometry{scrambled(region, random), {}, {}};
    SCOPED_TRACE("case " + std::to_string(i) + "\n" + to_text(geometry));
    const Geometry result = resolved(geometry, FillRule::kAutomatic);
    EXPECT_FALSE(result.has_thin_parts());
    EXPECT_EQ(reference::canonical_fault(result.region), "");
    EXPECT_EQ(result, resolved(geometry, FillRule::kStrict));
    EXPECT_EQ(result, resolved(geometry, FillRule::kEvenOdd));
    EXPECT_EQ(result.region, unite(region, region));
    // The bytes equal those of the sum with the origin.
    Region dot;
    dot.begin_polygon();
    dot.begin_ring();
    for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {0, 1}}) dot.add_vertex(x, y);
    const Region sum = minkowski_sum(region, dot);
    EXPECT_EQ(resolved({sum, {}, {}}, FillRule::kAutomatic).region, sum);
  }
}

TEST(Overlay, BooleansAreAsByBruteForce) {
  const int count = count_from_environment(500) / 2;
  for (int i = 0; i < count && !HasFailure(); ++i) {
    Random random = random_of_case(i);
    const Pair pair = random_pair(random);
    SCOPED_TRACE("case " + std::to_string(i) + "\nA " + to_text(pair.p) + "\nB " + to_text(pair.q));
    const auto expect = [&](const Region& result, bool (*keep)(bool, bool)) {
      EXPECT_EQ(to_text(result), to_text(brute_force_boolean(pair.p, pair.q, keep)));
    };
    switch (random.below(4)) {
      case 0:
        expect(unite(pair.p, pair.q), [](bool a, bool b) { return a || b; });
        break;
      case 1:
        expect(intersect(pair.p, pair.q), [](bool a, bool b) { return a && b; });
        break;
      case 2: {
        const Region rest = subtract(pair.p, pair.q);
        expect(rest, [](bool a, bool b) { return a && !b; });
        EXPECT_EQ(contains(pair.q, pair.p), rest.empty());
        break;
      }
      default:
        expect(symmetric_difference(pair.p, pair.q), [](bool a, bool b) { return a != b; });
    }
  }
}

TEST(Overlay, UnionsOfGeometriesAreAsByBruteForce) {
  const int count = count_from_environment(500) / 8;
  for (int i = 0; i < count && !HasFailure(); ++i) {
    Random random = random_of_case(i);
    std::vector<Geometry> geometries;
    std::string text = "case " + std::to_string(i);
    for (int k = random.between(1, 3); k > 0; --k) {
      geometries.push_back(resolved(random_case(random)));
      text += '\n';
      text += to_text(geometries.back());
    }
    SCOPED_TRACE(text);
    EXPECT_EQ(to_text(unite(geometries)), to_text(brute_force_unite(geometries)));
  }
}

TEST(Overlay, DegenerateFilesByEveryRule) {
  const auto folder = data_path();
  if (!folder) return;
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(*folder / "degenerate")) {
    if (entry.path().extension() != ".wkt") continue;
    ++files;
    const bool empty = entry.path().filename().string().starts_with("empty");
    const Geometry geometry{empty ? Region() : read_wkt(entry.path()), {}, {}};
    for (const FillRule rule : kRules) {
      SCOPED_TRACE(entry.path().filename().string() + " " + to_string(rule));
      EXPECT_EQ(to_text(resolved(geometry, rule)), to_text(brute_force_resolve(geometry, rule)));
    }
  }
  EXPECT_GT(files, 100);
}

}  // namespace
