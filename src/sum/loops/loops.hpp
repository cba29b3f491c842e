// Stage 5: finds orientable loops, the only closed chains that can bound a free face.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "machine/make_room.hpp"
#include "sum/arrangement/arrangement.hpp"

namespace minksum {

/// Closed chains of pieces. Each chain has one and the same face of the arrangement on its right.
///
/// A face is free only if it lies on the right of all its edges. So a chain that meets an edge from
/// the wrong side ends there and is no loop (Behar and Lien, section IV-C). By their Lemma 4.5, a
/// loop is boundary of the sum as a whole or not at all.
struct Loops {
  std::vector<PieceId> pieces;         ///< loop after loop, in order
  std::vector<std::uint32_t> begin;    ///< by loop: its first piece; and one entry more
  std::vector<std::uint8_t> positive;  ///< by loop: whether it runs counter-clockwise

  [[nodiscard]] std::size_t size() const { return begin.empty() ? 0 : begin.size() - 1; }
  [[nodiscard]] std::span<const PieceId> loop(std::size_t i) const {
    return std::span(pieces).subspan(begin[i], begin[i + 1] - begin[i]);
  }
};

/// The circle of directions. Directions are named by their ranks, so all work is on integers.
class DirectionCircle {
 public:
  explicit DirectionCircle(const Operands& operands, const Arrangement& arrangement)
      : operands_(&operands), arrangement_(&arrangement) {}
  [[nodiscard]] DirectionRank rank(PieceId piece) const {
    return arrangement_->kept[arrangement_->pieces[piece].segment].rank;
  }
  /// Returns a direction's place on a circle of `size()` places; `reverse` returns its reverse's.
  [[nodiscard]] std::uint32_t place(DirectionRank rank) const { return operands_->place[rank]; }
  [[nodiscard]] std::uint32_t reverse(DirectionRank rank) const {
    return operands_->reverse_place[rank];
  }
  [[nodiscard]] std::uint32_t size() const { return operands_->place_count; }
  /// Returns the steps counter-clockwise from one place to another.
  [[nodiscard]] std::uint32_t turn(std::uint32_t from, std::uint32_t to) const {
    return operands_->turn(from, to);
  }
  /// Returns how often a turn by less than half a circle passes the positive x axis, where places
  /// begin: -1, 0 or 1. A left turn passes it if the turn's end comes before the reverse of its
  /// begin, and that reverse before the begin. A right turn does in the opposite case.
  [[nodiscard]] int wraps(DirectionRank from, DirectionRank to) const {
    const std::uint32_t begin = place(from);
    const std::uint32_t back = reverse(from);
    const std::uint32_t end = place(to);
    return static_cast<int>((end < back) & (back < begin)) -
           static_cast<int>((begin < back) & (back < end));
  }

 private:
  const Operands* operands_;
  const Arrangement* arrangement_;
};

/// A piece that begins or ends at a node, with its place on the circle of directions around the
/// node.
struct Spoke {
  std::uint32_t place;
  std::uint32_t item;  ///< 2·piece for an outgoing, 2·piece + 1 for an incoming piece
  [[nodiscard]] PieceId piece() const { return item / 2; }
  [[nodiscard]] bool incoming() const { return item % 2 != 0; }
};

/// Pieces around nodes: lists of spokes by node.
struct Incidence {
  std::vector<std::uint32_t> begin;
  std::vector<Spoke> spokes;
  [[nodiscard]] std::span<const Spoke> at(NodeId node) const {
    return std::span(spokes).subspan(begin[node], begin[node + 1] - begin[node]);
  }
};
/// Lists each piece at those of its nodes for which `take(piece, node)` holds.
template <class Take>
void list_incidence(const Arrangement& arrangement, const DirectionCircle& circle, Take take,
                    Cancellation& cancellation, Incidence& incidence) {
  const auto& pieces = arrangement.pieces;
  const auto for_each_spoke = [&](auto visit) {
    in_pieces(pieces.size(), cancellation, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const auto p = static_cast<PieceId>(i);
        const auto& [from, to, segment] = pieces[p];
        if (take(p, from)) visit(from, Spoke{circle.place(circle.rank(p)), 2 * p});
        if (take(p, to)) visit(to, Spoke{circle.reverse(circle.rank(p)), 2 * p + 1});
      }
    });
  };
  list_by_key(arrangement.nodes.size(), cancellation, incidence.begin, incidence.spokes,
              for_each_spoke);
}

/// A summary of the pieces that begin or end at a node.
struct NodeEnds {
  PieceId out = kNoPiece;  ///< the last outgoing piece that was seen
  std::uint32_t degree = 0;
};

struct LoopScratch {
  std::vector<NodeEnds> ends;  ///< by node
  Incidence incidence;         ///< of nodes where more than two pieces end
  std::vector<PieceId> next;
  std::vector<PieceId> walk;  ///< by piece: first piece of the walk that came to it first
};

/// Finds all orientable loops. At each node a chain turns clockwise as far as it can.
/// O(pieces · degree).
void find_loops(const Operands& operands, const Arrangement& arrangement,
                Cancellation& cancellation, LoopScratch& scratch, Loops& loops);

/// Returns what is wrong with the loops, or nothing. Loops must close, and no piece may be in two.
[[nodiscard]] std::optional<std::string> check(const Loops& loops, const Arrangement& arrangement);

}  // namespace minksum
