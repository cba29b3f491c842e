// Step 3 of the signed method: the arrangement of all signed segments as a graph of pieces.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "minksum/testing.hpp"
#include "second/signed_convolution/crossings.hpp"
#include "second/signed_convolution/geometry.hpp"
#include "second/signed_convolution/segments.hpp"

namespace minksum::signed_sum {

/// By how much a layer's winding number is larger on the left than on the right.
struct Delta {
  LayerId layer = 0;
  std::int32_t change = 0;
};

/// A part of a segment without nodes inside, directed from `from` to `to`.
struct Piece {
  NodeId from = 0;
  NodeId to = 0;
  SegmentId segment = 0;
  bool along_segment = true;       ///< whether the piece has its segment's direction
  bool deltas_along_piece = true;  ///< whether the deltas hold for this direction, not the reverse
  std::uint32_t first_delta = 0;
  std::uint32_t last_delta = 0;
};

/// A directed piece. Half-edge 2k is piece k in its own direction; 2k + 1 is piece k reversed.
using HalfEdge = std::uint32_t;
[[nodiscard]] constexpr HalfEdge twin(HalfEdge h) { return h ^ 1U; }

/// Pieces that meet only at nodes, no two between the same nodes. Pieces across which no winding
/// number changes are left out.
struct Arrangement {
  std::vector<Piece> pieces;
  std::vector<Delta> deltas;
  std::vector<std::uint32_t> node_first;  ///< by node, and one more: the start of its half-edges
  std::vector<HalfEdge> outgoing;   ///< counter-clockwise around each node, from straight down
                                    ///< (excluded) to straight down (included)
  std::vector<std::uint32_t> slot;  ///< by half-edge: its index in `outgoing`

  [[nodiscard]] NodeId origin(HalfEdge h) const {
    return (h & 1U) == 0 ? pieces[h >> 1].from : pieces[h >> 1].to;
  }
  [[nodiscard]] std::size_t half_edge_count() const { return 2 * pieces.size(); }
  [[nodiscard]] std::size_t node_count() const { return node_first.size() - 1; }
  /// Returns the next half-edge clockwise around the same origin.
  [[nodiscard]] HalfEdge clockwise(HalfEdge h) const {
    const NodeId node = origin(h);
    const std::uint32_t at = slot[h];
    return outgoing[(at == node_first[node] ? node_first[node + 1] : at) - 1];
  }
  /// Returns the next half-edge along the boundary of the face on the left.
  [[nodiscard]] HalfEdge next(HalfEdge h) const { return clockwise(twin(h)); }
  /// Calls `visit(layer, change)` for all changes from the right side of h to its left side.
  template <class Visit>
  void for_deltas(HalfEdge h, const Visit& visit) const {
    const Piece& piece = pieces[h >> 1];
    const int sign = ((h & 1U) == 0) == piece.deltas_along_piece ? 1 : -1;
    for (std::uint32_t i = piece.first_delta; i < piece.last_delta; ++i) {
      visit(deltas[i].layer, sign * deltas[i].change);
    }
  }
};

/// Tells whether every layer's pieces form cycles: at each node, as much comes in as goes out.
[[nodiscard]] bool is_balanced(const Arrangement& arrangement);

/// The deltas of a segment of `Geometry`, in its direction: those of all signed segments between
/// its ends.
struct DeltaRange {
  std::uint32_t first = 0;
  std::uint32_t last = 0;
};

/// Adds up contributions and appends them to `deltas`: one entry a layer, and none that is 0.
[[nodiscard]] DeltaRange append_sum(std::span<Delta> contributions, std::vector<Delta>& deltas);

template <class N>
class ArrangementBuilder {
 public:
  ArrangementBuilder(Geometry<N>& geometry, const SumSettings& options, Statistics& statistics)
      : geometry_(geometry),
        options_(options),
        cancellation_(geometry.cancellation()),
        statistics_(statistics) {}

  Arrangement run(std::span<const Layer> layers, std::span<const SignedSegment> segments) {
    add_segments(layers, segments);
    CrossingFinder<N> finder(geometry_, options_);
    finder.run();
    statistics_.crossings = finder.crossings();
    split(finder.stops());
    merge_pieces();
    link();
    return std::move(result_);
  }

 private:
  using Coordinate = typename N::Coordinate;
  using Vector = typename Geometry<N>::Vector;
  struct Ends {
    NodeId from;
    NodeId to;
    Delta delta;
  };
  struct RawPiece {
    NodeId from;
    NodeId to;
    SegmentId segment;
    bool along_segment;
  };

