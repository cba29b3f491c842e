#include "minksum/measure.hpp"

#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "measure/common_scale.hpp"
#include "region/rational_access.hpp"
#include "region/region_access.hpp"

namespace minksum {

namespace {

__extension__ using Int128 = __int128;
__extension__ using Uint128 = unsigned __int128;

// A sum of 128-bit terms that cannot overflow: low and high halves apart.
class WideSum {
 public:
  void add(Int128 term) {
    low_ += static_cast<std::uint64_t>(term);
    high_ += static_cast<std::int64_t>(term >> 64);
  }
  [[nodiscard]] BigInt value() const { return (BigInt(high_) << 64) + BigInt(low_); }

 private:
  Uint128 low_ = 0;
  Int128 high_ = 0;
};

// Twice the signed area of a ring of integers below 2^61 in absolute value.
BigInt doubled_area(const std::vector<ScaledPoint>& points, IndexRange ring) {
  if (ring.size() < 3) return 0;
  const ScaledPoint origin = points[ring.front()];
  WideSum sum;
  std::int64_t last_x = 0;
  std::int64_t last_y = 0;
  for (const std::size_t v : ring) {
    const std::int64_t x = points[v].x - origin.x;
    const std::int64_t y = points[v].y - origin.y;
    sum.add(Int128{last_x} * y - Int128{x} * last_y);
    last_x = x;
    last_y = y;
  }
  return sum.value();
}

struct Fraction {
  BigInt numerator;
  BigInt denominator;
};

// Sums in a balanced tree: with many different denominators a running sum would be quadratic.
Fraction sum_of(const std::vector<Fraction>& terms, std::size_t first, std::size_t last) {
  if (last - first == 0) return {0, 1};
  if (last - first == 1) return terms[first];
  const std::size_t middle = first + (last - first) / 2;
  const Fraction a = sum_of(terms, first, middle);
  const Fraction b = sum_of(terms, middle, last);
  if (a.denominator == b.denominator) return {a.numerator + b.numerator, a.denominator};
  return {a.numerator * b.denominator + b.numerator * a.denominator, a.denominator * b.denominator};
}

Rational doubled_area_of_rationals(const Region& region, IndexRange ring) {
  if (ring.size() < 3) return {};
  std::vector<Fraction> terms;
  terms.reserve(ring.size());
  Point from = region.point(ring.front() + ring.size() - 1);
  for (const std::size_t v : ring) {
    Point to = region.point(v);
    const Rational cross = from.x * to.y - to.x * from.y;
    terms.push_back({RationalAccess::numerator(cross), RationalAccess::denominator(cross)});
    from = std::move(to);
  }
  Fraction sum = sum_of(terms, 0, terms.size());
  return RationalAccess::make(std::move(sum.numerator), std::move(sum.denominator));
}

Rational magnitude(Rational value) { return value.sign() < 0 ? -value : value; }

// Neumaier's compensated sum.
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

double approximate_doubled_area(const Region& region, IndexRange ring) {
  if (ring.size() < 3) return 0;
  const double origin_x = region.x(ring.front());
  const double origin_y = region.y(ring.front());
  CompensatedSum sum;
  double last_x = 0;
  double last_y = 0;
  for (const std::size_t v : ring) {
    const double x = region.x(v) - origin_x;
    const double y = region.y(v) - origin_y;
    sum.add(last_x * y);
    sum.add(-(x * last_y));
    last_x = x;
    last_y = y;
  }
  return std::abs(sum.value());
}

template <typename Better>
bool better_exactly(const Region& region, const StoredCoordinate& a, const StoredCoordinate& b,
                    Better better) {
  const bool same_unit = a.denominator_limbs == 0 && b.denominator_limbs == 0 && a.exp2 == b.exp2 &&
                         a.exp10 == b.exp10;
  if (same_unit) return better(a.payload, b.payload);
  return better(RegionAccess::exact(region, a), RegionAccess::exact(region, b));
}

// The extreme coordinate by exact comparison; the nearest doubles decide unless they are equal.
template <typename Get, typename Better>
Rational extreme(const Region& region, Get get, Better better) {
  std::size_t best = 0;
  double best_double = RegionAccess::nearest(region, get(region, 0));
  for (std::size_t v = 1; v < region.vertex_count(); ++v) {
    const double candidate = RegionAccess::nearest(region, get(region, v));
    if (better(best_double, candidate)) continue;
    if (candidate == best_double &&
        !better_exactly(region, get(region, v), get(region, best), better)) {
      continue;
    }
    best = v;
    best_double = candidate;
  }
  return RegionAccess::exact(region, get(region, best));
}

}  // namespace

Rational area(const Region& region) {
  CommonScale scale;
  const bool integral = find_common_scale(region, scale);
  const auto of_ring = [&](std::size_t ring) {
    const IndexRange vertices = region.vertices_of(ring);
    if (!integral) return magnitude(doubled_area_of_rationals(region, vertices));
    return magnitude(RationalAccess::make_reduced(doubled_area(scale.points, vertices), 1));
  };
  Rational doubled;
  for (const std::size_t polygon : region.polygons()) {
    bool outer = true;
    for (const std::size_t ring : region.rings_of(polygon)) {
      doubled = outer ? doubled + of_ring(ring) : doubled - of_ring(ring);
      outer = false;
    }
  }
  if (integral) doubled = doubled * scale.unit * scale.unit;
  return doubled / Rational(2);
}

double approximate_area(const Region& region) {
  CompensatedSum doubled;
  for (const std::size_t polygon : region.polygons()) {
    bool outer = true;
    for (const std::size_t ring : region.rings_of(polygon)) {
      const double part = approximate_doubled_area(region, region.vertices_of(ring));
      doubled.add(outer ? part : -part);
      outer = false;
    }
  }
  const double result = doubled.value() / 2;
  // Out of the range where the relative error of double arithmetic is what it should be.
  constexpr double kSmallest = 1e-270;
  if (!region.empty() && !(std::isfinite(result) && std::abs(result) > kSmallest)) {
    return area(region).to_double();
  }
  return result;
}

std::optional<Box> bounding_box(const Region& region) {
  if (region.empty()) return std::nullopt;
  Box box;
  box.min.x = extreme(region, RegionAccess::x, std::less<>());
  box.min.y = extreme(region, RegionAccess::y, std::less<>());
  box.max.x = extreme(region, RegionAccess::x, std::greater<>());
  box.max.y = extreme(region, RegionAccess::y, std::greater<>());
  return box;
}

std::size_t coordinate_bits(const Region& region) {
  const std::optional<Box> box = bounding_box(region);
  if (!box) return 0;
  const Rational scale = least_common_denominator(region);
  const Rational width = (box->max.x - box->min.x) * scale;
  const Rational height = (box->max.y - box->min.y) * scale;
  return std::max(bit_length(RationalAccess::numerator(width)),
                  bit_length(RationalAccess::numerator(height)));
}

}  // namespace minksum
