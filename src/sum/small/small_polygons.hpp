// Writes the rings of a small sum in canonical order.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sum/small/small_writer.hpp"

namespace minksum {

/// A ring of a result. It starts at its smallest vertex.
struct SmallRing {
  std::vector<SmallVertex> vertices;
  BoxOf<double> box;  ///< of rounded places
  bool is_outer = false;
  // Among all rings in order:
  std::uint32_t place = 0;
  std::uint32_t outer = 0;  ///< the place of its polygon's outer ring
};

/// Memory for rings, of which more may be kept than are in use.
struct SmallRingsMemory {
  std::vector<SmallRing> rings;
  std::vector<std::uint32_t> order;
  std::vector<SmallVertex> touching;
};

/// Makes the vertices of corners. So the rings need not know the type of numbers.
class SmallVertices {
 public:
  SmallVertices() = default;
  SmallVertices(const SmallVertices&) = delete;
  SmallVertices& operator=(const SmallVertices&) = delete;

  virtual void append(std::span<const SmallCorner> corners, std::vector<SmallVertex>& vertices) = 0;
  /// Positive if a segment turns left into another one.
  [[nodiscard]] virtual double turn(std::uint32_t in, std::uint32_t out) const = 0;

 protected:
  ~SmallVertices() = default;
};

/// Makes rings of a boundary's corners, orders them, and appends them to a region.
class RingWriter {
 public:
  RingWriter(SmallVertices& vertices, const SmallBoundary& boundary, double width,
             SmallRingsMemory& memory, Region& region)
      : vertices_(vertices),
        boundary_(boundary),
        width_(width),
        rings_(memory.rings),
        order_(memory.order),
        touching_(memory.touching),
        region_(region) {}

  /// Appends all rings but the first one: the holes of a polygon.
  void add_holes();
  /// Writes the rings of several polygons to a region that holds none but an empty one. Returns
  /// false if parts of the sum only touch one another, or if rounded places do not tell which
  /// polygon a hole is in.
  [[nodiscard]] bool add_polygons();

 private:
  [[nodiscard]] std::span<const SmallCorner> corners_of(std::size_t ring) const;
  /// Makes the rings from this one on, and orders them.
  void make_rings(std::uint32_t first);
  void make_ring(std::span<const SmallCorner> corners, SmallRing& ring);
  /// Whether rings go from one part to another one at the same place twice: there and back.
  [[nodiscard]] bool do_parts_touch();
  /// Finds the polygon of each hole. Of the outer rings that hold it, this is the last in order.
  [[nodiscard]] bool find_outer_rings();
  /// Returns 1 if a ring holds a point, 0 if it does not, and -1 if that is not sure.
  [[nodiscard]] int holds(const std::vector<SmallVertex>& ring, const SmallVertex& point) const;
  [[nodiscard]] int compare(double a, double b, const StoredCoordinate& x,
                            const StoredCoordinate& y) const;
  [[nodiscard]] bool less(const SmallVertex& a, const SmallVertex& b) const;
  void add(const SmallRing& ring);
  void add_vertices(const SmallRing& ring);

  SmallVertices& vertices_;
  const SmallBoundary& boundary_;
  double width_;
  std::vector<SmallRing>& rings_;
  std::vector<std::uint32_t>& order_;
  std::vector<SmallVertex>& touching_;
  Region& region_;
};

}  // namespace minksum
