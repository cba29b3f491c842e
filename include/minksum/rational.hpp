// Declares the exact numbers that the library takes and returns.
#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "minksum/export.h"

namespace minksum {

/// An exact decimal, mantissa · 10^exponent, as numbers in text files usually are.
struct Decimal {
  std::int64_t mantissa = 0;  ///< its digits and its sign
  int exponent = 0;           ///< the power of ten
  /// Tells whether both are written alike. Equal numbers may differ: 10 and 1e1.
  friend bool operator==(const Decimal&, const Decimal&) = default;
};

namespace detail {
/// An integer of up to 64 bits. Longer ones of some compilers would lose bits in conversion.
template <class Number>
concept Integer = std::integral<Number> && sizeof(Number) <= sizeof(std::int64_t);
/// float or double. Converting a long double would lose bits.
template <class Number>
concept Floating = std::same_as<Number, float> || std::same_as<Number, double>;
template <class Number>
concept Plain = Integer<Number> || Floating<Number>;
/// The 64-bit integer that holds every value of the type.
template <Integer Number>
using Widest = std::conditional_t<std::is_signed_v<Number>, std::int64_t, std::uint64_t>;
}  // namespace detail

/// An exact rational number of any size, in lowest terms with a positive denominator.
///
/// Copying takes O(1): copies share the digits, which never change, so different threads may use
/// copies. The type is meant for reading results and for exact operands, not for bulk arithmetic.
class MINKSUM_API Rational {
 public:
  Rational() noexcept;  ///< makes zero
  // Inline, each of these would be some hundred bytes of code, and expressions make many
  // temporaries.
  Rational(const Rational& other) noexcept;             ///< copies in O(1)
  Rational(Rational&& other) noexcept;                  ///< leaves `other` zero
  Rational& operator=(const Rational& other) noexcept;  ///< copies in O(1)
  Rational& operator=(Rational&& other) noexcept;       ///< leaves `other` zero
  ~Rational();
  // Numbers convert by themselves, as nothing is lost: NOLINTBEGIN(google-explicit-constructor)
  Rational(std::int64_t value);   ///< makes this integer
  Rational(std::uint64_t value);  ///< makes this integer
  /// Makes any other integer of up to 64 bits.
  template <detail::Integer Number>
  Rational(Number value) : Rational(static_cast<detail::Widest<Number>>(value)) {}
  /// Makes exactly this double. Throws Error(kBadInput) for NaN and infinities.
  Rational(double value);
  // NOLINTEND(google-explicit-constructor)
  /// Makes numerator / denominator. Throws Error(kBadInput) if the denominator is 0.
  Rational(std::int64_t numerator, std::int64_t denominator);
  /// Makes the exact quotient of any other two numbers, and throws like the constructors above.
  template <detail::Plain N, detail::Plain D>
  Rational(N numerator, D denominator) : Rational(quotient(numerator, denominator)) {}
  /// Makes exactly this decimal. Throws Error(kLimitExceeded) for an exponent beyond ±500,000,
  /// unless the mantissa is 0.
  explicit Rational(Decimal value);

  /// Returns the number that a text says, exactly. The text is `[+-]digits[.digits][e[+-]digits]`,
  /// or `p/q` with integers. Returns nothing if `text` is not such a number, or if a denominator is
  /// 0. The same holds for more than `kMaxDigits` digits, and for a decimal exponent beyond
  /// ±`kMaxExponent`.
  static std::optional<Rational> parse(std::string_view text);
  /// the most digits of a text for `parse`, without the exponent
  static constexpr int kMaxDigits = 4096;
  static constexpr int kMaxExponent = 4096;  ///< the largest |exponent| of a text for `parse`

  /// Returns the quotient of two integers, which are given as little-endian 64-bit limbs.
  /// `negative` is the numerator's sign. Throws Error(kBadInput) if the denominator is 0.
  static Rational from_limbs(bool negative, const std::uint64_t* numerator,
                             std::size_t numerator_limbs, const std::uint64_t* denominator,
                             std::size_t denominator_limbs);

  /// A number as little-endian 64-bit limbs without leading zeros. Zero has no numerator limbs.
  struct Limbs {
    bool negative = false;                   ///< the numerator's sign
    std::vector<std::uint64_t> numerator;    ///< |numerator|, in lowest terms
    std::vector<std::uint64_t> denominator;  ///< the denominator, in lowest terms
  };
  /// Returns the number in the form that `from_limbs` takes. O(n) for n limbs.
  [[nodiscard]] Limbs limbs() const;

  [[nodiscard]] int sign() const;              ///< returns -1, 0 or 1
  [[nodiscard]] bool is_integer() const;       ///< tells whether the denominator is 1
  [[nodiscard]] Rational numerator() const;    ///< in lowest terms, with the sign
  [[nodiscard]] Rational denominator() const;  ///< in lowest terms, positive
  /// Returns the number of bits of |numerator| or of the denominator, whichever is larger.
  [[nodiscard]] std::size_t bits() const;
  /// Returns the nearest double, ties to even. Beyond the range of doubles it is an infinity.
  [[nodiscard]] double to_double() const;
  /// Returns "p" or "p/q", in lowest terms.
  [[nodiscard]] std::string to_string() const;
  /// Returns the nearest decimal with exactly `digits` digits after the point, ties to even. O(n²)
  /// for n digits, of which there may be any number. Throws Error(kBadInput) if `digits` is
  /// negative.
  [[nodiscard]] std::string to_decimal(int digits) const;

  /// Returns the exact sum.
  friend MINKSUM_API Rational operator+(const Rational& a, const Rational& b);
  /// Returns the exact difference.
  friend MINKSUM_API Rational operator-(const Rational& a, const Rational& b);
  /// Returns the exact product.
  friend MINKSUM_API Rational operator*(const Rational& a, const Rational& b);
  /// Returns the exact quotient. Throws Error(kBadInput) if b is 0.
  friend MINKSUM_API Rational operator/(const Rational& a, const Rational& b);
  Rational& operator+=(const Rational& b) { return *this = *this + b; }  ///< adds b
  Rational& operator-=(const Rational& b) { return *this = *this - b; }  ///< subtracts b
  Rational& operator*=(const Rational& b) { return *this = *this * b; }  ///< multiplies by b
  /// Divides by b. Throws Error(kBadInput) if b is 0.
  Rational& operator/=(const Rational& b) { return *this = *this / b; }
  /// Returns the number with the other sign.
  friend MINKSUM_API Rational operator-(const Rational& a);
  /// Tells whether both are the same number.
  friend MINKSUM_API bool operator==(const Rational& a, const Rational& b);
  /// Compares by value, so `<`, `<=`, `>` and `>=` are exact.
  friend MINKSUM_API std::strong_ordering operator<=>(const Rational& a, const Rational& b);
  /// Writes what `to_string` returns.
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

/// @cond Doxygen does not know this name of std
/// Hashes a number by the nearest double: numbers beyond the range of doubles share one hash.
template <>
struct std::hash<minksum::Rational> {
  /// Returns the hash.
  std::size_t operator()(const minksum::Rational& value) const {
    return std::hash<double>()(value.to_double());
  }
};
/// @endcond
