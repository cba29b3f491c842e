// Converts regions from and to polygons and multipolygons of Boost.Geometry. This header is
// optional: it includes Boost.Geometry, which the library itself does not need at run time.
#pragma once

#include <boost/geometry/core/access.hpp>
#include <boost/geometry/core/closure.hpp>
#include <boost/geometry/core/coordinate_dimension.hpp>
#include <boost/geometry/core/coordinate_system.hpp>
#include <boost/geometry/core/coordinate_type.hpp>
#include <boost/geometry/core/cs.hpp>
#include <boost/geometry/core/exterior_ring.hpp>
#include <boost/geometry/core/interior_rings.hpp>
#include <boost/geometry/core/mutable_range.hpp>
#include <boost/geometry/core/point_order.hpp>
#include <boost/geometry/core/point_type.hpp>
#include <boost/geometry/core/ring_type.hpp>
#include <boost/geometry/core/tag.hpp>
#include <boost/geometry/core/tags.hpp>
#include <boost/range/begin.hpp>
#include <boost/range/end.hpp>
#include <boost/range/size.hpp>
#include <boost/range/value_type.hpp>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "minksum/adaptors/shared.hpp"
#include "minksum/error.hpp"
#include "minksum/region.hpp"

namespace minksum::adaptors {

namespace detail {
namespace bg = boost::geometry;

template <class Geometry>
inline constexpr bool kIsBoostPolygon =
    std::is_same_v<typename bg::tag<Geometry>::type, bg::polygon_tag>;
template <class Geometry>
inline constexpr bool kIsBoostMultiPolygon =
    std::is_same_v<typename bg::tag<Geometry>::type, bg::multi_polygon_tag>;

template <class Geometry>
constexpr void require_plane() {
  static_assert(kIsBoostPolygon<Geometry> || kIsBoostMultiPolygon<Geometry>,
                "this takes polygons and multipolygons of Boost.Geometry");
  static_assert(bg::dimension<Geometry>::value == 2, "points must have two coordinates");
  static_assert(std::is_same_v<typename bg::coordinate_system<Geometry>::type, bg::cs::cartesian>,
                "points must be of the plane, with Cartesian coordinates");
}

template <class Ring>
void add_boost_ring(const Ring& ring, Region& region) {
  add_ring(
      region, boost::begin(ring), boost::end(ring),
      [](const auto& point) { return bg::get<0>(point); },
      [](const auto& point) { return bg::get<1>(point); });
}

template <class Polygon>
void add_boost_polygon(const Polygon& polygon, Region& region) {
  const auto& outer = bg::exterior_ring(polygon);
  auto&& holes = bg::interior_rings(polygon);
  bool has_holes = false;
  for (auto hole = boost::begin(holes); hole != boost::end(holes); ++hole) {
    has_holes = has_holes || boost::size(*hole) > 0;
  }
  if (boost::size(outer) == 0) {
    if (has_holes) reject_holes_alone(region.polygon_count());
    return;
  }
  region.begin_polygon();
  add_boost_ring(outer, region);
  for (auto hole = boost::begin(holes); hole != boost::end(holes); ++hole) {
    if (boost::size(*hole) > 0) add_boost_ring(*hole, region);
  }
}

/// Fills `ring`, which may be a reference or a proxy.
template <class RingOrProxy>
void set_boost_ring(const Region& region, const Culprit& place, RingOrProxy&& ring) {
  using Ring = std::remove_reference_t<RingOrProxy>;
  using Point = typename bg::point_type<Ring>::type;
  using Number = typename bg::coordinate_type<Ring>::type;
  const bool clockwise = bg::point_order<Ring>::value == bg::clockwise;
  const auto append = [&ring](const Point& point) {
    bg::traits::push_back<Ring>::apply(ring, point);
  };
  for_each_vertex<Number>(region, place, clockwise == (place.ring == 0) ? -1 : 1, nullptr,
                          [&append](const Number& x, const Number& y) {
                            Point point{};
                            bg::set<0>(point, x);
                            bg::set<1>(point, y);
                            append(point);
                          });
  if (bg::closure<Ring>::value == bg::closed && boost::size(ring) > 0) {
    const Point first = *boost::begin(ring);
    append(first);
  }
}

template <class Polygon>
void set_boost_polygon(const Region& region, std::size_t index, Polygon& polygon) {
  const std::vector<Culprit> rings = rings_of(region, index);
  set_boost_ring(region, rings.front(), bg::exterior_ring(polygon));
  auto&& holes = bg::interior_rings(polygon);
  bg::traits::resize<std::remove_reference_t<decltype(holes)>>::apply(holes, rings.size() - 1);
  std::size_t next = 1;
  for (auto hole = boost::begin(holes); hole != boost::end(holes); ++hole) {
    set_boost_ring(region, rings[next++], *hole);
  }
}
}  // namespace detail

/// Returns the region of a polygon or multipolygon of Boost.Geometry, ring by ring and vertex by
/// vertex.
///
/// Coordinates are taken exactly. They are integers of up to 64 bits, float, double, or numbers
/// that convert to Rational (see NumberTraits). Rings may be closed or open: a last point that
/// repeats the first is left out. Rings keep their orientation, which has no meaning in a Region.
/// Rings and polygons without points are left out. Nothing else is checked: ask `validate`, or let
/// the operations refuse or resolve what is not valid.
///
/// O(n) for n points. Throws Error(kBadInput): for NaN and infinity, with polygon (among those with
/// points), ring and vertex; for a polygon with holes and an empty outer ring.
template <class BoostGeometry>
[[nodiscard]] Region from_boost(const BoostGeometry& geometry) {
  detail::require_plane<BoostGeometry>();
  Region region;
  if constexpr (detail::kIsBoostPolygon<BoostGeometry>) {
    detail::add_boost_polygon(geometry, region);
  } else {
    for (auto polygon = boost::begin(geometry); polygon != boost::end(geometry); ++polygon) {
      detail::add_boost_polygon(*polygon, region);
    }
  }
  return region;
}

/// Returns a region as a polygon or multipolygon of Boost.Geometry:
/// `to_boost<MultiPolygon>(region)`.
///
/// Rings are closed and directed as the type wants them (`closure`, `point_order`), holes against
/// their outer ring. Rings and polygons without vertices are left out. So
/// `boost::geometry::is_valid` accepts what a valid region gives, with one exception: here, rings
/// of one polygon may touch at several points. The direction of a ring that crosses itself is that
/// of the turn at its smallest vertex.
///
/// Doubles and floats are the nearest ones. Rounding may make rings cross, so call `round`
/// (round.hpp) first, which keeps them valid. Integers are never rounded: a coordinate that is not
/// an integer is an error. Other types are constructed from a Rational (see NumberTraits).
///
/// O(n) for n vertices. Throws Error: kBadInput for a coordinate that is not an integer where the
/// type has integers, with polygon, ring and vertex; kBadInput for two or more polygons where the
/// type is a polygon, and for a polygon with holes and an empty outer ring; kLimitExceeded for a
/// coordinate beyond the range of its type, with polygon, ring and vertex.
template <class BoostGeometry>
[[nodiscard]] BoostGeometry to_boost(const Region& region) {
  detail::require_plane<BoostGeometry>();
  BoostGeometry result;
  if constexpr (detail::kIsBoostPolygon<BoostGeometry>) {
    if (const auto polygon = detail::only_polygon(region, "single polygon of Boost.Geometry")) {
      detail::set_boost_polygon(region, *polygon, result);
    }
  } else {
    for (const std::size_t polygon : detail::polygons_of(region)) {
      typename boost::range_value<BoostGeometry>::type part;
      detail::set_boost_polygon(region, polygon, part);
      boost::geometry::traits::push_back<BoostGeometry>::apply(result, std::move(part));
    }
  }
  return result;
}

}  // namespace minksum::adaptors
