// Defines signed integers of a fixed number of 64-bit limbs, for exact predicates beyond 128 bits.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "exact/formulas.hpp"

namespace minksum {

__extension__ typedef __int128 Int128;
__extension__ typedef unsigned __int128 Uint128;

/// Returns the count of bits of the magnitude, without sign.
inline int bit_width(Int128 value) {
  const auto magnitude = static_cast<Uint128>(value < 0 ? -value : value);
  const auto high = static_cast<std::uint64_t>(magnitude >> 64);
  return high != 0 ? 64 + static_cast<int>(std::bit_width(high))
                   : static_cast<int>(std::bit_width(static_cast<std::uint64_t>(magnitude)));
}

/// Returns a bound on the bits of 10^exponent.
constexpr int bits_of_ten_to(int exponent) { return (exponent * 10 + 2) / 3; }

/// The powers of ten that fit in 63 bits.
inline constexpr auto kPowersOfTen = [] {
  std::array<std::int64_t, 19> powers{1};
  for (std::size_t k = 1; k < powers.size(); ++k) powers[k] = 10 * powers[k - 1];
  return powers;
}();
/// Returns value · 2^twos · 10^tens, which must fit.
template <class Integer>
[[nodiscard]] constexpr Integer scaled(Integer value, int twos, int tens) {
  constexpr int kMost = static_cast<int>(kPowersOfTen.size()) - 1;
  for (; tens > kMost; tens -= kMost) value *= kPowersOfTen[kMost];
  return (value * kPowersOfTen[static_cast<std::size_t>(tens)]) << twos;
}

/// A two's complement integer of little-endian limbs, which wraps like the built-in unsigned types.
/// The users of the class prove that values stay within 64·N − 1 bits (see exact/bit_budget.hpp).
template <std::size_t N>
class WideInt {
 public:
  static constexpr int kBits = static_cast<int>(64 * N);

  constexpr WideInt() : limbs_{} {}
  constexpr explicit WideInt(int value) : WideInt(static_cast<std::int64_t>(value)) {}
  constexpr explicit WideInt(std::int64_t value) {
    limbs_.fill(value < 0 ? ~std::uint64_t{0} : 0);
    limbs_[0] = static_cast<std::uint64_t>(value);
  }
  constexpr explicit WideInt(Int128 value) {
    static_assert(N >= 2);
    limbs_.fill(value < 0 ? ~std::uint64_t{0} : 0);
    limbs_[0] = static_cast<std::uint64_t>(value);
    limbs_[1] = static_cast<std::uint64_t>(static_cast<Uint128>(value) >> 64);
  }
  template <std::size_t M>
  requires(M < N) constexpr explicit WideInt(const WideInt<M>& value) {
    limbs_.fill(value.negative() ? ~std::uint64_t{0} : 0);
    for (std::size_t i = 0; i < M; ++i) limbs_[i] = value.limb(i);
  }

  /// Returns the number that has these limbs, of which there are at most N.
  static constexpr WideInt of_limbs(std::span<const std::uint64_t> limbs) {
    WideInt value;
    std::copy(limbs.begin(), limbs.end(), value.limbs_.begin());
    return value;
  }

  [[nodiscard]] constexpr std::uint64_t limb(std::size_t i) const { return limbs_[i]; }
  [[nodiscard]] constexpr std::span<const std::uint64_t> limbs() const { return limbs_; }
  [[nodiscard]] constexpr bool negative() const { return (limbs_[N - 1] >> 63) != 0; }

