// Declares the record of what each stage of a sum made, for pictures, figures and debugging.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace minksum {

/// A record of what each stage of one sum made. Coordinates are those of the result, as doubles.
struct Trace {
  /// A point of the picture.
  struct Vertex {
    double x = 0;  ///< the first coordinate
    double y = 0;  ///< the second coordinate
  };
  /// A directed segment. Points outside of the sum can lie only on its right, which is its outer
  /// side.
  struct Segment {
    Vertex from;                ///< where it starts
    Vertex to;                  ///< where it ends
    bool edge_of_first = true;  ///< whether the first operand has the edge
    bool kept = true;           ///< whether it is in the arrangement, see Statistics
  };
  /// Says what became of a loop.
  enum class LoopState : unsigned char {
    kAccepted,             ///< the loop is a ring of the sum
    kRejectedByNesting,    ///< the nesting filter dropped it
    kRejectedByCollision,  ///< the collision filter dropped it
  };
  /// An orientable loop.
  struct Loop {
    std::vector<Vertex> vertices;            ///< the vertices, in order
    bool positive = false;                   ///< whether it runs counter-clockwise
    LoopState state = LoopState::kAccepted;  ///< what became of it
  };
  /// The grid of the cover.
  struct Grid {
    double min_x = 0;           ///< x of its left side
    double min_y = 0;           ///< y of its lower side
    double cell_width = 0;      ///< width of a cell
    double cell_height = 0;     ///< height of a cell
    std::uint32_t columns = 0;  ///< cells along x
    std::uint32_t rows = 0;     ///< cells along y
    std::vector<bool> covered;  ///< row by row, whether a cell certainly lies in the sum
  };

  std::vector<Segment> convolution;  ///< the convolution's segments, kept or not
  Grid cover;                     ///< the cover's grid; `columns` is 0 if there is no cover
  std::vector<Vertex> nodes;      ///< nodes of the arrangement outside the cover
  std::vector<Segment> pieces;    ///< pieces of the arrangement: segments split at the nodes
  std::vector<Loop> loops;        ///< orientable loops, and what became of them
};

}  // namespace minksum
