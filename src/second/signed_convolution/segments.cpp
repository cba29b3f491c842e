#include "second/signed_convolution/segments.hpp"

#include <algorithm>
#include <optional>

#include "exact/wide_int.hpp"
#include "machine/exceeded.hpp"
#include "machine/make_room.hpp"
#include "region/point_arithmetic.hpp"
#include "region/region_access.hpp"

namespace minksum::signed_sum {
namespace {

// A closed set fits into an open one only if it is strictly narrower and strictly lower.
bool may_fit(const DirectedRing& set, const DirectedRing& hole) {
  return set.extent.x < hole.extent.x && set.extent.y < hole.extent.y;
}

void limit(std::uint64_t segments, std::uint64_t most) {
  if (segments <= most) return;
  throw exceeded("Limits::max_segments", most, "the convolution has", "segments");
}

// A range of ranks from `first` to `last`, both included, going counter-clockwise.
struct Range {
  DirectionRank first;
  DirectionRank last;
};

// These ranges tell which edges a vertex takes. Think of all edges of Q as turned counter-clockwise
// by an infinitesimal angle. Then no edge of P is parallel to one of Q. The convolution is the
// generic one, so it is closed. Off the segments, the winding numbers are those of the unturned
// operands. A direction of P between those of Q's edges `a` and `b` is then after a and not after
// b: (a, b]. A direction of Q between those of P's edges is not before a and before b: [a, b).
Range edges_of_p_between(DirectionRank a, DirectionRank b, DirectionRank count) {
  return {a + 1 == count ? 0 : a + 1, b};
}
Range edges_of_q_between(DirectionRank a, DirectionRank b, DirectionRank count) {
  return {a, b == 0 ? count - 1 : b - 1};
}

/// The directions of the tangent at a vertex, less than a half turn. At a left turn, the directions
/// go from the incoming edge to the outgoing one; at a right turn, the other way.
Range sector(const DirectedRing& ring, std::size_t vertex) {
  const DirectionRank in = ring.ranks[ring.previous(vertex)];
  const DirectionRank out = ring.ranks[vertex];
  return ring.convex[vertex] ? Range{in, out} : Range{out, in};
}

template <class Visit>
void for_run(const DirectedRing& ring, DirectionRank first, DirectionRank last, Visit visit) {
  auto edge =
      std::lower_bound(ring.by_direction.begin(), ring.by_direction.end(), first,
                       [&](std::uint32_t e, DirectionRank rank) { return ring.ranks[e] < rank; });
  for (; edge != ring.by_direction.end() && ring.ranks[*edge] <= last; ++edge) visit(*edge);
}
template <class Visit>
void for_edges(const DirectedRing& ring, Range range, DirectionRank count, Visit visit) {
  if (range.first <= range.last) return for_run(ring, range.first, range.last, visit);
  for_run(ring, range.first, count - 1, visit);
  for_run(ring, 0, range.last, visit);
}

/// Returns the sum of two short numbers, or nothing if it is not as short.
std::optional<StoredCoordinate> short_sum(const StoredCoordinate& a, const StoredCoordinate& b) {
  if (a.denominator_limbs != 0 || b.denominator_limbs != 0) return std::nullopt;
  if (a.payload == 0) return b;
  if (b.payload == 0) return a;
  StoredCoordinate sum;
  sum.exp2 = std::min(a.exp2, b.exp2);
  sum.exp10 = std::min(a.exp10, b.exp10);
  Int128 whole = 0;
  for (const StoredCoordinate* c : {&a, &b}) {
    const int twos = c->exp2 - sum.exp2;
    const int tens = c->exp10 - sum.exp10;
    if (twos + bits_of_ten_to(tens) > 62) return std::nullopt;
    whole += scaled(Int128{c->payload}, twos, tens);
  }
  sum.payload = static_cast<std::int64_t>(whole);
  if (sum.payload != whole) return std::nullopt;
  return sum;
}

}  // namespace

std::vector<SignedSegment> signed_segments(const DirectedRing& p, const DirectedRing& q,
                                           DirectionRank count, std::uint64_t most,
                                           Cancellation& cancellation) {
  std::vector<SignedSegment> segments;
  const auto add = [&](const VertexSum& from, const VertexSum& to, bool along) {
    limit(segments.size() + 1, most);
    cancellation.check();
    append(segments, along ? SignedSegment{from, to} : SignedSegment{to, from}, cancellation);
  };
  for (std::uint32_t j = 0; j < q.size(); ++j) {
    cancellation.check(4);
    const auto [a, b] = sector(q, j);
    for_edges(p, edges_of_p_between(a, b, count), count, [&](std::uint32_t edge) {
      add({edge, j}, {static_cast<std::uint32_t>(p.next(edge)), j}, q.convex[j]);
    });
  }
  for (std::uint32_t i = 0; i < p.size(); ++i) {
    cancellation.check(4);
    const auto [a, b] = sector(p, i);
    for_edges(q, edges_of_q_between(a, b, count), count, [&](std::uint32_t edge) {
      add({i, edge}, {i, static_cast<std::uint32_t>(q.next(edge))}, p.convex[i]);
    });
  }
  return segments;
}

void link_segments(const DirectedRing& p, const DirectedRing& q,
                   std::vector<SignedSegment> segments, Cancellation& cancellation,
                   Region& chains) {
  const auto add_vertex = [&](const VertexSum& at) {
    const std::size_t v = p.vertices[at.p];
    const std::size_t w = q.vertices[at.q];
    cancellation.check(2);
    const auto x = short_sum(RegionAccess::x(*p.region, v), RegionAccess::x(*q.region, w));
    const auto y = short_sum(RegionAccess::y(*p.region, v), RegionAccess::y(*q.region, w));
    if (x && y) return RegionAccess::add_vertex(chains, *x, *y);
    const Point sum = plus(p.region->point(v), q.region->point(w));
    cancellation.check(work_of(sum));
    chains.add_vertex(sum.x, sum.y);
  };
  const auto starts_before = [](const SignedSegment& segment, const VertexSum& at) {
    return segment.from < at;
  };
  std::sort(segments.begin(), segments.end(),
            cancellation.counting([](const SignedSegment& a, const SignedSegment& b) {
              return a.from != b.from ? a.from < b.from : a.to < b.to;
            }));
  // By the first segment that starts at a sum of vertices: how many such segments are taken.
  std::vector<std::uint32_t> taken;
  assign_in_pieces(taken, segments.size(), 0U, cancellation);
  // Takes a segment that starts there, if one is left.
  const auto take = [&](const VertexSum& at) -> const SignedSegment* {
    const auto first = std::lower_bound(segments.begin(), segments.end(), at, starts_before);
    if (first == segments.end()) return nullptr;
    const auto place = static_cast<std::size_t>(first - segments.begin());
    const std::size_t next = place + taken[place];
    if (next == segments.size() || segments[next].from != at) return nullptr;
    ++taken[place];
    return &segments[next];
  };
  for (std::size_t i = 0; i < segments.size(); ++i) {
    cancellation.check(4);
    const VertexSum start = segments[i].from;
    const SignedSegment* segment = take(start);
    if (segment == nullptr) continue;  // all that start there are taken
    chains.begin_ring();
    add_vertex(start);
    while (segment->to != start) {
      cancellation.check(4);
      add_vertex(segment->to);
      segment = take(segment->to);
      if (segment == nullptr) broken("the signed convolution is not closed");
    }
  }
}

Region signed_convolutions(const DirectedOperands& operands, std::uint64_t most,
                           Cancellation& cancellation) {
  // Lists the rings of a part that count beside another part.
  const auto rings_beside = [&](const Part& part, const Part& other) {
    std::vector<const DirectedRing*> rings;
    for (const DirectedRing& ring : part) {
      cancellation.check();
      if (&ring == &part.front() || may_fit(other.front(), ring)) rings.push_back(&ring);
    }
    return rings;
  };
  Region chains;
  chains.begin_polygon();
  for (const Part& a : operands.p) {
    for (const Part& b : operands.q) {
      for (const DirectedRing* const p : rings_beside(a, b)) {
        for (const DirectedRing* const q : rings_beside(b, a)) {
          std::vector<SignedSegment> segments =
              signed_segments(*p, *q, operands.direction_count, most, cancellation);
          limit(chains.vertex_count() + segments.size(), most);
          link_segments(*p, *q, std::move(segments), cancellation, chains);
        }
      }
    }
  }
  return chains;
}

}  // namespace minksum::signed_sum
