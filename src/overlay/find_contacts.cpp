// Finds where segments meet: cells are divided until few segments are left in each.
#include <algorithm>
#include <cmath>

#include "machine/exceeded.hpp"
#include "machine/make_room.hpp"
#include "overlay/subdivision.hpp"
#include "spatial/median_division.hpp"

namespace minksum::overlay {
namespace {

/// A segment in doubles, used to cut boxes by its line and to find pairs that are far apart.
struct Slant {
  Vec<double> low;
  Vec<double> high;
  Vec<double> d;
  double side_error;  ///< error of `side`

  /// Returns the cross product of the segment and the vector from its lower end to a point.
  [[nodiscard]] double side(const Vec<double>& p) const {
    return cross(d, {p.x - low.x, p.y - low.y});
  }
};

class ContactFinder {
 public:
  ContactFinder(const Segments& segments, const MostContacts& most, Contacts& contacts)
      : segments_(segments),
        predicates_(segments.predicates),
        most_(most),
        cancellation_(segments.cancellation()),
        contacts_(contacts),
        max_crossings_(std::min(cancellation_.options().limits.max_crossings, kMaxCrossings)),
        look_again_at_(max_crossings_) {}

  bool run() {
    measure();
    slants_.reserve(segments_.list.size());
    items_.reserve(2 * segments_.list.size());
    for (SegmentId s = 0; s < segments_.list.size(); ++s) add(s);
    add_lone_points();
    MedianDivision(*this, items_, 0, cancellation_)
        .divide({-HUGE_VAL, -HUGE_VAL, HUGE_VAL, HUGE_VAL});
    if (too_many()) return false;
    sort_unique(contacts_.touches, cancellation_);
    sort_crossings();
    return true;
  }

 private:
  friend MedianDivision<ContactFinder>;
  static constexpr std::size_t kPairsOfASweep = 128;  ///< take as long as sweeping one segment
  static constexpr std::uint64_t kMaxCrossings = std::uint64_t{1} << 30U;  // fit in 32-bit numbers

  [[nodiscard]] bool too_many() const {
    return contacts_.touches.size() > most_.touches || contacts_.crossings.size() > most_.crossings;
  }
  [[nodiscard]] const Ends& ends(SegmentId s) const {
    return s < segments_.list.size() ? segments_.list[s].ends
                                     : lone_points_[s - segments_.list.size()];
  }

  /// Adds points that belong to the result and are no segment's end, as segments without length.
  void add_lone_points() {
    std::vector<std::uint8_t> is_end(segments_.sources.size(), 0);
    for (const Segment& segment : segments_.list) {
      is_end[segment.ends.low] = is_end[segment.ends.high] = 1;
    }
    for (PointId p = 0; p < is_end.size(); ++p) {
      if (segments_.belongs[p] == 0 || is_end[p] != 0) continue;
      lone_points_.push_back({p, p});
      add(static_cast<SegmentId>(segments_.list.size() + lone_points_.size() - 1));
    }
  }

  void add(SegmentId s) {
    cancellation_.check(4);
    const ApproximateLocation& a = predicates_.point(ends(s).low);
    const ApproximateLocation& b = predicates_.point(ends(s).high);
    const auto low = [](const Bounded& u, const Bounded& v) {
      return std::min(u.value - 2 * u.error, v.value - 2 * v.error);
    };
    const auto high = [](const Bounded& u, const Bounded& v) {
      return std::max(u.value + 2 * u.error, v.value + 2 * v.error);
    };
    items_.push_back({{low(a.x, b.x), low(a.y, b.y), high(a.x, b.x), high(a.y, b.y)}, s});
    Slant slant{{a.x.value, a.y.value}, {b.x.value, b.y.value}, {}, 0};
    slant.d = {slant.high.x - slant.low.x, slant.high.y - slant.low.y};
    // Any point is at most 2·extent away along each axis. The point and both ends are off by
    // `position_error` each, and each of the six roundings by 2^-53.
    const double length = std::fabs(slant.d.x) + std::fabs(slant.d.y);
    slant.side_error = 16 * position_error_ * extent_ +
                       length * (4 * position_error_ + 0x1p-49 * extent_) + 0x1p-900;
    slants_.push_back(slant);
  }

  /// Finds the bounds of all points.
  void measure() {
    cancellation_.check(segments_.sources.size());
    for (PointId p = 0; p < segments_.sources.size(); ++p) {
      for (const Bounded& c : {predicates_.point(p).x, predicates_.point(p).y}) {
        extent_ = std::max(extent_, std::fabs(c.value));
        position_error_ = std::max(position_error_, c.error);
      }
    }
  }

