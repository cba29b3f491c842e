// Boxes of blocks of segments. Most blocks are not near a given one, and are left out by their box.
#pragma once

#include <algorithm>

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

/// The boxes of up to `kMaxBlocks` blocks of eight segments each, in order.
template <std::size_t kMaxBlocks>
struct SmallBlocks {
  static_assert(kMaxBlocks % kLanes == 0);
  std::size_t size = 0;
  alignas(64) std::array<double, kMaxBlocks> low_x;
  alignas(64) std::array<double, kMaxBlocks> low_y;
  alignas(64) std::array<double, kMaxBlocks> high_x;
  alignas(64) std::array<double, kMaxBlocks> high_y;

  using Box = BoxOf<double>;
  [[nodiscard]] Box box_of(std::size_t block) const {
    return {low_x[block], low_y[block], high_x[block], high_y[block]};
  }

  /// Sets the boxes of `count` segments, and makes them wider by `reach` on each side. Entries
  /// beyond these are not read.
  [[gnu::always_inline]] void set(const double* x, const double* y, const double* dx,
                                  const double* dy, std::size_t count, double reach) {
    size = filled_up(count) / kLanes;
    for (std::size_t b = 0; b < size; ++b) {
      Box all = box_of_segment(x[b * kLanes], y[b * kLanes], dx[b * kLanes], dy[b * kLanes]);
      for (std::size_t i = b * kLanes + 1; i < std::min((b + 1) * kLanes, count); ++i) {
        all.add(box_of_segment(x[i], y[i], dx[i], dy[i]));
      }
      low_x[b] = all.x0 - reach;
      low_y[b] = all.y0 - reach;
      high_x[b] = all.x1 + reach;
      high_y[b] = all.y1 + reach;
    }
    for (std::size_t b = size; b < filled_up(size); ++b) {
      low_x[b] = low_y[b] = high_x[b] = high_y[b] = 0;
    }
  }
  /// Returns those of up to 64 blocks from `first` on (a multiple of 8) whose boxes meet `box`.
  [[nodiscard, gnu::always_inline]] LaneBits near(const Box& box, std::size_t first) const {
    LaneBits bits = 0;
    const std::size_t n = filled_up(std::min<std::size_t>(size - first, 64));
    for (std::size_t b = 0; b < n; ++b) {
      bits |= box_of(first + b).meets(box) ? kBitOf[b] : 0;
    }
    return bits & first_bits(size - first);
  }
  /// Returns those of the 64 blocks from `first` on (a multiple of 8) that are near `block`, itself
  /// included, and not before it.
  [[nodiscard, gnu::always_inline]] LaneBits near_from(std::size_t block, std::size_t first) const {
    const LaneBits all = near(box_of(block), first);
    return first < block ? all & ~first_bits(block - first) : all;
  }
};

}  // namespace minksum
