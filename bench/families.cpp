#include "families.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "outlines.hpp"
#include "support/random.hpp"

namespace minksum::bench {
namespace {

using test::Random;

struct Corner {
  double x;
  double y;
};
using Corners = std::vector<Corner>;

// Returns a number of six decimals, as people write them down.
Decimal decimal(double value) { return {std::llround(value * 1e6), -6}; }

void add_ring(Region& region, const Corners& corners) {
  region.begin_ring();
  for (const Corner& c : corners) region.add_vertex(decimal(c.x), decimal(c.y));
}

Region to_region(const Corners& corners) {
  Region region;
  region.begin_polygon();
  add_ring(region, corners);
  return region;
}

double uniform(Random& random) { return static_cast<double>(random.next() >> 11U) * 0x1p-53; }

double turn(double part) { return 2 * std::numbers::pi * part; }

Corner polar(double angle, double radius) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

Corners spiky_star(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  Corners corners;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle =
        turn((static_cast<double>(i) + 0.3 * uniform(random)) / static_cast<double>(n));
    const double radius = (i % 2 == 0 ? 10 : 3) * (0.8 + 0.2 * uniform(random));
    corners.push_back(polar(angle, radius));
  }
  return corners;
}

Operands spiky_stars(std::size_t n) {
  return {to_region(spiky_star(n, 1)), to_region(spiky_star(n, 2))};
}

// Returns a back of height 1 with n / 4 teeth of different heights.
Corners comb(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  const std::size_t teeth = std::max<std::size_t>(n / 4, 1);
  const double pitch = 100.0 / static_cast<double>(teeth);
  Corners corners{{0, -10}, {100, -10}};
  for (std::size_t i = teeth; i-- > 0;) {
    const double left = pitch * static_cast<double>(i);
    const double top = 60 + 40 * uniform(random);
    corners.push_back({left + 0.7 * pitch, 0});
    corners.push_back({left + 0.6 * pitch, top});
    corners.push_back({left + 0.3 * pitch, top});
    corners.push_back({left + 0.1 * pitch, 0});
  }
  return corners;
}

Operands combs(std::size_t n) {
  Corners q = comb(n, 2);
  for (Corner& c : q) c = {-c.y, c.x};
  return {to_region(comb(n, 1)), to_region(q)};
}

// Returns an Archimedean band of 16 vertices a turn on each side.
Corners spiral(std::size_t n, double scale) {
  const std::size_t half = n / 2;
  Corners corners;
  const auto at = [&](std::size_t i, double offset) {
    const double turns = static_cast<double>(i) / 16;
    return polar(turn(turns), scale * (turns + 0.5 + offset));
  };
  for (std::size_t i = 0; i < half; ++i) corners.push_back(at(i, 0.3));
  for (std::size_t i = half; i-- > 0;) corners.push_back(at(i, 0));
  return corners;
}

Operands spirals(std::size_t n) { return {to_region(spiral(n, 1)), to_region(spiral(n, 0.05))}; }

bool crosses(const Corner& a, const Corner& b, const Corner& c, const Corner& d) {
  const auto side = [](const Corner& o, const Corner& p, const Corner& q) {
    return (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
  };
  return side(a, b, c) * side(a, b, d) <= 0 && side(c, d, a) * side(c, d, b) <= 0;
}

// Returns whether the path a, b, c can replace the edge number `at` without crossing any other.
bool fits(const Corners& ring, std::size_t at, const Corner& middle) {
  const std::size_t n = ring.size();
  const Corner& a = ring[at];
  const Corner& b = ring[(at + 1) % n];
  for (std::size_t i = 0; i < n; ++i) {
    if (i == at) continue;
    const Corner& c = ring[i];
    const Corner& d = ring[(i + 1) % n];
    if ((i + 1) % n != at && crosses(a, middle, c, d)) return false;
    if ((at + 1) % n != i && crosses(middle, b, c, d)) return false;
  }
  return true;
}

// Returns a triangle whose edges are bent out or in at random places, one by one, while it stays
// simple. The longer half of the edges goes first, so that no edge stays long.
Corners random_simple(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  Corners ring{{0, 0}, {100, 0}, {50, 86}};
  const auto length = [&](std::size_t i) {
    const Corner& a = ring[i];
    const Corner& b = ring[(i + 1) % ring.size()];
    return std::hypot(b.x - a.x, b.y - a.y);
  };
  while (ring.size() < n) {
    std::size_t at = random.next() % ring.size();
    for (int i = 0; i < 8; ++i) {
      const std::size_t other = random.next() % ring.size();
      if (length(other) > length(at)) at = other;
    }
    const Corner a = ring[at];
    const Corner b = ring[(at + 1) % ring.size()];
    const double along = 0.3 + 0.4 * uniform(random);
    const double across = (uniform(random) - 0.5) * 0.9;
    const Corner middle{a.x + along * (b.x - a.x) - across * (b.y - a.y),
                        a.y + along * (b.y - a.y) + across * (b.x - a.x)};
    const Corner rounded{std::round(middle.x * 1e6) / 1e6, std::round(middle.y * 1e6) / 1e6};
    if (fits(ring, at, rounded)) {
      ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(at) + 1, rounded);
    }
  }
  return ring;
}

Operands random_polygons(std::size_t n) {
  return {to_region(random_simple(n, 1)), to_region(random_simple(n, 2))};
}

// Returns a bar with a skyline above and one below.
Corners skylines(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  const std::size_t columns = std::max<std::size_t>(n / 4, 1);
  const double width = 100.0 / static_cast<double>(columns);
  Corners corners;
  for (std::size_t i = 0; i < columns; ++i) {
    const double depth = -1 - 49 * uniform(random);
    corners.push_back({width * static_cast<double>(i), depth});
    corners.push_back({width * static_cast<double>(i + 1), depth});
  }
  for (std::size_t i = columns; i-- > 0;) {
    const double height = 1 + 49 * uniform(random);
    corners.push_back({width * static_cast<double>(i + 1), height});
    corners.push_back({width * static_cast<double>(i), height});
  }
  return corners;
}

Operands orthogonal_outlines(std::size_t n) {
  return {to_region(skylines(n, 1)), to_region(skylines(n, 2))};
}

// Returns a plate with rows and columns of holes of five corners, and an octagon half as wide as
// they are.
Operands many_holes(std::size_t n) {
  Random random(1);
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(n) / 5));
  const double pitch = 100.0 / static_cast<double>(side);
  Region plate;
  plate.begin_polygon();
  add_ring(plate, {{0, 0}, {100, 0}, {100, 100}, {0, 100}});
  for (std::size_t row = 0; row < side; ++row) {
    for (std::size_t column = 0; column < side; ++column) {
      Corners hole;
      const double phase = uniform(random);
      for (int i = 5; i-- > 0;) {
        const Corner c = polar(turn((i + phase) / 5), 0.45 * pitch);
        hole.push_back({c.x + pitch * (static_cast<double>(column) + 0.5),
                        c.y + pitch * (static_cast<double>(row) + 0.5)});
      }
      add_ring(plate, hole);
    }
  }
  Corners octagon;
  for (int i = 0; i < 8; ++i) octagon.push_back(polar(turn((i + 0.1) / 8), 0.2 * pitch));
  return {plate, to_region(octagon)};
}

