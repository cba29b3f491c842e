// Finds the hot pixels of a grid, which hold vertices, and those that a segment meets.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "machine/cancellation.hpp"
#include "region/rational_access.hpp"
#include "spatial/uniform_grid.hpp"

namespace minksum {

/// A point in steps of the grid: the centre of its pixel, and its offset from there, in [-1/2,
/// 1/2).
struct SnapPoint {
  Vec<BigInteger> centre;
  Vec<Rational> offset;
  Vec<double> near_offset{};  ///< `offset` within 2^-53
};
/// Returns the point whose coordinates are x and y steps.
[[nodiscard]] SnapPoint snap_point(const Rational& x, const Rational& y);

using PixelId = std::uint32_t;

class HotPixels {
 public:
  /// Finds the pixels of these points. O(n log n).
  HotPixels(std::span<const SnapPoint> points, Cancellation& cancellation);

  [[nodiscard]] const Vec<BigInteger>& centre(PixelId pixel) const { return centres_[pixel]; }
  /// Returns the pixel of the point with this index.
  [[nodiscard]] PixelId pixel_of(std::size_t point) const { return pixel_of_[point]; }
  /// Lists the hot pixels that the closed segment between two of the points meets, in order along
  /// the segment. The first is that of `a`, and the last is that of `b`.
  void list_met(const SnapPoint& a, std::size_t index_a, const SnapPoint& b, std::size_t index_b,
                Cancellation& cancellation, std::vector<PixelId>& met);

 private:
  void place_in_cells(Cancellation& cancellation);

  std::vector<Vec<BigInteger>> centres_;  ///< sorted, each once
  std::vector<PixelId> pixel_of_;     ///< by point
  std::vector<Vec<double>> near_;     ///< by pixel: the centre in units of the grid of cells
  UniformGrid grid_;
  double margin_ = 0;  ///< margin of a walk, in cells
  std::vector<std::uint32_t> cell_begin_;
  std::vector<PixelId> in_cells_;
  std::vector<std::uint32_t> stamp_;  ///< by pixel: the last walk that saw it
  std::uint32_t walk_ = 0;
};

/// Tells exactly whether the closed segment from a to b meets the half-open pixel around `centre`.
[[nodiscard]] bool meets_pixel(const SnapPoint& a, const SnapPoint& b,
                               const Vec<BigInteger>& centre);

}  // namespace minksum
