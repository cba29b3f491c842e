// Free parts of slices as a graph, searched breadth first. Shares no code with the library beyond
// its value types: overlaps are found edge by edge.
#pragma once

#include <map>
#include <span>
#include <utility>
#include <vector>

#include "minksum/reach.hpp"
#include "reference/open_polygon.hpp"

namespace minksum::reference {

/// A node is a free part of a slice. Nodes of neighbouring slices are joined where their insides
/// meet.
class SliceGraph {
 public:
  /// Slices with free space, counter-clockwise, of turns that differ.
  explicit SliceGraph(const std::vector<Slice>& slices);

  /// Returns whether a way leads from one configuration to another one. Both turns need a slice.
  [[nodiscard]] bool connects(const Waypoint& from, const Waypoint& to);
  /// Whether a path is a way in the graph: each move stays in the closure of a part, each turn is
  /// on the spot from one to a part that is joined with it. Waypoints differ.
  [[nodiscard]] bool has(std::span<const Waypoint> path);

 private:
  struct Node {
    std::size_t slice;
    OpenPolygon part;
  };
  [[nodiscard]] std::vector<std::size_t> nodes_at(const Waypoint& waypoint) const;
  [[nodiscard]] std::size_t slice_of(const Turn& turn) const;
  [[nodiscard]] bool are_neighbours(std::size_t a, std::size_t b) const;
  [[nodiscard]] bool joined(std::size_t a, std::size_t b);

  std::vector<Turn> turns_;
  std::vector<Node> nodes_;
  std::map<std::pair<std::size_t, std::size_t>, bool> joined_;  ///< what was found out
};

}  // namespace minksum::reference
