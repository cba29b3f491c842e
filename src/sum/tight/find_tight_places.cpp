#include <algorithm>

#include "sum/tight/overlap_test.hpp"

namespace minksum {
namespace {

class TightFinder {
 public:
  TightFinder(const Operands& operands, const Arrangement& arrangement, Predicates& predicates,
              BoxTrees& trees, TightScratch& scratch)
      : o_(operands),
        arrangement_(arrangement),
        predicates_(predicates),
        scratch_(scratch),
        test_(operands, trees, predicates, scratch) {}

  [[nodiscard]] bool is_free(const ContactPosition& x) { return !test_.overlaps(x); }
  [[nodiscard]] static ContactPosition at(const Node& node) {
    return {&node, {}, node.at, node.error};
  }
  [[nodiscard]] ContactPosition at(const Probe& probe) const {
    const RoundingBounds& bounds = predicates_.bounds();
    const double error = bounds.position + bounds.magnitude * 0x1p-49;
    return {nullptr, probe, predicates_.position(probe), error};
  }
  [[nodiscard]] Node node_at(const SumVertex& v) const {
    return {{false, {}, {}, v}, predicates_.position(v), predicates_.bounds().difference};
  }

  /// Lists points at which two corners of each operand alternate, and P° and (x − Q)° do not meet.
  void find_pinches(std::vector<SumVertex>& pinches) {
    const TouchingRings& p = scratch_.touching[0];
    const TouchingRings& q = scratch_.touching[1];
    if (!p.parts_inside || !q.parts_inside) return;
    for (std::size_t i = 0; i < p.point.size(); ++i) {
      for (std::size_t j = 0; j < q.point.size(); ++j) {
        predicates_.cancellation().check(4);
        if (!alternate(corners_at(p, i), corners_at(q, j))) continue;
        const SumVertex v{p.point[i], q.point[j]};
        if (is_free(at(node_at(v)))) pinches.push_back(v);
      }
    }
  }

  /// Whether a slit is free. That is the same all along the slit but for pinches on it, so the
  /// point that is tested is no pinch.
  [[nodiscard]] bool slit_is_free(const Piece& slit, const std::vector<SumVertex>& pinches) {
    Fraction position;
    Probe probe = probe_on(arrangement_, slit, predicates_, position);
    while (is_free(at(probe))) {
      const auto is_here = [&](const SumVertex& v) {
        predicates_.count_kernel();
        const ExactKernel& kernel = predicates_.kernel();
        return kernel.probe_compare(probe, v, Axis::kX) == kZero &&
               kernel.probe_compare(probe, v, Axis::kY) == kZero;
      };
      if (std::none_of(pinches.begin(), pinches.end(), is_here)) return true;
      const ExactKernel& kernel = predicates_.kernel();
      const Fraction from = kernel.exact_parameter(probe.segment, node(slit.from).point);
      position = ((exact_position(probe) + from) * Fraction(1, 2)).reduced();
      probe = {probe.segment, 0, 0, &position};
    }
    return false;
  }
  [[nodiscard]] static Fraction exact_position(const Probe& probe) {
    if (probe.exact != nullptr) return *probe.exact;
    return {probe.numerator, BigInteger(1) << probe.shift};
  }

 private:
  [[nodiscard]] const Node& node(NodeId id) const { return arrangement_.nodes[id]; }
  static std::span<const Corner> corners_at(const TouchingRings& touching, std::size_t point) {
    const std::size_t begin = point == 0 ? 0 : touching.end[point - 1];
    return std::span(touching.corners).subspan(begin, touching.end[point] - begin);
  }
  /// Whether two corners of P alternate with two of x − Q around a point. (It does not matter
  /// whether corners meet.)
  [[nodiscard]] bool alternate(std::span<const Corner> of_p, std::span<const Corner> of_q) {
    auto& order = around_;
    order.clear();
    for (const Corner& c : of_p) order.push_back({o_.place[o_.rank[c.out]], 0});
    for (const Corner& c : of_q) order.push_back({o_.reverse_place[o_.rank[c.out]], 1});
    std::sort(order.begin(), order.end());
    int changes = order.front().second != order.back().second ? 1 : 0;
    for (std::size_t i = 1; i < order.size(); ++i) {
      changes += order[i].second != order[i - 1].second ? 1 : 0;
    }
    return changes >= 4;
  }

