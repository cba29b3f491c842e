// Divides crowds of segments at medians.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "exact/formulas.hpp"
#include "machine/make_room.hpp"
#include "spatial/box.hpp"

namespace minksum {

/// A segment, with a box that holds all of its points in a part of the plane.
struct BoxedSegment : BoxOf<double> {
  std::uint32_t segment;
};

/// Where the line of a segment meets a line along the other axis.
struct LineCut {
  double place;
  double error;  ///< bound on the error of `place`
  double slope;  ///< its sign tells which end of the segment is on which side
};

/// Tells where the segment from a to b meets the line axis = at. Its ends are off by less than
/// `error`, which is also far above the roundings here. An end that is off by e moves the line by
/// e · (1 + |slope|) between the ends. Returns false if the segment's extent along the axis is at
/// most `shortest`.
template <Axis axis>
bool cut_segment(const Vec<double>& a, const Vec<double>& b, double at, double shortest,
                 double error, LineCut& result) {
  constexpr auto kAlong = axis == Axis::kX ? &Vec<double>::x : &Vec<double>::y;
  constexpr auto kAcross = axis == Axis::kX ? &Vec<double>::y : &Vec<double>::x;
  const double run = b.*kAlong - a.*kAlong;
  if (!(std::abs(run) > shortest)) return false;
  const double slope = (b.*kAcross - a.*kAcross) / run;
  result = {a.*kAcross + (at - a.*kAlong) * slope, error * (2 + std::abs(slope)), slope};
  return true;
}

/// The line axis = at, which divides a part of the plane.
struct DividingLine {
  Axis axis = Axis::kX;
  double at = 0;
};

/// A part of the plane that is still to be divided, with its items.
struct UndividedPart {
  BoxOf<double> part;
  int poor;  ///< how many poor divisions are still allowed
  std::vector<BoxedSegment> items;
};

/// Divides a crowd of segments at medians, along x or y, until few are left in each part, or
/// dividing does not pay. Boxes are cut to each part.
///
/// A User has these functions. [begin, end) are indices of items.
/// - `bool enter(above, begin, end, box, const BoxOf<double>& part)` is told of each part, and of
///   the box of its items. If it returns false, the part is left out. The items [above, begin) are
///   those of the part that was divided.
/// - `bool cut<axis>(segment, at, LineCut&)` tells where a segment meets the line axis = at.
///   Returns false if the segment runs so nearly along that line that the place is not known.
/// - `void meet_few(begin, end)` handles the items of a part that are few.
/// - `void meet_crowd(begin, end, box)` handles items that lie in the box and are not to be
/// divided.
/// - `std::optional<DividingLine> line_among_crossings(begin, end, part)` tells where to divide
///   items that medians do not part, or nothing if they are to be left as they are.
/// - `bool is_sorted_soon(begin, end, box)` tells whether to handle a crowd that way rather than to
///   divide it poorly.
template <class User>
class MedianDivision {
 public:
  static constexpr std::size_t kFew = 16;  ///< comparing all pairs costs less than dividing
  /// In a box of fewer slacks, both halves would hold nearly all.
  static constexpr double kLeastSlacks = 64;

  /// `items` is a stack: the items of a part lie below those of its halves. An item belongs to a
  /// part if it is within `slack` of it.
  MedianDivision(User& user, std::vector<BoxedSegment>& items, double slack,
                 Cancellation& cancellation)
      : user_(user), items_(items), slack_(slack), cancellation_(cancellation) {}

