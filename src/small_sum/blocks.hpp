// Boxes of runs of segments: most of them are not near a given one.
#pragma once

#include <algorithm>

#include "small_sum/lanes.hpp"

namespace minksum {

/// Up to 64 blocks of eight segments each.
struct SmallBlocks {
  static constexpr std::size_t kMax = 64;
  std::size_t size = 0;
  alignas(64) std::array<double, kMax> low_x;
  alignas(64) std::array<double, kMax> low_y;
  alignas(64) std::array<double, kMax> high_x;
  alignas(64) std::array<double, kMax> high_y;

  /// Of `count` segments.
  [[gnu::always_inline]] void set(const double* x, const double* y, const double* dx,
                                  const double* dy, std::size_t count) {
    size = filled_up(count) / kLanes;
    for (std::size_t b = 0; b < size; ++b) {
      double lx = x[b * kLanes];
      double hx = lx;
      double ly = y[b * kLanes];
      double hy = ly;
      for (std::size_t i = b * kLanes; i < std::min((b + 1) * kLanes, count); ++i) {
        lx = std::min(lx, x[i] + std::min(dx[i], 0.0));
        hx = std::max(hx, x[i] + std::max(dx[i], 0.0));
        ly = std::min(ly, y[i] + std::min(dy[i], 0.0));
        hy = std::max(hy, y[i] + std::max(dy[i], 0.0));
      }
      low_x[b] = lx;
      high_x[b] = hx;
      low_y[b] = ly;
      high_y[b] = hy;
    }
    for (std::size_t b = size; b < filled_up(size); ++b) {
      low_x[b] = low_y[b] = high_x[b] = high_y[b] = 0;
    }
  }
  /// The blocks whose boxes meet that of a segment.
  [[nodiscard, gnu::always_inline]] LaneBits near(double x, double y, double dx, double dy) const {
    const double lx = x + std::min(dx, 0.0);
    const double hx = x + std::max(dx, 0.0);
    const double ly = y + std::min(dy, 0.0);
    const double hy = y + std::max(dy, 0.0);
    LaneBits bits = 0;
    const std::size_t n = filled_up(size);
    for (std::size_t b = 0; b < n; ++b) {
      const bool meets =
          (low_x[b] <= hx) & (high_x[b] >= lx) & (low_y[b] <= hy) & (high_y[b] >= ly);
      bits |= meets ? kBitOf[b] : 0;
    }
    return bits & first_bits(size);
  }
};

}  // namespace minksum
