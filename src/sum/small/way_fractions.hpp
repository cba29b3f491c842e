// Fractions of the ways of segments, at which other segments cross them.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "exact/formulas.hpp"
#include "exact/wide_int.hpp"
#include "sum/small/small_segments.hpp"

namespace minksum {

/// No segment.
inline constexpr std::uint32_t kNoSegment = ~std::uint32_t{0};

/// How much of a segment's way has been passed: up to the place where the line of another segment
/// crosses it, or where that segment ends, if both are on one line.
template <class Number>
struct WayFraction {
  std::uint32_t by = kNoSegment;  ///< the other segment; none at the start
  /// The fraction is within `error` of `near`.
  double near = 0;
  double error = 0;

  [[nodiscard]] bool is_start() const { return by == kNoSegment; }
};
template <>
struct WayFraction<double> {
  std::uint32_t by = kNoSegment;
  std::int64_t above = 0;
  std::int64_t below = 1;

  [[nodiscard]] bool is_start() const { return by == kNoSegment; }
};

/// Computes such fractions, and compares them.
template <class Number>
class WayFractions {
  static constexpr bool kShort = std::is_same_v<Number, double>;
  static constexpr bool kWide = std::is_same_v<Number, WideNumber>;

 public:
  WayFractions(const SmallNumbers<Number>& numbers, const SmallSegments& segments)
      : numbers_(numbers), s_(segments) {}

  /// Whether a segment starts at a point, which start(lanes) returns, and which is about `near`.
  template <class Start>
  [[nodiscard]] bool starts_at(std::uint32_t segment, const Vec<double>& near,
                               const Start& start) const {
    if (std::abs(s_.x[segment] - near.x) > numbers_.reach) return false;
    return compute_surely(numbers_, [&](const auto& lanes) {
      return are_equal(lanes.get(s_.at(), segment), start(lanes));
    });
  }
  /// Positive if a segment turns left into another one.
  [[nodiscard, gnu::always_inline]] double turn(std::uint32_t in, std::uint32_t out) const {
    return decide(
        numbers_, [&](const auto& lanes) __attribute__((always_inline)) {
          return lanes.turn(lanes.get(s_.way(), in), lanes.get(s_.way(), out));
        });
  }
  /// Positive if a segment starts on the left of another one.
  [[nodiscard, gnu::always_inline]] double start_of(std::uint32_t segment, std::uint32_t of) const {
    if (kWide && s_.start[segment] == s_.end[of]) return 0;
    return decide(
        numbers_, [&](const auto& lanes) __attribute__((always_inline)) {
          return lanes.side(lanes.get(s_.way(), of), between(lanes, of, segment));
        });
  }
  /// The same for its end. `start` is start_of(segment, of), and `turn` is turn(of, segment).
  [[nodiscard, gnu::always_inline]] double end_of(std::uint32_t segment, std::uint32_t of,
                                                  double start, double turn) const {
    if constexpr (kShort) return start + turn;
    return decide(
        numbers_, [&](const auto& lanes) __attribute__((always_inline)) {
          return lanes.side(lanes.get(s_.way(), of),
                            plus(between(lanes, of, segment), lanes.get(s_.way(), segment)));
        });
  }

  /// Returns what has been passed of a segment where another one turns into it. That one starts
  /// there.
  [[nodiscard, gnu::always_inline]] WayFraction<Number> entry(std::uint32_t segment,
                                                              std::uint32_t from, double start,
                                                              double turn) const {
    if (start == 0) return {};
    if constexpr (kShort) {
      return turn < 0 ? fraction(from, start, -turn) : fraction(from, -start, turn);
    } else {
      return crossing(segment, from);
    }
  }

  /// Returns where another segment crosses a segment. If doubles hold cross products, the other one
  /// must lead to the right.
  [[nodiscard, gnu::always_inline]] WayFraction<Number> crossing(std::uint32_t segment,
                                                                 std::uint32_t by) const {
    const Vec<double> to = minus(s_.at()[by], s_.at()[segment]);
    const Vec<double> in = s_.way()[segment];
    const Vec<double> other = s_.way()[by];
    const double above = cross(to, other);
    const double below = cross(in, other);
    if constexpr (kShort) {
      return fraction(by, -above, -below);
    } else {
      const double near = above / below;
      // Each product, and the difference of two, is rounded by 2^-53 at most, and each vector is
      // off by up to four times that.
      const auto sizes = [](const Vec<double>& a, const Vec<double>& b) {
        return std::abs(a.x * b.y) + std::abs(a.y * b.x);
      };
      const double of_below = 0x1p-49 * sizes(in, other);
      const double of_above = kWide ? numbers_.reach * (std::abs(other.x) + std::abs(other.y))
                                    : 0x1p-50 * sizes(to, other);
      const double least = std::abs(below) - of_below;
      const double error = (of_above + std::abs(near) * of_below) / least + kRounding;
      return {by, near, least > 0 ? error : HUGE_VAL};
    }
  }

