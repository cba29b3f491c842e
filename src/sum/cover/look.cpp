// Estimates from a sample what a cover leaves of the segments.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "sum/cover/cover.hpp"

namespace minksum {
namespace {

/// Whether a line touches an uncovered cell.
bool is_visible(const Line& line, const Cover& cover) {
  if (!cover.active) return true;
  bool visible = false;
  cover.grid.walk_rows(line.start, line.end, UniformGrid::kMargin, [&](const auto& span) {
    for (std::int32_t i = span.left; i <= span.right && !visible; i = (i | 63) + 1) {
      const std::int32_t last = std::min(span.right, i | 63);
      const std::uint64_t wanted = ~std::uint64_t{0} >> (63 - (last - i)) << (i & 63);
      visible = (wanted & ~cover.covered.row(span.row)[i >> 6]) != 0;
    }
    return !visible;
  });
  return visible;
}

/// Estimates how many uncovered cells a visible line touches, from some points of it.
double count_cells(const Line& line, const Cover& cover) {
  constexpr int kPoints = 8;
  const Vec<double> d{line.end.x - line.start.x, line.end.y - line.start.y};
  int uncovered = 0;
  for (int k = 0; k < kPoints; ++k) {
    const double t = (k + 0.5) / kPoints;
    const std::int32_t column = cover.grid.column(line.start.x + t * d.x);
    if (!cover.is_covered(column, cover.grid.row(line.start.y + t * d.y))) ++uncovered;
  }
  return 1 + (std::abs(d.x) + std::abs(d.y)) * cover.grid.inverse * uncovered / kPoints;
}

/// Counts the crossings of a few lines in uncovered cells, but not those at ends.
std::uint64_t count_crossings(std::span<const Line> lines, const Cover& cover,
                              CoverScratch& scratch) {
  constexpr double kEnd = 0x1p-20;
  std::uint64_t count = 0;
  auto& boxes = scratch.boxes;
  boxes.clear();
  for (const auto& [a, b] : lines) {
    const BoxOf<double> box{std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x),
                            std::max(a.y, b.y)};
    for (std::size_t j = 0; j < boxes.size(); ++j) {
      if (!box.meets(boxes[j])) continue;
      const auto& [c, d] = lines[j];
      const Vec<double> u{b.x - a.x, b.y - a.y};
      const Vec<double> v{d.x - c.x, d.y - c.y};
      const Vec<double> w{c.x - a.x, c.y - a.y};
      const double area = cross(u, v);
      const double at_u = cross(w, v) / area;
      const double at_v = cross(w, u) / area;
      // The tests fail if the area is zero.
      if (!(at_u > kEnd && at_u < 1 - kEnd && at_v > kEnd && at_v < 1 - kEnd)) continue;
      const double x = a.x + at_u * u.x;
      const double y = a.y + at_u * u.y;
      if (!cover.is_covered(cover.grid.column(x), cover.grid.row(y))) ++count;
    }
    boxes.push_back(box);
  }
  return count;
}

}  // namespace

Sample take_sample(const Convolution& convolution, CoverScratch& scratch) {
  // The number follows from the size of the convolution, because its list may be a sample already.
  const auto wanted = std::clamp<std::uint64_t>(convolution.size / 16, kFewestSampled, kSample);
  const std::size_t listed = convolution.segments.size();
  const std::size_t count = std::min(static_cast<std::size_t>(wanted), listed);
  auto& sample = scratch.sample;
  sample.clear();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t first = i * listed / count;
    const std::size_t end = (i + 1) * listed / count;
    // Positions vary, because shapes can repeat themselves with the period of the sample.
    const std::uint64_t random = (i + 1) * 0x9E3779B97F4A7C15U >> 32;
    sample.push_back(
        convolution.segments[first + random * (end - first) / (std::uint64_t{1} << 32)]);
  }
  return {sample, static_cast<double>(convolution.size) / static_cast<double>(count)};
}

double Sample::expected_crossings(const Operands& operands) const {
  constexpr std::int32_t kSide = 32;
  const auto& [x, y, dx, dy, next] = operands.sites;
  const Vec<double> extent = operands.sum_extent();
  const double area = extent.x * extent.y;
  if (!(area > 0)) return 0;
  std::array<std::uint32_t, kSide * kSide> in_cell{};
  const auto cell = [](double at, double size) {
    return std::clamp(static_cast<std::int32_t>(at / size * kSide), 0, kSide - 1);
  };
  double across = 0;
  double up = 0;
  std::uint64_t pairs = 0;
  for (const auto& [e, v] : segments) {
    across += std::abs(dx[e]);
    up += std::abs(dy[e]);
    const std::int32_t column = cell(x[e] + x[v] + dx[e] / 2, extent.x);
    const std::int32_t row = cell(y[e] + y[v] + dy[e] / 2, extent.y);
    pairs += in_cell[static_cast<std::size_t>(row * kSide + column)]++;
  }
  // Of segments that are evenly spread, one of so many pairs would lie in one cell.
  const auto count = static_cast<double>(segments.size());
  const double unevenness = 2 * static_cast<double>(pairs) * kSide * kSide / (count * count);
  return std::max(1.0, unevenness) * step * across * step * up / area;
}

Visibility look(const Operands& operands, const Sample& sample, const Cover& cover,
                Cancellation& cancellation, CoverScratch& scratch) {
  const auto at = [&](SiteId v) { return Vec<double>{operands.sites.x[v], operands.sites.y[v]}; };
  auto& visible = scratch.visible;
  visible.clear();
  double rows = 0;
  double cells = 0;
  for (const auto& [e, v] : sample.segments) {
    cancellation.check(static_cast<std::uint64_t>(cover.grid.rows));
    const Vec<double> a = at(e);
    const Vec<double> b = at(operands.sites.next[e]);
    const Vec<double> q = at(v);
    const Line line{{a.x + q.x, a.y + q.y}, {b.x + q.x, b.y + q.y}};
    if (!is_visible(line, cover)) continue;
    visible.push_back(line);
    if (!cover.active) continue;
    rows += 1 + std::abs(line.end.y - line.start.y) * cover.grid.inverse;
    cells += count_cells(line, cover);
  }
  const double share =
      static_cast<double>(visible.size()) / static_cast<double>(sample.segments.size());
  // A pair takes some 1.3 ns, and a segment that is left takes 150 ns to arrange. So many lines are
  // compared that all their pairs take a fiftieth of what arranging the visible segments takes.
  constexpr double kPairsForEach = 0.02 * 150 / 1.3;
  const double left = sample.step * static_cast<double>(visible.size());
  const std::size_t count =
      std::min(visible.size(), static_cast<std::size_t>(std::sqrt(2 * kPairsForEach * left)));
  if (count < 2) return {share, 0, sample.step * rows, sample.step * cells};
  const double each =
      sample.step * static_cast<double>(visible.size()) / static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) visible[i] = visible[i * visible.size() / count];
  const std::uint64_t crossings = count_crossings({visible.data(), count}, cover, scratch);
  return {share, static_cast<double>(crossings) * each * each, sample.step * rows,
          sample.step * cells};
}

}  // namespace minksum
