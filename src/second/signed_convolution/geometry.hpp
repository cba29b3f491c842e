// Holds the points and segments of the signed method's arrangement, and decides about them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include "machine/cancellation.hpp"
#include "machine/make_room.hpp"
#include "second/signed_convolution/numbers.hpp"

namespace minksum::signed_sum {

/// Index of a distinct point: a vertex of the convolution or a crossing.
using NodeId = std::uint32_t;
/// Index of a segment between two vertices of the convolution.
using SegmentId = std::uint32_t;

/// A coordinate pair rounded down to keys (see kKeyBits).
struct Key {
  std::int64_t x = 0;
  std::int64_t y = 0;
  friend bool operator==(const Key&, const Key&) = default;
};

/// Holds points with exact identity and order. `N` is one of the number sets of numbers.hpp, and
/// every coordinate is below 2^bits.
template <class N>
class Geometry {
 public:
  using Coordinate = typename N::Coordinate;
  using Product = typename N::Product;
  using Scaled = typename N::Scaled;
  using Comparison = typename N::Comparison;

  struct Vector {
    Coordinate x;
    Coordinate y;
  };
  struct Segment {
    NodeId from;
    NodeId to;
  };
  /// The point (x / d, y / d), where d > 0.
  struct ExactPoint {
    Scaled x;
    Scaled y;
    Product d;
  };

  Geometry(unsigned bits, Cancellation& cancellation)
      : bits_(bits), cancellation_(cancellation), work_(work_of(bits)) {}

  /// The cancellation of the operation, and the units of work of a decision.
  [[nodiscard]] Cancellation& cancellation() const { return cancellation_; }
  [[nodiscard]] std::uint64_t work() const { return work_; }

  // -- Building ------------------------------------------------------------------------------
  /// Adds an integer point, or finds it, and returns its node.
  NodeId add_vertex(const Coordinate& x, const Coordinate& y) {
    cancellation_.check(work_);
    const ExactPoint point{widen<Scaled>(x), widen<Scaled>(y), Product(1)};
    const NodeId fresh = next_node();
    const NodeId node = find_or_insert(fresh, key_of(point), point);
    if (node == fresh) {
      nodes_.back().first = static_cast<std::uint32_t>(vertices_.size());
      append(vertices_, {x, y}, cancellation_);
    }
    return node;
  }
  SegmentId add_segment(NodeId from, NodeId to) {
    append(segments_, {from, to}, cancellation_);
    return static_cast<SegmentId>(segments_.size() - 1);
  }
  /// Adds, or finds, the node where two segments cross properly. `a_from` and `a_to` are the sides
  /// of a's ends against b. Does nothing if `wanted` rejects the point's key.
  template <class Predicate>
  std::pair<bool, NodeId> add_crossing(SegmentId a, SegmentId b, const Product& a_from,
                                       const Product& a_to, const Predicate& wanted) {
    cancellation_.check(2 * work_);
    const ExactPoint point = crossing(a, a_from, a_to);
    const Key key = key_of(point);
    if (!wanted(key)) return {false, 0};
    const NodeId fresh = next_node();
    const NodeId node = find_or_insert(fresh, key, point);
    if (node == fresh) {
      nodes_.back().first = a;
      nodes_.back().second = b;
    }
    return {true, node};
  }

  // -- Reading -------------------------------------------------------------------------------
  [[nodiscard]] std::size_t node_count() const { return nodes_.size(); }
  [[nodiscard]] std::size_t segment_count() const { return segments_.size(); }
  [[nodiscard]] const Segment& segment(SegmentId id) const { return segments_[id]; }
  [[nodiscard]] const Key& key(NodeId node) const { return nodes_[node].key; }
  /// Returns the coordinates of an end of a segment.
  [[nodiscard]] const Vector& vertex(NodeId node) const { return vertices_[nodes_[node].first]; }
  [[nodiscard]] Vector direction(SegmentId id) const {
    const Vector& a = vertex(segments_[id].from);
    const Vector& b = vertex(segments_[id].to);
    return {b.x - a.x, b.y - a.y};
  }
  [[nodiscard]] ExactPoint exact(NodeId node) const {
    cancellation_.check(work_);
    const Node& record = nodes_[node];
    if (record.second == kVertex) {
      const Vector& v = vertices_[record.first];
      return {widen<Scaled>(v.x), widen<Scaled>(v.y), Product(1)};
    }
    const Segment& a = segments_[record.first];
    return crossing(record.first, side(record.second, a.from), side(record.second, a.to));
  }

