// Declares a part of free space: one polygon that tells where points and segments lie, and finds
// ways within it.
#pragma once

#include <cstdint>
#include <vector>

#include "machine/cancellation.hpp"
#include "minksum/locate.hpp"
#include "minksum/measure.hpp"
#include "region/point_arithmetic.hpp"
#include "region/point_predicates.hpp"
#include "spatial/box.hpp"

namespace minksum {

/// A box that certainly contains the points whose rounded coordinates it is made from.
using LooseBox = BoxOf<double>;

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

  /// Tells whether some point of the closed segment is inside (kInside) or outside (kOutside).
  /// O(n), and O(log² n) for each hit.
  [[nodiscard]] bool meets(const Point& a, const Point& b, Location open_side,
                           Cancellation& cancellation) const;
  /// Tells whether the closed segment lies in the closed polygon.
  [[nodiscard]] bool sees(const Point& a, const Point& b, Cancellation& cancellation) const {
    return !meets(a, b, Location::kOutside, cancellation);
  }

  /// Returns a path in the closed polygon between two of its points, which are included. It goes
  /// straight and, along the boundary, around what is in the way. Then it is shortened where
  /// corners see each other.
  [[nodiscard]] std::vector<Point> way(const Point& a, const Point& b,
                                       Cancellation& cancellation) const;

 private:
  /// A point a + t(b − a) at which a segment from a to b meets the edge that starts at `edge`.
  struct Hit {
    Rational t;
    std::uint32_t edge;
  };
  /// Returns all hits by t. An edge that runs along the segment has two: the ends of what both
  /// share. If `crosses` is given, it is set as soon as an edge certainly crosses the segment at a
  /// point inside both. The list is incomplete then.
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
  std::vector<RoundedPoint> points_;
  std::vector<LooseBox> edge_boxes_;
  std::vector<std::uint32_t> ring_begin_;  ///< by ring: its first vertex; at last the end
  std::vector<std::uint32_t> ring_of_;     ///< by vertex: its ring
  LooseBox box_{};
};

/// Returns a point strictly inside a region that has area, exactly. It is taken near a way from
/// `from` to `to`, as far from the boundary as a look at a few candidates tells. Coordinates are
/// short where there is room.
[[nodiscard]] Point point_within(const Region& region, const Point& from, const Point& to,
                                 const Options& options);

}  // namespace minksum
