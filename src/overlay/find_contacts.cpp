// Finds where segments meet: cells are divided until few segments are left in each.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "overlay/subdivision.hpp"

namespace minksum::overlay {
namespace {

/// A segment in a cell, with a box that holds all of its points there.
struct Item {
  double min_x, max_x, min_y, max_y;
  SegmentId segment;
};

/// A segment in doubles, used to cut boxes by its line and to find pairs that are far apart.
struct Slant {
  double x, y;    ///< its lower end
  double x2, y2;  ///< its upper end
  double dx, dy;
  double slope;       ///< dy / dx
  double inverse;     ///< dx / dy
  double cut_error;   ///< error of a y by `slope`, over 1 + |slope|; same for x
  double side_error;  ///< error of `side`
  bool by_x;          ///< wide enough for a good `slope`
  bool by_y;

  /// Returns the cross product of the segment and the vector from its lower end to a point.
  [[nodiscard]] double side(double px, double py) const { return dx * (py - y) - dy * (px - x); }
};

class ContactFinder {
 public:
  ContactFinder(const Segments& segments, std::size_t max_touches, Contacts& contacts)
      : segments_(segments),
        predicates_(segments.predicates),
        max_touches_(max_touches),
        cancellation_(segments.cancellation()),
        contacts_(contacts) {}

  bool run() {
    measure();
    slants_.reserve(segments_.list.size());
    items_.reserve(2 * segments_.list.size());
    for (SegmentId s = 0; s < segments_.list.size(); ++s) add(s);
    add_lone_points();
    divide(0, items_.size(), kMaxPoor);
    if (too_many()) return false;
    const auto touch_order = [](const Touch& a, const Touch& b) {
      return a.segment != b.segment ? a.segment < b.segment : a.point < b.point;
    };
    const auto same_touch = [](const Touch& a, const Touch& b) {
      return a.segment == b.segment && a.point == b.point;
    };
    auto& [touches, crossings] = contacts_;
    std::sort(touches.begin(), touches.end(), cancellation_.counting(touch_order));
    touches.erase(std::unique(touches.begin(), touches.end(), same_touch), touches.end());
    sort_crossings();
    return true;
  }

 private:
  static constexpr std::size_t kFew = 16;
  static constexpr int kMaxPoor = 4;
  static constexpr std::size_t kMaxCrossings = std::size_t{1} << 28U;

  [[nodiscard]] bool too_many() const { return contacts_.touches.size() > max_touches_; }
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
    items_.push_back({low(a.x, b.x), high(a.x, b.x), low(a.y, b.y), high(a.y, b.y), s});
    Slant slant{};
    slant.x = a.x.value;
    slant.y = a.y.value;
    slant.x2 = b.x.value;
    slant.y2 = b.y.value;
    slant.dx = slant.x2 - slant.x;
    slant.dy = slant.y2 - slant.y;
    slant.slope = slant.dy / slant.dx;
    slant.inverse = slant.dx / slant.dy;
    const double largest = std::max(
        {std::fabs(slant.x), std::fabs(slant.x2), std::fabs(slant.y), std::fabs(slant.y2)});
    // Coordinates are off by 2^-52 of the largest. Over such a width, a slope is off by at most
    // 2^-21 of itself, and a cut by some such errors, times the slope.
    const double enough = largest * 0x1p-30 + 0x1p-900;
    slant.by_x = std::fabs(slant.dx) > enough;
    slant.by_y = std::fabs(slant.dy) > enough;
    slant.cut_error = largest * 0x1p-46 + 0x1p-900;
    // Any point is at most 2·extent away along each axis. The point and both ends are off by
    // `position_error` each, and each of the six roundings by 2^-53.
    const double length = std::fabs(slant.dx) + std::fabs(slant.dy);
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

