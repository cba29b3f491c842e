// Boxes of blocks of segments. Most blocks are not near a given one, and are left out by their box.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "exact/formulas.hpp"
#include "spatial/box.hpp"
#include "sum/small/lanes.hpp"

namespace minksum {

/// Returns the box of a segment.
[[nodiscard, gnu::always_inline]] inline BoxOf<double> box_of_segment(double x, double y, double dx,
                                                                      double dy) {
  return {x + std::min(dx, 0.0), y + std::min(dy, 0.0), x + std::max(dx, 0.0),
          y + std::max(dy, 0.0)};
}
/// Returns a box moved by a vector, and wider by `reach` on each side.
[[nodiscard, gnu::always_inline]] inline BoxOf<double> moved(const BoxOf<double>& box,
                                                             const Vec<double>& by, double reach) {
  return {box.x0 + by.x - reach, box.y0 + by.y - reach, box.x1 + by.x + reach,
          box.y1 + by.y + reach};
}
/// Returns those of eight segments whose boxes meet `box`.
[[nodiscard, gnu::always_inline]] inline LaneBits segments_near(const double* x, const double* y,
                                                                const double* dx, const double* dy,
                                                                const BoxOf<double>& box) {
  LaneBits bits = 0;
  for (std::size_t t = 0; t < kLanes; ++t) {
    bits |= box_of_segment(x[t], y[t], dx[t], dy[t]).meets(box) ? kBitOf[t] : 0;
  }
  return bits;
}

/// Boxes in arrays that are read eight at a time.
class BoxRows {
 public:
  BoxRows() = default;
  BoxRows(const BoxRows&) = delete;
  BoxRows& operator=(const BoxRows&) = delete;
  /// Makes room for so many boxes, which must be set then.
  void make(std::size_t size) {
    size_ = size;
    stride_ = filled_up(size);
    rows_ = few_.data();
    if (4 * stride_ > few_.size()) {
      if (4 * stride_ > many_.size()) many_.resize(4 * stride_);
      rows_ = many_.data();
    }
    for (std::size_t i = size; i < stride_; ++i) set(i, {0, 0, 0, 0});
  }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] BoxOf<double> operator[](std::size_t i) const {
    return {rows_[i], rows_[stride_ + i], rows_[2 * stride_ + i], rows_[3 * stride_ + i]};
  }
  void set(std::size_t i, const BoxOf<double>& box) {
    rows_[i] = box.x0;
    rows_[stride_ + i] = box.y0;
    rows_[2 * stride_ + i] = box.x1;
    rows_[3 * stride_ + i] = box.y1;
  }
  /// Returns those of 64 boxes from `first` on, a multiple of 8, that meet `box`. Boxes before
  /// `from` are left out.
  [[nodiscard, gnu::always_inline]] LaneBits near(const BoxOf<double>& box, std::size_t first,
                                                  std::size_t from) const {
    const std::size_t count = std::min<std::size_t>(stride_ - first, 64);
    LaneBits bits = 0;
    for (std::size_t b = 0; b < count; ++b) {
      bits |= (*this)[first + b].meets(box) ? kBitOf[b] : 0;
    }
    bits &= first_bits(size_ - first);
    return from > first ? bits & ~first_bits(from - first) : bits;
  }

 private:
  std::size_t size_ = 0;
  std::size_t stride_ = 0;
  double* rows_ = nullptr;
  std::array<double, std::size_t{4} * 64> few_;  // no memory is allocated for so few
  std::vector<double> many_;
};

/// The boxes of blocks of eight segments each, in order, and of words of 64 blocks each.
class SmallBlocks {
 public:
  using Box = BoxOf<double>;
  [[nodiscard]] std::size_t size() const { return blocks_.size(); }
  [[nodiscard]] Box box_of(std::size_t block) const { return blocks_[block]; }
  [[nodiscard]] const Box& box_of_all() const { return all_; }

  /// Sets the boxes of `count` segments, and makes them wider by `reach` on each side. Entries
  /// beyond these fill the last block up, and are points of its segments.
  void set(const double* x, const double* y, const double* dx, const double* dy, std::size_t count,
           double reach);
  /// Calls visit(first, near) for words of 64 blocks, with their first block and those of them
  /// whose boxes meet `box`, as long as it returns true. Blocks before `from` are left out. Returns
  /// whether all were visited.
  template <class Visit>
  [[gnu::always_inline]] bool for_each_near(const Box& box, std::size_t from, Visit visit) const {
    for (std::size_t first = from / 64 * 64; first < size(); first += 64) {
      if (size() > 64 && !words_[first / 64].meets(box)) continue;
      if (!visit(first, blocks_.near(box, first, from))) return false;
    }
    return true;
  }

 private:
  BoxRows blocks_;
  std::vector<Box> words_;  ///< of words of 64 blocks, if there are several
  Box all_;
};

}  // namespace minksum
