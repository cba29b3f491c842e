#include "sum/filters/filters.hpp"

#include <algorithm>
#include <cmath>

#include "exact/share_decisions.hpp"
#include "machine/make_room.hpp"

namespace minksum {
namespace {

class LoopFilter {
 public:
  LoopFilter(const Arrangement& arrangement, const Loops& loops, Predicates& predicates)
      : arrangement_(arrangement),
        loops_(loops),
        predicates_(predicates),
        order_(arrangement, predicates) {}

  /// Returns the loop that is the sum's outer boundary if the operands are connected. It is the
  /// positive loop that has the lexicographically smallest node.
  [[nodiscard]] std::size_t outermost() {
    std::size_t best = loops_.size();
    NodeId best_node = 0;
    for (std::size_t i = 0; i < loops_.size(); ++i) {
      if (loops_.positive[i] == 0) continue;
      const NodeId node = smallest_node(i);
      if (best == loops_.size() || order_.compare(node, best_node) == kNegative) {
        best = i;
        best_node = node;
      }
    }
    return best;
  }

  /// Returns a probe at the loop's longest piece, where a probe's place needs the fewest bits.
  [[nodiscard]] Probe probe(std::size_t loop, Fraction& exact) const {
    PieceId longest = loops_.loop(loop)[0];
    double best = -1;
    predicates_.cancellation().check(1 + loops_.loop(loop).size());
    for (const PieceId p : loops_.loop(loop)) {
      const Vec<double>& a = node(arrangement_.pieces[p].from).at;
      const Vec<double>& b = node(arrangement_.pieces[p].to).at;
      const double length = std::abs(b.x - a.x) + std::abs(b.y - a.y);
      if (length > best) {
        best = length;
        longest = p;
      }
    }
    return probe_on(arrangement_, arrangement_.pieces[longest], predicates_, exact);
  }

 private:
  [[nodiscard]] const Node& node(NodeId id) const { return arrangement_.nodes[id]; }
  NodeId smallest_node(std::size_t loop) {
    NodeId best = arrangement_.pieces[loops_.loop(loop)[0]].from;
    visit_in_pieces(loops_.loop(loop), predicates_.cancellation(), [&](PieceId p) {
      const NodeId from = arrangement_.pieces[p].from;
      if (order_.compare(from, best) == kNegative) best = from;
    });
    return best;
  }

