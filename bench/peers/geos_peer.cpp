#include <geos_c.h>

#include <stdexcept>
#include <vector>

#include "peers/peers.hpp"
#include "peers/stopwatch.hpp"

namespace minksum::bench {
namespace {

void ignore_message(const char*, void*) {}

struct ContextDeleter {
  void operator()(GEOSContextHandle_t context) const { GEOS_finish_r(context); }
};
using Context = std::unique_ptr<std::remove_pointer_t<GEOSContextHandle_t>, ContextDeleter>;

struct GeometryDeleter {
  GEOSContextHandle_t context = nullptr;
  void operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy_r(context, geometry); }
};
using Geometry = std::unique_ptr<GEOSGeometry, GeometryDeleter>;

GEOSGeometry* make_ring(GEOSContextHandle_t context, const Region& region, std::size_t ring) {
  const IndexRange vertices = region.vertices_of(ring);
  const auto size = static_cast<unsigned>(vertices.size());
  GEOSCoordSequence* points = GEOSCoordSeq_create_r(context, size + 1, 2);
  for (unsigned i = 0; i <= size; ++i) {
    const std::size_t v = vertices.front() + (i == size ? 0 : i);
    GEOSCoordSeq_setXY_r(context, points, i, region.x(v), region.y(v));
  }
  return GEOSGeom_createLinearRing_r(context, points);
}

GEOSGeometry* make_geometry(GEOSContextHandle_t context, const Region& region) {
  std::vector<GEOSGeometry*> polygons;
  for (const std::size_t polygon : region.polygons()) {
    std::vector<GEOSGeometry*> rings;
    for (const std::size_t ring : region.rings_of(polygon)) {
      rings.push_back(make_ring(context, region, ring));
    }
    polygons.push_back(GEOSGeom_createPolygon_r(context, rings.front(), rings.data() + 1,
                                                static_cast<unsigned>(rings.size() - 1)));
  }
  return GEOSGeom_createCollection_r(context, GEOS_MULTIPOLYGON, polygons.data(),
                                     static_cast<unsigned>(polygons.size()));
}

class BufferPeer : public Peer {
 public:
  BufferPeer(const Region& p, double radius, int quadrant_segments)
      : context_(GEOS_init_r()), radius_(radius), quadrant_segments_(quadrant_segments) {
    GEOSContext_setErrorMessageHandler_r(context_.get(), ignore_message, nullptr);
    geometry_ = make_geometry(context_.get(), p);
    if (geometry_ == nullptr) throw std::runtime_error("GEOS took no such region");
  }
  ~BufferPeer() override { GEOSGeom_destroy_r(context_.get(), geometry_); }

  double run(std::size_t times) override {
    Geometry buffer;
    const double seconds = seconds_of(times, buffer, [&] {
      return Geometry(GEOSBuffer_r(context_.get(), geometry_, radius_, quadrant_segments_),
                      {context_.get()});
    });
    if (buffer == nullptr) throw std::runtime_error("GEOS made no buffer");
    vertices_ = static_cast<std::size_t>(GEOSGetNumCoordinates_r(context_.get(), buffer.get()));
    GEOSArea_r(context_.get(), buffer.get(), &area_);
    return seconds;
  }
  std::size_t result_vertices() const override { return vertices_; }
  double result_area() const override { return area_; }

 private:
  Context context_;
  GEOSGeometry* geometry_ = nullptr;
  double radius_;
  int quadrant_segments_;
  std::size_t vertices_ = 0;
  double area_ = 0;
};

}  // namespace

std::unique_ptr<Peer> make_geos_buffer(const Region& p, double radius, int quadrant_segments) {
  return std::make_unique<BufferPeer>(p, radius, quadrant_segments);
}

std::string geos_name() { return "GEOS " GEOS_VERSION; }

}  // namespace minksum::bench
