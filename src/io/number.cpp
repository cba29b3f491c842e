#include "io/number.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace minksum::io {

namespace {

constexpr std::size_t kQuickDigits = 18;  // 10^18 fits 63 bits
constexpr auto kDigitLimit = static_cast<std::size_t>(Rational::kMaxDigits);

// The parts of a number in the text: its runs of digits, and the value of its exponent.
struct Parts {
  std::size_t start = 0;
  bool negative = false;
  std::string_view whole;
  std::string_view fraction;
  int exponent = 0;
};

std::string_view take_digits(TextCursor& cursor) {
  const std::string_view rest = cursor.rest();
  std::size_t length = 0;
  while (length < rest.size() && is_digit(rest[length])) ++length;
  cursor.advance(length);
  return rest.substr(0, length);
}

void check_digits(const TextCursor& cursor, std::size_t digits, std::size_t start) {
  if (digits <= kDigitLimit) return;
  cursor.fail(ErrorCode::kLimitExceeded,
              "a number of " + std::to_string(digits) + " digits; the limit is " +
                  std::to_string(kDigitLimit),
              start);
}

[[noreturn]] void fail_no_number(TextCursor& cursor, std::size_t start) {
  std::string word = cursor.take_word();
  cursor.move_to(start);
  if (word == "NAN" || word == "INF" || word == "INFINITY") {
    cursor.fail("a coordinate must be a finite number, found " + cursor.found());
  }
  cursor.fail_expected("a number");
}

int take_exponent(TextCursor& cursor, std::size_t start) {
  const bool negative = cursor.peek() == '-';
  if (cursor.peek() == '-' || cursor.peek() == '+') cursor.advance();
  const std::string_view digits = take_digits(cursor);
  if (digits.empty()) cursor.fail_expected("the digits of an exponent");
  constexpr int kLimit = Rational::kMaxExponent;
  int value = 0;
  for (const char c : digits) value = std::min(value * 10 + (c - '0'), kLimit + 1);
  if (value > kLimit) {
    cursor.fail(ErrorCode::kLimitExceeded,
                "the exponent of a number is beyond the limit of ±" + std::to_string(kLimit),
                start);
  }
  return negative ? -value : value;
}

Parts take_parts(TextCursor& cursor, NumberSyntax syntax) {
  const bool json = syntax == NumberSyntax::kJson;
  Parts parts;
  parts.start = cursor.position();
  parts.negative = cursor.peek() == '-';
  if (parts.negative || (cursor.peek() == '+' && !json)) cursor.advance();
  parts.whole = take_digits(cursor);
  const bool dot = cursor.peek() == '.' && (!json || !parts.whole.empty());
  if (dot) {
    cursor.advance();
    parts.fraction = take_digits(cursor);
    if (json && parts.fraction.empty()) cursor.fail_expected("a digit after the point");
  }
  if (parts.whole.empty() && parts.fraction.empty()) fail_no_number(cursor, parts.start);
  if (json && parts.whole.size() > 1 && parts.whole[0] == '0') {
    cursor.fail(ErrorCode::kBadInput, "a number in JSON may not start with 0 and a digit",
                parts.start);
  }
  check_digits(cursor, parts.whole.size() + parts.fraction.size(), parts.start);
  if (cursor.peek() == 'e' || cursor.peek() == 'E') {
    cursor.advance();
    parts.exponent = take_exponent(cursor, parts.start);
  }
  return parts;
}

std::size_t significant_digits(const Parts& parts) {
  const auto zeros = [](std::string_view digits) {
    return std::min(digits.find_first_not_of('0'), digits.size());
  };
  const std::size_t above = zeros(parts.whole);
  const std::size_t below = above == parts.whole.size() ? zeros(parts.fraction) : 0;
  return parts.whole.size() - above + parts.fraction.size() - below;
}

std::uint64_t accumulate(std::uint64_t value, std::string_view digits) {
  for (const char c : digits) value = value * 10 + static_cast<std::uint64_t>(c - '0');
  return value;
}

std::int64_t signed_value(bool negative, std::uint64_t magnitude) {
  const auto value = static_cast<std::int64_t>(magnitude);
  return negative ? -value : value;
}

Number exact_number(const TextCursor& cursor, const Parts& parts, const std::string& text) {
  std::optional<Rational> value = Rational::parse(parts.negative ? '-' + text : text);
  if (!value) {  // the syntax is right, so the value exceeds a limit
    cursor.fail(ErrorCode::kLimitExceeded, "a number beyond the limits", parts.start);
  }
  return {false, {}, *std::move(value)};
}

Number take_quotient(TextCursor& cursor, const Parts& parts) {
  cursor.advance();  // the slash
  const std::string_view below = take_digits(cursor);
  if (below.empty()) cursor.fail_expected("a denominator");
  check_digits(cursor, below.size(), parts.start);
  if (below.find_first_not_of('0') == std::string_view::npos) {
    cursor.fail(ErrorCode::kBadInput, "a number has the denominator 0", parts.start);
  }
  if (parts.whole.size() <= kQuickDigits && below.size() <= kQuickDigits) {
    return {false,
            {},
            Rational(signed_value(parts.negative, accumulate(0, parts.whole)),
                     signed_value(false, accumulate(0, below)))};
  }
  return exact_number(cursor, parts, std::string(parts.whole) + '/' + std::string(below));
}

}  // namespace

bool operator==(const Number& a, const Number& b) {
  if (a.is_decimal && b.is_decimal && a.decimal.exponent == b.decimal.exponent) {
    return a.decimal.mantissa == b.decimal.mantissa;
  }
  return a.value() == b.value();
}

Number scan_number(TextCursor& cursor, NumberSyntax syntax) {
  const Parts parts = take_parts(cursor, syntax);
  const bool plain_integer = parts.whole.data() + parts.whole.size() == cursor.rest().data();
  if (plain_integer && cursor.peek() == '/' && syntax == NumberSyntax::kLenient) {
    return take_quotient(cursor, parts);
  }
  if (significant_digits(parts) <= kQuickDigits) {
    const std::uint64_t magnitude = accumulate(accumulate(0, parts.whole), parts.fraction);
    if (magnitude == 0) return {};
    return {true,
            {signed_value(parts.negative, magnitude),
             parts.exponent - static_cast<int>(parts.fraction.size())},
            {}};
  }
  std::string text = parts.whole.empty() ? "0" : std::string(parts.whole);
  if (!parts.fraction.empty()) text += '.' + std::string(parts.fraction);
  if (parts.exponent != 0) text += 'e' + std::to_string(parts.exponent);
  return exact_number(cursor, parts, text);
}

Number scan_lone_number(TextCursor& cursor) {
  cursor.skip_space_and_comments();
  Number number = scan_number(cursor, NumberSyntax::kLenient);
  end_of_token(cursor);
  return number;
}

void end_of_token(const TextCursor& cursor) {
  if (!cursor.at_end() && !is_space(cursor.peek()) && cursor.peek() != '#') {
    cursor.fail_expected("a space");
  }
}

std::size_t scan_count(TextCursor& cursor, const std::string& what) {
  const std::size_t start = cursor.position();
  const std::string_view digits = take_digits(cursor);
  const char next = cursor.peek();
  if (digits.empty() || next == '.' || next == '/' || is_letter(next)) {
    cursor.move_to(start);
    cursor.fail_expected(what);
  }
  if (digits.size() > kQuickDigits) {
    cursor.fail(ErrorCode::kLimitExceeded, "a count of more than 18 digits", start);
  }
  return static_cast<std::size_t>(accumulate(0, digits));
}

}  // namespace minksum::io
