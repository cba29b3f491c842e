// Computes the no-fit polygons of all pairs of parts: each sum once, and the others as its images.
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "machine/cancellation.hpp"
#include "machine/in_order.hpp"
#include "machine/part_progress.hpp"
#include "minksum/no_fit.hpp"
#include "minksum/resolve.hpp"
#include "minksum/transform.hpp"
#include "operations/no_fit/table_part.hpp"
#include "operations/sum/fixed_sum.hpp"
#include "region/region_access.hpp"
#include "region/turned.hpp"
#include "sum/small/small_sum.hpp"

namespace minksum {

struct NoFitTable::State {
  /// Row i has the pairs of i with i, i + 1, ..., and a sum for each turn of the second part. The
  /// pair of i with itself has turns of up to half a full one.
  std::vector<std::vector<Geometry>> rows;
  int turns = 4;

  [[nodiscard]] int turns_with_itself() const { return turns / 2 + 1; }
  [[nodiscard]] const Geometry& sum(std::size_t fixed, std::size_t moving, int turn) const {
    const auto all = static_cast<std::size_t>(turns);
    const std::size_t before = fixed == moving ? 0
                                               : static_cast<std::size_t>(turns_with_itself()) +
                                                     (moving - fixed - 1) * all;
    return rows[fixed][before + static_cast<std::size_t>(turn)];
  }
};

namespace {

/// Computes one sum by the stages. `options` are those of one sum.
Geometry sum(const PreparedRegion& fixed, const PreparedRegion& moving, const Options& options,
             bool with_tight, Workspace& workspace) {
  Geometry result;
  Geometry tight;
  SumRequest request(options);
  if (with_tight) request.want_tight_places(tight);
  sum_by_stages(fixed, moving, request, workspace, result.region);
  result.polylines = std::move(tight.polylines);
  result.points = std::move(tight.points);
  return result;
}

/// Returns how many threads are worth starting.
int worthwhile_threads(std::span<const Geometry> parts, int turns, int threads) {
  // The time of a sum grows with the square of its operands' vertices. So much work takes a
  // fraction of a millisecond.
  constexpr std::uint64_t kForOne = 60'000;
  std::uint64_t vertices = 0;
  for (const Geometry& part : parts) vertices += part.region.vertex_count();
  const std::uint64_t work = vertices * vertices * static_cast<std::uint64_t>(turns);
  const auto wanted = std::min<std::uint64_t>(thread_count(threads), work / kForOne);
  return static_cast<int>(std::max<std::uint64_t>(wanted, 1));
}

/// The units of work (see Cancellation) of a sum of two small parts, which looks at no token.
constexpr std::uint64_t kWorkOfSmallSum = 1 << 12;

/// The memory of one thread. The workspace is made where it is needed.
struct Memory {
  SmallScratch small;
  std::optional<Workspace> workspace;
};

Geometry sum(const TablePart& fixed, const TablePart& moving, std::size_t direction,
             const Options& options, bool with_tight, Memory& memory) {
  const SmallOperand* const p = fixed.small(0);
  const SmallOperand* const q = moving.small(direction);
  if (p != nullptr && q != nullptr && !with_tight && allow_small(options.limits)) {
    Geometry result;
    if (sum_small(*p, *q, memory.small, result.region)) return result;
  }
  if (!memory.workspace) memory.workspace.emplace();
  return sum(fixed.prepared(0), moving.prepared(direction), options, with_tight, *memory.workspace);
}

}  // namespace

NoFitTable::NoFitTable(std::span<const Geometry> given, int turns, const Options& options) {
  if (turns != 1 && turns != 2 && turns != 4) {
    refuse_input("a table of no-fit polygons has 1, 2 or 4 turns");
  }
  std::vector<TablePart> parts;
  parts.reserve(given.size());
  for (const Geometry& part : given) parts.emplace_back(part, parts.size(), turns, options);

  State state;
  state.turns = turns;
  state.rows.reserve(parts.size());
  const int half = std::max(1, turns / 2);
  const bool with_tight = options.tight.value_or(true);
  PartProgress progress(options, parts.size());
  const auto make_row = [&](std::size_t i, Memory& memory) {
    Cancellation cancellation(progress.options());
    cancellation.look();
    std::vector<Geometry> row;
    row.reserve((parts.size() - i) * static_cast<std::size_t>(state.turns));
    for (std::size_t j = i; j < parts.size(); ++j) {
      const int wanted = j == i ? state.turns_with_itself() : turns;
      for (int turn = 0; turn < wanted; ++turn) {
        cancellation.check(kWorkOfSmallSum);
        // The part's point mirror is the part turned by half a full turn.
        const auto mirror = static_cast<std::size_t>(turn + half) % parts[j].directions();
        row.push_back(sum(parts[i], parts[j], mirror, progress.options(), with_tight, memory));
      }
    }
    progress.finish_part();
    return row;
  };
  for_each_in_order<std::vector<Geometry>, Memory>(
      parts.size(), worthwhile_threads(given, turns, options.threads), progress.options(), make_row,
      [&](std::size_t, std::vector<Geometry>& row) { state.rows.push_back(std::move(row)); });
  state_ = std::make_shared<const State>(std::move(state));
}

std::size_t NoFitTable::size() const { return state_->rows.size(); }
int NoFitTable::turns() const { return state_->turns; }

Geometry NoFitTable::at(TurnedPart fixed, TurnedPart moving, const Options& options) const {
  Cancellation cancellation(options);
  const int turns = state_->turns;
  for (const TurnedPart& part : {fixed, moving}) {
    if (part.part >= size()) refuse_input("there is no such part");
    if (part.turn < 0 || part.turn >= turns) {
      refuse_input("there is no such turn");
    }
  }
  // The polygon is A ⊕ −R(t) B, turned as A is. It equals −R(t) (B ⊕ −R(−t) A).
  const int quarter = 4 / turns;
  int quarters = fixed.turn * quarter;
  int turn = (moving.turn - fixed.turn + turns) % turns;
  std::size_t first = fixed.part;
  std::size_t second = moving.part;
  const bool mirrored = second < first || (second == first && turn > turns / 2);
  if (mirrored) {
    std::swap(first, second);
    quarters += turn * quarter + 2;
    turn = (turns - turn) % turns;
  }
  const Geometry& sum = state_->sum(first, second, turn);
  Geometry result{turned(sum.region, quarters, cancellation), {}, {}};
  if (mirrored) RegionAccess::exchange_operands(result.region);
  if (sum.has_thin_parts()) {
    const Geometry tight = resolve(transform(Geometry{{}, sum.polylines, sum.points},
                                             Affine::quarter_turns(quarters), options),
                                   part_of(options));
    result.polylines = tight.polylines;
    result.points = tight.points;
  }
  return result;
}

}  // namespace minksum
