// Finds what makes an operand invalid: edges that meet where they must not, misplaced rings.
#include <algorithm>
#include <cmath>
#include <span>

#include "machine/make_room.hpp"
#include "spatial/box_pairs.hpp"
#include "spatial/uniform_grid.hpp"
#include "validation/bin_edges.hpp"
#include "validation/fault_list.hpp"
#include "validation/misplaced_rings.hpp"
#include "validation/prepared_operand.hpp"

namespace minksum {
namespace {

/// Holds an operand's edges and decides about pairs of them.
class ContactFinder {
 public:
  ContactFinder(std::size_t max_faults, Cancellation& cancellation, OperandScratch& scratch,
                PreparedOperand& operand, std::vector<Fault>& faults)
      : scratch_(scratch),
        o_(operand),
        cancellation_(cancellation),
        predicates_(operand.sites, *operand.kernel, operand.bounds, cancellation),
        list_(operand, max_faults, faults) {}

  void find_contacts() {
    scratch_.touches.clear();
    const Vec<double> extent = this->extent();
    const bool in_columns = o_.rings.size() == 1 && few_in_columns(extent.x);
    if (in_columns && compare_boxes(extent, kMostInColumn)) return;
    sweep_rings(o_, cancellation_, scratch_);
    if (!scratch_.sweep.any_suspect) return;
    suspects_known_ = true;
    if (in_columns) {
      compare_boxes(extent, o_.size());
    } else {
      compare_in_cells(extent);
    }
  }

  /// Finds rings in the wrong place, where no rings cross.
  void find_misplaced_rings() {
    minksum::find_misplaced_rings(o_.rings, scratch_.sweep.parent, cancellation_, scratch_.nesting);
    const std::vector<Misplacement>& misplaced = scratch_.nesting.misplaced;
    for (std::size_t r = 0; r < o_.rings.size() && !list_.full(); ++r) {
      const SiteId first = o_.rings[r].begin;
      if (misplaced[r].in_other_hole) list_.add_vertex("hole lies inside another hole", first);
      if (misplaced[r].out_of_outer) list_.add_vertex("hole lies outside its outer ring", first);
      if (misplaced[r].in_other_outer) list_.add_vertex("polygons overlap", first);
    }
  }

