#include "minksum/measure.hpp"

#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "exact/gcd.hpp"
#include "machine/cancellation.hpp"
#include "region/denominators.hpp"
#include "region/fraction_sum.hpp"
#include "region/grid_scale.hpp"
#include "region/rational_access.hpp"

namespace minksum {

namespace {

// Puts all coordinates on one grid, as integers below 2^62. Returns false if there is no such grid.
bool find_grid(const Region& region, Cancellation& cancellation, GridCoordinates& grid) {
  const std::optional<Scale> scale =
      scale_of_stored([&](auto visit) { for_each_coordinate(region, cancellation, visit); });
  if (!scale || scale->bits >= GridCoordinates::kSmallBits) return false;
  const auto on = [&](const StoredCoordinate& c) {
    return on_grid<std::int64_t>(c.payload, c.exp2, c.exp10, *scale);
  };
  const auto at = [&](std::size_t v) {
    return Vec<std::int64_t>{on(RegionAccess::x(region, v)), on(RegionAccess::y(region, v))};
  };
  load_grid(region.vertex_count(), *scale, at, cancellation, grid.small_sites, grid);
  return true;
}

// Returns twice the signed area of a ring of integers below 2^62.
BigInteger doubled_area(const std::vector<Vec<std::int64_t>>& points, IndexRange ring,
                        Cancellation& cancellation) {
  if (ring.size() < 3) return 0;
  const Vec<std::int64_t> origin = points[ring.front()];
  WideInt<3> sum;
  std::int64_t last_x = 0;
  std::int64_t last_y = 0;
  for (const std::size_t v : ring) {
    cancellation.check();
    const std::int64_t x = points[v].x - origin.x;
    const std::int64_t y = points[v].y - origin.y;
    sum = sum + WideInt<3>(Int128{last_x} * y - Int128{x} * last_y);
    last_x = x;
    last_y = y;
  }
  return BigInteger(sum);
}

// Bits of the longest common denominator. Beyond it, each vertex uses a denominator of its own.
constexpr std::size_t kLongestShared = 4096;

// The vertex (x / divisor, y / divisor).
struct Quotients {
  BigInteger x;
  BigInteger y;
  BigInteger divisor;
};

Quotients quotients_of(const Point& point, const BigInteger* shared) {
  const BigInteger& below_x = RationalAccess::denominator(point.x);
  const BigInteger& below_y = RationalAccess::denominator(point.y);
  BigInteger divisor = shared ? *shared : least_common_multiple(below_x, below_y);
  return {RationalAccess::numerator(point.x) * (divisor / below_x),
          RationalAccess::numerator(point.y) * (divisor / below_y), std::move(divisor)};
}

// Returns the area for coordinates that have no short common denominator.
Rational area_of_rationals(const Region& region, Cancellation& cancellation) {
  std::vector<Quotients> vertices;
  std::vector<BigInteger> divisors;
  // Doubles and decimals have few denominators, and one number is a multiple of them all.
  const BigInteger finite = finite_denominator(region, cancellation);
  const bool is_short = bit_length(finite) <= kLongestShared;
  for (std::size_t v = 0; v < region.vertex_count(); ++v) {
    const bool is_finite = RegionAccess::x(region, v).denominator_limbs == 0 &&
                           RegionAccess::y(region, v).denominator_limbs == 0;
    const BigInteger* const shared = is_short && is_finite ? &finite : nullptr;
    const Point point = region.point(v);
    cancellation.check(4 * work_of(point));
    divisors.push_back(vertices.emplace_back(quotients_of(point, shared)).divisor);
  }
  const FractionSum fractions(std::move(divisors), cancellation);
  std::vector<FractionSum::Term> rings;
  std::vector<FractionSum::Term> crosses;
  for (const std::size_t polygon : region.polygons()) {
    int sign = 1;
    for (const std::size_t ring : region.rings_of(polygon)) {
      const IndexRange range = region.vertices_of(ring);
      crosses.clear();
      for (const std::size_t v : range) {
        const std::size_t before = v == range.front() ? range.front() + range.size() - 1 : v - 1;
        const Quotients& a = vertices[before];
        const Quotients& b = vertices[v];
        cancellation.check(4 * work_of_product(bit_length(b.x)));
        crosses.push_back(fractions.term(a.x * b.y - b.x * a.y, a.divisor, b.divisor));
      }
      rings.push_back(fractions.sum(crosses));
      rings.back().numerator *= sign * rings.back().numerator.sign();
      sign = -1;
    }
  }
  return fractions.half(fractions.sum(rings));
}

// Implements Neumaier's compensated sum.
class CompensatedSum {
 public:
  void add(double term) {
    const double next = sum_ + term;
    lost_ += std::abs(sum_) >= std::abs(term) ? (sum_ - next) + term : (term - next) + sum_;
    sum_ = next;
  }
  [[nodiscard]] double value() const { return sum_ + lost_; }

