// Declares how the segments of a crowded part of the plane are met.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "spatial/median_division.hpp"
#include "sum/arrangement/meet_segments.hpp"

namespace minksum {

/// Meets the pairs of segments of a part of the plane that may share a point there.
///
/// A part is divided at medians until few segments are left in each. Segments that pass a strip
/// from side to side share points only if their order changes from one side to the other, so such
/// crowds are sorted and not divided. For k segments this takes O(k log k) time, and a meeting for
/// each pair that is near, unless segments end in one point or run side by side within rounding.
///
/// Where one operand is far larger than the other, the other's edges at one of its vertices are too
/// near one another to be divided. They become a group: they are moved to the origin, so that
/// doubles tell them apart again, and are divided there. A longer segment near a group is compared
/// with each of its members.
///
/// A part that lies inside the sum is left out. Whether it does is tried with the sums of two edges
/// next to the segments around it.
class CrowdFinder {
 public:
  /// All coordinates are in [0, extent]. No part is left out if `hiding` is null.
  CrowdFinder(double extent, const std::vector<KeptSegment>& kept, SegmentMeeter& meeter,
              CrowdScratch& scratch, const Operands* hiding, Cancellation& cancellation)
      : kept_(kept),
        hiding_(hiding),
        meeter_(meeter),
        scratch_(scratch),
        items_(scratch.items),
        cancellation_(cancellation),
        division_(*this, items_, meeter.slack(), cancellation),
        shortest_(extent * 0x1p-30),
        cut_error_(extent * 0x1p-44 + meeter.doubt()),
        short_(Division::kLeastSlacks * meeter.slack()) {
    items_.clear();
  }

  /// Adds a segment, if it is near the part.
  void add(KeptId segment, const PlanePart& part);
  /// Meets the segments that were added, and forgets them.
  void solve(const PlanePart& part);
  /// Divides the part, and lists what is left: parts of at most so many segments, and crowds.
  /// Groups are in the scratch of this finder.
  void split(const PlanePart& part, std::size_t most, std::vector<UndividedPart>& undivided);
  /// Divides further what another `split` has listed.
  void split(UndividedPart& given, std::size_t most, std::vector<UndividedPart>& undivided) {
    division_.split(given, most, undivided);
  }
  /// Meets the segments of what `split` has listed.
  void solve(UndividedPart& undivided, const SegmentGroups& groups) {
    groups_ = &groups;
    division_.divide(undivided);
  }
  /// Meets the members of one of the groups.
  void solve(std::size_t group, const SegmentGroups& groups) {
    groups_ = &groups;
    meeter_.enter({});
    meet_members(group);
  }

 private:
  using Division = MedianDivision<CrowdFinder>;
  struct Parallelogram;
  friend Division;

  // What the division asks for.
  bool enter(std::size_t above, std::size_t begin, std::size_t end, const BoxOf<double>& box,
             const BoxOf<double>& part) {
    meeter_.enter(part);
    return hiding_ == nullptr || !hide(above, begin, end, box);
  }
  template <Axis axis>
  [[nodiscard]] bool cut(KeptId segment, double at, LineCut& result) const {
    if (segment >= kept_.size()) return false;
    const auto [a, b] = kept_[segment].clipped();
    return cut_segment<axis>(a, b, at, shortest_, cut_error_, result);
  }
  [[nodiscard]] std::optional<DividingLine> line_among_crossings(std::size_t begin, std::size_t end,
                                                                 const BoxOf<double>& part) const;
  void meet_few(std::size_t begin, std::size_t end);
  [[nodiscard]] bool hide(std::size_t above, std::size_t begin, std::size_t end,
                          const BoxOf<double>& box);
  [[nodiscard]] bool hide_by(const Parallelogram& shape, std::size_t begin, std::size_t end);
  void sort_along(Axis axis, std::vector<BoxedSegment>& items, std::size_t begin,
                  std::size_t end) const;
  void meet_crowd(std::size_t begin, std::size_t end, const BoxOf<double>& box);
  [[nodiscard]] bool is_sorted_soon(std::size_t begin, std::size_t end,
                                    const BoxOf<double>& box) const;

  [[nodiscard]] bool passes(const BoxedSegment& item, const BoxOf<double>& box, Axis axis) const;
  [[nodiscard]] std::size_t count_ending(std::size_t begin, std::size_t end,
                                         const BoxOf<double>& box, Axis axis) const;
  double list_lines(std::size_t begin, std::size_t end, const BoxOf<double>& box, Axis axis);
  void meet_ending(std::size_t begin, std::size_t end, const BoxOf<double>& box);
  void group_short();
  void add_group(std::size_t begin, std::size_t end);
  [[nodiscard]] std::size_t gap_after(std::size_t begin, std::size_t end, Axis axis) const;
  [[nodiscard]] double move_short(std::size_t begin, std::size_t end);
  void meet_members(std::size_t group);
  void meet_group(const BoxedSegment& group, const BoxedSegment& other);
  static double size(const Vec<double>& v) { return std::max(std::abs(v.x), std::abs(v.y)); }
  [[nodiscard]] bool is_short(KeptId segment) const { return size(kept_[segment].d) <= short_; }
  [[nodiscard]] bool is_group(const BoxedSegment& item) const {
    return item.segment >= kept_.size();
  }
  void meet_ending_with_lines(std::size_t begin, std::size_t end, Axis axis, double error);
  void meet_lines(double error);
  void meet(const BoxedSegment& a, const BoxedSegment& b) {
    if (a.x0 > b.x1 || b.x0 > a.x1 || a.y0 > b.y1 || b.y0 > a.y1) return;
    if (is_group(a)) return meet_group(a, b);
    if (is_group(b)) return meet_group(b, a);
    meeter_.meet(std::min(a.segment, b.segment), std::max(a.segment, b.segment));
  }

  const std::vector<KeptSegment>& kept_;
  const Operands* hiding_;  ///< whose edges hide parts; null if no part is to be left out
  SegmentMeeter& meeter_;
  CrowdScratch& scratch_;
  std::vector<BoxedSegment>& items_;
  Cancellation& cancellation_;
  Division division_;
  double shortest_;              // the least extent along an axis over which a slope is good enough
  double cut_error_;             // bound on the error of a cut, over 2 + |slope|
  double short_;                 // the extent of segments that division cannot tell apart
  std::size_t short_count_ = 0;  // of those that were added
  const SegmentGroups* groups_ = nullptr;
};

}  // namespace minksum
