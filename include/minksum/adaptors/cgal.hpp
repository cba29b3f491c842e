// Converts regions from and to the polygons of CGAL: Polygon_2 and Polygon_with_holes_2 of any
// kernel. This header is optional: it is only for programs that have CGAL themselves. Large parts
// of CGAL are GPL, and then so is a program that includes them. The library minksum neither
// contains CGAL nor links it.
#pragma once

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Fraction_traits.h>
#include <CGAL/MP_Float.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "minksum/adaptors/shared.hpp"
#include "minksum/error.hpp"
#include "minksum/rational.hpp"
#include "minksum/region.hpp"

namespace minksum::adaptors {

namespace detail {

/// Returns the exact number inside a lazy one, and any other number as it is.
template <class Number>
decltype(auto) inside(const Number& number) {
  if constexpr (requires { number.exact(); }) {
    return number.exact();
  } else {
    return number;
  }
}
template <class Number>
using Inside = std::remove_cvref_t<decltype(inside(std::declval<const Number&>()))>;

/// Returns an integer of any library in decimal digits.
template <class Integer>
std::string digits_of(const Integer& integer) {
  // GMP's own classes print to streams by a library that a program need not have.
  if constexpr (requires { integer.get_str(); }) {
    return integer.get_str();
  } else {
    std::ostringstream out;
    out << integer;
    return out.str();
  }
}

/// Returns the integer of a text, which may have more digits than Rational::parse takes.
inline Rational integer_of(std::string_view digits) {
  const bool negative = digits.starts_with('-');
  if (negative) digits.remove_prefix(1);
  constexpr std::size_t kPart = 1000;
  Rational value;
  while (!digits.empty()) {
    const std::string_view part = digits.substr(0, kPart);
    const std::optional<Rational> number = Rational::parse(part);
    if (!number || part.find_first_not_of("0123456789") != std::string_view::npos) {
      reject("a coordinate is not a number");
    }
    value = value * Rational(Decimal{1, static_cast<int>(part.size())}) + *number;
    digits.remove_prefix(part.size());
  }
  return negative ? -value : value;
}

/// Converts a part of CGAL's fraction that is an integer of any library.
template <class Part>
Rational from_part(const Part& part) {
  using Category = typename CGAL::Algebraic_structure_traits<Part>::Algebraic_category;
  static_assert(std::is_convertible_v<Category, CGAL::Euclidean_ring_tag>,
                "coordinates must be of a plain type, or fractions of integers");
  return integer_of(digits_of(part));
}
/// Converts one that has 16-bit digits and a power of 2^16. It would print no more than a double.
inline Rational from_part(const CGAL::MP_Float& part) {
  const Rational base(65536);
  Rational value;
  for (auto digit = part.v.rbegin(); digit != part.v.rend(); ++digit) {
    value = value * base + Rational(*digit);
  }
  for (auto power = part.exp; power > 0; --power) value = value * base;
  for (auto power = part.exp; power < 0; ++power) value = value / base;
  return value;
}

template <class Exact>
Rational from_fraction(const Exact& number) {
  using Traits = CGAL::Fraction_traits<Exact>;
  static_assert(Traits::Is_fraction::value,
                "coordinates must be of a plain type, or exact fractions");
  typename Traits::Numerator_type numerator;
  typename Traits::Denominator_type denominator;
  typename Traits::Decompose()(number, numerator, denominator);
  return from_part(numerator) / from_part(denominator);
}

/// Converts an integer a few digits at a time. Number types agree on nothing but arithmetic with
/// small integers.
template <class Exact>
Exact to_integer(const Rational& value) {
  constexpr std::size_t kPart = 9;
  const std::string text = value.to_string();
  std::string_view digits = text;
  const bool negative = digits.starts_with('-');
  if (negative) digits.remove_prefix(1);
  Exact result(0);
  while (!digits.empty()) {
    const std::string_view part = digits.substr(0, kPart);
    int number = 0;
    int power = 1;
    for (const char digit : part) {
      number = 10 * number + (digit - '0');
      power *= 10;
    }
    result = result * Exact(power) + Exact(number);
    digits.remove_prefix(part.size());
  }
  return negative ? Exact(-result) : result;
}

template <class Exact>
Exact to_fraction(const Rational& value) {
  static_assert(CGAL::Fraction_traits<Exact>::Is_fraction::value,
                "coordinates must be of a plain type, or exact fractions");
  const double nearest = value.to_double();
  if (std::isfinite(nearest) && Rational(nearest) == value) return Exact(nearest);
  return to_integer<Exact>(value.numerator()) / to_integer<Exact>(value.denominator());
}

template <class Number>
Rational from_cgal_number(const Number& number) {
  if constexpr (kIsPlainNumber<Number>) {
    return number;
  } else {
    // Both bounds of most lazy numbers are one double, and then the exact number need not be made.
    const auto [low, high] = CGAL::to_interval(number);
    if (low == high && std::isfinite(low)) return low;
    return from_fraction(inside(number));
  }
}

template <class Kernel, class Container>
void add_cgal_ring(const CGAL::Polygon_2<Kernel, Container>& ring, Region& region) {
  using Number = typename Kernel::FT;
  region.begin_ring();
  auto first = ring.vertices_begin();
  auto last = ring.vertices_end();
  if (ring.size() > 1 && *first == *std::prev(last)) --last;
  for (; first != last; ++first) {
    if constexpr (kIsPlainNumber<Number>) {
      region.add_vertex(first->x(), first->y());
    } else {
      region.add_vertex(from_cgal_number(first->x()), from_cgal_number(first->y()));
    }
  }
}

template <class Kernel, class Container>
void add_cgal_polygon(const CGAL::Polygon_2<Kernel, Container>& polygon, Region& region) {
  if (polygon.is_empty()) return;
  region.begin_polygon();
  add_cgal_ring(polygon, region);
}

template <class Kernel, class Container>
void add_cgal_polygon(const CGAL::Polygon_with_holes_2<Kernel, Container>& polygon,
                      Region& region) {
  const std::size_t index = region.polygon_count();
  if (polygon.outer_boundary().is_empty()) {
    reject(
        "a polygon without an outer boundary is the whole plane: polygon " + std::to_string(index),
        place_of(index, 0));
  }
  region.begin_polygon();
  add_cgal_ring(polygon.outer_boundary(), region);
  for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole) {
    if (!hole->is_empty()) add_cgal_ring(*hole, region);
  }
}

/// Tells what differs between Polygon_2 and Polygon_with_holes_2.
template <class Type>
struct CgalPolygon {
  static constexpr bool kKnown = false;
};
template <class Kernel, class Container>
struct CgalPolygon<CGAL::Polygon_2<Kernel, Container>> {
  static constexpr bool kKnown = true;
  static constexpr bool kHasHoles = false;
  using Traits = Kernel;
  using Ring = CGAL::Polygon_2<Kernel, Container>;
};
template <class Kernel, class Container>
struct CgalPolygon<CGAL::Polygon_with_holes_2<Kernel, Container>> {
  static constexpr bool kKnown = true;
  static constexpr bool kHasHoles = true;
  using Traits = Kernel;
  using Ring = CGAL::Polygon_2<Kernel, Container>;
};

template <class Number>
Number to_cgal_number(const Rational& value, const Culprit& place) {
  if constexpr (kIsPlainNumber<Number>) {
    return detail::from_rational<Number>(value, place);
  } else {
    return Number(to_fraction<Inside<Number>>(value));
  }
}

template <class Polygon>
typename CgalPolygon<Polygon>::Ring make_cgal_ring(const Region& region, const Culprit& place) {
  using Kernel = typename CgalPolygon<Polygon>::Traits;
  using Number = typename Kernel::FT;
  typename CgalPolygon<Polygon>::Ring made;
  const std::size_t ring = region.rings_of(place.polygon).front() + place.ring;
  Culprit vertex = place;
  for (const std::size_t v : directed(region, ring, place.ring == 0 ? 1 : -1)) {
    vertex.vertex = v - region.vertices_of(ring).front();
    made.push_back(typename Kernel::Point_2(to_cgal_number<Number>(region.exact_x(v), vertex),
                                            to_cgal_number<Number>(region.exact_y(v), vertex)));
  }
  return made;
}

template <class Polygon>
Polygon make_cgal_polygon(const Region& region, std::size_t index) {
  const std::vector<Culprit> rings = rings_of(region, index);
  auto outer = make_cgal_ring<Polygon>(region, rings.front());
  if constexpr (CgalPolygon<Polygon>::kHasHoles) {
    Polygon polygon(std::move(outer));
    for (std::size_t i = 1; i < rings.size(); ++i) {
      polygon.add_hole(make_cgal_ring<Polygon>(region, rings[i]));
    }
    return polygon;
  } else {
    if (rings.size() > 1) {
      reject("a polygon with holes is no Polygon_2: " + detail::to_string(rings[1]), rings[1]);
    }
    return outer;
  }
}

}  // namespace detail

