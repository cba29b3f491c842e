#include "sum/arrangement/visible_segments.hpp"

#include <algorithm>
#include <bit>
#include <string>

#include "machine/exceeded.hpp"
#include "machine/share_by_key.hpp"
#include "spatial/uniform_grid.hpp"

namespace minksum {
namespace {

// Boxes are sums of two boxes, in cells and in single precision. Numbers are below 2^13, so a sum
// is off by at most three times 2^-12. That is below the margin of 3 · kMargin around covered
// cells, which lies inside the sum too.
static_assert(UniformGrid::kMaxSide <= 1 << 13);

/// Recognises boxes that lie wholly in covered cells, most of them by one look at a bitmap.
///
/// Take the block of 2^k by 2^k cells that starts at the lower left cell of a box. If the box is no
/// larger and the block is covered, the box lies in covered cells.
class CoveredBlocks {
 public:
  CoveredBlocks(const Cover& cover, const UncoveredRows& uncovered,
                std::array<Bitmap, VisibleScratch::kLevels>& blocks)
      : uncovered_(uncovered),
        words_(cover.covered.words_per_row()),
        last_row_(cover.grid.rows - 1) {
    const Bitmap* smaller = &cover.covered;
    bits_[0] = smaller->row(0);
    for (std::size_t k = 1; k <= VisibleScratch::kLevels; ++k) {
      unite_blocks(*smaller, 1 << (k - 1), blocks[k - 1]);
      smaller = &blocks[k - 1];
      bits_[k] = smaller->row(0);
    }
  }
  /// Whether the segment of an edge and a vertex lies in covered cells with its box. A box that is
  /// no larger than a block may do so without being recognised.
  [[nodiscard]] bool hides(const CellSite& edge, const CellSite& vertex) const {
    const auto i0 = static_cast<std::int32_t>(edge.box.x0 + vertex.x);
    const auto j0 = static_cast<std::int32_t>(edge.box.y0 + vertex.y);
    const auto i1 = static_cast<std::int32_t>(edge.box.x1 + vertex.x);
    const auto j1 = static_cast<std::int32_t>(edge.box.y1 + vertex.y);
    const auto spread = static_cast<std::uint32_t>((i1 - i0) | (j1 - j0));
    const auto level = static_cast<std::size_t>(std::bit_width(spread));
    if (level >= bits_.size()) return uncovered_.none_in(i0, j0, i1, j1);
    // Rows have room for a column more than the grid has.
    const auto word = static_cast<std::size_t>(std::min(j0, last_row_)) * words_ +
                      static_cast<std::size_t>(i0 >> 6);
    return ((bits_[level][word] >> (i0 & 63)) & 1) != 0;
  }

 private:
  const UncoveredRows& uncovered_;
  std::size_t words_;
  std::int32_t last_row_;
  std::array<const std::uint64_t*, VisibleScratch::kLevels + 1> bits_{};
};

/// Whether the sum of two boxes lies wholly in covered cells.
[[nodiscard]] bool hides(const UncoveredRows& uncovered, const CellBounds& a, const CellBounds& b) {
  const auto cell = [](float x) { return static_cast<std::int32_t>(x); };
  return uncovered.none_in(cell(a.x0 + b.x0), cell(a.y0 + b.y0), cell(a.x1 + b.x1),
                           cell(a.y1 + b.y1));
}

void measure_sites(const Operands& o, const UniformGrid& grid, std::vector<CellSite>& sites) {
  const auto& [x, y, dx, dy, next] = o.sites;
  const auto columns = [&](double value) { return static_cast<float>(value * grid.inverse.x); };
  const auto rows = [&](double value) { return static_cast<float>(value * grid.inverse.y); };
  sites.resize(o.size());
  for (SiteId v = 0; v < o.size(); ++v) {
    const float ax = columns(x[v]);
    const float ay = rows(y[v]);
    const float bx = columns(x[next[v]]);
    const float by = rows(y[next[v]]);
    sites[v] = {ax, ay, {std::min(ax, bx), std::min(ay, by), std::max(ax, bx), std::max(ay, by)}};
  }
}

CellBounds point_box(const CellSite& site) { return {site.x, site.y, site.x, site.y}; }

/// The circle of ranks.
class RankCircle {
 public:
  explicit RankCircle(DirectionRank count) : count_(count) {}
  /// Returns how many ranks the counter-clockwise way takes.
  [[nodiscard]] DirectionRank way(DirectionRank from, DirectionRank to) const {
    return to >= from ? to - from : to + count_ - from;
  }
  [[nodiscard]] bool meet(const RankRange& a, const RankRange& b) const {
    const int in_a = way(a.from, b.from) < a.length ? 1 : 0;
    const int in_b = way(b.from, a.from) < b.length ? 1 : 0;
    return std::min(a.length, b.length) != 0 && (in_a | in_b) != 0;
  }
  /// Returns the shorter of the two ranges that contain both given ones and begin as one of them.
  [[nodiscard]] RankRange unite(const RankRange& a, const RankRange& b) const {
    const DirectionRank from_a = std::max(a.length, way(a.from, b.from) + b.length);
    const DirectionRank from_b = std::max(b.length, way(b.from, a.from) + a.length);
    return from_a <= from_b ? RankRange{a.from, std::min(from_a, count_)}
                            : RankRange{b.from, std::min(from_b, count_)};
  }

