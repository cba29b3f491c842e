// Makes regions for round trips through other libraries, and compares both ends.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "minksum/error.hpp"
#include "minksum/resolve.hpp"
#include "support/generators.hpp"
#include "support/polygon_kinds.hpp"
#include "support/shapes.hpp"

namespace minksum::test {

/// Returns the same set in canonical form.
inline Region canonical(const Region& region) {
  Options options;
  options.regularize = true;
  return resolve(region, options).region;
}

/// Returns a random valid region in canonical form; several parts and holes are frequent. Its
/// integers are so large that vertices which `scrambled` puts between them are integers, too.
inline Region random_source(Random& random) {
  const auto region = [&random] {
    switch (random.below(3)) {
      case 0:
        return random_region(random);
      case 1:
        return random_with_holes(random, 24, 4);
      default:
        return random_cells(random, 5, 5, true, false);
    }
  };
  return canonical(scaled(region(), Rational(1024)));
}

/// Returns a square of 9 by 9 with a square hole of 3 by 3, and a triangle beside it.
inline Region frame_and_triangle() {
  return make_region({{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{3, 3}, {3, 6}, {6, 6}, {6, 3}}},
                      {{{20, 0}, {30, 0}, {20, 10}}}});
}

/// Returns a polygon without rings, a triangle with an empty hole and a whole one, and an empty
/// ring alone.
inline Region with_empty_rings() {
  Region region;
  region.begin_polygon();
  region.begin_polygon();
  const auto ring = [&region](const Outline& vertices) {
    region.begin_ring();
    for (const auto& [x, y] : vertices) region.add_vertex(x, y);
  };
  ring({{0, 0}, {9, 0}, {0, 9}});
  ring({});
  ring({{1, 1}, {1, 2}, {2, 1}});
  region.begin_polygon();
  ring({});
  return region;
}
/// Returns that region without its empty rings.
inline Region without_empty_rings() {
  return make_polygon({{0, 0}, {9, 0}, {0, 9}}, {{{1, 1}, {1, 2}, {2, 1}}});
}
/// Returns a hole without an outer ring.
inline Region hole_alone() {
  Region region;
  region.begin_polygon();
  region.begin_ring();
  region.begin_ring();
  for (const auto& [x, y] : Outline{{0, 0}, {9, 0}, {0, 9}}) region.add_vertex(x, y);
  return region;
}

/// Returns the error that `run` throws; fails if it throws none.
template <class Run>
Error error_of(const Run& run) {
  try {
    run();
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "no error";
  return {ErrorCode::kInternal, "no error"};
}

/// Returns polygon, ring and vertex of an error, each "-" if the error does not name it.
inline std::string place_of(const Error& error) {
  const auto text = [](std::size_t index) {
    return index == Culprit::kNone ? "-" : std::to_string(index);
  };
  const Culprit& place = error.culprit();
  return text(place.polygon) + ' ' + text(place.ring) + ' ' + text(place.vertex);
}

}  // namespace minksum::test
