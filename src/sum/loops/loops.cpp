#include "sum/loops/loops.hpp"

#include <atomic>

#include "machine/team.hpp"

namespace minksum {
namespace {

/// Returns the piece that follows an incoming one around the face on its right, if that piece goes
/// out.
///
/// Seen from the node, that face lies counter-clockwise of the incoming piece, up to the first
/// other piece. If that one comes in, it has the face on its left, and there is no loop.
PieceId successor(const Spoke& back, std::span<const Spoke> spokes, const DirectionCircle& circle) {
  std::uint32_t best_turn = circle.size();
  std::uint32_t best = kNoPiece;
  bool tie = false;
  for (const Spoke& spoke : spokes) {
    if (spoke.item == back.item) continue;
    const std::uint32_t turn = circle.turn(back.place, spoke.place);
    tie = turn == best_turn || (tie && turn > best_turn);
    if (turn < best_turn) {
      best_turn = turn;
      best = spoke.item;
    }
  }
  // Turn 0 means that a piece runs back over this one, and a tie means that two pieces lie over
  // each other. Neither happens where all crossings are known, that is, on the boundary.
  if (best == kNoPiece || tie || best_turn == 0 || best % 2 != 0) return kNoPiece;
  return best / 2;
}

/// Whether two pieces are parallel, with opposite senses.
bool run_against(const Arrangement& arrangement, PieceId a, PieceId b) {
  const KeptSegment& s = arrangement.kept[arrangement.pieces[a].segment];
  const KeptSegment& t = arrangement.kept[arrangement.pieces[b].segment];
  return s.line == t.line && s.rank != t.rank;
}

/// Sets the successor of each piece, or none.
void link_pieces(const Arrangement& arrangement, const DirectionCircle& circle,
                 Cancellation& cancellation, LoopScratch& scratch) {
  constexpr std::uint32_t kFew = 2;           // one piece comes in and one goes out: no choice
  constexpr std::uint64_t kUnitsOfPiece = 4;  // its node's pieces may not be in the cache
  const auto& pieces = arrangement.pieces;
  auto& ends = scratch.ends;
  assign_in_pieces(ends, arrangement.nodes.size(), NodeEnds{}, cancellation);
  in_pieces(pieces.size(), cancellation, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      NodeEnds& from = ends[pieces[p].from];
      from.out = static_cast<PieceId>(p);
      ++from.degree;
      ++ends[pieces[p].to].degree;
    }
  });
  resize_in_pieces(scratch.next, pieces.size(), cancellation);
  std::atomic<bool> any_choice = false;
  share_each(pieces.size(), kUnitsOfPiece, cancellation, [&](std::size_t p, Cancellation&) {
    const NodeEnds& at = ends[pieces[p].to];
    if (at.degree > kFew) any_choice.store(true, std::memory_order_relaxed);
    // The only piece to go on with may run straight back. Then there is no successor.
    const bool ahead =
        at.out != kNoPiece && !run_against(arrangement, static_cast<PieceId>(p), at.out);
    scratch.next[p] = ahead ? at.out : kNoPiece;
  });
  if (!any_choice) return;
  list_incidence(
      arrangement, circle, [&](PieceId, NodeId node) { return ends[node].degree > kFew; },
      cancellation, scratch.incidence);
  share_each(ends.size(), kUnitsOfPiece, cancellation, [&](std::size_t node, Cancellation& own) {
    if (ends[node].degree <= kFew) return;
    const std::span<const Spoke> spokes = scratch.incidence.at(static_cast<NodeId>(node));
    for (const Spoke& spoke : spokes) {
      if (!spoke.incoming()) continue;
      own.check(1 + spokes.size());
      scratch.next[spoke.piece()] = successor(spoke, spokes, circle);
    }
  });
}

}  // namespace

void find_loops(const Operands& operands, const Arrangement& arrangement,
                Cancellation& cancellation, LoopScratch& scratch, Loops& loops) {
  const DirectionCircle circle(operands, arrangement);
  link_pieces(arrangement, circle, cancellation, scratch);
  const std::size_t n = arrangement.pieces.size();
  loops.pieces.clear();
  loops.begin.assign(1, 0);
  loops.positive.clear();
  // Successors are unique both ways, so chains are paths or cycles. Each piece is marked with the
  // first piece of the walk that came to it. A walk that ends at its own mark has gone round.
  assign_in_pieces(scratch.walk, n, kNoPiece, cancellation);
  make_room(loops.pieces, n, cancellation);
  cancellation.counted(3 * n, [&](auto step) {
    for (PieceId first = 0; first < n; ++first) {
      step();
      PieceId p = first;
      while (p != kNoPiece && scratch.walk[p] == kNoPiece) {
        step();
        scratch.walk[p] = first;
        p = scratch.next[p];
      }
      if (p == kNoPiece || scratch.walk[p] != first) continue;
      int rotation = 0;
      const PieceId start = p;
      do {
        step();
        loops.pieces.push_back(p);
        rotation += circle.wraps(circle.rank(p), circle.rank(scratch.next[p]));
        p = scratch.next[p];
      } while (p != start);
      loops.begin.push_back(static_cast<std::uint32_t>(loops.pieces.size()));
      loops.positive.push_back(rotation > 0 ? 1 : 0);
    }
  });
}

std::optional<std::string> check(const Loops& loops, const Arrangement& arrangement) {
  if (loops.positive.size() != loops.size()) return "an array has the wrong size";
  std::vector<std::uint8_t> used(arrangement.pieces.size(), 0);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const auto loop = loops.loop(i);
    if (loop.size() < 3) return "a loop has fewer than three pieces";
    for (std::size_t k = 0; k < loop.size(); ++k) {
      if (loop[k] >= used.size()) return "a loop refers to a piece that is not there";
      if (used[loop[k]]++ != 0) return "a piece is in two loops";
      const Piece& piece = arrangement.pieces[loop[k]];
      const Piece& next = arrangement.pieces[loop[(k + 1) % loop.size()]];
      if (piece.to != next.from) return "a loop does not close";
    }
  }
  return std::nullopt;
}

}  // namespace minksum
