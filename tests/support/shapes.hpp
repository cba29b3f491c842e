// Making, moving and printing regions in tests.
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

/// A region of one polygon.
[[nodiscard]] Region make_polygon(const Outline& outer, const std::vector<Outline>& holes = {});
/// A region of several polygons, each its outer ring and then its holes.
[[nodiscard]] Region make_region(const std::vector<std::vector<Outline>>& polygons);
[[nodiscard]] Region rectangle(std::int64_t min_x, std::int64_t min_y, std::int64_t max_x,
                               std::int64_t max_y);

/// Every vertex replaced; origins are not kept.
[[nodiscard]] Region transformed(const Region& region, const std::function<Point(const Point&)>& f);
[[nodiscard]] Region moved(const Region& region, const Rational& dx, const Rational& dy);
/// Scaled by a factor of any sign but zero.
[[nodiscard]] Region scaled(const Region& region, const Rational& factor);
/// Turned by 90 degrees counter-clockwise.
[[nodiscard]] Region turned(const Region& region);
[[nodiscard]] Region mirrored(const Region& region);
/// All parts of both, side by side.
[[nodiscard]] Region together(const Region& a, const Region& b);

/// The same set written differently: rings turned round and started elsewhere, repeated vertices,
/// vertices in the middle of straight edges.
[[nodiscard]] Region scrambled(const Region& region, Random& random);

/// Exact WKT, for messages.
[[nodiscard]] std::string to_text(const Region& region);

}  // namespace minksum::test
