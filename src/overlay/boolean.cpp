// Implements the boolean operations.
#include "overlay/boolean.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "minksum/boolean.hpp"
#include "overlay/chains.hpp"
#include "overlay/complement.hpp"
#include "overlay/resolve_area.hpp"
#include "region/region_access.hpp"
#include "spatial/box.hpp"

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

/// How many regions are united at once where many overlap. Of 4, 8, 16 and 32, on triangles, stars,
/// squares and discs, 8 and 16 took least, and 4 too few to tell whether crossings vanish.
constexpr std::size_t kGroup = 16;

using Regions = std::vector<const Region*>;
Regions pointers_to(const std::vector<Region>& regions) {
  Regions pointers;
  for (const Region& region : regions) pointers.push_back(&region);
  return pointers;
}
std::size_t vertices_of(const Regions& regions) {
  std::size_t count = 0;
  for (const Region* const region : regions) count += region->vertex_count();
  return count;
}

constexpr overlay::Rule kInAny{[](const Winding& w) { return w.first > 0; }};

/// Lists the rings of regions, each of which winds once around the points of its area.
std::vector<overlay::Chain> chains_of(std::span<const Region* const> regions) {
  std::vector<overlay::Chain> chains;
  for (const Region* const region : regions) {
    overlay::list_by_role(*region, chains, [](overlay::Chain& chain) { chain.weight.first = 1; });
  }
  return chains;
}

/// Brings regions into an order in which each kGroup in succession begin near each other.
void order_by_place(std::span<const Region*> regions, Cancellation& cancellation) {
  if (regions.size() <= kGroup) return;
  cancellation.check(8 * regions.size());
  BoxOf<double> box{HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  for (const Region* const region : regions) {
    const double x = region->x(0);
    const double y = region->y(0);
    box.add({x, y, x, y});
  }
  const auto by = [](auto coordinate) {
    return
        [=](const Region* a, const Region* b) { return (a->*coordinate)(0) < (b->*coordinate)(0); };
  };
  const std::size_t middle = (regions.size() / kGroup + 1) / 2 * kGroup;
  const auto at = regions.begin() + static_cast<std::ptrdiff_t>(middle);
  if (box.longer() == Axis::kX) {
    std::nth_element(regions.begin(), at, regions.end(), by(&Region::x));
  } else {
    std::nth_element(regions.begin(), at, regions.end(), by(&Region::y));
  }
  order_by_place(regions.first(middle), cancellation);
  order_by_place(regions.subspan(middle), cancellation);
}

/// Unites each kGroup regions in succession. Adds how many pairs of edges cross to `crossings`.
std::vector<Region> unite_groups(std::span<const Region* const> regions, const Options& options,
                                 std::uint64_t& crossings) {
  std::vector<Region> united;
  for (std::size_t i = 0; i < regions.size(); i += kGroup) {
    const auto group = regions.subspan(i, std::min(kGroup, regions.size() - i));
    std::uint64_t found = 0;
    united.push_back(overlay::select(chains_of(group), kInAny, options, &found).region);
    crossings += found;
  }
  return united;
}

Region read(const Region& region, int operand, const Options& options) {
  return read_operand(Geometry(region), operand, options).region;
}

}  // namespace

Geometry overlay::unite(std::span<const Geometry> geometries, const Options& options) {
  Cancellation cancellation(options, Stage::kOverlay);
  Regions regions;
  ThinStore thin;
  for (const Geometry& geometry : geometries) {
    if (!geometry.region.empty()) regions.push_back(&geometry.region);
    thin.add(geometry, cancellation);
  }
  std::vector<Region> united;
  bool in_groups = regions.size() > kGroup;
  for (;;) {
    std::vector<Chain> chains = chains_of(regions);
    thin.list_chains(chains);
    if (!in_groups) return select(chains, kInAny, options);
    if (auto result = select_if_few_cross(chains, kInAny, options)) return std::move(*result);
    // Vertices and crossings within other regions vanish in groups before they are many. Others
    // would be found again in each round, so groups that keep most of them are not used.
    order_by_place(regions, cancellation);
    std::uint64_t found = vertices_of(regions);
    std::vector<Region> next = unite_groups(regions, options, found);
    const bool pays = vertices_of(pointers_to(next)) < found / 2;
    if (pays) {
      united = std::move(next);
      regions = pointers_to(united);
    }
    in_groups = pays && regions.size() > kGroup;
  }
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
