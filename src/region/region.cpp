#include "minksum/region.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "machine/bad_input.hpp"
#include "minksum/geometry.hpp"
#include "region/region_access.hpp"

namespace minksum {

namespace {

// Returns the index of the last start that is not after `index`. Starts may repeat.
std::size_t last_until(std::span<const std::size_t> starts, std::size_t index) {
  const auto after = std::ranges::upper_bound(starts, index);
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - starts.begin(), 1)) - 1;
}

void require_finite(double x, double y, const Region& region, std::size_t vertex) {
  if (std::isfinite(x) && std::isfinite(y)) return;
  const bool not_a_number = std::isnan(x) || std::isnan(y);
  throw Error(ErrorCode::kBadInput,
              not_a_number ? "a coordinate is not a number (NaN)" : "a coordinate is infinite",
              RegionAccess::culprit(region, vertex, -1));
}

}  // namespace

Region::Region(const Region& other) noexcept = default;
Region::Region(Region&& other) noexcept = default;
Region& Region::operator=(const Region& other) noexcept = default;
Region& Region::operator=(Region&& other) noexcept = default;
Region::~Region() = default;

// Geometry has no file of its own: all else is in its header.
Geometry::Geometry(const Geometry& other) = default;
Geometry::Geometry(Geometry&& other) noexcept = default;
Geometry& Geometry::operator=(const Geometry& other) = default;
Geometry& Geometry::operator=(Geometry&& other) noexcept = default;
Geometry::~Geometry() = default;

Region::Region(const Polygon& polygon) : Region(std::span<const Polygon>(&polygon, 1)) {}

Region::Region(std::span<const Polygon> polygons) {
  const auto add_ring = [this](const Ring& ring) {
    begin_ring();
    for (const Point& point : ring) add_vertex(point.x, point.y);
  };
  for (const Polygon& polygon : polygons) {
    begin_polygon();
    add_ring(polygon.outer);
    for (const Ring& hole : polygon.holes) add_ring(hole);
  }
}

void Region::clear() { arrays_.clear(); }

void Region::begin_polygon() { arrays_.push_back<kPolygonStarts>(ring_count()); }

void Region::begin_ring() {
  if (polygon_count() == 0) {
    refuse_input("begin_ring before any begin_polygon");
  }
  arrays_.push_back<kRingStarts>(vertex_count());
}

void Region::require_open_ring() const {
  if (polygon_count() == 0 || arrays_.get<kPolygonStarts>().back() == ring_count()) {
    refuse_input("add_vertex before any begin_ring in this polygon");
  }
}

void Region::add_vertex(const Rational& x, const Rational& y) {
  require_open_ring();
  const StoredCoordinate stored_x = store(x);
  arrays_.push_back<kVertices>({stored_x, store(y)});
}

void Region::add_vertex(Decimal x, Decimal y) {
  require_open_ring();
  const auto fits = [](Decimal value) {
    return value.exponent >= INT16_MIN && value.exponent <= INT16_MAX;
  };
  if (!fits(x) || !fits(y)) {
    add_vertex(Rational(x), Rational(y));
    return;
  }
  const auto compact = [](Decimal value) {
    return StoredCoordinate{value.mantissa, 0, static_cast<std::int16_t>(value.exponent), 0, 0};
  };
  arrays_.push_back<kVertices>({compact(x), compact(y)});
}

void Region::add_vertex(double x, double y) {
  require_open_ring();
  require_finite(x, y, *this, vertex_count());
  arrays_.push_back<kVertices>({store(x), store(y)});
}

void Region::add_vertex(std::int64_t x, std::int64_t y) {
  require_open_ring();
  arrays_.push_back<kVertices>({StoredCoordinate{x, 0, 0, 0, 0}, StoredCoordinate{y, 0, 0, 0, 0}});
}

namespace {

template <class Number>
Region one_ring(std::span<const std::array<Number, 2>> outer) {
  Region region;
  region.begin_polygon();
  region.begin_ring();
  for (const auto& [x, y] : outer) region.add_vertex(x, y);
  return region;
}

void require_offsets(std::span<const std::int64_t> offsets, std::size_t size, const char* what) {
  const bool good = !offsets.empty() && offsets.front() == 0 && std::ranges::is_sorted(offsets) &&
                    static_cast<std::size_t>(offsets.back()) == size;
  if (good) return;
  throw Error(ErrorCode::kBadInput, std::string(what) +
                                        " must begin with 0, never run back, and end with " +
                                        std::to_string(size));
}

}  // namespace

