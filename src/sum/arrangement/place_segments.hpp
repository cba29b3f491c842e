// Places segments in doubles, and finds equal ones.
#pragma once

#include <bit>
#include <cmath>

#include "machine/make_room.hpp"
#include "sum/arrangement/arrangement.hpp"

namespace minksum {

/// Makes a kept segment that is not known to meet the cover.
inline KeptSegment place_segment(const Operands& o, const Segment& segment, const Clip& clip) {
  const auto& [x, y, dx, dy, next] = o.sites;
  const auto& [e, v] = segment;
  const SiteId f = next[e];
  const DirectionRank rank = o.rank[e];
  const std::uint32_t line = std::min(o.place[rank], o.reverse_place[rank]);
  return {{x[e] + x[v], y[e] + y[v]},
          {x[f] + x[v], y[f] + y[v]},
          {dx[e], dy[e]},
          segment,
          0,
          line,
          rank,
          false,
          clip};
}

/// A segment's line in units of cells.
struct CellLine {
  Vec<double> start;
  double rise;  ///< height / width, or 0 where that would magnify rounding much
  explicit CellLine(const KeptSegment& s, double inverse)
      : start{s.a.x * inverse, s.a.y * inverse}, rise(0) {
    const double width = (s.b.x - s.a.x) * inverse;
    const double height = (s.b.y - s.a.y) * inverse;
    const bool flat = std::abs(height) <= 4 * std::abs(width);
    if (flat && std::abs(width) > UniformGrid::kMargin) rise = height / width;
  }
  [[nodiscard]] double height_at(double x) const { return start.y + (x - start.x) * rise; }
};

/// Finds segments that are equal, direction included. Doubles must hold their ends exactly.
class DuplicateFinder {
 public:
  DuplicateFinder(std::vector<KeptId>& table, const std::vector<KeptSegment>& kept,
                  Cancellation& cancellation)
      : table_(table), kept_(kept), cancellation_(cancellation) {
    table_.assign(kSmallest, kEmpty);
  }
  /// Whether an equal of the last kept segment was seen before. Must be called in turn for each
  /// segment that may have an equal. A segment that was seen must be removed.
  bool seen() {
    if (2 * kept_.size() > table_.size()) grow();
    return enter(static_cast<KeptId>(kept_.size() - 1));
  }

 private:
  static constexpr KeptId kEmpty = 0xFFFFFFFFU;
  static constexpr std::size_t kSmallest = 256;

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
    assign_in_pieces(table_, std::bit_ceil(4 * kept_.size()), kEmpty, cancellation_);
    for (KeptId id = 0; id + 1 < kept_.size(); ++id) {
      cancellation_.check(4);
      enter(id);
    }
  }
  static std::size_t hash(const KeptSegment& s) {
    // Negative zero equals zero, and must have its hash: + 0.0 turns it into zero.
    const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value + 0.0); };
    const std::uint64_t h = bits(s.a.x) * 0x9E3779B97F4A7C15U + bits(s.a.y) * 0xC2B2AE3D27D4EB4FU +
                            bits(s.b.x) * 0xFF51AFD7ED558CCDU + bits(s.b.y) * 0xD6E8FEB86659FD93U;
    return static_cast<std::size_t>((h ^ h >> 32) * 0x9E3779B97F4A7C15U >> 20);
  }
  std::vector<KeptId>& table_;
  const std::vector<KeptSegment>& kept_;
  Cancellation& cancellation_;
};

}  // namespace minksum
