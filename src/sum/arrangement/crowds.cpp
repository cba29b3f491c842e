// Divides crowds of segments, and sorts those that cannot be divided.
#include "sum/arrangement/crowds.hpp"

#include <algorithm>

namespace minksum {

void CrowdFinder::add(KeptId segment, const PlanePart& part) {
  cancellation_.check(2);
  const auto [a, b] = kept_[segment].clipped();
  BoxedSegment item{{std::min(a.x, b.x) - cut_error_, std::min(a.y, b.y) - cut_error_,
                     std::max(a.x, b.x) + cut_error_, std::max(a.y, b.y) + cut_error_},
                    segment};
  if (division_.cut_to(part, item)) append(items_, item, cancellation_);
}

void CrowdFinder::solve(const PlanePart& part) {
  division_.divide(part);
  items_.clear();
}

void CrowdFinder::split(const PlanePart& part, std::size_t most,
                        std::vector<UndividedPart>& undivided) {
  division_.split(part, most, undivided);
  items_.clear();
}

void CrowdFinder::meet_few(std::size_t begin, std::size_t end) {
  cancellation_.check(end - begin);
  for (std::size_t i = begin + 1; i < end; ++i) {
    for (std::size_t j = begin; j < i; ++j) meet(items_[j], items_[i]);
  }
}

// -- Strips -----------------------------------------------------------------------------------
// In a strip, most segments pass from one side to the other. What follows is said of a strip with
// sides x = box.x0 and x = box.x1; for the other kind of strip, exchange x and y.

/// Tells whether a segment passes a strip from side to side.
bool CrowdFinder::passes(const BoxedSegment& item, const BoxOf<double>& box, Axis axis) const {
  const auto [a, b] = kept_[item.segment].clipped();
  const auto [low, high] = axis == Axis::kX ? std::minmax(a.x, b.x) : std::minmax(a.y, b.y);
  return low <= box.low(axis) && high >= box.high(axis) && high - low > shortest_;
}
std::size_t CrowdFinder::count_ending(std::size_t begin, std::size_t end, const BoxOf<double>& box,
                                      Axis axis) const {
  std::size_t count = 0;
  division_.visit(begin, end,
                  [&](const BoxedSegment& i) { count += passes(i, box, axis) ? 0U : 1U; });
  return count;
}

bool CrowdFinder::is_sorted_soon(std::size_t begin, std::size_t end,
                                 const BoxOf<double>& box) const {
  return std::min(count_ending(begin, end, box, Axis::kX),
                  count_ending(begin, end, box, Axis::kY)) <= Division::kFew;
}

void CrowdFinder::meet_crowd(std::size_t begin, std::size_t end, const BoxOf<double>& box) {
  const Axis axis =
      count_ending(begin, end, box, Axis::kX) <= count_ending(begin, end, box, Axis::kY) ? Axis::kX
                                                                                         : Axis::kY;
  const auto first = items_.begin() + static_cast<std::ptrdiff_t>(begin);
  const auto last = items_.begin() + static_cast<std::ptrdiff_t>(end);
  const auto middle = static_cast<std::size_t>(std::partition(first, last,
                                                              [&](const BoxedSegment& i) {
                                                                cancellation_.check();
                                                                return !passes(i, box, axis);
                                                              }) -
                                               items_.begin());
  meet_ending(begin, middle, box);
  const double error = list_lines(middle, end, box, axis);
  meet_ending_with_lines(begin, middle, axis, error);
  meet_lines(error);
}

/// Meets segments that end in the strip, in the order of their boxes along the longer side.
void CrowdFinder::meet_ending(std::size_t begin, std::size_t end, const BoxOf<double>& box) {
  const Axis axis = box.longer();
  std::sort(items_.begin() + static_cast<std::ptrdiff_t>(begin),
            items_.begin() + static_cast<std::ptrdiff_t>(end),
            cancellation_.counting([&](const BoxedSegment& a, const BoxedSegment& b) {
              return a.low(axis) < b.low(axis);
            }));
  for (std::size_t i = begin; i < end; ++i) {
    const double reach = items_[i].high(axis);
    std::size_t j = i + 1;
    for (; j < end && items_[j].low(axis) <= reach; ++j) meet(items_[i], items_[j]);
    cancellation_.check(1 + (j - i) / 2);
  }
}

/// Lists where segments that pass the strip enter and leave it, from bottom to top on the left.
/// Returns a bound on the error of these heights.
double CrowdFinder::list_lines(std::size_t begin, std::size_t end, const BoxOf<double>& box,
                               Axis axis) {
  auto& lines = scratch_.lines;
  lines.clear();
  make_room(lines, end - begin, cancellation_);
  double steepest = 0;
  auto next = static_cast<std::uint32_t>(begin);
  division_.visit(begin, end, [&](const BoxedSegment& item) {
    const KeptSegment& s = kept_[item.segment];
    const Vec<double> a = axis == Axis::kX ? s.a : Vec<double>{s.a.y, s.a.x};
    const Vec<double> b = axis == Axis::kX ? s.b : Vec<double>{s.b.y, s.b.x};
    const double slope = (b.y - a.y) / (b.x - a.x);
    steepest = std::max(steepest, std::abs(slope));
    lines.push_back(
        {a.y + (box.low(axis) - a.x) * slope, a.y + (box.high(axis) - a.x) * slope, next++});
  });
  std::sort(lines.begin(), lines.end(),
            cancellation_.counting(
                [](const StripLine& s, const StripLine& t) { return s.left < t.left; }));
  return cut_error_ * (2 + steepest);
}

/// Meets segments that end in the strip with those that pass it. A passing segment is sought by its
/// height at the strip's left side. The steepest one bounds how far heights differ farther right.
void CrowdFinder::meet_ending_with_lines(std::size_t begin, std::size_t end, Axis axis,
                                         double error) {
  const auto& lines = scratch_.lines;
  double most = 0;
  visit_in_pieces(lines, cancellation_, [&](const StripLine& line) {
    most = std::max(most, std::abs(line.right - line.left));
  });
  for (std::size_t i = begin; i < end; ++i) {
    const BoxedSegment item = items_[i];
    const double low = item.low(other(axis)) - most - error;
    const double high = item.high(other(axis)) + most + error;
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
    const BoxedSegment& item = items_[lines[t].item];
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
