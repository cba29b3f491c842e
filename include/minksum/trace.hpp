// What the pipeline did, stage by stage, in doubles: for pictures, figures and debugging.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace minksum {

/// One trace of one sum. Coordinates are those of the result (rounded to doubles).
struct Trace {
  struct Vertex {
    double x = 0;
    double y = 0;
  };
  /// A directed segment; the sum can only be free on its right: that is its outer side.
  struct Segment {
    Vertex from;
    Vertex to;
    bool edge_of_first = true;  ///< an edge of the first operand (moved by a vertex of the second)
    bool kept = true;           ///< in the arrangement: see Statistics::segments_kept
  };
  enum class LoopState : unsigned char { kAccepted, kRejectedByNesting, kRejectedByCollision };
  struct Loop {
    std::vector<Vertex> vertices;
    bool positive = false;  ///< counter-clockwise
    LoopState state = LoopState::kAccepted;
  };
  struct Grid {
    double min_x = 0;
    double min_y = 0;
    double cell = 0;  ///< side of a cell
    std::uint32_t columns = 0;
    std::uint32_t rows = 0;
    std::vector<bool> covered;  ///< row by row; certainly inside the sum
  };

  std::vector<Segment> convolution;
  Grid cover;                     ///< columns = 0: no cover
  std::vector<Vertex> nodes;      ///< of the arrangement outside the cover
  std::vector<Segment> pieces;    ///< of the arrangement: segments split at the nodes
  std::vector<Loop> loops;        ///< orientable loops and what became of them
};

}  // namespace minksum
