// Finds all points that kept segments share: cell by cell, by pairs of boxes, or in one crowd.
#include <algorithm>
#include <cmath>
#include <utility>

#include "exact/share_decisions.hpp"
#include "machine/make_room.hpp"
#include "sum/arrangement/crowds.hpp"

namespace minksum {
namespace {

/// Finds the crossings of one task.
class CrossingFinder {
 public:
  CrossingFinder(const SumSettings& options, Predicates& predicates, MeetingScratch& memory,
                 ArrangementScratch& scratch, const std::vector<KeptSegment>& kept,
                 Meetings& meetings, const Cover* hidden, const Operands* hiding, bool alone)
      : grid_(scratch.grid),
        cancellation_(predicates.cancellation()),
        scratch_(scratch),
        near_(memory.near),
        kept_(kept),
        meeter_(std::max(scratch.extent.x, scratch.extent.y), options, predicates, scratch, kept,
                meetings, alone),
        crowds_(std::max(scratch.extent.x, scratch.extent.y), kept, meeter_, memory.crowds, hiding,
                cancellation_) {
    meeter_.hide(hidden);
  }

  /// Meets this task's pairs of boxes.
  void solve_pairs(const BoxPairs& pairs, std::size_t task, std::size_t tasks) {
    meeter_.enter({});
    const double doubt = 4 * meeter_.doubt();  // places are off by one doubt, and rounded
    const auto meet = [&](KeptId s, KeptId t) {
      if (!are_apart(kept_[s], kept_[t], doubt)) meeter_.meet(std::min(s, t), std::max(s, t));
    };
    pairs.for_each(meet, cancellation_, false, task, tasks);
  }
  /// Meets all segments.
  void solve_crowd() {
    add_all();
    crowds_.solve({});
  }
  /// Divides the plane into parts of at most so many segments, and crowds that are not to be
  /// divided. Lists them for `solve_listed`, and leaves groups in the memory.
  void split_crowd(std::size_t most, std::vector<UndividedPart>& undivided) {
    add_all();
    crowds_.split({}, most, undivided);
  }
  /// Divides one of these parts further.
  void split_listed(UndividedPart& part, std::size_t most, std::vector<UndividedPart>& undivided) {
    crowds_.split(part, most, undivided);
  }
  /// Solves one of the groups, or of the parts after them: in the order of `solve_crowd`.
  void solve_listed(std::vector<UndividedPart>& parts, const SegmentGroups& groups,
                    std::size_t task) {
    if (task < groups.groups.size()) return crowds_.solve(task, groups);
    crowds_.solve(parts[task - groups.groups.size()], groups);
  }
  /// Meets the segments of the cells [begin, end) of those that have items.
  void solve_cells(std::size_t begin, std::size_t end) {
    std::uint32_t first = begin == 0 ? 0 : scratch_.cell_end[scratch_.cells[begin - 1]];
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t cell = scratch_.cells[i];
      const std::uint32_t last = scratch_.cell_end[cell];
      const auto columns = static_cast<std::uint32_t>(grid_.columns);
      solve_cell({scratch_.in_cells.data() + first, last - first},
                 static_cast<std::int32_t>(cell % columns),
                 static_cast<std::int32_t>(cell / columns));
      first = last;
    }
  }

 private:
  using Items = std::span<const CellItem>;
  // Comparing the boxes of so many costs less than dividing them.
  static constexpr std::size_t kFew = 64;
  // Meeting so many pairs for each segment costs as much as dividing: some 200 steps a segment, and
  // 50 a pair.
  static constexpr std::size_t kPairsPerSegment = 4;
  /// Tells whether the boxes of two segments are farther apart than `doubt`. Those of BoxPairs are
  /// coarse where segments are short beside the sum.
  [[nodiscard]] static bool are_apart(const KeptSegment& s, const KeptSegment& t, double doubt) {
    const auto gap = [](double a, double b, double c, double d) {
      return std::max(std::min(c, d) - std::max(a, b), std::min(a, b) - std::max(c, d));
    };
    const auto [a, b] = s.clipped();
    const auto [c, d] = t.clipped();
    return std::max(gap(a.x, b.x, c.x, d.x), gap(a.y, b.y, c.y, d.y)) > doubt;
  }

  void add_all() {
    for (KeptId s = 0; s < scratch_.line_count; ++s) crowds_.add(s, {});
  }
  void solve_cell(Items items, std::int32_t column, std::int32_t row) {
    cancellation_.check();
    if (items.size() < 2) return;
    const PlanePart part = part_of_cell(column, row);
    if (items.size() <= kFew && list_pairs(items)) return meet_pairs(part);
    for (const CellItem& item : items) crowds_.add(item.segment, part);
    crowds_.solve(part);
  }

