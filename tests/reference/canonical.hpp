// Makes loose pieces of a boundary a region in the canonical form that region.hpp documents.
#pragma once

#include <cstddef>
#include <vector>

#include "reference/exact.hpp"

namespace minksum::reference {

/// A piece of boundary between two nodes, with the interior on its left.
struct Piece {
  std::size_t from = 0;
  std::size_t to = 0;
};

/// Links pieces into rings that hug the interior, cuts rings that touch themselves, and brings the
/// region into canonical form. Pieces must meet only at nodes, and nodes must be distinct points.
/// Throws std::logic_error if the pieces are not a closed boundary.
[[nodiscard]] Region link(const std::vector<Pt>& nodes, const std::vector<Piece>& pieces);

/// Does the same for rings with the interior on their left, whose edges meet only at vertices.
[[nodiscard]] Region link_rings(const Loops& rings);

/// Returns a ring without vertices that equal the one before.
[[nodiscard]] Loop without_repeats(const Loop& loop);

/// Returns the canonical form of a valid region in any form.
[[nodiscard]] Region canonical(const Region& region);

/// Returns all rings of a valid region, with the interior on their left and without repeated
/// vertices. Edges are split wherever a vertex of any ring lies on them.
[[nodiscard]] Loops directed_and_noded(const std::vector<Loops>& polygons);

}  // namespace minksum::reference
