// Defines the ladder: a floating-point filter with proven bounds, and then the exact kernel.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "exact/bit_budget.hpp"
#include "exact/exact_kernel.hpp"
#include "machine/cancellation.hpp"

namespace minksum {

/// The sites' coordinates and edge vectors, each rounded once to the nearest double. No component
/// of an edge vector becomes 0 by rounding.
struct ApproximateSites {
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> dx;  ///< from a site to the next site of its ring
  std::vector<double> dy;
  std::vector<SiteId> next;
};

/// Bounds on the rounding of the numbers that the filter works with.
///
/// Let M bound every coordinate. A stored coordinate is off by at most M·2^-53. A difference of two
/// sums has four coordinates and three roundings of numbers up to 4M, so it is off by at most
/// M·2^-49. A component of an edge vector is rounded once, so it is off by at most 2^-53 of itself,
/// and a product of two of them by 2^-52 of itself and next to nothing more. These errors are all 0
/// where B ≤ 52 bits.
///
/// A product is off by its size times 2^-53, and a difference of two products by half an ulp more.
/// In all that is m·2^-51, where m is the sum of both magnitudes. This error is 0 where B ≤ 25
/// bits.
///
/// Numbers do not underflow on a grid, where they are integers. Where they are rationals, M is at
/// most 2^62. An edge vector that is rounded to a multiple of 2^-1074 makes a product with a
/// difference of sums, of at most 4M, wrong by less than 2^-1008.
struct RoundingBounds {
  double magnitude = 0;   ///< M
  double difference = 0;  ///< of two sum vertices, per component
  double direction = 0;   ///< relative, of a product of components of two edge vectors
  double product = 0;     ///< relative, of a cross product
  double underflow = 0;   ///< of a cross product
  double position = 0;    ///< of a point a + λd computed in doubles, beyond λ's own error

  /// Covers the rounding of a bound, and products of two relative errors.
  static constexpr double kInflate = 1 + 0x1p-48;

  /// Bounds the error of left − right, the cross product of an edge vector d and a vector whose
  /// components are known within `v_error`.
  [[nodiscard]] double cross_bound(const Vec<double>& d, double left, double right,
                                   double v_error) const {
    const double by_v = v_error == 0 ? 0 : (std::abs(d.x) + std::abs(d.y)) * v_error;
    return ((std::abs(left) + std::abs(right)) * (product + direction) + by_v) * kInflate +
           underflow;
  }

  static RoundingBounds of(double magnitude, bool sums_exact, bool products_exact) {
    RoundingBounds bounds;
    bounds.magnitude = magnitude;
    bounds.difference = sums_exact ? 0 : magnitude * 0x1p-49;
    bounds.direction = sums_exact ? 0 : 0x1p-52;
    bounds.product = products_exact ? 0 : 0x1p-51;
    bounds.position = magnitude * 0x1p-48;
    return bounds;
  }
  /// Returns the bounds of rationals.
  static RoundingBounds of_rationals(double magnitude) {
    RoundingBounds bounds = of(magnitude, false, false);
    bounds.underflow = 0x1p-1000;
    return bounds;
  }
  /// Returns the bounds of places that were moved and rounded anew, so that none is beyond
  /// `magnitude`.
  [[nodiscard]] RoundingBounds moved_to(double new_magnitude) const {
    RoundingBounds bounds = of(new_magnitude, difference == 0, product == 0);
    bounds.underflow = underflow;
    return bounds;
  }
  /// Returns bounds that trust no number, so that the exact kernel decides everything.
  static RoundingBounds distrustful(double magnitude) {
    RoundingBounds bounds = of(magnitude, false, false);
    bounds.difference = bounds.direction = HUGE_VAL;
    return bounds;
  }
};

/// The counts of decisions that the filter and the kernel took.
struct LadderCounts {
  std::uint64_t by_filter = 0;
  std::uint64_t by_kernel = 0;
};

/// Takes all decisions of the pipeline: inline up to the filter, and exactly beyond it. Each
/// computation needs a `Predicates` of its own, because decisions are counted. Only one thread may
/// use it at a time.
class Predicates {
 public:
  Predicates(const ApproximateSites& sites, const ExactKernel& kernel, const RoundingBounds& bounds,
             Cancellation& cancellation)
      : sites_(&sites),
        kernel_(&kernel),
        bounds_(bounds),
        cancellation_(&cancellation),
        work_(kernel.work()) {}

  /// Returns one for another thread, which counts its decisions from 0 on.
  [[nodiscard]] Predicates for_thread(Cancellation& cancellation) const {
    return {*sites_, *kernel_, bounds_, cancellation};
  }
  /// Adds decisions that were taken on another thread.
  void add(const LadderCounts& counts) {
    counts_.by_filter += counts.by_filter;
    counts_.by_kernel += counts.by_kernel;
  }

