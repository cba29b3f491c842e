// Estimates from a sample what a cover leaves of the segments.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "machine/team.hpp"
#include "sum/cover/cover.hpp"

namespace minksum {
namespace {

/// Returns the vector from a line's start to its end.
Vec<double> way(const Line& line) { return {line.end.x - line.start.x, line.end.y - line.start.y}; }
BoxOf<double> box_of(const Line& line) {
  const auto& [a, b] = line;
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y)};
}

struct MeetingsSeen {
  double near_pairs = 0;
  double near_in_uncovered = 0;
  double crossings = 0;
  std::uint64_t overlaps = 0;  ///< pairs that can be joined
};

/// Counts pairs of lines: those whose boxes overlap, those of them with the middle of the overlap
/// in an uncovered cell, those that cross in an uncovered cell, but not near an end, and those that
/// can be joined. A pair counts as often as the product of `weight_of(i)` of both.
template <class WeightOf>
MeetingsSeen count_meetings(std::span<const Line> lines, const Cover& cover, WeightOf weight_of,
                            CoverScratch& scratch) {
  constexpr double kEnd = 0x1p-20;
  MeetingsSeen count;
  auto& boxes = scratch.boxes;
  boxes.clear();
  const auto is_uncovered = [&](double x, double y) {
    return !cover.is_covered(cover.grid.column(x), cover.grid.row(y));
  };
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Vec<double>& a = lines[i].start;
    const BoxOf<double> box = box_of(lines[i]);
    for (std::size_t j = 0; j < i; ++j) {
      if (!box.meets(boxes[j])) continue;
      const double weight = weight_of(i) * weight_of(j);
      count.near_pairs += weight;
      const BoxOf<double>& other = boxes[j];
      if (is_uncovered((std::max(box.x0, other.x0) + std::min(box.x1, other.x1)) / 2,
                       (std::max(box.y0, other.y0) + std::min(box.y1, other.y1)) / 2)) {
        count.near_in_uncovered += weight;
      }
      const Vec<double> u = way(lines[i]);
      const Vec<double> v = way(lines[j]);
      const Vec<double> w = way({a, lines[j].start});
      const double area = cross(u, v);
      if (area == 0) {
        count.overlaps += cross(w, u) == 0 && dot(u, v) > 0;
        continue;
      }
      const double at_u = cross(w, v) / area;
      const double at_v = cross(w, u) / area;
      if (!(at_u > kEnd && at_u < 1 - kEnd && at_v > kEnd && at_v < 1 - kEnd)) continue;
      if (is_uncovered(a.x + at_u * u.x, a.y + at_u * u.y)) count.crossings += weight;
    }
    boxes.push_back(box);
  }
  return count;
}

/// Joins lines that overlap on one line in one direction, as the arrangement does. Each line stands
/// for `each` segments. A line to which others were joined stands for one: it has the segments
/// beyond the sample as parts, too.
void join_overlaps(std::vector<Line>& lines, double each, std::vector<double>& weights) {
  weights.clear();
  for (const Line line : lines) {
    const Vec<double> u = way(line);
    const BoxOf<double> box = box_of(line);
    const auto joins = [&](const Line& other) {
      const Vec<double> v = way(other);
      return cross(u, v) == 0 && cross(u, way({line.start, other.start})) == 0 && dot(u, v) > 0 &&
             box.meets(box_of(other));
    };
    std::size_t k = 0;
    while (k < weights.size() && !joins(lines[k])) ++k;
    if (k == weights.size()) {
      lines[k] = line;
      weights.push_back(each);
      continue;
    }
    auto& [start, end] = lines[k];
    if (dot(u, way({line.start, start})) > 0) start = line.start;
    if (dot(u, way({end, line.end})) > 0) end = line.end;
    weights[k] = 1;
  }
  lines.resize(weights.size());
}

}  // namespace

CellsNear cells_near(const Cover& cover, const Line& line, Until until) {
  CellsNear near;
  cover.grid.walk_rows(line.start, line.end, UniformGrid::kMargin, [&](const auto& span) {
    cover.covered.visit_words(span.row, span.left, span.right,
                              [&](std::int32_t, std::uint64_t covered, std::uint64_t wanted) {
                                near.covered |= (covered & wanted) != 0;
                                near.uncovered |= (wanted & ~covered) != 0;
                              });
    ++near.rows;
    return (until != Until::kCovered && !near.uncovered) ||
           (until != Until::kUncovered && !near.covered);
  });
  return near;
}