  /// Divides the items [begin, end) of the stack. Afterwards, only their order has changed.
  ///
  /// A division is poor if many segments are in both halves. Crowds of segments that run side by
  /// side, or through one point, are not worth dividing. But a poor division may make way for good
  /// ones. So on the way to a cell, only some more poor divisions than good ones are made; `poor`
  /// is how many are left. Together, the poor divisions multiply the work by less than two.
  void divide(std::size_t begin, std::size_t end, int poor) {
    if (too_many()) return;
    if (end - begin <= kFew) return test_all(begin, end);
    cancellation_.check(2 * (end - begin));
    Item box = items_[begin];
    for (std::size_t i = begin + 1; i < end; ++i) {
      const Item& item = items_[i];
      box.min_x = std::min(box.min_x, item.min_x);
      box.max_x = std::max(box.max_x, item.max_x);
      box.min_y = std::min(box.min_y, item.min_y);
      box.max_y = std::max(box.max_y, item.max_y);
    }
    const bool wide = box.max_x - box.min_x >= box.max_y - box.min_y;
    const Division first = division(begin, end, wide);
    const Division second = division(begin, end, !wide);
    const bool use_first = first.in_both <= second.in_both;
    const Division& best = use_first ? first : second;
    const std::size_t count = end - begin;
    const bool is_poor = best.in_both > count * 2 / 5;
    const bool is_good = best.in_both < count / 6;
    if (best.in_one == 0 || best.in_both > count * 3 / 4 || (is_poor && poor == 0)) {
      return test_all(begin, end);
    }
    split(begin, end, use_first ? wide : !wide, best.at,
          std::min(kMaxPoor, poor - (is_poor ? 1 : 0) + (is_good ? 1 : 0)));
  }

  struct Division {
    double at = 0;
    std::size_t in_both = 0;
    std::size_t in_one = 0;  ///< only in the half that has fewer
  };
  [[nodiscard]] Division division(std::size_t begin, std::size_t end, bool by_x) const {
    Division result;
    result.at = middle(begin, end, by_x);
    std::size_t low = 0;
    std::size_t high = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const Item& item = items_[i];
      low += (by_x ? item.max_x : item.max_y) < result.at ? 1U : 0U;
      high += (by_x ? item.min_x : item.min_y) > result.at ? 1U : 0U;
    }
    result.in_both = end - begin - low - high;
    result.in_one = std::min(low, high);
    return result;
  }

  /// Returns the median of the middles of a sample of boxes.
  [[nodiscard]] double middle(std::size_t begin, std::size_t end, bool by_x) const {
    constexpr std::size_t kSample = 31;
    std::array<double, kSample> sample;
    const std::size_t count = end - begin;
    for (std::size_t i = 0; i < kSample; ++i) {
      const Item& item = items_[begin + i * count / kSample];
      sample[i] = by_x ? item.min_x / 2 + item.max_x / 2 : item.min_y / 2 + item.max_y / 2;
    }
    std::nth_element(sample.begin(), sample.begin() + kSample / 2, sample.end());
    return sample[kSample / 2];
  }

  void split(std::size_t begin, std::size_t end, bool by_x, double at, int poor) {
    for (const bool low : {true, false}) {
      const std::size_t first = items_.size();
      for (std::size_t i = begin; i < end; ++i) {
        Item item = items_[i];
        if (by_x ? cut_x(item, at, low) : cut_y(item, at, low)) items_.push_back(item);
      }
      divide(first, items_.size(), poor);
      items_.resize(first);
    }
  }

