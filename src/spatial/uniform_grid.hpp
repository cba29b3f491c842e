// Defines a uniform grid of square cells, and the conservative walk of a segment through it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

#include "exact/formulas.hpp"

namespace minksum {

/// The cells [i·h, (i+1)·h] × [j·h, (j+1)·h] for 0 ≤ i < columns and 0 ≤ j < rows.
struct UniformGrid {
  /// Most cells along a side. Up to this, rounding in cell units stays below 2^-38, far below the
  /// margins.
  static constexpr int kMaxSide = 1 << 13;
  /// Distance in cells. A walk reports every cell within this distance of the segment, and none
  /// farther than three times this distance.
  static constexpr double kMargin = 0x1p-6;

  double cell = 1;     ///< h
  double inverse = 1;  ///< 1 / h, rounded
  std::int32_t columns = 1;
  std::int32_t rows = 1;

  static UniformGrid over(double width, double height, int cells_along_longer_side) {
    UniformGrid grid;
    const double longer = std::max(width, height);
    // If the inverse of a side would overflow, everything lies in one cell.
    grid.cell = longer > 0x1p-900 ? longer / cells_along_longer_side : 1;
    grid.inverse = 1 / grid.cell;
    grid.columns = static_cast<std::int32_t>(width * grid.inverse) + 1;
    grid.rows = static_cast<std::int32_t>(height * grid.inverse) + 1;
    return grid;
  }
  [[nodiscard]] std::int64_t size() const { return std::int64_t{columns} * rows; }
  [[nodiscard]] std::int32_t column(double x) const { return clamp_to(x * inverse, columns); }
  [[nodiscard]] std::int32_t row(double y) const { return clamp_to(y * inverse, rows); }

  /// The part of a segment near one row of cells, in cell units.
  struct RowSpan {
    std::int32_t row;
    std::int32_t left;  ///< columns that the part is near, up to `right`
    std::int32_t right;
    double x0, x1;  ///< box of the part within `margin` of the row, off by at most kSlack
    double y0, y1;
  };

  /// Calls visit(span) for every row of cells within `margin` cells of the segment from a to b,
  /// from below. `margin` is a multiple of kMargin and at most 1. Stops early if visit returns
  /// false.
  template <class Visit>
  void walk_rows(const Vec<double>& a, const Vec<double>& b, double margin, Visit visit) const {
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
    const std::int32_t first = clamp_to(ay - margin, rows);
    const std::int32_t last = clamp_to(by + margin, rows);
    // If a segment is too flat to divide by its height safely, each of its rows gets all its
    // columns. So does its row if it has only one.
    const bool whole = first == last || by - ay <= kMargin;
    const double slope = whole ? 0 : (bx - ax) / (by - ay);
    for (std::int32_t j = first; j <= last; ++j) {
      RowSpan span{j, 0, 0, min_x, max_x, ay, by};
      if (!whole) {
        span.y0 = std::clamp(j - margin, ay, by);
        span.y1 = std::clamp(j + 1 + margin, ay, by);
        const double x0 = ax + (span.y0 - ay) * slope;
        const double x1 = ax + (span.y1 - ay) * slope;
        span.x0 = std::max(min_x, std::min(x0, x1));
        span.x1 = std::min(max_x, std::max(x0, x1));
      }
      span.left = clamp_to(span.x0 - margin - kSlack, columns);
      span.right = clamp_to(span.x1 + margin + kSlack, columns);
      if (!visit(span)) return;
    }
  }

  /// Calls visit(column, row) for every cell within `margin` cells of the segment from a to b.
  /// `margin` is a multiple of kMargin and at most 1. Stops early if visit returns false.
  template <class Visit>
  void walk(const Vec<double>& a, const Vec<double>& b, double margin, Visit visit) const {
    walk_rows(a, b, margin, [&](const RowSpan& span) {
      for (std::int32_t i = span.left; i <= span.right; ++i) {
        if (!visit(i, span.row)) return false;
      }
      return true;
    });
  }

  // Covers the rounding of the walk itself, for coordinates below 2^13 and slopes below 2^19.
  static constexpr double kSlack = 0x1p-16;

 private:
  /// Returns the cell that contains a coordinate, or the nearest of `count` cells. Truncation
  /// rounds numbers that are not negative down; without newer instructions, it is far cheaper than
  /// floor.
  [[nodiscard]] static std::int32_t clamp_to(double value, std::int32_t count) {
    return static_cast<std::int32_t>(
        std::min(std::max(value, 0.0), static_cast<double>(count - 1)));
  }
};

}  // namespace minksum
