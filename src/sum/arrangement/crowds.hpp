// Declares how the segments of a crowded part of the plane are met.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "machine/make_room.hpp"
#include "sum/arrangement/meet_segments.hpp"

namespace minksum {

/// Meets the pairs of segments of a part of the plane that may share a point there.
///
/// A part is divided at medians, along x or y, until few segments are left in each. Boxes are cut
/// to each part. Segments that pass a strip from side to side share points only if their order
/// changes from one side to the other, so such crowds are sorted and not divided. For k segments
/// this takes O(k log k) time, and a meeting for each pair that is near, unless segments end in one
/// point or run side by side within rounding.
class CrowdFinder {
 public:
  /// All coordinates are in [0, extent].
  CrowdFinder(double extent, const std::vector<KeptSegment>& kept, SegmentMeeter& meeter,
              CrowdScratch& scratch, Cancellation& cancellation)
      : kept_(kept),
        meeter_(meeter),
        scratch_(scratch),
        items_(scratch.items),
        cancellation_(cancellation),
        slack_(meeter.slack()),
        shortest_(extent * 0x1p-30),
        cut_error_(extent * 0x1p-44 + meeter.doubt()) {
    items_.clear();
  }

  /// Adds a segment, if it is near the part.
  void add(KeptId segment, const PlanePart& part);
  /// Meets the segments that were added, and forgets them.
  void solve(const PlanePart& part) {
    divide(0, items_.size(), part, kMaxPoor);
    items_.clear();
  }

 private:
  static constexpr std::size_t kFew = 16;  ///< comparing all pairs costs less than dividing
  /// A division is poor if it leaves many segments in both halves, but it may make way for good
  /// ones. On the way to a part, at most so many more poor divisions than good ones are made.
  static constexpr int kMaxPoor = 4;

  /// Where to divide some items.
  struct Division {
    bool by_x = true;
    double at = 0;
    std::size_t in_both = 0;  ///< items that are in both halves
    std::size_t in_less = 0;  ///< items that are in the lesser half alone
  };

  /// Calls work(item) for the items [begin, end), and looks at the token in between.
  template <class Work>
  void visit(std::size_t begin, std::size_t end, Work work) const {
    in_pieces(end - begin, cancellation_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = begin + first; i < begin + last; ++i) work(items_[i]);
    });
  }
  [[nodiscard]] bool cut_x(CrowdItem& item, double at, bool low) const;
  [[nodiscard]] bool cut_y(CrowdItem& item, double at, bool low) const;
  [[nodiscard]] CrowdItem bounds_of(std::size_t begin, std::size_t end) const;
  [[nodiscard]] Division division(std::size_t begin, std::size_t end, bool by_x) const;
  void divide(std::size_t begin, std::size_t end, const PlanePart& part, int poor);
  void meet_all(std::size_t begin, std::size_t end);
  [[nodiscard]] bool passes(const CrowdItem& item, const CrowdItem& box, bool by_x) const;
  [[nodiscard]] std::size_t count_ending(std::size_t begin, std::size_t end, const CrowdItem& box,
                                         bool by_x) const;
  void meet_in_strip(std::size_t begin, std::size_t end, const CrowdItem& box);
  double list_lines(std::size_t begin, std::size_t end, const CrowdItem& box, bool by_x);
  void meet_ending(std::size_t begin, std::size_t end, const CrowdItem& box);
  void meet_ending_with_lines(std::size_t begin, std::size_t end, bool by_x, double error);
  void meet_lines(double error);
  void meet(const CrowdItem& a, const CrowdItem& b) {
    if (a.x0 > b.x1 || b.x0 > a.x1 || a.y0 > b.y1 || b.y0 > a.y1) return;
    meeter_.meet(std::min(a.segment, b.segment), std::max(a.segment, b.segment));
  }

  const std::vector<KeptSegment>& kept_;
  SegmentMeeter& meeter_;
  CrowdScratch& scratch_;
  std::vector<CrowdItem>& items_;  // a stack: a part's items lie below those of its halves
  Cancellation& cancellation_;
  double slack_;
  double shortest_;   // the least extent along an axis over which a slope is good enough
  double cut_error_;  // bound on the error of a cut, over 2 + |slope|
};

}  // namespace minksum
