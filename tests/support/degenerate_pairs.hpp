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

/// Returns a pair of a random kind. Operands may be messes, have vertices on few lines, or have
/// holes that touch each other. They may have repeated vertices, spikes and rings drawn twice.
/// Pairs may be an operand with itself, mirrored or moved, a part with a frame or slot of its form,
/// or cells with cells. Anything thin comes with any of these.
[[nodiscard]] DegeneratePair random_degenerate_pair(Random& random);

/// Returns the same region as a careless source writes it. It has repeated and straight vertices,
/// spikes, rings drawn twice, rings that collapse on an edge, and lines and points on edges.
[[nodiscard]] Geometry untidy(const Region& region, Random& random);

/// Returns a box with square holes, standing on a corner, that touch one another and the box. Its
/// inside has many parts.
[[nodiscard]] Region lace(Random& random);

}  // namespace minksum::test
