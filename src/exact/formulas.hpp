// Each geometric formula, once, over any number type.
#pragma once

namespace minksum {

/// A vector or point over any number type.
template <class Number>
struct Vec {
  Number x;
  Number y;
};

/// Positive if `b` points to the left of `a`.
template <class Number>
constexpr Number cross(const Vec<Number>& a, const Vec<Number>& b) {
  return a.x * b.y - a.y * b.x;
}

template <class Number>
constexpr Number dot(const Vec<Number>& a, const Vec<Number>& b) {
  return a.x * b.x + a.y * b.y;
}

/// A position along a segment from `from` in direction `d`, as the quotient of the two.
template <class Number>
struct Quotient {
  Number numerator;
  Number denominator;
};

/// Where the line through `to_other` (relative to the segment's start) in direction `e` meets the
/// segment in direction `d`: from + d·N/D.
template <class Number>
constexpr Quotient<Number> crossing_parameter(const Vec<Number>& d, const Vec<Number>& to_other,
                                              const Vec<Number>& e) {
  return {cross(to_other, e), cross(d, e)};
}

}  // namespace minksum
