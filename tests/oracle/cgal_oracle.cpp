// Only this file includes CGAL, because CGAL takes long to compile.
#include "oracle/cgal_oracle.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/version.h>

// This header needs the polygons above, but does not include them.
#include <CGAL/Minkowski_sum_2/Minkowski_sum_by_reduced_convolution_2.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "reference/canonical.hpp"
#include "reference/exact.hpp"

namespace minksum::oracle {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using CgalPolygon = CGAL::Polygon_2<Kernel>;
using CgalPolygonWithHoles = CGAL::Polygon_with_holes_2<Kernel>;
using Container = CgalPolygon::Container;
using Sum = CGAL::Minkowski_sum_by_reduced_convolution_2<Kernel, Container>;
using Exact = Kernel::FT::Exact_type;
using reference::Loop;
using reference::Loops;
using reference::Number;

Kernel::FT to_cgal(const Number& value) { return Kernel::FT(Exact(value.str())); }

// Writes a number of CGAL's exact type, which CGAL's configuration chooses. GMP's own type would
// need another library to be streamed.
template <class Type>
std::string text_of(const Type& exact) {
  if constexpr (requires { exact.get_str(); }) {
    return exact.get_str();
  } else {
    std::ostringstream out;
    out << exact;
    return out.str();
  }
}

Number from_cgal(const Kernel::FT& value) { return Number(text_of(value.exact())); }

CgalPolygon to_cgal(const Loop& loop) {
  CgalPolygon polygon;
  for (const auto& p : loop) polygon.push_back({to_cgal(p.x), to_cgal(p.y)});
  return polygon;
}

Loop from_cgal(const CgalPolygon& polygon) {
  Loop loop;
  for (auto it = polygon.vertices_begin(); it != polygon.vertices_end(); ++it) {
    loop.push_back({from_cgal(it->x()), from_cgal(it->y())});
  }
  return loop;
}

struct Extent {
  Number width;
  Number height;
};

Extent extent(const Loop& loop) {
  Number min_x = loop[0].x, max_x = loop[0].x, min_y = loop[0].y, max_y = loop[0].y;
  for (const auto& p : loop) {
    min_x = std::min(min_x, p.x);
    max_x = std::max(max_x, p.x);
    min_y = std::min(min_y, p.y);
    max_y = std::max(max_y, p.y);
  }
  return {max_x - min_x, max_y - min_y};
}

// Returns the rings of a region of one polygon: directed, without repeated vertices, and with
// touching edges split.
Loops rings_of(const Region& region) {
  if (region.polygon_count() != 1) throw std::runtime_error("CGAL sums single polygons only");
  return reference::directed_and_noded(reference::to_loops(region));
}

// Leaves out the holes that are too small: an open hole cannot hold an operand of its own width or
// height.
CgalPolygonWithHoles without_small_holes(const Loops& rings, const Extent& other) {
  CgalPolygonWithHoles result(to_cgal(rings[0]));
  for (std::size_t h = 1; h < rings.size(); ++h) {
    const Extent hole = extent(rings[h]);
    if (other.width < hole.width && other.height < hole.height) result.add_hole(to_cgal(rings[h]));
  }
  return result;
}

}  // namespace

CgalSum cgal_sum(const Region& p, const Region& q) {
  const Loops rings_p = rings_of(p);
  const Loops rings_q = rings_of(q);
  const CgalPolygonWithHoles cgal_p = without_small_holes(rings_p, extent(rings_q[0]));
  const CgalPolygonWithHoles cgal_q = without_small_holes(rings_q, extent(rings_p[0]));
  CgalPolygon outer;
  std::vector<CgalPolygon> holes;
  CgalSum result;
  const auto start = std::chrono::steady_clock::now();
  Sum()(cgal_p, cgal_q, outer, std::back_inserter(holes));
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  Loops rings{from_cgal(outer)};
  for (const CgalPolygon& hole : holes) rings.push_back(from_cgal(hole));
  result.sum = reference::link_rings(rings);
  return result;
}

const char* cgal_version() { return "CGAL " CGAL_VERSION_STR; }

}  // namespace minksum::oracle