  [[nodiscard]] static std::vector<Vector> coordinates(const IntegerRing& ring) {
    std::vector<Vector> result;
    result.reserve(ring.size());
    for (const IntegerPoint& point : ring.vertices) {
      result.push_back({static_cast<Coordinate>(point.x), static_cast<Coordinate>(point.y)});
    }
    return result;
  }

  // Signed segments with the same ends become one segment, with one delta for each layer.
  void add_segments(std::span<const Layer> layers, std::span<const SignedSegment> segments) {
    std::vector<Ends> all;
    all.reserve(segments.size());
    std::vector<Vector> p;
    std::vector<Vector> q;
    for (std::size_t k = 0; k < segments.size(); ++k) {
      cancellation_.check(8);
      const SignedSegment& s = segments[k];
      const Layer& loops = layers[s.layer];
      if (k == 0 || segments[k - 1].layer != s.layer) {
        cancellation_.check(4 * (loops.p->size() + loops.q->size()));
        p = coordinates(*loops.p);
        q = coordinates(*loops.q);
      }
      const NodeId from = add_sum(p[s.p_index], q[s.q_index]);
      const NodeId to = s.edge_of_p ? add_sum(p[loops.p->next(s.p_index)], q[s.q_index])
                                    : add_sum(p[s.p_index], q[loops.q->next(s.q_index)]);
      if (from < to) all.push_back({from, to, {s.layer, s.multiplicity}});
      if (to < from) all.push_back({to, from, {s.layer, -s.multiplicity}});
    }
    std::sort(all.begin(), all.end(), cancellation_.counting([](const Ends& a, const Ends& b) {
      return a.from != b.from ? a.from < b.from : a.to < b.to;
    }));
    std::vector<Delta> group;
    for (std::size_t i = 0; i < all.size();) {
      group.clear();
      std::size_t j = i;
      for (; j < all.size() && all[j].from == all[i].from && all[j].to == all[i].to; ++j) {
        cancellation_.check(2);
        group.push_back(all[j].delta);
      }
      const DeltaRange range = append_sum(group, result_.deltas);
      if (range.first != range.last) {
        geometry_.add_segment(all[i].from, all[i].to);
        append(segment_deltas_, range, cancellation_);
      }
      i = j;
    }
  }
  NodeId add_sum(const Vector& a, const Vector& b) {
    return geometry_.add_vertex(a.x + b.x, a.y + b.y);
  }

  void split(const std::vector<Stop>& stops) {
    const std::size_t count = geometry_.segment_count();
    std::vector<std::size_t> first;
    assign_in_pieces(first, count + 1, std::size_t{0}, cancellation_);
    visit_in_pieces(stops, cancellation_, [&](const Stop& stop) { ++first[stop.segment]; });
    std::size_t total = 0;
    visit_in_pieces(first, cancellation_, [&](std::size_t& f) { f = total += f; });
    std::vector<NodeId> nodes;
    resize_in_pieces(nodes, total, cancellation_);
    visit_in_pieces(stops, cancellation_,
                    [&](const Stop& stop) { nodes[--first[stop.segment]] = stop.node; });
    raw_.reserve(total + count);
    for (SegmentId id = 0; id < count; ++id) {
      const auto begin = nodes.begin() + static_cast<std::ptrdiff_t>(first[id]);
      const auto end = nodes.begin() + static_cast<std::ptrdiff_t>(first[id + 1]);
      sort_along(id, begin, end);
      NodeId last = geometry_.segment(id).from;
      for (auto node = begin; node != end; ++node) {
        add_raw(id, last, *node);
        last = *node;
      }
      add_raw(id, last, geometry_.segment(id).to);
    }
  }
  // Along a segment, x decides the order, or y if the segment is vertical.
  template <class Iterator>
  void sort_along(SegmentId id, Iterator begin, Iterator end) const {
    if (end - begin < 2) return;
    const Vector d = geometry_.direction(id);
    const int sx = sign_of(d.x);
    const int sy = sign_of(d.y);
    std::sort(begin, end, [&](NodeId a, NodeId b) {
      cancellation_.check(4);
      if (a == b) return false;
      const Key& ka = geometry_.key(a);
      const Key& kb = geometry_.key(b);
      if (ka.x != kb.x) return (ka.x < kb.x) == (sx > 0);
      if (ka.y != kb.y) return (ka.y < kb.y) == (sy > 0);
      return sx != 0 ? geometry_.compare_x(a, b) * sx < 0 : geometry_.compare_y(a, b) * sy < 0;
    });
  }
  void add_raw(SegmentId id, NodeId a, NodeId b) {
    cancellation_.check();
    if (a < b) raw_.push_back({a, b, id, true});
    if (b < a) raw_.push_back({b, a, id, false});
  }

