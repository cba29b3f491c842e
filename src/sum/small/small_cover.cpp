#include "sum/small/small_cover.hpp"

#include <algorithm>
#include <cmath>

namespace minksum {
namespace {

/// Returns the edges of all rings of an operand, or those of its outer ring.
EdgesOfOperand edges_of(const SmallOperand& o, bool with_holes, std::vector<SiteId>& next) {
  next.clear();
  const auto add_ring = [&](SiteId end) {
    // Between two rings are edges of length zero.
    while (next.size() % kLanes != 0) next.push_back(static_cast<SiteId>(next.size()));
    const auto begin = static_cast<SiteId>(next.size());
    while (next.size() + 1 < end) next.push_back(static_cast<SiteId>(next.size() + 1));
    next.push_back(begin);
  };
  add_ring(o.size);
  if (with_holes) std::for_each(o.ends.begin(), o.ends.end(), add_ring);
  const auto count = static_cast<SiteId>(next.size());
  return {o[SmallOperand::kX], o[SmallOperand::kY], next.data(), 0, count, o.extent};
}

}  // namespace

void cover_small(const SmallPlan& plan, const SmallOperand& p, const SmallOperand& q,
                 SmallCover& cover) {
  cover.cover.active = false;
  // With fewer segments, a cover took as long as it saved, or longer: of 500 sums of 250 to 700
  // segments, it made 1.0 to 1.2 of the time.
  constexpr double kFewest = 700;
  if (plan.segments < kFewest) return;
  double run = 0;
  double rise = 0;
  const auto add = [&](const SmallOperand& o, double turning) {
    double run_of_edges = 0;
    double rise_of_edges = 0;
    for (std::uint32_t e = 0; e < o.size; ++e) {
      run_of_edges += std::abs(o[SmallOperand::kDx][e]);
      rise_of_edges += std::abs(o[SmallOperand::kDy][e]);
    }
    run += run_of_edges * turning;
    rise += rise_of_edges * turning;
  };
  add(p, q.turning);
  add(q, p.turning);
  // If half of the segments were horizontal and half vertical, and all were anywhere in the sum's
  // box, they would have this many crossings. Where there is hardly one for 50 segments, one
  // operand is small beside the other's features, and nothing is covered. With 0.01 or 0.04, 209
  // sums took 1.01 times as long on the geometric mean.
  constexpr double kFewCrossings = 0.02;
  const double crossings = run * rise / ((p.extent.x + q.extent.x) * (p.extent.y + q.extent.y));
  if (crossings < kFewCrossings * plan.segments) return;
  // What a segment takes, in words moved: 60, 90 and 130 ns.
  const double price = plan.numbers == SmallNumberType::kDoubles   ? 430
                       : plan.numbers == SmallNumberType::kRounded ? 640
                                                                   : 930;
  const EdgesOfOperands edges{edges_of(p, plan.with_holes[0], cover.next[0]),
                              edges_of(q, plan.with_holes[1], cover.next[1])};
  Cancellation never;
  cover_cheaply(edges, plan.segments, price * plan.segments, never, cover.scratch, cover.cover);
}

}  // namespace minksum
