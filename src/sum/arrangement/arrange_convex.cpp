// Arranges convex operands. Their whole convolution is one ring, which is the sum's boundary.
#include <array>

#include "machine/make_room.hpp"
#include "sum/arrangement/place_segments.hpp"

namespace minksum {

void arrange_convex(const Operands& o, Cancellation& cancellation, Arrangement& arrangement) {
  arrangement.kept.clear();
  arrangement.nodes.clear();
  arrangement.pieces.clear();
  arrangement.crossings = 0;
  arrangement.slits.clear();
  arrangement.crowded.clear();
  // The next edges start at `at`, because the edges of a convex ring are in order of direction.
  std::array<SiteId, 2> at{kNoSite, kNoSite};
  for (const SiteId edge : o.by_direction) {
    SiteId& start = at[static_cast<std::size_t>(o.operand_of(edge))];
    if (start == kNoSite) start = edge;
  }
  const auto count = static_cast<std::uint32_t>(o.by_direction.size());
  const auto add = [&](std::uint32_t i) {
    const SiteId edge = o.by_direction[i];
    const auto operand = static_cast<std::size_t>(o.operand_of(edge));
    const Segment segment{edge, at[1 - operand]};
    const KeptSegment& kept = arrangement.kept.emplace_back(place_segment(o, segment, {}));
    arrangement.nodes.push_back({{false, {}, {}, sum_vertex(edge, segment.vertex)}, kept.a,
                                 o.bounds.difference});
    arrangement.pieces.push_back({i, i + 1 == count ? 0 : i + 1, i});
    at[operand] = o.sites.next[edge];
  };
  in_pieces(count, cancellation, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) add(static_cast<std::uint32_t>(i));
  });
}

}  // namespace minksum
