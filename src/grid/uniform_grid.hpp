// A uniform grid of square cells and the conservative walk of a segment through it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "predicate/formulas.hpp"

namespace minksum {

/// Cells [i·h, (i+1)·h] × [j·h, (j+1)·h], 0 ≤ i < columns, 0 ≤ j < rows.
struct UniformGrid {
  /// No more cells along a side than this: then rounding in cell units stays below 2^-38, far
  /// below the margins.
  static constexpr int kMaxSide = 1 << 13;
  /// A walk reports every cell within this distance (in cells) of the segment, and none farther
  /// than three times this distance.
  static constexpr double kMargin = 0x1p-6;

  double cell = 1;      ///< h
  double inverse = 1;   ///< 1 / h, rounded
  std::int32_t columns = 1;
  std::int32_t rows = 1;

  static UniformGrid over(double width, double height, int cells_along_longer_side) {
    UniformGrid grid;
    const double longer = std::max(width, height);
    // A side so small that its inverse would overflow is all in one cell.
    grid.cell = longer > 0x1p-900 ? longer / cells_along_longer_side : 1;
    grid.inverse = 1 / grid.cell;
    grid.columns = static_cast<std::int32_t>(width * grid.inverse) + 1;
    grid.rows = static_cast<std::int32_t>(height * grid.inverse) + 1;
    return grid;
  }
  [[nodiscard]] std::int64_t size() const { return std::int64_t{columns} * rows; }
  [[nodiscard]] std::int32_t column(double x) const {
    return std::clamp(static_cast<std::int32_t>(std::floor(x * inverse)), 0, columns - 1);
  }
  [[nodiscard]] std::int32_t row(double y) const {
    return std::clamp(static_cast<std::int32_t>(std::floor(y * inverse)), 0, rows - 1);
  }

  /// Calls visit(column, row) for every cell within `margin` cells (a multiple of kMargin, at most
  /// 1) of the segment from a to b. Stops early if visit returns false.
  template <class Visit>
  void walk(const Vec<double>& a, const Vec<double>& b, double margin, Visit visit) const {
    double ax = a.x * inverse;
    double ay = a.y * inverse;
    double bx = b.x * inverse;
    double by = b.y * inverse;
    if (ay > by) {
      std::swap(ax, bx);
      std::swap(ay, by);
    }
    const double min_x = std::min(ax, bx);
    const double max_x = std::max(ax, bx);
    const std::int32_t first = clamp_row(ay - margin);
    const std::int32_t last = clamp_row(by + margin);
    // Too flat to divide by its height safely: all its columns in each of its rows.
    const bool flat = by - ay <= kMargin;
    const double slope = flat ? 0 : (bx - ax) / (by - ay);
    for (std::int32_t j = first; j <= last; ++j) {
      double low = min_x;
      double high = max_x;
      if (!flat) {
        const double y0 = std::clamp(j - margin, ay, by);
        const double y1 = std::clamp(j + 1 + margin, ay, by);
        const double x0 = ax + (y0 - ay) * slope;
        const double x1 = ax + (y1 - ay) * slope;
        low = std::max(min_x, std::min(x0, x1));
        high = std::min(max_x, std::max(x0, x1));
      }
      const std::int32_t left = clamp_column(low - margin - kSlack);
      const std::int32_t right = clamp_column(high + margin + kSlack);
      for (std::int32_t i = left; i <= right; ++i) {
        if (!visit(i, j)) return;
      }
    }
  }

 private:
  // Covers the rounding of the walk itself: coordinates below 2^13, slopes below 2^19.
  static constexpr double kSlack = 0x1p-16;
  [[nodiscard]] std::int32_t clamp_row(double y) const {
    return std::clamp(static_cast<std::int32_t>(std::floor(y)), 0, rows - 1);
  }
  [[nodiscard]] std::int32_t clamp_column(double x) const {
    return std::clamp(static_cast<std::int32_t>(std::floor(x)), 0, columns - 1);
  }
};

}  // namespace minksum
