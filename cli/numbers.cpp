#include "numbers.hpp"

#include <charconv>

namespace minksum::cli {
namespace {

// A decimal is easier to read than a fraction, if it is short.
constexpr int kMaxReadableDigits = 40;

}  // namespace

std::string readable(const Rational& value) {
  if (value.is_integer()) return value.to_string();
  for (int digits = 1; digits <= kMaxReadableDigits; ++digits) {
    std::string text = value.to_decimal(digits);
    if (Rational::parse(text) == value) return text;
  }
  return value.to_string() + " (about " + shortest(value.to_double()) + ")";
}

std::string shortest(double value) {
  char buffer[32];
  return std::string(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
}

}  // namespace minksum::cli