bool is_hidden(const Cover& cover, const UncoveredRows& uncovered, const Line& line) {
  const auto& [start, end] = line;
  const UniformGrid& grid = cover.grid;
  const Vec<double> middle{(start.x + end.x) / 2, (start.y + end.y) / 2};
  const auto is_uncovered = [&](const Vec<double>& at) {
    return !cover.covered.get(grid.column(at.x), grid.row(at.y));
  };
  if (is_uncovered(start) || is_uncovered(end) || is_uncovered(middle)) return false;
  const auto first = [](double a, double b, double inverse) {
    return static_cast<std::int32_t>(std::min(a, b) * inverse - 2 * UniformGrid::kMargin);
  };
  const auto last = [](double a, double b, double inverse) {
    return static_cast<std::int32_t>(std::max(a, b) * inverse + 2 * UniformGrid::kMargin);
  };
  const std::int32_t bottom = first(start.y, end.y, grid.inverse.y);
  const std::int32_t top = last(start.y, end.y, grid.inverse.y);
  const std::int32_t left = first(start.x, end.x, grid.inverse.x);
  const std::int32_t right = last(start.x, end.x, grid.inverse.x);
  if (uncovered.none_in(left, bottom, right, top)) return true;
  // In so few rows, the line's cells are a few words. Its halves may be in as many rows.
  constexpr std::int32_t kFewRows = 3;
  if (top - bottom < kFewRows) return !cells_near(cover, line, Until::kUncovered).uncovered;
  return is_hidden(cover, uncovered, {start, middle}) && is_hidden(cover, uncovered, {middle, end});
}

Sample take_sample(const Operands& operands, const Convolution& convolution,
                   CoverScratch& scratch) {
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
  const auto& [x, y, dx, dy, next] = operands.sites;
  auto& lines = scratch.lines;
  lines.clear();
  for (const auto& [e, v] : sample) {
    const SiteId f = next[e];
    lines.push_back({{x[e] + x[v], y[e] + y[v]}, {x[f] + x[v], y[f] + y[v]}});
  }
  return {lines, static_cast<double>(convolution.size) / static_cast<double>(count)};
}

ClippedShare see_clipped(const Operands& operands, const Sample& sample, Cancellation& cancellation,
                         const CoverScratch& scratch) {
  const auto length_of = [](const Line& line) {
    return std::abs(line.end.x - line.start.x) + std::abs(line.end.y - line.start.y);
  };
  const SegmentClipper clipper(operands);
  // With all 4,096 of a large sample, sums of random polygons took up to a tenth longer.
  constexpr std::size_t kMost = 256;
  const auto step = std::max(static_cast<std::size_t>(std::max(1.0, 16 / sample.step)),
                             sample.lines.size() / kMost);
  double count = 0;
  double length = 0;
  double kept = 0;
  double kept_length = 0;
  for (std::size_t i = step / 2; i < sample.lines.size(); i += step) {
    cancellation.check(SegmentClipper::kUnits);
    const Clip clip = clipper.clip(scratch.sample[i]);
    ++count;
    length += length_of(sample.lines[i]);
    if (clip.is_empty()) continue;
    ++kept;
    kept_length += length_of(clip.of(sample.lines[i]));
  }
  if (!(length > 0)) return {};
  return {kept / count, kept_length / length};
}

Sample clipped(const Operands& operands, const Sample& sample, Cancellation& cancellation,
               CoverScratch& scratch) {
  const SegmentClipper clipper(operands);
  auto& lines = scratch.lines;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    cancellation.check(SegmentClipper::kUnits);
    const Clip clip = clipper.clip(scratch.sample[i]);
    if (!clip.is_empty()) lines[kept++] = clip.of(lines[i]);
  }
  kept = std::max<std::size_t>(kept, 1);  // there is something to look at, whatever is left
  const double share = static_cast<double>(kept) / static_cast<double>(lines.size());
  lines.resize(kept);
  return {lines, sample.step, share};
}

