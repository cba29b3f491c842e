// Tests the steps of the overlay: bounded doubles, exact points on every rung, contacts, the status
// of the sweep, and the checker of subdivisions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "exact/bounded.hpp"
#include "minksum/resolve.hpp"
#include "overlay/chains.hpp"
#include "overlay/exact_points_of.hpp"
#include "overlay/subdivision.hpp"
#include "reference/exact.hpp"
#include "support/messes.hpp"
#include "support/shapes.hpp"
#include "unit/overlay/check_subdivision.hpp"

namespace {

using namespace minksum;
using namespace minksum::overlay;
using reference::Number;
using test::Random;

/// A number, with bounded doubles that claim to hold it.
struct Claim {
  Number exact;
  Bounded bounded;
  [[nodiscard]] bool holds() const {
    const Number value(bounded.value);
    return abs(Number(exact - value)) <= Number(bounded.error);
  }
};

Claim random_claim(Random& random) {
  const double value = std::ldexp(random.between(-1000000, 1000000), random.between(-60, 60));
  const double error = random.one_in(2) ? 0 : std::fabs(value) * 0x1p-50;
  const double off = error / 2;
  return {Number(value) + Number(random.one_in(2) ? off : -off), {value, error}};
}

TEST(OverlayBounded, HoldsTheExactNumber) {
  Random random(1);
  for (int i = 0; i < 20000; ++i) {
    const Claim a = random_claim(random);
    const Claim b = random_claim(random);
    const Claim c{a.exact * b.exact - b.exact, a.bounded * b.bounded - b.bounded};
    EXPECT_TRUE((Claim{a.exact + b.exact, a.bounded + b.bounded}).holds());
    EXPECT_TRUE((Claim{a.exact - b.exact, a.bounded - b.bounded}).holds());
    EXPECT_TRUE((Claim{a.exact * b.exact, a.bounded * b.bounded}).holds());
    EXPECT_TRUE(c.holds());
    if (c.bounded.certain()) {
      EXPECT_EQ(c.bounded.sign() == kPositive, c.exact > 0);
      EXPECT_TRUE((Claim{a.exact / c.exact, a.bounded / c.bounded}).holds());
    }
  }
}

TEST(OverlayBounded, OverflowIsNeverCertain) {
  const Bounded huge{1e300, 0};
  EXPECT_FALSE((huge * huge).certain());
  EXPECT_FALSE((huge * huge - huge * huge).certain());
  EXPECT_FALSE((huge / Bounded{1, 1}).certain());
  EXPECT_FALSE((Bounded{1e-300, 0} * Bounded{1e-300, 0}).certain());
}

// Compares every predicate on every rung with rationals.
template <class Rung>
std::unique_ptr<ExactPoints> points_on(const std::vector<std::pair<int, int>>& points) {
  using Length = typename Rung::Length;
  std::vector<typename ExactPointsOf<Rung>::Own> own;
  std::vector<Length> weights;
  for (const auto& [x, y] : points) {
    own.push_back({Length(std::int64_t{x}), Length(std::int64_t{y})});
    weights.push_back(Length(std::int64_t{1}));
  }
  return std::make_unique<ExactPointsOf<Rung>>(std::move(own), std::move(weights), Frame{});
}

TEST(OverlayExactPoints, AllRungsAgreeWithRationals) {
  Random random(2);
  for (int i = 0; i < 300; ++i) {
    const int size = random.one_in(2) ? 4 : (1 << 30) - 1;
    std::vector<std::pair<int, int>> points;
    std::vector<reference::Pt> exact;
    for (int k = 0; k < 8; ++k) {
      points.emplace_back(random.between(0, size), random.between(0, size));
      exact.push_back({Number(points.back().first), Number(points.back().second)});
    }
    const auto crossing = [&](int a) {
      const reference::Pt& p = exact[static_cast<std::size_t>(a)];
      const reference::Pt& q = exact[static_cast<std::size_t>(a + 1)];
      const reference::Pt& r = exact[static_cast<std::size_t>(a + 2)];
      const reference::Pt& s = exact[static_cast<std::size_t>(a + 3)];
      const Number w = (q.x - p.x) * (s.y - r.y) - (q.y - p.y) * (s.x - r.x);
      const Number t = ((r.x - p.x) * (s.y - r.y) - (r.y - p.y) * (s.x - r.x)) / w;
      return reference::Pt{p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
    };
    const auto parallel = [&](std::size_t a) {
      return reference::cross_sign(exact[a], exact[a + 1], exact[a + 2], exact[a + 3]) == 0;
    };
    for (const auto& rung : {points_on<NarrowNumbers>(points), points_on<MediumNumbers>(points),
                             points_on<WideNumbers>(points), points_on<ArbitraryNumbers>(points)}) {
      EXPECT_EQ(rung->orientation({0, 1}, 2), reference::turn(exact[0], exact[1], exact[2]));
      EXPECT_EQ(rung->cross({0, 1}, {2, 3}),
                reference::cross_sign(exact[0], exact[1], exact[2], exact[3]));
      EXPECT_EQ(rung->compare(0, 1) == kNegative, exact[0] < exact[1]);
      const std::vector<PointId> ring{0, 1, 2, 3, 4};
      EXPECT_EQ(rung->area_sign(ring),
                sign_of(reference::doubled_area({exact.begin(), exact.begin() + 5})));
      if (parallel(0) || parallel(4)) continue;
      const ExactLocation u = ExactLocation::of_crossing({0, 1}, {2, 3});
      const ExactLocation v = ExactLocation::of_crossing({4, 5}, {6, 7});
      const reference::Pt at_u = crossing(0);
      const reference::Pt at_v = crossing(4);
      EXPECT_EQ(rung->compare(u, v) == kNegative, at_u < at_v);
      EXPECT_EQ(rung->compare(v, u) == kNegative, at_v < at_u);
      EXPECT_EQ(rung->orientation({4, 6}, u), reference::turn(exact[4], exact[6], at_u));
      EXPECT_EQ(reference::to_pt(rung->exact(u)), at_u);
    }
  }
}

std::vector<Chain> chains_of(const Geometry& geometry, ThinStore& store) {
  std::vector<Chain> chains;
  for_each_ring(geometry.region, [&](Chain chain, bool) {
    chain.weight.first = 1;
    chain.belongs = true;
    chains.push_back(chain);
  });
  Cancellation nobody;
  store.add(geometry, nobody);
  store.list_chains(chains);
  return chains;
}

struct Steps {
  std::shared_ptr<ThinStore> store = std::make_shared<ThinStore>();  // results point into it
  std::shared_ptr<Cancellation> never = std::make_shared<Cancellation>();
  Segments segments;
  Contacts contacts;
  Subdivision subdivision;
};
Steps run_steps(const Geometry& geometry, bool joined = false) {
  Steps steps;
  steps.segments = list_segments(chains_of(geometry, *steps.store), *steps.never);
  if (joined) join_lines(steps.segments);
  EXPECT_TRUE(find_contacts(steps.segments, {SIZE_MAX, SIZE_MAX}, steps.contacts));
  steps.subdivision = subdivide(steps.segments, steps.contacts);
  sweep(steps.segments, {[](const Winding& w) { return w.first != 0; }}, steps.subdivision);
  return steps;
}

TEST(OverlaySteps, SubdivisionsPassTheirChecker) {
  for (std::uint64_t seed = 1; seed <= 1000 && !HasFailure(); ++seed) {
    Random random(seed);
    Geometry mess = test::random_mess(random);
    mess = test::transformed(
        mess, random.one_in(4) ? test::random_projection(random) : test::random_scaling(random));
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + test::to_text(mess));
    const Steps steps = run_steps(mess);
    EXPECT_EQ(check(steps.segments, steps.subdivision).value_or(""), "");
  }
}

std::string result_of(const Steps& steps) {
  Geometry result;
  extract_area(steps.segments, steps.subdivision, result.region);
  extract_thin(steps.segments, steps.subdivision, result);
  return test::to_text(result);
}

TEST(OverlaySteps, JoinedLinesGiveTheSame) {
  for (std::uint64_t seed = 1; seed <= 1000 && !HasFailure(); ++seed) {
    Random random(seed);
    Geometry mess = test::random_mess(random);
    if (random.one_in(4)) mess = test::transformed(mess, test::random_projection(random));
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + test::to_text(mess));
    const Steps joined = run_steps(mess, true);
    EXPECT_EQ(check(joined.segments, joined.subdivision).value_or(""), "");
    EXPECT_EQ(result_of(joined), result_of(run_steps(mess)));
  }
}

