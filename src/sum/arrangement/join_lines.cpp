// Joins segments that overlap on one line in one direction.
#include <algorithm>
#include <cstdint>
#include <span>

#include "exact/formulas.hpp"
#include "exact/wide_int.hpp"
#include "machine/make_room.hpp"
#include "machine/team.hpp"
#include "sum/arrangement/arrangement.hpp"

namespace minksum {
namespace {

Vec<Int128> exact(const Vec<double>& v) {
  return {static_cast<std::int64_t>(v.x), static_cast<std::int64_t>(v.y)};
}

/// Joins segments that overlap on one line, direction by direction.
class LineJoiner {
 public:
  LineJoiner(const Operands& o, const std::vector<KeptSegment>& kept, JoinScratch& scratch)
      : o_(o), kept_(kept), scratch_(scratch), doubles_tell_(o.bounds.product == 0) {}

  /// Lists the places of all segments, direction by direction.
  void list_places(Cancellation& cancellation) {
    scratch_.edge_of_rank.resize(o_.rank_count);
    for (const SiteId e : o_.by_direction) scratch_.edge_of_rank[o_.rank[e]] = e;
    list_by_key(o_.rank_count, cancellation, scratch_.begin_of_rank, scratch_.places,
                [&](auto visit) {
                  in_pieces(kept_.size(), cancellation, [&](std::size_t first, std::size_t last) {
                    for (std::size_t id = first; id < last; ++id) {
                      const DirectionRank rank = o_.rank[kept_[id].segment.edge];
                      visit(rank, position(static_cast<KeptId>(id), rank));
                    }
                  });
                });
  }
  /// Returns the first direction that this task joins. Tasks have about as many segments each,
  /// unless one direction has most of them.
  [[nodiscard]] DirectionRank first_rank(std::size_t task, std::size_t tasks) const {
    const auto& begin = scratch_.begin_of_rank;
    const std::size_t place = begin_of(task, tasks, scratch_.places.size());
    const auto at = std::lower_bound(begin.begin(), begin.end() - 1, place);
    return static_cast<DirectionRank>(at - begin.begin());
  }
  /// Joins the segments of the directions from `first` to `last`, without the last one.
  void join(DirectionRank first, DirectionRank last, Cancellation& cancellation,
            JoinedPart& part) const {
    part.members.clear();
    part.result.clear();
    part.joined.clear();
    const auto& begin = scratch_.begin_of_rank;
    for (DirectionRank rank = first; rank < last; ++rank) {
      const Positions places =
          Positions(scratch_.places).subspan(begin[rank], begin[rank + 1] - begin[rank]);
      sort(places, rank, cancellation);
      join(places, rank, cancellation, part);
    }
  }

 private:
  using Positions = std::span<LinePosition>;