  [[nodiscard]] const RoundingBounds& bounds() const { return bounds_; }
  [[nodiscard]] const ExactKernel& kernel() const { return *kernel_; }
  [[nodiscard]] const ApproximateSites& sites() const { return *sites_; }
  [[nodiscard]] const LadderCounts& counts() const { return counts_; }
  [[nodiscard]] Cancellation& cancellation() const { return *cancellation_; }

  // -- Approximate values, with `bounds()` --------------------------------------------------
  [[nodiscard]] Vec<double> direction(SiteId edge) const {
    return {sites_->dx[edge], sites_->dy[edge]};
  }
  [[nodiscard]] Vec<double> position(const SumVertex& v) const {
    return {sites_->x[v.first] + sites_->x[v.second], sites_->y[v.first] + sites_->y[v.second]};
  }
  [[nodiscard]] Vec<double> start(const Segment& s) const {
    return position(sum_vertex(s.edge, s.vertex));
  }
  [[nodiscard]] static SumVertex start_vertex(const Segment& s) {
    return sum_vertex(s.edge, s.vertex);
  }
  [[nodiscard]] SumVertex end_vertex(const Segment& s) const {
    return sum_vertex(sites_->next[s.edge], s.vertex);
  }

  // -- Decisions ----------------------------------------------------------------------------
  /// Returns the sign of a cross product `d × v` of an edge vector and a difference of sum
  /// vertices. The result of `exact` is returned where the filter cannot tell.
  template <class Exact>
  Sign filtered_cross(const Vec<double>& d, const Vec<double>& v, Exact exact) {
    return filtered_cross(d, v, bounds_.difference, exact);
  }
  Sign orientation(const Segment& s, const SumVertex& v) {
    const Vec<double> a = start(s);
    const Vec<double> p = position(v);
    return filtered_cross(direction(s.edge), {p.x - a.x, p.y - a.y},
                          [&] { return kernel_->orientation(s, v); });
  }
  Sign cross(SiteId edge, SiteId other) {
    return filtered_edges(direction(edge), direction(other),
                          [&] { return kernel_->cross(edge, other); });
  }
  Sign dot(SiteId edge, SiteId other) {
    const Vec<double> e = direction(other);
    // d · e is d × e', where e' is e turned by a right angle.
    return filtered_edges(direction(edge), {-e.y, e.x}, [&] { return kernel_->dot(edge, other); });
  }
  /// Returns the sign of a component of an edge vector.
  Sign component(SiteId edge, Axis axis) {
    const double value = axis == Axis::kX ? sites_->dx[edge] : sites_->dy[edge];
    return filtered_difference(value, std::abs(value) * bounds_.direction,
                               [&] { return kernel_->compare(sites_->next[edge], edge, axis); });
  }
  Sign compare(const SumVertex& a, const SumVertex& b, Axis axis) {
    const Vec<double> p = position(a);
    const Vec<double> q = position(b);
    return filtered_difference(axis == Axis::kX ? p.x - q.x : p.y - q.y, bounds_.difference,
                               [&] { return kernel_->compare(a, b, axis); });
  }
  /// Returns the orientation of three sites of one operand.
  Sign orientation(SiteId a, SiteId b, SiteId c) {
    const auto& [x, y, dx, dy, next] = *sites_;
    const Vec<double> d{x[b] - x[a], y[b] - y[a]};
    const Vec<double> v{x[c] - x[a], y[c] - y[a]};
    const double left = d.x * v.y;
    const double right = d.y * v.x;
    // Both factors are differences of coordinates; the bound for sums covers that. The last term is
    // the product of both errors.
    const double e = bounds_.difference;
    const double by_d = e == 0 ? 0 : (std::abs(v.x) + std::abs(v.y)) * e + 2 * e * e;
    return filtered_difference(left - right, bounds_.cross_bound(d, left, right, e) + by_d * RoundingBounds::kInflate,
                               [&] { return kernel_->orientation(a, b, c); });
  }
  Sign compare(SiteId a, SiteId b, Axis axis) {
    const auto& coordinate = axis == Axis::kX ? sites_->x : sites_->y;
    return filtered_difference(coordinate[a] - coordinate[b], bounds_.difference,
                               [&] { return kernel_->compare(a, b, axis); });
  }
  /// Returns the order by x, then by y.
  Sign compare(SiteId a, SiteId b) {
    const Sign by_x = compare(a, b, Axis::kX);
    return by_x != kZero ? by_x : compare(a, b, Axis::kY);
  }
  /// Returns the order of two points along s, whose parameters are known within their errors.
  Sign compare_along(const Segment& s, double lambda_a, double error_a, const PointOnSegment& a,
                     double lambda_b, double error_b, const PointOnSegment& b) {
    return filtered_difference(lambda_a - lambda_b, error_a + error_b,
                               [&] { return kernel_->compare_along(s, a, b); });
  }
  /// Returns the order of two nodes along an axis. `p` and `q` approximate them within `p_error`
  /// and `q_error`.
  Sign compare(const NodePoint& a, const Vec<double>& p, double p_error, const NodePoint& b,
               const Vec<double>& q, double q_error, Axis axis) {
    return filtered_difference(axis == Axis::kX ? p.x - q.x : p.y - q.y, p_error + q_error,
                               [&] { return kernel_->compare(a, b, axis); });
  }
  Sign orientation(const Segment& s, const NodePoint& node, const Vec<double>& p, double p_error) {
    return side(s.edge, start_vertex(s), p, p_error + bounds_.position,
                [&] { return kernel_->orientation(s, node); });
  }