TEST(OverlaySteps, NestedSegmentsHaveFewTouchesOnceJoined) {
  Geometry nested;
  for (int i = 0; i < 100; ++i) nested.polylines.push_back({{-i, 0}, {i + 1, i}});
  for (int i = 0; i < 100; ++i) nested.polylines.push_back({{-i, -i}, {i + 1, i + 1}});
  const Steps plain = run_steps(nested);
  const Steps joined = run_steps(nested, true);
  EXPECT_GT(plain.contacts.touches.size(), 9000U);
  EXPECT_LT(joined.contacts.touches.size(), 500U);
  EXPECT_EQ(result_of(joined), result_of(plain));
  Contacts contacts;
  EXPECT_FALSE(find_contacts(plain.segments, {9000, SIZE_MAX}, contacts));
}

TEST(OverlaySteps, CrossingsAreLimitedAndCounted) {
  Geometry grid;  // 20 lines cross 20 others
  for (int i = 0; i < 20; ++i) {
    grid.polylines.push_back({{0, 2 * i + 1}, {40, 2 * i + 1}});
    grid.polylines.push_back({{2 * i + 1, 0}, {2 * i + 1, 40}});
  }
  ThinStore store;
  const std::vector<Chain> chains = chains_of(grid, store);
  const Rule rule{[](const Winding& w) { return w.first != 0; }};
  Options options;
  options.limits.max_crossings = 400;
  std::uint64_t count = 0;
  (void)select(chains, rule, options, &count);
  EXPECT_EQ(count, 400U);
  for (const std::uint64_t most : {0U, 200U, 399U}) {
    options.limits.max_crossings = most;
    try {
      (void)select(chains, rule, options);
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kLimitExceeded);
      EXPECT_EQ(error.limit()->value, most);
    }
  }
}