  // What the division asks for.
  [[nodiscard]] bool enter(std::size_t /*above*/, std::size_t begin, std::size_t end,
                           const BoxOf<double>& /*box*/, const BoxOf<double>& /*part*/) const {
    return !too_many() && has_suspects(begin, end);
  }
  template <Axis axis>
  [[nodiscard]] bool cut(SegmentId segment, double at, LineCut& result) const {
    // Coordinates are off by 2^-52 of the extent. Over the shortest width, a slope is off by at
    // most 2^-21 of itself, and a cut by some such errors, times the slope.
    const Slant& slant = slants_[segment];
    return cut_segment<axis>(slant.low, slant.high, at, extent_ * 0x1p-30 + 0x1p-900,
                             extent_ * 0x1p-46 + 0x1p-900, result);
  }
  void meet_few(std::size_t begin, std::size_t end) { test_all(begin, end); }
  void meet_crowd(std::size_t begin, std::size_t end, const BoxOf<double>& /*box*/) {
    test_all(begin, end);
  }
  [[nodiscard]] static std::optional<DividingLine> line_among_crossings(
      std::size_t /*begin*/, std::size_t /*end*/, const BoxOf<double>& /*part*/) {
    return std::nullopt;
  }
  [[nodiscard]] static bool is_sorted_soon(std::size_t /*begin*/, std::size_t /*end*/,
                                           const BoxOf<double>& /*box*/) {
    return false;
  }

  /// Tests pairs whose boxes overlap, from left to right.
  void test_all(std::size_t begin, std::size_t end) {
    if (!has_suspects(begin, end)) return;
    const auto first = items_.begin() + static_cast<std::ptrdiff_t>(begin);
    std::sort(first, items_.begin() + static_cast<std::ptrdiff_t>(end),
              cancellation_.counting(
                  [](const BoxedSegment& a, const BoxedSegment& b) { return a.x0 < b.x0; }));
    if (swept_) list_suspects(begin, end);
    for (std::size_t i = begin; i < end; ++i) {
      const BoxedSegment a = items_[i];
      const bool with_all = is_suspect(a.segment);
      const auto from = [&](std::size_t k) { return with_all ? k : next_suspect_[k - begin]; };
      std::size_t tested = 1;
      for (std::size_t j = from(i + 1); j < end && items_[j].x0 <= a.x1; j = from(j + 1)) {
        ++tested;
        const BoxedSegment& b = items_[j];
        if (b.y0 > a.y1 || a.y0 > b.y1) continue;
        if (beside(a.segment, b.segment)) continue;
        if (beside(b.segment, a.segment)) continue;
        test(a.segment, b.segment);
      }
      if (too_many()) return;
      cancellation_.check(2 * tested);
      if (is_sweep_due(tested)) {
        sweep();
        list_suspects(begin, end);
      }
    }
  }

  /// Tells whether a segment may meet others in a way that is not listed yet.
  [[nodiscard]] bool is_suspect(SegmentId s) const { return !swept_ || suspect_[s] != 0; }
  [[nodiscard]] bool has_suspects(std::size_t begin, std::size_t end) const {
    const auto first = items_.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto last = items_.begin() + static_cast<std::ptrdiff_t>(end);
    return std::any_of(first, last,
                       [&](const BoxedSegment& item) { return is_suspect(item.segment); });
  }
  /// Lists, for each item and for the end, the next suspect from there on.
  void list_suspects(std::size_t begin, std::size_t end) {
    next_suspect_.resize(end - begin + 1);
    next_suspect_.back() = end;
    for (std::size_t i = end; i-- > begin;) {
      const bool suspect = is_suspect(items_[i].segment);
      next_suspect_[i - begin] = suspect ? i : next_suspect_[i - begin + 1];
    }
  }
  /// Counts pairs, and tells whether more have been tested in vain than a sweep costs.
  [[nodiscard]] bool is_sweep_due(std::size_t pairs) {
    tested_ += pairs;
    const auto& [touches, crossings] = contacts_;
    const std::size_t paid = segments_.list.size() + touches.size() + crossings.size();
    return !swept_ && tested_ > kPairsOfASweep * paid;
  }
  /// Sweeps over all segments. From here on, only pairs with a suspect are left to test.
  void sweep() {
    suspect_ = sweep_contacts(segments_, contacts_.touches);
    suspect_.resize(slants_.size(), 0);
    swept_ = true;
  }

