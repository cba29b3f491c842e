// Gives the library's own code the inside of Region: coordinates as stored, and results as made.
#pragma once

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <span>
#include <vector>

#include "exact/formulas.hpp"
#include "exact/wide_int.hpp"
#include "minksum/region.hpp"

namespace minksum {

class BigInteger;

/// Parts of StoredCoordinate::numerator_limbs: the sign and the count.
inline constexpr std::uint16_t kNegativeLimbs = 0x8000;
inline constexpr std::uint16_t kLimbCountMask = 0x7fff;

/// The number ±numerator / denominator.
struct ShortQuotient {
  Uint128 numerator = 0;
  std::uint64_t denominator = 1;
  bool negative = false;
};

class RegionAccess {
 public:
  static const StoredCoordinate& x(const Region& region, std::size_t vertex) {
    return region.vertices()[vertex].x;
  }
  static const StoredCoordinate& y(const Region& region, std::size_t vertex) {
    return region.vertices()[vertex].y;
  }
  /// Returns the pool that holds the digits of coordinates that have a denominator.
  static std::span<const std::uint64_t> limbs(const Region& region) {
    return region.arrays_.get<Region::kLimbs>();
  }
  /// Appends limbs, which must lie elsewhere, to the pool.
  static void append_limbs(Region& region, std::span<const std::uint64_t> limbs) {
    region.arrays_.append<Region::kLimbs>(limbs);
  }

  /// Appends a vertex of a result, with the origin of the edge that starts there.
  static void add_vertex(Region& region, const StoredCoordinate& x, const StoredCoordinate& y,
                         const EdgeOrigin& origin) {
    add_vertex(region, x, y);
    region.arrays_.push_back<Region::kOrigins>(origin);
  }
  /// Appends a vertex of another region, as it is stored there.
  static void copy_vertex(Region& region, const Region& from, std::size_t vertex) {
    const auto copy = [&](StoredCoordinate c) {
      if (c.denominator_limbs == 0) return c;
      const std::size_t count =
          (c.numerator_limbs & kLimbCountMask) + std::size_t{c.denominator_limbs};
      const auto digits = limbs(from).subspan(static_cast<std::size_t>(c.payload), count);
      c.payload = static_cast<std::int64_t>(limbs(region).size());
      append_limbs(region, digits);
      return c;
    };
    const StoredCoordinate x = copy(RegionAccess::x(from, vertex));
    add_vertex(region, x, copy(RegionAccess::y(from, vertex)));
  }
  /// Appends a vertex to a region that has no origins.
  static void add_vertex(Region& region, const StoredCoordinate& x, const StoredCoordinate& y) {
    region.arrays_.push_back<Region::kVertices>({x, y});
  }
  /// Changes the origins as if the operands had been given the other way round.
  static void exchange_operands(Region& region) {
    for (EdgeOrigin& origin : region.arrays_.change<Region::kOrigins>()) {
      const bool first = origin.edge_operand == Operand::kFirst;
      origin.edge_operand = first ? Operand::kSecond : Operand::kFirst;
    }
  }
  static void clear_origins(Region& region) { region.arrays_.resize<Region::kOrigins>(0); }

  /// The sizes of a region that is to be made.
  struct Room {
    std::size_t vertices = 0;
    std::size_t origins = 0;
    std::size_t rings = 1;
    std::size_t polygons = 1;
    std::size_t limbs = 0;
  };
  static void reserve(Region& region, const Room& room) {
    region.arrays_.reserve({room.vertices, room.origins, room.rings, room.polygons, room.limbs});
  }
  /// Returns the sizes of a region.
  static Room room_of(const Region& region) {
    return {region.vertex_count(), region.arrays_.size<Region::kOrigins>(), region.ring_count(),
            region.polygon_count(), limbs(region).size()};
  }
  /// Adds a polygon of one ring to an empty region. The caller must set vertices and origins
  /// afterwards.
  static void make_ring(Region& region, const Room& room) {
    reserve(region, room);
    region.begin_polygon();
    region.begin_ring();
    region.arrays_.resize<Region::kVertices>(room.vertices);
    region.arrays_.resize<Region::kOrigins>(room.origins);
  }
  /// Sets a vertex of a region that has not been copied.
  static void set_vertex(Region& region, std::size_t vertex, const StoredCoordinate& x,
                         const StoredCoordinate& y) {
    region.arrays_.unshared<Region::kVertices>(vertex) = {x, y};
  }
  static void set_origin(Region& region, std::size_t vertex, const EdgeOrigin& origin) {
    region.arrays_.unshared<Region::kOrigins>(vertex) = origin;
  }
  /// Drops all vertices but the first ones.
  static void keep_vertices(Region& region, std::size_t vertices) {
    region.arrays_.resize<Region::kVertices>(vertices);
    if (region.arrays_.size<Region::kOrigins>() > 0) {
      region.arrays_.resize<Region::kOrigins>(vertices);
    }
  }

  /// Returns the double nearest to a coordinate of this region.
  static double nearest(const Region& region, const StoredCoordinate& coordinate) {
    return region.nearest(coordinate);
  }
  /// Returns a coordinate without its powers of two and ten, not in lowest terms.
  static Quotient<BigInteger> quotient(const Region& region, const StoredCoordinate& coordinate);
  /// Returns a coordinate without its power of two, not in lowest terms, if that is short enough.
  static std::optional<ShortQuotient> short_quotient(const Region& region,
                                                     const StoredCoordinate& coordinate);
  static Rational exact(const Region& region, const StoredCoordinate& coordinate) {
    return region.exact(coordinate);
  }

  /// Returns the bits of the longer of a vertex's coordinates, or somewhat more.
  static std::size_t bits(const Region& region, std::size_t vertex) {
    const auto of = [](const StoredCoordinate& c) {
      const std::size_t limbs = std::max<std::size_t>(
          {1, static_cast<std::size_t>(c.numerator_limbs & kLimbCountMask), c.denominator_limbs});
      return 64 * limbs + static_cast<std::size_t>(std::abs(c.exp2) + 4 * std::abs(c.exp10));
    };
    return std::max(of(x(region, vertex)), of(y(region, vertex)));
  }

  /// Returns the order of two coordinates of this region.
  static std::strong_ordering compare(const Region& region, const StoredCoordinate& a,
                                      const StoredCoordinate& b);

  /// Returns the index of a ring's first vertex; `ring` may be the count of rings.
  static std::size_t ring_first(const Region& region, std::size_t ring) {
    return ring < region.ring_count() ? region.arrays_.at<Region::kRingStarts>(ring)
                                      : region.vertex_count();
  }
  /// Returns the index of a polygon's first ring; `polygon` may be the count of polygons.
  static std::size_t polygon_first_ring(const Region& region, std::size_t polygon) {
    return polygon < region.polygon_count() ? region.arrays_.at<Region::kPolygonStarts>(polygon)
                                            : region.ring_count();
  }
  /// Returns the ring that holds a vertex, or the polygon that holds a ring. O(log n).
  static std::size_t ring_of(const Region& region, std::size_t vertex);
  static std::size_t polygon_of(const Region& region, std::size_t ring);
  /// Returns the place of a vertex, for an Error.
  static Culprit culprit(const Region& region, std::size_t vertex, int operand = -1);
};

}  // namespace minksum
