// The overlay: rings and paths of any kind to the set of points that they mean.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "minksum/cancel.hpp"
#include "minksum/geometry.hpp"

namespace minksum::overlay {

/// Two winding numbers, one for each operand of a boolean operation; most uses need the first only.
struct Winding {
  std::int32_t first = 0;
  std::int32_t second = 0;

  friend Winding operator+(const Winding& a, const Winding& b) {
    return {a.first + b.first, a.second + b.second};
  }
  friend Winding operator-(const Winding& a) { return {-a.first, -a.second}; }
  friend bool operator==(const Winding&, const Winding&) = default;
};

/// Whether points around which the rings wind so often are in the result.
using Inside = bool (*)(const Winding& winding);

/// A piece of a chain, or a point, with the windings on its two sides.
struct Wall {
  Winding left;
  Winding right;
  bool belongs = false;     ///< it is on a chain that belongs
  std::int32_t spared = 0;  ///< the sum over the chains that it is on: see Chain::spared
};
/// Whether a piece or a point that has no area beside it is in the result.
using Keeps = bool (*)(const Wall& wall);

/// Which points are in the result.
struct Rule {
  Inside inside;
  Keeps keeps = [](const Wall& wall) { return wall.belongs; };
};

/// A closed or open path along consecutive vertices of a region.
struct Chain {
  enum class Direction { kAsGiven, kCounterClockwise, kClockwise };

  const Region* region = nullptr;  ///< used as a store of points only
  std::size_t begin = 0;
  std::size_t end = 0;
  bool closed = true;
  /// How it is directed before its windings count; one whose signed area is 0 stays as it is.
  Direction direction = Direction::kAsGiven;
  Winding weight;        ///< what going once around to the left adds
  bool belongs = false;  ///< its own points are in the result, if the rule keeps them
  /// For a ring that takes points away, but not its own ones: on how many of a piece's two sides
  /// it does so. Counts for `Rule::keeps` only.
  std::int32_t spared = 0;
};

/// The closure of the points that `rule.inside` says, and what `rule.keeps` of the chains; resolved
/// (see Geometry). Exact for all coordinates that a region holds; origins are not kept.
///
/// The steps, each in a file of that name: load_points (coordinates on the narrowest rung of number
/// types), find_contacts (where segments meet), subdivide (nodes and pieces), sweep (winding
/// numbers on both sides of each piece), extract_area and extract_thin.
/// O((n + c) log n) for n vertices and c contacts where segments are not much crowded: pairs are
/// looked for in cells that are divided until they hold a few segments, or do not divide them.
[[nodiscard]] Geometry select(std::span<const Chain> chains, const Rule& rule,
                              const std::optional<CancelToken>& cancel);

}  // namespace minksum::overlay
