// Divides crowds of segments, and sorts those that cannot be divided.
#include "sum/arrangement/crowds.hpp"

#include <algorithm>
#include <array>

namespace minksum {

void CrowdFinder::add(KeptId segment, const PlanePart& part) {
  cancellation_.check(2);
  const KeptSegment& s = kept_[segment];
  CrowdItem item{std::min(s.a.x, s.b.x) - cut_error_, std::min(s.a.y, s.b.y) - cut_error_,
                 std::max(s.a.x, s.b.x) + cut_error_, std::max(s.a.y, s.b.y) + cut_error_, segment};
  const bool near = cut_x(item, part.x0 - slack_, false) && cut_x(item, part.x1 + slack_, true) &&
                    cut_y(item, part.y0 - slack_, false) && cut_y(item, part.y1 + slack_, true);
  if (near) append(items_, item, cancellation_);
}

/// Keeps what is on one side of x = at. Returns false if nothing is.
///
/// A cut is off by at most cut_error_ · (2 + |slope|): an end that is off by e moves the line by
/// e · (1 + |slope|) between the ends, and each of the roundings, by 2^-53 of the extent, does
/// less.
bool CrowdFinder::cut_x(CrowdItem& item, double at, bool low) const {
  if (low ? item.x0 > at : item.x1 < at) return false;
  if (low ? item.x1 <= at : item.x0 >= at) return true;
  (low ? item.x1 : item.x0) = at;
  const KeptSegment& s = kept_[item.segment];
  const Vec<double> d{s.b.x - s.a.x, s.b.y - s.a.y};
  if (std::abs(d.x) <= shortest_) return true;
  const double slope = d.y / d.x;
  const double y = s.a.y + (at - s.a.x) * slope;
  const double error = cut_error_ * (2 + std::abs(slope));
  // The left part of a rising segment is the lower one.
  if ((slope > 0) == low) {
    item.y1 = std::min(item.y1, y + error);
  } else {
    item.y0 = std::max(item.y0, y - error);
  }
  return item.y0 <= item.y1;
}
/// Does the same for y = at.
bool CrowdFinder::cut_y(CrowdItem& item, double at, bool low) const {
  if (low ? item.y0 > at : item.y1 < at) return false;
  if (low ? item.y1 <= at : item.y0 >= at) return true;
  (low ? item.y1 : item.y0) = at;
  const KeptSegment& s = kept_[item.segment];
  const Vec<double> d{s.b.x - s.a.x, s.b.y - s.a.y};
  if (std::abs(d.y) <= shortest_) return true;
  const double slope = d.x / d.y;
  const double x = s.a.x + (at - s.a.y) * slope;
  const double error = cut_error_ * (2 + std::abs(slope));
  if ((slope > 0) == low) {
    item.x1 = std::min(item.x1, x + error);
  } else {
    item.x0 = std::max(item.x0, x - error);
  }
  return item.x0 <= item.x1;
}

CrowdItem CrowdFinder::bounds_of(std::size_t begin, std::size_t end) const {
  CrowdItem box = items_[begin];
  visit(begin + 1, end, [&](const CrowdItem& item) {
    box.x0 = std::min(box.x0, item.x0);
    box.y0 = std::min(box.y0, item.y0);
    box.x1 = std::max(box.x1, item.x1);
    box.y1 = std::max(box.y1, item.y1);
  });
  return box;
}

/// Returns the division at the median of a sample's centres.
CrowdFinder::Division CrowdFinder::division(std::size_t begin, std::size_t end, bool by_x) const {
  constexpr std::size_t kSampled = 31;
  std::array<double, kSampled> sample;
  const std::size_t count = end - begin;
  for (std::size_t i = 0; i < kSampled; ++i) {
    const CrowdItem& item = items_[begin + i * count / kSampled];
    sample[i] = by_x ? (item.x0 + item.x1) / 2 : (item.y0 + item.y1) / 2;
  }
  std::nth_element(sample.begin(), sample.begin() + kSampled / 2, sample.end());
  const double at = sample[kSampled / 2];
  std::size_t low = 0;
  std::size_t high = 0;
  visit(begin, end, [&](const CrowdItem& item) {
    low += (by_x ? item.x1 : item.y1) < at - slack_ ? 1U : 0U;
    high += (by_x ? item.x0 : item.y0) > at + slack_ ? 1U : 0U;
  });
  return {by_x, at, count - low - high, std::min(low, high)};
}

/// Solves the items [begin, end) of the stack. Afterwards, only their order has changed.
void CrowdFinder::divide(std::size_t begin, std::size_t end, const PlanePart& part, int poor) {
  const std::size_t count = end - begin;
  if (count < 2) return;
  meeter_.enter(part);
  if (count <= kFew) return meet_all(begin, end);
  const CrowdItem box = bounds_of(begin, end);
  const bool wide = box.x1 - box.x0 >= box.y1 - box.y0;
  // Within a few slacks, each half would hold nearly all.
  constexpr double kLeastSlacks = 64;
  if ((wide ? box.x1 - box.x0 : box.y1 - box.y0) < kLeastSlacks * slack_) {
    return meet_in_strip(begin, end, box);
  }
  Division best = division(begin, end, wide);
  const bool is_good = best.in_both < count / 6;
  if (!is_good) {
    const Division other = division(begin, end, !wide);
    if (other.in_both < best.in_both) best = other;
  }
  // Each half leaves out a sixteenth at least, so dividing ends. (There are more than kFew.)
  const bool is_useless = best.in_less < count / 16 || best.in_both > count * 3 / 4;
  const bool is_poor = best.in_both > count * 2 / 5;
  if (is_useless || (is_poor && poor == 0)) return meet_in_strip(begin, end, box);
  if (is_poor) {
    const std::size_t ending =
        std::min(count_ending(begin, end, box, true), count_ending(begin, end, box, false));
    if (ending <= kFew) return meet_in_strip(begin, end, box);
  }
  const int left = std::min(kMaxPoor, poor - (is_poor ? 1 : 0) + (is_good ? 1 : 0));
  for (const bool low : {true, false}) {
    PlanePart half = part;
    (best.by_x ? (low ? half.x1 : half.x0) : (low ? half.y1 : half.y0)) = best.at;
    const double at = low ? best.at + slack_ : best.at - slack_;
    // A copy of each, because the list grows.
    visit(begin, end, [&](CrowdItem item) {
      const bool near = best.by_x ? cut_x(item, at, low) : cut_y(item, at, low);
      if (near) append(items_, item, cancellation_);
    });
    divide(end, items_.size(), half, left);
    items_.resize(end);
  }
}

void CrowdFinder::meet_all(std::size_t begin, std::size_t end) {
  cancellation_.check(end - begin);
  for (std::size_t i = begin + 1; i < end; ++i) {
    for (std::size_t j = begin; j < i; ++j) meet(items_[j], items_[i]);
  }
}

// -- Strips -----------------------------------------------------------------------------------
// In a strip, most segments pass from one side to the other. What follows is said of a strip with
// sides x = box.x0 and x = box.x1; for the other kind of strip, exchange x and y.

/// Tells whether a segment passes a strip from side to side.
bool CrowdFinder::passes(const CrowdItem& item, const CrowdItem& box, bool by_x) const {
  const KeptSegment& s = kept_[item.segment];
  const auto [low, high] = by_x ? std::minmax(s.a.x, s.b.x) : std::minmax(s.a.y, s.b.y);
  return low <= (by_x ? box.x0 : box.y0) && high >= (by_x ? box.x1 : box.y1) &&
         high - low > shortest_;
}
std::size_t CrowdFinder::count_ending(std::size_t begin, std::size_t end, const CrowdItem& box,
                                      bool by_x) const {
  std::size_t count = 0;
  visit(begin, end, [&](const CrowdItem& i) { count += passes(i, box, by_x) ? 0U : 1U; });
  return count;
}

void CrowdFinder::meet_in_strip(std::size_t begin, std::size_t end, const CrowdItem& box) {
  const bool by_x = count_ending(begin, end, box, true) <= count_ending(begin, end, box, false);
  const auto first = items_.begin() + static_cast<std::ptrdiff_t>(begin);
  const auto last = items_.begin() + static_cast<std::ptrdiff_t>(end);
  const auto middle = static_cast<std::size_t>(std::partition(first, last,
                                                              [&](const CrowdItem& i) {
                                                                cancellation_.check();
                                                                return !passes(i, box, by_x);
                                                              }) -
                                               items_.begin());
  meet_ending(begin, middle, box);
  const double error = list_lines(middle, end, box, by_x);
  meet_ending_with_lines(begin, middle, by_x, error);
  meet_lines(error);
}

/// Meets segments that end in the strip, in the order of their boxes along the longer side.
void CrowdFinder::meet_ending(std::size_t begin, std::size_t end, const CrowdItem& box) {
  const bool wide = box.x1 - box.x0 >= box.y1 - box.y0;
  const auto low = [wide](const CrowdItem& i) { return wide ? i.x0 : i.y0; };
  std::sort(items_.begin() + static_cast<std::ptrdiff_t>(begin),
            items_.begin() + static_cast<std::ptrdiff_t>(end),
            cancellation_.counting(
                [&](const CrowdItem& a, const CrowdItem& b) { return low(a) < low(b); }));
  for (std::size_t i = begin; i < end; ++i) {
    const double reach = wide ? items_[i].x1 : items_[i].y1;
    std::size_t j = i + 1;
    for (; j < end && low(items_[j]) <= reach; ++j) meet(items_[i], items_[j]);
    cancellation_.check(1 + (j - i) / 2);
  }
}

/// Lists where segments that pass the strip enter and leave it, from bottom to top on the left.
/// Returns a bound on the error of these heights.
double CrowdFinder::list_lines(std::size_t begin, std::size_t end, const CrowdItem& box,
                               bool by_x) {
  auto& lines = scratch_.lines;
  lines.clear();
  make_room(lines, end - begin, cancellation_);
  double steepest = 0;
  auto next = static_cast<std::uint32_t>(begin);
  visit(begin, end, [&](const CrowdItem& item) {
    const KeptSegment& s = kept_[item.segment];
    const Vec<double> a = by_x ? s.a : Vec<double>{s.a.y, s.a.x};
    const Vec<double> b = by_x ? s.b : Vec<double>{s.b.y, s.b.x};
    const double slope = (b.y - a.y) / (b.x - a.x);
    steepest = std::max(steepest, std::abs(slope));
    lines.push_back({a.y + ((by_x ? box.x0 : box.y0) - a.x) * slope,
                     a.y + ((by_x ? box.x1 : box.y1) - a.x) * slope, next++});
  });
  std::sort(lines.begin(), lines.end(),
            cancellation_.counting(
                [](const StripLine& s, const StripLine& t) { return s.left < t.left; }));
  return cut_error_ * (2 + steepest);
}

/// Meets segments that end in the strip with those that pass it, by their heights on the left. On
/// the way to the right, none changes its height by more than the one that changes it most.
void CrowdFinder::meet_ending_with_lines(std::size_t begin, std::size_t end, bool by_x,
                                         double error) {
  const auto& lines = scratch_.lines;
  double most = 0;
  visit_in_pieces(lines, cancellation_, [&](const StripLine& line) {
    most = std::max(most, std::abs(line.right - line.left));
  });
  for (std::size_t i = begin; i < end; ++i) {
    const CrowdItem item = items_[i];
    const double low = (by_x ? item.y0 : item.x0) - most - error;
    const double high = (by_x ? item.y1 : item.x1) + most + error;
    auto line = std::lower_bound(lines.begin(), lines.end(), low,
                                 [](const StripLine& s, double y) { return s.left < y; });
    for (; line != lines.end() && line->left <= high; ++line) {
      cancellation_.check();
      meet(item, items_[line->item]);
    }
  }
}

/// Meets segments that pass the strip, if their order on the right is not certainly that on the
/// left. They are inserted in the order on the left into a list in the order on the right. That
/// moves those segments of the list that change places with the new one.
void CrowdFinder::meet_lines(double error) {
  const auto& lines = scratch_.lines;
  auto& by_right = scratch_.by_right;
  by_right.clear();
  make_room(by_right, lines.size(), cancellation_);
  for (std::uint32_t t = 0; t < lines.size(); ++t) {
    const CrowdItem& item = items_[lines[t].item];
    const double certainly_below = lines[t].right - 2 * error;
    std::size_t place = by_right.size();
    std::size_t met = by_right.size();
    for (; met > 0 && lines[by_right[met - 1]].right >= certainly_below; --met) {
      const StripLine& other = lines[by_right[met - 1]];
      if (other.right > lines[t].right) place = met - 1;
      meet(items_[other.item], item);
    }
    cancellation_.check(1 + by_right.size() - met);
    by_right.insert(by_right.begin() + static_cast<std::ptrdiff_t>(place), t);
    // Those that are nearly equal on the left alone.
    for (std::uint32_t s = t; s-- > 0 && lines[s].left >= lines[t].left - 2 * error;) {
      cancellation_.check();
      if (lines[s].right < certainly_below) meet(items_[lines[s].item], item);
    }
  }
}

}  // namespace minksum
