// Segments that overlap on one line, in one direction, are one.
#include <algorithm>
#include <cstdint>

#include "arrangement/arrangement.hpp"
#include "predicate/formulas.hpp"

namespace minksum {
namespace {

Vec<Int128> exact(const Vec<double>& v) {
  return {static_cast<std::int64_t>(v.x), static_cast<std::int64_t>(v.y)};
}

/// By line, and along it.
void list_places(const Operands& o, const std::vector<KeptSegment>& kept, JoinScratch& scratch) {
  scratch.edge_of_rank.resize(o.rank_count);
  for (const SiteId e : o.by_direction) scratch.edge_of_rank[o.rank[e]] = e;
  scratch.places.clear();
  for (KeptId id = 0; id < kept.size(); ++id) {
    const DirectionRank rank = o.rank[kept[id].segment.edge];
    const SiteId e = scratch.edge_of_rank[rank];
    const Vec<double> d{o.sites.dx[e], o.sites.dy[e]};
    const auto along = [&d](const Vec<double>& p) {
      const double place = d.x != 0 ? p.x : p.y;
      return (d.x != 0 ? d.x : d.y) > 0 ? place : -place;
    };
    scratch.places.push_back({cross(exact(d), exact(kept[id].a)), along(kept[id].a),
                              along(kept[id].b), rank, id});
  }
  std::sort(scratch.places.begin(), scratch.places.end(),
            [](const PlaceOnLine& s, const PlaceOnLine& t) {
              if (s.rank != t.rank) return s.rank < t.rank;
              if (s.line != t.line) return s.line < t.line;
              return s.from != t.from ? s.from < t.from : s.id < t.id;
            });
}

}  // namespace

bool lines_are_joined(const Operands& o, std::size_t segments) {
  constexpr std::size_t kSegmentsPerDirection = 8;  // then many may share lines
  const bool exact = o.bounds.difference == 0 && o.bounds.direction == 0;
  return exact && segments >= kSegmentsPerDirection * o.rank_count;
}

void join_lines(const Operands& o, bool wanted, JoinScratch& scratch,
                std::vector<KeptSegment>& kept) {
  scratch.joined.clear();
  scratch.members.clear();
  if (!wanted) return;
  list_places(o, kept, scratch);
  auto& members = scratch.members;
  auto& result = scratch.result;
  result.clear();
  const auto& places = scratch.places;
  for (std::size_t i = 0; i < places.size();) {
    const PlaceOnLine& start = places[i];
    const std::size_t first = members.size();
    members.push_back(kept[start.id]);
    double reach = start.to;
    for (++i; i < places.size() && places[i].rank == start.rank && places[i].line == start.line &&
              places[i].from <= reach;
         ++i) {
      if (places[i].to <= reach) continue;
      reach = places[i].to;
      members.push_back(kept[places[i].id]);
    }
    KeptSegment whole = members[first];
    if (members.size() == first + 1) {
      members.pop_back();
    } else {
      whole.b = members.back().b;
      whole.d = {whole.b.x - whole.a.x, whole.b.y - whole.a.y};
      scratch.joined.push_back({members.back().segment, static_cast<KeptId>(first),
                                static_cast<KeptId>(members.size())});
      whole.joined = static_cast<std::uint32_t>(scratch.joined.size());
    }
    result.push_back(whole);
  }
  std::swap(kept, result);
}

}  // namespace minksum
