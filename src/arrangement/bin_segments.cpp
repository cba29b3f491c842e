// Which segments touch uncovered cells, and which cells.
#include <bit>
#include <cmath>
#include <numeric>
#include <span>
#include <tuple>

#include "arrangement/place_segments.hpp"

namespace minksum {
namespace {

/// Quickly finds most of the segments that lie wholly in covered cells.
///
/// A box of up to 2^k by 2^k cells lies in the covered ones if the block of so many cells that
/// starts at its lower left cell does. Boxes are those of an edge, in cells, plus a vertex, in
/// single precision: cells are below 2^13, so that is off by at most three times 2^-12, and covered
/// cells are inside the sum with a margin of 3 · kMargin around them.
class HiddenSegments {
 public:
  [[nodiscard]] static bool covers_any(const Cover& cover) {
    const auto words = cover.covered.words();
    return cover.active &&
           std::any_of(words.begin(), words.end(), [](std::uint64_t word) { return word != 0; });
  }

  HiddenSegments(const Operands& o, const Cover& cover, BinScratch& scratch)
      : sites_(scratch.sites), active_(covers_any(cover)), last_row_(cover.grid.rows - 1) {
    if (!active_) return;
    measure_sites(o, cover.grid.inverse);
    words_ = cover.covered.words_per_row();
    bits_[0] = cover.covered.row(0);
    scratch.blocks[kLevels - 1].reset(cover.grid.columns, cover.grid.rows, words_);
    bits_[kLevels] = scratch.blocks[kLevels - 1].row(0);
    const Bitmap* smaller = &cover.covered;
    for (std::size_t k = 1; k < kLevels; ++k) {
      unite_blocks(*smaller, 1 << (k - 1), scratch.blocks[k - 1]);
      smaller = &scratch.blocks[k - 1];
      bits_[k] = smaller->row(0);
    }
  }

  /// The others. Without branches: which are hidden is hard to foresee.
  [[nodiscard]] std::span<const Segment> list_visible(const std::vector<Segment>& segments,
                                                      std::vector<Segment>& visible) const {
    if (!active_) return segments;
    visible.resize(segments.size());
    std::size_t count = 0;
    for (const Segment& segment : segments) {
      visible[count] = segment;
      count += hides(segment) ? 0U : 1U;
    }
    return std::span(visible).first(count);
  }

 private:
  static constexpr std::size_t kLevels = std::tuple_size_v<decltype(BinScratch::blocks)>;
  static_assert(UniformGrid::kMaxSide <= 1 << 13);

  [[nodiscard]] bool hides(const Segment& segment) const {
    const CellSite& e = sites_[segment.edge];
    const CellSite& v = sites_[segment.vertex];
    const auto i0 = static_cast<std::int32_t>(e.x0 + v.x);
    const auto j0 = static_cast<std::int32_t>(e.y0 + v.y);
    const auto i1 = static_cast<std::int32_t>(e.x1 + v.x);
    const auto j1 = static_cast<std::int32_t>(e.y1 + v.y);
    const auto spread = static_cast<std::uint32_t>((i1 - i0) | (j1 - j0));
    const auto level =
        std::min<std::size_t>(static_cast<std::size_t>(std::bit_width(spread)), kLevels);
    // Rows have room for a column more than the grid has.
    const auto word = static_cast<std::size_t>(std::min(j0, last_row_)) * words_ +
                      static_cast<std::size_t>(i0 >> 6);
    return ((bits_[level][word] >> (i0 & 63)) & 1) != 0;
  }
  void measure_sites(const Operands& o, double inverse) {
    const auto& [x, y, dx, dy, next] = o.sites;
    const auto cells = [&](double value) { return static_cast<float>(value * inverse); };
    sites_.resize(o.size());
    for (SiteId v = 0; v < o.size(); ++v) {
      const float ax = cells(x[v]);
      const float ay = cells(y[v]);
      const float bx = cells(x[next[v]]);
      const float by = cells(y[next[v]]);
      sites_[v] = {ax, ay, std::min(ax, bx), std::min(ay, by), std::max(ax, bx), std::max(ay, by)};
    }
  }
  /// Blocks of twice the side: four blocks of `side` each.
  static void unite_blocks(const Bitmap& blocks, std::int32_t side, Bitmap& greater) {
    const std::size_t words = blocks.words_per_row();
    greater.reset(blocks.columns(), blocks.rows(), words);
    const auto across = [&](const std::uint64_t* row, std::size_t w) {
      const std::uint64_t next = w + 1 < words ? row[w + 1] : 0;
      return row[w] & ((row[w] >> side) | (next << (64 - side)));
    };
    for (std::int32_t j = 0; j + side < blocks.rows(); ++j) {
      for (std::size_t w = 0; w < words; ++w) {
        greater.row(j)[w] = across(blocks.row(j), w) & across(blocks.row(j + side), w);
      }
    }
  }