/// Returns the region of a polygon of CGAL, or of a range of polygons (a vector, a list), ring by
/// ring and vertex by vertex. They are Polygon_2 or Polygon_with_holes_2 of any kernel.
///
/// Coordinates are taken exactly: doubles, floats and integers as they are, lazy numbers (as in
/// EPECK) by their exact value, and others as fractions. The compiler refuses numbers with roots. A
/// last point that repeats the first is left out. Rings keep their orientation, which has no
/// meaning in a Region. An empty Polygon_2 and empty holes are left out. Nothing else is checked:
/// ask `validate`, or let the operations refuse or resolve what is not valid.
///
/// O(n) for n points. Throws Error(kBadInput): for NaN and infinity, with polygon, ring and vertex;
/// for a Polygon_with_holes_2 without an outer boundary, which is unbounded in CGAL.
template <class CgalGeometry>
[[nodiscard]] Region from_cgal(const CgalGeometry& geometry) {
  Region region;
  if constexpr (detail::CgalPolygon<CgalGeometry>::kKnown) {
    detail::add_cgal_polygon(geometry, region);
  } else {
    for (const auto& polygon : geometry) detail::add_cgal_polygon(polygon, region);
  }
  return region;
}

/// Returns a region as polygons of CGAL:
/// `to_cgal<std::vector<CGAL::Polygon_with_holes_2<Kernel>>>(region)`. The type is a container of
/// polygons, or one polygon if the region has no more.
///
/// Kernels with exact fractions, such as EPECK, get the exact numbers. Kernels with doubles or
/// floats get the nearest ones. Rounding may make rings cross, so call `round` (round.hpp) first,
/// which keeps them valid. Integers are never rounded: a coordinate that is not an integer is an
/// error. Outer rings become counter-clockwise and holes clockwise, as CGAL wants them. The first
/// point is not repeated. Rings and polygons without vertices are left out. The direction of a ring
/// that crosses itself is that of the turn at its smallest vertex.
///
/// O(n) for n vertices. A number of d digits that is not a double takes O(d²). Throws
/// Error(kBadInput) with the polygon if the region does not fit the type: two or more polygons for
/// one, a hole for a Polygon_2, a number that is not an integer. No polygon does not fit a
/// Polygon_with_holes_2 either, as an empty one is the whole plane. Throws Error(kLimitExceeded)
/// for a coordinate beyond the range of its type.
template <class CgalGeometry>
[[nodiscard]] CgalGeometry to_cgal(const Region& region) {
  if constexpr (detail::CgalPolygon<CgalGeometry>::kKnown) {
    if (const auto polygon = detail::only_polygon(region, "single polygon of CGAL")) {
      return detail::make_cgal_polygon<CgalGeometry>(region, *polygon);
    }
    if constexpr (detail::CgalPolygon<CgalGeometry>::kHasHoles) {
      detail::reject("nothing is no Polygon_with_holes_2: an empty one is the whole plane");
    }
    return CgalGeometry();
  } else {
    CgalGeometry polygons;
    for (const std::size_t polygon : detail::polygons_of(region)) {
      polygons.push_back(
          detail::make_cgal_polygon<typename CgalGeometry::value_type>(region, polygon));
    }
    return polygons;
  }
}

}  // namespace minksum::adaptors