 private:
  [[nodiscard]] Vec<double> extent() const {
    if (!o_.rational) {
      return {static_cast<double>(o_.grid.extent.x), static_cast<double>(o_.grid.extent.y)};
    }
    Vec<double> extent{};
    for (const double x : o_.sites.x) extent.x = std::max(extent.x, x);
    for (const double y : o_.sites.y) extent.y = std::max(extent.y, y);
    return extent;
  }
  /// Comparing an edge with so many takes about as long as passing it in a sweep. On 150 rings of
  /// 49 to 21,000 vertices, limits of 30 to 60 come within 2 % of each ring's best, and 200 takes
  /// up to six times as long.
  static constexpr std::size_t kMostInColumn = 40;
  [[nodiscard]] static double lengths(std::span<const double> along_axis) {
    double sum = 0;
    for (const double d : along_axis) sum += std::abs(d);
    return sum;
  }
  /// Tells whether few edges overlap in x.
  [[nodiscard]] bool few_in_columns(double width) const {
    if (o_.size() <= kMostInColumn) return true;
    return lengths(o_.sites.dx) <= static_cast<double>(kMostInColumn) * width;
  }
  /// Tests all pairs of edges whose boxes overlap. Returns false, and tests none, if an edge shares
  /// its columns with more than `most` others, on average.
  bool compare_boxes(const Vec<double>& extent, std::size_t most) {
    const auto& [x, y, dx, dy, next] = o_.sites;
    BoxPairs pairs(extent.x, extent.y, o_.bounds.position, scratch_.pairs);
    for (SiteId e = 0; e < o_.size(); ++e) {
      const SiteId f = next[e];
      pairs.add(std::min(x[e], x[f]), std::min(y[e], y[f]), std::max(x[e], x[f]),
                std::max(y[e], y[f]));
    }
    if (!pairs.sort(cancellation_, {.in_x = static_cast<double>(most)})) return false;
    pairs.for_each(
        [&](SiteId e, SiteId f) {
          if (!list_.full()) contact(std::min(e, f), std::max(e, f));
        },
        cancellation_, true);
    return true;
  }
  /// So many cells are passed by an edge, on average. On twelve files, 4 took least or as little in
  /// each. 16 took up to three times as long, and 64 twelve times.
  static constexpr double kMostPassed = 4;
  /// Tests the suspect edges with all edges, cell by cell.
  void compare_in_cells(const Vec<double>& extent) {
    // Comparing all pairs of a few edges costs less than cells. Long edges meet the same pairs in
    // smaller cells, only more often.
    const double edges = o_.size();
    const double longer = std::max(extent.x, extent.y);
    const double side =
        std::min(std::sqrt(edges < 100 ? edges / 4 : edges),
                 kMostPassed * edges * longer / (lengths(o_.sites.dx) + lengths(o_.sites.dy)));
    bin_edges(o_, UniformGrid::over(extent, std::clamp(static_cast<int>(side), 1, 2048)),
              cancellation_, scratch_);
    const auto& begin = scratch_.cell_begin;
    in_pieces(begin.size() - 1, cancellation_, [&](std::size_t first, std::size_t last) {
      for (std::size_t cell = first; cell < last && !list_.full(); ++cell) {
        const std::uint32_t count = begin[cell + 1] - begin[cell];
        find_contacts_in(std::span(scratch_.in_cells).subspan(begin[cell], count));
      }
    });
  }
  [[nodiscard]] bool is_suspect(SiteId e) const {
    return !suspects_known_ || scratch_.sweep.suspect[e] != 0;
  }
  /// Tests the suspects of a cell with its other edges that overlap in x, from left to right.
  void find_contacts_in(std::span<SiteId> edges) {
    cancellation_.check(edges.size());
    if (std::ranges::none_of(edges, [&](SiteId e) { return is_suspect(e); })) return;
    const auto& x = o_.sites.x;
    const auto& next = o_.sites.next;
    const auto left = [&](SiteId e) { return std::min(x[e], x[next[e]]); };
    const auto right = [&](SiteId e) { return std::max(x[e], x[next[e]]); };
    constexpr std::size_t kFew = 8;
    const bool sorted = edges.size() > kFew;
    if (sorted) {
      std::sort(edges.begin(), edges.end(), [&](SiteId a, SiteId b) { return left(a) < left(b); });
    }
    next_suspect_.resize(edges.size() + 1);
    next_suspect_.back() = edges.size();
    for (std::size_t i = edges.size(); i-- > 0;) {
      next_suspect_[i] = is_suspect(edges[i]) ? i : next_suspect_[i + 1];
    }
    for (std::size_t i = 0; i < edges.size() && !list_.full(); ++i) {
      const double reach = right(edges[i]) + o_.bounds.difference;
      const bool with_all = is_suspect(edges[i]);
      const auto from = [&](std::size_t k) { return with_all ? k : next_suspect_[k]; };
      std::size_t compared = 1;
      for (std::size_t j = from(i + 1); j < edges.size(); j = from(j + 1)) {
        if (sorted && left(edges[j]) > reach) break;
        contact(edges[i], edges[j]);
        ++compared;
      }
      cancellation_.check(4 * compared);
    }
  }

  [[nodiscard]] std::size_t ring_of(SiteId v) const { return minksum::ring_of(o_.rings, v); }

  [[nodiscard]] bool boxes_apart(SiteId e, SiteId f) const {
    const auto& [x, y, dx, dy, next] = o_.sites;
    const double doubt = o_.bounds.difference;
    const auto apart = [&](double a0, double a1, double b0, double b1) {
      return std::max(a0, a1) + doubt < std::min(b0, b1) ||
             std::max(b0, b1) + doubt < std::min(a0, a1);
    };
    return apart(x[e], x[next[e]], x[f], x[next[f]]) || apart(y[e], y[next[e]], y[f], y[next[f]]);
  }

  void contact(SiteId e, SiteId f) {
    const SiteId e1 = o_.sites.next[e];
    const SiteId f1 = o_.sites.next[f];
    if (e == f || e1 == f || f1 == e) return;
    if ((!is_suspect(e) && !is_suspect(f)) || boxes_apart(e, f)) return;
    const Sign fs = predicates_.orientation(e, e1, f);
    const Sign ft = predicates_.orientation(e, e1, f1);
    if (fs == ft && fs != kZero) return;
    const Sign es = predicates_.orientation(f, f1, e);
    const Sign et = predicates_.orientation(f, f1, e1);
    if (es == et && es != kZero) return;
    if (fs == kZero && ft == kZero) return collinear(e, f);
    if (fs != kZero && ft != kZero && es != kZero && et != kZero) {
      return list_.add_crossing("edges cross", e, f);
    }
    // The edges touch at a point that is a vertex of one of them.
    if (fs == kZero && between(e, e1, f)) touch(e, f);
    if (ft == kZero && between(e, e1, f1)) touch(e, f1);
    if (es == kZero && between(f, f1, e)) touch(f, e);
    if (et == kZero && between(f, f1, e1)) touch(f, e1);
  }