  /// Returns where the end of `from` is on a segment of the same line, if this leads on from there,
  /// and nothing otherwise.
  [[nodiscard, gnu::noinline]] std::optional<WayFraction<Number>> straight_on(
      std::uint32_t segment, std::uint32_t from) const {
    // Places are taken along the axis that the line is closer to.
    const bool by_x = std::abs(s_.dx[segment]) >= std::abs(s_.dy[segment]);
    using Result = std::optional<WayFraction<Number>>;
    return compute_surely(numbers_, [&](const auto& lanes) -> Result {
      const auto get = [&](const auto& row, std::uint32_t i) {
        const auto vector = lanes.get(row, i);
        return by_x ? as_signed(vector).x : as_signed(vector).y;
      };
      const auto whole = get(s_.way(), segment);
      const auto other = get(s_.way(), from);
      const auto along = get(s_.at(), from) + other - get(s_.at(), segment);
      const decltype(whole) zero(0);
      const bool leads_on = whole < zero ? other < zero && along <= zero && along > whole
                                         : other > zero && along >= zero && along < whole;
      if (!leads_on) return std::nullopt;
      if (along == zero) return WayFraction<Number>{};
      if constexpr (kShort) {
        return whole < 0 ? fraction(from, -along, -whole) : fraction(from, along, whole);
      } else {
        return WayFraction<Number>{from, to_double(along) / to_double(whole), kRounding};
      }
    });
  }

  /// Compares two fractions of a segment, which are not 0.
  [[nodiscard, gnu::always_inline]] bool less(std::uint32_t segment, const WayFraction<Number>& a,
                                              const WayFraction<Number>& b) const {
    if constexpr (kShort) {
      return product<Int128>(a.above, b.below) < product<Int128>(b.above, a.below);
    } else {
      const double gap = b.near - a.near;
      if (std::abs(gap) > a.error + b.error) return gap > 0;
      return is_less_exactly(segment, a.by, b.by);
    }
  }

  /// Returns a fraction that is not 0, with a positive denominator.
  template <class Lanes>
  [[nodiscard, gnu::noinline]] auto exact(const Lanes& lanes, std::uint32_t segment,
                                          std::uint32_t by) const {
    const auto way = as_integers(lanes.get(s_.way(), segment));
    const auto other = as_integers(lanes.get(s_.way(), by));
    const auto to = as_integers(between(lanes, segment, by));
    using Coordinate = std::decay_t<decltype(way.x)>;
    using Integer = std::conditional_t<kShort, std::int64_t, ProductOf<Coordinate>>;
    Integer below = exact_cross<Integer>(way, other);
    Integer above = exact_cross<Integer>(to, other);
    if (below == Integer(0)) {
      // Places are taken along an axis.
      const bool by_x = !(way.x == Coordinate(0));
      below = Integer(by_x ? way.x : way.y);
      above = Integer(by_x ? to.x + other.x : to.y + other.y);
    }
    if (below < Integer(0)) return Quotient<Integer>{-above, -below};
    return Quotient<Integer>{above, below};
  }
  /// Returns a fraction, off by less than 2^-46.
  [[nodiscard, gnu::noinline]] double rounded(std::uint32_t segment,
                                              const WayFraction<Number>& at) const {
    if (at.is_start()) return 0;
    if constexpr (!kShort) {
      if (at.error < 0x1p-46) return at.near;
    }
    return compute_surely(numbers_, [&](const auto& lanes) {
      const auto part = exact(lanes, segment, at.by);
      return to_double(part.numerator) / to_double(part.denominator);
    });
  }

 private:
  /// More than numbers up to 1 are rounded by when they are divided.
  static constexpr double kRounding = 0x1p-49;
  [[nodiscard]] static WayFraction<Number> fraction(std::uint32_t by, double above, double below) {
    return {by, static_cast<std::int64_t>(above), static_cast<std::int64_t>(below)};
  }
  [[nodiscard, gnu::noinline]] bool is_less_exactly(std::uint32_t segment, std::uint32_t a,
                                                    std::uint32_t b) const {
    return compute_surely(numbers_, [&](const auto& lanes) {
      const auto p = exact(lanes, segment, a);
      const auto q = exact(lanes, segment, b);
      using Wide = ProductOf<std::decay_t<decltype(p.numerator)>>;
      return product<Wide>(p.numerator, q.denominator) < product<Wide>(q.numerator, p.denominator);
    });
  }

  template <class Lanes>
  [[nodiscard, gnu::always_inline]] auto between(const Lanes& lanes, std::uint32_t from,
                                                 std::uint32_t to) const {
    return minus(lanes.get(s_.at(), to), lanes.get(s_.at(), from));
  }

  SmallNumbers<Number> numbers_;
  const SmallSegments& s_;
};

}  // namespace minksum
