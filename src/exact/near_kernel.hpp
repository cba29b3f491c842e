// Decides with doubles between operands of very different sizes.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "exact/bounded.hpp"
#include "exact/formulas.hpp"
#include "exact/sum_geometry.hpp"
#include "machine/cancellation.hpp"

namespace minksum {

/// A bounded double times a power of two. So no number of a small operand underflows.
struct Scaled {
  Bounded bounded;
  int exponent = 0;

  /// Returns the number as a multiple of 2^to, for `to` that is not smaller.
  [[nodiscard]] Bounded at(int to) const {
    if (to == exponent) return bounded;
    const int drop = to - exponent;
    const double first = power_of_half(drop);
    const double second = power_of_half(drop - std::min(drop, kMostAtOnce));
    return {bounded.value * first * second, bounded.error * first * second + Bounded::kTiny};
  }
  [[nodiscard]] bool is_zero() const { return bounded.value == 0 && bounded.error == 0; }
  [[nodiscard]] std::optional<Sign> sign() const {
    if (bounded.certain()) return bounded.sign();
    return is_zero() ? std::optional(kZero) : std::nullopt;
  }

  friend Scaled operator+(const Scaled& a, const Scaled& b) {
    if (a.is_zero()) return b;
    if (b.is_zero()) return a;
    const int larger = std::max(a.exponent, b.exponent);
    return {a.at(larger) + b.at(larger), larger};
  }
  friend Scaled operator-(const Scaled& a, const Scaled& b) {
    return a + Scaled{{-b.bounded.value, b.bounded.error}, b.exponent};
  }
  friend Scaled operator*(const Scaled& a, const Scaled& b) {
    if (a.is_zero() || b.is_zero()) return {};
    return {a.bounded * b.bounded, a.exponent + b.exponent};
  }
  friend Scaled operator/(const Scaled& a, const Scaled& b) {
    return {a.bounded / b.bounded, a.exponent - b.exponent};
  }

 private:
  static constexpr int kMostAtOnce = 1022;
  /// Returns 2^-exponent, or 2^-1022 if that is less. Before, std::ldexp took 15 % of a sum with an
  /// operand of size 10^150.
  static double power_of_half(int exponent) {
    const int biased = 1023 - std::min(exponent, kMostAtOnce);
    return std::bit_cast<double>(static_cast<std::uint64_t>(biased) << 52);
  }
};

/// Decides as the exact kernel does, or not at all.
///
/// Where one operand is far larger than the other, the rounded sum of two sites has lost what the
/// smaller operand adds. So a difference of two sum vertices is computed here as one difference in
/// each operand. A site's difference from itself is exactly 0, and then the smaller operand counts.
/// So points are measured from the end of a segment that shares a site with them.
class NearKernel {
 public:
  /// Sets the sites. Those before `split` are the first operand's. Each operand's sites are rounded
  /// relative to its origin. `work` is that of one site (see Cancellation). The sites must stay.
  void load(std::span<const Vec<Fraction>> sites, SiteId split,
            const std::array<Vec<Fraction>, 2>& origins, std::uint64_t work,
            Cancellation& cancellation);
  /// Sets the edges: the edge that starts at site i ends at site next[i].
  void connect(std::span<const SiteId> next) { next_.assign(next.begin(), next.end()); }

  /// Returns a site of its operand, as a multiple of 2^-exponent from the operand's origin.
  [[nodiscard]] Vec<double> position(SiteId site, int exponent) const;
  [[nodiscard]] std::optional<Sign> orientation(const Segment& s, const SumVertex& v) const;
  [[nodiscard]] std::optional<Sign> orientation(const Segment& s, const NodePoint& node) const;
  [[nodiscard]] std::optional<Sign> compare(const SumVertex& a, const SumVertex& b,
                                            Axis axis) const;
  [[nodiscard]] std::optional<Sign> compare(const NodePoint& a, const NodePoint& b,
                                            Axis axis) const;
  [[nodiscard]] std::optional<Sign> compare_along(const Segment& s, const PointOnSegment& a,
                                                  const PointOnSegment& b) const;
  /// Returns the position along s with a relative error of at most 2^-48.
  [[nodiscard]] std::optional<double> parameter(const Segment& s, const PointOnSegment& p) const;

 private:
  /// Returns a vector within one operand. Equal coordinates differ by 0 exactly.
  [[nodiscard]] Vec<Scaled> difference(SiteId from, SiteId to) const;
  [[nodiscard]] Vec<Scaled> edge(SiteId start) const;
  /// Returns a vector from one sum vertex to another.
  [[nodiscard]] Vec<Scaled> between(const SumVertex& from, const SumVertex& to) const;
  [[nodiscard]] SumVertex end(const Segment& s) const {
    return sum_vertex(next_[s.edge], s.vertex);
  }
  /// Returns the end of s that shares a site with v, if one does, and the start otherwise.
  [[nodiscard]] SumVertex near_end(const Segment& s, const SumVertex& v) const;
  /// Returns the position along s from an end of s, where the whole of s has length 1.
  [[nodiscard]] Scaled parameter_from(const SumVertex& from, const Segment& s,
                                      const PointOnSegment& p) const;
  /// Returns a vector from a sum vertex to a node.
  [[nodiscard]] Vec<Scaled> between(const SumVertex& from, const NodePoint& node) const;

  std::span<const Vec<Fraction>> exact_;
  std::vector<Vec<Scaled>> sites_;
  std::vector<SiteId> next_;
};

}  // namespace minksum
