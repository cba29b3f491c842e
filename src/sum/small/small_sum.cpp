#include "sum/small/small_sum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "machine/vectors.hpp"
#include "sum/small/small_cover.hpp"
#include "sum/small/small_polygons.hpp"

namespace minksum {

struct SmallScratch::State {
  SmallCover cover;
  SmallSegments segments;
  SmallSegments ordered;  ///< the segments in order, or a sample of them
  SmallOrder order;
  SmallMeetings meetings;
  WalkMarks marks;
  SmallBoundary boundary;
  SmallPlacement::Memory placement;
  SmallRingsMemory rings;
};

namespace {

/// Whether a polygon of the other operand may fit into a hole, because its box does. A hole is
/// open, so a box of equal width is too wide, unless widths are rounded.
bool may_fit(const SmallOperand& operand, const Refinement& by, const SmallOperand& other,
             const Refinement& other_by) {
  // Then the box counts as a little smaller. That keeps holes which could be filled, at worst.
  const double steps = other_by.steps * (by.rounded || other_by.rounded ? 1 - 0x1p-48 : 1);
  const Vec<double> box{other.least_extent.x * steps, other.least_extent.y * steps};
  return std::ranges::any_of(operand.holes, [&](const Vec<double>& hole) {
    return box.x < hole.x * by.steps && box.y < hole.y * by.steps;
  });
}

Vec<double> extent_of(const SmallOperand& p, const SmallOperand& q) {
  return plus(p.extent, q.extent);
}
/// Returns the larger extent of the sum.
double width_of(const SmallOperand& p, const SmallOperand& q) {
  return std::max(extent_of(p, q).x, extent_of(p, q).y);
}

/// Merges both operands' edges in order of direction. These are all of the sum's boundary.
template <class Number>
[[gnu::noinline]] void merge_convex(const SmallNumbers<Number>& numbers, const SmallOperand& p,
                                    const SmallOperand& q, Region& result) {
  /// Goes round a ring from its smallest vertex.
  struct Round {
    VecRow at;
    VecRow way;
    std::uint32_t size;
    std::uint32_t i;
    std::uint32_t left;
    explicit Round(const SmallOperand& o)
        : at(o.at()), way(o.way()), size(o.size), i(o.smallest), left(o.size) {}
    void go_on() {
      i = i + 1 == size ? 0 : i + 1;
      --left;
    }
  };
  using Origin = SegmentOrigin;
  SmallWriter<Number> writer(numbers, p, q, p.size + q.size, 0, result);
  Round a(p);
  Round b(q);
  const auto turn_of_edges = [&](const auto& of) __attribute__((always_inline)) {
    return of.turn(of.get(a.way, a.i), of.get(b.way, b.i));
  };
  while (a.left + b.left > 0) {
    // Neither edge is half a circle behind the other, because convex rings turn by less.
    const double turn = a.left == 0 ? -1 : b.left == 0 ? 1 : decide(numbers, turn_of_edges);
    writer.add(a.at, a.i, b.at, b.i, turn >= 0 ? Origin{a.i, b.i, true} : Origin{b.i, a.i, false});
    if (turn >= 0) a.go_on();
    if (turn <= 0) b.go_on();
  }
  writer.finish();
}

/// Puts the segments in order, and finds their meetings. Returns null if these are too many, or
/// more than `most_right` on the right.
template <class Number>
const SmallSegments* meet(const SmallNumbers<Number>& numbers, const Vec<double>& extent,
                          SmallScratch::State& scratch, std::optional<double> most_right = {}) {
  SmallSegments* segments = &scratch.segments;
  segments->finish(numbers.reach);
  if (segments->is_out_of_order()) {
    scratch.order.apply(*segments, extent, numbers.reach, scratch.ordered);
    segments = &scratch.ordered;
  }
  const bool found =
      find_meetings_by(widest_vectors(), numbers, *segments, scratch.meetings, most_right);
  return found ? segments : nullptr;
}

/// What a sample of the segments tells of their meetings on the right.
struct SampledMeetings {
  double saved;       ///< of the sample: those that clipping saves, or all if parts have no count
  double most_saved;  ///< segments are clipped if more than this many are saved
  bool are_few;       ///< whether whole segments, or else their parts, have few enough for a walk
  double left;        ///< of all segments, or of all parts; no more than the limit of the count
};

/// Compares a sample of the segments, and then of their parts if those may have fewer meetings.
template <class Number>
SampledMeetings sample_meetings(const SmallNumbers<Number>& numbers, const SmallClipper& clipper,
                                SmallScratch::State& scratch) {
  SmallMeetings& meetings = scratch.meetings;
  SmallSegments& sample = scratch.ordered;
  const auto [share, count] = take_sample(scratch.cover.cover, scratch.segments, sample);
  const double of_pairs = share * share;
  // What a sample tells is off by a fifth or so. With 1 instead of 1.5, five of 670 sums took 1.7
  // to 4.5 times as long as if a walk was always tried. All meetings of parts may be one more for
  // each segment, as at the ends of outlines. Without that limit, two of the sums took over twice
  // as long: their segments lie on few lines, which the stages join.
  const double most_right = 1.5 * most_right_meetings(count) * of_pairs;
  const double most = (4.0 * count + 64) * of_pairs;
  // Returns the number of meetings on the right, or infinity if there are too many.
  const auto count_right = [&] {
    if (sample.size == 0) return 0.0;
    sample.finish(numbers.reach);
    // Where it gives up, those that are found tell. Of whole segments, some that are on one line,
    // but apart, are counted as well.
    static_cast<void>(find_meetings_by(widest_vectors(), numbers, sample, meetings, most_right));
    const bool are_few = meetings.right_count <= most_right &&
                         (!sample.in_part || static_cast<double>(meetings.size()) <= most);
    return are_few ? meetings.right_count : HUGE_VAL;
  };
  // Clipping a segment takes 40 to 110 ns, and a meeting 100 ns. With 0.3 instead of 0.15, 638 sums
  // took as long on the geometric mean.
  const double most_saved = 0.15 * most_right;
  double right = count_right();
  double saved = right;
  if (saved > most_saved) {
    clipper.clip(sample);
    right = count_right();
    saved -= right;
  }
  return {saved, most_saved, right != HUGE_VAL, std::min(right, most_right) / of_pairs};
}

/// Finds the meetings of the segments, or of those parts that may be boundary. Returns null if
/// these are too many, or seem so by a sample.
template <class Number>
const SmallSegments* meet_or_give_up(const SmallNumbers<Number>& numbers, const SmallPlan& plan,
                                     const SmallOperand& p, const SmallOperand& q,
                                     SmallScratch::State& scratch) {
  Cover& cover = scratch.cover.cover;
  SmallSegments& segments = scratch.segments;
  const Vec<double> extent = extent_of(p, q);
  bool may_be_hidden = cover.active;
  const auto drop = [&] {
    if (may_be_hidden) drop_hidden(cover, scratch.cover.uncovered, segments);
    may_be_hidden = false;
  };
  // Of 277 sums with a cover, 43 expect more crossings than this for each segment. Whole segments
  // have few enough meetings for a walk in four of these 43, and in 192 of the others.
  constexpr double kCrowded = 3;
  if (scratch.cover.crossings <= kCrowded) {
    drop();
    const SmallSegments* const met = meet(numbers, extent, scratch);
    if (met != nullptr || scratch.meetings.parts_would_not_help) return met;
  }
  const SmallClipper clipper(plan, p, q, width_of(p, q), scratch.cover);
  SampledMeetings seen = sample_meetings(numbers, clipper, scratch);
  // Finer grids are bought as long as they help and are cheap beside the meetings that are left. A
  // meeting takes 100 ns, as long as moving 700 words. Of 640 sums that come here, 20 take under
  // 0.77 of the time that they take without, and two over 1.3. With kWorthIt =
  // 0.9, they took the same time.
  constexpr double kMeeting = 700;
  constexpr double kWorthIt = 0.8;
  for (bool helps = true; helps;) {
    const bool was_active = cover.active;
    if (!refine_cover(plan, p, q, kMeeting * seen.left, scratch.cover)) break;
    const SampledMeetings before = std::exchange(seen, sample_meetings(numbers, clipper, scratch));
    helps = seen.left <= kWorthIt * before.left || seen.are_few > before.are_few;
    // Looking at the cells of a cover takes time, too.
    cover.active = helps || was_active;
    may_be_hidden = cover.active;
  }
  if (!seen.are_few) return nullptr;
  drop();
  // Half as many again as the sample may have told.
  const double most_of_all = 2.25 * most_right_meetings(segments.size);
  if (seen.saved > seen.most_saved) clipper.clip(segments);
  return meet(numbers, extent, scratch, most_of_all);
}

template <class Number>
class VerticesOf final : public SmallVertices {
 public:
  VerticesOf(const WayFractions<Number>& ways, const SmallSegments& segments,
             SmallWriter<Number>& writer)
      : ways_(ways), segments_(segments), writer_(writer) {}
  void append(std::span<const SmallCorner> corners, std::vector<SmallVertex>& vertices) override {
    for (const SmallCorner& corner : corners) {
      vertices.push_back(writer_.vertex(ways_, segments_, corner));
    }
  }
  [[nodiscard]] double turn(std::uint32_t in, std::uint32_t out) const override {
    return ways_.turn(in, out);
  }

