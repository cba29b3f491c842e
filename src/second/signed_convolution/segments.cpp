#include "second/signed_convolution/segments.hpp"

#include <algorithm>

#include "machine/exceeded.hpp"
#include "machine/make_room.hpp"
#include "second/signed_convolution/broken.hpp"

namespace minksum::signed_sum {
namespace {

struct Box {
  IntegerPoint min;
  IntegerPoint max;
};

Box box_of(const IntegerRing& ring) {
  Box box{ring.vertices.front(), ring.vertices.front()};
  for (const IntegerPoint& point : ring.vertices) {
    box.min.x = std::min(box.min.x, point.x);
    box.min.y = std::min(box.min.y, point.y);
    box.max.x = std::max(box.max.x, point.x);
    box.max.y = std::max(box.max.y, point.y);
  }
  return box;
}

// A closed set fits into an open one only if it is strictly narrower and strictly lower.
bool may_fit(const Box& set, const Box& hole) {
  return set.max.x - set.min.x < hole.max.x - hole.min.x &&
         set.max.y - set.min.y < hole.max.y - hole.min.y;
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

class Lister {
 public:
  Lister(DirectionRank count, const SumSettings& options, Cancellation& cancellation,
         std::vector<SignedSegment>& segments)
      : count_(count), options_(options), cancellation_(cancellation), segments_(segments) {}

  void list(LayerId layer, const Layer& loops) {
    for (std::size_t j = 0; j < loops.q->size(); ++j) {
      cancellation_.check(4);
      const auto [from, to] = sector(*loops.q, j);
      const Range range = edges_of_p_between(from, to, count_);
      const std::int8_t sign = loops.q->convex[j] ? 1 : -1;
      for_edges(*loops.p, range, [&](std::uint32_t edge) {
        add({layer, edge, static_cast<std::uint32_t>(j), true, sign});
      });
    }
    for (std::size_t i = 0; i < loops.p->size(); ++i) {
      cancellation_.check(4);
      const auto [from, to] = sector(*loops.p, i);
      const Range range = edges_of_q_between(from, to, count_);
      const std::int8_t sign = loops.p->convex[i] ? 1 : -1;
      for_edges(*loops.q, range, [&](std::uint32_t edge) {
        add({layer, static_cast<std::uint32_t>(i), edge, false, sign});
      });
    }
  }

 private:
  struct Sector {
    DirectionRank from;
    DirectionRank to;
  };
  // Returns the directions of the tangent at a vertex, less than a half turn. At a left turn, the
  // directions go from the incoming edge to the outgoing one; at a right turn, the other way.
  static Sector sector(const IntegerRing& ring, std::size_t vertex) {
    const DirectionRank in = ring.directions[ring.previous(vertex)];
    const DirectionRank out = ring.directions[vertex];
    return ring.convex[vertex] ? Sector{in, out} : Sector{out, in};
  }

  template <class Function>
  void for_edges(const IntegerRing& ring, Range range, const Function& function) const {
    if (range.first <= range.last) {
      for_run(ring, range.first, range.last, function);
    } else {
      for_run(ring, range.first, count_ - 1, function);
      for_run(ring, 0, range.last, function);
    }
  }

  template <class Function>
  static void for_run(const IntegerRing& ring, DirectionRank first, DirectionRank last,
                      const Function& function) {
    auto edge = std::lower_bound(
        ring.by_direction.begin(), ring.by_direction.end(), first,
        [&](std::uint32_t e, DirectionRank rank) { return ring.directions[e] < rank; });
    for (; edge != ring.by_direction.end() && ring.directions[*edge] <= last; ++edge) {
      function(*edge);
    }
  }

  void add(const SignedSegment& segment) {
    if (segments_.size() >= options_.limits.max_segments) {
      throw exceeded("Limits::max_segments", options_.limits.max_segments, "the convolution has",
                     "segments");
    }
    cancellation_.check();
    append(segments_, segment, cancellation_);
  }

  DirectionRank count_;
  const SumSettings& options_;
  Cancellation& cancellation_;
  std::vector<SignedSegment>& segments_;
};

// An end of a segment in the grid of pairs of vertices.
struct End {
  LayerId layer;
  std::uint32_t i;
  std::uint32_t j;
  int balance;
  [[nodiscard]] bool same_place(const End& other) const {
    return layer == other.layer && i == other.i && j == other.j;
  }
};

bool end_less(const End& a, const End& b) {
  if (a.layer != b.layer) return a.layer < b.layer;
  if (a.i != b.i) return a.i < b.i;
  return a.j < b.j;
}

void add_holes(const std::vector<IntegerRing>& holes, const IntegerRing& other, bool holes_of_p,
               PairId pair, Cancellation& cancellation, std::vector<Layer>& layers) {
  if (holes.empty()) return;
  const Box box = box_of(other);
  cancellation.check(16 * other.size());
  for (const IntegerRing& hole : holes) {
    cancellation.check(16 * hole.size());
    if (!may_fit(box, box_of(hole))) continue;
    layers.push_back({pair, true, holes_of_p ? &hole : &other, holes_of_p ? &other : &hole});
  }
}

}  // namespace

std::vector<Layer> make_layers(const IntegerOperands& operands, Cancellation& cancellation) {
  std::vector<Layer> layers;
  PairId pair = 0;
  for (const IntegerPart& p : operands.p) {
    for (const IntegerPart& q : operands.q) {
      cancellation.check();
      layers.push_back({pair, false, &p.outer, &q.outer});
      add_holes(p.holes, q.outer, true, pair, cancellation, layers);
      add_holes(q.holes, p.outer, false, pair, cancellation, layers);
      ++pair;
    }
  }
  return layers;
}

std::vector<SignedSegment> signed_segments(const IntegerOperands& operands,
                                           std::span<const Layer> layers,
                                           const SumSettings& options, Cancellation& cancellation) {
  std::vector<SignedSegment> segments;
  Lister lister(operands.direction_count, options, cancellation, segments);
  for (std::size_t i = 0; i < layers.size(); ++i) {
    lister.list(static_cast<LayerId>(i), layers[i]);
  }
  return segments;
}

bool is_closed(std::span<const Layer> layers, std::span<const SignedSegment> segments,
               Cancellation& cancellation) {
  std::vector<End> ends;
  ends.reserve(2 * segments.size());
  for (const SignedSegment& segment : segments) {
    cancellation.check(2);
    const Layer& loops = layers[segment.layer];
    End end{segment.layer, segment.p_index, segment.q_index, -segment.multiplicity};
    ends.push_back(end);
    std::uint32_t& moving = segment.edge_of_p ? end.i : end.j;
    moving = static_cast<std::uint32_t>((segment.edge_of_p ? loops.p : loops.q)->next(moving));
    end.balance = segment.multiplicity;
    ends.push_back(end);
  }
  std::sort(ends.begin(), ends.end(), cancellation.counting(end_less));
  int balance = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    cancellation.check();
    balance += ends[i].balance;
    const bool last = i + 1 == ends.size() || !ends[i].same_place(ends[i + 1]);
    if (last && balance != 0) return false;
  }
  return true;
}

}  // namespace minksum::signed_sum
