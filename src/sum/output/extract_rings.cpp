// Links accepted pieces into simple rings.
#include <algorithm>

#include "machine/make_room.hpp"
#include "sum/output/output.hpp"

namespace minksum {
namespace {

constexpr std::uint32_t kNotOnStack = 0xFFFFFFFFU;

[[noreturn]] void broken(const char* what) {
  throw Error(ErrorCode::kInternal, what, {}, "output");
}

class RingExtractor {
 public:
  RingExtractor(const Operands& operands, const Arrangement& arrangement, Predicates& predicates,
                OutputScratch& scratch, Boundary& boundary)
      : arrangement_(arrangement),
        circle_(operands, arrangement),
        order_(arrangement, predicates),
        cancellation_(predicates.cancellation()),
        scratch_(scratch),
        boundary_(boundary) {}

  void run(const Loops& loops, const FilteredLoops& filtered) {
    if (loops_are_rings(loops, filtered)) {
      for (std::size_t i = 0; i < loops.size(); ++i) {
        if (filtered.state[i] == LoopState::kAccepted) {
          add_ring(loops.loop(i), static_cast<std::uint32_t>(i));
        }
      }
      return;
    }
    accept(loops, filtered);
    list_incidence(
        arrangement_, circle_, [&](PieceId p, NodeId) { return scratch_.accepted[p] != 0; },
        cancellation_, scratch_.incidence);
    assign_in_pieces(scratch_.stack_place, arrangement_.nodes.size(), kNotOnStack, cancellation_);
    std::uint32_t walk = 0;
    for (std::size_t i = 0; i < loops.size(); ++i) {
      if (filtered.state[i] != LoopState::kAccepted) continue;
      for (const PieceId p : loops.loop(i)) {
        if (scratch_.accepted[p] == kAccepted) follow(p, walk++);
      }
    }
  }

 private:
  static constexpr std::uint8_t kAccepted = 1;
  static constexpr std::uint8_t kFollowed = 2;

  /// Whether the accepted loops pass no node twice. Then they are simple rings that touch nowhere.
  bool loops_are_rings(const Loops& loops, const FilteredLoops& filtered) {
    assign_in_pieces(scratch_.passed, arrangement_.nodes.size(), std::uint8_t{0}, cancellation_);
    for (std::size_t i = 0; i < loops.size(); ++i) {
      cancellation_.check(1 + loops.loop(i).size());
      if (filtered.state[i] != LoopState::kAccepted) continue;
      for (const PieceId p : loops.loop(i)) {
        std::uint8_t& passed = scratch_.passed[arrangement_.pieces[p].from];
        if (passed != 0) return false;
        passed = 1;
      }
    }
    return true;
  }

  void accept(const Loops& loops, const FilteredLoops& filtered) {
    assign_in_pieces(scratch_.accepted, arrangement_.pieces.size(), std::uint8_t{0}, cancellation_);
    for (std::size_t i = 0; i < loops.size(); ++i) {
      cancellation_.check(1 + loops.loop(i).size());
      if (filtered.state[i] != LoopState::kAccepted) continue;
      for (const PieceId p : loops.loop(i)) scratch_.accepted[p] = kAccepted;
    }
  }

  /// Returns the piece after `piece` around the sum's interior on its left. That is the first one
  /// clockwise from `piece` at the node.
  [[nodiscard]] PieceId successor(PieceId piece) const {
    const auto spokes = scratch_.incidence.at(arrangement_.pieces[piece].to);
    cancellation_.check(1 + spokes.size());
    const std::uint32_t back = circle_.reverse(circle_.rank(piece));
    std::uint32_t best_turn = circle_.size();
    std::uint32_t best = kNoPiece;
    for (const Spoke& spoke : spokes) {
      if (spoke.item == 2 * piece + 1) continue;
      const std::uint32_t turn = circle_.turn(spoke.place, back);
      if (turn < best_turn) {
        best_turn = turn;
        best = spoke.item;
      }
    }
    if (best == kNoPiece || best % 2 != 0) broken("the boundary does not go on at a node");
    return best / 2;
  }

  /// Walks along the interior from `first` until the walk closes. Cuts off a ring at each return to
  /// a node.
  void follow(PieceId first, std::uint32_t walk) {
    auto& stack = scratch_.stack;
    auto& place = scratch_.stack_place;
    stack.clear();
    PieceId p = first;
    do {
      if (scratch_.accepted[p] != kAccepted) broken("two walks share a piece");
      scratch_.accepted[p] = kFollowed;
      const NodeId from = arrangement_.pieces[p].from;
      if (place[from] != kNotOnStack) cut(place[from], walk);
      place[from] = static_cast<std::uint32_t>(stack.size());
      stack.push_back(p);
      p = successor(p);
    } while (p != first);
    cut(0, walk);
  }

  /// Takes the pieces from `begin` on off the stack. They are a ring.
  void cut(std::uint32_t begin, std::uint32_t walk) {
    const std::span<const PieceId> ring = std::span(scratch_.stack).subspan(begin);
    for (const PieceId p : ring) {
      scratch_.stack_place[arrangement_.pieces[p].from] = kNotOnStack;
    }
    add_ring(ring, walk);
    scratch_.stack.resize(begin);
  }

  void add_ring(std::span<const PieceId> ring, std::uint32_t walk) {
    cancellation_.check(ring.size());
    BoundaryRing result;
    result.begin = static_cast<std::uint32_t>(boundary_.vertices.size());
    result.walk = walk;
    int rotation = 0;
    DirectionRank previous = circle_.rank(ring.back());
    for (const PieceId p : ring) {
      const DirectionRank rank = circle_.rank(p);
      if (rank == previous) continue;
      boundary_.vertices.push_back({arrangement_.pieces[p].from, p});
      rotation += circle_.wraps(previous, rank);
      previous = rank;
    }
    result.end = static_cast<std::uint32_t>(boundary_.vertices.size());
    result.positive = rotation > 0;
    if ((rotation != 1 && rotation != -1) || result.end < result.begin + 3) {
      broken("a boundary ring is not simple");
    }
    start_at_smallest(result);
    boundary_.rings.push_back(result);
  }

  void start_at_smallest(const BoundaryRing& ring) {
    const auto begin = boundary_.vertices.begin() + ring.begin;
    const auto end = boundary_.vertices.begin() + ring.end;
    auto smallest = begin;
    const auto others =
        std::span(boundary_.vertices).subspan(ring.begin + 1, ring.end - ring.begin - 1);
    visit_in_pieces(others, cancellation_, [&](const BoundaryVertex& v) {
      if (order_.compare(v.node, smallest->node) == kNegative) smallest = begin + (&v - &*begin);
    });
    std::rotate(begin, smallest, end);
  }

  const Arrangement& arrangement_;
  DirectionCircle circle_;
  NodeOrder order_;
  Cancellation& cancellation_;
  OutputScratch& scratch_;
  Boundary& boundary_;
};

}  // namespace

void extract_rings(const Operands& operands, const Arrangement& arrangement, const Loops& loops,
                   const FilteredLoops& filtered, Predicates& predicates, OutputScratch& scratch,
                   Boundary& boundary) {
  boundary.vertices.clear();
  boundary.rings.clear();
  RingExtractor(operands, arrangement, predicates, scratch, boundary).run(loops, filtered);
  order_rings(arrangement, predicates, scratch, boundary);
}

}  // namespace minksum