 private:
  const WayFractions<Number>& ways_;
  const SmallSegments& segments_;
  SmallWriter<Number>& writer_;
};

template <bool kSeveral, class Number>
bool walk(const SmallNumbers<Number>& numbers, const SmallOperand& p, const SmallOperand& q,
          const SmallPlan& plan, const SmallSegments& segments, SmallScratch::State& scratch,
          Region& result) {
  SmallBoundary& boundary = scratch.boundary;
  SmallPlacement placement(width_of(p, q), p, q, plan.with_holes, scratch.placement);
  BoundaryWalk<Number, kSeveral> walk(numbers, segments, scratch.meetings, placement, scratch.marks,
                                      boundary);
  // The sum of the smallest points of both operands is the sum's smallest point.
  if (!walk.run(p.at(), p.smallest, q.at(), q.smallest)) return false;
  const WayFractions<Number> ways(numbers, segments);
  const std::uint32_t outer = kSeveral ? boundary.size : boundary.end_of[0];
  SmallWriter<Number> writer(numbers, p, q, outer, boundary.between, result);
  VerticesOf<Number> vertices(ways, segments, writer);
  RingWriter rings(vertices, boundary, width_of(p, q), scratch.rings, result);
  if constexpr (kSeveral) {
    writer.finish();  // no vertices yet
    return rings.add_polygons();
  }
  for (std::uint32_t k = 0; k < outer; ++k) writer.add(ways, segments, boundary.corners[k]);
  if (boundary.end_of.size() > 1) rings.add_holes();
  return true;
}

template <class Number>
bool walk(const SmallNumbers<Number>& numbers, const SmallOperand& p, const SmallOperand& q,
          const SmallPlan& plan, SmallScratch::State& scratch, Region& result) {
  SmallSegments& segments = scratch.segments;
  cover_small(plan, p, q, scratch.cover);
  const auto list = [&]() __attribute__((always_inline)) {
    return list_segments(numbers, p, q, plan.with_holes, segments);
  };
  if (!with_vectors(widest_vectors(), list)) return false;
  if (p.has_ring_of(q)) drop_copies(p, width_of(p, q), segments);
  const SmallSegments* const met = meet_or_give_up(numbers, plan, p, q, scratch);
  if (met == nullptr) return false;
  if constexpr (SmallOperand::kMayHaveSeveral) {
    if (p.has_several() || q.has_several()) {
      return walk<true>(numbers, p, q, plan, *met, scratch, result);
    }
  }
  return walk<false>(numbers, p, q, plan, *met, scratch, result);
}

}  // namespace

SmallScratch::SmallScratch() = default;
SmallScratch::~SmallScratch() = default;

SmallScratch::State& SmallScratch::state() {
  if (!state_) state_ = std::make_unique_for_overwrite<State>();
  return *state_;
}

bool allow_small(const Limits& limits) {
  constexpr std::uint64_t kMost = SmallSegments::kMax;
  return limits.max_segments >= std::max<std::uint64_t>(kMost, 2 * SmallOperand::kMaxVertices) &&
         limits.max_crossings >= SmallMeetings::kMax;
}

void bring_to_one_grid(const SmallPlan& plan, std::array<const SmallOperand*, 2>& operands,
                       std::array<SmallOperand, 2>& memory) {
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    const SmallOperand& o = *operands[i];
    if (o.exp2 == plan.exp2 && o.exp10 == plan.exp10) continue;
    refine(plan.exp2, plan.exp10, plan.with_holes[i] ? o.entries : o.size, o, memory[i]);
    operands[i] = &memory[i];
  }
}