  const Operands& o_;
  const Arrangement& arrangement_;
  Predicates& predicates_;
  TightScratch& scratch_;
  OverlapTest test_;
  std::vector<std::pair<std::uint32_t, int>> around_;
};

/// Marks nodes of the sum's boundary and of tight slits.
void mark_nodes(const Arrangement& arrangement, const Loops& loops, const FilteredLoops& filtered,
                const TightPlaces& places, std::vector<std::uint8_t>& marked) {
  marked.assign(arrangement.nodes.size(), 0);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (filtered.state[i] != LoopState::kAccepted) continue;
    for (const PieceId p : loops.loop(i)) marked[arrangement.pieces[p].from] = 1;
  }
  for (const std::uint32_t slit : places.slits) {
    marked[arrangement.slits[slit].from] = 1;
    marked[arrangement.slits[slit].to] = 1;
  }
}

}  // namespace

void find_tight_places(const Operands& operands, const Arrangement& arrangement, const Loops& loops,
                       const FilteredLoops& filtered, Predicates& predicates, BoxTrees& trees,
                       TightScratch& scratch, TightPlaces& places) {
  places.slits.clear();
  places.nodes.clear();
  places.pinches.clear();
  const std::span rings(operands.rings);
  const bool both_have_holes = has_holes(rings.first(operands.first_rings)) &&
                               has_holes(rings.subspan(operands.first_rings));
  if (arrangement.slits.empty() && arrangement.crowded.empty() && !both_have_holes) return;
  trees.build(operands, predicates.cancellation());
  TightFinder finder(operands, arrangement, predicates, trees, scratch);
  finder.find_pinches(places.pinches);
  for (std::uint32_t i = 0; i < arrangement.slits.size(); ++i) {
    if (finder.slit_is_free(arrangement.slits[i], places.pinches)) places.slits.push_back(i);
  }
  mark_nodes(arrangement, loops, filtered, places, scratch.marked);
  for (std::size_t i = 0; i < arrangement.crowded.size(); ++i) {
    predicates.cancellation().check();
    const NodeId node = arrangement.crowded[i];
    if (scratch.marked[node] == 0 && finder.is_free(TightFinder::at(arrangement.nodes[node]))) {
      places.nodes.push_back(node);
    }
  }
}

std::optional<std::string> check(const TightPlaces& places, const Arrangement& arrangement,
                                 const Loops& loops, const FilteredLoops& filtered,
                                 const Operands& operands) {
  Cancellation never;
  Predicates predicates(operands.sites, *operands.kernel, operands.bounds, never);
  BoxTrees trees;
  trees.build(operands, never);
  TightScratch scratch;
  TightFinder finder(operands, arrangement, predicates, trees, scratch);
  std::vector<std::uint8_t> listed(arrangement.slits.size(), 0);
  for (const std::uint32_t slit : places.slits) {
    if (slit >= listed.size()) return "a slit is not there";
    if (listed[slit]++ != 0) return "a slit is listed twice";
  }
  for (std::uint32_t i = 0; i < arrangement.slits.size(); ++i) {
    Fraction exact;
    const Piece& slit = arrangement.slits[i];
    const Probe middle = probe_on(arrangement, slit, predicates, exact);
    const Fraction to =
        operands.kernel->exact_parameter(middle.segment, arrangement.nodes[slit.to].point);
    const Fraction other =
        (Fraction(2) * TightFinder::exact_position(middle) + to) * Fraction(1, 3);
    const Probe probe{middle.segment, 0, 0, &other};
    if (finder.is_free(finder.at(probe)) != (listed[i] != 0)) return "a slit was misjudged";
  }
  mark_nodes(arrangement, loops, filtered, places, scratch.marked);
  for (const NodeId node : places.nodes) {
    if (node >= arrangement.nodes.size()) return "a point is not there";
    if (scratch.marked[node]++ != 0) return "a point is on the boundary or a slit, or listed twice";
    if (!finder.is_free(TightFinder::at(arrangement.nodes[node]))) return "a point is not tight";
  }
  for (const SumVertex& v : places.pinches) {
    const Node node = finder.node_at(v);
    if (!finder.is_free(TightFinder::at(node))) return "a pinch is not tight";
  }
  return std::nullopt;
}

}  // namespace minksum
