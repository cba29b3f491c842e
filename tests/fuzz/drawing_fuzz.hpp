// Fuzzes readers of drawings. The first byte chooses how a drawing is read.
#pragma once

#include "reader_fuzz.hpp"

namespace minksum::io {

/// Runs the fuzz test. `begin` and `end` make the text a drawing.
inline int fuzz_drawing(std::string_view begin, std::string_view end, const std::uint8_t* data,
                        std::size_t size) {
  if (size == 0) return 0;
  std::string text(begin);
  for (std::size_t i = 1; i < size; ++i) text += static_cast<char>(data[i]);
  text += end;
  ReadOptions options;
  constexpr RoundingSide kSides[] = {RoundingSide::kNearest, RoundingSide::kOutside,
                                     RoundingSide::kInside};
  options.drawing.side = kSides[data[0] % 3];
  // Coordinates may have many digits, so a fine tolerance makes very many vertices.
  if (data[0] % 4 != 0) options.drawing.tolerance = Rational(1 + data[0] % 50, 40);
  options.drawing.join_ends = Rational(data[0] % 5, 2);
  options.drop_z = data[0] % 2 == 0;
  const auto geometry =
      try_to_read(text, [&](const std::string& t) { return read_geometry(t, options); });
  const auto region = try_to_read(text, [&](const std::string& t) { return read(t, options); });
  if (region) require(geometry && geometry->region == *region, "a region is that geometry");
  if (geometry) check_geometry(*geometry);
  return 0;
}

}  // namespace minksum::io
