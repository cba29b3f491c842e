#include "sum/convolution/convolution.hpp"

#include <algorithm>
#include <cmath>

namespace minksum {
namespace {

/// Far along a ring, few crossings are found. With 16 to 32 steps, 203 sums took within 1 % of the
/// same time on the geometric mean; with 8 or 64 they took 8 % more.
constexpr int kMostSteps = 24;

}  // namespace

/// Follows a ring from the segment's vertex, until it has certainly crossed the segment's line from
/// the side of the sum's interior, or is as far along the line as the segment is long.
template <class Step>
void SegmentClipper::walk(const Segment& segment, Step step, Clip& clip) const {
  const auto& [x, y, dx, dy, next] = o_.sites;
  const Vec<double> d{dx[segment.edge], dy[segment.edge]};
  const double square = d.x * d.x + d.y * d.y;
  const double length = std::abs(d.x) + std::abs(d.y);
  const Vec<double> p{x[segment.vertex], y[segment.vertex]};
  double below = 0;  // how far the last site is on the left of the line, times the length
  double along = 0;  // where it is along the line, times the square of the length
  double off = 0;    // the bound on the error of `below`
  double far = 0;    // how far it is from p
  SiteId at = segment.vertex;
  for (int steps = 0; steps < kMostSteps; ++steps) {
    at = step(at);
    const Vec<double> v{x[at] - p.x, y[at] - p.y};
    const double left = d.x * v.y;
    const double right = d.y * v.x;
    const double bound = o_.bounds.cross_bound(d, left, right, o_.bounds.difference);
    const double side = left - right;
    const double place = d.x * v.x + d.y * v.y;
    const double distance = std::abs(v.x) + std::abs(v.y);
    if (side < -bound) {
      if (!(below > off)) return;
      // The place of the crossing, and twice what it may be off.
      const double height = below - side;
      const double run = (place - along) / square;
      const double crossing = along / square + run * (below / height);
      const double doubt = o_.bounds.difference + 0x1p-50 * std::max(far, distance);
      const double margin = 8 * doubt / length + 0x1p-11 * std::abs(run) + 0x1p-22;
      if (!(0x1p13 * (off + bound) <= height)) return;
      if (crossing >= margin) clip.to = std::min(clip.to, static_cast<float>(crossing + margin));
      if (crossing <= -margin) {
        clip.from = std::max(clip.from, static_cast<float>(1 + crossing - margin));
      }
      return;
    }
    if (std::abs(place) > square) return;
    below = side;
    along = place;
    off = bound;
    far = distance;
  }
}

Clip SegmentClipper::clip(const Segment& segment) const {
  Clip clip;
  walk(
      segment, [&](SiteId v) { return o_.sites.next[v]; }, clip);
  walk(
      segment, [&](SiteId v) { return o_.previous[v]; }, clip);
  return clip;
}

}  // namespace minksum
