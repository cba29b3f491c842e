// Declares integers of any size. Their arithmetic is that of Boost.Multiprecision, which only
// big_integer.cpp includes, because its headers take long to compile.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "exact/sign.hpp"
#include "exact/wide_int.hpp"

namespace minksum {

class BigInteger {
 public:
  BigInteger(Int128 value = 0);  // NOLINT(google-explicit-constructor): as built-in integers do
  template <std::size_t N>
  explicit BigInteger(const WideInt<N>& value)
      : BigInteger(value.magnitude().limbs(), value.negative()) {}
  /// Takes the magnitude from little-endian limbs.
  explicit BigInteger(std::span<const std::uint64_t> limbs, bool negative = false);
  /// Reads decimal digits.
  explicit BigInteger(std::string_view digits);
  BigInteger(const BigInteger& other);
  BigInteger(BigInteger&& other) noexcept;
  BigInteger& operator=(const BigInteger& other);
  BigInteger& operator=(BigInteger&& other) noexcept;
  ~BigInteger();

  /// Returns -1, 0 or 1.
  [[nodiscard]] int sign() const;
  [[nodiscard]] bool is_zero() const { return sign() == 0; }
  [[nodiscard]] bool is_odd() const { return (limb(0) & 1) != 0; }
  /// Returns how many limbs the magnitude has. There is at least one, and the highest of several is
  /// not 0.
  [[nodiscard]] std::size_t limb_count() const;
  /// Returns a limb of the magnitude, the lowest first.
  [[nodiscard]] std::uint64_t limb(std::size_t i) const;
  /// Returns the value modulo 2^64.
  explicit operator std::int64_t() const;
  [[nodiscard]] std::string to_string() const;

  BigInteger& operator+=(const BigInteger& other);
  BigInteger& operator-=(const BigInteger& other);
  BigInteger& operator*=(const BigInteger& other) { return *this = *this * other; }
  BigInteger& operator/=(const BigInteger& other) { return *this = *this / other; }
  BigInteger& operator<<=(std::int64_t bits);
  friend BigInteger operator+(const BigInteger& a, const BigInteger& b);
  friend BigInteger operator+(BigInteger&& a, const BigInteger& b) { return std::move(a += b); }
  friend BigInteger operator-(const BigInteger& a, const BigInteger& b);
  friend BigInteger operator-(BigInteger&& a, const BigInteger& b) { return std::move(a -= b); }
  friend BigInteger operator*(const BigInteger& a, const BigInteger& b);
  /// Quotients are rounded towards 0.
  friend BigInteger operator/(const BigInteger& a, const BigInteger& b);
  friend BigInteger operator%(const BigInteger& a, const BigInteger& b);
  friend BigInteger operator<<(BigInteger a, std::int64_t bits) { return std::move(a <<= bits); }
  friend BigInteger operator>>(const BigInteger& a, std::int64_t bits);
  friend BigInteger operator-(BigInteger a);
  friend bool operator==(const BigInteger& a, const BigInteger& b);
  friend std::strong_ordering operator<=>(const BigInteger& a, const BigInteger& b);

 private:
  friend struct BoostInteger;
  struct NotMade {};
  explicit BigInteger(NotMade /*unused*/) {}
  // Holds Boost's integer, of which big_integer.cpp checks size and alignment.
  alignas(16) std::byte storage_[32];
};

inline Sign sign_of(const BigInteger& value) { return static_cast<Sign>(value.sign()); }
[[nodiscard]] inline BigInteger abs(BigInteger value) {
  return value.sign() < 0 ? -std::move(value) : value;
}
/// Returns how often 2 divides the value, which must not be 0.
[[nodiscard]] std::int64_t trailing_zeros(const BigInteger& value);
/// Returns the count of bits of |value|, which is 0 for 0.
[[nodiscard]] std::size_t bit_length(const BigInteger& value);
/// Returns |value|, which must have at most 128 bits.
[[nodiscard]] Uint128 short_magnitude(const BigInteger& value);
[[nodiscard]] BigInteger power(int base, int exponent);
/// Multiplies numerator / denominator by 2^exp2 · 10^exp10.
void scale(BigInteger& numerator, BigInteger& denominator, int exp2, int exp10);
/// Appends |value| as little-endian 64-bit limbs without leading zeros, and returns their count.
std::size_t append_limbs(const BigInteger& value, std::vector<std::uint64_t>& limbs);

struct Division {
  BigInteger quotient;
  BigInteger rest;
};
/// Divides with a quotient rounded towards 0, so that the rest has the sign of `value`.
[[nodiscard]] Division divided(const BigInteger& value, const BigInteger& divisor);
/// Divides by a positive number, with the quotient rounded to the nearest integer, ties to even.
[[nodiscard]] Division divided_to_nearest(const BigInteger& value, const BigInteger& divisor);

/// Returns the double nearest to numerator / denominator · 2^exp2, for denominator > 0. Ties go to
/// even. Denormals, and overflow to infinity, are as in IEEE 754; zero is +0.
[[nodiscard]] double nearest_double(const BigInteger& numerator, const BigInteger& denominator,
                                    std::int64_t exp2 = 0);
/// Does the same for short numbers that are not negative.
[[nodiscard]] double nearest_double(Uint128 numerator, std::uint64_t denominator,
                                    std::int64_t exp2);
[[nodiscard]] double to_double(const BigInteger& value);

}  // namespace minksum
