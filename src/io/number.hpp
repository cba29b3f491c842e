// Numbers in texts, read exactly.
#pragma once

#include "io/text_cursor.hpp"
#include "minksum/rational.hpp"

namespace minksum::io {

/// An exact number: a decimal of at most 18 digits, or else any rational.
struct Number {
  bool is_decimal = true;
  Decimal decimal;
  Rational rational;
  [[nodiscard]] Rational value() const { return is_decimal ? Rational(decimal) : rational; }
};

[[nodiscard]] bool operator==(const Number& a, const Number& b);

enum class NumberSyntax {
  kLenient,  ///< [+-] digits, also `.5`, `5.`, exponents and `p/q`
  kJson,     ///< as JSON has it
};

/// Reads the number here. Limits: Rational::kMaxDigits and kMaxExponent.
[[nodiscard]] Number scan_number(TextCursor& cursor, NumberSyntax syntax);
/// Reads a count: digits alone.
[[nodiscard]] std::size_t scan_count(TextCursor& cursor, const std::string& what);

}  // namespace minksum::io
