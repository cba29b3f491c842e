#include "sum/arrangement/arrangement.hpp"

#include <algorithm>

namespace minksum {

void arrange(const Operands& operands, const Convolution& convolution, const Cover& cover,
             const SumSettings& options, Predicates& predicates, ArrangementScratch& scratch,
             Arrangement& arrangement) {
  bin_segments(operands, convolution, cover, options.limits, predicates.cancellation(), scratch,
               arrangement);
  find_crossings(operands, cover, options, predicates, scratch, arrangement);
  split_segments(operands, cover, options.tight.value_or(false), predicates, scratch,
                 arrangement);
}

std::optional<std::string> check(const Arrangement& a, const Operands& operands) {
  const ExactKernel& kernel = *operands.kernel;
  std::vector<std::pair<NodeId, NodeId>> ends;
  for (const Piece& piece : a.pieces) {
    if (piece.segment >= a.kept.size() || piece.from >= a.nodes.size() ||
        piece.to >= a.nodes.size()) {
      return "a piece refers to what is not there";
    }
    if (piece.from == piece.to) return "a piece has no length";
    const Segment& segment = a.kept[piece.segment].segment;
    const NodePoint& from = a.nodes[piece.from].point;
    const NodePoint& to = a.nodes[piece.to].point;
    if (kernel.orientation(segment, from) != kZero || kernel.orientation(segment, to) != kZero) {
      return "a piece's end is not on its segment";
    }
    const SiteId edge = segment.edge;
    const SiteId next = operands.sites.next[edge];
    for (const Axis axis : {Axis::kX, Axis::kY}) {
      if (kernel.compare(to, from, axis) != kernel.compare(next, edge, axis)) {
        return "a piece runs against its segment";
      }
    }
    ends.emplace_back(std::min(piece.from, piece.to), std::max(piece.from, piece.to));
  }
  std::sort(ends.begin(), ends.end());
  if (std::adjacent_find(ends.begin(), ends.end()) != ends.end()) {
    return "two pieces have the same ends";
  }
  return std::nullopt;
}

}  // namespace minksum
