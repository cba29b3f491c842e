// Converts regions from and to the paths of Clipper2: Paths64, PathsD, and every other vector of
// vectors of points with members x and y. This header is optional and does not include Clipper2:
// include both.
#pragma once

#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>

#include "minksum/adaptors/shared.hpp"
#include "minksum/error.hpp"
#include "minksum/rational.hpp"
#include "minksum/region.hpp"
#include "minksum/resolve.hpp"

namespace minksum::adaptors {

namespace detail {
template <class Paths>
using PathPoint = typename Paths::value_type::value_type;
template <class Paths>
using PathNumber = std::remove_cvref_t<decltype(std::declval<PathPoint<Paths>>().x)>;

inline void require_scale(const Rational& scale) {
  if (scale.sign() <= 0) reject("the scale " + scale.to_string() + " is not positive");
}
}  // namespace detail

/// Returns the region that paths mean by a fill rule, valid and canonical (see Region). All numbers
/// are taken exactly, and crossings become rational points.
///
/// Each path is closed, whether it repeats its first point at the end or not. Its direction counts
/// as the rule says. Paths without area add nothing, and Clipper's Z is not read. `scale` is that
/// of `to_clipper`: points of the paths are points of the region times `scale`, so coordinates are
/// divided by it.
///
/// O((n + c) log n) for n points and c places where edges meet, as `resolve`. Throws
/// Error(kBadInput) for NaN and infinity, with the index of the path as Culprit::polygon; for a
/// scale that is not positive; for kAutomatic and kStrict, as paths do not tell what is a hole.
/// Otherwise throws as `resolve` does.
template <class Paths>
[[nodiscard]] Region from_clipper(const Paths& paths, FillRule fill, const Rational& scale = 1) {
  if (fill == FillRule::kAutomatic || fill == FillRule::kStrict) {
    detail::reject(std::string("the fill rule ") + to_string(fill) +
                   " needs polygons; paths have none");
  }
  detail::require_scale(scale);
  Region region;
  for (const auto& path : paths) {
    region.begin_polygon();
    if (std::empty(path)) continue;
    detail::add_ring(
        region, std::begin(path), std::end(path), [](const auto& point) { return point.x; },
        [](const auto& point) { return point.y; });
  }
  if (scale != Rational(1)) {
    Region divided;
    for (const std::size_t polygon : region.polygons()) {
      divided.begin_polygon();
      for (const std::size_t ring : region.rings_of(polygon)) {
        divided.begin_ring();
        for (const std::size_t v : region.vertices_of(ring)) {
          divided.add_vertex(region.exact_x(v) / scale, region.exact_y(v) / scale);
        }
      }
    }
    region = std::move(divided);
  }
  Options options;
  options.fill = fill;
  options.regularize = true;
  return resolve(region, options).region;
}

/// Returns the rings of a region as paths: `to_clipper<Clipper2Lib::Paths64>(region)`. Coordinates
/// are multiplied by `scale`, exactly, before they are converted.
///
/// Integers are never rounded: it is an error if a coordinate times `scale` is not an integer.
/// Choose a scale that makes all of them integers, or call `round` (round.hpp) first. What `round`
/// gives with k decimals becomes integers by the scale 10^k and stays valid. Doubles and floats are
/// the nearest ones. They are exact if `round` made the region without decimals and there is no
/// scale.
///
/// Outer rings become counter-clockwise and holes clockwise, and the first point is not repeated.
/// So for a valid region kEvenOdd, kNonZero and kPositive all mean that region. Nothing else is
/// checked: paths of a region that is not valid mean what the rule makes of them. A ring without
/// vertices gives no path.
///
/// O(n) for n vertices. Throws Error: kBadInput for a scale that is not positive; kBadInput for a
/// coordinate that is not an integer, and kLimitExceeded for one beyond the range of its type, both
/// with polygon, ring and vertex. Clipper2 itself takes integers up to a quarter of that range.
template <class Paths>
[[nodiscard]] Paths to_clipper(const Region& region, const Rational& scale = 1) {
  using Number = detail::PathNumber<Paths>;
  detail::require_scale(scale);
  const Rational* const factor = scale == Rational(1) ? nullptr : &scale;
  Paths paths;
  for (const std::size_t polygon : region.polygons()) {
    std::size_t index = 0;
    for (const std::size_t ring : region.rings_of(polygon)) {
      const Culprit place = detail::place_of(polygon, index++);
      if (region.vertices_of(ring).empty()) continue;
      typename Paths::value_type path;
      path.reserve(region.vertices_of(ring).size());
      detail::for_each_vertex<Number>(region, place, place.ring == 0 ? 1 : -1, factor,
                                      [&path](Number x, Number y) {
                                        detail::PathPoint<Paths> point{};
                                        point.x = std::move(x);
                                        point.y = std::move(y);
                                        path.push_back(std::move(point));
                                      });
      paths.push_back(std::move(path));
    }
  }
  return paths;
}

}  // namespace minksum::adaptors