  friend constexpr WideInt operator+(const WideInt& a, const WideInt& b) {
    WideInt sum;
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < N; ++i) {
      const Uint128 t = static_cast<Uint128>(a.limbs_[i]) + b.limbs_[i] + carry;
      sum.limbs_[i] = static_cast<std::uint64_t>(t);
      carry = static_cast<std::uint64_t>(t >> 64);
    }
    return sum;
  }
  friend constexpr WideInt operator-(const WideInt& a) {
    WideInt negated;
    std::uint64_t carry = 1;
    for (std::size_t i = 0; i < N; ++i) {
      const Uint128 t = static_cast<Uint128>(~a.limbs_[i]) + carry;
      negated.limbs_[i] = static_cast<std::uint64_t>(t);
      carry = static_cast<std::uint64_t>(t >> 64);
    }
    return negated;
  }
  friend constexpr WideInt operator-(const WideInt& a, const WideInt& b) {
    WideInt difference = a;
    difference.subtract(b, 0, true);
    return difference;
  }
  // Modulo 2^(64·N), the product of two's complement numbers is the product of their unsigned
  // forms.
  friend constexpr WideInt operator*(const WideInt& a, const WideInt& b) {
    WideInt product;
    for (std::size_t i = 0; i < N; ++i) {
      std::uint64_t carry = 0;
      for (std::size_t j = 0; i + j < N; ++j) {
        const Uint128 t =
            static_cast<Uint128>(a.limbs_[i]) * b.limbs_[j] + product.limbs_[i + j] + carry;
        product.limbs_[i + j] = static_cast<std::uint64_t>(t);
        carry = static_cast<std::uint64_t>(t >> 64);
      }
    }
    return product;
  }
  /// Returns a · b modulo 2^(64·N). The unsigned form of a negative number of K limbs is too large
  /// by 2^(64·K).
  template <std::size_t K, std::size_t M>
  static constexpr WideInt product_of(const WideInt<K>& a, const WideInt<M>& b) {
    if constexpr (N > K + M) {
      return WideInt(WideInt<K + M>::product_of(a, b));
    } else {
      WideInt product;
      for (std::size_t i = 0; i < std::min(K, N); ++i) {
        std::uint64_t carry = 0;
        for (std::size_t j = 0; j < M && i + j < N; ++j) {
          const Uint128 t =
              static_cast<Uint128>(a.limb(i)) * b.limb(j) + product.limbs_[i + j] + carry;
          product.limbs_[i + j] = static_cast<std::uint64_t>(t);
          carry = static_cast<std::uint64_t>(t >> 64);
        }
        if (i + M < N) product.limbs_[i + M] = carry;
      }
      product.subtract(b, K, a.negative());
      product.subtract(a, M, b.negative());
      return product;
    }
  }
  friend constexpr bool operator==(const WideInt&, const WideInt&) = default;
  friend constexpr std::strong_ordering operator<=>(const WideInt& a, const WideInt& b) {
    if (a.negative() != b.negative()) {
      return a.negative() ? std::strong_ordering::less : std::strong_ordering::greater;
    }
    for (std::size_t i = N; i-- > 0;) {
      if (a.limbs_[i] != b.limbs_[i]) return a.limbs_[i] <=> b.limbs_[i];
    }
    return std::strong_ordering::equal;
  }
  [[nodiscard]] constexpr WideInt magnitude() const { return negative() ? -*this : *this; }
  /// Returns the value modulo 2^128.
  [[nodiscard]] constexpr Int128 to_int128() const {
    return static_cast<Int128>(Uint128{limbs_[1]} << 64U | limbs_[0]);
  }

 private:
  /// Subtracts the limbs of b · 2^(64·from) that this has, if wanted. Copies of whole numbers would
  /// wait for limbs that were just written.
  template <std::size_t M>
  constexpr void subtract(const WideInt<M>& b, std::size_t from, bool wanted) {
    const std::uint64_t mask = wanted ? ~std::uint64_t{0} : 0;
    std::uint64_t borrow = 0;
    for (std::size_t i = from; i < std::min(N, from + M); ++i) {
      const Uint128 t = static_cast<Uint128>(limbs_[i]) - (b.limb(i - from) & mask) - borrow;
      limbs_[i] = static_cast<std::uint64_t>(t);
      borrow = static_cast<std::uint64_t>(t >> 64) & 1;
    }
  }

  std::array<std::uint64_t, N> limbs_;
};

/// Returns the count of bits of the magnitude.
template <std::size_t N>
int bit_width(const WideInt<N>& value) {
  const WideInt<N> magnitude = value.magnitude();
  std::size_t k = N - 1;
  while (k > 0 && magnitude.limb(k) == 0) --k;
  return static_cast<int>(64 * k) + static_cast<int>(std::bit_width(magnitude.limb(k)));
}