 private:
  DirectionRank count_;
};

class TreeBuilder {
 public:
  TreeBuilder(const Operands& o, const RankCircle& circle, VisibleScratch& scratch)
      : o_(o), circle_(circle), scratch_(scratch) {}

  void edges_of(int operand) {
    build(operand, scratch_.edges, [&](SiteId e) {
      return SiteRun{scratch_.sites[e].box, {o_.rank[e], 1}};
    });
  }
  void vertices_of(int operand) {
    build(operand, scratch_.vertices, [&](SiteId v) {
      return SiteRun{point_box(scratch_.sites[v]), scratch_.ranges[v]};
    });
  }

 private:
  static constexpr SiteRun kNothing{{0, 0, 0, 0}, {0, 0}};

  template <class RunOf>
  void build(int operand, RunTree& tree, RunOf run_of) const {
    tree.begin = operand == 0 ? 0 : o_.split;
    tree.end = operand == 0 ? o_.split : o_.size();
    auto& runs = tree.runs;
    runs.clear();
    tree.level_begin.assign(1, 0);
    for (SiteId first = tree.begin; first < tree.end; first += RunTree::kLeaf) {
      SiteRun leaf = kNothing;
      const SiteId last = std::min(first + RunTree::kLeaf, tree.end);
      for (SiteId v = first; v < last; ++v) leaf = unite(leaf, run_of(v));
      runs.push_back(leaf);
    }
    for (std::size_t first = 0; runs.size() - first > 1;) {
      if ((runs.size() - first) % 2 != 0) runs.push_back(kNothing);
      const std::size_t last = runs.size();
      tree.level_begin.push_back(static_cast<std::uint32_t>(last));
      for (std::size_t i = first; i < last; i += 2) runs.push_back(unite(runs[i], runs[i + 1]));
      first = last;
    }
  }
  [[nodiscard]] SiteRun unite(const SiteRun& a, const SiteRun& b) const {
    if (a.directions.length == 0) return b;
    if (b.directions.length == 0) return a;
    SiteRun both{a.box, circle_.unite(a.directions, b.directions)};
    both.box.add(b.box);
    return both;
  }

  const Operands& o_;
  const RankCircle& circle_;
  VisibleScratch& scratch_;
};

void limit_visible(std::size_t segments, std::uint64_t most) {
  if (segments <= most) return;
  throw exceeded("Limits::max_segments", most, "the convolution has", "visible segments");
}

/// Finds visible segments of one operand's edges at the other's vertices, pairs of runs at a time.
class RunSearch {
 public:
  RunSearch(const Operands& o, const RankCircle& circle, const UncoveredRows& uncovered,
            std::uint64_t most, const VisibleScratch& scratch)
      : o_(o),
        circle_(circle),
        uncovered_(uncovered),
        most_(most),
        trees_{&scratch.edges, &scratch.vertices},
        scratch_(scratch) {}

  /// Lists pairs of runs that hold all visible segments: one, or as many as are wanted.
  void begin(std::size_t wanted, std::vector<RunPair>& pairs) const {
    pairs.resize(1);
    for (const std::size_t i : {0U, 1U}) {
      pairs[0].level[i] = static_cast<std::uint32_t>(trees_[i]->level_begin.size()) - 1;
      pairs[0].run[i] = trees_[i]->level_begin.back();
    }
    std::size_t first = 0;
    for (; pairs.size() - first < wanted && first < pairs.size() && !is_leaf(pairs[first]);
         ++first) {
      const std::size_t count = pairs.size();
      pairs.resize(count + 2);
      pairs.resize(divide(RunPair{pairs[first]}, pairs, count));
    }
    pairs.erase(pairs.begin(), pairs.begin() + static_cast<std::ptrdiff_t>(first));
  }
  /// Appends the visible segments of a pair of runs to `memory.found`.
  void run(const RunPair& whole, Cancellation& cancellation, RunScratch& memory) const {
    auto& pairs = memory.pairs;
    std::size_t count = 1;
    pairs.resize(std::max<std::size_t>(pairs.size(), 1));
    pairs[0] = whole;
    while (count > 0) {
      cancellation.check(16);
      const RunPair pair = pairs[--count];
      if (is_leaf(pair)) {
        list(pair.run[0], pair.run[1], memory.found);
        continue;
      }
      if (pairs.size() < count + 2) pairs.resize(2 * (count + 2));
      count = divide(pair, pairs, count);
    }
  }