  std::vector<CellSite>& sites_;
  bool active_;
  std::int32_t last_row_;
  std::size_t words_ = 0;
  std::array<const std::uint64_t*, kLevels + 1> bits_{};  ///< the last is clear: what is too long
};

/// How far segments go, all together.
class Extent {
 public:
  Extent(const Operands& o, const std::vector<KeptSegment>& kept)
      : width_(o.extent[0].x + o.extent[1].x), height_(o.extent[0].y + o.extent[1].y),
        count_(static_cast<double>(kept.size())) {
    for (const KeptSegment& s : kept) {
      across_ += std::abs(s.d.x);
      up_ += std::abs(s.d.y);
    }
  }
  [[nodiscard]] Vec<double> size() const { return {width_, height_}; }
  /// Cells about as wide and as high together as the segments are on average, but not more than
  /// segments.
  [[nodiscard]] UniformGrid grid() const {
    const double most = std::sqrt(count_);
    const double side = std::max(width_, height_) * count_ / (across_ + up_);
    const double kept = side >= 1 ? std::min(side, most) : 1;
    return UniformGrid::over(width_, height_, static_cast<int>(std::min(kept, 0x1p12)));
  }
  /// Whether a box overlaps few others, and few stand over each other: if they lie anywhere.
  [[nodiscard]] bool boxes_are_small() const {
    constexpr double kMostOverlaps = 8;
    constexpr double kMostInColumn = 400;
    return across_ <= kMostInColumn * width_ &&
           2 * across_ * up_ <= kMostOverlaps * count_ * width_ * height_;
  }

 private:
  double width_;
  double height_;
  double count_;
  double across_ = 0;
  double up_ = 0;
};

class Binner {
 public:
  Binner(const Operands& o, const Cover& cover, ArrangementScratch& scratch,
         Arrangement& arrangement)
      : o_(o),
        cover_(cover),
        covers_any_(HiddenSegments::covers_any(cover)),
        grid_(scratch.grid),
        items_(scratch.items),
        scratch_(scratch),
        kept_(arrangement.kept) {}

  void run(const Convolution& convolution) {
    kept_.clear();
    items_.clear();
    std::span<const Segment> visible =
        HiddenSegments(o_, cover_, scratch_.bin)
            .list_visible(convolution.segments, scratch_.bin.visible);
    if (visible.size() >= kWorthOrdering) visible = order_along_rings(visible);
    // Joining drops equal ones by itself, and doubles may not tell whether segments are equal.
    const bool joins = lines_are_joined(o_, visible.size());
    if (joins || o_.bounds.difference != 0 || !list_shared_directions()) {
      kept_.reserve(visible.size());
      for (const Segment& segment : visible) kept_.push_back(place_segment(o_, segment));
    } else {
      place_once(visible);
    }
    join_lines(o_, joins, scratch_.join, kept_);
    const Extent extent(o_, kept_);
    grid_ = covers_any_ ? cover_.grid : extent.grid();
    scratch_.swept = !covers_any_ && extent.boxes_are_small();
    scratch_.extent = extent.size();
    if (!scratch_.swept) list_all_cells();
    scratch_.line_count = static_cast<KeptId>(kept_.size());
    append_members();
    if (!scratch_.swept) sort_by_cells();
  }

 private:
  static constexpr std::size_t kWorthOrdering = 4096;  ///< fewer are near enough in memory anyhow

  /// Segments in the order of the sites of the operand that has more of them: what is near in the
  /// plane is near in memory then, all the way to the output.
  std::span<const Segment> order_along_rings(std::span<const Segment> segments) {
    const int longer = 2 * o_.split >= o_.size() ? 0 : 1;
    const auto site = [&](const Segment& s) {
      return o_.operand_of(s.edge) == longer ? s.edge : s.vertex;
    };
    auto& place = scratch_.bin.place;
    place.assign(o_.size() + 1, 0);
    for (const Segment& s : segments) ++place[site(s) + 1];
    std::partial_sum(place.begin(), place.end(), place.begin());
    auto& ordered = scratch_.bin.ordered;
    ordered.resize(segments.size());
    for (const Segment& s : segments) ordered[place[site(s)]++] = s;
    return ordered;
  }

