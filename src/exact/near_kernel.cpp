#include "exact/near_kernel.hpp"

#include <algorithm>
#include <initializer_list>
#include <limits>

namespace minksum {
namespace {

Vec<Scaled> operator+(const Vec<Scaled>& a, const Vec<Scaled>& b) { return {a.x + b.x, a.y + b.y}; }
Vec<Scaled> operator-(const Vec<Scaled>& a, const Vec<Scaled>& b) { return {a.x - b.x, a.y - b.y}; }

SumVertex start(const Segment& s) { return sum_vertex(s.edge, s.vertex); }

Vec<Fraction> difference(const Vec<Fraction>& a, const Vec<Fraction>& b) {
  return {a.x - b.x, a.y - b.y};
}

/// Returns e for a value of about 2^e.
int log2_of(const Fraction& value) {
  if (sign_of(value) == kZero) return std::numeric_limits<int>::min();
  return static_cast<int>(bit_length(value.numerator())) -
         static_cast<int>(bit_length(value.denominator()));
}

}  // namespace

void NearKernel::load(std::span<const Vec<Fraction>> sites, SiteId split,
                      const std::array<Vec<Fraction>, 2>& origins) {
  split_ = split;
  sites_.clear();
  edges_.clear();
  exponents_ = {std::numeric_limits<int>::min(), std::numeric_limits<int>::min()};
  std::vector<Vec<Fraction>> moved;
  moved.reserve(sites.size());
  for (SiteId i = 0; i < sites.size(); ++i) {
    const std::size_t operand = operand_of(i);
    moved.push_back(difference(sites[i], origins[operand]));
    exponents_[operand] =
        std::max({exponents_[operand], log2_of(moved.back().x), log2_of(moved.back().y)});
  }
  for (int& exponent : exponents_) {
    if (exponent == std::numeric_limits<int>::min()) exponent = 0;
  }
  sites_.reserve(sites.size());
  for (SiteId i = 0; i < sites.size(); ++i) {
    sites_.push_back({rounded(moved[i].x, operand_of(i)), rounded(moved[i].y, operand_of(i))});
  }
}

void NearKernel::connect(std::span<const Vec<Fraction>> sites, std::span<const SiteId> next) {
  next_.assign(next.begin(), next.end());
  edges_.clear();
  edges_.reserve(next.size());
  for (SiteId i = 0; i < next.size(); ++i) {
    const Vec<Fraction> d = difference(sites[next[i]], sites[i]);
    edges_.push_back({rounded(d.x, operand_of(i)), rounded(d.y, operand_of(i))});
  }
}

Scaled NearKernel::rounded(const Fraction& value, std::size_t operand) const {
  if (sign_of(value) == kZero) return {};
  const double nearest = to_double(value, -exponents_[operand]);
  return {{nearest, std::abs(nearest) * Bounded::kRounding + Bounded::kTiny}, exponents_[operand]};
}

Vec<Scaled> NearKernel::between(const SumVertex& from, const SumVertex& to) const {
  Vec<Scaled> result{};
  if (from.first != to.first) result = sites_[to.first] - sites_[from.first];
  if (from.second != to.second) result = result + (sites_[to.second] - sites_[from.second]);
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
  const Vec<Scaled>& d = edges_[s.edge];
  if (p.is_crossing) {
    const auto [numerator, denominator] =
        crossing_parameter(d, between(from, near_end(p.other, from)), edges_[p.other.edge]);
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
  const Vec<Scaled>& d = edges_[node.first.edge];
  return between(from, base) + Vec<Scaled>{d.x * lambda, d.y * lambda};
}

std::optional<Sign> NearKernel::orientation(const Segment& s, const SumVertex& v) const {
  return cross(edges_[s.edge], between(near_end(s, v), v)).sign();
}

std::optional<Sign> NearKernel::orientation(const Segment& s, const NodePoint& node) const {
  const SumVertex from = near_end(s, node.vertex_or_start());
  return cross(edges_[s.edge], between(from, node)).sign();
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
