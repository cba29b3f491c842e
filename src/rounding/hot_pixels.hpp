// The pixels of a grid that hold vertices, and which of them a segment meets.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "machine/cancellation.hpp"
#include "region/rational_access.hpp"
#include "spatial/uniform_grid.hpp"

namespace minksum {

/// A point in steps of the grid: its pixel's centre, and where it is in the pixel, [-1/2, 1/2).
struct SnapPoint {
  Vec<BigInt> centre;
  Vec<Rational> offset;
  Vec<double> near_offset{};  ///< the same, within 2^-53
};
/// x and y in steps.
[[nodiscard]] SnapPoint snap_point(const Rational& x, const Rational& y);

using PixelId = std::uint32_t;

class HotPixels {
 public:
  /// The pixels of these points. O(n log n).
  HotPixels(std::span<const SnapPoint> points, Cancellation& cancellation);

  [[nodiscard]] const Vec<BigInt>& centre(PixelId pixel) const { return centres_[pixel]; }
  /// The pixel of the point with this index.
  [[nodiscard]] PixelId pixel_of(std::size_t point) const { return pixel_of_[point]; }
  /// All hot pixels that the closed segment between two of the points meets, in the order along it:
  /// first that of `a`, last that of `b`.
  void list_met(const SnapPoint& a, std::size_t index_a, const SnapPoint& b, std::size_t index_b,
                Cancellation& cancellation, std::vector<PixelId>& met);

 private:
  void place_in_cells(Cancellation& cancellation);

  std::vector<Vec<BigInt>> centres_;  ///< sorted, each once
  std::vector<PixelId> pixel_of_;     ///< by point
  std::vector<Vec<double>> near_;     ///< by pixel: the centre in units of the cells' grid
  UniformGrid grid_;
  double margin_ = 0;  ///< of a walk, in cells
  std::vector<std::uint32_t> cell_begin_;
  std::vector<PixelId> in_cells_;
  std::vector<std::uint32_t> stamp_;  ///< by pixel: the walk that saw it last
  std::uint32_t walk_ = 0;
};

/// Whether the closed segment from a to b meets the half-open pixel around `centre`. Exact.
[[nodiscard]] bool meets_pixel(const SnapPoint& a, const SnapPoint& b, const Vec<BigInt>& centre);

}  // namespace minksum
