// Checks by exact numbers alone that a subdivision is as described.
#pragma once

#include <optional>
#include <string>

#include "overlay/subdivision.hpp"

namespace minksum::overlay {

class SubdivisionChecker {
 public:
  SubdivisionChecker(const Segments& segments, const Subdivision& subdivision)
      : segments_(segments), exact_(segments.predicates.exact()), s_(subdivision) {}

  std::optional<std::string> run() const {
    for (NodeId v = 1; v < s_.nodes.size(); ++v) {
      const Sign order = exact_.compare(s_.nodes[v - 1].place, s_.nodes[v].place);
      if (order == kZero) return "two nodes are one point";
      if (order == kPositive) return "nodes are not in order";
    }
    for (const Piece& piece : s_.pieces) {
      if (piece.low >= piece.high) return "a piece does not go up";
      for (const NodeId v : {piece.low, piece.high}) {
        if (exact_.orientation(ends_of(piece), s_.nodes[v].place) != kZero) {
          return "a piece ends off its segment";
        }
      }
    }
    for (NodeId v = 0; v < s_.nodes.size(); ++v) {
      if (auto fault = check_around(v)) return fault;
    }
    return check_pairs();
  }

 private:
  [[nodiscard]] const Ends& ends_of(const Piece& piece) const {
    return segments_.list[piece.segment].ends;
  }
  [[nodiscard]] std::optional<std::string> check_around(NodeId v) const {
    const std::uint32_t begin = s_.first_around[v];
    const std::uint32_t end = s_.first_around[v + 1];
    for (std::uint32_t i = begin; i < end; ++i) {
      const Piece& piece = s_.pieces[s_.around[i]];
      if (piece.low != v && piece.high != v) return "a piece is listed at a node that it misses";
      const Piece& next = s_.pieces[s_.around[i + 1 == end ? begin : i + 1]];
      const bool starts = piece.low == v;
      const bool next_starts = next.low == v;
      // Pieces that start here come first, from below. Those that end here follow, from above.
      if (!starts && next_starts && i + 1 != end) return "pieces around a node are out of order";
      if (i + 1 != end && starts == next_starts &&
          exact_.cross(ends_of(piece), ends_of(next)) != kPositive) {
        return "pieces around a node are not counter-clockwise";
      }
      const bool after = starts ? piece.inside_above : piece.inside_below;
      const bool before = next_starts ? next.inside_below : next.inside_above;
      if (after != before) return "a face is inside at one piece and outside at the next";
    }
    return std::nullopt;
  }

  /// Tests every pair of pieces, which may share only nodes that are ends of both.
  [[nodiscard]] std::optional<std::string> check_pairs() const {
    for (PieceId p = 0; p < s_.pieces.size(); ++p) {
      for (PieceId q = p + 1; q < s_.pieces.size(); ++q) {
        const Piece& a = s_.pieces[p];
        const Piece& b = s_.pieces[q];
        if (a.low == b.low && a.high == b.high) return "two pieces have the same ends";
        if (b.low >= a.high || a.low >= b.high) continue;  // one lies before the other
        const int sides_b = side(a, b.low) * side(a, b.high);
        const int sides_a = side(b, a.low) * side(b, a.high);
        if (sides_a < 0 && sides_b < 0) return "two pieces cross";
        if (inside(a, b.low) || inside(a, b.high) || inside(b, a.low) || inside(b, a.high)) {
          return "a node lies inside a piece";
        }
      }
    }
    return std::nullopt;
  }
  [[nodiscard]] int side(const Piece& piece, NodeId v) const {
    return exact_.orientation(ends_of(piece), s_.nodes[v].place);
  }
  [[nodiscard]] bool inside(const Piece& piece, NodeId v) const {
    return piece.low < v && v < piece.high && side(piece, v) == kZero;
  }

  const Segments& segments_;
  const ExactPoints& exact_;
  const Subdivision& s_;
};

/// Returns the first fault of a subdivision, or nothing. Nodes must be distinct and in order.
/// Pieces must meet only at nodes and be listed around them counter-clockwise. The pieces around a
/// face must agree on it. Every pair of pieces is tested.
[[nodiscard]] inline std::optional<std::string> check(const Segments& segments,
                                                      const Subdivision& subdivision) {
  return SubdivisionChecker(segments, subdivision).run();
}

}  // namespace minksum::overlay
