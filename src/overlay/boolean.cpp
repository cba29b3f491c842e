// Implements the boolean operations.
#include "overlay/boolean.hpp"

#include <optional>

#include "minksum/boolean.hpp"
#include "overlay/chains.hpp"
#include "overlay/complement.hpp"
#include "overlay/resolve_area.hpp"
#include "region/region_access.hpp"

namespace minksum {
namespace {

using overlay::Winding;

// An odd number of a valid region's rings go around each of its points, whatever their directions.
bool in_first(const Winding& w) { return w.first % 2 != 0; }
bool in_second(const Winding& w) { return w.second % 2 != 0; }

/// Returns the box that a region is, or nothing if it is not a box of four vertices.
std::optional<Box> as_box(const Region& region) {
  if (region.ring_count() != 1 || region.vertex_count() != 4) return std::nullopt;
  const auto equal = [&](const auto& coordinate, std::size_t v, std::size_t w) {
    return RegionAccess::compare(region, coordinate(region, v), coordinate(region, w)) == 0;
  };
  // Tells whether the ring starts with a side along the x axis.
  const bool across = equal(RegionAccess::y, 0, 1);
  const auto& along = across ? RegionAccess::y : RegionAccess::x;
  const auto& athwart = across ? RegionAccess::x : RegionAccess::y;
  if (!equal(along, 0, 1) || !equal(athwart, 1, 2) || !equal(along, 2, 3) ||
      !equal(athwart, 3, 0)) {
    return std::nullopt;
  }
  return bounding_box(region);
}

Region combine(const Region& a, const Region& b, overlay::Inside inside, const Options& options) {
  std::vector<overlay::Chain> chains;
  overlay::add_rings(a, {1, 0}, chains);
  overlay::add_rings(b, {0, 1}, chains);
  return overlay::select(chains, {inside}, options).region;
}

Region read(const Region& region, int operand, const Options& options) {
  return read_operand(Geometry(region), operand, options).region;
}

}  // namespace

Geometry overlay::unite(std::span<const Geometry> geometries, const Options& options) {
  Cancellation cancellation(options, Stage::kOverlay);
  std::vector<Chain> chains;
  ThinStore thin;
  for (const Geometry& geometry : geometries) {
    // A geometry winds once around each point of its area.
    list_by_role(geometry.region, chains, [](Chain& chain) { chain.weight.first = 1; });
    thin.add(geometry, cancellation);
  }
  thin.list_chains(chains);
  return select(chains, {[](const Winding& w) { return w.first > 0; }}, options);
}
Region overlay::intersect(const Region& a, const Region& b, const Options& options) {
  return combine(
      a, b, [](const Winding& w) { return in_first(w) && in_second(w); }, options);
}
Region overlay::subtract(const Region& a, const Region& b, const Options& options) {
  if (const auto box = as_box(a)) {
    if (auto result = complement_in(*box, b, options)) return std::move(*result);
  }
  return combine(
      a, b, [](const Winding& w) { return in_first(w) && !in_second(w); }, options);
}
bool overlay::contains(const Region& b, const Region& a, const Options& options) {
  return overlay::subtract(a, b, options).empty();
}

Geometry unite(std::span<const Geometry> geometries, const Options& options) {
  std::vector<Geometry> sets;
  for (std::size_t i = 0; i < geometries.size(); ++i) {
    sets.push_back(read_operand(geometries[i], static_cast<int>(i), options));
  }
  return overlay::unite(sets, options);
}
Region unite(const Region& a, const Region& b, const Options& options) {
  return combine(
      read(a, 0, options), read(b, 1, options),
      [](const Winding& w) { return in_first(w) || in_second(w); }, options);
}
Region intersect(const Region& a, const Region& b, const Options& options) {
  return overlay::intersect(read(a, 0, options), read(b, 1, options), options);
}
Region subtract(const Region& a, const Region& b, const Options& options) {
  return overlay::subtract(read(a, 0, options), read(b, 1, options), options);
}
Region symmetric_difference(const Region& a, const Region& b, const Options& options) {
  return combine(
      read(a, 0, options), read(b, 1, options),
      [](const Winding& w) { return in_first(w) != in_second(w); }, options);
}
bool contains(const Region& b, const Region& a, const Options& options) {
  return overlay::contains(read(b, 0, options), read(a, 1, options), options);
}

}  // namespace minksum
