// Exact numbers at the library's boundary.
#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "minksum/export.h"

namespace minksum {

/// An exact decimal: mantissa · 10^exponent. What a number in a text file usually is.
struct Decimal {
  std::int64_t mantissa = 0;  ///< its digits, and its sign
  int exponent = 0;           ///< the power of ten
};

namespace detail {
/// An integer of up to 64 bits. Some compilers have longer ones, which would be cut short.
template <class Number>
concept Integer = std::integral<Number> && sizeof(Number) <= sizeof(std::int64_t);
/// float or double. A long double would be cut short.
template <class Number>
concept Floating = std::same_as<Number, float> || std::same_as<Number, double>;
template <class Number>
concept Plain = Integer<Number> || Floating<Number>;
/// The 64-bit integer that holds every value of another type.
template <Integer Number>
using Widest = std::conditional_t<std::is_signed_v<Number>, std::int64_t, std::uint64_t>;
}  // namespace detail

/// An exact rational number of any size, always in lowest terms with a positive denominator.
///
/// A value type: copying is cheap (the digits are shared and never change), so concurrent use of
/// copies is safe. It is meant for reading results and feeding exact operands, not for bulk
/// arithmetic.
class MINKSUM_API Rational {
 public:
  Rational();                                           ///< zero
  // Numbers convert by themselves, as nothing is lost: NOLINTBEGIN(google-explicit-constructor)
  Rational(std::int64_t value);   ///< this integer
  Rational(std::uint64_t value);  ///< this integer
  /// Any other integer of up to 64 bits.
  template <detail::Integer Number>
  Rational(Number value) : Rational(static_cast<detail::Widest<Number>>(value)) {}
  /// Exactly this double. Throws Error(kBadInput) for NaN and infinities.
  Rational(double value);
  // NOLINTEND(google-explicit-constructor)
  /// numerator / denominator. Throws Error(kBadInput) if the denominator is 0.
  Rational(std::int64_t numerator, std::int64_t denominator);
  /// The same for any other two numbers, exactly.
  template <detail::Plain N, detail::Plain D>
  Rational(N numerator, D denominator) : Rational(quotient(numerator, denominator)) {}
  /// Throws Error(kLimitExceeded) for an exponent beyond ±500,000, unless the mantissa is 0.
  explicit Rational(Decimal value);

  /// Reads `[+-]digits[.digits][e[+-]digits]` or `p/q` (integers) as the number that it says,
  /// exactly. Returns nothing if `text` is not such a number, if a denominator is 0, or if it has
  /// more than `kMaxDigits` digits or a decimal exponent beyond ±`kMaxExponent`.
  static std::optional<Rational> parse(std::string_view text);
  static constexpr int kMaxDigits = 4096;    ///< of a text for `parse`, exponent apart
  static constexpr int kMaxExponent = 4096;  ///< of a text for `parse`, either way

  /// The quotient of two integers given as little-endian 64-bit limbs; the numerator's sign apart.
  /// Throws Error(kBadInput) if the denominator is 0.
  static Rational from_limbs(bool negative, const std::uint64_t* numerator,
                             std::size_t numerator_limbs, const std::uint64_t* denominator,
                             std::size_t denominator_limbs);

  [[nodiscard]] int sign() const;  ///< -1, 0 or 1
  [[nodiscard]] bool is_integer() const;       ///< whether the denominator is 1
  [[nodiscard]] Rational numerator() const;    ///< in lowest terms, with the sign
  [[nodiscard]] Rational denominator() const;  ///< in lowest terms; positive
  /// Bits of the larger of |numerator| and denominator.
  [[nodiscard]] std::size_t bits() const;
  /// The nearest double, ties to even; infinity if out of range.
  [[nodiscard]] double to_double() const;
  /// "p" or "p/q", in lowest terms.
  [[nodiscard]] std::string to_string() const;
  /// With exactly `digits` digits after the point, to the nearest, ties to even. Throws
  /// Error(kBadInput) if `digits` is negative.
  [[nodiscard]] std::string to_decimal(int digits) const;

  /// The exact sum.
  friend MINKSUM_API Rational operator+(const Rational& a, const Rational& b);
  /// The exact difference.
  friend MINKSUM_API Rational operator-(const Rational& a, const Rational& b);
  /// The exact product.
  friend MINKSUM_API Rational operator*(const Rational& a, const Rational& b);
  /// The exact quotient. Throws Error(kBadInput) if b is 0.
  friend MINKSUM_API Rational operator/(const Rational& a, const Rational& b);
  /// The number with the other sign.
  friend MINKSUM_API Rational operator-(const Rational& a);
  /// Whether both are the same number.
  friend MINKSUM_API bool operator==(const Rational& a, const Rational& b);
  /// By value: so `<`, `<=`, `>` and `>=` are exact, too.
  friend MINKSUM_API std::strong_ordering operator<=>(const Rational& a, const Rational& b);
  /// Writes what `to_string` gives.
  friend MINKSUM_API std::ostream& operator<<(std::ostream& out, const Rational& value);

 private:
  friend class RationalAccess;
  struct Value;
  explicit Rational(std::shared_ptr<const Value> value);
  template <class N, class D>
  static Rational quotient(N numerator, D denominator) {
    if constexpr (std::signed_integral<N> && std::signed_integral<D>) {
      return {static_cast<std::int64_t>(numerator), static_cast<std::int64_t>(denominator)};
    } else {
      return Rational(numerator) / Rational(denominator);
    }
  }
  std::shared_ptr<const Value> value_;  // null = zero
};

}  // namespace minksum
