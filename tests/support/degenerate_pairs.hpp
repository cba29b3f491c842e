// Makes random pairs of operands that are degenerate in a meaningful way, alone or with each other.
#pragma once

#include <string>

#include "minksum/geometry.hpp"
#include "support/random.hpp"

namespace minksum::test {

struct DegeneratePair {
  Geometry p;
  Geometry q;
  std::string kind;  ///< for messages
};

/// Returns a pair of one of these kinds: messes; vertices on few lines; an operand with itself,
/// mirrored or moved; rings with repeated vertices, spikes and rings drawn twice; parts and frames
/// or slots of their form; holes that touch each other; cells with cells; anything thin with any of
/// these.
[[nodiscard]] DegeneratePair random_degenerate_pair(Random& random);

/// Returns the same region as a careless source writes it: with repeated and straight vertices,
/// spikes, rings drawn twice, rings that collapse on an edge, lines along edges, and points on
/// them.
[[nodiscard]] Geometry untidy(const Region& region, Random& random);

}  // namespace minksum::test
