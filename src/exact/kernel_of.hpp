// Writes every exact decision once, for any rung of the ladder.
#pragma once

#include <cmath>

#include "exact/big_integer.hpp"
#include "exact/bit_budget.hpp"
#include "exact/exact_kernel.hpp"

namespace minksum {

/// Implements the formulas over one rung. Subclasses store the coordinates and give them out, which
/// differs between rungs.
template <class Rung>
class KernelOf : public ExactKernel {
 public:
  using Coord = typename Rung::Coord;
  using CrossNumber = typename Rung::Cross;
  using Along = typename Rung::Along;
  using Lexicographic = typename Rung::Lexicographic;
  using ProbeNumber = typename Rung::ProbeNumber;

  Sign orientation(SiteId a, SiteId b, SiteId c) const override {
    return cross_sign(difference(a, b), difference(a, c));
  }
  Sign dot(SiteId a, SiteId b, SiteId c, SiteId d) const override {
    return sign_of(exact_dot<CrossNumber>(difference(a, b), difference(c, d)));
  }
  Sign compare(SiteId a, SiteId b, Axis axis) const override {
    return sign_of(Coord(along(sites_[a], axis) - along(sites_[b], axis)));
  }
  Sign cross(SiteId edge, SiteId other) const override {
    return cross_sign(direction(edge), direction(other));
  }
  Sign dot(SiteId edge, SiteId other) const override {
    return sign_of(exact_dot<CrossNumber>(direction(edge), direction(other)));
  }

  Sign orientation(const Segment& s, const SumVertex& v) const override {
    return cross_sign(direction(s.edge), minus(position(v), start(s)));
  }
  Sign compare(const SumVertex& a, const SumVertex& b, Axis axis) const override {
    return sign_of(Coord(along(position(a), axis) - along(position(b), axis)));
  }
  Sign compare_along(const Segment& s, const PointOnSegment& a,
                     const PointOnSegment& b) const override {
    const auto p = parameter_of(s, a);
    const auto q = parameter_of(s, b);
    const Along difference(product<Along>(p.numerator, q.denominator) -
                           product<Along>(q.numerator, p.denominator));
    return sign_of(difference) * sign_of(p.denominator) * sign_of(q.denominator);
  }
  double parameter(const Segment& s, const PointOnSegment& point) const override {
    const auto p = parameter_of(s, point);
    if constexpr (std::is_same_v<CrossNumber, Fraction>) {
      return to_double(p.numerator / p.denominator);
    } else {
      return to_double(p.numerator) / to_double(p.denominator);
    }
  }

  Sign compare(const NodePoint& a, const NodePoint& b, Axis axis) const override {
    const Homogeneous p = homogeneous(a);
    const Homogeneous q = homogeneous(b);
    const bool x = axis == Axis::kX;
    return sign_of(Lexicographic(product<Lexicographic>(x ? p.x : p.y, q.denominator) -
                                 product<Lexicographic>(x ? q.x : q.y, p.denominator))) *
           sign_of(p.denominator) * sign_of(q.denominator);
  }
  Sign orientation(const Segment& s, const NodePoint& node) const override {
    if (!node.is_crossing) return orientation(s, node.vertex);
    const Vec<Coord> d = direction(s.edge);
    const auto t = crossing_of(node.first, node.second);
    const auto from_start = exact_cross<CrossNumber>(d, minus(start(node.first), start(s)));
    const auto ahead = exact_cross<CrossNumber>(d, direction(node.first.edge));
    return sign_of(Along(product<Along>(from_start, t.denominator) +
                         product<Along>(ahead, t.numerator))) *
           sign_of(t.denominator);
  }

  Sign probe_orientation(SiteId edge, const SumVertex& v, const Probe& probe) const override {
    if (probe.exact != nullptr) {
      return sign_of(minksum::cross(big(direction(edge)), exact_probe_offset(probe, v)));
    }
    return sign_of(exact_cross<ProbeNumber>(direction(edge), probe_offset(probe, v)));
  }
  Sign probe_compare(const Probe& probe, const SumVertex& v, Axis axis) const override {
    if (probe.exact != nullptr) return sign_of(along(exact_probe_offset(probe, v), axis));
    return sign_of(along(probe_offset(probe, v), axis));
  }

  Fraction exact_parameter(const Segment& s, const NodePoint& node) const override {
    const Vec<Fraction> at = exact_point(node);
    const Vec<Fraction> a = big(start(s));
    const Vec<Fraction> d = big(direction(s.edge));
    return (sign_of(d.x) != kZero ? (at.x - a.x) / d.x : (at.y - a.y) / d.y).reduced();
  }

  void connect(std::span<const SiteId> next) override { next_.assign(next.begin(), next.end()); }

