// Divides crowds of segments, and sorts those that cannot be divided.
#include "sum/arrangement/crowds.hpp"

#include <algorithm>

namespace minksum {
namespace {

/// Whether doubles tell that a segment shares nothing with a line.
bool are_apart(const KeptSegment& s, const Line& line, const RoundingBounds& bounds) {
  const auto gap = [](double a, double b, double c, double d) {
    return std::max(std::min(c, d) - std::max(a, b), std::min(a, b) - std::max(c, d));
  };
  const auto& [p, q] = line;
  if (std::max(gap(s.a.x, s.b.x, p.x, q.x), gap(s.a.y, s.b.y, p.y, q.y)) > 4 * bounds.position) {
    return true;
  }
  // Returns the sign of the side of a point, or 0 if it is unknown.
  const auto side = [&](const Vec<double>& at) {
    const double left = s.d.x * (at.y - s.a.y);
    const double right = s.d.y * (at.x - s.a.x);
    const double bound = bounds.cross_bound(s.d, left, right, bounds.difference);
    return left - right > bound ? 1 : left - right < -bound ? -1 : 0;
  };
  return side(p) * side(q) > 0;
}

}  // namespace

void CrowdFinder::add(KeptId segment, const PlanePart& part) {
  cancellation_.check(2);
  const auto [a, b] = kept_[segment].clipped();
  BoxedSegment item{{std::min(a.x, b.x) - cut_error_, std::min(a.y, b.y) - cut_error_,
                     std::max(a.x, b.x) + cut_error_, std::max(a.y, b.y) + cut_error_},
                    segment};
  if (!division_.cut_to(part, item)) return;
  append(items_, item, cancellation_);
  short_count_ += is_short(segment) ? 1U : 0U;
}

void CrowdFinder::solve(const PlanePart& part) {
  group_short();
  meeter_.enter(part);
  for (std::size_t group = 0; group < groups_->groups.size(); ++group) meet_members(group);
  division_.divide(part);
  items_.clear();
}

void CrowdFinder::split(const PlanePart& part, std::size_t most,
                        std::vector<UndividedPart>& undivided) {
  group_short();
  division_.split(part, most, undivided);
  items_.clear();
}

void CrowdFinder::sort_along(Axis axis, std::vector<BoxedSegment>& items, std::size_t begin,
                             std::size_t end) const {
  std::sort(items.begin() + static_cast<std::ptrdiff_t>(begin),
            items.begin() + static_cast<std::ptrdiff_t>(end),
            cancellation_.counting([axis](const BoxedSegment& a, const BoxedSegment& b) {
              return a.low(axis) < b.low(axis);
            }));
}

void CrowdFinder::meet_few(std::size_t begin, std::size_t end) {
  cancellation_.check(end - begin);
  for (std::size_t i = begin + 1; i < end; ++i) {
    for (std::size_t j = begin; j < i; ++j) meet(items_[j], items_[i]);
  }
}

// -- Short segments ---------------------------------------------------------------------------
/// Takes crowds of short segments off the list, and puts a group in the place of each.
void CrowdFinder::group_short() {
  SegmentGroups& found = scratch_.groups;
  auto& members = found.members;
  found.groups.clear();
  groups_ = &found;
  const bool is_crowd = short_count_ > Division::kFew;
  short_count_ = 0;
  if (!is_crowd) return;
  const auto first_short =
      std::partition(items_.begin(), items_.end(), [&](const BoxedSegment& item) {
        cancellation_.check();
        return !is_short(item.segment);
      });
  members.assign(first_short, items_.end());
  items_.erase(first_short, items_.end());
  found.moved.resize(members.size());
  sort_along(Axis::kX, members, 0, members.size());
  // What lies beside a gap shares nothing with what lies beyond.
  for (std::size_t first = 0, next = 0; first < members.size(); first = next) {
    next = gap_after(first, members.size(), Axis::kX);
    sort_along(Axis::kY, members, first, next);
    for (std::size_t begin = first, end = first; begin < next; begin = end) {
      end = gap_after(begin, next, Axis::kY);
      add_group(begin, end);
    }
  }
}

/// Moves short segments to the origin. Returns their extent there, or 0 if they are far apart
/// there, too.
double CrowdFinder::move_short(std::size_t begin, std::size_t end) {
  constexpr std::uint64_t kUnitsToMove = 16;
  // Each extent is then at most 2^-22 of the one around it, so groups within groups come to an end.
  constexpr double kMostShort = 256;
  if (!meeter_.can_move_to(short_)) return 0;
  const auto& members = scratch_.groups.members;
  double extent = 0;
  for (std::size_t i = begin; i < end; ++i) {
    cancellation_.check(kUnitsToMove);
    const KeptSegment s = meeter_.moved(members[begin].segment, members[i].segment);
    scratch_.groups.moved[i] = {s.a, s.b};
    extent = std::max({extent, size(s.a), size(s.b)});
  }
  return extent <= kMostShort * short_ && meeter_.can_move_to(extent) ? extent : 0;
}

/// Meets the members of a group with one another, where they are moved to the origin.
void CrowdFinder::meet_members(std::size_t group) {
  if (!scratch_.moved) scratch_.moved = std::make_unique<MovedCrowd>();
  auto& [kept, memory] = *scratch_.moved;
  if (kept.size() < kept_.size()) resize_in_pieces(kept, kept_.size(), cancellation_);
  const auto& [members, moved, groups] = *groups_;
  const auto [begin, end, extent] = groups[group];
  for (std::size_t i = begin; i < end; ++i) {
    const KeptId id = members[i].segment;
    kept[id] = kept_[id];
    kept[id].a = moved[i].start;
    kept[id].b = moved[i].end;
  }
  SegmentMeeter meeter(meeter_, extent, kept, kept_[members[begin].segment].a);
  CrowdFinder finder(extent, kept, meeter, memory, hiding_, cancellation_);
  for (std::size_t i = begin; i < end; ++i) finder.add(members[i].segment, {});
  finder.solve({});
}

/// Lists a group in the place of short segments, or these if they are no crowd.
void CrowdFinder::add_group(std::size_t begin, std::size_t end) {
  SegmentGroups& found = scratch_.groups;
  const double extent = end - begin <= Division::kFew ? 0 : move_short(begin, end);
  if (extent == 0) {
    for (std::size_t i = begin; i < end; ++i) append(items_, found.members[i], cancellation_);
    return;
  }
  BoxedSegment item = found.members[begin];
  for (std::size_t i = begin; i < end; ++i) item.add(found.members[i]);
  item.segment = static_cast<std::uint32_t>(kept_.size() + found.groups.size());
  append(items_, item, cancellation_);
  found.groups.push_back({begin, end, extent});
}

/// Returns where the next gap between boxes is, in `members`, which are sorted along the axis.
std::size_t CrowdFinder::gap_after(std::size_t begin, std::size_t end, Axis axis) const {
  const auto& members = scratch_.groups.members;
  double reach = members[begin].high(axis);
  std::size_t i = begin + 1;
  for (; i < end && members[i].low(axis) <= reach; ++i) {
    reach = std::max(reach, members[i].high(axis));
  }
  cancellation_.check(i - begin);
  return i;
}

/// Meets the members of a group with another segment. If that one ends near them, doubles tell for
/// most of them that they share nothing with it.
void CrowdFinder::meet_group(const BoxedSegment& group, const BoxedSegment& other) {
  constexpr double kLong = 8;   // a part so long, beside the members' extent, leaves their box
  if (is_group(other)) return;  // there is a gap between two groups
  const auto& [members, moved, groups] = *groups_;
  const auto [begin, end, extent] = groups[group.segment - kept_.size()];
  cancellation_.check(end - begin);
  KeptSegment part = meeter_.moved(members[begin].segment, other.segment);
  if (size(part.b) < size(part.a)) {
    part.a = part.b;
    part.d = {-part.d.x, -part.d.y};
  }
  const bool is_near = size(part.a) <= extent;
  // A power of two keeps the digits of the direction.
  const int excess = std::max(0, std::ilogb(size(part.d)) - std::ilogb(kLong * extent));
  part.d = {std::ldexp(part.d.x, -excess), std::ldexp(part.d.y, -excess)};
  part.b = {part.a.x + part.d.x, part.a.y + part.d.y};
  const RoundingBounds bounds = meeter_.bounds_of_moved(4 * kLong * extent);
  if (is_near) meeter_.count(2 * (end - begin));
  for (std::size_t i = begin; i < end; ++i) {
    if (!is_near || !are_apart(part, moved[i], bounds)) meet(members[i], other);
  }
}

// -- Strips -----------------------------------------------------------------------------------
// In a strip, most segments pass from one side to the other. What follows is said of a strip with
// sides x = box.x0 and x = box.x1; for the other kind of strip, exchange x and y.

/// Tells whether a segment passes a strip from side to side.
bool CrowdFinder::passes(const BoxedSegment& item, const BoxOf<double>& box, Axis axis) const {
  if (is_group(item)) return false;
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
  sort_along(axis, items_, begin, end);
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
    // It also meets those that are nearly equal on the left alone.
    for (std::uint32_t s = t; s-- > 0 && lines[s].left >= lines[t].left - 2 * error;) {
      cancellation_.check();
      if (lines[s].right < certainly_below) meet(items_[lines[s].item], item);
    }
  }
}

}  // namespace minksum
