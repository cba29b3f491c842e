// Draws the key of a picture: what its colours mean.
#pragma once

#include <string>
#include <vector>

#include "pictures/svg_picture.hpp"

namespace minksum::cli {

/// A colour of the key and its meaning.
struct KeyEntry {
  std::string style;  ///< a class of SvgPicture
  std::string words;
  bool line = false;  ///< shown as a line, not as an area
};

/// Returns how many rows the entries take in a picture of that width.
[[nodiscard]] int key_rows(const std::vector<KeyEntry>& entries, double width);
/// Draws the entries in rows of `kKeyRow`, the first of which begins at (left, top).
void draw_key(SvgPicture& picture, const std::vector<KeyEntry>& entries, double left, double top,
              double width);

inline constexpr double kKeyRow = 22;
/// The width of the sample of a colour.
inline constexpr double kSwatch = 18;

}  // namespace minksum::cli
