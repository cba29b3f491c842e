// Declares the overlay, which turns rings and paths of any kind into the set that they mean.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "minksum/geometry.hpp"
#include "minksum/options.hpp"

namespace minksum::overlay {

/// Two winding numbers, one for each operand of a boolean operation. Most uses need only the first.
struct Winding {
  std::int32_t first = 0;
  std::int32_t second = 0;

  friend Winding operator+(const Winding& a, const Winding& b) {
    return {a.first + b.first, a.second + b.second};
  }
  friend Winding operator-(const Winding& a) { return {-a.first, -a.second}; }
  friend bool operator==(const Winding&, const Winding&) = default;
};

/// Tells whether points with these winding numbers are in the result.
using Inside = bool (*)(const Winding& winding);

/// A piece of a chain, or a point, with the windings on its two sides.
struct Wall {
  Winding left;
  Winding right;
  bool belongs = false;     ///< it lies on a chain that belongs
  std::int32_t spared = 0;  ///< the sum of Chain::spared over the chains through it
};
/// Tells whether a piece or a point that has no area beside it is in the result.
using Keeps = bool (*)(const Wall& wall);

/// Decides which points are in the result.
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
  /// How the chain is directed before its windings count. A chain whose signed area is 0 stays as
  /// it is.
  Direction direction = Direction::kAsGiven;
  Winding weight;        ///< added by one turn around to the left
  bool belongs = false;  ///< whether its own points are in the result, if the rule keeps them
  /// Set for a ring that takes the points on some of its sides away, but not the ring itself: on
  /// how many of its two sides. Only `Rule::keeps` uses it.
  std::int32_t spared = 0;
};

/// Returns the closure of the points that `rule.inside` accepts, and the parts of chains that
/// `rule.keeps` accepts, resolved (see Geometry). The result is exact for all coordinates that a
/// region holds; origins are not kept.
///
/// Each step has a file of its name. load_points puts coordinates on the narrowest rung.
/// list_segments directs chains and merges equal segments. find_contacts finds where segments meet.
/// subdivide makes nodes and pieces. sweep finds winding numbers on both sides of each piece.
/// extract_area and extract_thin write the result. Takes O((n + c) log n) for n vertices and c
/// contacts where segments are not much crowded, or do not cross. Pairs are sought in cells. A cell
/// is divided until it holds a few segments, or dividing does not part them. In such crowds only
/// pairs with a segment that crosses or overlaps another one are tested. Throws
/// Error(kLimitExceeded) for more crossings than Limits::max_crossings.
///
/// Sets `crossings`, if it is not null, to how many pairs of segments cross; those that only touch
/// do not count.
[[nodiscard]] Geometry select(std::span<const Chain> chains, const Rule& rule,
                              const Options& options, std::uint64_t* crossings = nullptr);
/// Does what `select` does, but returns nothing if far more segments cross than chains have.
[[nodiscard]] std::optional<Geometry> select_if_few_cross(std::span<const Chain> chains,
                                                          const Rule& rule, const Options& options);

}  // namespace minksum::overlay
