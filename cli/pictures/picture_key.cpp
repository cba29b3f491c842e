#include "pictures/picture_key.hpp"

#include "pictures/text_layout.hpp"

namespace minksum::cli {
namespace {

// Calls visit(entry, x, row) for each entry; returns the number of rows.
int arrange(const std::vector<KeyEntry>& entries, double width, auto visit) {
  double x = 0;
  int row = 0;
  for (const KeyEntry& entry : entries) {
    const double wide =
        kSwatch + 8 + kCharacterWidth * static_cast<double>(character_count(entry.words)) + 20;
    if (x > 0 && x + wide > width) {
      x = 0;
      ++row;
    }
    visit(entry, x, row);
    x += wide;
  }
  return row + 1;
}

}  // namespace

int key_rows(const std::vector<KeyEntry>& entries, double width) {
  return arrange(entries, width, [](const KeyEntry&, double, int) {});
}

void draw_key(SvgPicture& picture, const std::vector<KeyEntry>& entries, double left, double top,
              double width) {
  arrange(entries, width, [&](const KeyEntry& entry, double x, int row) {
    const double y = top + kKeyRow * row;
    if (entry.line) {
      const PictureLine line{left + x, y + 8, left + x + kSwatch, y + 8};
      picture.lines({&line, 1}, entry.style);
    } else {
      picture.box(left + x, y + 2, kSwatch, 12, "region " + entry.style);
    }
    picture.text(left + x + kSwatch + 8, y + 13, "caption", entry.words);
  });
}

}  // namespace minksum::cli
