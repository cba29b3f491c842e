// Orders the events along each segment.
#pragma once

#include <cstdint>

#include "sum/arrangement/arrangement.hpp"

namespace minksum {

/// Tells what the numbers of points stand for.
class SharedPoints {
 public:
  SharedPoints(const Predicates& predicates, const ArrangementScratch& scratch,
               const Arrangement& arrangement)
      : predicates_(predicates),
        scratch_(scratch),
        arrangement_(arrangement),
        ends_(static_cast<std::uint32_t>(2 * arrangement.kept.size())) {}

  /// Points of lower numbers are ends of segments.
  [[nodiscard]] std::uint32_t ends() const { return ends_; }
  [[nodiscard]] SumVertex end(std::uint32_t end_point) const {
    const KeptSegment& s = arrangement_.kept[end_point / 2];
    return end_point % 2 == 0 ? Predicates::start_vertex(s.segment)
                              : predicates_.end_vertex(last_segment(s, scratch_.join));
  }
  [[nodiscard]] PointOnSegment on(KeptId s, std::uint32_t point) const {
    if (point < ends_) return {false, {}, end(point)};
    return {true, arrangement_.kept[other(s, point)].segment, {}};
  }
  [[nodiscard]] KeptId other(KeptId s, std::uint32_t crossing_point) const {
    const Crossing& crossing = scratch_.crossings[crossing_point - ends_];
    return crossing.first == s ? crossing.second : crossing.first;
  }

 private:
  const Predicates& predicates_;
  const ArrangementScratch& scratch_;
  const Arrangement& arrangement_;
  std::uint32_t ends_;
};

/// Groups events by segment, orders them along each, and unites equal ones.
void order_events(Predicates& predicates, ArrangementScratch& scratch,
                  const Arrangement& arrangement);

}  // namespace minksum
