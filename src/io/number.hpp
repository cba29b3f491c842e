// Numbers in texts, read exactly, and the rings that they make.
#pragma once

#include "io/text_cursor.hpp"
#include "minksum/region.hpp"

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

void add_vertex(Region& region, const Number& x, const Number& y);

/// Builds polygons from rings that repeat their first point at the end (WKT, GeoJSON).
class ClosedRingBuilder {
 public:
  explicit ClosedRingBuilder(Region& region) : region_(region) {}
  void begin_polygon();
  /// `cursor` stands at the ring's opening bracket: where its faults are reported.
  void begin_ring(const TextCursor& cursor);
  void add(Number x, Number y);
  void end_ring(const TextCursor& cursor);

 private:
  [[nodiscard]] std::string name() const;

  Region& region_;
  std::size_t ring_ = 0;
  std::size_t start_ = 0;
  std::size_t points_ = 0;
  Number first_x_, first_y_;
  Number last_x_, last_y_;  // held back: the closing point is not a vertex
};

}  // namespace minksum::io
