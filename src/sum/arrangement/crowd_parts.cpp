// Leaves out parts of a crowd that lie inside the sum, and divides crowds among their crossings.
#include <algorithm>
#include <array>
#include <cmath>

#include "machine/scramble.hpp"
#include "sum/arrangement/crowds.hpp"

namespace minksum {

/// The sum of two edges with vectors d and f, where d × f > 0. It starts at `at`.
struct CrowdFinder::Parallelogram {
  Vec<double> at;
  Vec<double> d;
  Vec<double> f;

  /// Whether a box is inside. A margin of a slack is far larger than all roundings.
  [[nodiscard, gnu::noinline]] bool contains(const BoxOf<double>& box, double slack) const {
    constexpr double kLeast = 0x1p-1000;  // far above what is lost to underflow
    const double width = (box.x1 - box.x0) / 2;
    const double height = (box.y1 - box.y0) / 2;
    const Vec<double> v{box.x0 + width - at.x, box.y0 + height - at.y};
    // The error of d × f may exceed a slack if one operand is far larger than the box.
    const double most = cross(d, f) - 0x1p-49 * size(d) * size(f);
    const auto is_between = [&](double product, const Vec<double>& side) {
      const double reach =
          std::abs(side.x) * height + std::abs(side.y) * width + 2 * slack * size(side);
      return reach > kLeast && product > reach && product < most - reach;
    };
    return is_between(cross(d, v), d) && is_between(cross(v, f), f);
  }
};

/// Hides what a part has of its items if the sum of two edges contains it. Such a sum is looked for
/// beside some items of the part that was divided: on the left of an item's edge lies its sum with
/// each of both edges at the item's vertex.
bool CrowdFinder::hide(std::size_t above, std::size_t begin, std::size_t end,
                       const BoxOf<double>& box) {
  // So few tries cost less than the division that they come after. In sums of 10,000 slivers, 128
  // tries left 0.98 of the crossings that 32 leave.
  constexpr std::size_t kItemsOfATry = 16;
  constexpr std::size_t kMostTried = 32;
  const std::size_t around = begin - above;
  const std::size_t tried = std::min(kMostTried, around / kItemsOfATry);
  const auto& [x, y, dx, dy, next] = hiding_->sites;
  for (std::size_t i = 0; i < tried; ++i) {
    const BoxedSegment& item = items_[above + scramble(i) % around];
    if (is_group(item)) continue;
    const auto [e, v] = kept_[item.segment].segment;
    const SiteId before = hiding_->previous[v];
    const Vec<double> sides[] = {{dx[v], dy[v]}, {-dx[before], -dy[before]}};
    for (const Vec<double>& side : sides) {
      const Parallelogram shape{kept_[item.segment].a, {dx[e], dy[e]}, side};
      if (shape.contains(box, meeter_.slack()) && hide_by(shape, begin, end)) return true;
    }
  }
  return false;
}

/// Lists the parts of items that a shape hides. Does nothing and returns false if it is not certain
/// that the shape contains them all. A shape that contains all boxes may not: the box of a nearly
/// level segment does not always hold the whole part that is listed.
bool CrowdFinder::hide_by(const Parallelogram& shape, std::size_t begin, std::size_t end) {
  auto& hidden = meeter_.hidden();
  const std::size_t before = hidden.size();
  const auto add = [&](const BoxedSegment& item) {
    if (is_group(item)) return false;
    const KeptSegment& s = kept_[item.segment];
    const bool by_x = std::abs(s.d.x) >= std::abs(s.d.y);
    const Axis axis = by_x ? Axis::kX : Axis::kY;
    const double start = by_x ? s.a.x : s.a.y;
    const double length = by_x ? s.d.x : s.d.y;
    const double low = (item.low(axis) - start) / length;
    const double high = (item.high(axis) - start) / length;
    append(hidden, {item.segment, std::min(low, high), std::max(low, high)}, cancellation_);
    const auto is_inside = [&](double share) {
      const Vec<double> p{s.a.x + share * s.d.x, s.a.y + share * s.d.y};
      return shape.contains({p.x, p.y, p.x, p.y}, meeter_.slack());
    };
    return is_inside(low) && is_inside(high);
  };
  for (std::size_t i = begin; i < end; ++i) {
    cancellation_.check();
    if (add(items_[i])) continue;
    hidden.resize(before);
    return false;
  }
  return true;
}

/// Returns the median of a sample's crossings, if there are many for each item. Then dividing costs
/// little beside meeting them all, and smaller parts may be hidden. Each half has half of the
/// crossings, so dividing ends. Not inlined into a recursion, because the sample takes 32 KB.
[[gnu::noinline]] std::optional<DividingLine> CrowdFinder::line_among_crossings(
    std::size_t begin, std::size_t end, const BoxOf<double>& part) const {
  constexpr std::size_t kMostSampled = 64;  // 2,016 pairs
  // With 4, 8, 16 and 32, a sum of 10,000 slivers that has 50 million crossings makes 3.6, 4.8, 6.8
  // and 10.1 million of them, in about the same time up to 16.
  constexpr double kManyOfAnItem = 8;
  if (hiding_ == nullptr) return std::nullopt;
  const std::size_t count = end - begin;
  // That makes about two pairs for each item, which cost less than to divide it.
  const std::size_t sampled =
      std::min(kMostSampled, static_cast<std::size_t>(std::sqrt(4 * static_cast<double>(count))));
  cancellation_.check(sampled * sampled / 4);
  const double near = 2 * meeter_.slack();
  constexpr std::size_t kMostPairs = kMostSampled * (kMostSampled - 1) / 2;
  std::array<std::array<double, kMostPairs>, 2> places;
  std::size_t found = 0;
  for (std::size_t i = 0; i < sampled; ++i) {
    const BoxedSegment& a = items_[begin + scramble(i) % count];
    if (is_group(a)) continue;
    const KeptSegment& s = kept_[a.segment];
    for (std::size_t j = 0; j < i; ++j) {
      const BoxedSegment& b = items_[begin + scramble(j) % count];
      if (is_group(b)) continue;
      const KeptSegment& t = kept_[b.segment];
      const double share = cross({t.a.x - s.a.x, t.a.y - s.a.y}, t.d) / cross(s.d, t.d);
      const Vec<double> p{s.a.x + share * s.d.x, s.a.y + share * s.d.y};
      const auto is_in = [&](const BoxOf<double>& box) {
        return p.x >= box.x0 && p.x <= box.x1 && p.y >= box.y0 && p.y <= box.y1;
      };
      // Dividing does not part segments that share an end.
      const Vec<double> ends[] = {s.a, s.b, t.a, t.b};
      const bool is_end = std::any_of(std::begin(ends), std::end(ends), [&](const Vec<double>& q) {
        return size({p.x - q.x, p.y - q.y}) < near;
      });
      if (is_end || !is_in(a) || !is_in(b) || !is_in(part)) continue;
      places[0][found] = p.x;
      places[1][found++] = p.y;
    }
  }
  const std::size_t ways = sampled * (sampled - 1);
  if (static_cast<double>(found) * static_cast<double>(count) <
      kManyOfAnItem * static_cast<double>(ways)) {
    return std::nullopt;
  }
  std::optional<DividingLine> best;
  double widest = 0;
  for (const Axis axis : {Axis::kX, Axis::kY}) {
    double* const begin_of = places[axis == Axis::kX ? 0 : 1].data();
    const auto [least, greatest] = std::minmax_element(begin_of, begin_of + found);
    const double width = *greatest - *least;
    std::nth_element(begin_of, begin_of + found / 2, begin_of + found);
    const double at = begin_of[found / 2];
    // Near a side of the part, one half would have all that the part has.
    if (width <= widest || at < part.low(axis) + near || at > part.high(axis) - near) continue;
    widest = width;
    best = DividingLine{axis, at};
  }
  return best;
}

}  // namespace minksum