// Returns points of a circle whose radii differ in the fifth digit. Half of the vertices are
// reflex, and all are almost straight.
Corners dense_circle(std::size_t n, double radius, std::uint64_t seed) {
  Random random(seed);
  Corners corners;
  for (std::size_t i = 0; i < n; ++i) {
    const double wobble = 1 + 1e-4 * (uniform(random) - 0.5);
    corners.push_back(
        polar(turn(static_cast<double>(i) / static_cast<double>(n)), radius * wobble));
  }
  return corners;
}

Operands dense_circles(std::size_t n) {
  return {to_region(dense_circle(n, 100, 1)), to_region(dense_circle(n, 30, 2))};
}

Region ellipse(std::size_t n, double a, double b, double phase) {
  Region region;
  region.begin_polygon();
  region.begin_ring();
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = turn((static_cast<double>(i) + phase) / static_cast<double>(n));
    // Nine decimals keep even a hundred thousand corners convex.
    region.add_vertex(Decimal{std::llround(a * std::cos(angle) * 1e9), -9},
                      Decimal{std::llround(b * std::sin(angle) * 1e9), -9});
  }
  return region;
}

Operands convex_convex(std::size_t n) {
  return {ellipse(n, 100, 60, 0.2), ellipse(n, 40, 70, 0.7)};
}