  // -- Predicates ----------------------------------------------------------------------------
  [[nodiscard]] static Product cross(const Vector& a, const Vector& b) {
    return widen<Product>(a.x) * widen<Product>(b.y) - widen<Product>(a.y) * widen<Product>(b.x);
  }
  /// Returns twice the area of the triangle of a segment and a vertex, positive if the vertex is
  /// left of the segment.
  [[nodiscard]] Product side(SegmentId id, NodeId vertex_node) const {
    cancellation_.check(work_ / 4);
    const Vector& a = vertex(segments_[id].from);
    const Vector& b = vertex(segments_[id].to);
    const Vector& c = vertex(vertex_node);
    return cross({b.x - a.x, b.y - a.y}, {c.x - a.x, c.y - a.y});
  }
  /// Returns the sign of the side of any node.
  [[nodiscard]] int side_of_node(SegmentId id, NodeId node) const {
    if (nodes_[node].second == kVertex) return sign_of(side(id, node));
    const ExactPoint point = exact(node);
    const Vector& a = vertex(segments_[id].from);
    const Vector d = direction(id);
    const Comparison dx = widen<Comparison>(d.x);
    const Comparison dy = widen<Comparison>(d.y);
    const Comparison px = widen<Comparison>(point.x) - scale(a.x, point.d);
    const Comparison py = widen<Comparison>(point.y) - scale(a.y, point.d);
    return sign_of(Comparison(dx * py - dy * px));
  }
  /// Return the order of two nodes by one coordinate: -1, 0 or 1.
  [[nodiscard]] int compare_x(NodeId a, NodeId b) const { return compare<true>(a, b); }
  [[nodiscard]] int compare_y(NodeId a, NodeId b) const { return compare<false>(a, b); }
  /// Returns the order by x, then by y.
  [[nodiscard]] int compare_xy(NodeId a, NodeId b) const {
    const int by_x = compare_x(a, b);
    return by_x != 0 ? by_x : compare_y(a, b);
  }

 private:
  static constexpr std::uint32_t kVertex = std::numeric_limits<std::uint32_t>::max();
  static constexpr NodeId kNobody = std::numeric_limits<NodeId>::max();

  // A vertex (index `first` in vertices_), or the crossing of segments `first` and `second`.
  struct Node {
    Key key;
    std::uint32_t first = 0;
    std::uint32_t second = kVertex;
  };

  [[nodiscard]] static Comparison scale(const Coordinate& c, const Product& d) {
    return widen<Comparison>(c) * widen<Comparison>(d);
  }

  // side(b, ·) is linear along a, so the crossing divides a as a_from : -a_to.
  [[nodiscard]] ExactPoint crossing(SegmentId a, const Product& a_from, const Product& a_to) const {
    const Vector& from = vertex(segments_[a].from);
    const Vector d = direction(a);
    const bool left_to_right = a_from > 0;
    const Product t = left_to_right ? a_from : Product(-a_from);
    const Product whole = left_to_right ? Product(a_from - a_to) : Product(a_to - a_from);
    const Scaled wide_t = widen<Scaled>(t);
    const Scaled wide_whole = widen<Scaled>(whole);
    return {widen<Scaled>(from.x) * wide_whole + wide_t * widen<Scaled>(d.x),
            widen<Scaled>(from.y) * wide_whole + wide_t * widen<Scaled>(d.y), whole};
  }

