// A part of free space: one polygon, asked where points and segments lie, and for ways within it.
#pragma once

#include <cstdint>
#include <vector>

#include "machine/cancellation.hpp"
#include "minksum/locate.hpp"
#include "minksum/measure.hpp"
#include "region/point_arithmetic.hpp"

namespace minksum {

/// A box of doubles that surely contains points with these coordinates rounded.
struct LooseBox {
  double min_x, min_y, max_x, max_y;
  static LooseBox around(double ax, double ay, double bx, double by);
  static LooseBox around(const Point& a, const Point& b) {
    return around(a.x.to_double(), a.y.to_double(), b.x.to_double(), b.y.to_double());
  }
  [[nodiscard]] bool meets(const LooseBox& other) const {
    return min_x <= other.max_x && other.min_x <= max_x && min_y <= other.max_y &&
           other.min_y <= max_y;
  }
};

/// One polygon of a valid region. Everything is decided exactly.
class FreePart {
 public:
  FreePart(Region polygon, const Options& options);

  [[nodiscard]] const Region& region() const { return region_; }
  [[nodiscard]] const LooseBox& box() const { return box_; }
  [[nodiscard]] Location locate(const Point& point) const { return locator_.locate(point); }
  [[nodiscard]] bool contains(const Point& point) const {
    return locate(point) != Location::kOutside;
  }

  /// Whether some point of the closed segment is inside (kInside), or outside (kOutside). O(n) and
  /// what log n it takes for its hits.
  [[nodiscard]] bool meets(const Point& a, const Point& b, Location open_side,
                           Cancellation& cancellation) const;
  /// Whether the closed segment is in the closed polygon.
  [[nodiscard]] bool sees(const Point& a, const Point& b, Cancellation& cancellation) const {
    return !meets(a, b, Location::kOutside, cancellation);
  }

  /// A path in the closed polygon between two of its points, both included: straight, and around
  /// what is in the way along its boundary; then shortened where corners see each other.
  [[nodiscard]] std::vector<Point> way(const Point& a, const Point& b,
                                       Cancellation& cancellation) const;

 private:
  /// Where a segment from a to b meets an edge: a + t(b − a), on the edge that starts at `edge`.
  struct Hit {
    Rational t;
    std::uint32_t edge;
  };
  /// All of them, by t; where an edge runs along the segment, both ends of what they share. If
  /// `crosses` is given, it is set, and the list is left as it is then, as soon as an edge is found
  /// that certainly crosses the segment at a point inside of both.
  [[nodiscard]] std::vector<Hit> hits(const Point& a, const Point& b, bool* crosses,
                                      Cancellation& cancellation) const;
  void add_hits(std::uint32_t edge, const Point& a, const Point& d, std::vector<Hit>& found) const;
  [[nodiscard]] std::uint32_t next(std::uint32_t vertex) const;
  [[nodiscard]] std::uint32_t previous(std::uint32_t vertex) const;
  [[nodiscard]] bool is_beyond(std::uint32_t ring, const Point& point,
                               const Options& options) const;
  void go_round(const Hit& from, const Point& a, const Hit& to, const Point& b,
                std::vector<Point>& path) const;
  [[nodiscard]] std::vector<Point> walk(const Point& a, const Point& b,
                                        Cancellation& cancellation) const;
  [[nodiscard]] std::vector<Point> shortened(const std::vector<Point>& path,
                                             Cancellation& cancellation) const;

  Region region_;
  PointLocator locator_;
  std::vector<Point> points_;
  std::vector<double> x_;  ///< the points' nearest doubles
  std::vector<double> y_;
  double magnitude_ = 0;
  std::vector<LooseBox> edge_boxes_;
  std::vector<std::uint32_t> ring_begin_;  ///< and one more: the end
  std::vector<std::uint32_t> ring_of_;     ///< by vertex
  LooseBox box_{};
};

/// A point strictly inside of a region with area; exact, and as far from the boundary as a look at
/// a few of them tells, near a way from `from` to `to`. Coordinates are short where there is room.
[[nodiscard]] Point point_within(const Region& region, const Point& from, const Point& to,
                                 const Options& options);

}  // namespace minksum