  [[nodiscard]] LinePosition position(KeptId id, DirectionRank rank) const {
    const Vec<double> d = direction(rank);
    const auto along = [&d](const Vec<double>& p) {
      const double place = d.x != 0 ? p.x : p.y;
      return (d.x != 0 ? d.x : d.y) > 0 ? place : -place;
    };
    const Vec<double>& a = kept_[id].a;
    const double line =
        doubles_tell_ ? cross(d, a) : static_cast<double>(cross(exact(d), exact(a)));
    return {line, along(a), along(kept_[id].b), id};
  }
  /// Sorts by line, and then along it.
  void sort(Positions places, DirectionRank rank, Cancellation& cancellation) const {
    const auto before = [&](const LinePosition& s, const LinePosition& t) {
      if (s.line != t.line) return s.line < t.line;
      if (!doubles_tell_) {
        const Int128 line_s = exact_line(s, rank);
        const Int128 line_t = exact_line(t, rank);
        if (line_s != line_t) return line_s < line_t;
      }
      return s.from != t.from ? s.from < t.from : s.id < t.id;
    };
    sort_in_pieces(places.begin(), places.end(), cancellation, before);
  }
  void join(Positions places, DirectionRank rank, Cancellation& cancellation,
            JoinedPart& part) const {
    auto& members = part.members;
    const auto same_line = [&](const LinePosition& s, const LinePosition& t) {
      return s.line == t.line && (doubles_tell_ || exact_line(s, rank) == exact_line(t, rank));
    };
    for (std::size_t i = 0; i < places.size();) {
      cancellation.check();
      const LinePosition& start = places[i];
      const std::size_t first = members.size();
      append(members, kept_[start.id], cancellation);
      double reach = start.to;
      for (++i; i < places.size() && same_line(places[i], start) && places[i].from <= reach; ++i) {
        cancellation.check();
        if (places[i].to <= reach) continue;
        reach = places[i].to;
        append(members, kept_[places[i].id], cancellation);
      }
      KeptSegment whole = members[first];
      if (members.size() == first + 1) {
        members.pop_back();
      } else {
        whole.b = members.back().b;
        whole.d = {whole.b.x - whole.a.x, whole.b.y - whole.a.y};
        part.joined.push_back({members.back().segment, static_cast<KeptId>(first),
                               static_cast<KeptId>(members.size())});
        whole.joined = static_cast<std::uint32_t>(part.joined.size());
      }
      append(part.result, whole, cancellation);
    }
  }
  [[nodiscard]] Vec<double> direction(DirectionRank rank) const {
    const SiteId e = scratch_.edge_of_rank[rank];
    return {o_.sites.dx[e], o_.sites.dy[e]};
  }
  [[nodiscard]] Int128 exact_line(const LinePosition& place, DirectionRank rank) const {
    return cross(exact(direction(rank)), exact(kept_[place.id].a));
  }

  const Operands& o_;
  const std::vector<KeptSegment>& kept_;
  JoinScratch& scratch_;
  bool doubles_tell_;  ///< whether cross products have no rounding
};

/// Appends what a task has joined.
void add_part(const JoinedPart& part, Cancellation& cancellation, JoinedPart& whole) {
  const auto members_before = static_cast<KeptId>(whole.members.size());
  const auto joined_before = static_cast<std::uint32_t>(whole.joined.size());
  visit_in_pieces(part.members, cancellation,
                  [&](const KeptSegment& s) { append(whole.members, s, cancellation); });
  visit_in_pieces(part.result, cancellation, [&](KeptSegment s) {
    if (s.joined != 0) s.joined += joined_before;
    append(whole.result, s, cancellation);
  });
  visit_in_pieces(part.joined, cancellation, [&](JoinedSegments s) {
    s.first += members_before;
    s.end += members_before;
    append(whole.joined, s, cancellation);
  });
}

}  // namespace

bool lines_are_joined(const Operands& o, std::size_t segments) {
  constexpr std::size_t kSegmentsPerDirection = 8;  // if there are more, many may share lines
  const bool exact = o.bounds.difference == 0 && o.bounds.direction == 0;
  return exact && segments >= kSegmentsPerDirection * o.rank_count;
}

void join_lines(const Operands& o, bool wanted, Cancellation& cancellation, JoinScratch& scratch,
                std::vector<KeptSegment>& kept) {
  constexpr std::uint64_t kUnitsOfSegment = 16;  // it is compared with some others
  scratch.joined.clear();
  scratch.members.clear();
  if (!wanted) return;
  LineJoiner joiner(o, kept, scratch);
  joiner.list_places(cancellation);
  const std::size_t tasks = tasks_for(kUnitsOfSegment * kept.size(), cancellation);
  if (tasks == 1) {
    joiner.join(0, o.rank_count, cancellation, scratch);
  } else {
    scratch.parts.resize(std::max(scratch.parts.size(), tasks - 1));
    const auto part_of = [&](std::size_t task) -> JoinedPart& {
      return task == 0 ? scratch : scratch.parts[task - 1];
    };
    share(tasks, cancellation, [&](std::size_t task, std::size_t, Cancellation& own) {
      joiner.join(joiner.first_rank(task, tasks), joiner.first_rank(task + 1, tasks), own,
                  part_of(task));
    });
    for (std::size_t task = 1; task < tasks; ++task) {
      add_part(part_of(task), cancellation, scratch);
    }
  }
  std::swap(kept, scratch.result);
}

}  // namespace minksum