template <std::size_t N>
constexpr const WideInt<N>& as_limbs(const WideInt<N>& value) {
  return value;
}
constexpr WideInt<2> as_limbs(Int128 value) { return WideInt<2>(value); }
constexpr WideInt<1> as_limbs(std::int64_t value) { return WideInt<1>(value); }

constexpr double to_double(double value) { return value; }
inline double to_double(std::int64_t value) { return static_cast<double>(value); }
inline double to_double(Int128 value) { return static_cast<double>(value); }
/// Returns a double with a relative error under 2^-52, without a branch or a call. It keeps the
/// order of numbers that it does not make equal, because each rounding does. Proof of the error: if
/// `high` is 0, only `low` is rounded. Otherwise the value is 2^63 or more. Up to 2^117, rounding
/// `low` changes it by at most 2^-54, and rounding the sum by 2^-53. Beyond, rounding `high`
/// changes it by 2^-53, and `low`, which is lost, is less than 2^-53 of it.
inline double to_near_double(Int128 value) {
  // The lower part has a sign, so that short values are not rounded twice.
  const auto low = static_cast<std::int64_t>(value);
  const auto high = static_cast<std::int64_t>((value - low) >> 64);
  return static_cast<double>(high) * 0x1p64 + static_cast<double>(low);
}
/// The same of longer numbers. Proof of the error: bits below the 64 highest are left out, which
/// are less than 2^-63 of the value, and these 64 are rounded by 2^-53.
template <std::size_t N>
double to_near_double(const WideInt<N>& value) {
  const WideInt<N> magnitude = value.magnitude();
  std::size_t k = N - 1;
  while (k > 0 && magnitude.limb(k) == 0) --k;
  const std::uint64_t high = magnitude.limb(k);
  if (high == 0) return 0;
  const int shift = std::countl_zero(high);
  const std::uint64_t low = k == 0 || shift == 0 ? 0 : magnitude.limb(k - 1) >> (64 - shift);
  const double near =
      std::ldexp(static_cast<double>(high << shift | low), static_cast<int>(64 * k) - shift);
  return value.negative() ? -near : near;
}
/// Returns a double with a relative error under 2^-51. Proof: let limb k be the highest that is not
/// 0. It is rounded by 2^-53, and so is the sum with limb k - 1. That sum is 2^64 at least, before
/// it is multiplied by 2^64. So all limbs below are less than 2^-64 of it each, which is less than
/// half a bit: they change nothing.
template <std::size_t N>
double to_double(const WideInt<N>& value) {
  const WideInt<N> magnitude = value.magnitude();
  double sum = 0;
  for (std::size_t i = N; i-- > 0;) {
    sum = sum * 0x1p64 + static_cast<double>(magnitude.limb(i));
  }
  return value.negative() ? -sum : sum;
}

/// Returns the same value in a type at least as wide; without a copy where the type is the same.
template <class To, class From>
[[nodiscard]] constexpr decltype(auto) widen(const From& value) {
  if constexpr (std::is_same_v<To, From>) {
    return (value);
  } else {
    return static_cast<To>(value);
  }
}

/// Returns the product of two numbers, which `Wide` holds. It takes as many steps as they have
/// limbs, not `Wide`.
template <class Wide, class A, class B>
constexpr Wide product(const A& a, const B& b) {
  if constexpr (requires { Wide::product_of(as_limbs(a), as_limbs(b)); }) {
    return Wide::product_of(as_limbs(a), as_limbs(b));
  } else {
    return Wide(widen<Wide>(a) * widen<Wide>(b));
  }
}
/// Returns the cross product of two vectors, which `Wide` holds, in as many steps.
template <class Wide, class A, class B>
constexpr Wide exact_cross(const Vec<A>& a, const Vec<B>& b) {
  return Wide(product<Wide>(a.x, b.y) - product<Wide>(a.y, b.x));
}
/// The same for the dot product.
template <class Wide, class Number>
constexpr Wide exact_dot(const Vec<Number>& a, const Vec<Number>& b) {
  return Wide(product<Wide>(a.x, b.x) + product<Wide>(a.y, b.y));
}

}  // namespace minksum
