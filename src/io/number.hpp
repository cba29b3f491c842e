// Reads numbers from texts exactly.
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
  kPlain,    ///< the same without `p/q`
  kJson,     ///< the numbers that JSON allows
};

/// Reads the number at the cursor. Its limits are Rational::kMaxDigits and kMaxExponent.
[[nodiscard]] Number scan_number(TextCursor& cursor, NumberSyntax syntax);
/// Reads the number after white space and comments, behind which nothing else may stand.
[[nodiscard]] Number scan_lone_number(TextCursor& cursor);
/// Fails unless white space, a comment or the end stands here.
void end_of_token(const TextCursor& cursor);
/// Reads a count, which has digits only; `what` names the count in errors.
[[nodiscard]] std::size_t scan_count(TextCursor& cursor, const std::string& what);

}  // namespace minksum::io