  void merge_pieces() {
    const auto before = [](const RawPiece& a, const RawPiece& b) {
      return a.from != b.from ? a.from < b.from : a.to < b.to;
    };
    std::sort(raw_.begin(), raw_.end(), cancellation_.counting(before));
    std::vector<Delta> group;
    for (std::size_t i = 0; i < raw_.size();) {
      std::size_t j = i + 1;
      while (j < raw_.size() && raw_[j].from == raw_[i].from && raw_[j].to == raw_[i].to) ++j;
      cancellation_.check(2 * (j - i));
      Piece piece{raw_[i].from, raw_[i].to, raw_[i].segment, raw_[i].along_segment, true, 0, 0};
      DeltaRange range = segment_deltas_[raw_[i].segment];
      piece.deltas_along_piece = raw_[i].along_segment;
      if (j > i + 1) {
        group.clear();
        for (std::size_t k = i; k < j; ++k) collect(raw_[k], group);
        range = append_sum(group, result_.deltas);
        piece.deltas_along_piece = true;
      }
      piece.first_delta = range.first;
      piece.last_delta = range.last;
      if (range.first != range.last) append(result_.pieces, piece, cancellation_);
      i = j;
    }
    raw_ = {};
  }
  void collect(const RawPiece& raw, std::vector<Delta>& group) const {
    const DeltaRange range = segment_deltas_[raw.segment];
    for (std::uint32_t i = range.first; i < range.last; ++i) {
      const Delta& delta = result_.deltas[i];
      group.push_back({delta.layer, raw.along_segment ? delta.change : -delta.change});
    }
  }

  // Sorts the half-edges around each node. Their directions are those of whole segments, so they
  // are integers.
  void link() {
    const std::size_t count = result_.half_edge_count();
    assign_in_pieces(result_.node_first, geometry_.node_count() + 1, 0U, cancellation_);
    for (HalfEdge h = 0; h < count; ++h) {
      cancellation_.check();
      ++result_.node_first[result_.origin(h)];
    }
    std::uint32_t sum = 0;
    visit_in_pieces(result_.node_first, cancellation_, [&](std::uint32_t& f) { f = sum += f; });
    resize_in_pieces(result_.outgoing, count, cancellation_);
    for (HalfEdge h = 0; h < count; ++h) {
      cancellation_.check();
      result_.outgoing[--result_.node_first[result_.origin(h)]] = h;
    }
    for (NodeId node = 0; node < result_.node_count(); ++node) sort_around(node);
    resize_in_pieces(result_.slot, count, cancellation_);
    std::uint32_t slot = 0;
    visit_in_pieces(result_.outgoing, cancellation_, [&](HalfEdge h) { result_.slot[h] = slot++; });
  }
  void sort_around(NodeId node) {
    struct Ray {
      Vector direction;
      HalfEdge half_edge;
      bool first_half;
    };
    std::vector<Ray> rays;
    const std::uint32_t first = result_.node_first[node];
    for (std::uint32_t i = first; i < result_.node_first[node + 1]; ++i) {
      cancellation_.check(geometry_.work());
      const HalfEdge h = result_.outgoing[i];
      const Piece& piece = result_.pieces[h >> 1];
      Vector d = geometry_.direction(piece.segment);
      if (piece.along_segment != ((h & 1U) == 0)) d = {-d.x, -d.y};
      const bool first_half = d.x > 0 || (d.x == 0 && d.y > 0);
      rays.push_back({d, h, first_half});
    }
    std::sort(rays.begin(), rays.end(), [this](const Ray& a, const Ray& b) {
      cancellation_.check(geometry_.work());
      if (a.first_half != b.first_half) return a.first_half;
      return Geometry<N>::cross(a.direction, b.direction) > 0;
    });
    for (std::uint32_t i = 0; i < rays.size(); ++i) result_.outgoing[first + i] = rays[i].half_edge;
  }

  Geometry<N>& geometry_;
  const SumSettings& options_;
  Cancellation& cancellation_;
  Statistics& statistics_;
  std::vector<DeltaRange> segment_deltas_;
  std::vector<RawPiece> raw_;
  Arrangement result_;
};

}  // namespace minksum::signed_sum