  const Arrangement& arrangement_;
  const Loops& loops_;
  Predicates& predicates_;
  NodeOrder order_;
};

}  // namespace

Probe probe_on(const Arrangement& arrangement, const Piece& piece, const Predicates& predicates,
               Fraction& exact) {
  const Segment& segment = arrangement.kept[piece.segment].segment;
  const Node& from = arrangement.nodes[piece.from];
  const Node& to = arrangement.nodes[piece.to];
  const Vec<double> a = predicates.start(segment);
  const Vec<double> d = predicates.direction(segment.edge);
  const bool by_x = std::abs(d.x) >= std::abs(d.y);
  const auto lambda = [&](const Vec<double>& p) {
    return by_x ? (p.x - a.x) / d.x : (p.y - a.y) / d.y;
  };
  const double length = std::abs(by_x ? d.x : d.y);
  const RoundingBounds& bounds = predicates.bounds();
  const double doubt = bounds.position / length + 4 * bounds.direction + 0x1p-50;
  const double low = std::max(0.0, lambda(from.at)) + from.error / length + doubt;
  const double high = std::min(1.0, lambda(to.at)) - to.error / length - doubt;
  // These are the fewest bits that put a point well between both nodes.
  if (high - low > 0x1p-50) {
    const double middle = low + (high - low) / 2;
    const int shift = std::max(1, 2 - std::ilogb(high - low));
    const auto numerator = static_cast<std::int64_t>(std::ldexp(middle, shift));
    const double rounded = std::ldexp(static_cast<double>(numerator), -shift);
    if (rounded > low && rounded < high) return {segment, numerator, shift};
  }
  const ExactKernel& kernel = predicates.kernel();
  exact =
      (kernel.exact_parameter(segment, from.point) + kernel.exact_parameter(segment, to.point)) *
      Fraction(1, 2);
  return {segment, 0, 0, &exact};
}

void filter_loops(const Operands& operands, const Arrangement& arrangement, const Loops& loops,
                  Predicates& predicates, BoxTrees& trees, FilteredLoops& filtered) {
  filtered.state.assign(loops.size(), LoopState::kAccepted);
  filtered.rejected_by_nesting = 0;
  filtered.rejected_by_collision = 0;
  LoopFilter filter(arrangement, loops, predicates);
  const std::size_t outermost = operands.connected ? filter.outermost() : loops.size();
  if (operands.connected && outermost == loops.size()) {
    throw Error(ErrorCode::kInternal, "no loop is the outer boundary", {}, "filters");
  }
  if (loops.size() > 1 || !operands.connected) {
    trees.build(operands, predicates.cancellation());
  }
  constexpr std::uint64_t kUnitsOfTest = 1 << 10;  // some hundred pairs of boxes
  const std::size_t tasks =
      tasks_for(kUnitsOfTest * loops.size() + loops.pieces.size(), predicates.cancellation());
  share_decisions(tasks, predicates, [&](std::size_t task, std::size_t member, Predicates& decide) {
    const LoopFilter judge(arrangement, loops, decide);
    std::vector<BoxPair> own_stack;
    CollisionTest collision(operands, trees, member == 0 ? trees.stack : own_stack, decide);
    Fraction exact;
    const std::size_t end = begin_of(task + 1, tasks, loops.size());
    for (std::size_t i = begin_of(task, tasks, loops.size()); i < end; ++i) {
      if (i == outermost) continue;
      // The nesting filter rejects every positive loop but the outermost, which is skipped above.
      if (operands.connected && loops.positive[i] != 0) {
        filtered.state[i] = LoopState::kRejectedByNesting;
      } else if (collision.meets(judge.probe(i, exact))) {
        filtered.state[i] = LoopState::kRejectedByCollision;
      }
    }
  });
  for (const LoopState state : filtered.state) {
    filtered.rejected_by_nesting += state == LoopState::kRejectedByNesting ? 1U : 0U;
    filtered.rejected_by_collision += state == LoopState::kRejectedByCollision ? 1U : 0U;
  }
  // A sum that is not empty always has an outer boundary.
  if (std::find(filtered.state.begin(), filtered.state.end(), LoopState::kAccepted) ==
      filtered.state.end()) {
    throw Error(ErrorCode::kInternal, "no loop is left", {}, "filters");
  }
}

std::optional<std::string> check(const FilteredLoops& filtered, const Loops& loops,
                                 const Arrangement& arrangement, const Operands& operands) {
  if (filtered.state.size() != loops.size()) return "an array has the wrong size";
  const auto count = [&](LoopState state) {
    return static_cast<std::uint64_t>(
        std::count(filtered.state.begin(), filtered.state.end(), state));
  };
  if (count(LoopState::kRejectedByNesting) != filtered.rejected_by_nesting ||
      count(LoopState::kRejectedByCollision) != filtered.rejected_by_collision) {
    return "a count is wrong";
  }
  Cancellation never;
  Predicates predicates(operands.sites, *operands.kernel, operands.bounds, never);
  LoopFilter filter(arrangement, loops, predicates);
  BoxTrees trees;
  trees.build(operands, never);
  CollisionTest collision(operands, trees, trees.stack, predicates);
  Fraction exact;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    for (const PieceId p : loops.loop(i)) {
      const bool inside =
          collision.meets(probe_on(arrangement, arrangement.pieces[p], predicates, exact));
      if (inside == (filtered.state[i] == LoopState::kAccepted)) return "a loop was misjudged";
    }
  }
  return std::nullopt;
}

}  // namespace minksum
