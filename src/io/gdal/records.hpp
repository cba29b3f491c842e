// Says how features of GDAL are handed over to the readers: as one text, as those of files are.
#pragma once

#include <cstdint>
#include <string_view>

namespace minksum::io::gdal {

/// Begins the text. Its first byte begins no character of UTF-8, so that no other format has it.
/// The reference system follows, and then the features. Numbers have the machine's own byte order.
inline constexpr std::string_view kMark = "\x8Eminksum: features\n";

/// Says what is known of the reference system. The code of another authority than EPSG follows it,
/// such as "ESRI::102003".
struct System {
  static constexpr std::int32_t kUnnamed = -1;  ///< there is one, but nobody has numbered it
  std::int32_t number;                          ///< that of EPSG; 0 if it is unknown
  std::uint32_t code;                           ///< how many bytes follow
};

/// Begins a feature. What it counts in bytes follows it in the same order.
struct Lengths {
  std::uint64_t id;
  std::uint64_t properties;
  std::uint64_t wkb;  ///< 0 for a feature without a geometry
};

}  // namespace minksum::io::gdal
