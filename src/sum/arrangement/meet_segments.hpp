// Finds the points that two kept segments share.
#pragma once

#include <cmath>

#include "minksum/testing.hpp"
#include "sum/arrangement/arrangement.hpp"

namespace minksum {

/// A part of the plane. The parts of a grid are half-open, so each point is in exactly one of them.
struct PlanePart : BoxOf<double> {
  /// Makes the whole plane.
  PlanePart() : BoxOf{-HUGE_VAL, -HUGE_VAL, HUGE_VAL, HUGE_VAL} {}
  PlanePart(const BoxOf& box) : BoxOf(box) {}
  [[nodiscard]] bool contains(const Vec<double>& p) const {
    return p.x >= x0 && p.x < x1 && p.y >= y0 && p.y < y1;
  }
};

/// Throws if there are more crossings than `most`.
void limit_crossings(std::size_t crossings, std::uint64_t most);
/// Returns the most crossings that may be found.
[[nodiscard]] inline std::uint64_t most_crossings(const Limits& limits) {
  return std::min(limits.max_crossings, kMostNumbered);
}

/// Finds the points that pairs of segments share, in one part after the other.
///
/// A pair may be listed in several parts. A shared point is added in the part that contains it:
/// both segments are listed there. If doubles do not tell the point well enough to choose a part,
/// it is added in each of them. Then the same events are listed more than once, which does no harm.
class SegmentMeeter {
 public:
  /// All coordinates are in [0, extent]. What is found is added to `meetings` and to the forests of
  /// `scratch`. Unless it is `alone`, other threads add to the same forests.
  SegmentMeeter(double extent, const SumSettings& options, Predicates& predicates,
                ArrangementScratch& scratch, const std::vector<KeptSegment>& kept,
                Meetings& meetings, bool alone);

  /// Meets the same segments at places that were moved and rounded anew, none of which is beyond
  /// `extent`. What was moved to (0, 0) is at `origin` for the other meeter, in whose part points
  /// are wanted. That meeter must stay.
  SegmentMeeter(const SegmentMeeter& other, double extent, const std::vector<KeptSegment>& moved,
                const Vec<double>& origin);

  /// Returns a segment, moved so that `origin` starts at (0, 0). It is rounded once.
  [[nodiscard]] KeptSegment moved(KeptId origin, KeptId s) const;
  [[nodiscard]] RoundingBounds bounds_of_moved(double extent) const {
    return bounds_.moved_to(extent);
  }
  /// Counts decisions that others have taken in doubles.
  void count(std::uint64_t decisions) { predicates_.count_filtered(decisions); }
  /// Whether places can be moved to such an extent. Not if doubles are not trusted, or if moved
  /// places may be too small for them.
  [[nodiscard]] bool can_move_to(double extent) const { return trust_ && extent > 0x1p-900; }
  /// Sets the part in which points are wanted from now on.
  void enter(const PlanePart& part) { part_ = part; }
  /// Sets a cover, in whose cells no points are wanted; null if nothing is covered.
  void hide(const Cover* cover) { cover_ = cover; }
  /// Unites ends of s and t that coincide, and adds crossings and events. s must be less than t.
  /// O(1): at most four orientations.
  void meet(KeptId s, KeptId t);
  /// Returns the list of hidden parts.
  [[nodiscard]] std::vector<HiddenPart>& hidden() { return meetings_.hidden; }
  /// Returns the distance from a part within which segments are listed in it.
  [[nodiscard]] double slack() const { return slack_; }
  /// Returns a bound on the error of a segment's place.
  [[nodiscard]] double doubt() const { return bounds_.position; }

 private:
  /// Where the ends of a segment lie relative to another one's line.
  struct Sides {
    double start_value;  ///< approximate cross product of the start
    double end_value;
    double bound;  ///< bound on the error of both values; infinite if the kernel was asked
    Sign start;
    Sign end;
    [[nodiscard]] bool apart() const { return start == end && start != kZero; }
  };
  /// The distance of a segment's line from (0, 0), which has a sign, and a bound on its error.
  struct LineOffset {
    double value;
    double error;
  };
  struct Parameter {
    double lambda;
    double error;
  };

  [[nodiscard]] SumVertex start(KeptId s) const {
    return Predicates::start_vertex(kept_[s].segment);
  }
  [[nodiscard]] SumVertex end(KeptId s) const {
    return predicates_.end_vertex(last_segment(kept_[s], scratch_.join));
  }
  /// Returns an end of a segment by its number as a point, 2s or 2s + 1.
  [[nodiscard]] SumVertex vertex(std::uint32_t point) const {
    return point % 2 == 0 ? start(point / 2) : end(point / 2);
  }
  [[nodiscard]] const Vec<double>& place(std::uint32_t point) const {
    const KeptSegment& s = kept_[point / 2];
    return point % 2 == 0 ? s.a : s.b;
  }

  [[nodiscard]] Sides sides(KeptId s, KeptId t);
  [[nodiscard]] Sign side(KeptId s, std::uint32_t point, double& value, double& bound);
  [[nodiscard]] bool coincide(std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] bool meet_at_ends(KeptId s, KeptId t);
  void touch(KeptId s, const Sides& of_s, std::uint32_t point);
  [[nodiscard]] bool clearly_apart(KeptId s, KeptId t) const;
  [[nodiscard]] LineOffset offset_of(KeptId segment) const;
  void meet_parallel(KeptId s, KeptId t);
  void meet_on_line(KeptId s, std::uint32_t point);
  void cross_at(KeptId s, const Sides& of_s, KeptId t, const Sides& of_t);
  void add_vertex_event(KeptId s, std::uint32_t point);
  [[nodiscard]] Parameter crossing_parameter(KeptId s, const Sides& of_s, KeptId t);
  [[nodiscard]] Parameter from_kernel(KeptId s, const PointOnSegment& point);
  [[nodiscard]] bool mine(const Vec<double>& p, double error) const {
    if (error < slack_ / 2 && !(part_.contains(p) && (cover_ == nullptr || !is_hidden(p)))) {
      return false;
    }
    return other_ == nullptr ||
           other_->mine({origin_.x + p.x, origin_.y + p.y}, error + other_->bounds_.position);
  }
  [[nodiscard]] bool is_hidden(const Vec<double>& p) const {
    return cover_->is_covered(cover_->grid.column(p.x), cover_->grid.row(p.y));
  }
  /// Returns an infinite error if doubles are not trusted. Then the kernel decides every order.
  [[nodiscard]] double doubted(double error) const { return trust_ ? error : HUGE_VAL; }

  void join(std::vector<std::uint32_t>& parent, std::uint32_t a, std::uint32_t b) const {
    if (alone_) return unite(parent, a, b);
    unite_shared(parent, a, b);
  }

  Predicates& predicates_;
  ArrangementScratch& scratch_;
  Meetings& meetings_;
  bool alone_;
  const std::vector<KeptSegment>& kept_;
  const std::vector<KeptSegment>& unmoved_;  ///< the members of joined segments, too
  const RoundingBounds bounds_;
  std::uint64_t most_crossings_;
  double extent_;
  double slack_;
  bool exact_;  ///< whether cross products have no rounding
  bool trust_;
  PlanePart part_;
  const Cover* cover_ = nullptr;
  const SegmentMeeter* other_ = nullptr;  ///< which meets what was not moved; null if this one does
  Vec<double> origin_{};                  ///< where that one has what was moved to (0, 0)
};

}  // namespace minksum
