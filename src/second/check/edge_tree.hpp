// Stores the edges of a geometry, with boxes around runs of them.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "machine/cancellation.hpp"
#include "minksum/geometry.hpp"
#include "spatial/box.hpp"

namespace minksum::checking {

/// A box that certainly contains the corners or edges for which it stands.
using DoubleBox = BoxOf<double>;
inline constexpr DoubleBox kEverything{
    -std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
    std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};

/// A vertex v of P, or the corner x − v of x − Q: in doubles, and exactly on demand.
struct Corner {
  const Point* vertex;
  const Point* moved_to;  ///< x, or null for a vertex
  double x;
  double y;
  double error;  ///< bounds how far x and y are off

  /// Makes a vertex by itself.
  explicit Corner(const Point& point);
  /// Makes the corner x − vertex, where `at` is x.
  Corner(const Corner& at, const Corner& corner);
  [[nodiscard]] Rational exact_x() const {
    return moved_to == nullptr ? vertex->x : moved_to->x - vertex->x;
  }
  [[nodiscard]] Rational exact_y() const {
    return moved_to == nullptr ? vertex->y : moved_to->y - vertex->y;
  }
};

/// Returns a box that contains the corner.
[[nodiscard]] DoubleBox around(const Corner& corner);

/// An edge between two corners, which are the same for a point.
struct Edge {
  std::size_t from;
  std::size_t to;
};

/// Holds all edges, and a binary tree of boxes over runs of them.
class EdgeTree {
 public:
  static constexpr std::size_t kLeaf = 4;
  EdgeTree(const Geometry& geometry, Cancellation& cancellation);
  EdgeTree(const EdgeTree&) = delete;
  EdgeTree& operator=(const EdgeTree&) = delete;

  /// Returns the greatest work (see Cancellation) of a decision about the corners.
  [[nodiscard]] std::uint64_t work() const { return work_; }
  [[nodiscard]] const Corner& corner(std::size_t i) const { return corners_[i]; }
  [[nodiscard]] const std::vector<Edge>& edges() const { return edges_; }
  /// Returns one corner of each ring, path and point.
  [[nodiscard]] const std::vector<std::size_t>& heads() const { return heads_; }

  // Node 1 is the root; node i has the children 2i and 2i + 1, if it is no leaf.
  [[nodiscard]] const DoubleBox& box(std::size_t node) const { return boxes_[node]; }
  [[nodiscard]] bool is_leaf(std::size_t node) const { return node >= leaves_; }
  [[nodiscard]] std::size_t first_edge(std::size_t leaf) const { return (leaf - leaves_) * kLeaf; }
  [[nodiscard]] std::size_t last_edge(std::size_t leaf) const;

 private:
  void add_path(std::size_t first, bool closed);
  void build(Cancellation& cancellation);

  std::uint64_t work_ = 0;
  std::vector<Point> points_;
  std::vector<Corner> corners_;
  std::vector<Edge> edges_;
  std::vector<std::size_t> heads_;
  std::vector<DoubleBox> boxes_;
  std::size_t leaves_ = 1;
};

}  // namespace minksum::checking
