// Writes each exact formula of the overlay once, over the number types of any rung.
#pragma once

#include <type_traits>
#include <utility>
#include <vector>

#include "exact/big_integer.hpp"
#include "exact/bit_budget.hpp"
#include "exact/formulas.hpp"
#include "exact/gcd.hpp"
#include "exact/wide_int.hpp"
#include "overlay/exact_points.hpp"
#include "region/rational_access.hpp"

namespace minksum::overlay {

// Magnitudes have these bits, if coordinates have B bits, are not negative, and W is 1:
//   a line's direction (A, B)    B              its C                2B
//   a crossing's W               2B + 1         its X, Y             3B + 1
//   line · point                 2B + 2         line · crossing      4B + 3
//   X₁·W₂ − X₂·W₁                5B + 3         sum of 2^32 C        2B + 32
template <class Fixed, class VolumeType>
struct FixedNumbers {
  static constexpr int kBits = Fixed::kCoordinateBits;
  using Length = typename Fixed::Coord;         // coordinates and A, B
  using Area = typename Fixed::Cross;           // C, W and line · point
  using Volume = VolumeType;                    // X, Y of a crossing
  using Side = typename Fixed::Along;           // line · crossing
  using Order = typename Fixed::Lexicographic;  // X₁·W₂ − X₂·W₁
  using AreaSum = typename Fixed::ProbeNumber;
  static_assert(kBits + 1 < Bits<Length>::value && 2 * kBits + 2 < Bits<Area>::value &&
                3 * kBits + 1 < Bits<Volume>::value && 4 * kBits + 3 < Bits<Side>::value &&
                5 * kBits + 3 < Bits<Order>::value && 2 * kBits + 33 < Bits<AreaSum>::value);
};
using NarrowNumbers = FixedNumbers<NarrowRung, Int128>;
using MediumNumbers = FixedNumbers<MediumRung, WideInt<3>>;
using WideNumbers = FixedNumbers<WideRung, WideInt<6>>;
struct ArbitraryNumbers {
  using Length = BigInteger;
  using Area = BigInteger;
  using Volume = BigInteger;
  using Side = BigInteger;
  using Order = BigInteger;
};

/// Relates the rung's own coordinates to the given ones: given = (own + offset)·2^exp2·10^exp10.
struct Frame {
  BigInteger offset_x = 0;
  BigInteger offset_y = 0;
  int exp2 = 0;
  int exp10 = 0;
  /// Scales approximations, so that they neither overflow nor underflow needlessly.
  int approximate_exp2 = 0;
};

template <class Numbers>
class ExactPointsOf final : public ExactPoints {
  static constexpr bool kHomogeneous = std::is_same_v<Numbers, ArbitraryNumbers>;
  using Length = typename Numbers::Length;
  using Area = typename Numbers::Area;
  using Volume = typename Numbers::Volume;
  using Side = typename Numbers::Side;
  using Order = typename Numbers::Order;

 public:
  using Own = Vec<Length>;
  /// `weights` are the W of points on the rung of any size. On other rungs it is empty.
  ExactPointsOf(std::vector<Own> points, std::vector<Length> weights, Frame frame)
      : points_(std::move(points)), weights_(std::move(weights)), frame_(std::move(frame)) {}

  void pick(std::span<const PointId> points) override {
    points_ = picked(points_, points);
    if constexpr (kHomogeneous) weights_ = picked(weights_, points);
  }

  [[nodiscard]] Sign compare(PointId a, PointId b) const override {
    if constexpr (kHomogeneous) {
      return compare(ExactLocation::of_point(a), ExactLocation::of_point(b));
    } else {
      const Own& p = points_[a];
      const Own& q = points_[b];
      if (p.x != q.x) return p.x < q.x ? kNegative : kPositive;
      return p.y == q.y ? kZero : p.y < q.y ? kNegative : kPositive;
    }
  }
  [[nodiscard]] Sign compare(const ExactLocation& a, const ExactLocation& b) const override {
    const Homogeneous p = homogeneous(a);
    const Homogeneous q = homogeneous(b);
    const Sign by_x = compare(p.x, p.w, q.x, q.w);
    return by_x != kZero ? by_x : compare(p.y, p.w, q.y, q.w);
  }
  [[nodiscard]] Sign orientation(const Ends& line, PointId point) const override {
    const Coefficients l = line_of(line);
    const Own& p = points_[point];
    Area sum = widen<Area>(l.a) * widen<Area>(p.x) + widen<Area>(l.b) * widen<Area>(p.y);
    if constexpr (kHomogeneous) {
      sum = sum + l.c * weights_[point];
    } else {
      sum = sum + l.c;
    }
    return sign_of(sum);
  }
  [[nodiscard]] Sign orientation(const Ends& line, const ExactLocation& place) const override {
    if (!place.is_crossing) return orientation(line, place.point());
    const Coefficients l = line_of(line);
    const Homogeneous p = homogeneous(place);
    const Side sum = widen<Side>(l.a) * widen<Side>(p.x) + widen<Side>(l.b) * widen<Side>(p.y) +
                     widen<Side>(l.c) * widen<Side>(p.w);
    return sign_of(sum);
  }
  [[nodiscard]] Sign cross(const Ends& s, const Ends& t) const override {
    const Coefficients l = line_of(s);
    const Coefficients m = line_of(t);
    return sign_of(Area(widen<Area>(l.a) * widen<Area>(m.b) - widen<Area>(l.b) * widen<Area>(m.a)));
  }
  [[nodiscard]] Sign area_sign(std::span<const PointId> ring) const override {
    if constexpr (kHomogeneous) {
      const Quotient sum = doubled_area(ring, 0, ring.size());
      return sign_of(sum.numerator);
    } else {
      using Sum = typename Numbers::AreaSum;
      Sum sum(0);
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Coefficients side = line_of({ring[i], ring[i + 1 == ring.size() ? 0 : i + 1]});
        sum = sum + widen<Sum>(side.c);
      }
      return sign_of(sum);
    }
  }

