#include "reference/canonical.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>

namespace minksum::reference {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

// Returns the successor of every piece: the first piece clockwise from the way back, because the
// interior lies clockwise of the way back.
std::vector<std::size_t> successors(const std::vector<Pt>& nodes,
                                    const std::vector<Piece>& pieces) {
  std::vector<std::vector<std::size_t>> leaving(nodes.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) leaving[pieces[i].from].push_back(i);
  std::vector<std::size_t> next(pieces.size(), kNone);
  std::vector<bool> taken(pieces.size(), false);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Piece& piece = pieces[i];
    for (const std::size_t candidate : leaving[piece.to]) {
      if (next[i] == kNone ||
          clockwise_before(nodes[piece.to], nodes[piece.from], nodes[pieces[candidate].to],
                           nodes[pieces[next[i]].to])) {
        next[i] = candidate;
      }
    }
    if (next[i] == kNone || taken[next[i]]) throw std::logic_error("pieces do not close");
    taken[next[i]] = true;
  }
  return next;
}

using IdRing = std::vector<std::size_t>;

// Cuts a closed walk at the nodes that it visits more than once.
void part(const IdRing& walk, std::vector<std::size_t>& place, std::vector<IdRing>& rings) {
  IdRing stack;
  for (const std::size_t node : walk) {
    if (place[node] != kNone) {
      const auto first = stack.begin() + static_cast<std::ptrdiff_t>(place[node]);
      rings.emplace_back(first, stack.end());
      for (const std::size_t popped : rings.back()) place[popped] = kNone;
      stack.erase(first, stack.end());
    }
    place[node] = stack.size();
    stack.push_back(node);
  }
  for (const std::size_t popped : stack) place[popped] = kNone;
  if (!stack.empty()) rings.push_back(std::move(stack));
}

std::vector<IdRing> trace(const std::vector<Pt>& nodes, const std::vector<Piece>& pieces) {
  const std::vector<std::size_t> next = successors(nodes, pieces);
  std::vector<bool> done(pieces.size(), false);
  std::vector<std::size_t> place(nodes.size(), kNone);
  std::vector<IdRing> rings;
  for (std::size_t start = 0; start < pieces.size(); ++start) {
    IdRing walk;
    for (std::size_t i = start; !done[i]; i = next[i]) {
      done[i] = true;
      walk.push_back(pieces[i].from);
    }
    part(walk, place, rings);
  }
  return rings;
}

// Drops straight vertices and starts at the lexicographically smallest one.
Loop tidy(const Loop& loop) {
  Loop result;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Pt& before = loop[(i + loop.size() - 1) % loop.size()];
    const Pt& after = loop[(i + 1) % loop.size()];
    if (turn(before, loop[i], after) != 0) result.push_back(loop[i]);
  }
  if (result.size() < 3) throw std::logic_error("a ring without area");
  std::rotate(result.begin(), std::min_element(result.begin(), result.end()), result.end());
  return result;
}

bool ring_before(const Loop& a, const Loop& b) { return a[0] == b[0] ? a[1] < b[1] : a[0] < b[0]; }

struct Outer {
  Loop raw;
  Number area;
  Loops polygon;
};

// Returns the smallest outer ring around a hole. The midpoint of a piece touches no other ring.
Outer& owner(std::vector<Outer>& outers, const Loop& hole) {
  if (outers.size() == 1) return outers.front();
  const Pt inner = midpoint(hole[0], hole[1]);
  Outer* best = nullptr;
  for (Outer& outer : outers) {
    if (best != nullptr && best->area <= outer.area) continue;
    if (locate(inner, outer.raw) == Side::kInside) best = &outer;
  }
  if (best == nullptr) throw std::logic_error("a hole outside every outer ring");
  return *best;
}

// Returns the points of `sorted` that lie inside the edge ab, in the order from a to b.
std::vector<Pt> points_inside(const Pt& a, const Pt& b, const std::vector<Pt>& sorted) {
  const Pt& low = std::min(a, b);
  const Pt& high = std::max(a, b);
  const Number min_y = std::min(a.y, b.y);
  const Number max_y = std::max(a.y, b.y);
  std::vector<Pt> found;
  for (auto it = std::upper_bound(sorted.begin(), sorted.end(), low);
       it != sorted.end() && *it < high; ++it) {
    if (it->y < min_y || max_y < it->y) continue;
    if (turn(a, b, *it) == 0) found.push_back(*it);
  }
  if (b < a) std::reverse(found.begin(), found.end());
  return found;
}

}  // namespace

Loop without_repeats(const Loop& loop) {
  Loop result;
  for (const Pt& p : loop) {
    if (result.empty() || !(result.back() == p)) result.push_back(p);
  }
  while (result.size() > 1 && result.back() == result.front()) result.pop_back();
  return result;
}

Region link(const std::vector<Pt>& nodes, const std::vector<Piece>& pieces) {
  std::vector<Outer> outers;
  Loops holes;
  for (const IdRing& ids : trace(nodes, pieces)) {
    Loop raw;
    for (const std::size_t id : ids) raw.push_back(nodes[id]);
    const Number area = doubled_area(raw);
    if (area > 0) {
      Loop outer = tidy(raw);
      outers.push_back({std::move(raw), area, {std::move(outer)}});
    } else {
      holes.push_back(std::move(raw));
    }
  }
  if (outers.empty() && !holes.empty()) throw std::logic_error("holes without an outer ring");
  for (const Loop& hole : holes) owner(outers, hole).polygon.push_back(tidy(hole));
  std::vector<Loops> polygons;
  for (Outer& outer : outers) {
    std::sort(outer.polygon.begin() + 1, outer.polygon.end(), ring_before);
    polygons.push_back(std::move(outer.polygon));
  }
  std::sort(polygons.begin(), polygons.end(),
            [](const Loops& a, const Loops& b) { return ring_before(a[0], b[0]); });
  return to_region(polygons);
}

Region link_rings(const Loops& rings) {
  std::map<Pt, std::size_t> ids;
  std::vector<Pt> nodes;
  const auto id_of = [&](const Pt& p) {
    const auto [it, is_new] = ids.try_emplace(p, nodes.size());
    if (is_new) nodes.push_back(p);
    return it->second;
  };
  std::vector<Piece> pieces;
  for (const Loop& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      pieces.push_back({id_of(ring[i]), id_of(ring[(i + 1) % ring.size()])});
    }
  }
  return link(nodes, pieces);
}

Loops directed_and_noded(const std::vector<Loops>& polygons) {
  std::vector<Pt> vertices;
  for (const Loops& loops : polygons) {
    for (const Loop& loop : loops) vertices.insert(vertices.end(), loop.begin(), loop.end());
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  Loops result;
  for (const Loops& loops : polygons) {
    for (std::size_t r = 0; r < loops.size(); ++r) {
      Loop clean = without_repeats(loops[r]);
      if ((doubled_area(clean) > 0) != (r == 0)) std::reverse(clean.begin(), clean.end());
      Loop noded;
      for (std::size_t i = 0; i < clean.size(); ++i) {
        noded.push_back(clean[i]);
        const std::vector<Pt> inside =
            points_inside(clean[i], clean[(i + 1) % clean.size()], vertices);
        noded.insert(noded.end(), inside.begin(), inside.end());
      }
      result.push_back(std::move(noded));
    }
  }
  return result;
}

Region canonical(const Region& region) { return link_rings(directed_and_noded(to_loops(region))); }

}  // namespace minksum::reference
