// Finds what makes an operand invalid: edges that meet where they must not, misplaced rings.
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "machine/make_room.hpp"
#include "spatial/box_pairs.hpp"
#include "spatial/uniform_grid.hpp"
#include "validation/bin_edges.hpp"
#include "validation/fault_list.hpp"
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
    if (o_.rings.size() == 1 && few_in_columns(extent.x)) return sweep(extent);
    // Comparing all pairs of a few edges costs less than cells.
    const double edges = o_.size();
    const double cells = edges < 100 ? edges / 4 : edges;
    const int side = std::clamp(static_cast<int>(std::sqrt(cells)), 1, 2048);
    grid_ = UniformGrid::over(extent.x, extent.y, side);
    bin_edges(o_, grid_, cancellation_, scratch_);
    const auto& begin = scratch_.cell_begin;
    in_pieces(begin.size() - 1, cancellation_, [&](std::size_t first, std::size_t last) {
      for (std::size_t cell = first; cell < last; ++cell) {
        const std::uint32_t count = begin[cell + 1] - begin[cell];
        if (count < 2) continue;
        if (list_.full()) return;
        find_contacts_in(std::span(scratch_.in_cells).subspan(begin[cell], count));
      }
    });
  }

  /// Finds rings in the wrong place. Rings do not cross here, so any point of a ring that is not on
  /// the other ring decides.
  void find_misplaced_rings() {
    scratch_.stamp.assign(o_.size(), kNoSite);
    for (std::size_t r = 0; r < o_.rings.size() && !list_.full(); ++r) {
      list_rings_around(r);
      if (o_.rings[r].is_hole()) {
        check_hole(r);
      } else {
        check_outer(r);
      }
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
  /// Tells whether few edges overlap in x, so that a sweep costs less than cells. With several
  /// rings, cells are needed anyway, to find which rings lie in others.
  [[nodiscard]] bool few_in_columns(double width) const {
    constexpr std::size_t kMostInColumn = 200;
    if (o_.size() <= kMostInColumn) return true;
    double across = 0;
    for (const double dx : o_.sites.dx) across += std::abs(dx);
    return across <= static_cast<double>(kMostInColumn) * width;
  }
  /// Tests all pairs of edges whose boxes overlap.
  void sweep(const Vec<double>& extent) {
    const auto& [x, y, dx, dy, next] = o_.sites;
    BoxPairs pairs(extent.x, extent.y, o_.bounds.position, scratch_.pairs);
    for (SiteId e = 0; e < o_.size(); ++e) {
      const SiteId f = next[e];
      pairs.add(std::min(x[e], x[f]), std::min(y[e], y[f]), std::max(x[e], x[f]),
                std::max(y[e], y[f]));
    }
    pairs.for_each(
        [&](SiteId e, SiteId f) {
          if (!list_.full()) contact(std::min(e, f), std::max(e, f));
        },
        cancellation_, true);
  }
  /// Tests all pairs of a cell's edges that overlap in x, from left to right, because cells may be
  /// crowded.
  void find_contacts_in(std::span<SiteId> edges) {
    const auto& x = o_.sites.x;
    const auto& next = o_.sites.next;
    const auto left = [&](SiteId e) { return std::min(x[e], x[next[e]]); };
    const auto right = [&](SiteId e) { return std::max(x[e], x[next[e]]); };
    constexpr std::size_t kFew = 8;
    const bool sorted = edges.size() > kFew;
    if (sorted) {
      std::sort(edges.begin(), edges.end(), [&](SiteId a, SiteId b) { return left(a) < left(b); });
    }
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const double reach = right(edges[i]) + o_.bounds.difference;
      std::size_t j = i + 1;
      for (; j < edges.size(); ++j) {
        if (sorted && left(edges[j]) > reach) break;
        contact(edges[i], edges[j]);
      }
      cancellation_.check(4 * (j - i));
      if (list_.full()) return;
    }
  }

  [[nodiscard]] std::size_t ring_of(SiteId v) const {
    const auto after =
        std::upper_bound(o_.rings.begin(), o_.rings.end(), v,
                         [](SiteId site, const OperandRing& r) { return site < r.begin; });
    return static_cast<std::size_t>(after - o_.rings.begin()) - 1;
  }

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
    if (e == f || e1 == f || f1 == e || boxes_apart(e, f)) return;
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
  bool equal(SiteId a, SiteId b) {
    return predicates_.compare(a, b, Axis::kX) == kZero &&
           predicates_.compare(a, b, Axis::kY) == kZero;
  }

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

  // -- Rings in their places -------------------------------------------------------------------
  /// Probes and lines are made of sums, so they need a second site. Any one moves both alike.
  static constexpr SiteId kFixedSite = 0;

  /// How a ray from a probe to the right meets an edge. Edges are half-open: an end at the probe's
  /// own height counts as below it.
  enum class Meeting { kMisses, kPasses, kStartsOn };
  [[nodiscard]] Meeting meeting(const Probe& probe, SiteId e) const {
    cancellation_.check(2 * o_.kernel->work());
    const SiteId f = o_.sites.next[e];
    const ExactKernel& kernel = *o_.kernel;
    const Sign at_e = kernel.probe_compare(probe, sum_vertex(e, kFixedSite), Axis::kY);
    const Sign at_f = kernel.probe_compare(probe, sum_vertex(f, kFixedSite), Axis::kY);
    if (at_e == at_f && at_e != kZero) return Meeting::kMisses;
    const Sign side = kernel.probe_orientation(e, sum_vertex(e, kFixedSite), probe);
    if (side == kZero) {
      const Sign x_e = kernel.probe_compare(probe, sum_vertex(e, kFixedSite), Axis::kX);
      const Sign x_f = kernel.probe_compare(probe, sum_vertex(f, kFixedSite), Axis::kX);
      const bool on = x_e * x_f != kPositive && at_e * at_f != kPositive;
      return on ? Meeting::kStartsOn : Meeting::kMisses;
    }
    const bool e_above = at_e == kNegative;
    const bool f_above = at_f == kNegative;
    return e_above != f_above && (side == kPositive) == f_above ? Meeting::kPasses
                                                                 : Meeting::kMisses;
  }

  /// Returns the coordinates of a probe, which are off by at most `doubt()`.
  [[nodiscard]] Vec<double> place_of(const Probe& probe) const {
    const Vec<double> sum = predicates_.position(probe);
    return {sum.x - o_.sites.x[kFixedSite], sum.y - o_.sites.y[kFixedSite]};
  }
  [[nodiscard]] double doubt() const { return 8 * o_.bounds.position; }

  /// Lists the rings that contain ring `inner` in `scratch_.around`, by parity along a row of
  /// cells.
  void list_rings_around(std::size_t inner) {
    auto& around = scratch_.around;
    around.clear();
    const Probe probe{{o_.rings[inner].begin, kFixedSite}, 1, 1};
    const Vec<double> at = place_of(probe);
    const double low = at.y - doubt();
    const double high = at.y + doubt();
    std::vector<std::size_t>& on = scratch_.on;
    on.clear();
    const auto stamp = static_cast<SiteId>(inner);
    for (std::int32_t j = grid_.row(low); j <= grid_.row(high); ++j) {
      for (std::int32_t i = grid_.column(at.x - doubt()); i < grid_.columns; ++i) {
        const std::size_t cell =
            static_cast<std::size_t>(j) * static_cast<std::size_t>(grid_.columns) +
            static_cast<std::size_t>(i);
        const std::uint32_t cell_end = scratch_.cell_begin[cell + 1];
        cancellation_.check(1 + cell_end - scratch_.cell_begin[cell]);
        for (std::uint32_t k = scratch_.cell_begin[cell]; k < cell_end; ++k) {
          const SiteId e = scratch_.in_cells[k];
          const double y0 = o_.sites.y[e];
          const double y1 = o_.sites.y[o_.sites.next[e]];
          if (std::max(y0, y1) < low || std::min(y0, y1) > high) continue;
          if (std::exchange(scratch_.stamp[e], stamp) == stamp) continue;
          const std::size_t ring = ring_of(e);
          if (ring == inner) continue;
          const Meeting found = meeting(probe, e);
          if (found == Meeting::kPasses) around.push_back(ring);
          if (found == Meeting::kStartsOn) on.push_back(ring);
        }
      }
    }
    keep_odd(around);
    for (const std::size_t ring : on) {
      std::erase(around, ring);
      if (lies_inside(inner, ring)) around.push_back(ring);
    }
  }
  /// Keeps one of each ring that occurs an odd number of times.
  static void keep_odd(std::vector<std::size_t>& rings) {
    std::sort(rings.begin(), rings.end());
    std::size_t kept = 0;
    for (std::size_t i = 0, j = 0; i < rings.size(); i = j) {
      for (j = i; j < rings.size() && rings[j] == rings[i]; ++j) {
      }
      if ((j - i) % 2 != 0) rings[kept++] = rings[i];
    }
    rings.resize(kept);
  }

  /// Tells whether ring `inner` lies inside ring `outer`, which it does not cross. Only finitely
  /// many points of an edge lie on the other ring, so some dyadic point does not.
  bool lies_inside(std::size_t inner, std::size_t outer) {
    const Segment edge{o_.rings[inner].begin, kFixedSite};
    for (int shift = 1; shift < Probe::kMaxShift; ++shift) {
      for (std::int64_t k = 1; k < (std::int64_t{1} << std::min(shift, 12)); k += 2) {
        const Probe probe{edge, k, shift};
        bool inside = false;
        bool on = false;
        for (SiteId e = o_.rings[outer].begin; e < o_.rings[outer].end && !on; ++e) {
          const Meeting found = meeting(probe, e);
          inside ^= found == Meeting::kPasses;
          on = found == Meeting::kStartsOn;
        }
        if (!on) return inside;
      }
    }
    throw Error(ErrorCode::kInternal, "no point of a ring lies off another ring", {}, "operands");
  }

  void check_hole(std::size_t hole) {
    const OperandRing& own = o_.rings[hole];
    bool in_outer = false;
    cancellation_.check(scratch_.around.size());
    for (const std::size_t r : scratch_.around) {
      const OperandRing& ring = o_.rings[r];
      if (ring.polygon != own.polygon) continue;
      in_outer |= !ring.is_hole();
      if (ring.is_hole()) list_.add_vertex("hole lies inside another hole", own.begin);
    }
    if (!in_outer) list_.add_vertex("hole lies outside its outer ring", own.begin);
  }

  void check_outer(std::size_t outer) {
    const auto in_hole_of = [&](std::uint32_t polygon) {
      cancellation_.check(scratch_.around.size());
      return std::any_of(scratch_.around.begin(), scratch_.around.end(), [&](std::size_t r) {
        return o_.rings[r].is_hole() && o_.rings[r].polygon == polygon;
      });
    };
    cancellation_.check(scratch_.around.size());
    for (const std::size_t r : scratch_.around) {
      const OperandRing& ring = o_.rings[r];
      if (!ring.is_hole() && !in_hole_of(ring.polygon)) {
        list_.add_vertex("polygons overlap", o_.rings[outer].begin);
      }
    }
  }

  OperandScratch& scratch_;
  const PreparedOperand& o_;
  Cancellation& cancellation_;
  UniformGrid grid_;
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
