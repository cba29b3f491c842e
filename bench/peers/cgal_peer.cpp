// Only this file of the benchmark includes CGAL, because CGAL takes long to compile.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/minkowski_sum_2.h>
#include <CGAL/version.h>

#include <iterator>
#include <stdexcept>
#include <vector>

#include "peers/peers.hpp"
#include "peers/stopwatch.hpp"

namespace minksum::bench {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using CgalPolygon = CGAL::Polygon_2<Kernel>;
using CgalRegion = CGAL::Polygon_with_holes_2<Kernel>;
using Reduced = CGAL::Minkowski_sum_by_reduced_convolution_2<Kernel, CgalPolygon::Container>;

CgalPolygon to_cgal(const Region& region, std::size_t ring, bool is_hole) {
  CgalPolygon polygon;
  for (const std::size_t v : region.vertices_of(ring)) {
    const Kernel::Point_2 point(region.x(v), region.y(v));
    if (polygon.is_empty() || point != *std::prev(polygon.vertices_end())) polygon.push_back(point);
  }
  if (polygon.is_clockwise_oriented() != is_hole) polygon.reverse_orientation();
  return polygon;
}

struct Extent {
  double width;
  double height;
};

Extent extent(const CgalPolygon& polygon) {
  const CGAL::Bbox_2 box = polygon.bbox();
  return {box.xmax() - box.xmin(), box.ymax() - box.ymin()};
}

void require_single(const Region& region) {
  if (region.polygon_count() != 1) throw std::runtime_error("CGAL sums single polygons only");
}

// This replaces CGAL 5.5's own filter of holes, which corrupts memory.
CgalRegion with_large_holes(const Region& region, const Extent& other) {
  CgalRegion result(to_cgal(region, 0, false));
  for (std::size_t ring = 1; ring < region.ring_count(); ++ring) {
    const CgalPolygon hole = to_cgal(region, ring, true);
    const Extent size = extent(hole);
    if (other.width < size.width && other.height < size.height) result.add_hole(hole);
  }
  return result;
}

class ReducedPeer : public Peer {
 public:
  ReducedPeer(const Region& p, const Region& q) {
    const Extent size_p = extent(to_cgal(p, 0, false));
    const Extent size_q = extent(to_cgal(q, 0, false));
    p_ = with_large_holes(p, size_q);
    q_ = with_large_holes(q, size_p);
  }
  double run(std::size_t times) override {
    return seconds_of(times, sum_, [&] {
      Rings sum;
      Reduced()(p_, q_, sum.outer, std::back_inserter(sum.holes));
      return sum;
    });
  }
  std::size_t result_vertices() const override {
    std::size_t vertices = sum_.outer.size();
    for (const CgalPolygon& hole : sum_.holes) vertices += hole.size();
    return vertices;
  }

 private:
  struct Rings {
    CgalPolygon outer;
    std::vector<CgalPolygon> holes;
  };
  CgalRegion p_;
  CgalRegion q_;
  Rings sum_;
};

class FullPeer : public Peer {
 public:
  FullPeer(const Region& p, const Region& q) : p_(to_cgal(p, 0, false)), q_(to_cgal(q, 0, false)) {}
  double run(std::size_t times) override {
    return seconds_of(times, sum_,
                      [&] { return CGAL::minkowski_sum_by_full_convolution_2(p_, q_); });
  }
  std::size_t result_vertices() const override {
    std::size_t vertices = sum_.outer_boundary().size();
    for (auto hole = sum_.holes_begin(); hole != sum_.holes_end(); ++hole) vertices += hole->size();
    return vertices;
  }

 private:
  CgalPolygon p_;
  CgalPolygon q_;
  CgalRegion sum_;
};

}  // namespace

std::unique_ptr<Peer> make_cgal_reduced(const Region& p, const Region& q) {
  require_single(p);
  require_single(q);
  return std::make_unique<ReducedPeer>(p, q);
}

std::unique_ptr<Peer> make_cgal_full(const Region& p, const Region& q) {
  require_single(p);
  require_single(q);
  if (p.ring_count() != 1 || q.ring_count() != 1) return nullptr;
  return std::make_unique<FullPeer>(p, q);
}

std::string cgal_name() { return "CGAL " CGAL_VERSION_STR; }

}  // namespace minksum::bench