// Here cells are divided often; the expected contacts come from all pairs.
TEST(OverlaySteps, NoContactIsMissed) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    const int size = random.one_in(2) ? 60 : 1 << 20;
    const int reach = std::max(2, size / random.between(1, 12));
    Geometry mess;
    for (int i = 0; i < 150; ++i) {
      const int x = random.between(0, size);
      const int y = random.between(0, size);
      mess.polylines.push_back({{Rational(x), Rational(y)},
                                {Rational(x + random.between(-reach, reach)),
                                 Rational(y + random.between(-reach, reach))}});
    }
    const Steps steps = run_steps(mess);
    const auto& list = steps.segments.list;
    const ExactPoints& exact = steps.segments.predicates.exact();
    std::size_t crossings = 0;
    std::size_t touches = 0;
    for (std::size_t s = 0; s < list.size(); ++s) {
      for (std::size_t t = s + 1; t < list.size(); ++t) {
        const auto side = [&](const Ends& line, PointId p) {
          return int{exact.orientation(line, p)};
        };
        const Ends a = list[s].ends;
        const Ends b = list[t].ends;
        if (side(a, b.low) * side(a, b.high) < 0 && side(b, a.low) * side(b, a.high) < 0) {
          ++crossings;
        }
      }
      for (PointId p = list[s].ends.low + 1; p < list[s].ends.high; ++p) {
        if (exact.orientation(list[s].ends, p) == kZero) ++touches;
      }
    }
    EXPECT_EQ(steps.contacts.crossings.size(), crossings) << "seed " << seed;
    EXPECT_EQ(steps.contacts.touches.size(), touches) << "seed " << seed;
  }
}