  // -- Points that are known within an error; `exact` is asked where the filter cannot tell -----
  /// Returns on which side of an edge, moved so that v is on its line, a point lies.
  template <class Exact>
  Sign side(SiteId edge, const SumVertex& v, const Vec<double>& at, double error, Exact exact) {
    const Vec<double> p = position(v);
    return filtered_cross(direction(edge), {at.x - p.x, at.y - p.y}, bounds_.difference + error,
                          exact);
  }
  /// Returns the sign of a point minus v along an axis.
  template <class Exact>
  Sign compare(const Vec<double>& at, double error, const SumVertex& v, Axis axis, Exact exact) {
    const Vec<double> p = position(v);
    return filtered_difference(axis == Axis::kX ? at.x - p.x : at.y - p.y,
                               bounds_.difference + error, exact);
  }

  // -- Probes -------------------------------------------------------------------------------
  /// Returns the probe's coordinates, off by at most `bounds().position` (+ difference) each.
  [[nodiscard]] Vec<double> position(const Probe& probe) const {
    const double lambda = probe.exact != nullptr
                              ? to_double(*probe.exact)
                              : std::ldexp(static_cast<double>(probe.numerator), -probe.shift);
    const Vec<double> a = start(probe.segment);
    const Vec<double> d = direction(probe.segment.edge);
    return {a.x + lambda * d.x, a.y + lambda * d.y};
  }
  /// Returns a sign that is never zero. The probe stands off its segment by an infinitesimal along
  /// its right normal, and by one of second order along its direction.
  Sign orientation(SiteId edge, const SumVertex& v, const Probe& probe, const Vec<double>& at) {
    return side(edge, v, at, 2 * bounds_.position, [&] {
      Sign sign = kernel_->probe_orientation(edge, v, probe);
      if (sign == kZero) sign = -dot(edge, probe.segment.edge);
      if (sign == kZero) sign = cross(edge, probe.segment.edge);
      return sign;
    });
  }
  /// Returns the sign of (probe − v) along y, which is never zero for the same reason.
  Sign compare_y(const Probe& probe, const Vec<double>& at, const SumVertex& v) {
    return compare(at, 2 * bounds_.position, v, Axis::kY, [&] {
      Sign sign = kernel_->probe_compare(probe, v, Axis::kY);
      if (sign == kZero) sign = -component(probe.segment.edge, Axis::kX);
      if (sign == kZero) sign = component(probe.segment.edge, Axis::kY);
      return sign;
    });
  }

  void count_filtered(std::uint64_t n) { counts_.by_filter += n; }
  /// Counts a decision that the kernel is about to take, and its work.
  void count_kernel() {
    ++counts_.by_kernel;
    cancellation_->check(work_);
  }

 private:
  Sign count_filter(Sign sign) {
    ++counts_.by_filter;
    return sign;
  }
  template <class Exact>
  Sign filtered_difference(double value, double bound, Exact exact) {
    if (value > bound) return count_filter(kPositive);
    if (value < -bound) return count_filter(kNegative);
    if (bound == 0) return count_filter(kZero);
    count_kernel();
    return exact();
  }
  template <class Exact>
  Sign filtered_cross(const Vec<double>& d, const Vec<double>& v, double v_error, Exact exact) {
    const double left = d.x * v.y;
    const double right = d.y * v.x;
    return filtered_difference(left - right, bounds_.cross_bound(d, left, right, v_error), exact);
  }
  /// Does the same for two edge vectors.
  template <class Exact>
  Sign filtered_edges(const Vec<double>& d, const Vec<double>& e, Exact exact) {
    // Underflow takes nothing from a product with 0.
    if (bounds_.underflow != 0 && ((d.x == 0 && e.x == 0) || (d.y == 0 && e.y == 0))) {
      return count_filter(kZero);
    }
    return filtered_cross(d, e, 0, exact);
  }

  const ApproximateSites* sites_;
  const ExactKernel* kernel_;
  RoundingBounds bounds_;
  Cancellation* cancellation_;
  std::uint64_t work_;  ///< units of work of a decision by the kernel
  LadderCounts counts_;
};

}  // namespace minksum
