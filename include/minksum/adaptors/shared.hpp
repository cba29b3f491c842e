// Holds what the adaptors share: numbers of other libraries, rings, and places for errors. It
// includes no other library. Users include the adaptor of their library instead.
#pragma once

#include <charconv>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

#include "minksum/error.hpp"
#include "minksum/rational.hpp"
#include "minksum/region.hpp"

namespace minksum::adaptors {

/// Says how numbers of another library become exact numbers, and back. Users may specialise it for
/// a number type of their own. Integers of up to 64 bits, float and double do not need it.
template <class Number>
struct NumberTraits {
  /// Returns the same number. Throws Error(kBadInput) if it is not finite.
  static Rational to_rational(const Number& number) {
    static_assert(std::convertible_to<const Number&, Rational>,
                  "coordinates of this type have no exact conversion: specialise NumberTraits");
    return number;
  }
  /// Returns the same number. A specialisation may return the nearest one if the type cannot hold
  /// the number and its users expect that.
  static Number from_rational(const Rational& value) {
    static_assert(std::constructible_from<Number, const Rational&>,
                  "Rational does not convert to this type: specialise NumberTraits");
    return Number(value);
  }
};

namespace detail {

// Others are refused: a long double, and an integer of more than 64 bits, would silently lose bits.
template <class Number>
inline constexpr bool kIsPlainNumber = std::is_same_v<Number, float> ||
                                       std::is_same_v<Number, double> ||
                                       (std::is_integral_v<Number> && sizeof(Number) <= 8);

template <class Number>
Rational to_rational(const Number& number) {
  if constexpr (kIsPlainNumber<Number>) {
    return number;
  } else {
    static_assert(!std::is_arithmetic_v<Number>, "long double coordinates are not supported");
    return NumberTraits<Number>::to_rational(number);
  }
}

template <class Number>
void add_vertex(Region& region, const Number& x, const Number& y) {
  if constexpr (kIsPlainNumber<Number>) {
    region.add_vertex(x, y);
  } else {
    region.add_vertex(detail::to_rational(x), detail::to_rational(y));
  }
}

/// Adds the ring of a range of points. A last point that repeats the first one is left out.
template <class Iterator, class X, class Y>
void add_ring(Region& region, Iterator first, Iterator last, const X& x_of, const Y& y_of) {
  region.begin_ring();
  if (std::distance(first, last) > 1) {
    const Iterator back = std::prev(last);
    if (x_of(*first) == x_of(*back) && y_of(*first) == y_of(*back)) last = back;
  }
  for (; first != last; ++first) detail::add_vertex(region, x_of(*first), y_of(*first));
}

[[noreturn]] inline void reject(const std::string& message, const Culprit& place = {}) {
  throw Error(ErrorCode::kBadInput, message, place);
}

/// Returns a place as messages have it: "polygon 0, ring 1, vertex 2".
inline std::string to_string(const Culprit& place) {
  std::string text;
  const auto append = [&text](const char* what, std::size_t index) {
    if (index == Culprit::kNone) return;
    text += (text.empty() ? "" : ", ") + std::string(what) + ' ' + std::to_string(index);
  };
  append("polygon", place.polygon);
  append("ring", place.ring);
  append("vertex", place.vertex);
  return text;
}

[[noreturn]] inline void reject_range(const char* kind, const Culprit& place) {
  std::string message = std::string("a coordinate is beyond the range of ") + kind;
  if (place.polygon != Culprit::kNone) message += ": " + to_string(place);
  throw Error(ErrorCode::kLimitExceeded, message, place, {}, ExceededLimit{kind});
}

inline double nearest_double(const Rational& value, const Culprit& place) {
  const double nearest = value.to_double();
  if (!std::isfinite(nearest)) reject_range("doubles", place);
  return nearest;
}

/// Returns the nearest float. Rounding first to a double and then to a float would round twice.
inline float nearest_float(const Rational& value, const Culprit& place) {
  const double near = nearest_double(value, place);
  const auto nearest = static_cast<float>(near);
  if (!std::isfinite(nearest)) {
    // Numbers up to the middle between the largest float and the next power of two become that
    // float. The middle itself does not, but the nearest double may be the middle.
    const Rational middle(0x1.ffffffp+127);
    if (value >= middle || -value >= middle) reject_range("floats", place);
    return std::copysign(std::numeric_limits<float>::max(), nearest);
  }
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const float other = std::nextafter(nearest, near > nearest ? kInfinity : -kInfinity);
  // The double may lie in the middle between two floats while the number itself does not.
  const bool middle = near != nearest && near - nearest == other - near;
  if (!middle) return nearest;
  const Rational exact_middle(near);
  if (value == exact_middle) return nearest;
  return (value > exact_middle) == (other > nearest) ? other : nearest;
}

template <class Integer>
Integer exact_integer(const Rational& value, const Culprit& place) {
  if (!value.is_integer()) {
    const std::string number = value.bits() <= 128 ? ' ' + value.to_string() : "";
    reject("the coordinate" + number + " is not an integer: " + to_string(place), place);
  }
  const std::string digits = value.to_string();
  Integer integer = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), integer);
  if (error != std::errc() || end != digits.data() + digits.size()) {
    reject_range("integers", place);
  }
  return integer;
}

/// Converts a number to the nearest double or float, to the same integer, or as NumberTraits says.
/// Throws Error: kBadInput for a number that is not an integer, where the type has integers;
/// kLimitExceeded beyond the range of a type.
template <class Number>
Number from_rational(const Rational& value, const Culprit& place) {
  if constexpr (std::is_same_v<Number, double>) {
    return nearest_double(value, place);
  } else if constexpr (std::is_same_v<Number, float>) {
    return nearest_float(value, place);
  } else if constexpr (kIsPlainNumber<Number>) {
    return exact_integer<Number>(value, place);
  } else {
    static_assert(!std::is_arithmetic_v<Number>, "long double coordinates are not supported");
    return NumberTraits<Number>::from_rational(value);
  }
}

