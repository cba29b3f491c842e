#include "sum/small/small_cover.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace minksum {
namespace {

/// Returns the edges of all rings that are linked.
EdgesOfOperand edges_of(const SmallOperand& o, const SmallLinks& links) {
  const auto count = static_cast<SiteId>(links.next.size());
  return {o[SmallOperand::kX], o[SmallOperand::kY], links.next.data(), 0, count, o.extent};
}

/// Returns what two boxes have in common.
BoxOf<double> common(const BoxOf<double>& a, const BoxOf<double>& b) {
  return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

/// Makes the box of a part of a segment as small as what is near uncovered cells.
void see_part(const Cover& cover, const Line& line, BoxOf<double>& box) {
  // In units of cells.
  BoxOf<double> part{HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  cover.grid.walk_rows(line.start, line.end, UniformGrid::kMargin, [&](const auto& span) {
    const auto add = [&](std::int32_t word, std::uint64_t covered, std::uint64_t wanted) {
      const std::uint64_t seen = wanted & ~covered;
      if (seen == 0) return;
      const int from = 64 * word + std::countr_zero(seen);
      const int to = 64 * word + static_cast<int>(std::bit_width(seen));
      part.add({std::max<double>(span.x0, from), span.y0, std::min<double>(span.x1, to), span.y1});
    };
    cover.covered.visit_words(span.row, span.left, span.right, add);
    return true;
  });
  // Spans and coordinates in cells are rounded by far less than the margin.
  constexpr double kMargin = 2 * UniformGrid::kMargin;
  const Vec<double>& cell = cover.grid.cell;
  box = common(box, {(part.x0 - kMargin) * cell.x, (part.y0 - kMargin) * cell.y,
                     (part.x1 + kMargin) * cell.x, (part.y1 + kMargin) * cell.y});
}

}  // namespace

void cover_small(const SmallPlan& plan, const SmallOperand& p, const SmallOperand& q,
                 SmallCover& cover) {
  cover.cover.active = false;
  cover.bought = {};
  cover.crossings = 0;
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
  cover.crossings =
      run * rise / ((p.extent.x + q.extent.x) * (p.extent.y + q.extent.y) * plan.segments);
  if (cover.crossings < kFewCrossings) return;
  // What a segment takes, in words moved: 60, 90 and 130 ns.
  const double price = plan.numbers == SmallNumberType::kDoubles   ? 430
                       : plan.numbers == SmallNumberType::kRounded ? 640
                                                                   : 930;
  link_rings(p, plan.with_holes[0], cover.links[0]);
  link_rings(q, plan.with_holes[1], cover.links[1]);
  static_cast<void>(refine_cover(plan, p, q, price * plan.segments, cover));
}

bool refine_cover(const SmallPlan& plan, const SmallOperand& p, const SmallOperand& q, double price,
                  SmallCover& cover) {
  const EdgesOfOperands edges{edges_of(p, cover.links[0]), edges_of(q, cover.links[1])};
  Cancellation never;
  return cover_cheaply(edges, plan.segments, price, never, cover.scratch, cover.bought,
                       cover.cover);
}

void link_rings(const SmallOperand& o, bool with_holes, SmallLinks& links) {
  links.next.clear();
  links.previous.clear();
  const auto add_ring = [&](SiteId end) {
    // Between two rings are edges of length zero.
    for (auto* row : {&links.next, &links.previous}) {
      while (row->size() % kLanes != 0) row->push_back(static_cast<SiteId>(row->size()));
    }
    const auto begin = static_cast<SiteId>(links.next.size());
    for (SiteId v = begin; v < end; ++v) {
      links.next.push_back(v + 1 == end ? begin : v + 1);
      links.previous.push_back((v == begin ? end : v) - 1);
    }
  };
  const auto rings = static_cast<std::ptrdiff_t>(with_holes ? o.ends.size() : o.outer_rings);
  std::for_each(o.ends.begin(), o.ends.begin() + rings, add_ring);
}

SmallClipper::SmallClipper(const SmallPlan& plan, const SmallOperand& p, const SmallOperand& q,
                           double width, SmallCover& cover)
    : clipper_(RoundingBounds::of(width, plan.numbers != SmallNumberType::kWide, false)),
      cover_(cover.cover),
      slack_(reach_of(width)) {
  const std::array operands{&p, &q};
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    const SmallOperand& o = *operands[i];
    SmallLinks& links = cover.links[i];
    link_rings(o, plan.with_holes[i], links);
    rings_[i] = {o[SmallOperand::kX], o[SmallOperand::kY], links.next.data(),
                 links.previous.data()};
  }
}

void SmallClipper::clip(SmallSegments& s) const {
  std::uint32_t kept = 0;
  for (std::uint32_t i = 0; i < s.size; ++i) {
    const SegmentOrigin origin = s.origin[i];
    const Clip clip = clipper_.clip(s.way()[i], rings_[origin.of_first], origin.vertex);
    if (clip.is_empty()) continue;
    const Vec<double> start = s.at()[i];
    const Vec<double> way = s.way()[i];
    const BoxOf<double> whole = box_of_segment(start.x, start.y, way.x, way.y);
    const Line line = clip.of({start, plus(start, way)});
    const Vec<double> d = minus(line.end, line.start);
    BoxOf<double> box = common(whole, box_of_segment(line.start.x, line.start.y, d.x, d.y));
    if (cover_.active) see_part(cover_, line, box);
    if (box.x0 > box.x1 || box.y0 > box.y1) continue;
    s.copy(s, i, kept);
    s.set_part(kept++, moved(box, {}, slack_));
  }
  s.left_out += s.size - kept;
  s.size = kept;
  s.in_part = true;
}

}  // namespace minksum
