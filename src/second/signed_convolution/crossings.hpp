// Step 3 of the signed method: finds all places where segments meet, by a uniform grid.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "machine/exceeded.hpp"
#include "minksum/testing.hpp"
#include "second/signed_convolution/broken.hpp"
#include "second/signed_convolution/geometry.hpp"

namespace minksum::signed_sum {

/// A node inside a segment.
struct Stop {
  SegmentId segment;
  NodeId node;
};

struct CellRange {
  std::int64_t first;
  std::int64_t last;
};

/// A grid over the keys of all nodes. A point's key alone gives its cell, so each point is in
/// exactly one cell.
class Grid {
 public:
  /// Makes a grid with a few cells for each segment. `mean_x` and `mean_y` are the average extents
  /// of the segments, in keys. The cells get that shape.
  Grid(Key min, Key max, std::size_t segments, double mean_x, double mean_y) : min_(min) {
    const double reach_x = std::max(mean_x / (static_cast<double>(max.x - min.x) + 1), 1e-5);
    const double reach_y = std::max(mean_y / (static_cast<double>(max.y - min.y) + 1), 1e-5);
    const double cells = 4.0 * static_cast<double>(segments);
    const double columns = std::clamp(std::sqrt(cells * reach_y / reach_x), 1.0, kMaxSide);
    const double rows = std::clamp(cells / columns, 1.0, kMaxSide);
    shift_x_ = shift_for(max.x - min.x, static_cast<std::uint64_t>(columns));
    shift_y_ = shift_for(max.y - min.y, static_cast<std::uint64_t>(rows));
    columns_ = column(max) + 1;
    rows_ = row(max) + 1;
  }
  [[nodiscard]] std::int64_t column(const Key& key) const { return (key.x - min_.x) >> shift_x_; }
  [[nodiscard]] std::int64_t row(const Key& key) const { return (key.y - min_.y) >> shift_y_; }
  [[nodiscard]] std::size_t cell(const Key& key) const { return cell(column(key), row(key)); }
  [[nodiscard]] std::size_t cell(std::int64_t column, std::int64_t row) const {
    return static_cast<std::size_t>(row * columns_ + column);
  }
  [[nodiscard]] std::size_t cell_count() const {
    return static_cast<std::size_t>(columns_ * rows_);
  }

  /// Calls `visit(cell)` for every cell that contains a point of the segment from a to b, and
  /// perhaps for some more.
  template <class Visit>
  void for_cells(const Key& a, const Key& b, const Visit& visit) const {
    const CellRange columns = ordered(column(a), column(b));
    const CellRange rows = ordered(row(a), row(b));
    const bool small = columns.last - columns.first < 2 || rows.last - rows.first < 2;
    const bool coarse_keys = shift_x_ < kMinShift || shift_y_ < kMinShift;
    for (std::int64_t c = columns.first; c <= columns.last; ++c) {
      const CellRange range = small || coarse_keys ? rows : rows_in_column(a, b, c, rows);
      for (std::int64_t r = range.first; r <= range.last; ++r) visit(cell(c, r));
    }
  }

 private:
  // A side has at most 2^16 cells. Where the float path is used, a cell has at least 2^20 keys.
  // Then, in units of cells, a computed end is within e = 2^-20 + 2^-37 of the exact one. The first
  // term is the rounding down of its key, and the second the conversion to double. So every point
  // of the segment is within e of the computed segment's point with the same parameter. The
  // computed segment is more than a column wide (else `small`). So evaluating it within its ends
  // loses less than 2^-32 more. On each side of the column and of the result, kMargin amply covers
  // both errors: kMargin is as long in y as in x.
  static constexpr double kMaxSide = 65536;
  static constexpr int kMinShift = 20;
  static constexpr double kMargin = 1.0 / 1024;