  /// Divides all items. Afterwards, only their order has changed.
  void divide(const BoxOf<double>& part) { divide(0, 0, items_.size(), part, kMaxPoor); }
  /// Does the same, but lists crowds, and parts with at most so many items, in the order in which
  /// they would be handled. Nothing is handled.
  void split(const BoxOf<double>& part, std::size_t most, std::vector<UndividedPart>& undivided) {
    split(part, kMaxPoor, most, undivided);
  }
  /// Does the same with what another `split` has left.
  void split(UndividedPart& given, std::size_t most, std::vector<UndividedPart>& undivided) {
    items_.swap(given.items);
    split(given.part, given.poor, most, undivided);
    items_.clear();
  }
  /// Divides what `split` has left.
  void divide(UndividedPart& undivided) {
    items_.swap(undivided.items);
    divide(0, 0, items_.size(), undivided.part, undivided.poor);
    items_.clear();
  }

  /// Cuts an item's box to a part. Returns false if nothing of the segment is within the slack.
  [[nodiscard]] bool cut_to(const BoxOf<double>& part, BoxedSegment& item) const {
    return keep<Axis::kX>(item, part.x0 - slack_, false) &&
           keep<Axis::kX>(item, part.x1 + slack_, true) &&
           keep<Axis::kY>(item, part.y0 - slack_, false) &&
           keep<Axis::kY>(item, part.y1 + slack_, true);
  }

