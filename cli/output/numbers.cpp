#include "output/numbers.hpp"

#include <charconv>
#include <cmath>
#include <cstdio>

namespace minksum::cli {
namespace {

// Up to this length, a decimal is easier to read than a fraction.
constexpr int kMaxReadableDigits = 40;

// Nobody reads more than about two hundred digits, and writing very many takes long.
constexpr std::size_t kMaxReadableBits = 700;

// Returns a decimal of few digits, also for numbers beyond the range of doubles.
std::string about(const Rational& value) {
  const double nearest = value.to_double();
  if (std::isnormal(nearest)) return shortest(nearest);
  const auto bits = static_cast<double>(value.numerator().bits()) -
                    static_cast<double>(value.denominator().bits());
  int exponent = static_cast<int>(std::floor(bits * std::log10(2.0)));
  const double mantissa = (value / Rational(Decimal{1, exponent})).to_double();
  // The mantissa lies between a tenth and a hundred, and is right to 15 digits.
  constexpr int kBeside = 100;
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.15g", mantissa * 1e100);
  const std::string text = digits;
  const std::size_t e = text.find('e');
  exponent += std::stoi(text.substr(e + 1)) - kBeside;
  return text.substr(0, e + 1) + (exponent < 0 ? "" : "+") + std::to_string(exponent);
}

}  // namespace

std::string in_decimals(const Rational& value) {
  std::string exact = readable(value);
  const std::size_t begin = exact.rfind("(about ");
  return begin == std::string::npos ? exact : exact.substr(begin + 1, exact.size() - begin - 2);
}

std::string readable(const Rational& value) {
  if (value.bits() > kMaxReadableBits) {
    return "about " + about(value) + " (" + std::to_string(value.bits()) +
           " bits; exactly with --json)";
  }
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
