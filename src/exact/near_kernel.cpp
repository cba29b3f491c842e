#include "exact/near_kernel.hpp"

#include <initializer_list>

namespace minksum {
namespace {

Vec<Scaled> operator+(const Vec<Scaled>& a, const Vec<Scaled>& b) { return {a.x + b.x, a.y + b.y}; }
Vec<Scaled> operator-(const Vec<Scaled>& a, const Vec<Scaled>& b) { return {a.x - b.x, a.y - b.y}; }

SumVertex start(const Segment& s) { return sum_vertex(s.edge, s.vertex); }

/// Rounds a fraction, and keeps its size apart.
Scaled rounded(const Fraction& value) {
  if (sign_of(value) == kZero) return {};
  const int exponent = static_cast<int>(bit_length(value.numerator())) -
                       static_cast<int>(bit_length(value.denominator()));
  const double nearest = to_double(value, -exponent);
  return {{nearest, std::abs(nearest) * Bounded::kRounding + Bounded::kTiny}, exponent};
}

}  // namespace

void NearKernel::load(std::span<const Vec<Fraction>> sites, SiteId split,
                      const std::array<Vec<Fraction>, 2>& origins, std::uint64_t work,
                      Cancellation& cancellation) {
  exact_ = sites;
  sites_.clear();
  sites_.reserve(sites.size());
  for (SiteId i = 0; i < sites.size(); ++i) {
    cancellation.check(work);
    const Vec<Fraction>& origin = origins[i < split ? 0 : 1];
    sites_.push_back({rounded(sites[i].x - origin.x), rounded(sites[i].y - origin.y)});
  }
}

Vec<double> NearKernel::position(SiteId site, int exponent) const {
  const auto at = [exponent](const Scaled& s) {
    return std::ldexp(s.bounded.value, s.exponent + exponent);
  };
  return {at(sites_[site].x), at(sites_[site].y)};
}

Vec<Scaled> NearKernel::difference(SiteId from, SiteId to) const {
  Vec<Scaled> result = sites_[to] - sites_[from];
  const auto are_equal = [](const Fraction& a, const Fraction& b) {
    return a.numerator() == b.numerator() && a.denominator() == b.denominator();
  };
  if (result.x.bounded.value == 0 && are_equal(exact_[from].x, exact_[to].x)) result.x = {};
  if (result.y.bounded.value == 0 && are_equal(exact_[from].y, exact_[to].y)) result.y = {};
  return result;
}

Vec<Scaled> NearKernel::edge(SiteId start) const { return difference(start, next_[start]); }

Vec<Scaled> NearKernel::between(const SumVertex& from, const SumVertex& to) const {
  Vec<Scaled> result{};
  if (from.first != to.first) result = difference(from.first, to.first);
  if (from.second != to.second) result = result + difference(from.second, to.second);
  return result;
}

SumVertex NearKernel::near_end(const Segment& s, const SumVertex& v) const {
  const SumVertex first = start(s);
  if (first.first == v.first || first.second == v.second) return first;
  const SumVertex last = end(s);
  return last.first == v.first || last.second == v.second ? last : first;
}

Scaled NearKernel::parameter_from(const SumVertex& from, const Segment& s,
                                  const PointOnSegment& p) const {
  const Vec<Scaled> d = edge(s.edge);
  if (p.is_crossing) {
    const auto [numerator, denominator] =
        crossing_parameter(d, between(from, near_end(p.other, from)), edge(p.other.edge));
    return numerator / denominator;
  }
  const Vec<Scaled> offset = between(from, p.vertex);
  const bool by_x = std::abs(d.x.bounded.value) >= std::abs(d.y.bounded.value);
  return by_x ? offset.x / d.x : offset.y / d.y;
}

Vec<Scaled> NearKernel::between(const SumVertex& from, const NodePoint& node) const {
  if (!node.is_crossing) return between(from, node.vertex);
  const SumVertex base = near_end(node.first, from);
  const Scaled lambda = parameter_from(base, node.first, {true, node.second, {}});
  const Vec<Scaled> d = edge(node.first.edge);
  return between(from, base) + Vec<Scaled>{d.x * lambda, d.y * lambda};
}

std::optional<Sign> NearKernel::orientation(const Segment& s, const SumVertex& v) const {
  return cross(edge(s.edge), between(near_end(s, v), v)).sign();
}

std::optional<Sign> NearKernel::orientation(const Segment& s, const NodePoint& node) const {
  const SumVertex from = near_end(s, node.vertex_or_start());
  return cross(edge(s.edge), between(from, node)).sign();
}

std::optional<Sign> NearKernel::compare(const SumVertex& a, const SumVertex& b, Axis axis) const {
  const Vec<Scaled> difference = between(b, a);
  return (axis == Axis::kX ? difference.x : difference.y).sign();
}

std::optional<Sign> NearKernel::compare(const NodePoint& a, const NodePoint& b, Axis axis) const {
  const SumVertex from = b.vertex_or_start();
  const Vec<Scaled> difference = between(from, a) - between(from, b);
  return (axis == Axis::kX ? difference.x : difference.y).sign();
}

std::optional<Sign> NearKernel::compare_along(const Segment& s, const PointOnSegment& a,
                                              const PointOnSegment& b) const {
  for (const SumVertex& from : {start(s), end(s)}) {
    const auto sign = (parameter_from(from, s, a) - parameter_from(from, s, b)).sign();
    if (sign) return sign;
  }
  return {};
}

std::optional<double> NearKernel::parameter(const Segment& s, const PointOnSegment& p) const {
  const Scaled one{{1, 0}, 0};
  for (const Scaled& lambda :
       {parameter_from(start(s), s, p), one + parameter_from(end(s), s, p)}) {
    const double result = std::ldexp(lambda.bounded.value, lambda.exponent);
    if (std::isnormal(result) && lambda.bounded.error <= std::abs(lambda.bounded.value) * 0x1p-49) {
      return result;
    }
  }
  return {};
}

}  // namespace minksum
