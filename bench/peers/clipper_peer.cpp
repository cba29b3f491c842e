#include <cmath>
#include <polyclipping/clipper.hpp>
#include <stdexcept>

#include "peers/peers.hpp"
#include "peers/stopwatch.hpp"

namespace minksum::bench {
namespace {

using ClipperLib::Path;
using ClipperLib::Paths;

constexpr double kScale = 1e6;

Path outer_ring(const Region& region) {
  Path path;
  for (const std::size_t v : region.vertices_of(0)) {
    path.emplace_back(std::llround(region.x(v) * kScale), std::llround(region.y(v) * kScale));
  }
  if (!ClipperLib::Orientation(path)) ClipperLib::ReversePath(path);
  return path;
}

class ClipperPeer : public Peer {
 public:
  ClipperPeer(const Region& p, const Region& q) : p_(outer_ring(p)), q_(outer_ring(q)) {}
  double run(std::size_t times) override {
    return seconds_of(times, sum_, [&] {
      Paths sum;
      ClipperLib::MinkowskiSum(p_, q_, sum, true);
      return sum;
    });
  }
  std::size_t result_vertices() const override {
    std::size_t vertices = 0;
    for (const Path& path : sum_) vertices += path.size();
    return vertices;
  }

 private:
  Path p_;
  Path q_;
  Paths sum_;
};

}  // namespace

std::unique_ptr<Peer> make_clipper(const Region& p, const Region& q) {
  if (p.ring_count() != 1 || q.ring_count() != 1) return nullptr;
  return std::make_unique<ClipperPeer>(p, q);
}

std::string clipper_name() { return "Clipper " CLIPPER_VERSION; }

}  // namespace minksum::bench