 private:
  [[nodiscard]] static bool is_leaf(const RunPair& pair) {
    return (pair.level[0] | pair.level[1]) == 0;
  }
  /// Puts the parts of a pair that may have visible segments into `pairs`, from `count` on. Returns
  /// where they end.
  [[gnu::always_inline]] std::size_t divide(const RunPair& pair, std::vector<RunPair>& pairs,
                                            std::size_t count) const {
    const std::size_t larger = choose(pair);
    const std::size_t other = 1 - larger;
    const RunTree& tree = *trees_[larger];
    const std::uint32_t level = pair.level[larger] - 1;
    const std::uint32_t first =
        tree.level_begin[level] + 2 * (pair.run[larger] - tree.level_begin[level + 1]);
    const SiteRun& fixed = trees_[other]->runs[pair.run[other]];
    // There is no branch on which parts stay, because that is hard to predict.
    for (const std::uint32_t part : {first, first + 1}) {
      pairs[count] = pair;
      pairs[count].run[larger] = part;
      pairs[count].level[larger] = level;
      count += may_be_visible(tree.runs[part], fixed) ? 1U : 0U;
    }
    return count;
  }
  [[nodiscard]] bool may_be_visible(const SiteRun& a, const SiteRun& b) const {
    const int meet = circle_.meet(a.directions, b.directions) ? 1 : 0;
    const int hidden = hides(uncovered_, a.box, b.box) ? 1 : 0;
    return (meet & ~hidden) != 0;
  }
  [[nodiscard]] std::size_t choose(const RunPair& pair) const {
    const auto extent = [&](std::size_t i) {
      const CellBounds& box = trees_[i]->runs[pair.run[i]].box;
      return pair.level[i] == 0 ? -1.0F : std::max(box.x1 - box.x0, box.y1 - box.y0);
    };
    return extent(0) >= extent(1) ? 0 : 1;
  }
  void list(std::uint32_t edge_leaf, std::uint32_t vertex_leaf, std::vector<Segment>& found) const {
    const SiteId first_edge = scratch_.edges.begin + edge_leaf * RunTree::kLeaf;
    const SiteId edges = std::min(RunTree::kLeaf, scratch_.edges.end - first_edge);
    const SiteId first_vertex = scratch_.vertices.begin + vertex_leaf * RunTree::kLeaf;
    const SiteId last_vertex = std::min(first_vertex + RunTree::kLeaf, scratch_.vertices.end);
    std::array<DirectionRank, RunTree::kLeaf> rank{};
    std::copy_n(o_.rank.begin() + first_edge, edges, rank.begin());
    const std::uint32_t all = (1U << edges) - 1;
    for (SiteId v = first_vertex; v < last_vertex; ++v) {
      const RankRange range = scratch_.ranges[v];
      std::uint32_t met = 0;
      for (SiteId i = 0; i < RunTree::kLeaf; ++i) {
        met |= (circle_.way(range.from, rank[i]) < range.length ? 1U : 0U) << i;
      }
      const CellBounds vertex = point_box(scratch_.sites[v]);
      for (met &= all; met != 0; met &= met - 1) {
        const SiteId e = first_edge + static_cast<SiteId>(std::countr_zero(met));
        if (hides(uncovered_, scratch_.sites[e].box, vertex)) continue;
        if (o_.on_hole[e] != 0 && o_.on_hole[v] != 0) continue;
        if (o_.equal && is_copy(o_, {e, v})) continue;
        found.push_back({e, v});
      }
    }
    limit_visible(found.size(), most_);
  }

