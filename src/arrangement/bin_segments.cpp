// Which segments touch uncovered cells, and which cells.
#include <bit>

#include "arrangement/arrangement.hpp"

namespace minksum {
namespace {

/// Finds segments that are equal as directed segments, where doubles hold them exactly.
class DuplicateFinder {
 public:
  DuplicateFinder(std::vector<KeptId>& table, const std::vector<KeptSegment>& kept,
                  std::size_t segments)
      : table_(table), kept_(kept) {
    table_.assign(std::bit_ceil(std::max<std::size_t>(2 * segments, 16)), kEmpty);
  }
  /// Whether an equal segment was entered before; enters `id` if not.
  bool seen(KeptId id) {
    const KeptSegment& s = kept_[id];
    const std::size_t mask = table_.size() - 1;
    for (std::size_t slot = hash(s) & mask;; slot = (slot + 1) & mask) {
      if (table_[slot] == kEmpty) {
        table_[slot] = id;
        return false;
      }
      const KeptSegment& t = kept_[table_[slot]];
      if (s.a.x == t.a.x && s.a.y == t.a.y && s.b.x == t.b.x && s.b.y == t.b.y) return true;
    }
  }

 private:
  static constexpr KeptId kEmpty = 0xFFFFFFFFU;
  static std::size_t hash(const KeptSegment& s) {
    std::uint64_t h = 0;
    // + 0.0 turns a negative zero, equal to zero, into zero.
    for (const double value : {s.a.x, s.a.y, s.b.x, s.b.y}) {
      h = (h ^ std::bit_cast<std::uint64_t>(value + 0.0)) * 0x9E3779B97F4A7C15U;
      h ^= h >> 29;
    }
    return static_cast<std::size_t>(h);
  }
  std::vector<KeptId>& table_;
  const std::vector<KeptSegment>& kept_;
};

}  // namespace

void bin_segments(const Operands& o, const Convolution& convolution, const Cover& cover,
                  ArrangementScratch& scratch, Arrangement& arrangement) {
  const UniformGrid& grid = cover.grid;
  const auto columns = static_cast<std::uint32_t>(grid.columns);
  auto& kept = arrangement.kept;
  auto& entries = scratch.cell_entries;
  kept.clear();
  entries.clear();
  const bool exact_sums = o.bounds.difference == 0;
  DuplicateFinder duplicates(scratch.hash_table, kept, convolution.segments.size());
  const auto& [x, y, dx, dy, next] = o.sites;
  for (const Segment& segment : convolution.segments) {
    const SiteId e = segment.edge;
    const SiteId f = next[e];
    const SiteId v = segment.vertex;
    const Vec<double> a{x[e] + x[v], y[e] + y[v]};
    const Vec<double> b{x[f] + x[v], y[f] + y[v]};
    if (cover.hides(a, b)) continue;
    const auto id = static_cast<KeptId>(kept.size());
    const std::size_t first_entry = entries.size();
    grid.walk(a, b, UniformGrid::kMargin, [&](std::int32_t i, std::int32_t j) {
      if (!cover.is_covered(i, j)) {
        entries.emplace_back(static_cast<std::uint32_t>(j) * columns +
                                 static_cast<std::uint32_t>(i), id);
      }
      return true;
    });
    if (entries.size() == first_entry) continue;
    kept.push_back({a, b, {dx[e], dy[e]}, segment});
    if (exact_sums && duplicates.seen(id)) {
      kept.pop_back();
      entries.resize(first_entry);
    }
  }
  auto& begin = scratch.cell_begin;
  begin.assign(static_cast<std::size_t>(grid.size()) + 2, 0);
  for (const auto& [cell, id] : entries) ++begin[cell + 2];
  for (std::size_t c = 2; c < begin.size(); ++c) begin[c] += begin[c - 1];
  scratch.in_cells.resize(entries.size());
  for (const auto& [cell, id] : entries) scratch.in_cells[begin[cell + 1]++] = id;
  begin.pop_back();
}

}  // namespace minksum
