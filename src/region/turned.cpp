#include "region/turned.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "region/region_access.hpp"

namespace minksum {
namespace {

struct StoredPoint {
  StoredCoordinate x;
  StoredCoordinate y;
};

/// Turns a region by so many right angles.
class Turner {
 public:
  Turner(const Region& region, int quarters, bool with_origins, Cancellation& cancellation)
      : region_(region),
        quarters_(((quarters % 4) + 4) % 4),
        cancellation_(cancellation),
        with_origins_(with_origins) {
    RegionAccess::Room room = RegionAccess::room_of(region);
    if (!with_origins) room.origins = 0;
    RegionAccess::reserve(image_, room);
    RegionAccess::append_limbs(image_, RegionAccess::limbs(region));
  }

  /// Returns the image with rings and vertices in the order that they have.
  Region in_order() {
    for (const std::size_t polygon : region_.polygons()) {
      image_.begin_polygon();
      for (const std::size_t ring : region_.rings_of(polygon)) {
        image_.begin_ring();
        write(region_.vertices_of(ring));
      }
    }
    return std::move(image_);
  }

  Region in_canonical_order() {
    std::vector<TurnedRing> rings;
    std::vector<IndexRange> polygons;
    rings.reserve(region_.ring_count());
    polygons.reserve(region_.polygon_count());
    const auto before = cancellation_.counting(
        [this](const TurnedRing& a, const TurnedRing& b) { return ring_before(a, b); });
    for (const std::size_t polygon : region_.polygons()) {
      const auto begin = static_cast<std::ptrdiff_t>(rings.size());
      for (const std::size_t ring : region_.rings_of(polygon)) rings.push_back(turned_ring(ring));
      std::sort(rings.begin() + begin + 1, rings.end(), before);
      polygons.emplace_back(static_cast<std::size_t>(begin), rings.size());
    }
    std::ranges::sort(polygons, cancellation_.counting([&](const auto& a, const auto& b) {
      return ring_before(rings[a.front()], rings[b.front()]);
    }));
    for (const IndexRange& polygon : polygons) {
      image_.begin_polygon();
      for (const std::size_t ring : polygon) write(rings[ring]);
    }
    return std::move(image_);
  }

 private:
  /// A ring of the region, with the vertex at which its image starts.
  struct TurnedRing {
    IndexRange vertices;
    std::size_t first_vertex;
    StoredPoint first;
    StoredPoint second;
  };

  /// Returns −c. If c has digits, they must lie in the image's pool.
  StoredCoordinate negative(StoredCoordinate c) {
    if (c.denominator_limbs > 0) {
      if ((c.numerator_limbs & kLimbCountMask) != 0) c.numerator_limbs ^= kNegativeLimbs;
      return c;
    }
    if (c.payload == std::numeric_limits<std::int64_t>::min()) return negative_of_smallest(c);
    c.payload = -c.payload;
    return c;
  }
  [[gnu::noinline]] StoredCoordinate negative_of_smallest(StoredCoordinate c) {
    c.payload = static_cast<std::int64_t>(RegionAccess::limbs(image_).size());
    RegionAccess::append_limbs(image_, std::array{std::uint64_t{1} << 63U, std::uint64_t{1}});
    c.numerator_limbs = 1;
    c.denominator_limbs = 1;
    return c;
  }
  StoredPoint image(std::size_t vertex) {
    cancellation_.check();
    const StoredCoordinate& x = RegionAccess::x(region_, vertex);
    const StoredCoordinate& y = RegionAccess::y(region_, vertex);
    if (quarters_ == 2) return {negative(x), negative(y)};
    if (quarters_ == 1) return {negative(y), x};
    if (quarters_ == 3) return {y, negative(x)};
    return {x, y};
  }

  [[nodiscard]] std::strong_ordering compare(const StoredCoordinate& a,
                                             const StoredCoordinate& b) const {
    const bool quick =
        (a.denominator_limbs | b.denominator_limbs) == 0 && a.exp2 == b.exp2 && a.exp10 == b.exp10;
    return quick ? a.payload <=> b.payload : RegionAccess::compare(image_, a, b);
  }
  [[nodiscard]] std::strong_ordering compare(const StoredPoint& a, const StoredPoint& b) const {
    const std::strong_ordering by_x = compare(a.x, b.x);
    return by_x != 0 ? by_x : compare(a.y, b.y);
  }
  /// Orders rings by their first vertices, and by the next ones where these are equal. Two rings
  /// differ in one of them.
  [[nodiscard]] bool ring_before(const TurnedRing& a, const TurnedRing& b) const {
    const std::strong_ordering by_first = compare(a.first, b.first);
    return (by_first != 0 ? by_first : compare(a.second, b.second)) < 0;
  }

  TurnedRing turned_ring(std::size_t index) {
    const IndexRange vertices = region_.vertices_of(index);
    std::size_t smallest = vertices.front();
    StoredPoint first = image(smallest);
    for (const std::size_t v : vertices) {
      const StoredPoint point = image(v);
      if (compare(point, first) >= 0) continue;
      smallest = v;
      first = point;
    }
    const std::size_t last = vertices.front() + vertices.size() - 1;
    return {vertices, smallest, first, image(smallest == last ? vertices.front() : smallest + 1)};
  }

  void write(const TurnedRing& ring) {
    image_.begin_ring();
    write({ring.first_vertex, ring.vertices.front() + ring.vertices.size()});
    write({ring.vertices.front(), ring.first_vertex});
  }
  void write(const IndexRange& vertices) {
    for (const std::size_t v : vertices) {
      const StoredPoint at = image(v);
      if (with_origins_) {
        RegionAccess::add_vertex(image_, at.x, at.y, region_.origin(v));
      } else {
        RegionAccess::add_vertex(image_, at.x, at.y);
      }
    }
  }

  const Region& region_;
  int quarters_;
  Cancellation& cancellation_;
  bool with_origins_;
  Region image_;
};

}  // namespace

Region turned(const Region& region, int quarters, Cancellation& cancellation) {
  if (quarters % 4 == 0) return region;
  return Turner(region, quarters, region.has_origins(), cancellation).in_canonical_order();
}
Region in_canonical_order(const Region& region, Cancellation& cancellation) {
  return Turner(region, 0, region.has_origins(), cancellation).in_canonical_order();
}
Region turned_in_order(const Region& region, int quarters, Cancellation& cancellation) {
  return Turner(region, quarters, false, cancellation).in_order();
}

}  // namespace minksum
