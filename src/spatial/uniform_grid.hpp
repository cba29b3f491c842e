// Defines a uniform grid of cells, and the conservative walk of a segment through it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "exact/formulas.hpp"

namespace minksum {

/// Finds how much wider than high cells should be that suit sets of edges. On a plane whose axes
/// have different units, edges may be a thousand times as wide as high. A square cell that fits
/// into such shapes is tiny then.
class CellShape {
 public:
  /// Adds so many edges, by the widths and the heights of all of them together.
  void add(double edges, double run, double rise) {
    // Sets count by their edges, not by lengths: the few long edges of a box say little of a shape
    // that is moved along it.
    const double root = std::sqrt(run / rise);
    if (!(root > 0) || !(root < HUGE_VAL)) return;
    run_ += edges * root;
    rise_ += edges / root;
  }
  /// Returns how many times as wide as high cells should be, as a power of two. They are square
  /// unless edges are far from that: the strokes of a letter are as narrow one way as the other,
  /// whichever way is longer in all. With 5.7 instead of 11, three of 83 sums of flat shapes took
  /// 1.2 to 1.3 times as long. With 2, and powers of four, 16 of 335 sums took over 1.2 times as
  /// long, and two under 0.8.
  [[nodiscard]] double stretch() const {
    constexpr double kSquare = 11;
    const double ratio = run_ / rise_;
    if (!(ratio > 0) || !(ratio < HUGE_VAL)) return 1;
    if (ratio < kSquare && ratio > 1 / kSquare) return 1;
    constexpr double kRoot = 1.4142135623730951;  // so the power of two is the nearest one
    return std::ldexp(1.0, std::clamp(std::ilogb(ratio * kRoot), -64, 64));
  }

 private:
  double run_ = 0;
  double rise_ = 0;
};

/// The cells [i·w, (i+1)·w) × [j·h, (j+1)·h) for 0 ≤ i < columns and 0 ≤ j < rows: a point on the
/// border of two belongs to the right or the upper one.
struct UniformGrid {
  /// Most cells along a side. Up to this, rounding in cell units stays below 2^-38, far below the
  /// margins.
  static constexpr int kMaxSide = 1 << 13;
  /// Distance in cells. A walk reports every cell within this distance of the segment, and none
  /// farther than three times this distance.
  static constexpr double kMargin = 0x1p-6;
  /// Covers the rounding of the walk itself, for coordinates below 2^13 and slopes below 2^19.
  static constexpr double kSlack = 0x1p-16;

  Vec<double> cell{1, 1};     ///< w and h
  Vec<double> inverse{1, 1};  ///< 1 / w and 1 / h, rounded
  std::int32_t columns = 1;
  std::int32_t rows = 1;

  /// Returns the grid over the box from (0, 0) to `extent`, with cells `stretch` times as wide as
  /// high, and so many along the side that takes more of them. `stretch` is from 2^-64 to 2^64.
  static UniformGrid over(const Vec<double>& extent, int most_along_side, double stretch = 1) {
    UniformGrid grid;
    if (extent.y * stretch == HUGE_VAL) stretch = 1;
    const double longer = std::max(extent.x, extent.y * stretch);
    // If the inverse of a side would overflow, everything lies in one cell.
    if (longer > 0x1p-800) {
      const double width = longer / most_along_side;
      grid.cell = {width, width / stretch};
      grid.inverse = {1 / grid.cell.x, 1 / grid.cell.y};
    }
    grid.columns = static_cast<std::int32_t>(extent.x * grid.inverse.x) + 1;
    grid.rows = static_cast<std::int32_t>(extent.y * grid.inverse.y) + 1;
    return grid;
  }
  [[nodiscard]] std::int64_t size() const { return std::int64_t{columns} * rows; }
  [[nodiscard]] std::int32_t column(double x) const { return clamp_to(x * inverse.x, columns); }
  [[nodiscard]] std::int32_t row(double y) const { return clamp_to(y * inverse.y, rows); }

  /// The part of a segment near one row of cells, in cell units.
  struct RowSpan {
    std::int32_t row;
    std::int32_t left;  ///< columns that the part is near, up to `right`
    std::int32_t right;
    double x0, x1;  ///< box of the part within `margin` of the row, off by at most kSlack
    double y0, y1;
  };

