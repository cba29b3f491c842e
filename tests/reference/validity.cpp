#include "reference/validity.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <vector>

#include "reference/canonical.hpp"
#include "reference/exact.hpp"

namespace minksum::reference {
namespace {

struct RingEdge {
  Pt a;
  Pt b;
  std::size_t ring;   // number of the ring among those of all polygons
  std::size_t index;  // number of the edge in its ring
  Number min_x, max_x, min_y, max_y;
};

std::vector<RingEdge> edges_of(const Loops& rings) {
  std::vector<RingEdge> edges;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const Loop& ring = rings[r];
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Pt& a = ring[i];
      const Pt& b = ring[(i + 1) % ring.size()];
      edges.push_back({a, b, r, i, std::min(a.x, b.x), std::max(a.x, b.x), std::min(a.y, b.y),
                       std::max(a.y, b.y)});
    }
  }
  std::sort(edges.begin(), edges.end(),
            [](const RingEdge& e, const RingEdge& f) { return e.min_x < f.min_x; });
  return edges;
}

bool neighbours(const RingEdge& e, const RingEdge& f, std::size_t count) {
  return e.ring == f.ring && ((e.index + 1) % count == f.index || (f.index + 1) % count == e.index);
}

// Returns whether neighbours share more than one end, which makes a spike.
bool neighbours_overlap(const RingEdge& e, const RingEdge& f) {
  const Pt& shared = e.b == f.a ? e.b : e.a;
  const Pt& before = e.b == f.a ? e.a : f.a;
  const Pt& after = e.b == f.a ? f.b : e.b;
  return turn(before, shared, after) == 0 &&
         (on_segment(before, shared, after) || on_segment(after, shared, before));
}

// Returns whether two edges are collinear and share more than a point.
bool overlap(const RingEdge& e, const RingEdge& f) {
  if (turn(e.a, e.b, f.a) != 0 || turn(e.a, e.b, f.b) != 0) return false;
  const Pt low = std::max(std::min(e.a, e.b), std::min(f.a, f.b));
  const Pt high = std::min(std::max(e.a, e.b), std::max(f.a, f.b));
  return low < high;
}

std::string pair_fault(const RingEdge& e, const RingEdge& f, const Loops& rings) {
  const std::string where = " (ring " + std::to_string(e.ring) + " edge " +
                            std::to_string(e.index) + ", ring " + std::to_string(f.ring) +
                            " edge " + std::to_string(f.index) + ")";
  if (neighbours(e, f, rings[e.ring].size())) {
    return neighbours_overlap(e, f) ? "a spike" + where : std::string{};
  }
  if (e.ring == f.ring) {
    return segments_meet(e.a, e.b, f.a, f.b) ? "a ring meets itself" + where : std::string{};
  }
  if (cross_properly(e.a, e.b, f.a, f.b)) return "two rings cross" + where;
  return overlap(e, f) ? "two rings share a piece" + where : std::string{};
}

std::string edges_fault(const Loops& rings) {
  const std::vector<RingEdge> edges = edges_of(rings);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size() && edges[j].min_x <= edges[i].max_x; ++j) {
      if (edges[j].max_y < edges[i].min_y || edges[i].max_y < edges[j].min_y) continue;
      std::string fault = pair_fault(edges[i], edges[j], rings);
      if (!fault.empty()) return fault;
    }
  }
  return {};
}

// Returns the side of `other` on which the noded ring lies; nothing if it lies on both sides.
std::optional<Side> side_of(const Loop& noded, const Loop& other) {
  std::optional<Side> side;
  for (std::size_t i = 0; i < noded.size(); ++i) {
    const Side here = locate(midpoint(noded[i], noded[(i + 1) % noded.size()]), other);
    if (here == Side::kBoundary || (side && *side != here)) return std::nullopt;
    side = here;
  }
  return side;
}

using Sides = std::vector<std::vector<Side>>;

std::string crossing_fault(const Loops& noded, Sides& sides) {
  sides.assign(noded.size(), std::vector<Side>(noded.size(), Side::kOutside));
  for (std::size_t r = 0; r < noded.size(); ++r) {
    for (std::size_t s = 0; s < noded.size(); ++s) {
      if (r == s) continue;
      const std::optional<Side> side = side_of(noded[r], noded[s]);
      if (!side) return "rings " + std::to_string(r) + " and " + std::to_string(s) + " cross";
      sides[r][s] = *side;
    }
  }
  return {};
}

std::string nesting_fault(const std::vector<Loops>& polygons, const Sides& sides) {
  std::vector<std::size_t> first;
  std::size_t count = 0;
  for (const Loops& loops : polygons) {
    first.push_back(count);
    count += loops.size();
  }
  const auto inside = [&](std::size_t r, std::size_t s) { return sides[r][s] == Side::kInside; };
  for (std::size_t p = 0; p < polygons.size(); ++p) {
    const std::size_t outer = first[p];
    const std::size_t end = outer + polygons[p].size();
    for (std::size_t h = outer + 1; h < end; ++h) {
      if (!inside(h, outer)) return "a hole outside its outer ring";
      for (std::size_t g = outer + 1; g < end; ++g) {
        if (g != h && inside(h, g)) return "a hole inside a hole";
      }
    }
    for (std::size_t other = 0; other < polygons.size(); ++other) {
      if (other == p || !inside(first[other], outer)) continue;
      bool in_a_hole = false;
      for (std::size_t h = outer + 1; h < end; ++h) in_a_hole |= inside(first[other], h);
      if (!in_a_hole) return "polygons overlap";
    }
  }
  return {};
}

}  // namespace

std::string validity_fault(const Region& region) {
  std::vector<Loops> polygons = to_loops(region);
  Loops rings;
  for (Loops& loops : polygons) {
    if (loops.empty()) return "a polygon without rings";
    for (Loop& loop : loops) {
      loop = without_repeats(loop);
      if (loop.size() < 3) return "a ring of fewer than three points";
      rings.push_back(loop);
    }
  }
  std::string fault = edges_fault(rings);
  if (!fault.empty()) return fault;
  Sides sides;
  fault = crossing_fault(directed_and_noded(polygons), sides);
  return fault.empty() ? nesting_fault(polygons, sides) : fault;
}

std::string canonical_fault(const Region& region) {
  std::string fault = validity_fault(region);
  if (!fault.empty()) return fault;
  try {
    if (!(canonical(region) == region)) return "valid, but not in canonical form";
  } catch (const std::logic_error& error) {
    return std::string("the boundary does not link up: ") + error.what();
  }
  return {};
}

}  // namespace minksum::reference
