// Makes an operand of polylines: walked there and back, they are rings without area.
#include "machine/exceeded.hpp"
#include "sum/operands/operands.hpp"

namespace minksum {

void prepare_thin_operand(const Region& walks, const SumSettings& options,
                          Cancellation& cancellation, OperandScratch& scratch,
                          PreparedOperand& operand) {
  load_sites(walks, options, cancellation, operand);
  operand.thin = true;
  const auto n = static_cast<SiteId>(walks.vertex_count());
  approximate_sites(n, options, cancellation, scratch, operand);
  operand.rings.clear();
  for (const std::size_t ring : walks.polygons()) {
    const IndexRange vertices = walks.vertices_of(ring);
    const auto begin = static_cast<SiteId>(vertices.front());
    operand.rings.push_back({begin, begin + static_cast<SiteId>(vertices.size()),
                             static_cast<std::uint32_t>(ring), 0});
  }
  connect_rings(cancellation, operand);
  Predicates predicates(operand.sites, *operand.kernel, operand.bounds, cancellation);
  operand.convex.resize(n);
  operand.vertex_source.resize(n);
  for (SiteId i = 0; i < n; ++i) {
    // A vertex in line with its neighbours is an end, where the walk turns back.
    operand.convex[i] =
        predicates.orientation(operand.previous[i], i, operand.sites.next[i]) != kNegative ? 1 : 0;
    operand.vertex_source[i] = i;
  }
  operand.edge_source = operand.vertex_source;
  sort_directions(cancellation, scratch, operand);
}

void list_parallel_sums(const Operands& o, std::span<const Region, 2> walks, const Limits& limits,
                        Cancellation& cancellation, std::vector<Polyline>& sums) {
  sums.clear();
  const std::uint64_t work = 4 * o.kernel->work();
  const auto point = [&](SiteId site) {
    return walks[static_cast<std::size_t>(o.operand_of(site))].point(o.vertex_source[site]);
  };
  const auto bends = [&](SiteId site) {
    return o.rank[site] != o.rank[o.previous[site]] && !o.turns_back(site);
  };
  // The sum of two parallel edges is two pieces: one edge at an end of the other, and the other way
  // round. A piece is a side of a parallelogram if the polyline goes on in another direction there.
  const auto is_within_area = [&](SiteId e, SiteId f) {
    return (bends(f) && bends(o.sites.next[e])) || (bends(e) && bends(o.sites.next[f]));
  };
  const auto sum = [&](SiteId a, SiteId b) {
    const Point p = point(a);
    const Point q = point(b);
    return Point{p.x + q.x, p.y + q.y};
  };
  for (std::size_t i = 0, j = 0; i < o.by_direction.size(); i = j) {
    const DirectionRank rank = o.rank[o.by_direction[i]];
    while (j < o.by_direction.size() && o.rank[o.by_direction[j]] == rank) ++j;
    // Walks take each edge in both directions, and one of them is enough.
    if (o.place[rank] > o.reverse_place[rank]) continue;
    for (std::size_t k = i; k < j; ++k) {
      const SiteId e = o.by_direction[k];
      if (o.operand_of(e) != 0) continue;
      for (std::size_t l = i; l < j; ++l) {
        const SiteId f = o.by_direction[l];
        cancellation.check();
        if (o.operand_of(f) != 1 || is_within_area(e, f)) continue;
        cancellation.check(work);
        if (sums.size() >= limits.max_segments) {
          throw exceeded("Limits::max_segments", limits.max_segments, "polylines have",
                         "pairs of parallel edges");
        }
        sums.push_back({sum(e, f), sum(o.sites.next[e], o.sites.next[f])});
      }
    }
  }
}

}  // namespace minksum