  /// Tells whether t certainly lies on one side of the line of s. One end of t may be shared with
  /// s; then the other end decides.
  [[nodiscard]] bool beside(SegmentId s, SegmentId t) const {
    const Slant& line = slants_[s];
    const Slant& other = slants_[t];
    const double low = line.side(other.low);
    const double high = line.side(other.high);
    if ((low > line.side_error && high > line.side_error) ||
        (low < -line.side_error && high < -line.side_error)) {
      return true;
    }
    const Ends& a = ends(s);
    const Ends& b = ends(t);
    if (a.low == b.low || a.high == b.low) return std::fabs(high) > line.side_error;
    return (a.low == b.high || a.high == b.high) && std::fabs(low) > line.side_error;
  }

  void test(SegmentId s, SegmentId t) {
    const Ends a = ends(s);
    const Ends b = ends(t);
    if (a.low == a.high || b.low == b.high) return test_point(s, t);
    if (a.low == b.low) return test_ends(s, a.high, t, b.high, a.low);
    if (a.high == b.high) return test_ends(s, a.low, t, b.low, a.high);
    if (a.low == b.high || a.high == b.low) return;  // one goes on from the other
    const Sign b_low = predicates_.orientation(a, b.low);
    const Sign b_high = predicates_.orientation(a, b.high);
    if (b_low == b_high && b_low != kZero) return;
    const Sign a_low = predicates_.orientation(b, a.low);
    const Sign a_high = predicates_.orientation(b, a.high);
    if (a_low == a_high && a_low != kZero) return;
    if (b_low * b_high == kNegative && a_low * a_high == kNegative) {
      append(contacts_.crossings, {std::min(s, t), std::max(s, t)}, cancellation_);
      return limit_crossings();
    }
    if (b_low == kZero) touch_inside(s, b.low);
    if (b_high == kZero) touch_inside(s, b.high);
    if (a_low == kZero) touch_inside(t, a.low);
    if (a_high == kZero) touch_inside(t, a.high);
  }
  /// Tests two segments of which at least one is a lone point. Two lone points are different.
  void test_point(SegmentId s, SegmentId t) {
    const bool first_is_point = ends(s).low == ends(s).high;
    const SegmentId line = first_is_point ? t : s;
    const PointId p = ends(first_is_point ? s : t).low;
    if (ends(line).low == ends(line).high) return;
    if (predicates_.orientation(ends(line), p) == kZero) touch_inside(line, p);
  }
  /// Tests segments that share the end `common`. On one line, one segment contains the other.
  void test_ends(SegmentId s, PointId a, SegmentId t, PointId b, PointId common) {
    const Ends line{std::min(common, a), std::max(common, a)};
    if (predicates_.orientation(line, b) != kZero) return;
    touch_inside(s, b);
    touch_inside(t, a);
  }
  /// Adds a touch if a point of the segment's line lies inside the segment. Numbers of points tell,
  /// because they are in lexicographic order.
  void touch_inside(SegmentId s, PointId p) {
    if (ends(s).low < p && p < ends(s).high) append(contacts_.touches, {s, p}, cancellation_);
  }

  void limit_crossings() {
    if (contacts_.crossings.size() <= look_again_at_) return;
    sort_crossings();
    look_again_at_ = std::max<std::uint64_t>(max_crossings_, 2 * contacts_.crossings.size());
  }
  /// Sorts crossings, so that those found in several cells count once. Throws if they are too many.
  void sort_crossings() {
    auto& crossings = contacts_.crossings;
    sort_unique(crossings, cancellation_);
    if (crossings.size() <= max_crossings_) return;
    throw exceeded("Limits::max_crossings", max_crossings_, "an overlay has", "crossings");
  }

  const Segments& segments_;
  const Predicates& predicates_;
  MostContacts most_;
  Cancellation& cancellation_;
  Contacts& contacts_;
  std::uint64_t max_crossings_;
  std::uint64_t look_again_at_;  // so many crossings
  double extent_ = 0;            // the largest magnitude of a coordinate
  double position_error_ = 0;    // the largest error of a coordinate
  std::vector<Ends> lone_points_;
  std::vector<Slant> slants_;          // by segment, lone points included
  std::size_t tested_ = 0;             // pairs
  bool swept_ = false;                 // whether `suspect_` is known
  std::vector<std::uint8_t> suspect_;  // by segment, lone points included
  std::vector<std::size_t> next_suspect_;
  std::vector<BoxedSegment> items_;
};

}  // namespace

bool find_contacts(const Segments& segments, const MostContacts& most, Contacts& contacts) {
  return ContactFinder(segments, most, contacts).run();
}

}  // namespace minksum::overlay
