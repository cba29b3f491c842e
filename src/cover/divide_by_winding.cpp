// Covered cells by winding number, on a tree of cells.
#include <algorithm>
#include <bit>
#include <cmath>

#include "cover/cover.hpp"

namespace minksum {
namespace {

/// The root's side in units: no product of two differences overflows.
constexpr std::int64_t kUnits = std::int64_t{1} << 24;
/// Cells with no more segments than this are left to the arrangement.
constexpr std::size_t kFewSegments = 8;
/// Dividing ends where so many times in turn it did not thin out a list: many segments meet there.
constexpr int kMostFutile = 3;

struct Box {
  std::int64_t x;  ///< centre, in units
  std::int64_t y;
  std::int64_t half;
};

/// What is known of a cell beyond its list.
struct State {
  std::int32_t winding = 0;   ///< of the rounded chains, at the centre
  std::int32_t losing = 0;    ///< segments on whose left the centre may be
  std::int32_t doubtful = 0;  ///< segments that rounding may have moved over the centre
  std::size_t reduced = 0;    ///< segments of the reduced convolution
  int futile = 0;
  [[nodiscard]] bool inside() const { return winding > losing + doubtful; }
};

std::int64_t magnitude(std::int64_t x) { return x < 0 ? -x : x; }

/// Whether the centre, moved by (ε, ε²), is on the left, given the determinant for the centre.
bool left_of(const WindingSegment& s, std::int64_t cross) {
  if (cross != 0) return cross > 0;
  return s.dy != 0 ? s.dy < 0 : s.dx > 0;
}

class Divider {
 public:
  Divider(const Operands& o, CoverScratch& scratch, Cover& cover)
      : o_(o), reflex_(scratch.reflex.segments), stack_(scratch.stack), cover_(cover) {}

  void run(std::span<const Segment> reduced, std::int32_t side) {
    lay_grid(side);
    cover_.divided = true;
    cover_.leaves.clear();
    cover_.leaf_segments.clear();
    reduced_ = static_cast<std::uint32_t>(reduced.size());
    const std::size_t all = reduced.size() + reflex_.size();
    grow_stack(all);
    load(reduced, false, 0);
    load(reflex_, true, reduced.size());
    const Box root{kUnits / 2, kUnits / 2, kUnits / 2};
    State state;
    state.reduced = reduced.size();
    for (std::size_t i = 0; i < all; ++i) {
      state.winding += ray_step(stack_[i], root);
      count(stack_[i], root.x - stack_[i].ax, root.y - stack_[i].ay, state);
    }
    visit(root, 0, all, state, side);
  }

 private:
  void lay_grid(int side) {
    const Vec<double> extent{o_.extent[0].x + o_.extent[1].x, o_.extent[0].y + o_.extent[1].y};
    const double longer = std::max(extent.x, extent.y) * (1 + 0x1p-20);
    UniformGrid& grid = cover_.grid;
    grid.cell = longer / side;
    grid.inverse = 1 / grid.cell;
    grid.columns = static_cast<std::int32_t>(extent.x * grid.inverse) + 1;
    grid.rows = static_cast<std::int32_t>(extent.y * grid.inverse) + 1;
    cover_.covered.reset(grid.columns, grid.rows);
    scale_ = grid.inverse * static_cast<double>(kUnits / side);
    units_per_cell_ = kUnits / side;
    margin_ = static_cast<std::int64_t>(static_cast<double>(units_per_cell_) * 4 *
                                        UniformGrid::kMargin);
  }
  void grow_stack(std::size_t size) {
    if (stack_.size() < size) stack_.resize(size);
  }
  [[nodiscard]] std::int32_t rounded(double x) const {
    return static_cast<std::int32_t>(x * scale_ + 0.5);
  }
  void load(std::span<const Segment> segments, bool backwards, std::size_t first) {
    const auto& [x, y, dx, dy, next] = o_.sites;
    std::size_t i = first;
    for (const auto& [e, v] : segments) {
      const SiteId f = next[e];
      const std::int32_t ax = rounded(x[e] + x[v]);
      const std::int32_t ay = rounded(y[e] + y[v]);
      const std::int32_t bx = rounded(x[f] + x[v]);
      const std::int32_t by = rounded(y[f] + y[v]);
      const auto id = static_cast<std::uint32_t>(i);
      stack_[i++] = backwards ? WindingSegment{bx, by, ax - bx, ay - by, id}
                              : WindingSegment{ax, ay, bx - ax, by - ay, id};
    }
  }

  /// What a segment adds to the winding number if it crosses the ray from the centre to the right.
  static std::int32_t ray_step(const WindingSegment& s, const Box& box) {
    const std::int64_t rx = box.x - s.ax;
    const std::int64_t ry = box.y - s.ay;
    const bool start_below = ry >= 0;
    const bool end_below = ry - s.dy >= 0;
    if (start_below == end_below) return 0;
    const bool left = left_of(s, s.dx * ry - s.dy * rx);
    if (start_below) return left ? 1 : 0;
    return left ? 0 : -1;
  }

  /// (rx, ry) is the centre seen from the segment's start.
  static void count(const WindingSegment& s, std::int64_t rx, std::int64_t ry, State& state) {
    const std::int64_t cross = s.dx * ry - s.dy * rx;
    // Components of the edge are off by less than 2 units, those of r by less than 1.
    const std::int64_t doubt =
        magnitude(s.dx) + magnitude(s.dy) + 2 * (magnitude(rx) + magnitude(ry)) + 4;
    if (cross < -doubt) return;
    ++state.losing;
    if (cross <= doubt && is_close(s, rx, ry)) ++state.doubtful;
  }
  /// Whether the centre is within 2 units of the segment's box.
  static bool is_close(const WindingSegment& s, std::int64_t rx, std::int64_t ry) {
    return rx >= std::min<std::int64_t>(s.dx, 0) - 2 && rx <= std::max<std::int64_t>(s.dx, 0) + 2 &&
           ry >= std::min<std::int64_t>(s.dy, 0) - 2 && ry <= std::max<std::int64_t>(s.dy, 0) + 2;
  }