  /// The rows near a segment, in cell units, from its lower end.
  class RowWalk {
   public:
    RowWalk(const UniformGrid& grid, const Vec<double>& a, const Vec<double>& b, double margin)
        : grid_(grid),
          margin_(margin),
          ax_((a.y <= b.y ? a : b).x * grid.inverse.x),
          ay_((a.y <= b.y ? a : b).y * grid.inverse.y),
          by_((a.y <= b.y ? b : a).y * grid.inverse.y) {
      const double bx = (a.y <= b.y ? b : a).x * grid.inverse.x;
      min_x_ = std::min(ax_, bx);
      max_x_ = std::max(ax_, bx);
      first = clamp_to(ay_ - margin, grid.rows);
      last = clamp_to(by_ + margin, grid.rows);
      // If a segment is too flat to divide by its height safely, each of its rows gets all its
      // columns. So does its row if it has only one.
      whole_ = first == last || by_ - ay_ <= kMargin;
      slope_ = whole_ ? 0 : (bx - ax_) / (by_ - ay_);
    }
    /// Returns the part near the rows from j to `end`.
    [[nodiscard]] RowSpan span(std::int32_t j, std::int32_t end) const {
      RowSpan span{j, 0, 0, min_x_, max_x_, ay_, by_};
      if (!whole_) {
        span.y0 = std::clamp(j - margin_, ay_, by_);
        span.y1 = std::clamp(end + 1 + margin_, ay_, by_);
        const double x0 = ax_ + (span.y0 - ay_) * slope_;
        const double x1 = ax_ + (span.y1 - ay_) * slope_;
        span.x0 = std::max(min_x_, std::min(x0, x1));
        span.x1 = std::min(max_x_, std::max(x0, x1));
      }
      span.left = clamp_to(span.x0 - margin_ - kSlack, grid_.columns);
      span.right = clamp_to(span.x1 + margin_ + kSlack, grid_.columns);
      return span;
    }
    /// Returns the rows that the segment passes from one side to the other, with their margins: the
    /// first one, and the one behind the last one. They have equal spans, each moved by the slope.
    /// There are none if the segment is flat.
    [[nodiscard]] std::pair<std::int32_t, std::int32_t> inner_rows() const {
      if (whole_) return {first, first};
      return {static_cast<std::int32_t>(ay_ + margin_) + 1,
              static_cast<std::int32_t>(by_ - margin_)};
    }
    /// Returns how many columns the segment goes to the right for each row.
    [[nodiscard]] double slope() const { return slope_; }
    /// Whether the segment passes a height: it starts below it, and does not end below it.
    [[nodiscard]] bool passes(double y) const { return ay_ < y && y <= by_; }
    /// Returns where it does so, or any point of it if it is flat.
    [[nodiscard]] double column_at(double y) const {
      return std::clamp(ax_ + (y - ay_) * slope_, min_x_, max_x_);
    }

    std::int32_t first;  ///< row
    std::int32_t last;

   private:
    const UniformGrid& grid_;
    double margin_;
    double ax_, ay_, by_;
    double min_x_, max_x_;
    bool whole_;
    double slope_;
  };

  /// Calls visit(span) for every row of cells within `margin` cells of the segment from a to b,
  /// from below. `margin` is a multiple of kMargin and at most 1. Stops early if visit returns
  /// false.
  template <class Visit>
  void walk_rows(const Vec<double>& a, const Vec<double>& b, double margin, Visit visit) const {
    const RowWalk walk(*this, a, b, margin);
    for (std::int32_t j = walk.first; j <= walk.last; ++j) {
      if (!visit(walk.span(j, j))) return;
    }
  }

  /// Calls visit(span) for the same rows, but leaves out runs of rows for which pass_over(span,
  /// last row) returns true. A span of several rows has all that the spans of its rows have. Runs
  /// get longer as long as they are left out, or visited, so few runs are tried.
  template <class Visit, class PassOver>
  void walk_rows_but(const Vec<double>& a, const Vec<double>& b, double margin, Visit visit,
                     PassOver pass_over) const {
    constexpr std::int32_t kRun = 4;  // trying shorter runs takes more than they save
    const RowWalk walk(*this, a, b, margin);
    std::int32_t left_out = kRun;
    std::int32_t visited = kRun;
    for (std::int32_t j = walk.first; j <= walk.last;) {
      const std::int32_t end = std::min(j + left_out - 1, walk.last);
      if (pass_over(walk.span(j, end), end)) {
        j = end + 1;
        left_out *= 2;
        visited = kRun;
        continue;
      }
      for (const std::int32_t stop = std::min(j + visited - 1, walk.last); j <= stop; ++j) {
        visit(walk.span(j, j));
      }
      visited *= 2;
      left_out = kRun;
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
