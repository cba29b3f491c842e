#include "sum/small/small_polygons.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace minksum {
namespace {

/// Rounded places are off by less than a quarter of this part of the sum's width.
constexpr double kReach = 0x1p-46;

}  // namespace

void RingWriter::add_holes() {
  make_rings(1);
  for (const std::uint32_t hole : order_) add(rings_[hole]);
}

bool RingWriter::add_polygons() {
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

std::span<const SmallCorner> RingWriter::corners_of(std::size_t ring) const {
  const std::uint32_t begin = ring == 0 ? 0 : boundary_.end_of[ring - 1];
  return {boundary_.corners.data() + begin, boundary_.end_of[ring] - begin};
}

void RingWriter::make_rings(std::uint32_t first) {
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

void RingWriter::make_ring(std::span<const SmallCorner> corners, SmallRing& ring) {
  std::vector<SmallVertex>& vertices = ring.vertices;
  vertices.clear();
  vertices_.append(corners, vertices);
  ring.box = {HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  for (const SmallVertex& v : vertices) {
    ring.box.add({v.rounded.x, v.rounded.y, v.rounded.x, v.rounded.y});
  }
  const auto smallest =
      std::min_element(vertices.begin(), vertices.end(),
                       [&](const SmallVertex& a, const SmallVertex& b) { return less(a, b); });
  const auto at = static_cast<std::size_t>(smallest - vertices.begin());
  const SmallCorner& before = corners[(at == 0 ? corners.size() : at) - 1];
  ring.is_outer = vertices_.turn(before.segment, corners[at].segment) > 0;
  std::rotate(vertices.begin(), smallest, vertices.end());
}

bool RingWriter::do_parts_touch() {
  touching_.clear();
  vertices_.append(boundary_.touching, touching_);
  const auto is_less = [&](const SmallVertex& a, const SmallVertex& b) { return less(a, b); };
  std::sort(touching_.begin(), touching_.end(), is_less);
  const auto are_equal = [&](const SmallVertex& a, const SmallVertex& b) { return !less(a, b); };
  return std::adjacent_find(touching_.begin(), touching_.end(), are_equal) != touching_.end();
}

bool RingWriter::find_outer_rings() {
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

int RingWriter::holds(const std::vector<SmallVertex>& ring, const SmallVertex& point) const {
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

int RingWriter::compare(double a, double b, const StoredCoordinate& x,
                        const StoredCoordinate& y) const {
  if (std::abs(a - b) > kReach * width_) return a < b ? -1 : 1;
  const auto order = RegionAccess::compare(region_, x, y);
  return order < 0 ? -1 : order > 0 ? 1 : 0;
}

bool RingWriter::less(const SmallVertex& a, const SmallVertex& b) const {
  const int by_x = compare(a.rounded.x, b.rounded.x, a.x, b.x);
  return by_x != 0 ? by_x < 0 : compare(a.rounded.y, b.rounded.y, a.y, b.y) < 0;
}

void RingWriter::add(const SmallRing& ring) {
  region_.begin_ring();
  add_vertices(ring);
}

void RingWriter::add_vertices(const SmallRing& ring) {
  for (const SmallVertex& v : ring.vertices) {
    RegionAccess::add_vertex(region_, v.x, v.y, v.origin);
  }
}

}  // namespace minksum
