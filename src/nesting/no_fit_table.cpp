// All pairs of a nesting problem: each sum once, the others as its images.
#include <algorithm>
#include <utility>
#include <vector>

#include "minksum/nesting.hpp"
#include "minksum/prepared_region.hpp"
#include "minksum/transform.hpp"
#include "minksum/validity.hpp"
#include "region/region_access.hpp"
#include "threads/in_order.hpp"
#include "transform/turned.hpp"

namespace minksum {

struct NoFitTable::State {
  /// Row i holds the pairs of i with i, i + 1, ..., and for each of them a sum for each turn of the
  /// second part; of i with itself, turns up to half a full one.
  std::vector<std::vector<Geometry>> rows;
  int turns = 4;

  [[nodiscard]] int turns_with_itself() const { return turns / 2 + 1; }
  [[nodiscard]] const Geometry& sum(std::size_t fixed, std::size_t moving, int turn) const {
    const auto all = static_cast<std::size_t>(turns);
    const std::size_t before =
        fixed == moving
            ? 0
            : static_cast<std::size_t>(turns_with_itself()) + (moving - fixed - 1) * all;
    return rows[fixed][before + static_cast<std::size_t>(turn)];
  }
};

namespace {

[[noreturn]] void refuse(const char* what, std::size_t part) {
  Culprit culprit;
  culprit.operand = static_cast<int>(part);
  throw Error(ErrorCode::kBadInput, what, culprit);
}

/// A part in each direction, its reference point at the origin.
using Part = std::vector<PreparedRegion>;

/// What a part covers. Resolving takes as long as some sums: what is legal already goes without.
Region area_of(const Geometry& part, std::size_t index, const NoFitTableOptions& options) {
  const bool by_role = options.fill == FillRule::kAutomatic || options.fill == FillRule::kStrict;
  if (by_role && validate(part.region, 1).empty()) return part.region;
  return resolve(part, {options.fill, true, options.cancel, static_cast<int>(index)}).region;
}

Part prepare(const Geometry& given, std::size_t index, const NoFitTableOptions& options) {
  const Region area = area_of(given, index, options);
  if (area.empty() || given.region.empty()) refuse("a part without area cannot be paired", index);
  const Point reference = given.region.point(0);
  const Region at_origin = transform(area, Affine::translation(-reference.x, -reference.y));
  Part part;
  for (int quarters = 0; quarters < 4; quarters += 4 / options.turns) {
    part.emplace_back(transform(at_origin, Affine::quarter_turns(quarters)));
  }
  // Of one direction, there is no point mirror among them.
  if (options.turns == 1) part.emplace_back(reflect(at_origin));
  return part;
}

Geometry sum(const PreparedRegion& fixed, const PreparedRegion& moving,
             const NoFitTableOptions& options, Workspace& workspace) {
  Geometry result;
  Geometry tight;
  Options settings;
  settings.limits = options.limits;
  settings.cancel = options.cancel;
  if (options.tight) settings.tight = &tight;
  const Outcome outcome = minkowski_sum(fixed, moving, settings, workspace, result.region);
  if (!outcome.ok()) throw *outcome.error;
  result.polylines = std::move(tight.polylines);
  result.points = std::move(tight.points);
  return result;
}

}  // namespace

NoFitTable::NoFitTable(std::span<const Geometry> given, const NoFitTableOptions& options) {
  if (options.turns != 1 && options.turns != 2 && options.turns != 4) {
    throw Error(ErrorCode::kBadInput, "a table of no-fit polygons has 1, 2 or 4 turns");
  }
  std::vector<Part> parts;
  parts.reserve(given.size());
  for (const Geometry& part : given) parts.push_back(prepare(part, parts.size(), options));

  State state;
  state.turns = options.turns;
  state.rows.reserve(parts.size());
  const int half = std::max(1, options.turns / 2);
  const auto make_row = [&](std::size_t i, Workspace& workspace) {
    std::vector<Geometry> row;
    row.reserve((parts.size() - i) * static_cast<std::size_t>(state.turns));
    for (std::size_t j = i; j < parts.size(); ++j) {
      const int turns = j == i ? state.turns_with_itself() : state.turns;
      for (int turn = 0; turn < turns; ++turn) {
        // Its point mirror is itself, turned by half a full turn.
        const auto mirror = static_cast<std::size_t>(turn + half) % parts[j].size();
        row.push_back(sum(parts[i][0], parts[j][mirror], options, workspace));
      }
    }
    return row;
  };
  for_each_in_order<std::vector<Geometry>, Workspace>(
      parts.size(), options.threads, make_row,
      [&](std::size_t, std::vector<Geometry>& row) { state.rows.push_back(std::move(row)); });
  state_ = std::make_shared<const State>(std::move(state));
}

std::size_t NoFitTable::size() const { return state_->rows.size(); }
int NoFitTable::turns() const { return state_->turns; }

Geometry NoFitTable::at(TurnedPart fixed, TurnedPart moving) const {
  const int turns = state_->turns;
  for (const TurnedPart& part : {fixed, moving}) {
    if (part.part >= size()) throw Error(ErrorCode::kBadInput, "there is no such part");
    if (part.turn < 0 || part.turn >= turns) {
      throw Error(ErrorCode::kBadInput, "there is no such turn");
    }
  }
  // A ⊕ −R(t) B, turned as A is; and it is −R(t) (B ⊕ −R(−t) A).
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
  Geometry result{turned(sum.region, quarters), {}, {}};
  if (mirrored) RegionAccess::exchange_operands(result.region);
  if (sum.has_thin_parts()) {
    const Geometry tight = resolve(
        transform(Geometry{{}, sum.polylines, sum.points}, Affine::quarter_turns(quarters)));
    result.polylines = tight.polylines;
    result.points = tight.points;
  }
  return result;
}

}  // namespace minksum