Operands region_and_small_convex(std::size_t n) {
  Corners octagon;
  for (int i = 0; i < 8; ++i) octagon.push_back(polar(turn((i + 0.1) / 8), 1));
  return {to_region(random_simple(n, 3)), to_region(octagon)};
}

Operands with_its_negative(std::size_t n) {
  const Region p = to_region(random_simple(n, 4));
  return {p, negated(p)};
}

Region scaled(const Region& region, const Rational& by) {
  Region result;
  for (const std::size_t polygon : region.polygons()) {
    result.begin_polygon();
    for (const std::size_t ring : region.rings_of(polygon)) {
      result.begin_ring();
      for (const std::size_t v : region.vertices_of(ring)) {
        result.add_vertex(region.exact_x(v) * by, region.exact_y(v) * by);
      }
    }
  }
  return result;
}

// The radius of the disc is about ten kilometres, in degrees.
Operands outline_and_disc(std::size_t n) { return {thinned_outline(n), regular_polygon(32, 0.09)}; }

Operands outline_and_outline(std::size_t n) {
  const Region outline = thinned_outline(n);
  return {outline, scaled(outline, Rational(-1, 10))};
}

}  // namespace

const std::vector<Family>& families() {
  static const std::vector<Family> kFamilies{
      {"spiky stars", "two thin stars, every second vertex reflex", 32, spiky_stars},
      {"combs", "a comb and a comb turned by 90 degrees, teeth of random height", 32, combs},
      {"spirals", "a spiral band and one of a twentieth of its scale", 64, spirals},
      {"random simple polygons", "two triangles bent at random while simple", 32, random_polygons},
      {"orthogonal outlines", "two bars with skylines above and below", 32, orthogonal_outlines},
      {"many holes", "a plate of five-cornered holes and a small octagon", 80, many_holes},
      {"dense circles", "points of circles, radii uneven in the fifth digit", 32, dense_circles},
      {"convex + convex", "two ellipses", 64, convex_convex},
      {"region + small convex", "a random simple polygon and a small octagon", 64,
       region_and_small_convex},
      {"P + -P", "a random simple polygon and its mirror image at the origin", 32,
       with_its_negative},
      {"country outline + disc", "Norway thinned to n vertices and a 32-gon of ten kilometres", 256,
       outline_and_disc},
      {"country outline + its negative", "Norway thinned and a tenth of it turned by 180 degrees",
       64, outline_and_outline},
      {"nesting parts", "real parts, the first of n vertices or more, and the next one turned", 8,
       parts_of_size},
  };
  return kFamilies;
}

Region regular_polygon(std::size_t corners, double radius) {
  const int digits = 5 - static_cast<int>(std::floor(std::log10(radius)));
  const double scale = std::pow(10.0, digits);
  Region region;
  region.begin_polygon();
  region.begin_ring();
  for (std::size_t i = 0; i < corners; ++i) {
    const Corner c = polar(turn(static_cast<double>(i) / static_cast<double>(corners)), radius);
    region.add_vertex(Decimal{std::llround(c.x * scale), -digits},
                      Decimal{std::llround(c.y * scale), -digits});
  }
  return region;
}

Region negated(const Region& region) { return scaled(region, Rational(-1)); }

}  // namespace minksum::bench
