// Writes the rings of a small sum in canonical order.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "sum/small/small_writer.hpp"

namespace minksum {

/// A ring of a result. It starts at its smallest vertex.
struct SmallRing {
  std::vector<SmallVertex> vertices;
  BoxOf<double> box;  ///< of rounded places
  bool is_outer = false;
  // Among all rings in order:
  std::uint32_t place = 0;
  std::uint32_t outer = 0;  ///< the place of its polygon's outer ring
};

/// Memory for rings, of which more may be kept than are in use.
struct SmallRingsMemory {
  std::vector<SmallRing> rings;
  std::vector<std::uint32_t> order;
  std::vector<SmallVertex> touching;
};

/// Makes rings of a boundary's corners, orders them, and appends them to a region.
template <class Number>
class RingWriter {
 public:
  RingWriter(const WayFractions<Number>& ways, const SmallSegments& segments,
             const SmallBoundary& boundary, double width, SmallWriter<Number>& writer,
             SmallRingsMemory& memory, Region& region)
      : ways_(ways),
        s_(segments),
        boundary_(boundary),
        width_(width),
        writer_(writer),
        rings_(memory.rings),
        order_(memory.order),
        touching_(memory.touching),
        region_(region) {}

  /// Appends all rings but the first one: the holes of a polygon.
  void add_holes() {
    make_rings(1);
    for (const std::uint32_t hole : order_) add(rings_[hole]);
  }
  /// Writes the rings of several polygons to a region that holds none but an empty one. Returns
  /// false if parts of the sum only touch one another, or if rounded places do not tell which
  /// polygon a hole is in.
  [[nodiscard]] bool add_polygons() {
    if (do_parts_touch()) return false;
    make_rings(0);
    if (!find_outer_rings()) return false;
    const auto key = [&](std::uint32_t k) { return std::pair(rings_[k].outer, rings_[k].place); };
    std::sort(order_.begin(), order_.end(),
              [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    add_vertices(rings_[order_[0]]);
    for (std::size_t k = 1; k < order_.size(); ++k) {
      if (rings_[order_[k]].is_outer) region_.begin_polygon();
      add(rings_[order_[k]]);
    }
    return true;
  }

 private:
  [[nodiscard]] std::span<const SmallCorner> corners_of(std::size_t ring) const {
    const std::uint32_t begin = ring == 0 ? 0 : boundary_.end_of[ring - 1];
    return {boundary_.corners.data() + begin, boundary_.end_of[ring] - begin};
  }
  /// Makes the rings from this one on, and orders them.
  void make_rings(std::uint32_t first) {
    const auto count = static_cast<std::uint32_t>(boundary_.end_of.size());
    if (rings_.size() < count) rings_.resize(count);
    for (std::uint32_t k = first; k < count; ++k) make_ring(corners_of(k), rings_[k]);
    // Rings that start at the same vertex differ in the second one. Mostly they are few, so each is
    // put among those before it.
    const auto is_before = [&](std::uint32_t i, std::uint32_t j) {
      const std::vector<SmallVertex>& a = rings_[i].vertices;
      const std::vector<SmallVertex>& b = rings_[j].vertices;
      return less(a[0], b[0]) || (!less(b[0], a[0]) && less(a[1], b[1]));
    };
    order_.resize(count - first);
    for (std::uint32_t k = first; k < count; ++k) {
      const auto end = order_.begin() + (k - first);
      *end = k;
      std::rotate(std::upper_bound(order_.begin(), end, k, is_before), end, end + 1);
    }
  }
  void make_ring(std::span<const SmallCorner> corners, SmallRing& ring) {
    std::vector<SmallVertex>& vertices = ring.vertices;
    vertices.clear();
    ring.box = {HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (const SmallCorner& corner : corners) {
      const Vec<double>& at = vertices.emplace_back(writer_.vertex(ways_, s_, corner)).rounded;
      ring.box.add({at.x, at.y, at.x, at.y});
    }
    const auto smallest =
        std::min_element(vertices.begin(), vertices.end(),
                         [&](const SmallVertex& a, const SmallVertex& b) { return less(a, b); });
    const auto at = static_cast<std::size_t>(smallest - vertices.begin());
    const SmallCorner& before = corners[(at == 0 ? corners.size() : at) - 1];
    ring.is_outer = ways_.turn(before.segment, corners[at].segment) > 0;
    std::rotate(vertices.begin(), smallest, vertices.end());
  }
  /// Whether rings go from one part to another one at the same place twice: there and back.
  [[nodiscard]] bool do_parts_touch() {
    touching_.clear();
    for (const SmallCorner& place : boundary_.touching) {
      touching_.push_back(writer_.vertex(ways_, s_, place));
    }
    const auto is_less = [&](const SmallVertex& a, const SmallVertex& b) { return less(a, b); };
    std::sort(touching_.begin(), touching_.end(), is_less);
    const auto are_equal = [&](const SmallVertex& a, const SmallVertex& b) { return !less(a, b); };
    return std::adjacent_find(touching_.begin(), touching_.end(), are_equal) != touching_.end();
  }
  /// Finds the polygon of each hole. Of the outer rings that hold it, this is the last in order.
  [[nodiscard]] bool find_outer_rings() {
    const double reach = kReach * width_;
    for (std::uint32_t place = 0; place < order_.size(); ++place) {
      SmallRing& ring = rings_[order_[place]];
      ring.place = ring.outer = place;
      // A ring that holds a hole starts before it.
      for (bool is_found = ring.is_outer; !is_found;) {
        if (ring.outer == 0) return false;
        const SmallRing& outer = rings_[order_[--ring.outer]];
        if (!outer.is_outer || !outer.box.meets(moved(ring.box, {}, reach))) continue;
        const int held = holds(outer.vertices, ring.vertices[0]);
        if (held < 0) return false;
        is_found = held > 0;
      }
    }
    return true;
  }
  /// Returns 1 if a ring holds a point, 0 if it does not, and -1 if that is not sure.
  [[nodiscard]] int holds(const std::vector<SmallVertex>& ring, const SmallVertex& point) const {
    const auto is_above = [&](const SmallVertex& v) {
      return compare(v.rounded.y, point.rounded.y, v.y, point.y) > 0;
    };
    const double reach = kReach * width_;
    bool odd = false;
    bool to_is_above = is_above(ring.back());
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const bool from_is_above = std::exchange(to_is_above, is_above(ring[i]));
      if (from_is_above == to_is_above) continue;
      const Vec<double> from = ring[(i == 0 ? ring.size() : i) - 1].rounded;
      const Vec<double> way = minus(ring[i].rounded, from);
      const double side = cross(way, minus(point.rounded, from));
      if (std::abs(side) <= 4 * reach * (std::abs(way.x) + std::abs(way.y))) return -1;
      // A ray to the left meets upward edges whose right side it starts on, and downward ones.
      odd = odd != ((side < 0) == to_is_above);
    }
    return odd ? 1 : 0;
  }

  [[nodiscard]] int compare(double a, double b, const StoredCoordinate& x,
                            const StoredCoordinate& y) const {
    if (std::abs(a - b) > kReach * width_) return a < b ? -1 : 1;
    const auto order = RegionAccess::compare(region_, x, y);
    return order < 0 ? -1 : order > 0 ? 1 : 0;
  }
  [[nodiscard]] bool less(const SmallVertex& a, const SmallVertex& b) const {
    const int by_x = compare(a.rounded.x, b.rounded.x, a.x, b.x);
    return by_x != 0 ? by_x < 0 : compare(a.rounded.y, b.rounded.y, a.y, b.y) < 0;
  }
  void add(const SmallRing& ring) {
    region_.begin_ring();
    add_vertices(ring);
  }
  void add_vertices(const SmallRing& ring) {
    for (const SmallVertex& v : ring.vertices)
      RegionAccess::add_vertex(region_, v.x, v.y, v.origin);
  }

  /// Rounded places are off by less than a quarter of this part of the sum's width.
  static constexpr double kReach = 0x1p-46;

  const WayFractions<Number>& ways_;
  const SmallSegments& s_;
  const SmallBoundary& boundary_;
  double width_;
  SmallWriter<Number>& writer_;
  std::vector<SmallRing>& rings_;
  std::vector<std::uint32_t>& order_;
  std::vector<SmallVertex>& touching_;
  Region& region_;
};

}  // namespace minksum
