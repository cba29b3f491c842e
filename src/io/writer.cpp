#include "io/writer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "exact/shortest_double.hpp"
#include "minksum/round.hpp"

namespace minksum::io {

namespace {

// Divides `value` by `factor` as often as that leaves an integer; returns how often.
template <typename Integer>
int divide_out(Integer& value, int factor);

template <>
int divide_out(std::uint64_t& value, int factor) {
  int times = 0;
  for (const auto by = static_cast<std::uint64_t>(factor); value % by == 0; value /= by) ++times;
  return times;
}

template <>
int divide_out(Rational& value, int factor) {
  int times = 0;
  for (Rational next = value / Rational(factor); next.is_integer();
       next = value / Rational(factor)) {
    value = next;
    ++times;
  }
  return times;
}

template <typename Integer>
std::optional<int> finite_decimal_digits_of(Integer denominator) {
  const int twos = divide_out(denominator, 2);
  const int fives = divide_out(denominator, 5);
  if (!(denominator == Integer(1))) return {};
  return std::max(twos, fives);
}

// Returns how many digits after the point write `value` exactly. Returns nothing if no number of
// digits does, or if a reader would refuse so many.
std::optional<int> finite_decimal_digits(const Rational& value) {
  const Rational denominator = value.denominator();
  const std::size_t bits = denominator.bits();
  if (bits <= 53) {  // a double holds it
    return finite_decimal_digits_of(static_cast<std::uint64_t>(denominator.to_double()));
  }
  const auto limit = static_cast<std::size_t>(Rational::kMaxDigits);
  const std::optional<int> digits =
      bits <= limit ? finite_decimal_digits_of(denominator) : std::nullopt;
  // A numerator of b bits has at most b / 3 + 1 digits, which bounds those before the point.
  if (digits && static_cast<std::size_t>(*digits) + value.numerator().bits() / 3 + 1 > limit) {
    return {};
  }
  return digits;
}

}  // namespace

void check_finite(double value) {
  if (std::isfinite(value)) return;
  throw Error(ErrorCode::kLimitExceeded, "a coordinate is beyond the range of doubles", {}, {},
              ExceededLimit{"doubles"});
}

Writer::Writer(const Sink& out, const Coordinates& style)
    : out_(out), style_(style), options_{.cancel = style.cancel}, cancellation_(options_) {
  const bool has_digits = style.style == Coordinates::Style::kDecimal;
  if (has_digits && (style.digits < 0 || style.digits > kMaxDecimals)) {
    refuse_input("digits after the point are not from 0 to 4096");
  }
  buffer_.reserve(kChunk + 4096);
}

void Writer::count(std::size_t value) { text(std::to_string(value)); }

void Writer::real(double value) {
  std::array<char, kDoubleCharacters> digits{};
  const char* const end = write_shortest(digits.data(), value);
  text(std::string_view(digits.data(), static_cast<std::size_t>(end - digits.data())));
}

void Writer::exact(const Rational& value) {
  if (!json_ || value.is_integer()) return text(value.to_string());
  if (const std::optional<int> digits = finite_decimal_digits(value)) {
    return text(value.to_decimal(*digits));
  }
  text('"' + value.to_string() + '"');
}

void Writer::nearest(double value) {
  check_finite(value);
  real(value);
}

void Writer::count_work(const Rational& value) {
  // Writing the number in digits takes a division for each digit, or a few products.
  const auto digits = static_cast<std::size_t>(std::max(style_.digits, 0));
  const std::size_t decimals = style_.style == Coordinates::Style::kDecimal ? 4 * digits : 0;
  cancellation_.check(16 * work_of_product(value.bits() + decimals));
}

void Writer::coordinate(const Rational& value) {
  count_work(value);
  switch (style_.style) {
    case Coordinates::Style::kDouble:
      return nearest(value.to_double());
    case Coordinates::Style::kExact:
      return exact(value);
    case Coordinates::Style::kDecimal:
      return text(value.to_decimal(style_.digits));
  }
}

void Writer::coordinate(const Region& region, std::size_t vertex, bool is_x) {
  if (style_.style == Coordinates::Style::kDouble) {  // needs no Rational
    cancellation_.check(8);
    return nearest(is_x ? region.x(vertex) : region.y(vertex));
  }
  coordinate(is_x ? region.exact_x(vertex) : region.exact_y(vertex));
}

void Writer::point(const Region& region, std::size_t vertex, char separator) {
  coordinate(region, vertex, true);
  text(separator);
  coordinate(region, vertex, false);
}

void Writer::point(const Point& point, char separator) {
  coordinate(point.x);
  text(separator);
  coordinate(point.y);
}

void Writer::flush() {
  out_(buffer_);
  buffer_.clear();
}

}  // namespace minksum::io