  const Operands& o_;
  const RankCircle& circle_;
  const UncoveredRows& uncovered_;
  std::uint64_t most_;
  std::array<const RunTree*, 2> trees_;
  const VisibleScratch& scratch_;
};

/// Orders segments by vertex, and those of a vertex from the first direction that it meets.
void order_as_listed(const Operands& o, const RankCircle& circle, Cancellation& cancellation,
                     VisibleScratch& scratch) {
  auto& begin = scratch.begin;
  auto& ordered = scratch.visible;
  share_by_key(
      o.size(), scratch.searches.size(),
      [&](std::size_t i) -> const auto& { return scratch.searches[i].found; },
      [](std::size_t, const Segment& s) { return std::pair(s.vertex, s); }, cancellation, begin,
      ordered);
  constexpr std::uint64_t kUnitsOfSegment = 16;  // it is compared with some others
  const std::uint64_t units = kUnitsOfSegment * ordered.size() / o.size();
  share_each(o.size(), units, cancellation, [&](std::size_t v, Cancellation& own) {
    const auto before = [&](const Segment& a, const Segment& b) {
      const DirectionRank way_a = circle.way(scratch.ranges[v].from, o.rank[a.edge]);
      const DirectionRank way_b = circle.way(scratch.ranges[v].from, o.rank[b.edge]);
      return way_a != way_b ? way_a < way_b : a.edge < b.edge;
    };
    sort_in_pieces(ordered.begin() + begin[v], ordered.begin() + begin[v + 1], own, before);
  });
}

std::span<const Segment> list_visible(const Operands& o, std::span<const Segment> segments,
                                      const Cover& cover, Cancellation& cancellation,
                                      VisibleScratch& scratch) {
  const auto& sites = scratch.sites;
  auto& visible = scratch.visible;
  resize_in_pieces(visible, segments.size(), cancellation);
  const CoveredBlocks covered(cover, scratch.uncovered, scratch.blocks);
  const std::size_t tasks = tasks_for(segments.size(), cancellation);
  const auto first_of = [&](std::size_t task) { return begin_of(task, tasks, segments.size()); };
  scratch.end_of_task.resize(tasks);
  share(tasks, cancellation, [&](std::size_t task, std::size_t, Cancellation& own) {
    std::size_t end = first_of(task);
    // There is no branch on which segments are hidden, because that is hard to predict.
    visit_in_pieces(segments.subspan(end, first_of(task + 1) - end), own,
                    [&](const Segment& segment) {
                      visible[end] = segment;
                      const bool hidden = covered.hides(sites[segment.edge], sites[segment.vertex]);
                      const bool copy = o.equal && is_copy(o, segment);
                      end += (hidden | copy) ? 0U : 1U;
                    });
    scratch.end_of_task[task] = end;
  });
  std::size_t count = scratch.end_of_task[0];
  for (std::size_t task = 1; task < tasks; ++task) {
    visit_in_pieces(
        std::span(visible).subspan(first_of(task), scratch.end_of_task[task] - first_of(task)),
        cancellation, [&](const Segment& segment) { visible[count++] = segment; });
  }
  visible.resize(count);
  return visible;
}

}  // namespace

std::span<const Segment> visible_segments(const Operands& operands, const Convolution& convolution,
                                          const Cover& cover, const Limits& limits,
                                          Cancellation& cancellation, VisibleScratch& scratch) {
  constexpr std::uint64_t kUnitsOfSite = 32;  // a site's runs meet some others, in 300 ns
  cancellation.check(operands.size());
  measure_sites(operands, cover.grid, scratch.sites);
  scratch.uncovered.unite(cover, cancellation);
  if (convolution.listed()) {
    return list_visible(operands, convolution.segments, cover, cancellation, scratch);
  }
  scratch.ranges.resize(operands.size());
  for (SiteId v = 0; v < operands.size(); ++v) {
    scratch.ranges[v] = operands.convex[v] != 0 ? reduced_range(operands, v) : RankRange{0, 0};
  }
  const RankCircle circle(operands.rank_count);
  TreeBuilder builder(operands, circle, scratch);
  scratch.searches.resize(std::max(scratch.searches.size(), members_of(cancellation)));
  for (RunScratch& search : scratch.searches) search.found.clear();
  const std::uint64_t most = std::min(limits.max_segments, kMostNumbered);
  const std::size_t tasks = tasks_for(kUnitsOfSite * operands.size(), cancellation);
  for (const int operand : {0, 1}) {
    builder.edges_of(1 - operand);
    builder.vertices_of(operand);
    const RunSearch search(operands, circle, scratch.uncovered, most, scratch);
    search.begin(tasks, scratch.pairs);
    share(scratch.pairs.size(), cancellation,
          [&](std::size_t task, std::size_t member, Cancellation& own) {
            search.run(scratch.pairs[task], own, scratch.searches[member]);
          });
    std::size_t found = 0;
    for (const RunScratch& one : scratch.searches) found += one.found.size();
    limit_visible(found, most);
  }
  order_as_listed(operands, circle, cancellation, scratch);
  return scratch.visible;
}

}  // namespace minksum
