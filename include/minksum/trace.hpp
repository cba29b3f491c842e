// What the pipeline did, stage by stage, in doubles: for pictures, figures and debugging.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace minksum {

/// One trace of one sum. Coordinates are those of the result (rounded to doubles).
struct Trace {
  /// A point of the picture.
  struct Vertex {
    double x = 0;  ///< the first coordinate
    double y = 0;  ///< the second coordinate
  };
  /// A directed segment; the sum can only be free on its right: that is its outer side.
  struct Segment {
    Vertex from;                ///< where it starts
    Vertex to;                  ///< where it ends
    bool edge_of_first = true;  ///< an edge of the first operand (moved by a vertex of the second)
    bool kept = true;           ///< in the arrangement: see Statistics::segments_kept
  };
  /// What became of a loop.
  enum class LoopState : unsigned char {
    kAccepted,             ///< it is a ring of the sum
    kRejectedByNesting,    ///< the nesting filter dropped it
    kRejectedByCollision,  ///< the collision filter dropped it
  };
  /// An orientable loop.
  struct Loop {
    std::vector<Vertex> vertices;            ///< in order
    bool positive = false;                   ///< counter-clockwise
    LoopState state = LoopState::kAccepted;  ///< what became of it
  };
  /// The grid of the cover.
  struct Grid {
    double min_x = 0;           ///< its left side
    double min_y = 0;           ///< its lower side
    double cell = 0;            ///< side of a cell
    std::uint32_t columns = 0;  ///< cells along x
    std::uint32_t rows = 0;     ///< cells along y
    std::vector<bool> covered;  ///< row by row; certainly inside the sum
  };

  std::vector<Segment> convolution;  ///< its segments, kept or not
  Grid cover;                     ///< columns = 0: no cover
  std::vector<Vertex> nodes;      ///< of the arrangement outside the cover
  std::vector<Segment> pieces;    ///< of the arrangement: segments split at the nodes
  std::vector<Loop> loops;        ///< orientable loops and what became of them
};

}  // namespace minksum
