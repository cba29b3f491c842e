#include "overlay/take_holes.hpp"

#include <vector>

#include "minksum/validity.hpp"
#include "overlay/boolean.hpp"
#include "overlay/chains.hpp"
#include "region/region_access.hpp"

namespace minksum::overlay {
namespace {

bool wound_around(const Winding& w) { return w.first != 0; }
bool keeps_nothing(const Wall&) { return false; }

void append_ring(const Region& from, std::size_t ring, Region& region) {
  region.begin_ring();
  for (const std::size_t v : from.vertices_of(ring)) RegionAccess::copy_vertex(region, from, v);
}
Region copied(const Region& from, const IndexRange& rings) {
  Region region;
  region.begin_polygon();
  for (const std::size_t ring : rings) append_ring(from, ring, region);
  return region;
}
bool is_valid(const Region& region, const Options& options) {
  return validate(region, 1, options).empty();
}

/// Reads the rings of one polygon as chains. For each face, `first` counts the outer ring, and
/// `second` counts the holes that enclose the face.
class PolygonReader {
 public:
  PolygonReader(const Region& region, const IndexRange& rings, const Options& options)
      : region_(region), rings_(rings), options_(options) {}

  Geometry run() {
    const Region outer = copied(region_, {rings_.front(), rings_.front() + 1});
    list_by_role(outer, chains_, [this](Chain& chain) {
      chain.weight.first = 1;
      chain.belongs = !options_.regularize;
    });
    // The holes must not move, because chains point into them.
    std::vector<Hole> holes;
    holes.reserve(rings_.size());
    for (const std::size_t ring : rings_) {
      if (ring != rings_.front()) holes.push_back(read_hole(ring));
    }
    for (const Hole& hole : holes) {
      list_by_role(hole.area, chains_, [](Chain& chain) {
        chain.weight.second = 1;
        chain.spared = 1;
      });
      const std::size_t thin = chains_.size();
      hole.inner.list_chains(chains_);
      for (std::size_t i = thin; i < chains_.size(); ++i) {
        chains_[i].belongs = false;
        chains_[i].spared = 2;
      }
    }
    const Inside inside = [](const Winding& w) { return w.first != 0 && w.second == 0; };
    return select(chains_, {inside, options_.regularize ? keeps_nothing : stays}, options_);
  }

 private:
  /// The points that one hole takes away: its area less its own ring.
  struct Hole {
    Region area;
    ThinStore inner;  ///< the parts of the ring inside the area
  };

  /// Tells whether the polygon keeps a piece that has a hole, or nothing, on either side. The outer
  /// ring must hold the piece. Each hole that encloses both sides must have it on its own ring.
  static bool stays(const Wall& wall) {
    const bool held = wall.belongs || wound_around(wall.left) || wound_around(wall.right);
    return held && wall.left.second + wall.right.second <= wall.spared;
  }

  [[nodiscard]] Hole read_hole(std::size_t ring) const {
    Hole hole{copied(region_, {ring, ring + 1}), {}};
    if (is_valid(hole.area, options_)) return hole;
    std::vector<Chain> chains;
    add_rings(hole.area, {1, 0}, chains);
    const Inside nowhere = [](const Winding&) { return false; };
    const Keeps within = [](const Wall& w) {
      return wound_around(w.left) && wound_around(w.right);
    };
    // A piece that is traversed in both directions has no weight, so `spared` keeps it in the list.
    for (Chain& chain : chains) chain.spared = 1;
    const Geometry inner = select(chains, {nowhere, within}, options_);
    Region area = select(chains, {wound_around, keeps_nothing}, options_).region;
    Cancellation cancellation(options_, Stage::kOverlay);
    hole.inner.add(inner, cancellation);
    hole.area = std::move(area);
    return hole;
  }

  const Region& region_;
  IndexRange rings_;
  const Options& options_;
  std::vector<Chain> chains_;
};

}  // namespace

Geometry take_holes_away(const Geometry& geometry, const Options& options) {
  const Region& region = geometry.region;
  std::vector<Geometry> read;
  read.reserve(region.polygon_count() + 1);
  for (const std::size_t polygon : region.polygons()) {
    const IndexRange rings = region.rings_of(polygon);
    if (rings.empty()) continue;
    read.push_back({copied(region, rings), {}, {}});
    if (!is_valid(read.back().region, options)) {
      read.back() = PolygonReader(region, rings, options).run();
    }
  }
  if (!options.regularize) read.push_back({{}, geometry.polylines, geometry.points});
  return unite(read, options);
}

}  // namespace minksum::overlay