 private:
  double sum_ = 0;
  double lost_ = 0;
};

// An area in doubles, and a bound on what rounded coordinates add to its error.
struct DoubleArea {
  double value = 0;
  double error = 0;
};

// Coordinates are seen from the first vertex. That difference is rounded, or both coordinates are.
DoubleArea approximate_doubled_area(const Region& region, IndexRange ring, bool rounds_difference,
                                    Cancellation& cancellation) {
  if (ring.size() < 3) return {};
  const std::size_t origin = ring.front();
  CompensatedSum sum;
  double length = 0;
  double farthest = 0;
  double last_x = 0;
  double last_y = 0;
  for (const std::size_t v : ring) {
    cancellation.check(work_of_product(RegionAccess::bits(region, v)));
    double x = region.x(v) - region.x(origin);
    double y = region.y(v) - region.y(origin);
    if (rounds_difference) {
      x = (region.exact_x(v) - region.exact_x(origin)).to_double();
      y = (region.exact_y(v) - region.exact_y(origin)).to_double();
    }
    sum.add(last_x * y);
    sum.add(-(x * last_y));
    length += std::abs(x - last_x) + std::abs(y - last_y);
    farthest = std::max({farthest, std::abs(region.x(v)), std::abs(region.y(v))});
    last_x = x;
    last_y = y;
  }
  return {std::abs(sum.value()), rounds_difference ? 0 : 0x1p-51 * farthest * length};
}

// Returns the extreme coordinate. The nearest doubles decide, and exact comparison where they are
// equal.
template <typename Get, typename Better>
Rational extreme(const Region& region, Get get, Better better, Cancellation& cancellation) {
  std::size_t best = 0;
  double best_double = RegionAccess::nearest(region, get(region, 0));
  for (std::size_t v = 1; v < region.vertex_count(); ++v) {
    cancellation.check(work_of_product(RegionAccess::bits(region, v)));
    const double candidate = RegionAccess::nearest(region, get(region, v));
    if (better(best_double, candidate)) continue;
    if (candidate == best_double) {
      const auto order = RegionAccess::compare(region, get(region, v), get(region, best));
      if (!better(order < 0 ? -1 : order > 0, 0)) continue;
    }
    best = v;
    best_double = candidate;
  }
  return RegionAccess::exact(region, get(region, best));
}

}  // namespace

Rational area(const Region& region, const Options& options) {
  Cancellation cancellation(options);
  GridCoordinates grid;
  if (!find_grid(region, cancellation, grid)) return area_of_rationals(region, cancellation);
  BigInteger doubled;
  for (const std::size_t polygon : region.polygons()) {
    bool outer = true;
    for (const std::size_t ring : region.rings_of(polygon)) {
      const BigInteger of_ring =
          abs(doubled_area(grid.small_sites, region.vertices_of(ring), cancellation));
      doubled += outer ? of_ring : -of_ring;
      outer = false;
    }
  }
  return RationalAccess::make(std::move(doubled), 2, 2 * grid.unit.exp2, 2 * grid.unit.exp10);
}

double approximate_area(const Region& region, const Options& options) {
  Cancellation cancellation(options);
  for (const bool rounds_difference : {false, true}) {
    CompensatedSum doubled;
    double error = 0;
    for (const std::size_t polygon : region.polygons()) {
      bool outer = true;
      for (const std::size_t ring : region.rings_of(polygon)) {
        const DoubleArea part = approximate_doubled_area(region, region.vertices_of(ring),
                                                         rounds_difference, cancellation);
        doubled.add(outer ? part.value : -part.value);
        error += part.error;
        outer = false;
      }
    }
    const double result = doubled.value() / 2;
    // Outside this range, the relative error of double arithmetic may be larger than it should be.
    constexpr double kSmallest = 1e-270;
    if (!region.empty() && !(std::isfinite(result) && std::abs(result) > kSmallest)) break;
    constexpr double kMostError = 1e-9;  // what the interface promises
    if (error <= kMostError * std::abs(result)) return result;
  }
  return area(region, options).to_double();
}

std::optional<Box> bounding_box(const Region& region, const Options& options) {
  Cancellation cancellation(options);
  if (region.empty()) return std::nullopt;
  Box box;
  box.min.x = extreme(region, RegionAccess::x, std::less<>(), cancellation);
  box.min.y = extreme(region, RegionAccess::y, std::less<>(), cancellation);
  box.max.x = extreme(region, RegionAccess::x, std::greater<>(), cancellation);
  box.max.y = extreme(region, RegionAccess::y, std::greater<>(), cancellation);
  return box;
}

std::size_t coordinate_bits(const Region& region, const Options& options) {
  const std::optional<Box> box = bounding_box(region, options);
  if (!box) return 0;
  Cancellation cancellation(options);
  const BigInteger scale = least_common_denominator(region, cancellation);
  // Times `scale`, both sides are integers. With k as below, 2^(k-1) < a / b < 2^(k+1), so no long
  // division is needed.
  const auto scaled_bits = [&](const Rational& side) -> std::size_t {
    cancellation.look();
    if (side.sign() == 0) return 0;
    const BigInteger above = RationalAccess::numerator(side) * scale;
    const BigInteger& below = RationalAccess::denominator(side);
    const std::size_t k = bit_length(above) - bit_length(below);
    return above >= below << static_cast<std::int64_t>(k) ? k + 1 : k;
  };
  return std::max(scaled_bits(box->max.x - box->min.x), scaled_bits(box->max.y - box->min.y));
}

}  // namespace minksum
