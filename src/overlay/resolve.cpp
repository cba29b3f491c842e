// Implements the fill rules.
#include "minksum/resolve.hpp"

#include <array>
#include <utility>

#include "overlay/chains.hpp"
#include "overlay/resolve_area.hpp"
#include "overlay/take_holes.hpp"
#include "overlay/tight_places.hpp"
#include "validation/fault.hpp"

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

}  // namespace

const char* to_string(FillRule rule) {
  static constexpr std::array kNames{"automatic", "evenodd",  "nonzero",
                                     "positive",  "negative", "strict"};
  return name_of(rule, kNames);
}

Geometry resolve(const Geometry& geometry, const Options& options, int operand) {
  if (options.fill == FillRule::kStrict) require_valid(geometry.region, operand, options);
  // One ring encloses the points that it winds around. Valid polygons, directed by their roles,
  // wind once around each of their points. So in both cases, windings agree with the OGC.
  if (options.fill == FillRule::kAutomatic && geometry.region.ring_count() > 1 &&
      !validate(geometry.region, 1, options).empty()) {
    return overlay::take_holes_away(geometry, options);
  }
  const bool by_role = is_by_role(options.fill);
  using Direction = overlay::Chain::Direction;
  std::vector<overlay::Chain> chains;
  overlay::for_each_ring(geometry.region, [&](overlay::Chain chain, bool is_hole) {
    chain.weight.first = 1;
    chain.belongs = !options.regularize;
    if (by_role) chain.direction = is_hole ? Direction::kClockwise : Direction::kCounterClockwise;
    chains.push_back(chain);
  });
  overlay::ThinStore thin;
  Cancellation cancellation(options, Stage::kOverlay);
  if (!options.regularize) thin.add(geometry, cancellation);
  thin.list_chains(chains);
  return overlay::select(chains, {inside_by(options.fill)}, options);
}

Geometry resolve_with_tight_places(const Geometry& geometry, const Options& options) {
  Geometry set = resolve(geometry, options);
  if (!overlay::keeps_tight_places(geometry, set, options)) return set;
  Geometry tight = resolve(overlay::tight_places_of(geometry), part_of(options));
  return overlay::with_tight_places(std::move(set), std::move(tight));
}

}  // namespace minksum
