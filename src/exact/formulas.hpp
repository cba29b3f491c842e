// Writes each geometric formula once, over any number type.
#pragma once

namespace minksum {

/// A vector or point over any number type.
template <class Number>
struct Vec {
  Number x;
  Number y;
  friend bool operator==(const Vec&, const Vec&) = default;
};

/// Returns a positive number if `b` points to the left of `a`.
template <class Number>
constexpr Number cross(const Vec<Number>& a, const Vec<Number>& b) {
  return a.x * b.y - a.y * b.x;
}

template <class Number>
constexpr Number dot(const Vec<Number>& a, const Vec<Number>& b) {
  return a.x * b.x + a.y * b.y;
}

/// A position along a segment from `from` in direction `d`: from + d · numerator / denominator.
template <class Number>
struct Quotient {
  Number numerator;
  Number denominator;
};

/// Returns where a line meets the segment in direction `d`. The line has the direction `e` and
/// contains the point `to_other`, relative to the segment's start.
template <class Number>
constexpr Quotient<Number> crossing_parameter(const Vec<Number>& d, const Vec<Number>& to_other,
                                              const Vec<Number>& e) {
  return {cross(to_other, e), cross(d, e)};
}

}  // namespace minksum