TEST(OverlaySteps, CheckerRejects) {
  const Geometry cross{{}, {{{0, 0}, {4, 4}}, {{0, 4}, {4, 0}}, {{0, 2}, {9, 2}}}, {}};
  Geometry frame{test::make_region({{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}}}), cross.polylines, {}};
  const Steps good = run_steps(frame);
  ASSERT_EQ(check(good.segments, good.subdivision), std::nullopt);
  const auto fault = [&](auto change) {
    Subdivision bad = good.subdivision;
    change(bad);
    return check(good.segments, bad).value_or("");
  };
  EXPECT_EQ(fault([](Subdivision& s) { std::swap(s.nodes[1].place, s.nodes[2].place); }),
            "nodes are not in order");
  EXPECT_EQ(fault([](Subdivision& s) { s.nodes[1].place = s.nodes[0].place; }),
            "two nodes are one point");
  EXPECT_EQ(fault([](Subdivision& s) { std::swap(s.pieces[0].low, s.pieces[0].high); }),
            "a piece does not go up");
  EXPECT_EQ(fault([](Subdivision& s) { s.pieces[0].segment = s.pieces[1].segment; }),
            "a piece ends off its segment");
  EXPECT_EQ(fault([](Subdivision& s) { std::swap(s.around[0], s.around[1]); }),
            "pieces around a node are not counter-clockwise");
  EXPECT_EQ(fault([](Subdivision& s) { s.pieces[0].inside_above ^= true; }),
            "a face is inside at one piece and outside at the next");
  // Without contacts, no segment is cut.
  const auto uncut = [](const Geometry& geometry) {
    const Steps steps = run_steps(geometry);
    Subdivision bad = subdivide(steps.segments, {});
    bad.first_around.assign(bad.nodes.size() + 1, 0);
    return check(steps.segments, bad).value_or("");
  };
  EXPECT_EQ(uncut(cross), "two pieces cross");
  EXPECT_EQ(uncut({{}, {{{0, 0}, {4, 0}}, {{2, 0}, {2, 3}}}, {}}), "a node lies inside a piece");
}

/// Tells whether two segments meet elsewhere than at ends of theirs, or overlap.
bool crosses(const Segments& segments, SegmentId s, SegmentId t) {
  const Ends a = segments.list[s].ends;
  const Ends b = segments.list[t].ends;
  const auto side = [&](const Ends& line, PointId p) {
    return int{segments.predicates.orientation(line, p)};
  };
  if (side(a, b.low) == 0 && side(a, b.high) == 0) {
    return std::max(a.low, b.low) < std::min(a.high, b.high);
  }
  return side(a, b.low) * side(a, b.high) < 0 && side(b, a.low) * side(b, a.high) < 0;
}

TEST(OverlaySteps, ASweepListsAllContactsOfSegmentsThatStay) {
  std::size_t stay = 0;
  std::size_t touching = 0;
  for (std::uint64_t seed = 1; seed <= 2000 && !HasFailure(); ++seed) {
    Random random(seed);
    Geometry mess = test::random_mess(random);
    if (random.one_in(4)) mess = test::transformed(mess, test::random_projection(random));
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + test::to_text(mess));
    const Steps steps = run_steps(mess);
    const Segments& segments = steps.segments;
    std::vector<Touch> swept;
    const std::vector<std::uint8_t> suspect = sweep_contacts(segments, swept);
    std::sort(swept.begin(), swept.end());
    EXPECT_TRUE(std::ranges::includes(steps.contacts.touches, swept));
    std::vector<std::uint8_t> ends(segments.sources.size(), 0);  // by point: of one that stays
    for (SegmentId s = 0; s < suspect.size(); ++s) {
      bool meets_wrongly = false;
      for (SegmentId t = 0; t < suspect.size(); ++t) {
        const bool wrong = s != t && crosses(segments, s, t);
        meets_wrongly |= wrong;
        EXPECT_FALSE(wrong && suspect[s] == 0 && suspect[t] == 0);
      }
      EXPECT_TRUE(meets_wrongly || suspect[s] == 0);
      if (suspect[s] != 0) continue;
      ++stay;
      ends[segments.list[s].ends.low] = ends[segments.list[s].ends.high] = 1;
    }
    for (const Touch& touch : steps.contacts.touches) {
      if (suspect[touch.segment] != 0 || ends[touch.point] == 0) continue;
      ++touching;
      EXPECT_TRUE(std::ranges::binary_search(swept, touch));
    }
  }
  EXPECT_GT(stay, 1000U);
  EXPECT_GT(touching, 100U);
}

TEST(OverlaySteps, CrowdsThatDoNotCrossAreSwept) {
  // No cut parts these segments, and few of their pairs meet.
  Geometry crowd;
  constexpr int kCount = 3000;
  for (int i = 0; i < kCount; ++i) crowd.polylines.push_back({{i, 0}, {1'000'000 + i, 1'000'000}});
  crowd.polylines.push_back({{0, 10}, {200, 0}});
  std::uint64_t looks = 0;
  Options options;
  options.progress = [&](const Progress&) { return ++looks != 0; };
  const Geometry result = resolve(crowd, options);
  EXPECT_GT(result.polylines.size(), std::size_t{kCount});
  // All pairs would take some 500 looks.
  EXPECT_LT(looks, 200U);
}

}  // namespace
