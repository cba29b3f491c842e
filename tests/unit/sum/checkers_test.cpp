// Tests that the checker of each stage accepts what the stage makes and rejects damage.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "sum/pipeline.hpp"
#include "support/polygon_kinds.hpp"
#include "support/shapes.hpp"

namespace {

using namespace minksum;
using namespace minksum::test;

/// Returns a comb with a hole into which a small L fits with room to spare.
Region comb() {
  return make_polygon({{0, 0}, {60, 0}, {60, 40}, {50, 40}, {50, 10}, {40, 10}, {40, 40}, {30, 40},
                       {30, 10}, {20, 10}, {20, 40}, {0, 40}},
                      {{{2, 12}, {2, 38}, {17, 38}, {17, 12}}});
}
Region l_shape() { return make_polygon({{0, 0}, {9, 0}, {9, 3}, {3, 3}, {3, 13}, {0, 13}}); }

/// Keeps the results of all stages of one sum.
struct Stages : StageMemory {
  SumRequest options;
  Region result;

  Stages() : Stages(comb(), l_shape(), true) {}
  Stages(const Region& p, const Region& q, bool with_cover) {
    options.grid = 40;
    options.cover = with_cover;
    run_pipeline({p}, {q}, options, *this, result);
  }
};

TEST(Checkers, AcceptWhatTheStagesMake) {
  const Stages s;
  EXPECT_EQ(check(s.operands), std::nullopt);
  EXPECT_EQ(check(s.convolution, s.operands, false), std::nullopt);
  EXPECT_EQ(check(s.cover, s.operands), std::nullopt);
  EXPECT_EQ(check(s.arrangement, s.operands), std::nullopt);
  EXPECT_EQ(check(s.loops, s.arrangement), std::nullopt);
  EXPECT_EQ(check(s.filtered, s.loops, s.arrangement, s.operands), std::nullopt);
  EXPECT_EQ(check(s.boundary, s.arrangement, s.operands), std::nullopt);
  EXPECT_GE(s.cover.covered_count(), 1U);
  EXPECT_GE(s.arrangement.crossings, 1U);
  EXPECT_GE(s.boundary.rings.size(), 2U);
}

TEST(Checkers, FiltersRejectAnAcceptedFalseLoop) {
  std::size_t false_loops = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const Region p = random_two_opt(random, 40, 1000);
    const Region q = random_two_opt(random, 40, 1000);
    Stages s(p, q, false);
    ASSERT_EQ(check(s.filtered, s.loops, s.arrangement, s.operands), std::nullopt);
    for (LoopState& state : s.filtered.state) {
      if (state != LoopState::kRejectedByCollision) continue;
      ++false_loops;
      --s.filtered.rejected_by_collision;
      state = LoopState::kAccepted;
      EXPECT_EQ(check(s.filtered, s.loops, s.arrangement, s.operands),
                std::optional<std::string>("a loop was misjudged"));
      break;
    }
  }
  EXPECT_GE(false_loops, 5U) << "too few false loops to accept";
}

/// A way to damage the stages, and the checker's expected answer.
struct Damage {
  const char* name;
  std::function<void(Stages&)> damage;
  std::function<std::optional<std::string>(const Stages&)> run;
  const char* expected;
};

std::optional<std::string> run_operands(const Stages& s) { return check(s.operands); }
std::optional<std::string> run_convolution(const Stages& s) {
  return check(s.convolution, s.operands, false);
}
std::optional<std::string> run_cover(const Stages& s) { return check(s.cover, s.operands); }
std::optional<std::string> run_arrangement(const Stages& s) {
  return check(s.arrangement, s.operands);
}
std::optional<std::string> run_loops(const Stages& s) { return check(s.loops, s.arrangement); }
std::optional<std::string> run_filters(const Stages& s) {
  return check(s.filtered, s.loops, s.arrangement, s.operands);
}
std::optional<std::string> run_boundary(const Stages& s) {
  return check(s.boundary, s.arrangement, s.operands);
}

