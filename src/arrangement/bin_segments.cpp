// Which segments touch uncovered cells, and which cells.
#include <bit>
#include <cmath>

#include "arrangement/arrangement.hpp"

namespace minksum {
namespace {

/// Finds segments that are equal as directed segments, where doubles hold them exactly.
class DuplicateFinder {
 public:
  DuplicateFinder(std::vector<KeptId>& table, const std::vector<KeptSegment>& kept)
      : table_(table), kept_(kept) {
    table_.assign(kSmallest, kEmpty);
  }
  /// Whether a segment equal to the last one was seen before. To be asked for each in turn; those
  /// that were are to be taken away.
  bool seen() {
    if (2 * kept_.size() > table_.size()) grow();
    return enter(static_cast<KeptId>(kept_.size() - 1));
  }

 private:
  static constexpr KeptId kEmpty = 0xFFFFFFFFU;
  static constexpr std::size_t kSmallest = 1024;

  bool enter(KeptId id) {
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
  void grow() {
    table_.assign(4 * table_.size(), kEmpty);
    for (KeptId id = 0; id + 1 < kept_.size(); ++id) enter(id);
  }
  static std::size_t hash(const KeptSegment& s) {
    // + 0.0 turns a negative zero, equal to zero, into zero.
    const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value + 0.0); };
    const std::uint64_t h = bits(s.a.x) * 0x9E3779B97F4A7C15U + bits(s.a.y) * 0xC2B2AE3D27D4EB4FU +
                            bits(s.b.x) * 0xFF51AFD7ED558CCDU + bits(s.b.y) * 0xD6E8FEB86659FD93U;
    return static_cast<std::size_t>((h ^ h >> 32) * 0x9E3779B97F4A7C15U >> 20);
  }
  std::vector<KeptId>& table_;
  const std::vector<KeptSegment>& kept_;
};

class Binner {
 public:
  Binner(const Operands& o, const Cover& cover, ArrangementScratch& scratch,
         Arrangement& arrangement)
      : o_(o), cover_(cover), grid_(cover.grid), items_(scratch.items), scratch_(scratch),
        kept_(arrangement.kept) {}

  void run(const Convolution& convolution) {
    kept_.clear();
    items_.clear();
    const bool exact_sums = o_.bounds.difference == 0;
    DuplicateFinder duplicates(scratch_.hash_table, kept_);
    const auto& [x, y, dx, dy, next] = o_.sites;
    for (const Segment& segment : convolution.segments) {
      const SiteId e = segment.edge;
      const SiteId f = next[e];
      const SiteId v = segment.vertex;
      const Vec<double> a{x[e] + x[v], y[e] + y[v]};
      const Vec<double> b{x[f] + x[v], y[f] + y[v]};
      if (cover_.hides(a, b)) continue;
      const std::size_t first_item = items_.size();
      const bool meets_cover = list_cells(a, b, static_cast<KeptId>(kept_.size()));
      if (items_.size() == first_item) continue;
      const DirectionRank rank = o_.rank[e];
      const std::uint32_t line = std::min(o_.place[rank], o_.reverse_place[rank]);
      kept_.push_back({a, b, {dx[e], dy[e]}, segment, line, meets_cover});
      if (exact_sums && duplicates.seen()) {
        kept_.pop_back();
        items_.resize(first_item);
      }
    }
    sort_by_cells();
  }

 private:
  /// Appends an item for each uncovered cell; whether there were covered ones as well.
  bool list_cells(const Vec<double>& a, const Vec<double>& b, KeptId id) {
    constexpr double kMargin = UniformGrid::kMargin;
    const auto columns = static_cast<std::uint32_t>(grid_.columns);
    const Vec<double> start{a.x * grid_.inverse, a.y * grid_.inverse};
    const double width = (b.x - a.x) * grid_.inverse;
    const double height = (b.y - a.y) * grid_.inverse;
    // Heights from widths only where that does not magnify their rounding much.
    const bool flat = std::abs(height) <= 4 * std::abs(width) && std::abs(width) > kMargin;
    const double rise = flat ? height / width : 0;
    bool meets_cover = false;
    grid_.walk_rows(a, b, kMargin, [&](const UniformGrid::RowSpan& span) {
      for (std::int32_t i = span.left; i <= span.right; ++i) {
        if (cover_.is_covered(i, span.row)) {
          meets_cover = true;
          continue;
        }
        const double x0 = std::max(span.x0, i - kMargin);
        const double x1 = std::min(span.x1, i + 1 + kMargin);
        double y0 = span.y0;
        double y1 = span.y1;
        if (flat) {
          const double at_x0 = start.y + (x0 - start.x) * rise;
          const double at_x1 = start.y + (x1 - start.x) * rise;
          y0 = std::max(y0, std::min(at_x0, at_x1));
          y1 = std::min(y1, std::max(at_x0, at_x1));
        }
        items_.push_back({CellBox(x0 - i, y0 - span.row, x1 - i, y1 - span.row),
                          static_cast<std::uint32_t>(span.row) * columns +
                              static_cast<std::uint32_t>(i),
                          id});
      }
      return true;
    });
    return meets_cover;
  }

  /// A counting sort that looks at no cells but those that have items.
  void sort_by_cells() {
    auto& cells = scratch_.cells;
    auto& end = scratch_.cell_end;
    for (const std::uint32_t cell : cells) end[cell] = 0;
    cells.clear();
    const auto cell_count = static_cast<std::size_t>(grid_.size());
    if (end.size() < cell_count) end.resize(cell_count, 0);
    for (const CellItem& item : items_) {
      if (end[item.cell] == 0) cells.push_back(item.cell);
      ++end[item.cell];
    }
    std::uint32_t begin = 0;
    for (const std::uint32_t cell : cells) begin += std::exchange(end[cell], begin);
    scratch_.in_cells.resize(items_.size());
    for (const CellItem& item : items_) scratch_.in_cells[end[item.cell]++] = item;
  }

  const Operands& o_;
  const Cover& cover_;
  const UniformGrid& grid_;
  std::vector<CellItem>& items_;
  ArrangementScratch& scratch_;
  std::vector<KeptSegment>& kept_;
};

}  // namespace

void bin_segments(const Operands& operands, const Convolution& convolution, const Cover& cover,
                  ArrangementScratch& scratch, Arrangement& arrangement) {
  Binner(operands, cover, scratch, arrangement).run(convolution);
}

}  // namespace minksum