 protected:
  template <class Number>
  static const Number& along(const Vec<Number>& v, Axis axis) {
    return axis == Axis::kX ? v.x : v.y;
  }
  static Vec<Coord> minus(const Vec<Coord>& a, const Vec<Coord>& b) {
    return {Coord(a.x - b.x), Coord(a.y - b.y)};
  }
  static Sign cross_sign(const Vec<Coord>& a, const Vec<Coord>& b) {
    return sign_of(exact_cross<CrossNumber>(a, b));
  }
  [[nodiscard]] Vec<Coord> difference(SiteId from, SiteId to) const {
    return minus(sites_[to], sites_[from]);
  }
  [[nodiscard]] Vec<Coord> direction(SiteId edge) const { return difference(edge, next_[edge]); }
  [[nodiscard]] Vec<Coord> position(const SumVertex& v) const {
    return {Coord(sites_[v.first].x + sites_[v.second].x),
            Coord(sites_[v.first].y + sites_[v.second].y)};
  }
  [[nodiscard]] Vec<Coord> start(const Segment& s) const {
    return position(sum_vertex(s.edge, s.vertex));
  }
  [[nodiscard]] Quotient<CrossNumber> crossing_of(const Segment& s, const Segment& t) const {
    const Vec<Coord> e = direction(t.edge);
    return {exact_cross<CrossNumber>(minus(start(t), start(s)), e),
            exact_cross<CrossNumber>(direction(s.edge), e)};
  }
  [[nodiscard]] Quotient<CrossNumber> parameter_of(const Segment& s,
                                                   const PointOnSegment& point) const {
    if (point.is_crossing) return crossing_of(s, point.other);
    const Vec<Coord> d = direction(s.edge);
    const Axis axis = sign_of(d.x) != kZero ? Axis::kX : Axis::kY;
    return {CrossNumber(along(minus(position(point.vertex), start(s)), axis)),
            CrossNumber(along(d, axis))};
  }
  struct Homogeneous {
    Lexicographic x;
    Lexicographic y;
    CrossNumber denominator;
  };
  [[nodiscard]] Homogeneous homogeneous(const NodePoint& node) const {
    if (!node.is_crossing) {
      const Vec<Coord> at = position(node.vertex);
      return {Lexicographic(at.x), Lexicographic(at.y), CrossNumber(1)};
    }
    const auto t = crossing_of(node.first, node.second);
    const Vec<Coord> at = start(node.first);
    const Vec<Coord> d = direction(node.first.edge);
    const auto coordinate = [&](const Coord& from, const Coord& along) {
      return Lexicographic(product<Lexicographic>(from, t.denominator) +
                           product<Lexicographic>(along, t.numerator));
    };
    return {coordinate(at.x, d.x), coordinate(at.y, d.y), t.denominator};
  }
  static Vec<Fraction> big(const Vec<Coord>& v) { return {Fraction(v.x), Fraction(v.y)}; }
  [[nodiscard]] Vec<Fraction> exact_point(const NodePoint& node) const {
    const Vec<Fraction> at = big(position(node.vertex_or_start()));
    if (!node.is_crossing) return at;
    const Vec<Fraction> d = big(direction(node.first.edge));
    const auto t = minksum::crossing_parameter(d, big(minus(start(node.second), start(node.first))),
                                               big(direction(node.second.edge)));
    Fraction lambda = t.numerator / t.denominator;
    // Terms that are not integers have the same denominators many times over.
    const bool integers = t.numerator.is_integer() && t.denominator.is_integer();
    if (!integers) lambda = lambda.reduced();
    return {at.x + d.x * lambda, at.y + d.y * lambda};
  }
  [[nodiscard]] Vec<Fraction> exact_probe_offset(const Probe& probe, const SumVertex& v) const {
    const Vec<Fraction> offset = big(minus(start(probe.segment), position(v)));
    const Vec<Fraction> d = big(direction(probe.segment.edge));
    return {offset.x + d.x * *probe.exact, offset.y + d.y * *probe.exact};
  }
  /// Returns (probe − v) · 2^shift.
  [[nodiscard]] Vec<ProbeNumber> probe_offset(const Probe& probe, const SumVertex& v) const {
    const Vec<Coord> offset = minus(start(probe.segment), position(v));
    const Vec<Coord> d = direction(probe.segment.edge);
    const auto coordinate = [&](const Coord& from, const Coord& along) {
      return ProbeNumber(product<ProbeNumber>(from, std::int64_t{1} << probe.shift) +
                         product<ProbeNumber>(along, probe.numerator));
    };
    return {coordinate(offset.x, d.x), coordinate(offset.y, d.y)};
  }

  std::vector<Vec<Coord>> sites_;
  std::vector<SiteId> next_;
};

}  // namespace minksum