std::vector<Damage> damages() {
  return {
      {"a convexity flag", [](Stages& s) { s.operands.convex[0] ^= 1; }, run_operands,
       "a convexity flag is wrong"},
      {"a direction out of order",
       [](Stages& s) { std::ranges::reverse(s.operands.by_direction); },
       run_operands, "directions are not sorted"},
      {"a ring's end", [](Stages& s) { s.operands.rings[0].end -= 1; }, run_operands,
       "rings do not tile the sites"},
      {"a place", [](Stages& s) { std::swap(s.operands.place[0], s.operands.place[1]); },
       run_operands, "places are not sorted"},
      {"a reverse's place",
       [](Stages& s) { std::swap(s.operands.reverse_place[0], s.operands.reverse_place[1]); },
       run_operands, "a reverse is out of place"},
      {"a lost array", [](Stages& s) { s.operands.rank.pop_back(); }, run_operands,
       "an array has the wrong size"},
      {"a lost segment", [](Stages& s) { s.convolution.segments.pop_back(); }, run_convolution,
       "a segment is missing"},
      {"a doubled segment",
       [](Stages& s) { s.convolution.segments.push_back(s.convolution.segments[0]); },
       run_convolution, "a segment is listed twice"},
      {"a covered border", [](Stages& s) { s.cover.covered.set(0, 0); }, run_cover,
       "a cell at the border of the sum is covered"},
      {"a small grid", [](Stages& s) { s.cover.grid.columns = 1; }, run_cover,
       "the grid does not span the sum's box"},
      {"a cover of another size", [](Stages& s) { s.cover.covered.reset(1, 1); }, run_cover,
       "the cover is not of the grid's size"},
      {"a piece turned round",
       [](Stages& s) { std::swap(s.arrangement.pieces[0].from, s.arrangement.pieces[0].to); },
       run_arrangement, "a piece runs against its segment"},
      {"a piece on another segment",
       [](Stages& s) {
         const auto& kept = s.arrangement.kept;
         KeptId& segment = s.arrangement.pieces[0].segment;
         const std::uint32_t line = kept[segment].line;
         while (kept[segment].line == line) {
           segment = (segment + 1) % static_cast<KeptId>(kept.size());
         }
       },
       run_arrangement, "a piece's end is not on its segment"},
      {"a piece twice",
       [](Stages& s) { s.arrangement.pieces.push_back(s.arrangement.pieces[0]); },
       run_arrangement, "two pieces have the same ends"},
      {"a piece of a lost segment", [](Stages& s) { s.arrangement.pieces[0].segment = 1U << 30; },
       run_arrangement, "a piece refers to what is not there"},
      {"a loop with a gap", [](Stages& s) { std::swap(s.loops.pieces[0], s.loops.pieces[1]); },
       run_loops, "a loop does not close"},
      {"a loop twice",
       [](Stages& s) {
         const auto loop = s.loops.loop(0);
         const std::vector<PieceId> again(loop.begin(), loop.end());
         s.loops.pieces.insert(s.loops.pieces.end(), again.begin(), again.end());
         s.loops.begin.push_back(static_cast<std::uint32_t>(s.loops.pieces.size()));
         s.loops.positive.push_back(s.loops.positive[0]);
       },
       run_loops, "a piece is in two loops"},
      {"a rejected true loop",
       [](Stages& s) {
         for (LoopState& state : s.filtered.state) state = LoopState::kRejectedByCollision;
         s.filtered.rejected_by_nesting = 0;
         s.filtered.rejected_by_collision = s.filtered.state.size();
       },
       run_filters, "a loop was misjudged"},
      {"a wrong count", [](Stages& s) { ++s.filtered.rejected_by_collision; }, run_filters,
       "a count is wrong"},
      {"a ring started elsewhere",
       [](Stages& s) {
         const BoundaryRing& ring = s.boundary.rings[0];
         std::rotate(s.boundary.vertices.begin() + ring.begin,
                     s.boundary.vertices.begin() + ring.begin + 1,
                     s.boundary.vertices.begin() + ring.end);
       },
       run_boundary, "a ring does not start at its smallest vertex"},
      {"a ring's orientation",
       [](Stages& s) { s.boundary.rings[0].positive = !s.boundary.rings[0].positive; },
       run_boundary, "a ring's orientation is wrong"},
      {"a lost vertex",
       [](Stages& s) {
         BoundaryRing& ring = s.boundary.rings.back();
         s.boundary.vertices.erase(s.boundary.vertices.begin() + ring.begin + 1);
         --ring.end;
       },
       run_boundary, "an edge leaves its line"},
      {"a lost ring", [](Stages& s) { s.boundary.ring_order.pop_back(); }, run_boundary,
       "a ring is in no polygon"},
  };
}

TEST(Checkers, RejectDamage) {
  for (const Damage& damage : damages()) {
    Stages stages;
    damage.damage(stages);
    EXPECT_EQ(damage.run(stages), std::optional<std::string>(damage.expected)) << damage.name;
  }
}

}  // namespace
