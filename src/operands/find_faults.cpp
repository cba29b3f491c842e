// What makes an operand illegal: edges that meet where they must not, rings in the wrong place.
#include <algorithm>
#include <cmath>
#include <set>
#include <span>

#include "grid/uniform_grid.hpp"
#include "operands/operands.hpp"

namespace minksum {
namespace {

/// Edges of one operand and the questions about pairs of them.
class ContactFinder {
 public:
  ContactFinder(Operands& operands, int operand, std::size_t max_faults,
                std::vector<Fault>& faults)
      : ring_of_(operands.scratch.ring_of),
        cell_begin_(operands.scratch.cell_begin),
        in_cells_(operands.scratch.in_cells),
        boxes_(operands.scratch.boxes),
        o_(operands),
        predicates_(operands.sites, *operands.kernel, operands.bounds),
        operand_(operand),
        max_faults_(max_faults),
        faults_(faults) {
    first_ring_ = operand == 0 ? 0 : operands.first_rings;
    last_ring_ = operand == 0 ? operands.first_rings : operands.rings.size();
    begin_ = operand == 0 ? 0 : operands.split;
    end_ = operand == 0 ? operands.split : operands.size();
    ring_of_.resize(end_ - begin_);
    for (std::size_t r = first_ring_; r < last_ring_; ++r) {
      for (SiteId v = operands.rings[r].begin; v < operands.rings[r].end; ++v) {
        ring_of_[v - begin_] = r;
      }
    }
  }

  void find_contacts() {
    const Vec<double> extent = o_.extent[static_cast<std::size_t>(operand_)];
    const double edges = end_ - begin_;
    const int side = std::clamp(static_cast<int>(std::sqrt(edges)), 1, 2048);
    const UniformGrid grid = UniformGrid::over(extent.x, extent.y, side);
    bin(grid);
    for (std::size_t cell = 0; cell + 1 < cell_begin_.size(); ++cell) {
      const auto edges_in_cell = std::span(in_cells_).subspan(
          cell_begin_[cell], cell_begin_[cell + 1] - cell_begin_[cell]);
      find_contacts_in(edges_in_cell);
      if (full()) return;
    }
  }

  void find_misplaced_rings() {
    boxes();
    for (std::size_t r = first_ring_; r < last_ring_ && !full(); ++r) {
      const OperandRing& ring = o_.rings[r];
      if (ring.is_hole()) {
        check_hole(r);
      } else {
        check_outer(r);
      }
    }
  }

 private:
  enum class Place { kInside, kOutside, kOnBoundary };

  /// All pairs whose x ranges overlap, from left to right: cells may be crowded.
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
      for (std::size_t j = i + 1; j < edges.size() && !full(); ++j) {
        if (sorted && left(edges[j]) > reach) break;
        contact(edges[i], edges[j]);
      }
    }
  }

  [[nodiscard]] bool full() const { return faults_.size() >= max_faults_; }
  [[nodiscard]] const OperandRing& ring_of(SiteId v) const {
    return o_.rings[ring_of_[v - begin_]];
  }

  void report(const char* message, SiteId v) {
    if (full() || !reported_.insert({v, message}).second) return;
    const OperandRing& ring = ring_of(v);
    Fault fault{message, {-1, ring.polygon, ring.ring, Culprit::kNone}, 0, 0};
    fault.place.vertex = o_.vertex_source[v];  // made relative to its ring by the caller
    faults_.push_back(std::move(fault));
  }

