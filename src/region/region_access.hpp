// The inside of Region for the library's own code: coordinates as stored, and results as made.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "minksum/region.hpp"

namespace minksum {

/// StoredCoordinate::numerator_limbs: the sign and the count.
inline constexpr std::uint16_t kNegativeLimbs = 0x8000;
inline constexpr std::uint16_t kLimbCountMask = 0x7fff;

class RegionAccess {
 public:
  static const StoredCoordinate& x(const Region& region, std::size_t vertex) {
    return region.vertices_[vertex].x;
  }
  static const StoredCoordinate& y(const Region& region, std::size_t vertex) {
    return region.vertices_[vertex].y;
  }
  /// The pool that holds the digits of coordinates that have a denominator.
  static std::span<const std::uint64_t> limbs(const Region& region) { return region.limbs_; }
  static std::vector<std::uint64_t>& mutable_limbs(Region& region) { return region.limbs_; }

  /// Appends a vertex of a result, with what made the edge that starts there.
  static void add_vertex(Region& region, const StoredCoordinate& x, const StoredCoordinate& y,
                         const EdgeOrigin& origin) {
    region.vertices_.push_back({x, y});
    region.origins_.push_back(origin);
  }
  /// Appends a vertex of another region, as it is stored there.
  static void copy_vertex(Region& region, const Region& from, std::size_t vertex) {
    const auto copy = [&](StoredCoordinate c) {
      if (c.denominator_limbs == 0) return c;
      const std::size_t count =
          (c.numerator_limbs & kLimbCountMask) + std::size_t{c.denominator_limbs};
      const auto* digits = from.limbs_.data() + c.payload;
      c.payload = static_cast<std::int64_t>(region.limbs_.size());
      region.limbs_.insert(region.limbs_.end(), digits, digits + count);
      return c;
    };
    const StoredCoordinate x = copy(from.vertices_[vertex].x);
    region.vertices_.push_back({x, copy(from.vertices_[vertex].y)});
  }
  /// The same of a region that knows no origins.
  static void add_vertex(Region& region, const StoredCoordinate& x, const StoredCoordinate& y) {
    region.vertices_.push_back({x, y});
  }
  /// As if the operands had been given the other way round.
  static void exchange_operands(Region& region) {
    for (EdgeOrigin& origin : region.origins_) {
      const bool first = origin.edge_operand == Operand::kFirst;
      origin.edge_operand = first ? Operand::kSecond : Operand::kFirst;
    }
  }
  static void clear_origins(Region& region) { region.origins_.clear(); }
  /// Adds to an empty region a polygon of one ring of so many vertices, to be set one by one.
  static void make_ring(Region& region, std::size_t vertices, bool with_origins) {
    region.begin_polygon();
    region.begin_ring();
    region.vertices_.resize(vertices);
    if (with_origins) region.origins_.resize(vertices);
  }
  /// Drops all vertices but the first ones.
  static void keep_vertices(Region& region, std::size_t vertices) {
    region.vertices_.resize(vertices);
    if (!region.origins_.empty()) region.origins_.resize(vertices);
  }
  static void set_vertex(Region& region, std::size_t vertex, const StoredCoordinate& x,
                         const StoredCoordinate& y) {
    region.vertices_[vertex] = {x, y};
  }
  static void set_origin(Region& region, std::size_t vertex, const EdgeOrigin& origin) {
    region.origins_[vertex] = origin;
  }
  static void reserve(Region& region, std::size_t vertices) {
    region.vertices_.reserve(vertices);
    region.origins_.reserve(vertices);
  }

  /// The double nearest to a coordinate of this region.
  static double nearest(const Region& region, const StoredCoordinate& coordinate) {
    return region.nearest(coordinate);
  }
  static Rational exact(const Region& region, const StoredCoordinate& coordinate) {
    return region.exact(coordinate);
  }

  /// The order of two coordinates of this region.
  static std::strong_ordering compare(const Region& region, const StoredCoordinate& a,
                                      const StoredCoordinate& b);

  /// Index of the first vertex of a ring; `ring` may be the count of rings.
  static std::size_t ring_first(const Region& region, std::size_t ring) {
    return ring < region.ring_first_vertex_.size() ? region.ring_first_vertex_[ring]
                                                   : region.vertices_.size();
  }
  /// Index of the first ring of a polygon; `polygon` may be the count of polygons.
  static std::size_t polygon_first_ring(const Region& region, std::size_t polygon) {
    return polygon < region.polygon_first_ring_.size() ? region.polygon_first_ring_[polygon]
                                                       : region.ring_first_vertex_.size();
  }
  /// The ring that holds a vertex, and the polygon that holds a ring. O(log n).
  static std::size_t ring_of(const Region& region, std::size_t vertex);
  static std::size_t polygon_of(const Region& region, std::size_t ring);
  /// The place of a vertex, for an Error.
  static Culprit culprit(const Region& region, std::size_t vertex, int operand = -1);
};

}  // namespace minksum