double Sample::expected_crossings(const Operands& operands) const {
  constexpr std::int32_t kSide = 32;
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
  for (const auto& [a, b] : lines) {
    across += std::abs(b.x - a.x);
    up += std::abs(b.y - a.y);
    const std::int32_t column = cell((a.x + b.x) / 2, extent.x);
    const std::int32_t row = cell((a.y + b.y) / 2, extent.y);
    pairs += in_cell[static_cast<std::size_t>(row * kSide + column)]++;
  }
  // If segments were evenly spread, one of kSide * kSide pairs would lie in one cell.
  const auto count = static_cast<double>(lines.size());
  const double unevenness = 2 * static_cast<double>(pairs) * kSide * kSide / (count * count);
  // Two segments cross once at most.
  const double all = step * count;
  return std::min(std::max(1.0, unevenness) * step * across * step * up / area, all * all / 2);
}

double lines_compared(double visible) {
  // A pair takes some 1.3 ns, and a segment that is left takes 150 ns to arrange. So many lines are
  // compared that all their pairs take a fiftieth of what arranging the visible segments takes, or
  // 0.2 ms: where more are visible, a finer grid mostly hides them.
  constexpr double kPairsForEach = 0.02 * 150 / 1.3;
  constexpr double kMost = 512;
  return std::min(std::sqrt(2 * kPairsForEach * visible), kMost);
}

Visibility look(const Sample& sample, const Cover& cover, Cancellation& cancellation,
                CoverScratch& scratch) {
  auto& visible = scratch.visible;
  visible.clear();
  double rows = 0;
  auto& lines = scratch.looked_at;
  // The sample is looked at by eighths, until enough visible lines are found to compare, or until
  // looking has taken a twentieth of what arranging takes: a quarter as many lines as are left.
  constexpr std::size_t kParts = 8;
  constexpr std::uint64_t kUnitsOfLine = 32;  // a walk along some cells
  // So many are looked at in any case. With 64, one of 870 sums took 1.37 times as long: no
  // crossing was seen where there were 1,400.
  constexpr std::size_t kFewest = 128;
  std::size_t looked_at = 0;
  double each = 0;  // how many segments one of those that were looked at stands for
  double left = 0;
  for (std::size_t part = 0; part < kParts; ++part) {
    lines.clear();
    for (std::size_t i = part; i < sample.lines.size(); i += kParts) {
      lines.push_back({sample.lines[i], true});
    }
    share_each(lines.size(), kUnitsOfLine, cancellation, [&](std::size_t i, Cancellation& own) {
      if (!cover.active) return;
      const CellsNear near = cells_near(cover, lines[i].line, Until::kUncovered);
      own.check(near.rows);
      lines[i].seen = near.uncovered;
    });
    for (const auto& [line, seen] : lines) {
      if (!seen) continue;
      visible.push_back(line);
      if (cover.active) rows += 1 + std::abs(line.end.y - line.start.y) * cover.grid.inverse.y;
    }
    looked_at += lines.size();
    each = sample.step * static_cast<double>(sample.lines.size()) / static_cast<double>(looked_at);
    left = each * static_cast<double>(visible.size());
    const bool is_cheap = looked_at < kFewest || static_cast<double>(looked_at) < left / 4;
    if (!is_cheap || static_cast<double>(visible.size()) > lines_compared(left)) break;
  }
  Visibility seen{
      .share = sample.share * static_cast<double>(visible.size()) / static_cast<double>(looked_at),
      .rows = each * rows};
  const std::size_t count =
      std::min(visible.size(), static_cast<std::size_t>(lines_compared(left)));
  if (count < 2) return seen;
  for (std::size_t i = 0; i < count; ++i) visible[i] = visible[i * visible.size() / count];
  visible.resize(count);
  const double each_compared = left / static_cast<double>(count);
  MeetingsSeen meetings = count_meetings(
      visible, cover, [&](std::size_t) { return each_compared; }, scratch);
  // Joining is for lines that overlap with two others each, on average. With a quarter or four
  // times as many overlaps, 212 sums took 0.99 and 1.01 times as long.
  if (meetings.overlaps >= count) {
    auto& weights = scratch.weights;
    join_overlaps(visible, each_compared, weights);
    meetings = count_meetings(
        visible, cover, [&](std::size_t i) { return weights[i]; }, scratch);
  }
  seen.near_pairs = meetings.near_pairs;
  seen.near_in_uncovered = meetings.near_in_uncovered;
  seen.crossings = meetings.crossings;
  return seen;
}

}  // namespace minksum