  void bin(const UniformGrid& grid) {
    const auto visit_all = [&](auto visit) {
      for (SiteId e = begin_; e < end_; ++e) {
        const SiteId f = o_.sites.next[e];
        grid.walk({o_.sites.x[e], o_.sites.y[e]}, {o_.sites.x[f], o_.sites.y[f]},
                  UniformGrid::kMargin, [&](std::int32_t i, std::int32_t j) {
                    visit(static_cast<std::size_t>(j) * static_cast<std::size_t>(grid.columns) +
                              static_cast<std::size_t>(i),
                          e);
                    return true;
                  });
      }
    };
    cell_begin_.assign(static_cast<std::size_t>(grid.size()) + 2, 0);
    visit_all([&](std::size_t cell, SiteId) { ++cell_begin_[cell + 2]; });
    for (std::size_t i = 2; i < cell_begin_.size(); ++i) cell_begin_[i] += cell_begin_[i - 1];
    in_cells_.resize(cell_begin_.back());
    visit_all([&](std::size_t cell, SiteId e) { in_cells_[cell_begin_[cell + 1]++] = e; });
    cell_begin_.pop_back();
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
      return report("edges cross", e);
    }
    // They touch at a point that is a vertex of one of them.
    if (fs == kZero && between(e, e1, f)) touch(e, f);
    if (ft == kZero && between(e, e1, f1)) touch(e, f1);
    if (es == kZero && between(f, f1, e)) touch(f, e);
    if (et == kZero && between(f, f1, e1)) touch(f, e1);
  }

  /// v, on the line through a and b, lies on the closed segment.
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
    // In one line and in touch: either at one common end point, or along a piece.
    for (const SiteId a : {e, e1}) {
      for (const SiteId b : {f, f1}) {
        const SiteId a_other = a == e ? e1 : e;
        const SiteId b_other = b == f ? f1 : f;
        if (equal(a, b) && !between(a, a_other, b_other) && !between(b, b_other, a_other)) {
          return touch_at_vertices(a, b);
        }
      }
    }
    report("edges overlap", e);
  }

  /// v of another edge lies on the closed edge e.
  void touch(SiteId e, SiteId v) {
    const SiteId e1 = o_.sites.next[e];
    if (equal(e, v)) return touch_at_vertices(e, v);
    if (equal(e1, v)) return touch_at_vertices(e1, v);
    if (ring_of_[e - begin_] == ring_of_[v - begin_]) return report("ring touches itself", v);
    const Sign before = predicates_.orientation(e, e1, o_.previous[v]);
    const Sign after = predicates_.orientation(e, e1, o_.sites.next[v]);
    if (before * after == kNegative) report("rings cross", v);
  }

  void touch_at_vertices(SiteId v, SiteId w) {
    if (v == w) return;
    if (ring_of_[v - begin_] == ring_of_[w - begin_]) {
      return report("ring touches itself", std::min(v, w));
    }
    // Both edges of w must leave into the same of the two sectors between the edges of v.
    if (left_of(v, w, kPositive) != left_of(v, o_.previous[w], kNegative)) {
      report("rings cross", std::min(v, w));
    }
  }
  /// Whether the direction of `edge` (reversed for kNegative) points into the sector left of v.
  bool left_of(SiteId v, SiteId edge, Sign sense) {
    const SiteId in = o_.previous[v];
    const bool left_of_out = predicates_.cross(v, edge) * sense == kPositive;
    const bool left_of_in = predicates_.cross(in, edge) * sense == kPositive;
    return predicates_.cross(in, v) == kPositive ? left_of_out && left_of_in
                                                 : left_of_out || left_of_in;
  }

  // -- Rings in their places: rings do not cross here, so one point of a ring that is not on the
  // -- other ring decides. -------------------------------------------------------------------
  void boxes() {
    const auto& x = o_.sites.x;
    const auto& y = o_.sites.y;
    boxes_.clear();
    for (std::size_t r = first_ring_; r < last_ring_; ++r) {
      const OperandRing& ring = o_.rings[r];
      const auto [x0, x1] = std::minmax_element(x.begin() + ring.begin, x.begin() + ring.end);
      const auto [y0, y1] = std::minmax_element(y.begin() + ring.begin, y.begin() + ring.end);
      boxes_.push_back({*x0, *x1, *y0, *y1});
    }
  }
  /// Certainly not inside: the box of `inner` is not within that of `outer`.
  [[nodiscard]] bool box_outside(std::size_t inner, std::size_t outer) const {
    const RingBox& a = boxes_[inner - first_ring_];
    const RingBox& b = boxes_[outer - first_ring_];
    const double doubt = o_.bounds.difference;
    return a.x0 < b.x0 - doubt || a.x1 > b.x1 + doubt || a.y0 < b.y0 - doubt ||
           a.y1 > b.y1 + doubt;
  }

  /// Probes and lines are made of sums: any one site moves both the probe and the ring alike.
  [[nodiscard]] SiteId fixed_site() const { return begin_; }

  Place locate(const Probe& probe, const OperandRing& ring) {
    bool inside = false;
    const SiteId fixed = fixed_site();
    for (SiteId e = ring.begin; e < ring.end; ++e) {
      const SiteId f = o_.sites.next[e];
      const ExactKernel& kernel = *o_.kernel;
      const Sign at_e = kernel.probe_compare(probe, sum_vertex(e, fixed), Axis::kY);
      const Sign at_f = kernel.probe_compare(probe, sum_vertex(f, fixed), Axis::kY);
      if (at_e == at_f && at_e != kZero) continue;
      const Sign side = kernel.probe_orientation(e, sum_vertex(e, fixed), probe);
      if (side == kZero) {
        const Sign x_e = kernel.probe_compare(probe, sum_vertex(e, fixed), Axis::kX);
        const Sign x_f = kernel.probe_compare(probe, sum_vertex(f, fixed), Axis::kX);
        if (x_e * x_f != kPositive && at_e * at_f != kPositive) return Place::kOnBoundary;
        continue;
      }
      // Half-open: an end at the probe's own height counts as below it.
      const bool e_above = at_e == kNegative;
      const bool f_above = at_f == kNegative;
      if (e_above != f_above && (side == kPositive) == f_above) inside = !inside;
    }
    return inside ? Place::kInside : Place::kOutside;
  }

  /// Whether ring `inner`, which does not cross ring `outer`, lies inside it.
  bool lies_inside(std::size_t inner, std::size_t outer) {
    if (box_outside(inner, outer)) return false;
    const Segment edge{o_.rings[inner].begin, fixed_site()};
    // Only finitely many points of the edge lie on the other ring: some dyadic one does not.
    for (int shift = 1; shift < Probe::kMaxShift; ++shift) {
      for (std::int64_t k = 1; k < (std::int64_t{1} << std::min(shift, 12)); k += 2) {
        const Place place = locate({edge, k, shift}, o_.rings[outer]);
        if (place != Place::kOnBoundary) return place == Place::kInside;
      }
    }
    throw Error(ErrorCode::kInternal, "no point of a ring lies off another ring", {}, "operands");
  }

  void check_hole(std::size_t hole) {
    for (std::size_t r = first_ring_; r < last_ring_; ++r) {
      if (r == hole || o_.rings[r].polygon != o_.rings[hole].polygon) continue;
      if (!o_.rings[r].is_hole()) {
        if (!lies_inside(hole, r)) report("hole lies outside its outer ring", o_.rings[hole].begin);
      } else if (lies_inside(hole, r)) {
        report("hole lies inside another hole", o_.rings[hole].begin);
      }
    }
  }

  void check_outer(std::size_t outer) {
    for (std::size_t r = first_ring_; r < last_ring_; ++r) {
      if (r == outer || o_.rings[r].is_hole() || !lies_inside(outer, r)) continue;
      bool in_hole = false;
      for (std::size_t h = first_ring_; h < last_ring_ && !in_hole; ++h) {
        in_hole = o_.rings[h].is_hole() && o_.rings[h].polygon == o_.rings[r].polygon &&
                  lies_inside(outer, h);
      }
      if (!in_hole) report("polygons overlap", o_.rings[outer].begin);
    }
  }

  std::vector<std::size_t>& ring_of_;
  std::vector<std::size_t>& cell_begin_;
  std::vector<SiteId>& in_cells_;
  std::vector<RingBox>& boxes_;
  const Operands& o_;
  Predicates predicates_;
  int operand_;
  std::size_t max_faults_;
  std::vector<Fault>& faults_;
  std::size_t first_ring_ = 0;
  std::size_t last_ring_ = 0;
  SiteId begin_ = 0;
  SiteId end_ = 0;
  std::set<std::pair<SiteId, std::string>> reported_;
};

}  // namespace

void find_faults(Operands& operands, int operand, std::size_t max_faults,
                 std::vector<Fault>& faults) {
  ContactFinder finder(operands, operand, max_faults, faults);
  finder.find_contacts();
  // Whether a ring lies in its place means something only if no rings cross.
  if (faults.empty() && operands.rings.size() > 1) finder.find_misplaced_rings();
}

}  // namespace minksum
