// Writes coordinates in the chosen style through a buffer.
#pragma once

#include <string>
#include <string_view>

#include "io/formats.hpp"
#include "machine/cancellation.hpp"
#include "minksum/io.hpp"

namespace minksum::io {

/// Throws Error(kLimitExceeded) for a coordinate that no double is near to.
void check_finite(double value);

class Writer {
 public:
  Writer(const Sink& out, const Coordinates& style);
  ~Writer() = default;
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  void text(std::string_view part) {
    buffer_ += part;
    if (buffer_.size() >= kChunk) flush();
  }
  void text(char c) { buffer_ += c; }
  void count(std::size_t value);
  /// Writes x, the separator and y.
  void point(const Region& region, std::size_t vertex, char separator);
  void point(const Point& point, char separator);
  /// From now on, numbers without a finite decimal become strings, because JSON lacks fractions.
  void quote_quotients() { json_ = true; }
  /// Writes a double in its shortest form.
  void real(double value);
  /// Hands the buffer to the sink. The destructor does not: text after the last flush is lost.
  void flush();

 private:
  static constexpr std::size_t kChunk = std::size_t{1} << 16;

  void exact(const Rational& value);
  void count_work(const Rational& value);
  void coordinate(const Region& region, std::size_t vertex, bool is_x);
  void coordinate(const Rational& value);
  void nearest(double value);

  const Sink& out_;
  Coordinates style_;
  Options options_;  ///< of writing
  Cancellation cancellation_;
  bool json_ = false;
  std::string buffer_;
};

}  // namespace minksum::io
