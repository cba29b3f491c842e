// Fill rules.
#include "minksum/resolve.hpp"

#include "minksum/error.hpp"
#include "minksum/validity.hpp"
#include "overlay/chains.hpp"

namespace minksum {
namespace {

overlay::Inside inside_by(FillRule rule) {
  using overlay::Winding;
  switch (rule) {
    case FillRule::kEvenOdd:
      return [](const Winding& w) { return w.first % 2 != 0; };
    case FillRule::kPositive:
      return [](const Winding& w) { return w.first > 0; };
    case FillRule::kNegative:
      return [](const Winding& w) { return w.first < 0; };
    case FillRule::kAutomatic:
    case FillRule::kNonZero:
    case FillRule::kStrict:
      break;
  }
  return [](const Winding& w) { return w.first != 0; };
}

void require_legal(const Region& region, int operand) {
  const std::vector<Fault> faults = validate(region, 1);
  if (faults.empty()) return;
  Culprit culprit = faults.front().place;
  culprit.operand = operand;
  throw Error(ErrorCode::kBadInput, faults.front().message, culprit);
}

}  // namespace

const char* to_string(FillRule rule) {
  switch (rule) {
    case FillRule::kAutomatic:
      return "automatic";
    case FillRule::kEvenOdd:
      return "evenodd";
    case FillRule::kNonZero:
      return "nonzero";
    case FillRule::kPositive:
      return "positive";
    case FillRule::kNegative:
      return "negative";
    case FillRule::kStrict:
      return "strict";
  }
  return "";
}

Geometry resolve(const Geometry& geometry, const ResolveOptions& options) {
  if (options.fill == FillRule::kStrict) require_legal(geometry.region, options.operand);
  // Legal polygons directed by their roles wind once around each of their points: what OGC says and
  // what the windings say is the same, so the automatic rule need not ask whether they are legal.
  const bool by_role = options.fill == FillRule::kAutomatic || options.fill == FillRule::kStrict;
  using Direction = overlay::Chain::Direction;
  std::vector<overlay::Chain> chains;
  overlay::for_each_ring(geometry.region, [&](overlay::Chain chain, bool is_hole) {
    chain.weight.first = 1;
    chain.belongs = !options.regularize;
    if (by_role) chain.direction = is_hole ? Direction::kClockwise : Direction::kCounterClockwise;
    chains.push_back(chain);
  });
  overlay::ThinStore thin;
  if (!options.regularize) thin.add(geometry);
  thin.list_chains(chains);
  return overlay::select(chains, inside_by(options.fill), options.cancel);
}

}  // namespace minksum