  [[nodiscard]] Line line(const Ends& ends) const override {
    const Coefficients l = line_of(ends);
    Line line{BigInteger(l.a), BigInteger(l.b), BigInteger(l.c)};
    // a and b are not both 0.
    const BigInteger divisor =
        greatest_common_divisor(greatest_common_divisor(line[0], line[1]), line[2]);
    for (BigInteger& coefficient : line) coefficient /= divisor;
    return line;
  }

  [[nodiscard]] bool on_grid() const override { return !kHomogeneous; }
  [[nodiscard]] Vec<double> approximate(const ExactLocation& place) const override {
    if constexpr (std::is_same_v<Length, std::int64_t>) {
      if (!place.is_crossing) {
        const Own& p = points_[place.point()];
        return {static_cast<double>(p.x), static_cast<double>(p.y)};
      }
    }
    const Homogeneous p = homogeneous(place);
    const BigInteger w(p.w);
    return {nearest_double(BigInteger(p.x), w, frame_.approximate_exp2),
            nearest_double(BigInteger(p.y), w, frame_.approximate_exp2)};
  }
  [[nodiscard]] Point exact(const ExactLocation& place) const override {
    const Homogeneous p = homogeneous(place);
    const BigInteger w(p.w);
    return {given(BigInteger(p.x), w, frame_.offset_x), given(BigInteger(p.y), w, frame_.offset_y)};
  }

 private:
  struct Coefficients {
    Length a;  // direction (b, -a)
    Length b;
    Area c;
  };
  struct Homogeneous {
    Volume x;
    Volume y;
    Area w;
  };

  template <class Value>
  static std::vector<Value> picked(const std::vector<Value>& from,
                                   std::span<const PointId> points) {
    std::vector<Value> result;
    result.reserve(points.size());
    for (const PointId p : points) result.push_back(from[p]);
    return result;
  }

  [[nodiscard]] Coefficients line_of(const Ends& ends) const {
    const Own& p = points_[ends.low];
    const Own& q = points_[ends.high];
    Coefficients line{
        Length(p.y - q.y), Length(q.x - p.x),
        Area(widen<Area>(p.x) * widen<Area>(q.y) - widen<Area>(p.y) * widen<Area>(q.x))};
    if constexpr (kHomogeneous) {
      const Length& v = weights_[ends.low];
      const Length& w = weights_[ends.high];
      line.a = p.y * w - q.y * v;
      line.b = q.x * v - p.x * w;
    }
    return line;
  }
  [[nodiscard]] Homogeneous homogeneous(const ExactLocation& place) const {
    if (!place.is_crossing) {
      const Own& p = points_[place.point()];
      if constexpr (kHomogeneous) {
        return {p.x, p.y, weights_[place.point()]};
      } else {
        return {widen<Volume>(p.x), widen<Volume>(p.y), Area(1)};
      }
    }
    const Coefficients l = line_of(place.first);
    const Coefficients m = line_of(place.second);
    const auto volume = [](const auto& a, const auto& b) {
      return Volume(widen<Volume>(a) * widen<Volume>(b));
    };
    Homogeneous p{Volume(volume(l.b, m.c) - volume(m.b, l.c)),
                  Volume(volume(m.a, l.c) - volume(l.a, m.c)),
                  Area(widen<Area>(l.a) * widen<Area>(m.b) - widen<Area>(l.b) * widen<Area>(m.a))};
    if (sign_of(p.w) == kNegative) p = {Volume(-p.x), Volume(-p.y), Area(-p.w)};
    return p;
  }
  static Sign compare(const Volume& n, const Area& d, const Volume& m, const Area& e) {
    return sign_of(Order(widen<Order>(n) * widen<Order>(e) - widen<Order>(m) * widen<Order>(d)));
  }
  /// Returns the sum of the sides' cross products from `begin` to `end`. Halves are added, so that
  /// denominators of like size are multiplied.
  [[nodiscard]] Quotient<BigInteger> doubled_area(std::span<const PointId> ring, std::size_t begin,
                                                  std::size_t end) const {
    if (end - begin <= 1) {
      if (begin == end) return {0, 1};
      const PointId p = ring[begin];
      const PointId q = ring[end == ring.size() ? 0 : end];
      return {line_of({p, q}).c, weights_[p] * weights_[q]};
    }
    const std::size_t middle = begin + (end - begin) / 2;
    const auto a = doubled_area(ring, begin, middle);
    const auto b = doubled_area(ring, middle, end);
    if (a.denominator == b.denominator) return {a.numerator + b.numerator, a.denominator};
    return {a.numerator * b.denominator + b.numerator * a.denominator,
            a.denominator * b.denominator};
  }
  [[nodiscard]] Rational given(BigInteger numerator, BigInteger denominator,
                               const BigInteger& offset) const {
    numerator += offset * denominator;
    return RationalAccess::make(std::move(numerator), std::move(denominator), frame_.exp2,
                                frame_.exp10);
  }

  std::vector<Own> points_;
  std::vector<Length> weights_;
  Frame frame_;
};

}  // namespace minksum::overlay
