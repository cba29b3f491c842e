// Finds where rings of one polygon touch.
#include <algorithm>
#include <numeric>

#include "machine/make_room.hpp"
#include "sum/tight/tight.hpp"

namespace minksum {
namespace {

class TouchFinder {
 public:
  TouchFinder(const Operands& operands, const BoxTree& tree, Predicates& predicates,
              TouchingRings& touching)
      : o_(operands),
        tree_(tree),
        predicates_(predicates),
        cancellation_(predicates.cancellation()),
        result_(touching) {}

  void run(int operand) {
    const std::size_t first = operand == 0 ? 0 : o_.first_rings;
    const std::size_t last = operand == 0 ? o_.first_rings : o_.rings.size();
    for (std::size_t r = first; r < last; ++r) {
      const bool alone = (r == first || o_.rings[r - 1].polygon != o_.rings[r].polygon) &&
                         (r + 1 == last || o_.rings[r + 1].polygon != o_.rings[r].polygon);
      if (alone) continue;
      for (SiteId v = o_.rings[r].begin; v < o_.rings[r].end; ++v) list_touches(v, o_.rings[r]);
    }
    if (touches_.empty()) return;
    unite_points();
    result_.last_edge = o_.previous;
    ring_parent_.resize(o_.rings.size());
    std::iota(ring_parent_.begin(), ring_parent_.end(), 0U);
    for (std::size_t i = 0; i < members_.size();) {
      std::size_t j = i;
      while (j < members_.size() && members_[j].point == members_[i].point) ++j;
      link(std::span(members_).subspan(i, j - i));
      i = j;
    }
    sort_cuts();
  }

 private:
  /// A vertex on an edge of another ring, at the edge's start or within the edge.
  struct Touch {
    SiteId at;
    SiteId edge;
    bool at_start;
  };
  /// An edge that starts at a touching point or passes it. A vertex at the point names the point.
  struct Member {
    SiteId point;
    SiteId edge;
    bool starts;
    friend auto operator<=>(const Member&, const Member&) = default;
  };

  void list_touches(SiteId v, const OperandRing& ring) {
    const double x = o_.sites.x[v];
    const double y = o_.sites.y[v];
    const double doubt = predicates_.bounds().magnitude * 0x1p-49;
    const auto misses = [&](const BoxTree::Box& box) {
      cancellation_.check();
      return x < box.x0 - doubt || x > box.x1 + doubt || y < box.y0 - doubt || y > box.y1 + doubt;
    };
    tree_.any_edge(tree_.leaves(), misses, [&](SiteId e) {
      cancellation_.check();
      const bool own = e >= ring.begin && e < ring.end;
      if (!own && o_.rings[ring_index(e)].polygon == ring.polygon) add_touch(v, e);
      return false;
    });
  }
  void add_touch(SiteId v, SiteId e) {
    const SiteId f = o_.sites.next[e];
    if (predicates_.orientation(e, f, v) != kZero) return;
    const Axis axis = predicates_.component(e, Axis::kX) == kZero ? Axis::kY : Axis::kX;
    const Sign from_start = predicates_.compare(v, e, axis);
    if (from_start == kZero) {
      touches_.push_back({v, e, true});
    } else if (from_start == predicates_.compare(f, v, axis)) {
      touches_.push_back({v, e, false});
    }
  }
  [[nodiscard]] std::uint32_t ring_index(SiteId site) const {
    return static_cast<std::uint32_t>(ring_of(o_.rings, site));
  }

  void unite_points() {
    std::vector<std::uint32_t> parent(o_.size());
    std::iota(parent.begin(), parent.end(), 0U);
    for (const Touch& t : touches_) {
      if (t.at_start) parent[find_root(parent, t.at)] = find_root(parent, t.edge);
    }
    for (const Touch& t : touches_) {
      const SiteId point = find_root(parent, t.at);
      members_.push_back({point, t.at, true});
      members_.push_back({point, t.edge, t.at_start});
    }
    sort_unique(members_, cancellation_);
  }

  /// Makes the corners at a touching point. Each edge out of the point starts a corner, which goes
  /// counter-clockwise up to the first edge into the point.
  void link(std::span<const Member> around) {
    const SiteId point = around.front().point;
    for (const Member& out : around) {
      const std::uint32_t from = o_.place[o_.rank[out.edge]];
      SiteId last = kNoSite;
      std::uint32_t least = o_.place_count;
      cancellation_.check(around.size());
      for (const Member& other : around) {
        const SiteId in = other.starts ? o_.previous[other.edge] : other.edge;
        const std::uint32_t to = o_.reverse_place[o_.rank[in]];
        const std::uint32_t turn = o_.turn(from, to);
        if (turn < least) {
          least = turn;
          last = in;
        }
      }
      result_.corners.push_back({out.edge, last});
      if (out.starts) {
        result_.last_edge[out.edge] = last;
      } else {
        result_.cuts.push_back({out.edge, point, last});
      }
    }
    result_.point.push_back(point);
    result_.end.push_back(static_cast<std::uint32_t>(result_.corners.size()));
    join_rings(around);
  }
  /// Joins the rings at a touching point. If other touching points have joined two of these rings
  /// before, the two enclose something between them.
  void join_rings(std::span<const Member> around) {
    const std::uint32_t first = find_root(ring_parent_, ring_index(around.front().edge));
    for (const Member& member : around.subspan(1)) {
      const std::uint32_t ring = find_root(ring_parent_, ring_index(member.edge));
      if (ring == find_root(ring_parent_, first)) result_.parts_inside = true;
      ring_parent_[ring] = first;
    }
  }
  void sort_cuts() {
    const auto before = [&](const EdgeCut& a, const EdgeCut& b) {
      if (a.edge != b.edge) return a.edge < b.edge;
      const Axis axis = predicates_.component(a.edge, Axis::kX) == kZero ? Axis::kY : Axis::kX;
      return predicates_.compare(a.at, b.at, axis) == -predicates_.component(a.edge, axis);
    };
    std::sort(result_.cuts.begin(), result_.cuts.end(), cancellation_.counting(before));
  }

  const Operands& o_;
  const BoxTree& tree_;
  Predicates& predicates_;
  Cancellation& cancellation_;
  TouchingRings& result_;
  std::vector<Touch> touches_;
  std::vector<Member> members_;
  std::vector<std::uint32_t> ring_parent_;
};

}  // namespace

void find_touching_rings(const Operands& operands, int operand, const BoxTree& tree,
                         Predicates& predicates, TouchingRings& touching) {
  touching.last_edge.clear();
  touching.cuts.clear();
  touching.corners.clear();
  touching.point.clear();
  touching.end.clear();
  touching.parts_inside = false;
  TouchFinder(operands, tree, predicates, touching).run(operand);
}

}  // namespace minksum
