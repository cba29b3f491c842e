// Finds covered cells by moving edges of one operand along edges of the other.
#include <algorithm>
#include <cmath>

#include "sum/cover/cover.hpp"

namespace minksum {
namespace {

/// Sets columns [first, last] of a row.
void set_run(std::uint64_t* row, std::int32_t first, std::int32_t last) {
  if (first > last) return;
  std::uint64_t* word = row + (first >> 6);
  std::uint64_t* const last_word = row + (last >> 6);
  std::uint64_t bits = ~std::uint64_t{0} << (first & 63);
  for (; word < last_word; ++word) {
    *word |= bits;
    bits = ~std::uint64_t{0};
  }
  *word |= bits & ~std::uint64_t{0} >> (63 - (last & 63));
}

/// The points between two parallel lines. At height y, these are the points with x from
/// `slope` · y + `low` to `slope` · y + `high`. If the lines are level, the strip has all points.
struct Strip {
  double slope = 0;
  double low = -HUGE_VAL;
  double high = HUGE_VAL;
};

/// Makes the strip that a line sweeps when it is moved by the vector of another edge. The line goes
/// through `from` in direction `d`, and `area` is d × that vector. Returns false if the line is not
/// level but too flat to divide by the height of `d`.
bool make_strip(const Vec<double>& from, const Vec<double>& d, double area, Strip& strip) {
  if (d.y == 0) return true;
  if (std::abs(d.y) <= UniformGrid::kMargin) return false;
  strip.slope = d.x / d.y;
  const double at = from.x - strip.slope * from.y;
  const double width = -area / d.y;
  strip.low = at + std::min(width, 0.0);
  strip.high = at + std::max(width, 0.0);
  return true;
}

constexpr double kShortest = 2;  ///< in cells

/// Lists the longest edge in each of `count` stretches of an operand's sites, without short ones.
void choose(const Operands& o, int operand, std::size_t count, const Vec<double>& inverse,
            std::vector<CellEdge>& edges) {
  const SiteId begin = operand == 0 ? 0 : o.split;
  const SiteId size = operand == 0 ? o.split : o.size() - o.split;
  const auto& sites = o.sites;
  // In cells.
  const auto length = [&](SiteId e) {
    return std::abs(sites.dx[e]) * inverse.x + std::abs(sites.dy[e]) * inverse.y;
  };
  edges.clear();
  count = std::min<std::size_t>(count, size);
  for (std::size_t i = 0; i < count; ++i) {
    const auto first = begin + static_cast<SiteId>(i * size / count);
    const auto last = begin + static_cast<SiteId>((i + 1) * size / count);
    SiteId longest = first;
    for (SiteId e = first + 1; e < last; ++e) {
      if (length(e) > length(longest)) longest = e;
    }
    if (length(longest) < kShortest) continue;
    edges.push_back({{sites.x[longest] * inverse.x, sites.y[longest] * inverse.y},
                     {sites.dx[longest] * inverse.x, sites.dy[longest] * inverse.y}});
  }
}

class ParallelogramRasteriser {
 public:
  explicit ParallelogramRasteriser(Bitmap& covered) : covered_(covered) {}

  void mark(const CellEdge& e, const std::vector<CellEdge>& others) {
    for (const CellEdge& f : others) mark(e, f);
  }
  /// Marks the cells that lie, with their margin, in e ⊕ f.
  void mark(const CellEdge& e, const CellEdge& f) {
    constexpr double kMargin = 4 * UniformGrid::kMargin;
    const double area = cross(e.d, f.d);
    // Such a parallelogram is hardly anywhere as wide as kShortest cells.
    if (std::abs(area) <= kShortest * std::max(std::abs(e.d.x) + std::abs(e.d.y),
                                               std::abs(f.d.x) + std::abs(f.d.y))) {
      return;
    }
    const Vec<double> from{e.start.x + f.start.x, e.start.y + f.start.y};
    Strip along_e;
    Strip along_f;
    if (!make_strip(from, e.d, area, along_e) || !make_strip(from, f.d, -area, along_f)) return;
    const double bottom = from.y + std::min(e.d.y, 0.0) + std::min(f.d.y, 0.0) + kMargin;
    const double top = from.y + std::max(e.d.y, 0.0) + std::max(f.d.y, 0.0) - kMargin;
    const auto first = static_cast<std::int32_t>(std::ceil(bottom));
    const auto last = std::min(static_cast<std::int32_t>(std::floor(top)), covered_.rows()) - 1;
    // A convex shape contains a box if it contains the box's corners.
    for (std::int32_t j = first; j <= last; ++j) {
      const double y0 = j - kMargin;
      const double y1 = j + 1 + kMargin;
      const auto left = [&](const Strip& s) {
        return std::max(s.slope * y0, s.slope * y1) + s.low;
      };
      const auto right = [&](const Strip& s) {
        return std::min(s.slope * y0, s.slope * y1) + s.high;
      };
      const double x0 = std::max(left(along_e), left(along_f)) + kMargin;
      const double x1 = std::min(right(along_e), right(along_f)) - kMargin;
      if (x1 - x0 < 1) continue;
      set_run(covered_.row(j), static_cast<std::int32_t>(std::ceil(x0)),
              static_cast<std::int32_t>(std::floor(x1)) - 1);
    }
  }

 private:
  Bitmap& covered_;
};

}  // namespace

double choose_long_edges(const Operands& operands, const UniformGrid& grid, CoverScratch& scratch) {
  const std::int32_t side = std::max(grid.columns, grid.rows);
  const auto count = static_cast<std::size_t>(4 * std::sqrt(side));
  double rises[2] = {0, 0};
  for (const int operand : {0, 1}) {
    auto& edges = scratch.long_edges[operand];
    choose(operands, operand, count, grid.inverse, edges);
    for (const CellEdge& e : edges) rises[operand] += 1 + std::abs(e.d.y);
  }
  return rises[0] * static_cast<double>(scratch.long_edges[1].size()) +
         rises[1] * static_cast<double>(scratch.long_edges[0].size());
}

void cover_by_parallelograms(Cancellation& cancellation, CoverScratch& scratch, Cover& cover) {
  const std::vector<CellEdge>& first = scratch.long_edges[0];
  const std::vector<CellEdge>& second = scratch.long_edges[1];
  const auto rise = [](const CellEdge& e) { return 1 + std::abs(e.d.y); };
  double rows = 0;
  for (const CellEdge& f : second) rows += rise(f);
  const auto work = [&](const CellEdge& e) {
    return static_cast<std::uint64_t>(rows + rise(e) * static_cast<double>(second.size()));
  };
  std::uint64_t units = 0;
  for (const CellEdge& e : first) units += work(e);
  const std::size_t tasks = tasks_for(units, cancellation);
  MemberBitmaps targets(cancellation, scratch.helpers, cover.covered);
  share(tasks, cancellation, [&](std::size_t task, std::size_t member, Cancellation& own) {
    ParallelogramRasteriser rasteriser(targets.of(member));
    const std::size_t end = begin_of(task + 1, tasks, first.size());
    for (std::size_t i = begin_of(task, tasks, first.size()); i < end; ++i) {
      own.check(work(first[i]));
      rasteriser.mark(first[i], second);
    }
  });
  targets.unite();
}

}  // namespace minksum