  [[nodiscard]] Key key_of(const ExactPoint& point) const {
    return {key_of(point.x, point.d), key_of(point.y, point.d)};
  }
  [[nodiscard]] std::int64_t key_of(const Scaled& n, const Product& d) const {
    if constexpr (std::is_same_v<Coordinate, BigInteger>) {
      return static_cast<std::int64_t>(bits_ <= kKeyBits ? (n << (kKeyBits - bits_)) / d
                                                         : n / (d << (bits_ - kKeyBits)));
    } else if constexpr (std::is_same_v<Scaled, Int128>) {
      return static_cast<std::int64_t>((n << (kKeyBits - bits_)) / d);
    } else {
      return short_quotient(n * Scaled(std::int64_t{1} << (kKeyBits - bits_)), widen<Scaled>(d));
    }
  }

  template <bool kX>
  [[nodiscard]] int compare(NodeId a, NodeId b) const {
    const std::int64_t key_a = kX ? nodes_[a].key.x : nodes_[a].key.y;
    const std::int64_t key_b = kX ? nodes_[b].key.x : nodes_[b].key.y;
    if (key_a != key_b) return key_a < key_b ? -1 : 1;
    if (a == b) return 0;
    const ExactPoint pa = exact(a);
    const ExactPoint pb = exact(b);
    return kX ? compare(pa.x, pa.d, pb.x, pb.d) : compare(pa.y, pa.d, pb.y, pb.d);
  }
  [[nodiscard]] static int compare(const Scaled& n1, const Product& d1, const Scaled& n2,
                                   const Product& d2) {
    return sign_of(Comparison(widen<Comparison>(n1) * widen<Comparison>(d2) -
                              widen<Comparison>(n2) * widen<Comparison>(d1)));
  }

  // -- The table of nodes: open addressing by key, then exact comparison -----------------------
  [[nodiscard]] NodeId next_node() const { return static_cast<NodeId>(nodes_.size()); }
  [[nodiscard]] static std::size_t hash(const Key& key) {
    std::uint64_t h = static_cast<std::uint64_t>(key.x) * 0x9e3779b97f4a7c15U;
    h ^= h >> 29;
    h = (h + static_cast<std::uint64_t>(key.y)) * 0xbf58476d1ce4e5b9U;
    return static_cast<std::size_t>(h ^ (h >> 32));
  }
  NodeId find_or_insert(NodeId fresh, const Key& key, const ExactPoint& point) {
    if (2 * nodes_.size() >= table_.size()) grow();
    const std::size_t mask = table_.size() - 1;
    std::size_t slot = hash(key) & mask;
    for (; table_[slot] != kNobody; slot = (slot + 1) & mask) {
      const NodeId other = table_[slot];
      if (nodes_[other].key == key && same(exact(other), point)) return other;
    }
    table_[slot] = fresh;
    append(nodes_, {key, 0, kVertex}, cancellation_);
    return fresh;
  }
  [[nodiscard]] static bool same(const ExactPoint& a, const ExactPoint& b) {
    return compare(a.x, a.d, b.x, b.d) == 0 && compare(a.y, a.d, b.y, b.d) == 0;
  }
  void grow() {
    assign_in_pieces(table_, table_.empty() ? 256 : 2 * table_.size(), kNobody, cancellation_);
    const std::size_t mask = table_.size() - 1;
    for (NodeId node = 0; node < nodes_.size(); ++node) {
      cancellation_.check(4);
      std::size_t slot = hash(nodes_[node].key) & mask;
      while (table_[slot] != kNobody) slot = (slot + 1) & mask;
      table_[slot] = node;
    }
  }

  [[nodiscard]] static std::uint64_t work_of(unsigned bits) {
    constexpr std::uint64_t kWorkOfFixedWidth = 8;
    const bool fixed = !std::is_same_v<Coordinate, BigInteger>;
    return fixed ? kWorkOfFixedWidth : work_of_decision(bits);
  }

  unsigned bits_;
  Cancellation& cancellation_;
  std::uint64_t work_;
  std::vector<Vector> vertices_;
  std::vector<Node> nodes_;
  std::vector<Segment> segments_;
  std::vector<NodeId> table_;
};

}  // namespace minksum::signed_sum
