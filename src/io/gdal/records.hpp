// Says how features of GDAL are handed over to the readers: as one text, as those of files are.
#pragma once

#include <cstdint>
#include <string_view>

namespace minksum::io::gdal {

/// Begins the text. Its first byte begins no character of UTF-8, so that no other format has it.
/// The reference system follows as a number (std::int32_t, 0 if it is unknown), and then the
/// features. Numbers have the machine's own byte order.
inline constexpr std::string_view kMark = "\x8Eminksum: features\n";

/// Begins a feature. What it counts in bytes follows it in the same order.
struct Lengths {
  std::uint64_t id;
  std::uint64_t properties;
  std::uint64_t wkb;  ///< 0 for a feature without a geometry
};

}  // namespace minksum::io::gdal