  void list_all_cells() {
    KeptId count = 0;
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      if (list_cells(kept_[i], count)) kept_[count++] = kept_[i];
    }
    kept_.resize(count);
  }

  /// Directions that several edges have: only segments of such can be equal. False if there are none.
  bool list_shared_directions() {
    if (o_.rank_count == o_.size()) return false;
    auto& shared = scratch_.bin.shared;
    shared.assign(o_.rank_count, 0);
    for (std::size_t i = 1; i < o_.by_direction.size(); ++i) {
      const DirectionRank rank = o_.rank[o_.by_direction[i]];
      if (rank == o_.rank[o_.by_direction[i - 1]]) shared[rank] = 1;
    }
    return true;
  }
  /// Of equal segments one.
  void place_once(std::span<const Segment> segments) {
    DuplicateFinder duplicates(scratch_.hash_table, kept_);
    const auto& shared = scratch_.bin.shared;
    for (const Segment& segment : segments) {
      kept_.push_back(place_segment(o_, segment));
      if (shared[o_.rank[segment.edge]] != 0 && duplicates.seen()) kept_.pop_back();
    }
  }

  void append_members() {
    auto& join = scratch_.join;
    for (KeptId s = 0; s < scratch_.line_count; ++s) {
      if (kept_[s].joined == 0) continue;
      JoinedSegments& joined = join.joined[kept_[s].joined - 1];
      const auto first = static_cast<KeptId>(kept_.size());
      kept_.insert(kept_.end(), join.members.begin() + joined.first,
                   join.members.begin() + joined.end);
      joined.first = first;
      joined.end = static_cast<KeptId>(kept_.size());
    }
  }

  /// Appends an item for each uncovered cell that a segment is near; whether there is one.
  bool list_cells(KeptSegment& s, KeptId id) {
    const std::size_t before = items_.size();
    const CellLine line(s, grid_.inverse);
    grid_.walk_rows(s.a, s.b, UniformGrid::kMargin, [&](const UniformGrid::RowSpan& span) {
      std::uint64_t any_covered = 0;
      for (std::int32_t first = span.left; first <= span.right; first = (first | 63) + 1) {
        const std::int32_t last = std::min(span.right, first | 63);
        const std::uint64_t wanted = ~std::uint64_t{0} >> (63 - (last - first)) << (first & 63);
        const std::uint64_t covered = covers_any_ ? cover_.covered.row(span.row)[first >> 6] : 0;
        any_covered |= covered & wanted;
        for (std::uint64_t bits = wanted & ~covered; bits != 0; bits &= bits - 1) {
          add_item(id, line, span, (first & ~63) + std::countr_zero(bits));
        }
      }
      s.meets_cover = s.meets_cover || any_covered != 0;
      return true;
    });
    return items_.size() > before;
  }
  void add_item(KeptId id, const CellLine& line, const UniformGrid::RowSpan& span, std::int32_t i) {
    constexpr double kMargin = UniformGrid::kMargin;
    const double x0 = std::max(span.x0, i - kMargin);
    const double x1 = std::min(span.x1, i + 1 + kMargin);
    double y0 = span.y0;
    double y1 = span.y1;
    if (line.rise != 0) {
      const double at_x0 = line.height_at(x0);
      const double at_x1 = line.height_at(x1);
      y0 = std::max(y0, std::min(at_x0, at_x1));
      y1 = std::min(y1, std::max(at_x0, at_x1));
    }
    const auto cell =
        static_cast<std::uint32_t>(span.row) * static_cast<std::uint32_t>(grid_.columns) +
        static_cast<std::uint32_t>(i);
    items_.push_back({CellBox(x0 - i, y0 - span.row, x1 - i, y1 - span.row), cell, id});
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
  bool covers_any_;
  UniformGrid& grid_;
  std::vector<CellItem>& items_;
  ArrangementScratch& scratch_;
  std::vector<KeptSegment>& kept_;
};

}  // namespace

void bin_segments(const Operands& operands, const Convolution& convolution, const Cover& cover,
                  ArrangementScratch& scratch, Arrangement& arrangement) {
  if (cover.divided) return bin_leaves(operands, convolution, cover, scratch, arrangement);
  Binner(operands, cover, scratch, arrangement).run(convolution);
}

}  // namespace minksum