  /// Returns a cell's part of the plane. Neighbouring cells have a bound in common, equal to the
  /// last bit, so that all parts tile the plane.
  [[nodiscard]] PlanePart part_of_cell(std::int32_t column, std::int32_t row) const {
    const auto bound = [](std::int32_t i, std::int32_t count, double side) {
      return i == 0 ? -HUGE_VAL : i >= count ? HUGE_VAL : i * side;
    };
    const auto& [cell, inverse, columns, rows] = grid_;
    return BoxOf<double>{bound(column, columns, cell.x), bound(row, rows, cell.y),
                         bound(column + 1, columns, cell.x), bound(row + 1, rows, cell.y)};
  }

  /// Lists the pairs whose boxes overlap. Returns false if these are many.
  bool list_pairs(Items items) {
    auto& pairs = near_;
    const std::size_t most = kPairsPerSegment * items.size();
    pairs.resize(most + items.size());
    std::size_t count = 0;
    cancellation_.check(items.size() * items.size() / 4);
    for (std::size_t i = 1; i < items.size() && count <= most; ++i) {
      const std::uint64_t partner = items[i].box.partner();
      // There is no branch on which pairs overlap, because that is hard to predict.
      for (std::size_t j = 0; j < i; ++j) {
        pairs[count] = {items[j].segment, items[i].segment};
        count += items[j].box.overlaps(partner) ? 1U : 0U;
      }
    }
    pairs.resize(count);
    return count <= most;
  }
  void meet_pairs(const PlanePart& part) {
    meeter_.enter(part);
    for (const auto& [s, t] : near_) meeter_.meet(s, t);
  }

  const UniformGrid& grid_;
  Cancellation& cancellation_;
  ArrangementScratch& scratch_;
  std::vector<std::pair<KeptId, KeptId>>& near_;
  const std::vector<KeptSegment>& kept_;
  SegmentMeeter meeter_;
  CrowdFinder crowds_;
};

/// Lists the boxes of all segments. Returns false if too many of them overlap.
bool list_boxes(std::span<const KeptSegment> segments, Cancellation& cancellation,
                BoxPairs& pairs) {
  // 354 sums in which boxes overlap more than three others took 1.024 times as long as by the
  // better of comparing all boxes and dividing the crowd. With limits of 12, 15, 21 and 24
  // overlaps, they took 1.034, 1.028, 1.032 and 1.033 times as long. The limit in x alone is for
  // long boxes above one another, which hardly overlap.
  constexpr BoxPairs::Most kMostPairs{.in_x = 400, .overlaps = 18};
  visit_in_pieces(segments, cancellation, [&](const KeptSegment& s) {
    const auto [a, b] = s.clipped();
    pairs.add(std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y));
  });
  return pairs.sort(cancellation, kMostPairs);
}

/// Makes each element its own root.
void start_forest(std::vector<std::uint32_t>& parent, std::size_t size,
                  Cancellation& cancellation) {
  resize_in_pieces(parent, size, cancellation);
  std::uint32_t next = 0;
  visit_in_pieces(parent, cancellation, [&](std::uint32_t& p) { p = next++; });
}

/// Returns where the task begins if cells are divided into tasks of about as many items.
std::size_t first_cell(const ArrangementScratch& scratch, std::size_t task, std::size_t tasks) {
  if (task == 0) return 0;
  if (task == tasks) return scratch.cells.size();
  const auto end_of = [&](std::uint32_t cell) -> std::size_t { return scratch.cell_end[cell]; };
  const std::size_t item = begin_of(task, tasks, scratch.in_cells.size());
  const auto at = std::ranges::lower_bound(scratch.cells, item, {}, end_of);
  return static_cast<std::size_t>(at - scratch.cells.begin());
}

/// Lists all crossings, part by part, and makes each its own root.
void join_crossings(std::uint64_t most, Cancellation& cancellation, ArrangementScratch& scratch) {
  std::size_t count = 0;
  for (Meetings& part : scratch.meetings) {
    part.before = static_cast<std::uint32_t>(count);
    count += part.crossings.size();
    limit_crossings(count, most);
  }
  if (scratch.meetings.size() == 1) {
    std::swap(scratch.crossings, scratch.meetings[0].crossings);
  } else {
    resize_in_pieces(scratch.crossings, count, cancellation);
    share(scratch.meetings.size(), cancellation,
          [&](std::size_t task, std::size_t, Cancellation& own) {
            const Meetings& part = scratch.meetings[task];
            in_pieces(part.crossings.size(), own, [&](std::size_t begin, std::size_t end) {
              std::copy(part.crossings.data() + begin, part.crossings.data() + end,
                        scratch.crossings.data() + part.before + begin);
            });
          });
  }
  std::uint32_t next = static_cast<std::uint32_t>(scratch.parent.size());
  make_room(scratch.parent, count, cancellation);
  in_pieces(count, cancellation, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) scratch.parent.push_back(next++);
  });
}

}  // namespace