SmallPlan plan_sum(const SmallOperand& p, const SmallOperand& q) {
  SmallPlan plan;
  if (p.has_several() && q.has_several()) return plan;
  plan.exp2 = std::min(p.exp2, q.exp2);
  plan.exp10 = std::min(p.exp10, q.exp10);
  const Refinement of_p = refinement(plan.exp2, plan.exp10, p);
  const Refinement of_q = refinement(plan.exp2, plan.exp10, q);
  if (of_p.steps == 0 || of_q.steps == 0) return {};
  plan.with_holes = {may_fit(p, of_p, q, of_q), may_fit(q, of_q, p, of_p)};
  plan.convex = p.convex && q.convex && !plan.with_holes[0] && !plan.with_holes[1];
  const auto size = [](const SmallOperand& o, bool with_holes) {
    return static_cast<double>(with_holes ? o.entries : o.size);
  };
  const auto turning = [](const SmallOperand& o, bool with_holes) {
    return o.turning + (with_holes ? o.turning_of_holes : 0);
  };
  const double width = std::max(p.extent.x * of_p.steps + q.extent.x * of_q.steps,
                                p.extent.y * of_p.steps + q.extent.y * of_q.steps);
  const double longest_p = p.longest * of_p.steps;
  const double longest_q = q.longest * of_q.steps;
  plan.numbers = small_numbers(of_p.rounded || of_q.rounded, std::max(longest_p, longest_q), width);
  if (plan.convex) return plan;
  // Doubles hardly tell edges apart that are as short as places are rounded. A walk decides nearly
  // all pairs of these exactly; the stages move them to the origin first. Of 373 sums with an
  // operand that is 2^36 to 2^52 times as large as the other one, 22 take over 1.5 times as long as
  // by the faster way, and some 75 without this limit. With 2, 32 and 128, 40, 21 and 25 do.
  constexpr double kShort = 8;
  if (plan.numbers == SmallNumberType::kWide &&
      std::min(longest_p, longest_q) < kShort * reach_of(width)) {
    return {};
  }
  const double m = size(p, plan.with_holes[0]);
  const double n = size(q, plan.with_holes[1]);
  plan.segments = m * turning(q, plan.with_holes[1]) + n * turning(p, plan.with_holes[0]);
  // Listing the segments compares each vertex with each edge, in 1 ns or half of that. The stages
  // take longer than a walk for each vertex and for each segment. Of 4,500 random sums, 151 walk
  // because of their segments, and take 0.77 of the stages' time. With 32 for a segment, 16 more
  // would walk, in 0.96 of that time. With 32 for a vertex, others took up to 3 times as long.
  const double pairs_for_vertex = plan.numbers == SmallNumberType::kDoubles ? 128 : 64;
  constexpr double kPairsForSegment = 16;
  const double most = pairs_for_vertex * (m + n) + kPairsForSegment * plan.segments;
  return plan.segments <= SmallSegments::kMax && m * n <= most ? plan : SmallPlan{};
}

bool sum_small(const SmallPlan& plan, const SmallOperand& p, const SmallOperand& q,
               SmallScratch& scratch, Region& result) {
  const double width = width_of(p, q);
  if (plan.convex) {
    scratch.set_counts(p.size + q.size, p.size + q.size);
    with_numbers<WideNumber>(plan.numbers, width,
                             [&](const auto& numbers) { merge_convex(numbers, p, q, result); });
    return true;
  }
  SmallScratch::State& state = scratch.state();
  const bool done = with_numbers<WideNumber>(plan.numbers, width, [&](const auto& numbers) {
    return walk(numbers, p, q, plan, state, result);
  });
  scratch.set_counts(state.segments.size + state.segments.left_out, state.segments.size);
  return done;
}

bool sum_small(const SmallOperand& p, const SmallOperand& q, SmallScratch& scratch,
               Region& result) {
  const SmallPlan plan = plan_sum(p, q);
  if (plan.numbers == SmallNumberType::kNone) return false;
  std::array<const SmallOperand*, 2> operands{&p, &q};
  std::array<SmallOperand, 2> memory;
  bring_to_one_grid(plan, operands, memory);
  return sum_small(plan, *operands[0], *operands[1], scratch, result);
}

}  // namespace minksum
