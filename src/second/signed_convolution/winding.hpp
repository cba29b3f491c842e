// Step 4 of the signed method: finds by winding numbers which side of each piece is in the sum.
//
// The faces of a connected component of the arrangement are visited one by one. Each step crosses
// one piece, and updates the winding numbers of all layers. Where a component starts, the numbers
// are counted directly, along a ray to infinity. So it need not be known which component lies in
// which.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "second/signed_convolution/arrangement.hpp"
#include "second/signed_convolution/broken.hpp"
#include "second/signed_convolution/geometry.hpp"
#include "second/signed_convolution/segments.hpp"

namespace minksum::signed_sum {

/// The winding numbers of all layers at a point, and whether the point is in the sum.
class WindingNumbers {
 public:
  explicit WindingNumbers(std::span<const Layer> layers);
  void add(LayerId layer, int change);
  /// Returns how many layers there are.
  [[nodiscard]] std::size_t size() const { return winding_.size(); }
  /// Tells whether the point is in the sum of some pair of parts: in the filled sum and in no hole.
  [[nodiscard]] bool inside() const { return pairs_inside_ > 0; }
  /// Throws Error(kInternal) if a layer, just changed, has a number that theory excludes.
  void check(LayerId layer) const;
  void clear();

 private:
  [[nodiscard]] bool pair_inside(PairId pair) const {
    return pair_filled_[pair] > 0 && pair_holes_[pair] == 0;
  }
  std::span<const Layer> layers_;
  std::vector<std::int32_t> winding_;      // per layer
  std::vector<std::int32_t> pair_filled_;  // winding number of the pair's outer rings
  std::vector<std::int32_t> pair_holes_;   // how many of the pair's holes have winding number -1
  std::int64_t pairs_inside_ = 0;
};

/// Tells for each half-edge whether the face on its left is in the sum.
using InsideFlags = std::vector<bool>;

/// Tells whether a half-edge bounds the sum and has it on its left.
[[nodiscard]] inline bool is_boundary(const InsideFlags& inside, HalfEdge h) {
  return inside[h] && !inside[twin(h)];
}

template <class N>
class WindingTrace {
 public:
  WindingTrace(const Geometry<N>& geometry, const Arrangement& arrangement,
               std::span<const Layer> layers)
      : geometry_(geometry),
        cancellation_(geometry.cancellation()),
        arrangement_(arrangement),
        winding_(layers) {}

  InsideFlags run() {
    label_cycles();
    std::vector<NodeId> starts = leftmost_nodes();
    index_pieces(starts.size());
    cycle_inside_.assign(cycle_count_, 0);
    for (const NodeId node : starts) {
      cancellation_.check(winding_.size() / 4);
      count_left_of(node);
      // All half-edges here go right or up. The last one counter-clockwise from straight down has
      // the point just left of the node in the face on its left.
      walk_component(arrangement_.outgoing[arrangement_.node_first[node + 1] - 1]);
    }
    InsideFlags inside(arrangement_.half_edge_count());
    for (HalfEdge h = 0; h < inside.size(); ++h) {
      cancellation_.check();
      inside[h] = cycle_inside_[cycle_[h]] == kInside;
    }
    return inside;
  }

 private:
  static constexpr std::uint8_t kOutside = 1;
  static constexpr std::uint8_t kInside = 2;
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  void label_cycles() {
    assign_in_pieces(cycle_, arrangement_.half_edge_count(), kNone, cancellation_);
    for (HalfEdge h = 0; h < cycle_.size(); ++h) {
      if (cycle_[h] != kNone) continue;
      for (HalfEdge g = h; cycle_[g] == kNone; g = arrangement_.next(g)) {
        cancellation_.check(2);
        cycle_[g] = cycle_count_;
      }
      ++cycle_count_;
    }
  }

  // Returns the lexicographically smallest node of each connected component.
  [[nodiscard]] std::vector<NodeId> leftmost_nodes() const {
    std::vector<NodeId> parent;
    resize_in_pieces(parent, arrangement_.node_count(), cancellation_);
    NodeId next = 0;
    visit_in_pieces(parent, cancellation_, [&](NodeId& node) { node = next++; });
    const auto find = [&](NodeId node) {
      while (parent[node] != node) node = parent[node] = parent[parent[node]];
      return node;
    };
    for (const Piece& piece : arrangement_.pieces) {
      const NodeId a = find(piece.from);
      const NodeId b = find(piece.to);
      cancellation_.check(2);
      if (a != b) parent[std::max(a, b)] = std::min(a, b);
    }
    std::vector<NodeId> leftmost;
    assign_in_pieces(leftmost, parent.size(), kNone, cancellation_);
    for (const Piece& piece : arrangement_.pieces) {
      NodeId& best = leftmost[find(piece.from)];
      cancellation_.check(2);
      for (const NodeId node : {piece.from, piece.to}) {
        if (best == kNone || (node != best && geometry_.compare_xy(node, best) < 0)) best = node;
      }
    }
    std::erase(leftmost, kNone);
    return leftmost;
  }

