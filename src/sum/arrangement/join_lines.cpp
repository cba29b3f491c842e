// Joins segments that overlap on one line in one direction.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>

#include "exact/formulas.hpp"
#include "exact/wide_int.hpp"
#include "machine/make_room.hpp"
#include "machine/scramble.hpp"
#include "machine/team.hpp"
#include "sum/arrangement/arrangement.hpp"

namespace minksum {
namespace {

/// Converts integers that doubles hold.
template <class Integer>
Vec<Integer> as(const Vec<double>& v) {
  return {static_cast<Integer>(static_cast<std::int64_t>(v.x)),
          static_cast<Integer>(static_cast<std::int64_t>(v.y))};
}

/// Joins segments that overlap on one line, direction by direction.
class LineJoiner {
 public:
  LineJoiner(const Operands& o, std::vector<KeptSegment>& kept, JoinScratch& scratch)
      : o_(o), kept_(kept), scratch_(scratch), wrapped_tell_(o.bounds.product == 0) {}

  /// Lists the places of segments that may share a line, direction by direction. Returns false if
  /// there are none.
  [[nodiscard]] bool list_places(Cancellation& cancellation) {
    scratch_.directions.resize(o_.rank_count);
    for (const SiteId e : o_.by_direction) {
      scratch_.directions[o_.rank[e]] = {o_.sites.dx[e], o_.sites.dy[e]};
    }
    list_candidates(cancellation);
    if (scratch_.candidates.empty()) return false;
    list_by_key(o_.rank_count, cancellation, scratch_.begin_of_rank, scratch_.places,
                [&](auto visit) {
                  visit_in_pieces(scratch_.candidates, cancellation,
                                  [&](KeptId id) { visit(kept_[id].rank, position(id)); });
                });
    return true;
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
    part.joined.clear();
    part.wholes.clear();
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
  static constexpr KeptId kNone = 0xFFFFFFFFU;

  /// Lists the segments whose line another one has, too. Most have lines of their own.
  void list_candidates(Cancellation& cancellation) {
    auto& lines = scratch_.lines;
    auto& table = scratch_.first_on_line;
    auto& shares = scratch_.shares_line;
    resize_in_pieces(lines, kept_.size(), cancellation);
    assign_in_pieces(shares, kept_.size(), std::uint8_t{0}, cancellation);
    assign_in_pieces(table, std::bit_ceil(2 * kept_.size()), kNone, cancellation);
    const std::size_t mask = table.size() - 1;
    bool any = false;
    in_pieces(kept_.size(), cancellation, [&](std::size_t first, std::size_t last) {
      for (std::size_t id = first; id < last; ++id) {
        const KeptSegment& s = kept_[id];
        lines[id] = line_of(s) ^ std::uint64_t{s.rank} << 40U;
        std::size_t slot = scramble(lines[id]) & mask;
        while (table[slot] != kNone && lines[table[slot]] != lines[id]) slot = (slot + 1) & mask;
        if (table[slot] == kNone) {
          table[slot] = static_cast<KeptId>(id);
        } else {
          any = true;
          shares[table[slot]] = shares[id] = 1;
        }
      }
    });
    scratch_.candidates.clear();
    if (!any) return;
    in_pieces(kept_.size(), cancellation, [&](std::size_t first, std::size_t last) {
      for (std::size_t id = first; id < last; ++id) {
        if (shares[id] != 0) append(scratch_.candidates, static_cast<KeptId>(id), cancellation);
      }
    });
  }
  /// Returns the cross product of a segment's start with its direction, modulo 2^64. Segments of
  /// one direction have the same on one line.
  [[nodiscard]] std::uint64_t line_of(const KeptSegment& s) const {
    return cross(as<std::uint64_t>(direction(s.rank)), as<std::uint64_t>(s.a));
  }
  /// Returns how far along a direction a point is, in steps of the grid in x, or in y.
  [[nodiscard]] static double along(const Vec<double>& d, const Vec<double>& p) {
    const double place = d.x != 0 ? p.x : p.y;
    return (d.x != 0 ? d.x : d.y) > 0 ? place : -place;
  }
  [[nodiscard]] LinePosition position(KeptId id) const {
    const KeptSegment& s = kept_[id];
    const Vec<double> d = direction(s.rank);
    const double start = along(d, s.a);
    const double end = along(d, s.b);
    // Whole steps are exact. What rounds the products is far less than a clip's margin.
    const double from = s.clip.from == 0 ? 0 : std::floor(s.clip.from * (end - start));
    const double to = s.clip.to == 1 ? end - start : std::ceil(s.clip.to * (end - start));
    return {line_of(s), start + from, start + to, id};
  }
  /// Returns which part of a joined segment its members' clips leave, between `from` and `to`.
  [[nodiscard]] Clip clip_of(const KeptSegment& whole, double from, double to) const {
    constexpr double kMargin = 0x1p-22;  // far more than rounding to single precision takes
    const double start = along(whole.d, whole.a);
    const double end = along(whole.d, whole.b);
    const double length = end - start;
    const double first = from == start ? 0 : std::max(0.0, (from - start) / length - kMargin);
    const double last = to == end ? 1 : std::min(1.0, (to - start) / length + kMargin);
    return {static_cast<float>(first), static_cast<float>(last)};
  }
  /// Sorts by line, and then along it.
  void sort(Positions places, DirectionRank rank, Cancellation& cancellation) const {
    const auto before = [&](const LinePosition& s, const LinePosition& t) {
      if (s.line != t.line) return s.line < t.line;
      if (!wrapped_tell_) {
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
      return s.line == t.line && (wrapped_tell_ || exact_line(s, rank) == exact_line(t, rank));
    };
    for (std::size_t i = 0; i < places.size();) {
      cancellation.check();
      const LinePosition& start = places[i];
      KeptSegment& whole = kept_[start.id];
      const std::size_t first = members.size();
      double reach = start.to;
      for (++i; i < places.size() && same_line(places[i], start) && places[i].from <= reach; ++i) {
        cancellation.check();
        scratch_.gone[places[i].id] = 1;
        if (places[i].to <= reach) continue;
        reach = places[i].to;
        if (members.size() == first) append(members, whole, cancellation);
        append(members, kept_[places[i].id], cancellation);
      }
      if (members.size() == first) continue;
      whole.b = members.back().b;
      whole.d = {whole.b.x - whole.a.x, whole.b.y - whole.a.y};
      whole.clip = clip_of(whole, start.from, reach);
      part.joined.push_back({members.back().segment, static_cast<KeptId>(first),
                             static_cast<KeptId>(members.size())});
      part.wholes.push_back(start.id);
    }
  }
  [[nodiscard]] Vec<double> direction(DirectionRank rank) const {
    return scratch_.directions[rank];
  }
  [[nodiscard]] Int128 exact_line(const LinePosition& place, DirectionRank rank) const {
    return cross(as<Int128>(direction(rank)), as<Int128>(kept_[place.id].a));
  }

  const Operands& o_;
  std::vector<KeptSegment>& kept_;
  JoinScratch& scratch_;
  bool wrapped_tell_;  ///< whether cross products are so small that 64 bits hold them
};

/// Appends what a task has joined.
void add_part(const JoinedPart& part, Cancellation& cancellation, JoinedPart& whole) {
  const auto members_before = static_cast<KeptId>(whole.members.size());
  visit_in_pieces(part.members, cancellation,
                  [&](const KeptSegment& s) { append(whole.members, s, cancellation); });
  visit_in_pieces(part.joined, cancellation, [&](JoinedSegments s) {
    s.first += members_before;
    s.end += members_before;
    append(whole.joined, s, cancellation);
  });
  visit_in_pieces(part.wholes, cancellation,
                  [&](KeptId s) { append(whole.wholes, s, cancellation); });
}

/// Drops the segments that are gone, and keeps the order of the others.
void drop_gone(const std::vector<std::uint8_t>& gone, Cancellation& cancellation,
               std::vector<KeptSegment>& kept) {
  std::size_t count = 0;
  in_pieces(kept.size(), cancellation, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (gone[i] != 0) continue;
      if (i != count) kept[count] = kept[i];
      ++count;
    }
  });
  kept.resize(count);
}

}  // namespace

void join_lines(const Operands& o, Cancellation& cancellation, JoinScratch& scratch,
                std::vector<KeptSegment>& kept) {
  constexpr std::uint64_t kUnitsOfSegment = 16;  // it is compared with some others
  scratch.joined.clear();
  scratch.members.clear();
  if (o.bounds.difference != 0) return;
  LineJoiner joiner(o, kept, scratch);
  if (!joiner.list_places(cancellation)) return;
  assign_in_pieces(scratch.gone, kept.size(), std::uint8_t{0}, cancellation);
  const std::size_t tasks = tasks_for(kUnitsOfSegment * scratch.places.size(), cancellation);
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
  for (std::uint32_t i = 0; i < scratch.wholes.size(); ++i) {
    kept[scratch.wholes[i]].joined = i + 1;
  }
  drop_gone(scratch.gone, cancellation, kept);
}

}  // namespace minksum
