// Writes slits and nodes as polylines and points with exact coordinates.
#include "minksum/resolve.hpp"
#include "region/rational_access.hpp"
#include "sum/tight/tight.hpp"

namespace minksum {

void write_tight_places(const Operands& operands, const Arrangement& arrangement,
                        const TightPlaces& places, Cancellation& cancellation, Geometry& geometry) {
  const ExactKernel& kernel = *operands.kernel;
  Vec<ExactCoordinate> at;
  const auto value = [&](const ExactCoordinate& c) {
    return RationalAccess::make(BigInteger(c.numerator, c.negative), BigInteger(c.denominator),
                                kernel.exp2(), kernel.exp10());
  };
  const auto point = [&](const NodePoint& node) {
    cancellation.check(4 * kernel.work());
    kernel.coordinates(node, at);
    return Point{value(at.x), value(at.y)};
  };
  const auto point_of = [&](NodeId node) { return point(arrangement.nodes[node].point); };
  geometry = {};
  for (const std::uint32_t i : places.slits) {
    const Piece& slit = arrangement.slits[i];
    geometry.polylines.push_back({point_of(slit.from), point_of(slit.to)});
  }
  for (const NodeId node : places.nodes) geometry.points.push_back(point_of(node));
  for (const SumVertex& v : places.pinches) geometry.points.push_back(point({false, {}, {}, v}));
  if (geometry.has_thin_parts()) geometry = resolve(geometry, part_of(cancellation.options()));
}

}  // namespace minksum