  /// Tells whether v, on the line through a and b, lies on the closed segment.
  bool between(SiteId a, SiteId b, SiteId v) {
    for (const Axis axis : {Axis::kX, Axis::kY}) {
      if (predicates_.compare(a, v, axis) * predicates_.compare(v, b, axis) == kNegative) {
        return false;
      }
    }
    return true;
  }
  bool equal(SiteId a, SiteId b) { return predicates_.compare(a, b) == kZero; }

  void collinear(SiteId e, SiteId f) {
    const SiteId e1 = o_.sites.next[e];
    const SiteId f1 = o_.sites.next[f];
    const bool inside[4] = {between(e, e1, f), between(e, e1, f1), between(f, f1, e),
                            between(f, f1, e1)};
    if (!inside[0] && !inside[1] && !inside[2] && !inside[3]) return;
    // The edges lie in one line and share either one common end point or a piece.
    for (const SiteId a : {e, e1}) {
      for (const SiteId b : {f, f1}) {
        const SiteId a_other = a == e ? e1 : e;
        const SiteId b_other = b == f ? f1 : f;
        if (equal(a, b) && !between(a, a_other, b_other) && !between(b, b_other, a_other)) {
          return touch_at_vertices(a, b);
        }
      }
    }
    list_.add_overlap("edges overlap", e, f);
  }

  /// Handles a vertex v of another edge that lies on the closed edge e.
  void touch(SiteId e, SiteId v) {
    const SiteId e1 = o_.sites.next[e];
    if (equal(e, v)) return touch_at_vertices(e, v);
    if (equal(e1, v)) return touch_at_vertices(e1, v);
    if (ring_of(e) == ring_of(v)) return list_.add_vertex_on_edge("ring touches itself", v, e);
    const Sign before = predicates_.orientation(e, e1, o_.previous[v]);
    const Sign after = predicates_.orientation(e, e1, o_.sites.next[v]);
    if (before * after == kNegative) return list_.add_vertex_on_edge("rings cross", v, e);
    scratch_.touches.push_back({v, e, false});
  }

  void touch_at_vertices(SiteId v, SiteId w) {
    if (v == w) return;
    if (ring_of(v) == ring_of(w)) {
      return list_.add_two_vertices("ring touches itself", v, w);
    }
    // Both edges of w must leave into the same of the two sectors between the edges of v.
    if (left_of(v, w, kPositive) != left_of(v, o_.previous[w], kNegative)) {
      return list_.add_two_vertices("rings cross", v, w);
    }
    scratch_.touches.push_back({v, w, true});
  }
  /// Tells whether the direction of `edge` (reversed for kNegative) points into the sector left of
  /// v.
  bool left_of(SiteId v, SiteId edge, Sign sense) {
    const SiteId in = o_.previous[v];
    const bool left_of_out = predicates_.cross(v, edge) * sense == kPositive;
    const bool left_of_in = predicates_.cross(in, edge) * sense == kPositive;
    return predicates_.cross(in, v) == kPositive ? left_of_out && left_of_in
                                                 : left_of_out || left_of_in;
  }

  OperandScratch& scratch_;
  const PreparedOperand& o_;
  Cancellation& cancellation_;
  std::vector<std::size_t> next_suspect_;  // in a cell's edges: the next suspect from there on
  bool suspects_known_ = false;            ///< whether only suspect edges can be faulty
  Predicates predicates_;
  FaultList list_;
};

}  // namespace

void find_faults(std::size_t max_faults, Cancellation& cancellation, OperandScratch& scratch,
                 PreparedOperand& operand, std::vector<Fault>& faults) {
  ContactFinder finder(max_faults, cancellation, scratch, operand, faults);
  finder.find_contacts();
  // A ring can be said to be out of place only if no rings cross.
  if (faults.empty() && operand.rings.size() > 1) finder.find_misplaced_rings();
}

}  // namespace minksum