/// Compares two vertices lexicographically and exactly.
inline bool comes_before(const Region& region, std::size_t a, std::size_t b) {
  // Rounding keeps the order, so exact numbers are made only where doubles are equal.
  if (region.x(a) != region.x(b)) return region.x(a) < region.x(b);
  const Rational ax = region.exact_x(a);
  const Rational bx = region.exact_x(b);
  if (ax != bx) return ax < bx;
  if (region.y(a) != region.y(b)) return region.y(a) < region.y(b);
  return region.exact_y(a) < region.exact_y(b);
}

/// Returns the direction of a ring: 1 = counter-clockwise, -1 = clockwise, 0 = there is no turn at
/// its smallest vertex. That vertex tells the direction of every simple ring. O(n).
inline int direction(const Region& region, std::size_t ring) {
  const IndexRange vertices = region.vertices_of(ring);
  const std::size_t n = vertices.size();
  if (n < 3) return 0;
  std::size_t smallest = 0;
  for (std::size_t i = 1; i < n; ++i) {
    if (comes_before(region, vertices.front() + i, vertices.front() + smallest)) smallest = i;
  }
  const Point at = region.point(vertices.front() + smallest);
  // This finds the nearest vertex that differs, `step` by `step` along the ring.
  const auto neighbour = [&](std::size_t step) {
    std::size_t i = smallest;
    Point found = at;
    do {
      i = (i + step) % n;
      found = region.point(vertices.front() + i);
    } while (found == at && i != smallest);
    return found;
  };
  const Point before = neighbour(n - 1);
  const Point after = neighbour(1);
  const Rational turn = (at.x - before.x) * (after.y - at.y) - (at.y - before.y) * (after.x - at.x);
  return turn.sign();
}

/// Returns the vertices of a ring from its first one on, in the `wanted` direction: 1 =
/// counter-clockwise, -1 = clockwise. A ring without a direction stays as it is.
inline std::vector<std::size_t> directed(const Region& region, std::size_t ring, int wanted) {
  const IndexRange vertices = region.vertices_of(ring);
  const std::size_t first = vertices.front();
  const std::size_t n = vertices.size();
  const bool turn_round = direction(region, ring) == -wanted;
  std::vector<std::size_t> order;
  order.reserve(n);
  for (std::size_t i = 0; i < n; ++i) order.push_back(first + (turn_round ? (n - i) % n : i));
  return order;
}

/// Calls `use(x, y)` for the vertices of a ring, as Numbers and in the `wanted` direction.
/// Coordinates are multiplied by `scale`, unless it is null, before they are converted.
template <class Number, class Use>
void for_each_vertex(const Region& region, Culprit place, int wanted, const Rational* scale,
                     const Use& use) {
  const std::size_t ring = region.rings_of(place.polygon).front() + place.ring;
  const std::size_t first = region.vertices_of(ring).front();
  for (const std::size_t vertex : directed(region, ring, wanted)) {
    place.vertex = vertex - first;
    if constexpr (std::is_same_v<Number, double>) {
      const double x = region.x(vertex);
      const double y = region.y(vertex);
      if (scale == nullptr && std::isfinite(x) && std::isfinite(y)) {
        use(x, y);
        continue;
      }
    }
    const auto number = [&](const Rational& value) {
      return detail::from_rational<Number>(scale == nullptr ? value : value * *scale, place);
    };
    Number x = number(region.exact_x(vertex));
    use(std::move(x), number(region.exact_y(vertex)));
  }
}

/// Returns the place of a ring.
inline Culprit place_of(std::size_t polygon, std::size_t ring) {
  Culprit place;
  place.polygon = polygon;
  place.ring = ring;
  return place;
}

/// Returns the polygons that have vertices.
inline std::vector<std::size_t> polygons_of(const Region& region) {
  std::vector<std::size_t> found;
  for (const std::size_t polygon : region.polygons()) {
    for (const std::size_t ring : region.rings_of(polygon)) {
      if (region.vertices_of(ring).empty()) continue;
      found.push_back(polygon);
      break;
    }
  }
  return found;
}

/// Returns the only polygon with vertices, or nothing. Throws Error(kBadInput) with the second one.
inline std::optional<std::size_t> only_polygon(const Region& region, const char* type) {
  const std::vector<std::size_t> polygons = polygons_of(region);
  if (polygons.empty()) return std::nullopt;
  if (polygons.size() > 1) {
    Culprit place;
    place.polygon = polygons[1];
    reject("a region of " + std::to_string(polygons.size()) + " polygons is no " + type, place);
  }
  return polygons[0];
}

/// Throws Error(kBadInput) for a polygon that has holes and an outer ring without points.
[[noreturn]] inline void reject_holes_alone(std::size_t polygon) {
  reject(
      "a polygon has holes, but its outer ring has no points: polygon " + std::to_string(polygon),
      place_of(polygon, 0));
}

/// Returns the rings of a polygon that have vertices, the outer one first. Throws Error(kBadInput)
/// if the outer ring has none.
inline std::vector<Culprit> rings_of(const Region& region, std::size_t polygon) {
  std::vector<Culprit> rings;
  std::size_t index = 0;
  for (const std::size_t ring : region.rings_of(polygon)) {
    const bool empty = region.vertices_of(ring).empty();
    if (empty && index == 0) reject_holes_alone(polygon);
    if (!empty) rings.push_back(place_of(polygon, index));
    ++index;
  }
  return rings;
}

}  // namespace detail

}  // namespace minksum::adaptors
