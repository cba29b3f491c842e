// Vectors whose coordinates are integers, in doubles that may round them.
#pragma once

#include <cstddef>
#include <cstdint>

#include "exact/formulas.hpp"
#include "exact/wide_int.hpp"

namespace minksum {

/// Holds coordinates of up to 2^250.
using WideNumber = WideInt<4>;

/// For WideNumber, returns 2^-48 of the width of all coordinates. It bounds the errors of points,
/// of boxes and, for edges of length 1, of cross products. Let u be 2^-53 of the width, and v the
/// same of an edge and the width. An operand's points and edges are off by less than 2u on their
/// own grid, and are rounded twice as products with a rounded number of steps. So an operand's
/// points are off by up to 4u, a sum's by 5u, and differences of two points by 11u, or by 16u if
/// one is moved by an edge. Rounded edges and products make that up to 23v. Instead of a moved
/// point, the cross product of the two edges may be added, with 10v and with 2v for that sum: 29v
/// in all.
[[nodiscard]] constexpr double reach_of(double width) { return 0x1p-48 * width; }

/// How the coordinates of a small sum are stored, and its cross products computed. Their sign is
/// that of doubles, or of integers if these do not tell:
/// - `double`: doubles hold all cross products.
/// - `std::uint64_t`: doubles hold coordinates, of up to 2^49, and round cross products. One whose
///   sign they do not tell is small, so its value modulo 2^64 tells it.
/// - `WideNumber`: doubles round coordinates, of up to 2^250, too. The exact ones are computed only
///   where doubles do not tell.
template <class Number>
struct SmallNumbers {
  double reach = 0;  ///< `reach_of` the sum's width, for WideNumber

  /// Whether Int128 holds coordinates: up to a width of 2^125. Differences take one bit more.
  [[nodiscard]] bool fit_int128() const { return reach <= 0x1p77; }
};

class SmallOperand;

/// An array of vectors in doubles: a property of an operand's vertices.
struct VecRow {
  const double* x;
  const double* y;
  const SmallOperand* operand;
  int property;  ///< see SmallOperand::Row

  [[nodiscard]] Vec<double> operator[](std::size_t i) const { return {x[i], y[i]}; }
  /// Returns a vector that doubles may round.
  template <class Integer>
  [[nodiscard]] Vec<Integer> exact(std::size_t i) const;
};

/// The type that holds the cross product of two vectors of integers, or the product of two such
/// products.
template <class Integer>
struct ProductType;
template <>
struct ProductType<std::int64_t> {
  using Type = Int128;
};
template <>
struct ProductType<Int128> {
  using Type = WideInt<4>;
};
template <std::size_t N>
struct ProductType<WideInt<N>> {
  using Type = WideInt<2 * N>;
};
template <class Integer>
using ProductOf = typename ProductType<Integer>::Type;

/// A vector in doubles, and exactly or modulo 2^64.
template <class Number>
struct SureVec {
  Vec<double> near;
  Vec<Number> exact;
};

template <class Number>
[[nodiscard, gnu::always_inline]] constexpr Vec<Number> plus(const Vec<Number>& a,
                                                             const Vec<Number>& b) {
  return {a.x + b.x, a.y + b.y};
}
template <class Number>
[[nodiscard, gnu::always_inline]] constexpr Vec<Number> minus(const Vec<Number>& a,
                                                              const Vec<Number>& b) {
  return {a.x - b.x, a.y - b.y};
}
template <class Number>
[[nodiscard, gnu::always_inline]] constexpr SureVec<Number> plus(const SureVec<Number>& a,
                                                                 const SureVec<Number>& b) {
  return {plus(a.near, b.near), plus(a.exact, b.exact)};
}
template <class Number>
[[nodiscard, gnu::always_inline]] constexpr SureVec<Number> minus(const SureVec<Number>& a,
                                                                  const SureVec<Number>& b) {
  return {minus(a.near, b.near), minus(a.exact, b.exact)};
}

/// The coordinates of a vector without rounding, in a type that compares them: doubles hold short
/// ones.
[[nodiscard, gnu::always_inline]] constexpr Vec<double> as_signed(const Vec<double>& v) {
  return v;
}
[[nodiscard, gnu::always_inline]] constexpr Vec<double> as_signed(const SureVec<std::uint64_t>& v) {
  return v.near;
}
template <class Integer>
[[nodiscard, gnu::always_inline]] constexpr const Vec<Integer>& as_signed(
    const SureVec<Integer>& v) {
  return v.exact;
}
/// The same as integers.
[[nodiscard]] constexpr Vec<std::int64_t> as_integers(const Vec<double>& v) {
  return {static_cast<std::int64_t>(v.x), static_cast<std::int64_t>(v.y)};
}
[[nodiscard]] constexpr Vec<std::int64_t> as_integers(const SureVec<std::uint64_t>& v) {
  return {static_cast<std::int64_t>(v.exact.x), static_cast<std::int64_t>(v.exact.y)};
}
template <class Integer>
[[nodiscard]] constexpr const Vec<Integer>& as_integers(const SureVec<Integer>& v) {
  return v.exact;
}
/// The same in doubles, which may round it.
[[nodiscard]] constexpr const Vec<double>& near_of(const Vec<double>& v) { return v; }
template <class Number>
[[nodiscard]] constexpr const Vec<double>& near_of(const SureVec<Number>& v) {
  return v.near;
}
template <class Vector>
[[nodiscard, gnu::always_inline]] constexpr bool are_equal(const Vector& a, const Vector& b) {
  return as_signed(a).x == as_signed(b).x && as_signed(a).y == as_signed(b).y;
}

}  // namespace minksum
