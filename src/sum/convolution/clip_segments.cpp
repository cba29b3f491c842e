#include <algorithm>
#include <cmath>

#include "sum/convolution/convolution.hpp"

namespace minksum {
namespace {

/// Far along a ring, few crossings are found. With 16 to 32 steps, 203 sums took within 1 % of the
/// same time on the geometric mean; with 8 or 64 they took 8 % more.
constexpr int kMostSteps = 24;

}  // namespace

/// Takes off what lies beyond a crossing. An edge of the vertex's operand leads from `a` to `b`,
/// seen from the vertex, and crosses the segment's line to its right.
void SegmentClipper::cut(const Vec<double>& d, const Vec<double>& a, const Vec<double>& b,
                         Clip& clip) const {
  const auto left_of = [&](const Vec<double>& v, double& bound) {
    const double left = d.x * v.y;
    const double right = d.y * v.x;
    bound += bounds_.cross_bound(d, left, right, bounds_.difference);
    return left - right;
  };
  const auto size = [](const Vec<double>& v) { return std::abs(v.x) + std::abs(v.y); };
  double bound = 0;
  const double from = left_of(a, bound);
  const double to = left_of(b, bound);
  // Both signs are sure then, and from / (from - to) is off by less than 2^-12.
  if (!(std::min(from, -to) > bound && from - to >= 0x1p13 * bound)) return;
  const double square = dot(d, d);
  if (square < 0x1p-900) return;  // its digits may be lost
  const double start = dot(d, a) / square;
  const double run = dot(d, b) / square - start;
  const double crossing = start + run * (from / (from - to));
  // A place along the line is off by 2 · doubt / size(d) at most, because the square is at least
  // half of size(d)^2. The margin is twice that, and twice what the quotient above is off. The last
  // term is far more than rounding to single precision takes.
  const double doubt = bounds_.difference + 0x1p-50 * std::max(size(a), size(b));
  const double margin = 8 * doubt / size(d) + 0x1p-11 * std::abs(run) + 0x1p-22;
  if (crossing >= margin) clip.to = std::min(clip.to, static_cast<float>(crossing + margin));
  if (crossing <= -margin) {
    clip.from = std::max(clip.from, static_cast<float>(1 + crossing - margin));
  }
}

/// Follows a ring from the segment's vertex, until it crosses the segment's line from left to
/// right, or is as far along the line as the segment is long.
void SegmentClipper::walk(const Vec<double>& d, const Rings& rings, const SiteId* step,
                          SiteId vertex, Clip& clip) const {
  const double square = dot(d, d);
  const Vec<double> p{rings.x[vertex], rings.y[vertex]};
  Vec<double> before{0, 0};
  SiteId at = vertex;
  for (int steps = 0; steps < kMostSteps; ++steps) {
    at = step[at];
    const Vec<double> v{rings.x[at] - p.x, rings.y[at] - p.y};
    if (cross(d, v) < 0) return cut(d, before, v, clip);
    if (std::abs(dot(d, v)) > square) return;
    before = v;
  }
}

Clip SegmentClipper::clip(const Vec<double>& d, const Rings& rings, SiteId vertex) const {
  Clip clip;
  walk(d, rings, rings.next, vertex, clip);
  walk(d, rings, rings.previous, vertex, clip);
  return clip;
}

Clip SegmentClipper::clip(const Segment& segment) const {
  const auto& [x, y, dx, dy, next] = operands_->sites;
  return clip({dx[segment.edge], dy[segment.edge]},
              {x.data(), y.data(), next.data(), operands_->previous.data()}, segment.vertex);
}

}  // namespace minksum
