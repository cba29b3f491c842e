// From loose pieces of a boundary to a region in the canonical form that region.hpp documents.
#pragma once

#include <cstddef>
#include <vector>

#include "reference/exact.hpp"

namespace minksum::reference {

/// A piece of boundary between two nodes, the interior on its left.
struct Piece {
  std::size_t from = 0;
  std::size_t to = 0;
};

/// Links pieces into rings that hug the interior, parts rings that touch themselves, and brings the
/// whole into canonical form. Pieces meet only at nodes; nodes are distinct points. Throws
/// std::logic_error if the pieces are no closed boundary.
[[nodiscard]] Region link(const std::vector<Pt>& nodes, const std::vector<Piece>& pieces);

/// The same for directed rings (interior on the left) whose edges meet only at vertices.
[[nodiscard]] Region link_rings(const Loops& rings);

/// The canonical form of a valid region in any form.
[[nodiscard]] Region canonical(const Region& region);

/// All rings of a valid region, directed with the interior on the left, without repeated
/// vertices, their edges split wherever a vertex of any ring lies on them.
[[nodiscard]] Loops directed_and_noded(const std::vector<Loops>& polygons);

}  // namespace minksum::reference
