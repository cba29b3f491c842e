#include "cgal_peer.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/minkowski_sum_2.h>

#include <chrono>

namespace minksum::bench {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using CgalPolygon = CGAL::Polygon_2<Kernel>;

CgalPolygon to_cgal(const Region& region) {
  CgalPolygon polygon;
  for (const std::size_t v : region.vertices_of(0)) {
    polygon.push_back(Kernel::Point_2(region.x(v), region.y(v)));
  }
  if (polygon.is_clockwise_oriented()) polygon.reverse_orientation();
  return polygon;
}

}  // namespace

struct CgalPeer::Polygons {
  CgalPolygon p;
  CgalPolygon q;
};

CgalPeer::CgalPeer(const Region& p, const Region& q)
    : polygons_(std::make_unique<Polygons>(Polygons{to_cgal(p), to_cgal(q)})) {}
CgalPeer::~CgalPeer() = default;

double CgalPeer::run() {
  const auto begin = std::chrono::steady_clock::now();
  { const auto sum = CGAL::minkowski_sum_by_reduced_convolution_2(polygons_->p, polygons_->q); }
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace minksum::bench
