// What every reader must keep to, for any bytes: an answer or a ReadError with a place; and what
// was read, written exactly and read again, is equal.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>
#include <string_view>

#include "minksum/io.hpp"
#include "minksum/measure.hpp"

namespace minksum::io {

inline void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "violated: %s\n", what);
  std::abort();
}

// Numbers near the limits of reading can need more digits as a quotient than a reader takes.
inline bool can_come_back(const Region& region) {
  constexpr std::size_t kBits = 13'000;
  for (std::size_t v = 0; v < region.vertex_count(); ++v) {
    if (region.exact_x(v).bits() > kBits || region.exact_y(v).bits() > kBits) return false;
  }
  return true;
}

inline void check_region(const Region& region) {
  if (!can_come_back(region)) return;
  for (const Format format : {Format::kWkt, Format::kGeoJson, Format::kPoly}) {
    std::ostringstream out;
    write(out, region, format, {Coordinates::Style::kExact});
    require(read(out.str()) == region, "exact text comes back equal");
  }
  for (std::size_t v = 0; v < region.vertex_count(); ++v) {
    require(region.exact_x(v).to_double() == region.x(v), "x is the nearest double");
    require(region.exact_y(v).to_double() == region.y(v), "y is the nearest double");
  }
  require(bounding_box(region).has_value() == !region.empty(), "only the empty have no box");
}

/// `prefix` leads the bytes to one reader; it may be empty.
inline int fuzz_reader(std::string_view prefix, const std::uint8_t* data, std::size_t size) {
  std::string text(prefix);
  for (std::size_t i = 0; i < size; ++i) text += static_cast<char>(data[i]);
  Region region;
  try {
    region = read(text);
  } catch (const ReadError& error) {
    require(error.code() == ErrorCode::kBadInput || error.code() == ErrorCode::kLimitExceeded,
            "a fault of the text has a code for that");
    require(error.line() >= 1 && error.column() >= 1, "a fault has a place");
    require(std::string_view(error.what()).find('\n') == std::string_view::npos,
            "a message is one line");
    return 0;
  }
  check_region(region);
  return 0;
}

}  // namespace minksum::io
