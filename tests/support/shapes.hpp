// Makes, moves and prints regions in tests.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "minksum/region.hpp"
#include "support/random.hpp"

namespace minksum::test {

struct Vertex {
  std::int64_t x;
  std::int64_t y;
  friend bool operator==(const Vertex&, const Vertex&) = default;
};
using Outline = std::vector<Vertex>;

/// Returns a region of one polygon.
[[nodiscard]] Region make_polygon(const Outline& outer, const std::vector<Outline>& holes = {});
/// Returns a region of several polygons, each of which is its outer ring and then its holes.
[[nodiscard]] Region make_region(const std::vector<std::vector<Outline>>& polygons);
[[nodiscard]] Region rectangle(std::int64_t min_x, std::int64_t min_y, std::int64_t max_x,
                               std::int64_t max_y);

/// Returns the region with every vertex replaced and without origins.
[[nodiscard]] Region transformed(const Region& region, const std::function<Point(const Point&)>& f);
[[nodiscard]] Region moved(const Region& region, const Rational& dx, const Rational& dy);
/// Returns the region scaled by a factor that is not zero.
[[nodiscard]] Region scaled(const Region& region, const Rational& factor);
/// Returns the region turned by 90 degrees counter-clockwise.
[[nodiscard]] Region turned(const Region& region);
[[nodiscard]] Region mirrored(const Region& region);
/// Returns all parts of both regions, without uniting them.
[[nodiscard]] Region together(const Region& a, const Region& b);

/// Returns the same set written differently: with reversed rings, other first vertices, repeated
/// vertices, and vertices in the middle of straight edges.
[[nodiscard]] Region scrambled(const Region& region, Random& random);

/// Returns exact WKT for messages.
[[nodiscard]] std::string to_text(const Region& region);

}  // namespace minksum::test