  /// Calls work(item) for the items [begin, end), and looks at the token in between.
  template <class Work>
  void visit(std::size_t begin, std::size_t end, Work work) const {
    in_pieces(end - begin, cancellation_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = begin + first; i < begin + last; ++i) work(items_[i]);
    });
  }

 private:
  /// A division is poor if it leaves many segments in both halves, but it may make way for good
  /// ones. On the way to a part, at most so many more poor divisions than good ones are made.
  /// Together, the poor divisions multiply the work by less than two.
  static constexpr int kMaxPoor = 4;

  /// Where to divide some items.
  struct Division : DividingLine {
    std::size_t in_both = 0;  ///< items that are in both halves
    std::size_t in_less = 0;  ///< items that are in the lesser half alone
  };

  /// Cuts an item's box to one side of axis = at. Returns false if nothing is left.
  template <Axis axis>
  [[nodiscard]] bool keep(BoxedSegment& item, double at, bool low) const {
    constexpr Axis kAcross = other(axis);
    if (low ? item.low(axis) > at : item.high(axis) < at) return false;
    if (low ? item.high(axis) <= at : item.low(axis) >= at) return true;
    (low ? item.high(axis) : item.low(axis)) = at;
    LineCut cut;
    if (!user_.template cut<axis>(item.segment, at, cut)) return true;
    // The left part of a rising segment is the lower one.
    if ((cut.slope > 0) == low) {
      item.high(kAcross) = std::min(item.high(kAcross), cut.place + cut.error);
    } else {
      item.low(kAcross) = std::max(item.low(kAcross), cut.place - cut.error);
    }
    return item.low(kAcross) <= item.high(kAcross);
  }

  [[nodiscard]] BoxOf<double> bounds_of(std::size_t begin, std::size_t end) const {
    BoxOf<double> box = items_[begin];
    visit(begin + 1, end, [&](const BoxedSegment& item) { box.add(item); });
    return box;
  }

  /// Returns the division at the median of a sample's centres.
  template <Axis axis>
  [[nodiscard]] Division division(std::size_t begin, std::size_t end) const {
    constexpr std::size_t kSampled = 31;
    std::array<double, kSampled> sample;
    const std::size_t count = end - begin;
    for (std::size_t i = 0; i < kSampled; ++i) {
      const BoxedSegment& item = items_[begin + i * count / kSampled];
      sample[i] = item.low(axis) / 2 + item.high(axis) / 2;
    }
    std::nth_element(sample.begin(), sample.begin() + kSampled / 2, sample.end());
    const double at = sample[kSampled / 2];
    std::size_t low = 0;
    std::size_t high = 0;
    visit(begin, end, [&](const BoxedSegment& item) {
      low += item.high(axis) < at - slack_ ? 1U : 0U;
      high += item.low(axis) > at + slack_ ? 1U : 0U;
    });
    return {{axis, at}, count - low - high, std::min(low, high)};
  }
  [[nodiscard]] Division division(std::size_t begin, std::size_t end, Axis axis) const {
    return axis == Axis::kX ? division<Axis::kX>(begin, end) : division<Axis::kY>(begin, end);
  }

  void split(const BoxOf<double>& part, int poor, std::size_t most,
             std::vector<UndividedPart>& undivided) {
    most_undivided_ = std::max(most, kFew);
    undivided_ = &undivided;
    divide(0, 0, items_.size(), part, poor);
    undivided_ = nullptr;
    most_undivided_ = 0;
  }
  void divide(std::size_t above, std::size_t begin, std::size_t end, const BoxOf<double>& part,
              int poor) {
    const std::size_t count = end - begin;
    if (count < 2) return;
    const BoxOf<double> box = bounds_of(begin, end);
    if (!user_.enter(above, begin, end, box, part)) return;
    if (count <= most_undivided_) return put_off(begin, end, part, poor);
    if (count <= kFew) return user_.meet_few(begin, end);
    std::optional<DividingLine> line = line_at_median(begin, end, box, poor);
    if (!line) line = user_.line_among_crossings(begin, end, part);
    if (!line) {
      if (undivided_ != nullptr) return put_off(begin, end, part, poor);
      return user_.meet_crowd(begin, end, box);
    }
    for (const bool low : {true, false}) {
      if (line->axis == Axis::kX) {
        put_half<Axis::kX>(begin, end, line->at, low);
      } else {
        put_half<Axis::kY>(begin, end, line->at, low);
      }
      BoxOf<double> half = part;
      (low ? half.high(line->axis) : half.low(line->axis)) = line->at;
      divide(begin, end, items_.size(), half, poor);
      items_.resize(end);
    }
  }
  /// Returns where to divide, if that pays, and counts how many poor divisions are allowed then.
  std::optional<DividingLine> line_at_median(std::size_t begin, std::size_t end,
                                             const BoxOf<double>& box, int& poor) {
    const std::size_t count = end - begin;
    const Axis longer = box.longer();
    if (box.high(longer) - box.low(longer) < kLeastSlacks * slack_) return std::nullopt;
    Division best = division(begin, end, longer);
    const bool is_good = best.in_both < count / 6;
    if (!is_good) {
      const Division second = division(begin, end, other(longer));
      if (second.in_both < best.in_both) best = second;
    }
    // Each half lacks a sixteenth of the items at least, so dividing ends.
    const bool is_useless = best.in_less < count / 16 || best.in_both > count * 3 / 4;
    const bool is_poor = best.in_both > count * 2 / 5;
    if (is_useless || (is_poor && (poor == 0 || user_.is_sorted_soon(begin, end, box)))) {
      return std::nullopt;
    }
    poor = std::min(kMaxPoor, poor - (is_poor ? 1 : 0) + (is_good ? 1 : 0));
    return best;
  }
  /// Lists a part, to be divided later from its start.
  void put_off(std::size_t begin, std::size_t end, const BoxOf<double>& part, int poor) {
    undivided_->push_back({part, poor, {}});
    auto& items = undivided_->back().items;
    items.reserve(end - begin);
    visit(begin, end, [&](const BoxedSegment& item) { items.push_back(item); });
  }
  /// Puts what is on one side of axis = at on top of the stack.
  template <Axis axis>
  void put_half(std::size_t begin, std::size_t end, double at, bool low) {
    const double bound = low ? at + slack_ : at - slack_;
    // Each item is copied, because the list grows.
    visit(begin, end, [&](BoxedSegment item) {
      if (keep<axis>(item, bound, low)) append(items_, item, cancellation_);
    });
  }

  User& user_;
  std::vector<BoxedSegment>& items_;
  double slack_;
  Cancellation& cancellation_;
  std::vector<UndividedPart>* undivided_ = nullptr;  ///< where parts are listed, if they are
  std::size_t most_undivided_ = 0;
};

}  // namespace minksum
