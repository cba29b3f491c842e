// Boolean operations.
#include "minksum/boolean.hpp"

#include "overlay/chains.hpp"

namespace minksum {
namespace {

using overlay::Winding;

// A point of a legal region has an odd number of its rings around it, whatever their directions.
bool in_first(const Winding& w) { return w.first % 2 != 0; }
bool in_second(const Winding& w) { return w.second % 2 != 0; }

Region combine(const Region& a, const Region& b, overlay::Inside inside) {
  std::vector<overlay::Chain> chains;
  for (const bool second : {false, true}) {
    overlay::for_each_ring(second ? b : a, [&](overlay::Chain chain, bool) {
      (second ? chain.weight.second : chain.weight.first) = 1;
      chains.push_back(chain);
    });
  }
  return overlay::select(chains, inside, std::nullopt).region;
}

}  // namespace

Geometry unite(std::span<const Geometry> geometries) {
  // Each winds once around its points: outer rings are counter-clockwise, holes clockwise.
  std::vector<overlay::Chain> chains;
  overlay::ThinStore thin;
  for (const Geometry& geometry : geometries) {
    overlay::for_each_ring(geometry.region, [&](overlay::Chain chain, bool) {
      chain.weight.first = 1;
      chains.push_back(chain);
    });
    thin.add(geometry);
  }
  thin.list_chains(chains);
  return overlay::select(
      chains, [](const Winding& w) { return w.first > 0; }, std::nullopt);
}

Region unite(const Region& a, const Region& b) {
  return combine(a, b, [](const Winding& w) { return in_first(w) || in_second(w); });
}
Region intersect(const Region& a, const Region& b) {
  return combine(a, b, [](const Winding& w) { return in_first(w) && in_second(w); });
}
Region subtract(const Region& a, const Region& b) {
  return combine(a, b, [](const Winding& w) { return in_first(w) && !in_second(w); });
}
Region symmetric_difference(const Region& a, const Region& b) {
  return combine(a, b, [](const Winding& w) { return in_first(w) != in_second(w); });
}

bool contains(const Region& b, const Region& a) { return subtract(a, b).empty(); }

}  // namespace minksum
