// Finds the touches of segments that do not cross, and the segments that do.
#include <algorithm>
#include <span>

#include "machine/make_room.hpp"
#include "overlay/subdivision.hpp"
#include "spatial/segment_sweep.hpp"

namespace minksum::overlay {
namespace {

class ContactSweeper {
 public:
  ContactSweeper(const Segments& segments, std::vector<Touch>& touches)
      : segments_(segments),
        cancellation_(segments.cancellation()),
        touches_(touches),
        suspect_(segments.list.size(), 0),
        sweep_(*this, cancellation_, scratch_) {}

  [[nodiscard]] std::vector<std::uint8_t> run() {
    const std::size_t count = segments_.list.size();
    sweep_.start(count);
    list_by([](const Ends& ends) { return ends.low; }, first_starting_, starting_);
    list_by([](const Ends& ends) { return ends.high; }, first_ending_, ending_);
    for (PointId p = 0; p < segments_.sources.size(); ++p) {
      cancellation_.check(8);
      pass(p, at(p, first_starting_, starting_), at(p, first_ending_, ending_));
    }
    return std::move(suspect_);
  }

  // What SegmentSweep asks for.
  [[nodiscard]] PointId low_end(SegmentId s) const { return segments_.list[s].ends.low; }
  [[nodiscard]] PointId high_end(SegmentId s) const { return segments_.list[s].ends.high; }
  [[nodiscard]] static PointId place(PointId p) { return p; }
  [[nodiscard]] Sign side(SegmentId s, PointId p) const {
    return segments_.predicates.orientation(segments_.list[s].ends, p);
  }
  void suspect(SegmentId s) { suspect_[s] = 1; }
  [[nodiscard]] bool is_suspect(SegmentId s) const { return suspect_[s] != 0; }
  void started(SegmentId, SlotId) {}

 private:
  /// Lists the segments by one of their ends.
  template <class End>
  void list_by(End end, std::vector<std::uint32_t>& first, std::vector<SegmentId>& list) {
    list_by_key(segments_.sources.size(), cancellation_, first, list, [&](auto visit) {
      SegmentId s = 0;
      visit_in_pieces(segments_.list, cancellation_,
                      [&](const Segment& segment) { visit(end(segment.ends), s++); });
    });
  }
  [[nodiscard]] static std::span<SegmentId> at(PointId p, const std::vector<std::uint32_t>& first,
                                               std::vector<SegmentId>& list) {
    return std::span(list).subspan(first[p], first[p + 1] - first[p]);
  }

  void pass(PointId p, std::span<SegmentId> starting, std::span<const SegmentId> ending) {
    if (starting.empty() && ending.empty() && segments_.belongs[p] == 0) return;
    cancellation_.check(starting.size() + ending.size());
    const auto placed =
        std::ranges::find_if(ending, [&](SegmentId s) { return sweep_.has_place(s); });
    const SegmentId passing = sweep_.arrive(p, placed != ending.end() ? *placed : kNone);
    if (passing != kNone) touches_.push_back({passing, p});
    sort(starting);
    suspect_overlapping(starting, passing);
    sweep_.leave(passing, [&](auto visit) {
      for (const SegmentId s : starting) visit(s, high_end(s));
    });
  }
  /// Sorts segments that start at one point counter-clockwise.
  void sort(std::span<SegmentId> starting) {
    if (starting.size() < 2) return;
    std::sort(starting.begin(), starting.end(),
              cancellation_.counting([&](SegmentId s, SegmentId t) {
                const Sign sign = s == t ? kZero : direction(s, t);
                return sign != kZero ? sign == kPositive : s < t;
              }));
  }
  [[nodiscard]] Sign direction(SegmentId s, SegmentId t) const {
    return segments_.predicates.cross(segments_.list[s].ends, segments_.list[t].ends);
  }
  /// Suspects all but one of the segments that start in one direction, or in that of `passing`.
  void suspect_overlapping(std::span<const SegmentId> starting, SegmentId passing) {
    for (std::size_t i = 0; i < starting.size(); ++i) {
      const bool repeated = i > 0 && direction(starting[i - 1], starting[i]) == kZero;
      if (repeated || (passing != kNone && side(passing, high_end(starting[i])) == kZero)) {
        suspect(starting[i]);
      }
    }
  }

  const Segments& segments_;
  Cancellation& cancellation_;
  std::vector<Touch>& touches_;
  std::vector<std::uint8_t> suspect_;          // by segment
  std::vector<std::uint32_t> first_starting_;  // by point: its segments in `starting_`
  std::vector<SegmentId> starting_;
  std::vector<std::uint32_t> first_ending_;
  std::vector<SegmentId> ending_;
  SegmentSweepScratch scratch_;
  SegmentSweep<ContactSweeper> sweep_;
};

}  // namespace

std::vector<std::uint8_t> sweep_contacts(const Segments& segments, std::vector<Touch>& touches) {
  return ContactSweeper(segments, touches).run();
}

}  // namespace minksum::overlay
