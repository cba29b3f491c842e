#include "property/provenance.hpp"

#include <vector>

#include "reference/exact.hpp"

namespace minksum::test {
namespace {

using reference::Number;
using reference::Pt;

// The vertices of an operand by index, with the places of their rings.
struct Flat {
  struct RingSpan {
    std::size_t ring_first = 0;
    std::size_t ring_size = 0;
    bool backwards = false;  // the ring has the interior on the right
  };
  std::vector<Pt> points;
  std::vector<RingSpan> places;
};

Flat flatten(const Region& region) {
  Flat flat;
  for (const auto& loops : reference::to_loops(region)) {
    for (std::size_t r = 0; r < loops.size(); ++r) {
      const bool is_ccw = reference::doubled_area(loops[r]) > 0;
      const Flat::RingSpan place{flat.points.size(), loops[r].size(), is_ccw != (r == 0)};
      flat.places.insert(flat.places.end(), loops[r].size(), place);
      flat.points.insert(flat.points.end(), loops[r].begin(), loops[r].end());
    }
  }
  return flat;
}

// Returns the next vertex of the ring at another point; `step` is 1 or size - 1.
std::size_t different(const Flat& flat, std::size_t from, std::size_t step) {
  const Flat::RingSpan& place = flat.places[from];
  std::size_t at = from;
  do {
    at = place.ring_first + (at - place.ring_first + step) % place.ring_size;
  } while (flat.points[at] == flat.points[from]);
  return at;
}

// Finds the ends of the straight run that begins with the edge at `first`, with the interior on the
// left.
bool straight_run(const Flat& flat, std::size_t first, Pt& from, Pt& to) {
  const std::size_t back = flat.places[first].ring_size - 1;
  const std::size_t before = different(flat, first, back);
  std::size_t last = different(flat, first, 1);
  if (reference::turn(flat.points[before], flat.points[first], flat.points[last]) == 0)
    return false;
  for (;;) {
    const std::size_t next = different(flat, last, 1);
    if (reference::turn(flat.points[first], flat.points[last], flat.points[next]) != 0) break;
    last = next;
  }
  from = flat.points[first];
  to = flat.points[last];
  if (flat.places[first].backwards) std::swap(from, to);
  return true;
}

std::string edge_fault(const Flat& edges, const Flat& vertices, const EdgeOrigin& origin,
                       const Pt& a, const Pt& b) {
  if (origin.edge >= edges.points.size() || origin.vertex >= vertices.points.size()) {
    return "names a vertex that is not there";
  }
  Pt from;
  Pt to;
  if (!straight_run(edges, origin.edge, from, to)) {
    return "names an edge that is not the first of its straight run";
  }
  const Pt& by = vertices.points[origin.vertex];
  for (Pt* end : {&from, &to}) *end = {Number(end->x + by.x), Number(end->y + by.y)};
  if (reference::cross_sign(a, b, from, to) != 0) return "names an edge that is not parallel";
  const Number dot = (b.x - a.x) * (to.x - from.x) + (b.y - a.y) * (to.y - from.y);
  if (dot < 0) return "names an edge of the opposite direction";
  if (!reference::on_segment(a, from, to) || a == to) return "does not begin on the named edge";
  return {};
}

}  // namespace

std::string provenance_fault(const Region& p, const Region& q, const Region& sum) {
  if (sum.empty()) return {};
  if (!sum.has_origins()) return "no origins";
  const Flat flat_p = flatten(p);
  const Flat flat_q = flatten(q);
  for (std::size_t ring = 0; ring < sum.ring_count(); ++ring) {
    const IndexRange range = sum.vertices_of(ring);
    for (const std::size_t v : range) {
      const std::size_t next = v + 1 == range.front() + range.size() ? range.front() : v + 1;
      const EdgeOrigin& origin = sum.origin(v);
      const bool of_first = origin.edge_operand == Operand::kFirst;
      const std::string fault =
          edge_fault(of_first ? flat_p : flat_q, of_first ? flat_q : flat_p, origin,
                     reference::to_pt(sum.point(v)), reference::to_pt(sum.point(next)));
      if (!fault.empty()) {
        return "the edge at vertex " + std::to_string(v) + ' ' + fault + " (edge " +
               std::to_string(origin.edge) + " of the " + (of_first ? "first" : "second") +
               ", vertex " + std::to_string(origin.vertex) + ')';
      }
    }
  }
  return {};
}

}  // namespace minksum::test
