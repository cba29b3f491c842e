// Covered cells by winding number.
#include <algorithm>
#include <cmath>

#include "cover/cover.hpp"

namespace minksum {
namespace {

class WindingCounter {
 public:
  WindingCounter(const Operands& o, const UniformGrid& grid, CoverScratch& scratch)
      : o_(o), grid_(grid), crossing_(scratch.crossing), winding_(scratch.winding) {
    crossing_.assign(static_cast<std::size_t>(grid.size()), 0);
    // One more column: for what is right of all centres.
    winding_.assign(static_cast<std::size_t>(grid.rows) * stride(), 0);
  }

  void add(std::span<const Segment> segments, bool backwards) {
    const auto& [x, y, dx, dy, next] = o_.sites;
    for (const auto& [e, v] : segments) {
      const Vec<double> a{x[e] + x[v], y[e] + y[v]};
      const Vec<double> b{x[next[e]] + x[v], y[next[e]] + y[v]};
      grid_.walk(a, b, 4 * UniformGrid::kMargin, [&](std::int32_t i, std::int32_t j) {
        ++crossing_[static_cast<std::size_t>(j) * static_cast<std::size_t>(grid_.columns) +
                    static_cast<std::size_t>(i)];
        return true;
      });
      cross_centre_lines(backwards ? b : a, backwards ? a : b);
    }
  }

  /// Steps at crossings become winding numbers at centres; every row must end at zero.
  void sum_rows() {
    for (std::int32_t j = 0; j < grid_.rows; ++j) {
      std::int32_t* row = winding_.data() + static_cast<std::size_t>(j) * stride();
      for (std::size_t i = 1; i < stride(); ++i) row[i] += row[i - 1];
      if (row[stride() - 1] != 0) {
        throw Error(ErrorCode::kInternal, "the signed convolution is not closed", {}, "cover");
      }
    }
  }
  [[nodiscard]] bool certain(std::int32_t i, std::int32_t j) const {
    const auto column = static_cast<std::size_t>(i);
    const std::int32_t n = crossing_[static_cast<std::size_t>(j) *
                                         static_cast<std::size_t>(grid_.columns) + column];
    return winding_[static_cast<std::size_t>(j) * stride() + column] > 2 * n;
  }

 private:
  [[nodiscard]] std::size_t stride() const { return static_cast<std::size_t>(grid_.columns) + 1; }

  /// A step for the centres right of where the segment crosses the rows' centre lines. Segments that
  /// share a vertex share its double, so chains stay closed under the half-open rule.
  void cross_centre_lines(const Vec<double>& a, const Vec<double>& b) {
    const bool up = a.y < b.y;
    const Vec<double>& low = up ? a : b;
    const Vec<double>& high = up ? b : a;
    const double y0 = low.y * grid_.inverse;
    const double y1 = high.y * grid_.inverse;
    const auto first = static_cast<std::int32_t>(std::ceil(y0 - 0.5));
    const auto last = static_cast<std::int32_t>(std::ceil(y1 - 0.5));
    for (std::int32_t j = std::max(first, 0); j < std::min(last, grid_.rows); ++j) {
      const double t = std::clamp((j + 0.5 - y0) / (y1 - y0), 0.0, 1.0);
      const double x = (low.x + t * (high.x - low.x)) * grid_.inverse;
      const auto i = static_cast<std::int32_t>(std::floor(x - 0.5)) + 1;
      // To the left of the inside, chains run down.
      winding_[static_cast<std::size_t>(j) * stride() +
               static_cast<std::size_t>(std::clamp(i, 0, grid_.columns))] += up ? -1 : 1;
    }
  }

  const Operands& o_;
  const UniformGrid& grid_;
  std::vector<std::int32_t>& crossing_;
  std::vector<std::int32_t>& winding_;
};

}  // namespace

void cover_by_winding(const Operands& operands, const Convolution& convolution,
                      const Limits& limits, CoverScratch& scratch, Cover& cover) {
  reflex_convolution(operands, limits, scratch.convolution, scratch.reflex);
  WindingCounter counter(operands, cover.grid, scratch);
  counter.add(convolution.segments, false);
  counter.add(scratch.reflex.segments, true);
  counter.sum_rows();
  for (std::int32_t j = 0; j < cover.grid.rows; ++j) {
    for (std::int32_t i = 0; i < cover.grid.columns; ++i) {
      if (counter.certain(i, j)) cover.covered.set(i, j);
    }
  }
  make_blocks(cover.covered, cover.block);
}

}  // namespace minksum
