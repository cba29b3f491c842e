#include "minksum/rational.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <ostream>
#include <utility>

#include "exact/gcd.hpp"
#include "machine/bad_input.hpp"
#include "minksum/error.hpp"
#include "region/rational_access.hpp"

namespace minksum {

namespace {

// Beyond this, a decimal exponent asks for megabytes of digits, not for a coordinate.
constexpr int kDecimalExponentLimit = 500'000;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::size_t digit_run(std::string_view text, std::size_t from) {
  std::size_t end = from;
  while (end < text.size() && is_digit(text[end])) ++end;
  return end - from;
}

// Parses `[+-]digits` up to the end of `text`. Returns nothing for other text and for exponents
// that are too large.
std::optional<int> parse_exponent(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  int value = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  if (error != std::errc() || end != last) return {};
  if (value > Rational::kMaxExponent || value < -Rational::kMaxExponent) return {};
  return value;
}

}  // namespace

Rational RationalAccess::make(BigInteger numerator, BigInteger denominator) {
  if (denominator.sign() < 0) {
    numerator = -numerator;
    denominator = -denominator;
  }
  if (denominator != 1) {
    const BigInteger divisor = greatest_common_divisor(numerator, denominator);
    if (divisor != 1) {
      numerator /= divisor;
      denominator /= divisor;
    }
  }
  return make_reduced(std::move(numerator), std::move(denominator));
}

Rational RationalAccess::make(BigInteger numerator, BigInteger denominator, int exp2, int exp10) {
  scale(numerator, denominator, exp2, exp10);
  return make(std::move(numerator), std::move(denominator));
}

Rational RationalAccess::make_reduced(BigInteger numerator, BigInteger denominator) {
  if (numerator.is_zero()) return {};
  return Rational(std::make_shared<const Rational::Value>(
      Rational::Value{std::move(numerator), std::move(denominator)}));
}

const BigInteger& RationalAccess::numerator(const Rational& value) {
  static const BigInteger zero;
  return value.value_ ? value.value_->numerator : zero;
}

const BigInteger& RationalAccess::denominator(const Rational& value) {
  static const BigInteger one = 1;
  return value.value_ ? value.value_->denominator : one;
}

Rational::Rational() noexcept = default;
Rational::Rational(const Rational& other) noexcept = default;
Rational::Rational(Rational&& other) noexcept = default;
Rational& Rational::operator=(const Rational& other) noexcept = default;
Rational& Rational::operator=(Rational&& other) noexcept = default;
Rational::~Rational() = default;

Rational::Rational(std::shared_ptr<const Value> value) : value_(std::move(value)) {}

Rational::Rational(std::int64_t value) : Rational(RationalAccess::make_reduced(value, 1)) {}

Rational::Rational(std::uint64_t value) : Rational(RationalAccess::make_reduced(value, 1)) {}

Rational::Rational(std::int64_t numerator, std::int64_t denominator) {
  if (denominator == 0) refuse_input("a rational number with denominator 0");
  *this = RationalAccess::make(numerator, denominator);
}

Rational::Rational(Decimal value) {
  if (value.mantissa == 0) return;
  if (value.exponent > kDecimalExponentLimit || value.exponent < -kDecimalExponentLimit) {
    throw Error(ErrorCode::kLimitExceeded, "a decimal exponent beyond ±500000");
  }
  *this = RationalAccess::make(value.mantissa, 1, 0, value.exponent);
}

Rational::Rational(double value) {
  if (!std::isfinite(value)) {
    refuse_input(std::isnan(value) ? "a number is not a number (NaN)" : "a number is infinite");
  }
  if (value == 0) return;
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(fraction, 53));
  *this = RationalAccess::make(mantissa, 1, exponent - 53, 0);
}

std::optional<Rational> Rational::parse(std::string_view text) {
  const bool negative = !text.empty() && text[0] == '-';
  if (!text.empty() && (text[0] == '-' || text[0] == '+')) text.remove_prefix(1);
  const auto sign = [negative](BigInteger value) { return negative ? -std::move(value) : value; };

  const std::size_t whole = digit_run(text, 0);
  if (whole == 0 || whole > kMaxDigits) return std::nullopt;
  if (whole < text.size() && text[whole] == '/') {
    const std::string_view below = text.substr(whole + 1);
    if (below.empty() || below.size() > kMaxDigits) return std::nullopt;
    if (digit_run(below, 0) != below.size()) return std::nullopt;
    BigInteger denominator(below);
    if (denominator.is_zero()) return std::nullopt;
    return RationalAccess::make(sign(BigInteger(text.substr(0, whole))), std::move(denominator));
  }
  std::size_t position = whole;
  std::string digits(text.substr(0, whole));
  int exponent = 0;
  if (position < text.size() && text[position] == '.') {
    const std::size_t fraction = digit_run(text, position + 1);
    if (fraction == 0 || whole + fraction > kMaxDigits) return std::nullopt;
    digits += text.substr(position + 1, fraction);
    exponent = -static_cast<int>(fraction);
    position += 1 + fraction;
  }
  if (position < text.size()) {
    if (text[position] != 'e' && text[position] != 'E') return std::nullopt;
    const std::optional<int> power = parse_exponent(text.substr(position + 1));
    if (!power) return std::nullopt;
    exponent += *power;
  }
  return RationalAccess::make(sign(BigInteger(digits)), 1, 0, exponent);
}