  /// Keeps the part on one side of x = at. Returns false if there is none.
  [[nodiscard]] bool cut_x(Item& item, double at, bool low) const {
    if (low ? item.min_x > at : item.max_x < at) return false;
    if (low ? item.max_x <= at : item.min_x >= at) return true;
    (low ? item.max_x : item.min_x) = at;
    const Slant& slant = slants_[item.segment];
    if (!slant.by_x) return true;
    const double y = slant.y + (at - slant.x) * slant.slope;
    const double error = slant.cut_error * (1 + std::fabs(slant.slope));
    // The left part of a rising segment is the lower one.
    if ((slant.slope > 0) == low) {
      item.max_y = std::min(item.max_y, y + error);
    } else {
      item.min_y = std::max(item.min_y, y - error);
    }
    return true;
  }
  [[nodiscard]] bool cut_y(Item& item, double at, bool low) const {
    if (low ? item.min_y > at : item.max_y < at) return false;
    if (low ? item.max_y <= at : item.min_y >= at) return true;
    (low ? item.max_y : item.min_y) = at;
    const Slant& slant = slants_[item.segment];
    if (!slant.by_y) return true;
    const double x = slant.x + (at - slant.y) * slant.inverse;
    const double error = slant.cut_error * (1 + std::fabs(slant.inverse));
    if ((slant.inverse > 0) == low) {
      item.max_x = std::min(item.max_x, x + error);
    } else {
      item.min_x = std::max(item.min_x, x - error);
    }
    return true;
  }

  /// Tests pairs whose boxes overlap, from left to right.
  void test_all(std::size_t begin, std::size_t end) {
    const auto first = items_.begin() + static_cast<std::ptrdiff_t>(begin);
    std::sort(
        first, items_.begin() + static_cast<std::ptrdiff_t>(end),
        cancellation_.counting([](const Item& a, const Item& b) { return a.min_x < b.min_x; }));
    for (std::size_t i = begin; i < end; ++i) {
      const Item a = items_[i];
      std::size_t j = i + 1;
      for (; j < end && items_[j].min_x <= a.max_x; ++j) {
        const Item& b = items_[j];
        if (b.min_y > a.max_y || a.min_y > b.max_y) continue;
        if (beside(a.segment, b.segment)) continue;
        if (beside(b.segment, a.segment)) continue;
        test(a.segment, b.segment);
      }
      if (too_many()) return;
      cancellation_.check(1 + 2 * (j - i));
    }
  }

  /// Tells whether t certainly lies on one side of the line of s. One end of t may be shared with
  /// s; then the other end decides.
  [[nodiscard]] bool beside(SegmentId s, SegmentId t) const {
    const Slant& line = slants_[s];
    const Slant& other = slants_[t];
    const double low = line.side(other.x, other.y);
    const double high = line.side(other.x2, other.y2);
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
      contacts_.crossings.push_back({std::min(s, t), std::max(s, t)});
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
    if (ends(s).low < p && p < ends(s).high) contacts_.touches.push_back({s, p});
  }

  void limit_crossings() {
    if (contacts_.crossings.size() <= look_again_at_) return;
    sort_crossings();  // those found in several cells count once
    if (contacts_.crossings.size() > kMaxCrossings) {
      throw Error(ErrorCode::kLimitExceeded, "more than 2^28 crossings in one overlay");
    }
    look_again_at_ = std::max(kMaxCrossings, 2 * contacts_.crossings.size());
  }
  void sort_crossings() {
    auto& crossings = contacts_.crossings;
    std::sort(crossings.begin(), crossings.end(), cancellation_.counting(std::less<>()));
    crossings.erase(std::unique(crossings.begin(), crossings.end()), crossings.end());
  }

  const Segments& segments_;
  const Predicates& predicates_;
  std::size_t max_touches_;
  Cancellation& cancellation_;
  Contacts& contacts_;
  double extent_ = 0;          // the largest magnitude of a coordinate
  double position_error_ = 0;  // the largest error of a coordinate
  std::vector<Ends> lone_points_;
  std::vector<Slant> slants_;  // by segment, lone points included
  std::size_t look_again_at_ = kMaxCrossings;
  std::vector<Item> items_;  // a stack: a cell's items lie below those of its halves
};

}  // namespace

bool find_contacts(const Segments& segments, std::size_t max_touches, Contacts& contacts) {
  return ContactFinder(segments, max_touches, contacts).run();
}

}  // namespace minksum::overlay
