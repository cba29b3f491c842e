// Bitmaps of cells.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace minksum {

/// Sets the bits of a row from column `left` to column `right`.
inline void set_bits(std::uint64_t* row, std::int32_t left, std::int32_t right) {
  const std::int32_t first = left >> 6;
  const std::int32_t last = right >> 6;
  const std::uint64_t from = ~std::uint64_t{0} << (left & 63);
  const std::uint64_t to = ~std::uint64_t{0} >> (63 - (right & 63));
  if (first == last) {
    row[first] |= from & to;
    return;
  }
  row[first] |= from;
  for (std::int32_t w = first + 1; w < last; ++w) row[w] = ~std::uint64_t{0};
  row[last] |= to;
}

/// A bitmap of cells: rows of bits, 64 to a word. Bits past the last column are never set.
class Bitmap {
 public:
  /// Sets the size, and clears all bits. Rows may have more words than the columns need: bitmaps
  /// with equal `words` per row line up.
  void reset(std::int32_t columns, std::int32_t rows, std::size_t words = 0) {
    columns_ = columns;
    rows_ = rows;
    words_ = std::max((static_cast<std::size_t>(columns) + 63) / 64, words);
    bits_.assign(words_ * static_cast<std::size_t>(rows), 0);
  }
  [[nodiscard]] std::int32_t columns() const { return columns_; }
  [[nodiscard]] std::int32_t rows() const { return rows_; }
  [[nodiscard]] std::size_t words_per_row() const { return words_; }
  [[nodiscard]] std::span<std::uint64_t> words() { return bits_; }
  [[nodiscard]] std::span<const std::uint64_t> words() const { return bits_; }
  [[nodiscard]] std::uint64_t* row(std::int32_t j) {
    return bits_.data() + words_ * static_cast<std::size_t>(j);
  }
  [[nodiscard]] const std::uint64_t* row(std::int32_t j) const {
    return bits_.data() + words_ * static_cast<std::size_t>(j);
  }
  [[nodiscard]] bool has_any() const {
    return std::any_of(bits_.begin(), bits_.end(), [](std::uint64_t word) { return word != 0; });
  }
  [[nodiscard]] bool get(std::int32_t i, std::int32_t j) const {
    return ((row(j)[i >> 6] >> (i & 63)) & 1) != 0;
  }
  /// Calls visit(word, bits) for the words of row j that hold the columns from `left` to `right`,
  /// with the bits of these columns.
  template <class Visit>
  void visit_words(std::int32_t j, std::int32_t left, std::int32_t right, Visit visit) const {
    for (std::int32_t first = left; first <= right; first = (first | 63) + 1) {
      const std::int32_t last = std::min(right, first | 63);
      visit(first >> 6, row(j)[first >> 6],
            ~std::uint64_t{0} >> (63 - (last - first)) << (first & 63));
    }
  }
  void set(std::int32_t i, std::int32_t j) { row(j)[i >> 6] |= std::uint64_t{1} << (i & 63); }

 private:
  std::int32_t columns_ = 0;
  std::int32_t rows_ = 0;
  std::size_t words_ = 0;
  std::vector<std::uint64_t> bits_;
};

}  // namespace minksum