Rational Rational::from_limbs(bool negative, const std::uint64_t* numerator,
                              std::size_t numerator_limbs, const std::uint64_t* denominator,
                              std::size_t denominator_limbs) {
  BigInteger above({numerator, numerator_limbs}, negative);
  BigInteger below({denominator, denominator_limbs});
  if (below.is_zero()) refuse_input("a rational number with denominator 0");
  return RationalAccess::make(std::move(above), std::move(below));
}

Rational::Limbs Rational::limbs() const {
  Limbs limbs;
  limbs.negative = sign() < 0;
  append_limbs(RationalAccess::numerator(*this), limbs.numerator);
  append_limbs(RationalAccess::denominator(*this), limbs.denominator);
  return limbs;
}

int Rational::sign() const { return value_ ? value_->numerator.sign() : 0; }

bool Rational::is_integer() const { return !value_ || value_->denominator == 1; }

Rational Rational::numerator() const {
  return RationalAccess::make_reduced(RationalAccess::numerator(*this), 1);
}

Rational Rational::denominator() const {
  return RationalAccess::make_reduced(RationalAccess::denominator(*this), 1);
}

std::size_t Rational::bits() const {
  return std::max(bit_length(RationalAccess::numerator(*this)),
                  bit_length(RationalAccess::denominator(*this)));
}

double Rational::to_double() const {
  if (!value_) return 0;
  return nearest_double(value_->numerator, value_->denominator);
}

std::string Rational::to_string() const {
  if (!value_) return "0";
  std::string result = value_->numerator.to_string();
  if (value_->denominator != 1) result += '/' + value_->denominator.to_string();
  return result;
}

std::string Rational::to_decimal(int digits) const {
  if (digits < 0) refuse_input("a negative number of digits");
  const BigInteger scaled = abs(RationalAccess::numerator(*this)) * power(10, digits);
  const BigInteger quotient =
      divided_to_nearest(scaled, RationalAccess::denominator(*this)).quotient;
  std::string text = quotient.to_string();
  const auto places = static_cast<std::size_t>(digits);
  if (text.size() <= places) text.insert(0, places + 1 - text.size(), '0');
  if (places > 0) text.insert(text.size() - places, 1, '.');
  if (sign() < 0 && !quotient.is_zero()) text.insert(0, 1, '-');
  return text;
}

Rational operator+(const Rational& a, const Rational& b) {
  if (!a.value_) return b;
  if (!b.value_) return a;
  const auto& [an, ad] = *a.value_;
  const auto& [bn, bd] = *b.value_;
  if (ad == bd) return RationalAccess::make(an + bn, ad);
  return RationalAccess::make(an * bd + bn * ad, ad * bd);
}

Rational operator-(const Rational& a) {
  if (!a.value_) return a;
  return RationalAccess::make_reduced(-a.value_->numerator, a.value_->denominator);
}

Rational operator-(const Rational& a, const Rational& b) { return a + (-b); }

Rational operator*(const Rational& a, const Rational& b) {
  if (!a.value_ || !b.value_) return {};
  return RationalAccess::make(a.value_->numerator * b.value_->numerator,
                              a.value_->denominator * b.value_->denominator);
}

Rational operator/(const Rational& a, const Rational& b) {
  if (!b.value_) refuse_input("division by 0");
  if (!a.value_) return {};
  return RationalAccess::make(a.value_->numerator * b.value_->denominator,
                              a.value_->denominator * b.value_->numerator);
}

bool operator==(const Rational& a, const Rational& b) {
  if (a.value_ == b.value_) return true;
  if (!a.value_ || !b.value_) return false;
  return a.value_->numerator == b.value_->numerator &&
         a.value_->denominator == b.value_->denominator;
}

std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
  const int signs = a.sign() - b.sign();
  if (signs != 0) return signs <=> 0;
  if (a.value_ == b.value_) return std::strong_ordering::equal;
  const auto& [an, ad] = *a.value_;
  const auto& [bn, bd] = *b.value_;
  if (ad == bd) return an <=> bn;
  return an * bd <=> bn * ad;
}

std::ostream& operator<<(std::ostream& out, const Rational& value) {
  return out << value.to_string();
}

}  // namespace minksum
