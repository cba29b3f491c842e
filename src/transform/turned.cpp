#include "transform/turned.hpp"

#include <algorithm>
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

class Turner {
 public:
  Turner(const Region& region, int quarters, bool with_origins)
      : region_(region), quarters_(((quarters % 4) + 4) % 4), with_origins_(with_origins) {
    RegionAccess::reserve(image_, region.vertex_count());
    RegionAccess::mutable_limbs(image_).assign(RegionAccess::limbs(region).begin(),
                                               RegionAccess::limbs(region).end());
  }

  /// Rings and vertices in the order that they have.
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
    if (region_.ring_count() == 1) return only_ring();
    std::vector<TurnedRing> rings;
    std::vector<IndexRange> polygons;
    rings.reserve(region_.ring_count());
    polygons.reserve(region_.polygon_count());
    const auto before = [this](const TurnedRing& a, const TurnedRing& b) {
      return ring_before(a, b);
    };
    for (const std::size_t polygon : region_.polygons()) {
      const auto begin = static_cast<std::ptrdiff_t>(rings.size());
      for (const std::size_t ring : region_.rings_of(polygon)) rings.push_back(turned_ring(ring));
      std::sort(rings.begin() + begin + 1, rings.end(), before);
      polygons.emplace_back(static_cast<std::size_t>(begin), rings.size());
    }
    std::ranges::sort(polygons, [&](const IndexRange& a, const IndexRange& b) {
      return ring_before(rings[a.front()], rings[b.front()]);
    });
    for (const IndexRange& polygon : polygons) {
      image_.begin_polygon();
      for (const std::size_t ring : polygon) write(rings[ring]);
    }
    return std::move(image_);
  }

 private:
  Region only_ring() {
    image_.begin_polygon();
    write(turned_ring(0));
    return std::move(image_);
  }

  /// A ring of the region, and the vertex that its image starts at.
  struct TurnedRing {
    IndexRange vertices;
    std::size_t first_vertex;
    StoredPoint first;
    StoredPoint second;
  };

  /// Of a coordinate that lies in the image's pool, if it has digits.
  StoredCoordinate negative(StoredCoordinate c) {
    if (c.denominator_limbs > 0) {
      if ((c.numerator_limbs & kLimbCountMask) != 0) c.numerator_limbs ^= kNegativeLimbs;
    } else if (c.payload != std::numeric_limits<std::int64_t>::min()) {
      c.payload = -c.payload;
    } else {
      auto& limbs = RegionAccess::mutable_limbs(image_);
      c.payload = static_cast<std::int64_t>(limbs.size());
      limbs.insert(limbs.end(), {std::uint64_t{1} << 63U, 1});
      c.numerator_limbs = 1;
      c.denominator_limbs = 1;
    }
    return c;
  }
  StoredPoint image(std::size_t vertex) {
    const StoredCoordinate& x = RegionAccess::x(region_, vertex);
    const StoredCoordinate& y = RegionAccess::y(region_, vertex);
    if (quarters_ == 1) return {negative(y), x};
    if (quarters_ == 2) return {negative(x), negative(y)};
    if (quarters_ == 3) return {y, negative(x)};
    return {x, y};
  }

  [[nodiscard]] std::strong_ordering compare(const StoredPoint& a, const StoredPoint& b) const {
    const std::strong_ordering by_x = RegionAccess::compare(image_, a.x, b.x);
    return by_x != 0 ? by_x : RegionAccess::compare(image_, a.y, b.y);
  }
  /// Rings differ in their first vertex, or at least in the one after it.
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
  bool with_origins_;
  Region image_;
};

}  // namespace

Region turned(const Region& region, int quarters) {
  return quarters % 4 == 0 ? region
                           : Turner(region, quarters, region.has_origins()).in_canonical_order();
}
Region turned_in_order(const Region& region, int quarters) {
  return Turner(region, quarters, false).in_order();
}

}  // namespace minksum
