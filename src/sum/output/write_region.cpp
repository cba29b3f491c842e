// Writes the boundary's nodes as exact coordinates.
#include <algorithm>

#include "machine/make_room.hpp"
#include "region/region_access.hpp"
#include "sum/output/output.hpp"

namespace minksum {
namespace {

class CoordinateWriter {
 public:
  CoordinateWriter(const ExactKernel& kernel, Vec<ExactCoordinate>& scratch, Region& region)
      : kernel_(kernel),
        exp2_(static_cast<std::int16_t>(kernel.exp2())),
        exp10_(static_cast<std::int16_t>(kernel.exp10())),
        scratch_(scratch),
        region_(region) {}

  /// Stores coordinates as compact numbers if they are integers of 63 bits on the operands' grid,
  /// else as limbs.
  Vec<StoredCoordinate> store(const NodePoint& point) {
    Vec<std::int64_t> at{};
    if (!point.is_crossing && kernel_.integer_coordinates(point.vertex, at)) {
      return {compact(at.x), compact(at.y)};
    }
    kernel_.coordinates(point, scratch_);
    return {store(scratch_.x), store(scratch_.y)};
  }

 private:
  [[nodiscard]] StoredCoordinate compact(std::int64_t value) const {
    return value == 0 ? StoredCoordinate{} : StoredCoordinate{value, exp2_, exp10_, 0, 0};
  }
  StoredCoordinate store(const ExactCoordinate& c) {
    if (c.numerator.empty()) return StoredCoordinate{};
    const bool integer = c.denominator.size() == 1 && c.denominator[0] == 1;
    if (integer && c.numerator.size() == 1 && (c.numerator[0] >> 63) == 0) {
      const auto magnitude = static_cast<std::int64_t>(c.numerator[0]);
      return compact(c.negative ? -magnitude : magnitude);
    }
    if (c.numerator.size() > kLimbCountMask || c.denominator.size() > kLimbCountMask) {
      throw Error(ErrorCode::kLimitExceeded,
                  "a coordinate of the result needs more than 2^21 bits");
    }
    const std::size_t place = RegionAccess::limbs(region_).size();
    StoredCoordinate stored{static_cast<std::int64_t>(place), exp2_, exp10_,
                            static_cast<std::uint16_t>(c.numerator.size()),
                            static_cast<std::uint16_t>(c.denominator.size())};
    if (c.negative) stored.numerator_limbs |= kNegativeLimbs;
    RegionAccess::append_limbs(region_, c.numerator);
    RegionAccess::append_limbs(region_, c.denominator);
    return stored;
  }

