// Searches the graph of free parts of slices breadth first. Overlaps are found edge by edge, so
// this shares no code with the library beyond its value types.
#pragma once

#include <map>
#include <span>
#include <utility>
#include <vector>

#include "minksum/reach.hpp"
#include "reference/open_polygon.hpp"

namespace minksum::reference {

/// A graph whose nodes are the free parts of slices. Nodes of neighbouring slices are joined if
/// their insides meet.
class SliceGraph {
 public:
  /// The slices must have free space, be in counter-clockwise order, and have different turns.
  explicit SliceGraph(const std::vector<Slice>& slices);

  /// Returns whether a way leads from one configuration to another one. Both turns need a slice.
  [[nodiscard]] bool connects(const Waypoint& from, const Waypoint& to);
  /// Returns whether a path is a way in the graph. Each move must stay in the closure of a part,
  /// and each turn must go on the spot to a part that is joined. Waypoints must differ.
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
  std::map<std::pair<std::size_t, std::size_t>, bool> joined_;  ///< answers that are known
};

}  // namespace minksum::reference
