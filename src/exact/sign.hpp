// Defines the sign of an exact quantity, which every predicate returns.
#pragma once

namespace minksum {

enum Sign : int { kNegative = -1, kZero = 0, kPositive = 1 };

constexpr Sign operator-(Sign sign) { return static_cast<Sign>(-static_cast<int>(sign)); }
constexpr Sign operator*(Sign a, Sign b) {
  return static_cast<Sign>(static_cast<int>(a) * static_cast<int>(b));
}

/// Returns the sign of any number that compares with 0.
template <class Number>
constexpr Sign sign_of(const Number& value) {
  const Number zero(0);
  return static_cast<Sign>(static_cast<int>(value > zero) - static_cast<int>(value < zero));
}

}  // namespace minksum