  const ExactKernel& kernel_;
  std::int16_t exp2_;
  std::int16_t exp10_;
  Vec<ExactCoordinate>& scratch_;
  Region& region_;
};

EdgeOrigin origin_of(const Operands& o, const Segment& segment) {
  EdgeOrigin origin;
  origin.edge_operand = o.operand_of(segment.edge) == 0 ? Operand::kFirst : Operand::kSecond;
  origin.edge = o.edge_source[segment.edge];
  origin.vertex = o.vertex_source[segment.vertex];
  return origin;
}

/// Stays out of line, because the loop that counts would take registers from this one.
[[gnu::noinline]] void write_vertices(const Operands& operands, const Arrangement& arrangement,
                                      std::span<const BoundaryVertex> vertices,
                                      CoordinateWriter& writer, Region& region) {
  for (const BoundaryVertex& v : vertices) {
    const Vec<StoredCoordinate> at = writer.store(arrangement.nodes[v.node].point);
    const Segment& made_by = arrangement.kept[arrangement.pieces[v.piece].segment].segment;
    RegionAccess::add_vertex(region, at.x, at.y, origin_of(operands, made_by));
  }
}

/// Returns how many limbs the coordinates may take. A crossing lies at (p·t + d·s) / t on its
/// segment, where t is a cross product of directions: 2B + 3 bits for coordinates of B bits, and so
/// 3B + 5 above. Other nodes take limbs if they are longer than 63 bits.
std::size_t limbs_of_nodes(const Operands& operands, const Arrangement& arrangement,
                           const Boundary& boundary, Cancellation& cancellation) {
  if (operands.kernel->rung() == Arithmetic::kArbitrary) return 0;
  const auto limbs = [](std::size_t bits) { return (bits + 63) / 64; };
  const std::size_t bits = operands.bits;
  const std::size_t of_crossing = 2 * (limbs(2 * bits + 3) + limbs(3 * bits + 5));
  const std::size_t of_vertex = bits > 63 ? 2 * (limbs(bits + 1) + 1) : 0;
  std::size_t count = 0;
  visit_in_pieces(boundary.vertices, cancellation, [&](const BoundaryVertex& v) {
    count += arrangement.nodes[v.node].point.is_crossing ? of_crossing : of_vertex;
  });
  return count;
}

}  // namespace

void write_region(const Operands& operands, const Arrangement& arrangement,
                  const Boundary& boundary, Cancellation& cancellation, OutputScratch& scratch,
                  Region& region) {
  CoordinateWriter writer(*operands.kernel, scratch.coordinates, region);
  region.clear();
  const std::size_t vertices = boundary.vertices.size();
  const std::size_t rings = boundary.ring_order.size();
  RegionAccess::reserve(region, {vertices, vertices, rings, rings,
                                 limbs_of_nodes(operands, arrangement, boundary, cancellation)});
  // It counts as many vertices at a time as it writes between two looks.
  const std::uint64_t work = 4 * operands.kernel->work();
  const auto units = static_cast<std::uint64_t>(Cancellation::kUnits);
  const auto step = static_cast<std::uint32_t>(std::max<std::uint64_t>(units / work, 1));
  for (std::uint32_t i = 0; i < boundary.ring_order.size(); ++i) {
    const BoundaryRing& ring = boundary.rings[boundary.ring_order[i]];
    if (ring.positive) region.begin_polygon();
    region.begin_ring();
    for (std::uint32_t begin = ring.begin, end = begin; begin < ring.end; begin = end) {
      end = begin + std::min(step, ring.end - begin);
      cancellation.check(work * (end - begin));
      write_vertices(operands, arrangement, {boundary.vertices.data() + begin, end - begin}, writer,
                     region);
    }
  }
}

std::optional<std::string> check(const Boundary& b, const Arrangement& arrangement,
                                 const Operands& operands) {
  Cancellation never;
  Predicates predicates(operands.sites, *operands.kernel, operands.bounds, never);
  const NodeOrder order(arrangement, predicates);
  if (b.ring_order.size() != b.rings.size()) return "a ring is in no polygon";
  for (const BoundaryRing& ring : b.rings) {
    if (ring.end < ring.begin + 3) return "a ring has fewer than three vertices";
    std::vector<NodeId> nodes;
    for (std::uint32_t i = ring.begin; i < ring.end; ++i) {
      const BoundaryVertex& v = b.vertices[i];
      const BoundaryVertex& w = b.vertices[i + 1 == ring.end ? ring.begin : i + 1];
      const auto direction = [&](const BoundaryVertex& at) {
        return arrangement.kept[arrangement.pieces[at.piece].segment].segment;
      };
      if (order.orientation(direction(v), w.node) != kZero) return "an edge leaves its line";
      if (operands.rank[direction(v).edge] == operands.rank[direction(w).edge]) {
        return "a vertex lies in the middle of a straight edge";
      }
      if (order.compare(v.node, b.vertices[ring.begin].node) == kNegative) {
        return "a ring does not start at its smallest vertex";
      }
      nodes.push_back(v.node);
    }
    std::sort(nodes.begin(), nodes.end());
    if (std::adjacent_find(nodes.begin(), nodes.end()) != nodes.end()) {
      return "a ring visits a node twice";
    }
    const Segment first =
        arrangement.kept[arrangement.pieces[b.vertices[ring.begin].piece].segment].segment;
    const Segment last =
        arrangement.kept[arrangement.pieces[b.vertices[ring.end - 1].piece].segment].segment;
    const Sign turn = operands.kernel->cross(last.edge, first.edge);
    if ((turn == kPositive) != ring.positive) return "a ring's orientation is wrong";
  }
  for (std::size_t p = 0; p + 1 < b.polygon_begin.size(); ++p) {
    for (std::uint32_t i = b.polygon_begin[p]; i < b.polygon_begin[p + 1]; ++i) {
      const bool outer = i == b.polygon_begin[p];
      if (b.rings[b.ring_order[i]].positive != outer) return "a polygon has no outer ring first";
    }
  }
  return std::nullopt;
}

}  // namespace minksum
