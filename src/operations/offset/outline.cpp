#include "operations/offset/outline.hpp"

#include <algorithm>

namespace minksum {
namespace {

class Outline {
 public:
  Outline(const std::vector<Point>& path, std::span<const std::size_t> ends, const Corners& corners,
          Cancellation& cancellation)
      : path_(path), cancellation_(cancellation), direct_(path.size(), true) {
    const std::size_t n = path.size();
    for (std::size_t i = 0; i < n; ++i) {
      cancellation_.check(64 * work_of(path[i]));
      edges_.push_back(corners.edge(minus(path[(i + 1) % n], path[i])));
    }
    for (std::size_t i = 0; i < n; ++i) {
      cancellation_.check(64 * work_of(path[i]));
      const OffsetEdge& before = edges_[(i + n - 1) % n];
      const bool is_end = std::find(ends.begin(), ends.end(), i) != ends.end();
      corners_.push_back(is_end ? corners.at_end(before, edges_[i])
                                : corners.at_vertex(before, edges_[i]));
    }
    make_strips();
  }

  void write(Region& outlines) const {
    outlines.begin_polygon();
    outlines.begin_ring();
    for (std::size_t i = 0; i < path_.size(); ++i) {
      for (const Point& vector : outline(i)) {
        const Point at = plus(path_[i], vector);
        cancellation_.check(work_of(at));
        outlines.add_vertex(at.x, at.y);
      }
    }
  }

 private:
  [[nodiscard]] const std::vector<Point>& outline(std::size_t corner) const {
    return direct_[corner] ? corners_[corner].direct : corners_[corner].full;
  }

  /// The ends of an edge that is shorter than the grid's step may come to lie in the wrong order if
  /// they go to corners directly. Between the edge's own `outwards` on both sides they cannot.
  void make_strips() {
    const std::size_t n = path_.size();
    std::vector<std::size_t> left;
    for (std::size_t i = 0; i < n; ++i) left.push_back(i);
    while (!left.empty()) {
      const std::size_t i = left.back();
      left.pop_back();
      if (goes_left(i)) continue;
      for (const std::size_t corner : {i, (i + 1) % n}) {
        if (!direct_[corner]) continue;
        direct_[corner] = false;
        left.push_back((corner + n - 1) % n);
        left.push_back(corner);
      }
    }
  }

  /// Tells whether the strip of this edge is two counter-clockwise triangles, cut either way.
  [[nodiscard]] bool goes_left(std::size_t edge) const {
    const std::size_t next = (edge + 1) % path_.size();
    cancellation_.check(16 * work_of(path_[edge]));
    const Point& from = outline(edge).back();
    const Point& to = outline(next).front();
    if (from == to && from == edges_[edge].outwards) return true;
    const Point along = minus(path_[next], path_[edge]);
    const Point end = plus(along, to);  // as all vectors, seen from the edge's first vertex
    const Point outside = minus(end, from);
    return (cross(from, along).sign() >= 0 && cross(outside, minus(along, from)).sign() >= 0) ||
           (cross(from, end).sign() >= 0 && cross(end, along).sign() >= 0);
  }

  const std::vector<Point>& path_;
  Cancellation& cancellation_;
  std::vector<OffsetEdge> edges_;       // edge i begins at vertex i
  std::vector<CornerOutline> corners_;  // corner i is at vertex i
  std::vector<bool> direct_;
};

}  // namespace

void add_outline(const std::vector<Point>& path, std::span<const std::size_t> ends,
                 const Corners& corners, Cancellation& cancellation, Region& outlines) {
  Outline(path, ends, corners, cancellation).write(outlines);
}

}  // namespace minksum