void find_crossings(const Operands& operands, const Cover& cover, const SumSettings& options,
                    Predicates& predicates, ArrangementScratch& scratch, Arrangement& arrangement) {
  constexpr std::uint64_t kUnitsOfItem = 16;       // an item meets some others, in 150 ns
  constexpr std::uint64_t kUnitsInCrowd = 1 << 9;  // a segment is divided and meets others, in 5 us
  Cancellation& cancellation = predicates.cancellation();
  const auto& kept = arrangement.kept;
  const bool by_cells = scratch.by_cells;
  // Tight places are inside the sum.
  const bool may_hide = options.cover && options.method != Method::kFull &&
                        !options.tight.value_or(false) &&
                        !std::isinf(predicates.bounds().direction);
  const Operands* const hiding = may_hide ? &operands : nullptr;
  scratch.hidden.clear();
  scratch.parent.clear();
  make_room(scratch.parent, 3 * kept.size(), cancellation);  // crossings follow
  start_forest(scratch.parent, 2 * kept.size(), cancellation);
  start_forest(scratch.line_parent, kept.size(), cancellation);
  scratch.meeting.resize(std::max(scratch.meeting.size(), members_of(cancellation)));
  // Calls solve(finder, task) for each task. Each has meetings of its own.
  const auto solve_tasks = [&](std::size_t tasks, auto solve) {
    scratch.meetings.resize(std::max<std::size_t>(tasks, 1));
    for (Meetings& part : scratch.meetings) {
      part.crossings.clear();
      part.events.clear();
      part.hidden.clear();
      part.lines_shared = false;
    }
    share_decisions(
        tasks, predicates, [&](std::size_t task, std::size_t member, Predicates& decide) {
          CrossingFinder finder(
              options, decide, scratch.meeting[member], scratch, kept, scratch.meetings[task],
              scratch.covered && !by_cells ? &cover : nullptr, hiding, tasks == 1);
          solve(finder, task);
        });
    for (const Meetings& part : scratch.meetings) {
      visit_in_pieces(part.hidden, cancellation, [&](const HiddenPart& hidden) {
        append(scratch.hidden, hidden, cancellation);
      });
    }
  };
  BoxPairs pairs(scratch.extent.x, scratch.extent.y, predicates.bounds().position, scratch.pairs);
  if (by_cells) {
    const std::size_t tasks = tasks_for(kUnitsOfItem * scratch.in_cells.size(), cancellation);
    solve_tasks(tasks, [&](CrossingFinder& finder, std::size_t task) {
      finder.solve_cells(first_cell(scratch, task, tasks), first_cell(scratch, task + 1, tasks));
    });
  } else if (list_boxes(std::span(kept.data(), scratch.line_count), cancellation, pairs)) {
    const std::size_t tasks = tasks_for(pairs.units_of_visits(), cancellation);
    solve_tasks(tasks, [&](CrossingFinder& finder, std::size_t task) {
      finder.solve_pairs(pairs, task, tasks);
    });
  } else if (const std::size_t tasks = tasks_for(kUnitsInCrowd * scratch.line_count, cancellation);
             tasks == 1) {
    solve_tasks(1, [](CrossingFinder& finder, std::size_t) { finder.solve_crowd(); });
  } else {
    // First about one large part for each thread. A part may have half again as many segments as
    // an even share, because segments on the border of two parts are in both.
    std::vector<UndividedPart> large;
    solve_tasks(1, [&](CrossingFinder& finder, std::size_t) {
      finder.split_crowd(3 * (scratch.line_count / 2) / members_of(cancellation), large);
    });
    std::vector<std::vector<UndividedPart>> divided(large.size());
    solve_tasks(large.size(), [&](CrossingFinder& finder, std::size_t task) {
      finder.split_listed(large[task], scratch.line_count / tasks, divided[task]);
    });
    std::vector<UndividedPart> undivided;
    for (auto& parts : divided) {
      for (UndividedPart& part : parts) undivided.push_back(std::move(part));
    }
    const SegmentGroups& groups = scratch.meeting[0].crowds.groups;
    solve_tasks(groups.groups.size() + undivided.size(),
                [&](CrossingFinder& finder, std::size_t task) {
                  finder.solve_listed(undivided, groups, task);
                });
  }
  join_crossings(most_crossings(options.limits), cancellation, scratch);
  scratch.lines_shared = std::ranges::any_of(scratch.meetings, &Meetings::lines_shared);
  arrangement.crossings = scratch.crossings.size();
}

}  // namespace minksum