  [[nodiscard]] static CellRange ordered(std::int64_t a, std::int64_t b) {
    return {std::min(a, b), std::max(a, b)};
  }
  [[nodiscard]] static int shift_for(std::int64_t extent, std::uint64_t cells) {
    int shift = 0;
    while ((static_cast<std::uint64_t>(extent) >> shift) >= cells) ++shift;
    return shift;
  }
  [[nodiscard]] CellRange rows_in_column(const Key& a, const Key& b, std::int64_t c,
                                         const CellRange& rows) const {
    const double ax = std::ldexp(static_cast<double>(a.x - min_.x), -shift_x_);
    const double ay = std::ldexp(static_cast<double>(a.y - min_.y), -shift_y_);
    const double bx = std::ldexp(static_cast<double>(b.x - min_.x), -shift_x_);
    const double by = std::ldexp(static_cast<double>(b.y - min_.y), -shift_y_);
    const double slope = (by - ay) / (bx - ax);
    const double low = std::min(ax, bx);
    const double high = std::max(ax, bx);
    const double from = std::clamp(static_cast<double>(c) - kMargin, low, high);
    const double to = std::clamp(static_cast<double>(c + 1) + kMargin, low, high);
    const double y0 = ay + (from - ax) * slope;
    const double y1 = ay + (to - ax) * slope;
    const auto first = static_cast<std::int64_t>(std::floor(std::min(y0, y1) - kMargin));
    const auto last = static_cast<std::int64_t>(std::floor(std::max(y0, y1) + kMargin));
    return {std::max(rows.first, first), std::min(rows.last, last)};
  }

  Key min_;
  int shift_x_ = 0;
  int shift_y_ = 0;
  std::int64_t columns_ = 1;
  std::int64_t rows_ = 1;
};

/// Finds all pairs of segments that meet, and adds the nodes where they cross. Lists every node
/// that lies inside a segment (perhaps several times).
template <class N>
class CrossingFinder {
 public:
  CrossingFinder(Geometry<N>& geometry, const SumSettings& options)
      : geometry_(geometry), cancellation_(geometry.cancellation()), options_(options) {}

  void run() {
    if (geometry_.segment_count() == 0) return;
    Key min = geometry_.key(0);
    Key max = min;
    cancellation_.check(geometry_.node_count() + geometry_.segment_count());
    for (NodeId node = 0; node < geometry_.node_count(); ++node) {
      const Key& key = geometry_.key(node);
      min = {std::min(min.x, key.x), std::min(min.y, key.y)};
      max = {std::max(max.x, key.x), std::max(max.y, key.y)};
    }
    const Grid grid = make_grid(min, max);
    fill(grid);
    for (std::size_t cell = 0; cell + 1 < cell_first_.size(); ++cell) meet_in_cell(grid, cell);
  }

  [[nodiscard]] const std::vector<Stop>& stops() const { return stops_; }
  [[nodiscard]] std::uint64_t crossings() const { return crossings_; }

 private:
  using Product = typename N::Product;
  struct KeyBox {
    Key min;
    Key max;
  };
  [[nodiscard]] static bool overlap(const KeyBox& a, const KeyBox& b) {
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
  }

  [[nodiscard]] Grid make_grid(const Key& min, const Key& max) const {
    double sum_x = 0;
    double sum_y = 0;
    for (SegmentId id = 0; id < geometry_.segment_count(); ++id) {
      cancellation_.check();
      const Key& a = geometry_.key(geometry_.segment(id).from);
      const Key& b = geometry_.key(geometry_.segment(id).to);
      sum_x += std::fabs(static_cast<double>(a.x - b.x));
      sum_y += std::fabs(static_cast<double>(a.y - b.y));
    }
    const auto count = static_cast<double>(geometry_.segment_count());
    return {min, max, geometry_.segment_count(), sum_x / count, sum_y / count};
  }

  void fill(const Grid& grid) {
    assign_in_pieces(cell_first_, grid.cell_count() + 1, std::size_t{0}, cancellation_);
    boxes_.reserve(geometry_.segment_count());
    for (SegmentId id = 0; id < geometry_.segment_count(); ++id) {
      const Key& a = geometry_.key(geometry_.segment(id).from);
      const Key& b = geometry_.key(geometry_.segment(id).to);
      boxes_.push_back(
          {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}});
      grid.for_cells(a, b, [&](std::size_t cell) {
        cancellation_.check();
        ++cell_first_[cell];
      });
    }
    std::size_t total = 0;
    visit_in_pieces(cell_first_, cancellation_,
                    [&](std::size_t& first) { first = total += first; });
    resize_in_pieces(members_, total, cancellation_);
    for (SegmentId id = 0; id < geometry_.segment_count(); ++id) {
      const Key& a = geometry_.key(geometry_.segment(id).from);
      const Key& b = geometry_.key(geometry_.segment(id).to);
      grid.for_cells(a, b, [&](std::size_t cell) {
        cancellation_.check();
        members_[--cell_first_[cell]] = id;
      });
    }
  }

