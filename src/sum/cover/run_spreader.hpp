// Unites a bitmap with copies of another, moved along runs of columns.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "minksum/error.hpp"
#include "sum/cover/cover.hpp"

namespace minksum {

/// A range of rows that holds all set bits of a bitmap.
struct RowRange {
  std::int32_t first = 0;
  std::int32_t last = 0;
};
[[nodiscard]] inline RowRange occupied_rows(const Bitmap& bitmap) {
  const auto empty = [&](std::int32_t j) {
    return std::all_of(bitmap.row(j), bitmap.row(j) + bitmap.words_per_row(),
                       [](std::uint64_t word) { return word == 0; });
  };
  RowRange rows{0, bitmap.rows()};
  while (rows.first < rows.last && empty(rows.first)) ++rows.first;
  while (rows.first < rows.last && empty(rows.last - 1)) --rows.last;
  return rows;
}

/// Unites `to` with `from`, moved by `bits` < 64 columns. All rows are moved as if they were one,
/// because set bits stay within their rows. `to` is as long as `from`, or has one word more.
[[gnu::always_inline]] inline void unite_moved(const std::uint64_t* __restrict from,
                                               std::size_t count, int bits,
                                               std::uint64_t* __restrict to, bool one_more) {
  if (bits == 0) {
    for (std::size_t w = 0; w < count; ++w) to[w] |= from[w];
    return;
  }
  to[0] |= from[0] << bits;
  for (std::size_t w = 1; w < count; ++w) to[w] |= (from[w] << bits) | (from[w - 1] >> (64 - bits));
  if (one_more) to[count] |= from[count - 1] >> (64 - bits);
}

/// Unites a bitmap, moved along whole runs of columns at a time, with another whose rows are as
/// long. It keeps the bitmap united with itself, moved by 1, 2, 4 and more columns. With these, a
/// run of up to 128 columns takes two moves at most.
class RunSpreader {
 public:
  RunSpreader(const Bitmap& source, Vectors vectors, std::vector<std::uint64_t>& widened)
      : rows_(occupied_rows(source)),
        words_(source.words_per_row()),
        vectors_(vectors),
        widened_(widened) {
    first_ = static_cast<std::size_t>(rows_.first) * words_;
    count_ = static_cast<std::size_t>(rows_.last - rows_.first) * words_;
    const auto words = source.words().subspan(first_, count_);
    widened_.assign(words.begin(), words.end());
  }
  /// Returns how many words each move unites.
  [[nodiscard]] std::size_t words() const { return count_; }

  /// Returns how often moving along so many columns unites all words, at most.
  [[nodiscard]] static std::uint64_t moves(std::int32_t columns) {
    return static_cast<std::uint64_t>(columns >> kMostLevels) + 2;
  }
  /// Makes what runs of up to so many columns need.
  void widen_for(std::int32_t length) {
    while (levels_ < level_of(length)) widen();
  }
  /// Unites `target` with the bitmap moved by (first, row) to (last, row). No number may be
  /// negative. Threads may do this at the same time, after `widen_for` the longest run.
  void spread(std::int32_t first, std::int32_t last, std::int32_t row, Bitmap& target) {
    if (words_ != target.words_per_row()) {
      throw Error(ErrorCode::kInternal, "rows of different lengths", {}, "cover");
    }
    const std::int32_t length = last + 1 - first;
    widen_for(length);
    const int level = level_of(length);
    const std::int32_t width = 1 << level;
    for (std::int32_t i = first; i + width <= last + 1; i += width) place(level, i, row, target);
    if (length % width != 0) place(level, last + 1 - width, row, target);
  }

 private:
  static constexpr int kMostLevels = 6;

  [[nodiscard]] static int level_of(std::int32_t length) {
    return std::min(static_cast<int>(std::bit_width(static_cast<std::uint32_t>(length))) - 1,
                    kMostLevels);
  }
  void widen() {
    const std::size_t from = static_cast<std::size_t>(levels_) * count_;
    widened_.resize(from + 2 * count_);
    std::uint64_t* source = widened_.data() + from;
    std::copy(source, source + count_, source + count_);
    unite(source, count_, 1 << levels_, source + count_, false);
    ++levels_;
  }
  void place(int level, std::int32_t column, std::int32_t row, Bitmap& target) const {
    const std::size_t offset =
        first_ + static_cast<std::size_t>(row) * words_ + static_cast<std::size_t>(column >> 6);
    const std::size_t size = target.words().size();
    if (offset >= size) return;
    unite(widened_.data() + static_cast<std::size_t>(level) * count_,
          std::min(count_, size - offset), column & 63, target.words().data() + offset,
          offset + count_ < size);
  }
  void unite(const std::uint64_t* from, std::size_t count, int bits, std::uint64_t* to,
             bool one_more) const {
    with_vectors(
        vectors_, [&]() __attribute__((always_inline)) {
          unite_moved(from, count, bits, to, one_more);
        });
  }

  RowRange rows_;
  std::size_t words_;
  Vectors vectors_;
  std::size_t first_ = 0;  ///< index of the source's first word in use
  std::size_t count_ = 0;
  int levels_ = 0;
  std::vector<std::uint64_t>& widened_;
};

}  // namespace minksum
