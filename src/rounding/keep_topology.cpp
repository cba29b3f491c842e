#include "rounding/keep_topology.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "machine/make_room.hpp"
#include "region/region_access.hpp"
#include "region/turned.hpp"
#include "rounding/orientation.hpp"
#include "validation/prepared_operand.hpp"

namespace minksum {
namespace {

/// Disjoint sets of numbers.
class Classes {
 public:
  explicit Classes(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  [[nodiscard]] std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// Joins two classes. Returns false if they were one class before.
  bool join(std::size_t a, std::size_t b) {
    a = find(a);
    b = find(b);
    parent_[a] = b;
    return a != b;
  }

 private:
  std::vector<std::size_t> parent_;
};

class TopologyChecker {
 public:
  TopologyChecker(const Region& exact, const Region& moved, Cancellation& cancellation)
      : cancellation_(cancellation),
        exact_(exact),
        moved_(moved),
        keeps_origins_(exact.has_origins() && exact.vertex_count() == moved.vertex_count()) {}

  TopologyCheck run() {
    if (moved_.empty()) return {TopologyVerdict::kKept, {}};
    std::vector<Fault> faults;
    load_sites(moved_, {}, cancellation_, operand_);
    clean_rings({}, cancellation_, scratch_, operand_, faults);
    if (!faults.empty() || turned_over()) return {};
    find_faults(1, cancellation_, scratch_, operand_, faults);
    if (!faults.empty()) return {};
    return {interiors_connected() ? TopologyVerdict::kKept : TopologyVerdict::kCut, write()};
  }

 private:
  /// Tells whether some ring has lost its orientation. Cleaning directs rings by their kind. A ring
  /// was reversed unless its edges carry the names of the vertices at their starts.
  [[nodiscard]] bool turned_over() const {
    return std::any_of(operand_.rings.begin(), operand_.rings.end(), [&](const OperandRing& ring) {
      const bool reversed = operand_.edge_source[ring.begin] != operand_.vertex_source[ring.begin];
      const std::size_t source = RegionAccess::ring_of(moved_, operand_.vertex_source[ring.begin]);
      return reversed != (counter_clockwise(exact_, source, cancellation_) == ring.is_hole());
    });
  }

  [[nodiscard]] bool interiors_connected() {
    Classes points(operand_.size());
    for (const RingTouch& touch : scratch_.touches) {
      cancellation_.check();
      if (touch.at_vertex) points.join(touch.vertex, touch.other);
    }
    // These are the pairs of a ring and a point where it touches another ring of its polygon.
    std::vector<std::pair<std::size_t, std::size_t>> joints;
    for (const RingTouch& touch : scratch_.touches) {
      cancellation_.check(4);
      const std::size_t a = ring_of(operand_.rings, touch.vertex);
      const std::size_t b = ring_of(operand_.rings, touch.other);
      if (operand_.rings[a].polygon != operand_.rings[b].polygon) continue;
      const std::size_t point = points.find(touch.vertex);
      joints.emplace_back(a, point);
      joints.emplace_back(b, point);
    }
    sort_unique(joints, cancellation_);
    const std::size_t rings = operand_.rings.size();
    // Rings of several polygons may meet at one point, so each polygon has a node of its own there.
    std::vector<std::pair<std::size_t, std::size_t>> nodes;
    const auto node_of = [&](const std::pair<std::size_t, std::size_t>& joint) {
      return std::pair{std::size_t{operand_.rings[joint.first].polygon}, joint.second};
    };
    for (const auto& joint : joints) nodes.push_back(node_of(joint));
    sort_unique(nodes, cancellation_);
    Classes parts(rings + nodes.size());
    return std::all_of(joints.begin(), joints.end(), [&](const auto& joint) {
      cancellation_.check(4);
      const auto node = std::lower_bound(nodes.begin(), nodes.end(), node_of(joint));
      return parts.join(joint.first, rings + static_cast<std::size_t>(node - nodes.begin()));
    });
  }

  [[nodiscard]] Region write() const {
    Region result;
    for (const OperandRing& ring : operand_.rings) {
      if (!ring.is_hole()) result.begin_polygon();
      result.begin_ring();
      for (SiteId v = ring.begin; v < ring.end; ++v) copy_vertex(v, result);
    }
    return in_canonical_order(result, cancellation_);
  }

  void copy_vertex(SiteId site, Region& result) const {
    cancellation_.check(2);
    const std::size_t v = operand_.vertex_source[site];
    const StoredCoordinate& x = RegionAccess::x(moved_, v);
    const StoredCoordinate& y = RegionAccess::y(moved_, v);
    // Coordinates with digits of their own are too long for anybody who asks for origins.
    if (!keeps_origins_ || x.denominator_limbs != 0 || y.denominator_limbs != 0) {
      RegionAccess::copy_vertex(result, moved_, v);
    } else {
      RegionAccess::add_vertex(result, x, y, exact_.origin(operand_.edge_source[site]));
    }
  }

  Cancellation& cancellation_;
  const Region& exact_;
  const Region& moved_;
  bool keeps_origins_;
  OperandScratch scratch_;
  PreparedOperand operand_;
};

}  // namespace

TopologyCheck check_topology(const Region& exact, const Region& moved, Cancellation& cancellation) {
  return TopologyChecker(exact, moved, cancellation).run();
}

}  // namespace minksum