  // -- Winding numbers at a point, counted along a ray straight down ---------------------------
  void index_pieces(std::size_t queries) {
    for (const Piece& piece : arrangement_.pieces) {
      cancellation_.check(2);
      for (const NodeId node : {piece.from, piece.to}) {
        min_x_ = std::min(min_x_, geometry_.key(node).x);
        max_x_ = std::max(max_x_, geometry_.key(node).x);
      }
    }
    const std::size_t wanted = std::clamp<std::size_t>(queries / 2, 1, 4096);
    while ((static_cast<std::uint64_t>(max_x_ - min_x_) >> shift_) >= wanted) ++shift_;
    slabs_.resize(arrangement_.pieces.empty() ? 0 : slab(max_x_) + 1);
    for (std::uint32_t k = 0; k < arrangement_.pieces.size(); ++k) {
      const Piece& piece = arrangement_.pieces[k];
      std::size_t a = slab(geometry_.key(piece.from).x);
      std::size_t b = slab(geometry_.key(piece.to).x);
      if (b < a) std::swap(a, b);
      cancellation_.check(2 * (b - a + 1));
      for (std::size_t s = a; s <= b; ++s) slabs_[s].push_back(k);
    }
  }
  [[nodiscard]] std::size_t slab(std::int64_t key) const {
    return static_cast<std::size_t>((key - min_x_) >> shift_);
  }

  // Counts winding numbers at an infinitesimal distance left of the node, which no piece of its
  // component reaches. So a piece counts if it runs below the node and has the node's x, but not as
  // its smallest x.
  void count_left_of(NodeId node) {
    winding_.clear();
    for (const std::uint32_t k : slabs_[slab(geometry_.key(node).x)]) {
      const Piece& piece = arrangement_.pieces[k];
      cancellation_.check();
      const int from = geometry_.compare_x(piece.from, node);
      const int to = geometry_.compare_x(piece.to, node);
      const bool rightward = from < 0 && to >= 0;
      const bool leftward = to < 0 && from >= 0;
      if (!rightward && !leftward) continue;
      const int side = geometry_.side_of_node(piece.segment, node);
      if (side == 0) broken("a component of the arrangement does not start at its leftmost node");
      const bool node_on_left = (side > 0) == piece.along_segment;
      if (node_on_left != rightward) continue;
      arrangement_.for_deltas(2 * k + (rightward ? 0U : 1U),
                              [&](LayerId layer, int change) { winding_.add(layer, change); });
    }
  }

  // -- From face to face ----------------------------------------------------------------------
  struct Visit {
    HalfEdge first;    // the face was entered on the left side of this
    HalfEdge current;  // the other side of this is looked at next
    bool started;
  };

  void cross_to_left_of(HalfEdge h) {
    arrangement_.for_deltas(h, [&](LayerId layer, int change) {
      cancellation_.check();
      winding_.add(layer, change);
    });
    arrangement_.for_deltas(h, [&](LayerId layer, int) { winding_.check(layer); });
  }

  void enter(HalfEdge h) {
    cycle_inside_[cycle_[h]] = winding_.inside() ? kInside : kOutside;
    stack_.push_back({h, h, false});
  }

  void walk_component(HalfEdge start) {
    enter(start);
    while (!stack_.empty()) {
      cancellation_.check();
      Visit& visit = stack_.back();
      if (visit.started && visit.current == visit.first) {
        const HalfEdge entered = visit.first;
        stack_.pop_back();
        if (!stack_.empty()) cross_to_left_of(twin(entered));
        continue;
      }
      visit.started = true;
      const HalfEdge other_side = twin(visit.current);
      visit.current = arrangement_.next(visit.current);
      if (cycle_inside_[cycle_[other_side]] == 0) {
        cross_to_left_of(other_side);
        enter(other_side);
      }
    }
  }

  const Geometry<N>& geometry_;
  Cancellation& cancellation_;
  const Arrangement& arrangement_;
  WindingNumbers winding_;
  std::vector<std::uint32_t> cycle_;  // by half-edge: the boundary cycle of its left face
  std::uint32_t cycle_count_ = 0;
  std::vector<std::uint8_t> cycle_inside_;
  std::vector<Visit> stack_;
  std::vector<std::vector<std::uint32_t>> slabs_;  // pieces by the keys of x
  std::int64_t min_x_ = std::numeric_limits<std::int64_t>::max();
  std::int64_t max_x_ = 0;
  int shift_ = 0;
};

}  // namespace minksum::signed_sum