Region Region::from_points(std::span<const std::array<double, 2>> outer) { return one_ring(outer); }
Region Region::from_points(std::span<const std::array<std::int64_t, 2>> outer) {
  return one_ring(outer);
}

Region Region::from_flat(std::span<const double> coordinates,
                         std::span<const std::int64_t> ring_offsets,
                         std::span<const std::int64_t> polygon_offsets) {
  if (coordinates.size() % 2 != 0) {
    refuse_input("an odd number of coordinates");
  }
  require_offsets(ring_offsets, coordinates.size() / 2, "ring offsets");
  require_offsets(polygon_offsets, ring_offsets.size() - 1, "polygon offsets");
  Region region;
  Arrays& arrays = region.arrays_;
  const std::size_t vertices = coordinates.size() / 2;
  arrays.reserve({vertices, 0, ring_offsets.size() - 1, polygon_offsets.size() - 1, 0});
  for (const std::int64_t first : polygon_offsets.first(polygon_offsets.size() - 1)) {
    arrays.push_back<kPolygonStarts>(static_cast<std::size_t>(first));
  }
  for (const std::int64_t first : ring_offsets.first(ring_offsets.size() - 1)) {
    arrays.push_back<kRingStarts>(static_cast<std::size_t>(first));
  }
  arrays.resize<kVertices>(vertices);
  const std::span<StoredPoint> points = arrays.change<kVertices>();
  for (std::size_t v = 0; v < vertices; ++v) {
    const double x = coordinates[2 * v];
    const double y = coordinates[2 * v + 1];
    require_finite(x, y, region, v);
    points[v] = {region.store(x), region.store(y)};
  }
  return region;
}

FlatRegion Region::flat() const {
  FlatRegion flat;
  flat.coordinates.reserve(2 * vertex_count());
  for (std::size_t v = 0; v < vertex_count(); ++v) {
    flat.coordinates.push_back(x(v));
    flat.coordinates.push_back(y(v));
  }
  const auto append_ends = [](IndexRange indices, auto end_of, std::vector<std::int64_t>& offsets) {
    for (const std::size_t i : indices) offsets.push_back(static_cast<std::int64_t>(end_of(i)));
  };
  append_ends(
      {0, ring_count()}, [&](std::size_t r) { return RegionAccess::ring_first(*this, r + 1); },
      flat.ring_offsets);
  append_ends(
      polygons(), [&](std::size_t p) { return RegionAccess::polygon_first_ring(*this, p + 1); },
      flat.polygon_offsets);
  return flat;
}

std::size_t RingView::polygon() const { return RegionAccess::polygon_of(*region_, index_); }

bool RingView::is_hole() const {
  return RegionAccess::polygon_first_ring(*region_, polygon()) != index_;
}

IndexRange Region::rings_of(std::size_t polygon) const {
  return {RegionAccess::polygon_first_ring(*this, polygon),
          RegionAccess::polygon_first_ring(*this, polygon + 1)};
}

IndexRange Region::vertices_of(std::size_t ring) const {
  return {RegionAccess::ring_first(*this, ring), RegionAccess::ring_first(*this, ring + 1)};
}

Polygon Region::polygon(std::size_t index) const {
  Polygon result;
  bool first = true;
  for (const std::size_t ring : rings_of(index)) {
    Ring points;
    points.reserve(vertices_of(ring).size());
    for (const std::size_t vertex : vertices_of(ring)) points.push_back(point(vertex));
    if (first) {
      result.outer = std::move(points);
    } else {
      result.holes.push_back(std::move(points));
    }
    first = false;
  }
  return result;
}

std::size_t Region::polygon_count_with_rings() const {
  std::size_t count = 0;
  for (const std::size_t polygon : polygons()) {
    if (!rings_of(polygon).empty()) ++count;
  }
  return count;
}

std::size_t RegionAccess::ring_of(const Region& region, std::size_t vertex) {
  return last_until(region.arrays_.get<Region::kRingStarts>(), vertex);
}

std::size_t RegionAccess::polygon_of(const Region& region, std::size_t ring) {
  return last_until(region.arrays_.get<Region::kPolygonStarts>(), ring);
}

Culprit RegionAccess::culprit(const Region& region, std::size_t vertex, int operand) {
  const std::size_t ring = ring_of(region, vertex);
  const std::size_t polygon = polygon_of(region, ring);
  return {operand, polygon, ring - polygon_first_ring(region, polygon),
          vertex - ring_first(region, ring)};
}

}  // namespace minksum
