// Cross products in lanes of doubles, whose signs are exact.
#pragma once

#include <cmath>
#include <type_traits>

#include "exact/formulas.hpp"
#include "exact/wide_int.hpp"
#include "sum/small/lanes.hpp"

namespace minksum {

/// Returns an integer that a double holds, in a type that holds its products with others.
template <class Number>
[[nodiscard]] constexpr Number whole_number(double value) {
  if constexpr (std::is_same_v<Number, double>) return value;
  return static_cast<Number>(static_cast<std::int64_t>(value));
}
template <class Number>
[[nodiscard]] constexpr Vec<Number> whole_numbers(const Vec<double>& v) {
  return {whole_number<Number>(v.x), whole_number<Number>(v.y)};
}

/// Cross products of integers, in a type that holds their values and sums of two values.
template <class Number>
struct ExactCross {
  static constexpr bool kHoldsSums = true;
  [[gnu::always_inline]] Number operator()(const Vec<double>& a, const Vec<double>& b) const {
    return cross(whole_numbers<Number>(a), whole_numbers<Number>(b));
  }
};

/// Cross products of integers up to 2^49 in doubles that round them. Rounding keeps the order of
/// two products, so the sign of a value that is not zero is exact. Zero is sure if the products are
/// zero. It is also sure if x of both vectors is the same but for the sign, as where one segment
/// starts at the end of the other: a product that changes with y changes by x at least, and
/// rounding changes it by less than x / 8.
struct RoundedCross {
  static constexpr bool kHoldsSums = false;
  bool& unsure;
  [[gnu::always_inline]] double operator()(const Vec<double>& a, const Vec<double>& b) const {
    const double above = a.x * b.y;
    const double value = above - a.y * b.x;
    unsure |= (value == 0) & (above != 0) & (std::abs(a.x) != std::abs(b.x));
    return value;
  }
};

/// The same, with the exact sign: other zeros are decided by a number type that holds the products.
template <class Number>
struct SureCross {
  static constexpr bool kHoldsSums = false;
  [[gnu::always_inline]] double operator()(const Vec<double>& a, const Vec<double>& b) const {
    bool unsure = false;
    const double value = RoundedCross{unsure}(a, b);
    if (!unsure) return value;
    const Number exact = ExactCross<Number>{}(a, b);
    return exact > 0 ? 1 : exact < 0 ? -1 : 0;
  }
};

/// Returns test(cross, lane) for lanes 0 to count - 1, as a sum of bits. The bits of lane t are
/// kLaneBits · 2^t. A number type that is not `double` holds all cross products where doubles may
/// round them.
template <class Number, LaneBits kLaneBits = 1, class Test>
[[gnu::always_inline]] inline LaneBits test_lanes(std::size_t count, Test test) {
  LaneBits bits = 0;
  if constexpr (std::is_same_v<Number, double>) {
    for (std::size_t t = 0; t < count; ++t) bits |= test(ExactCross<double>{}, t);
    return bits;
  }
  LaneBits unsure = 0;
  for (std::size_t t = 0; t < count; ++t) {
    bool is_unsure = false;
    bits |= test(RoundedCross{is_unsure}, t);
    unsure |= is_unsure ? kBitOf[t] : 0;
  }
  for_each_bit(unsure, [&](std::uint32_t t) {
    bits = (bits & ~(kLaneBits << t)) | test(SureCross<Number>{}, t);
  });
  return bits;
}

/// On which sides of each other's line two segments r and t have their ends.
template <class Number>
struct Sides {
  Number start;  ///< positive if t starts on the left of r
  Number end;    ///< positive if t ends on the left of r
  Number along;  ///< positive if r starts on the left of t
  Number left;   ///< negative if r ends on the left of t
};
/// Segment t starts at `a`, seen from the start of r.
template <class Cross>
[[gnu::always_inline]] inline auto sides(const Cross& cross, const Vec<double>& r,
                                         const Vec<double>& a, const Vec<double>& t) {
  using Number = decltype(cross(r, t));
  const Number start = cross(r, a);
  const Number along = cross(a, t);
  if constexpr (!Cross::kHoldsSums) {
    return Sides<Number>{start, cross(r, {a.x + t.x, a.y + t.y}), along,
                         cross({r.x - a.x, r.y - a.y}, t)};
  } else {
    const Number turn = cross(r, t);
    return Sides<Number>{start, start + turn, along, turn - along};
  }
}

}  // namespace minksum