  void meet_in_cell(const Grid& grid, std::size_t cell) {
    cancellation_.check();
    for (std::size_t i = cell_first_[cell]; i < cell_first_[cell + 1]; ++i) {
      const SegmentId a = members_[i];
      cancellation_.check(1 + (cell_first_[cell + 1] - i) / 2);
      for (std::size_t j = i + 1; j < cell_first_[cell + 1]; ++j) {
        const SegmentId b = members_[j];
        if (overlap(boxes_[a], boxes_[b])) meet(grid, cell, a, b);
      }
    }
  }

  void meet(const Grid& grid, std::size_t cell, SegmentId a, SegmentId b) {
    const auto& sa = geometry_.segment(a);
    const auto& sb = geometry_.segment(b);
    const Product b_from = geometry_.side(a, sb.from);
    const Product b_to = geometry_.side(a, sb.to);
    const int sign_b_from = sign_of(b_from);
    const int sign_b_to = sign_of(b_to);
    if (sign_b_from * sign_b_to > 0) return;
    const Product a_from = geometry_.side(b, sa.from);
    const Product a_to = geometry_.side(b, sa.to);
    const int sign_a_from = sign_of(a_from);
    const int sign_a_to = sign_of(a_to);
    if (sign_a_from * sign_a_to > 0) return;
    bool met_here = false;
    if (sign_a_from * sign_a_to < 0 && sign_b_from * sign_b_to < 0) {
      const auto [here, node] = geometry_.add_crossing(
          a, b, a_from, a_to, [&](const Key& key) { return grid.cell(key) == cell; });
      if (here) {
        append(stops_, {a, node}, cancellation_);
        append(stops_, {b, node}, cancellation_);
        met_here = true;
      }
    } else {
      const std::array<Candidate, 4> candidates{
          Candidate{{a, sb.from}, sign_b_from == 0}, Candidate{{a, sb.to}, sign_b_to == 0},
          Candidate{{b, sa.from}, sign_a_from == 0}, Candidate{{b, sa.to}, sign_a_to == 0}};
      met_here = touch(grid, cell, candidates);
    }
    if (met_here && ++crossings_ > options_.limits.max_crossings) {
      throw exceeded("Limits::max_crossings", options_.limits.max_crossings, "the arrangement has",
                     "crossings");
    }
  }

  struct Candidate {
    Stop stop;
    bool on_line;  // whether the node is on the segment's line
  };
  // Lists the candidates that are real stops and in this cell. Two segments in one line may have
  // stops in two cells. Such a pair counts as met in the cell of its first stop.
  bool touch(const Grid& grid, std::size_t cell, const std::array<Candidate, 4>& candidates) {
    bool any = false;
    bool first_here = false;
    for (const Candidate& candidate : candidates) {
      if (!candidate.on_line || !is_inside(candidate.stop)) continue;
      const bool here = grid.cell(geometry_.key(candidate.stop.node)) == cell;
      if (here) append(stops_, candidate.stop, cancellation_);
      if (!any) first_here = here;
      any = true;
    }
    return first_here;
  }

  // Tells whether a vertex on the line of a segment is between its ends.
  [[nodiscard]] bool is_inside(const Stop& stop) const {
    const auto& segment = geometry_.segment(stop.segment);
    if (stop.node == segment.from || stop.node == segment.to) return false;
    const auto& p = geometry_.vertex(stop.node);
    const auto& a = geometry_.vertex(segment.from);
    const auto& b = geometry_.vertex(segment.to);
    return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
           p.y <= std::max(a.y, b.y);
  }

  Geometry<N>& geometry_;
  Cancellation& cancellation_;
  const SumSettings& options_;
  std::vector<KeyBox> boxes_;
  std::vector<std::size_t> cell_first_;
  std::vector<SegmentId> members_;
  std::vector<Stop> stops_;
  std::uint64_t crossings_ = 0;
};

}  // namespace minksum::signed_sum