  void visit(const Box& box, std::size_t begin, std::size_t end, const State& state,
             std::int32_t side) {
    const auto column = static_cast<std::int32_t>((box.x - box.half) / units_per_cell_);
    const auto row = static_cast<std::int32_t>((box.y - box.half) / units_per_cell_);
    if (state.inside()) return mark(column, row, side);
    if (state.reduced == 0) return;
    if (side == 1 || end - begin <= kFewSegments || state.futile == kMostFutile) {
      return add_leaf(column, row, side, begin, end);
    }
    for (const int up : {-1, 1}) {
      for (const int right : {-1, 1}) descend(box, begin, end, state, side / 2, right, up);
    }
  }

  /// One of a cell's quarters.
  void descend(const Box& parent, std::size_t begin, std::size_t end, const State& before,
               std::int32_t side, int right, int up) {
    const std::int64_t half = parent.half / 2;
    const Box box{parent.x + right * half, parent.y + up * half, half};
    if (box.x - half >= cover_.grid.columns * units_per_cell_ ||
        box.y - half >= cover_.grid.rows * units_per_cell_) {
      return;
    }
    grow_stack(end + (end - begin));
    State state;
    state.winding = before.winding;
    std::size_t out = end;
    for (std::size_t i = begin; i < end; ++i) {
      const WindingSegment s = stack_[i];
      const std::int64_t rx = box.x - s.ax;
      const std::int64_t ry = box.y - s.ay;
      if (!is_near(s, rx, ry, half + margin_)) continue;
      stack_[out++] = s;
      state.reduced += s.id < reduced_ ? 1U : 0U;
      count(s, rx, ry, state);
      state.winding += step(s, rx, ry, half, right, up);
    }
    state.futile = 4 * (out - end) > 3 * (end - begin) ? before.futile + 1 : 0;
    visit(box, end, out, state, side);
  }

  /// Whether the segment touches the square of this half side, centred at r from its start.
  static bool is_near(const WindingSegment& s, std::int64_t rx, std::int64_t ry,
                      std::int64_t half) {
    const std::int64_t dx = s.dx;
    const std::int64_t dy = s.dy;
    return std::max(rx, rx - dx) >= -half && std::min(rx, rx - dx) <= half &&
           std::max(ry, ry - dy) >= -half && std::min(ry, ry - dy) <= half &&
           magnitude(dx * ry - dy * rx) <= (magnitude(dx) + magnitude(dy)) * half;
  }

  /// What the segment adds to the winding number on the way to the centre from (right, up) · half
  /// before it.
  static std::int32_t step(const WindingSegment& s, std::int64_t rx, std::int64_t ry,
                           std::int64_t half, int right, int up) {
    const std::int64_t cross = s.dx * ry - s.dy * rx;
    const bool left_after = left_of(s, cross);
    if (left_of(s, cross - (std::int64_t{s.dx} * up - std::int64_t{s.dy} * right) * half) ==
        left_after) {
      return 0;
    }
    // On which side of the way's line the segment starts and ends.
    const std::int64_t start = ry * right - rx * up;
    const std::int64_t end = start - (std::int64_t{s.dy} * right - std::int64_t{s.dx} * up);
    const bool on_line = up < 0;
    if ((start > 0 || (start == 0 && on_line)) == (end > 0 || (end == 0 && on_line))) return 0;
    return left_after ? 1 : -1;
  }

  void add_leaf(std::int32_t column, std::int32_t row, std::int32_t side, std::size_t begin,
                std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (stack_[i].id < reduced_) cover_.leaf_segments.push_back(stack_[i].id);
    }
    cover_.leaves.push_back(
        {column, row, side, static_cast<std::uint32_t>(cover_.leaf_segments.size())});
  }

  void mark(std::int32_t column, std::int32_t row, std::int32_t side) {
    const std::int32_t top = std::min(row + side, cover_.grid.rows);
    // Squares are aligned: one is in one word of each row, or is whole words.
    const std::uint64_t bits = side < 64 ? ((std::uint64_t{1} << side) - 1) << (column & 63)
                                         : ~std::uint64_t{0};
    for (std::int32_t j = row; j < top; ++j) {
      std::uint64_t* words = cover_.covered.row(j);
      const auto last = static_cast<std::size_t>((column + side - 1) >> 6);
      for (auto w = static_cast<std::size_t>(column >> 6);
           w <= last && w < cover_.covered.words_per_row(); ++w) {
        words[w] |= bits;
      }
    }
  }

  const Operands& o_;
  std::span<const Segment> reflex_;
  std::vector<WindingSegment>& stack_;
  Cover& cover_;
  double scale_ = 1;
  std::int64_t units_per_cell_ = 1;
  std::int64_t margin_ = 0;  ///< four times the grid's
  std::uint32_t reduced_ = 0;
};

}  // namespace

void divide_by_winding(const Operands& operands, const Convolution& convolution,
                       const Limits& limits, std::int32_t side, CoverScratch& scratch,
                       Cover& cover) {
  reflex_convolution(operands, limits, scratch.convolution, scratch.reflex);
  Divider(operands, scratch, cover).run(convolution.segments, side);
}

}  // namespace minksum
