// Joins segments that overlap on one line in one direction.
#include <algorithm>
#include <cstdint>

#include "exact/formulas.hpp"
#include "exact/wide_int.hpp"
#include "machine/make_room.hpp"
#include "sum/arrangement/arrangement.hpp"

namespace minksum {
namespace {

Vec<Int128> exact(const Vec<double>& v) {
  return {static_cast<std::int64_t>(v.x), static_cast<std::int64_t>(v.y)};
}

/// Lists the places of segments on lines, sorted by line and then along it.
class PositionLister {
 public:
  PositionLister(const Operands& o, const std::vector<KeptSegment>& kept,
                 Cancellation& cancellation, JoinScratch& scratch)
      : o_(o),
        kept_(kept),
        cancellation_(cancellation),
        scratch_(scratch),
        doubles_tell_(o.bounds.product == 0) {}

  void run() {
    scratch_.edge_of_rank.resize(o_.rank_count);
    for (const SiteId e : o_.by_direction) scratch_.edge_of_rank[o_.rank[e]] = e;
    scratch_.places.clear();
    scratch_.places.reserve(kept_.size());
    in_pieces(kept_.size(), cancellation_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t id = begin; id < end; ++id) list_place(static_cast<KeptId>(id));
    });
    doubles_tell_ ? sort<true>() : sort<false>();
  }
  [[nodiscard]] bool same_line(const LinePosition& s, const LinePosition& t) const {
    return s.rank == t.rank && s.line == t.line &&
           (doubles_tell_ || exact_line(s) == exact_line(t));
  }

 private:
  void list_place(KeptId id) {
    const DirectionRank rank = o_.rank[kept_[id].segment.edge];
    const Vec<double> d = direction(rank);
    const auto along = [&d](const Vec<double>& p) {
      const double place = d.x != 0 ? p.x : p.y;
      return (d.x != 0 ? d.x : d.y) > 0 ? place : -place;
    };
    const Vec<double>& a = kept_[id].a;
    const double line =
        doubles_tell_ ? cross(d, a) : static_cast<double>(cross(exact(d), exact(a)));
    scratch_.places.push_back({line, along(a), along(kept_[id].b), rank, id});
  }
  template <bool kDoublesTell>
  void sort() {
    sort_in_pieces(scratch_.places.begin(), scratch_.places.end(), cancellation_,
                   [&](const LinePosition& s, const LinePosition& t) {
                     if (s.rank != t.rank) return s.rank < t.rank;
                     if (s.line != t.line) return s.line < t.line;
                     if constexpr (!kDoublesTell) {
                       const Int128 line_s = exact_line(s);
                       const Int128 line_t = exact_line(t);
                       if (line_s != line_t) return line_s < line_t;
                     }
                     return s.from != t.from ? s.from < t.from : s.id < t.id;
                   });
  }
  [[nodiscard]] Vec<double> direction(DirectionRank rank) const {
    const SiteId e = scratch_.edge_of_rank[rank];
    return {o_.sites.dx[e], o_.sites.dy[e]};
  }
  [[nodiscard]] Int128 exact_line(const LinePosition& place) const {
    return cross(exact(direction(place.rank)), exact(kept_[place.id].a));
  }

  const Operands& o_;
  const std::vector<KeptSegment>& kept_;
  Cancellation& cancellation_;
  JoinScratch& scratch_;
  bool doubles_tell_;  ///< whether cross products have no rounding
};

}  // namespace

bool lines_are_joined(const Operands& o, std::size_t segments) {
  constexpr std::size_t kSegmentsPerDirection = 8;  // if there are more, many may share lines
  const bool exact = o.bounds.difference == 0 && o.bounds.direction == 0;
  return exact && segments >= kSegmentsPerDirection * o.rank_count;
}

void join_lines(const Operands& o, bool wanted, Cancellation& cancellation, JoinScratch& scratch,
                std::vector<KeptSegment>& kept) {
  scratch.joined.clear();
  scratch.members.clear();
  if (!wanted) return;
  PositionLister lister(o, kept, cancellation, scratch);
  lister.run();
  auto& members = scratch.members;
  auto& result = scratch.result;
  result.clear();
  const auto& places = scratch.places;
  result.reserve(places.size());
  cancellation.counted(places.size(), [&](auto step) {
    for (std::size_t i = 0; i < places.size();) {
      step();
      const LinePosition& start = places[i];
      const std::size_t first = members.size();
      members.push_back(kept[start.id]);
      double reach = start.to;
      for (++i; i < places.size() && lister.same_line(places[i], start) && places[i].from <= reach;
           ++i) {
        step();
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
  });
  std::swap(kept, result);
}

}  // namespace minksum
