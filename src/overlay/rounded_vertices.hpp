// Answers questions about a region by doubles, where these are certain.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstddef>
#include <optional>
#include <vector>

#include "exact/formulas.hpp"
#include "exact/sign.hpp"
#include "machine/cancellation.hpp"
#include "region/region_access.hpp"

namespace minksum {

/// A box in doubles.
struct ErrorBounds {
  double x0 = HUGE_VAL;
  double y0 = HUGE_VAL;
  double x1 = -HUGE_VAL;
  double y1 = -HUGE_VAL;
  void add(const Vec<double>& p) {
    x0 = std::min(x0, p.x);
    y0 = std::min(y0, p.y);
    x1 = std::max(x1, p.x);
    y1 = std::max(y1, p.y);
  }
};

/// Holds doubles of a region's vertices, each coordinate off by less than `error`, and decides by
/// them.
class ApproximatePoints {
 public:
  ApproximatePoints(const Region& region, Cancellation& cancellation)
      : region_(region), cancellation_(cancellation) {
    at_.resize(region.vertex_count());
    for (std::size_t v = 0; v < at_.size(); ++v) {
      cancellation.check(work_of_product(RegionAccess::bits(region, v)));
      at_[v] = {region.x(v), region.y(v)};
      bounds_.add(at_[v]);
    }
    const double largest = std::max({-bounds_.x0, -bounds_.y0, bounds_.x1, bounds_.y1, 0x1p-900});
    error_ = largest * 0x1p-52;
  }
  /// Tells whether products of two differences neither overflow nor vanish.
  [[nodiscard]] bool usable() const { return error_ > 0x1p-400 && error_ < 0x1p400; }
  [[nodiscard]] const Vec<double>& operator[](std::size_t v) const { return at_[v]; }
  [[nodiscard]] const ErrorBounds& bounds() const { return bounds_; }
  [[nodiscard]] double error() const { return error_; }

  /// Returns the side of the line from a to b on which p certainly lies, or zero if none is
  /// certain.
  [[nodiscard]] Sign side(const Vec<double>& a, const Vec<double>& b, const Vec<double>& p) const {
    const Vec<double> d{b.x - a.x, b.y - a.y};
    const Vec<double> q{p.x - a.x, p.y - a.y};
    // Differences are off by less than 3 errors. The rounding of products is less than that, too.
    const double bound =
        8 * error_ * (std::abs(d.x) + std::abs(d.y) + std::abs(q.x) + std::abs(q.y) + error_);
    const double value = cross(d, q);
    if (value > bound) return kPositive;
    return value < -bound ? kNegative : kZero;
  }
  /// Tells whether the segments from a to b and from c to d are certainly apart.
  [[nodiscard]] bool apart(std::size_t a, std::size_t b, std::size_t c, std::size_t d) const {
    const auto gap = [this](double a0, double a1, double b0, double b1) {
      return std::max(a0, a1) + 2 * error_ < std::min(b0, b1);
    };
    const auto& [pa, pb, pc, pd] = std::array{at_[a], at_[b], at_[c], at_[d]};
    if (gap(pa.x, pb.x, pc.x, pd.x) || gap(pc.x, pd.x, pa.x, pb.x) || gap(pa.y, pb.y, pc.y, pd.y) ||
        gap(pc.y, pd.y, pa.y, pb.y)) {
      return true;
    }
    return side(pa, pb, pc) * side(pa, pb, pd) == kPositive ||
           side(pc, pd, pa) * side(pc, pd, pb) == kPositive;
  }
  /// Tells whether a vertex is inside a ring that does not touch it. Returns nothing if that is not
  /// certain.
  [[nodiscard]] std::optional<bool> is_inside(std::size_t vertex, const IndexRange& ring) const {
    bool inside = false;
    std::size_t from = ring.front() + ring.size() - 1;
    bool from_above = is_above(from, vertex);
    for (const std::size_t to : ring) {
      cancellation_.check();
      const bool to_above = is_above(to, vertex);
      if (from_above != to_above) {
        const Sign sign = side(at_[from], at_[to], at_[vertex]);
        if (sign == kZero) return std::nullopt;
        if ((sign == kPositive) == to_above) inside = !inside;
      }
      from = to;
      from_above = to_above;
    }
    return inside;
  }

  /// Tells exactly whether v comes before w by x, then by y.
  [[nodiscard]] bool is_before(std::size_t v, std::size_t w) const {
    const double difference = at_[v].x - at_[w].x;
    if (std::abs(difference) > 2 * error_) return difference < 0;
    cancellation_.check(work_of_product(RegionAccess::bits(region_, v)));
    const auto by_x =
        RegionAccess::compare(region_, RegionAccess::x(region_, v), RegionAccess::x(region_, w));
    return by_x != 0 ? by_x < 0 : compare_y(v, w) < 0;
  }

 private:
  [[nodiscard]] std::strong_ordering compare_y(std::size_t v, std::size_t w) const {
    const double difference = at_[v].y - at_[w].y;
    if (std::abs(difference) > 2 * error_) {
      return difference < 0 ? std::strong_ordering::less : std::strong_ordering::greater;
    }
    cancellation_.check(work_of_product(RegionAccess::bits(region_, v)));
    return RegionAccess::compare(region_, RegionAccess::y(region_, v), RegionAccess::y(region_, w));
  }
  [[nodiscard]] bool is_above(std::size_t v, std::size_t other) const {
    return compare_y(v, other) > 0;
  }

  const Region& region_;
  Cancellation& cancellation_;
  std::vector<Vec<double>> at_;
  ErrorBounds bounds_;
  double error_ = 0;
};

}  // namespace minksum
