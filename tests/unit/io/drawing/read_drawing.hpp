// Reads drawings for tests.
#pragma once

#include <string>

#include "minksum/io.hpp"
#include "minksum/resolve.hpp"

namespace minksum::io {

/// Returns what a text means as exact WKT, or where and why it is refused.
inline std::string read_exactly(const std::string& text, const ReadOptions& options = {}) {
  try {
    return to_wkt(resolve(read_geometry(text, options)), {Coordinates::Style::kExact});
  } catch (const ReadError& error) {
    return std::to_string(error.line()) + ":" + std::to_string(error.column()) + ": " +
           error.what();
  }
}

inline ReadOptions within(const Rational& tolerance, RoundingSide side = RoundingSide::kNearest) {
  ReadOptions options;
  options.drawing.tolerance = tolerance;
  options.drawing.side = side;
  return options;
}

}  // namespace minksum::io
