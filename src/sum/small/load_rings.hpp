// Loads the rings of small operands as integers of any of three sizes.
#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "region/region_access.hpp"
#include "sum/small/added_ring.hpp"

namespace minksum {

/// Sets `value` to the numerator of a coordinate that has limbs. Returns false if it is too long,
/// or if there is a denominator.
template <class Integer>
bool take_limbs(const Region& region, const StoredCoordinate& c, Integer& value) {
  const auto limbs = RegionAccess::limbs(region).subspan(static_cast<std::size_t>(c.payload));
  const std::size_t count = c.numerator_limbs & kLimbCountMask;
  constexpr std::size_t kLimbs = sizeof(Integer) / sizeof(std::uint64_t);
  if (count > kLimbs || c.denominator_limbs != 1 || limbs[count] != 1) return false;
  if (count == kLimbs && limbs[count - 1] >> 62U != 0) return false;
  const auto magnitude = WideInt<kLimbs>::of_limbs(limbs.first(count));
  if constexpr (std::is_same_v<Integer, Int128>) {
    value = magnitude.to_int128();
  } else {
    value = magnitude;
  }
  if ((c.numerator_limbs & kNegativeLimbs) != 0) value = -value;
  return true;
}

/// Adds the rings of a region to an operand whose grid is set. With Int128 as the integer type, the
/// operand is wide; with WideNumber, it is long.
template <class Integer>
class RingLoader {
  static constexpr bool kWide = !std::is_same_v<Integer, std::int64_t>;
  static constexpr bool kLong = std::is_same_v<Integer, WideNumber>;

 public:
  RingLoader(const Region& region, SmallOperand& s) : region_(region), s_(s) {
    s.make_rows(region.vertex_count() + (kLanes - 1) * region.ring_count(), kWide, kLong);
    s.entries = 0;
    s.outer_rings = 0;
    s.longest = 0;
    s.turning = 0;
    s.turning_of_holes = 0;
    s.holes.clear();
    s.ends.clear();
  }

  /// Adds a ring, all outer ones first, without repeated vertices. Returns false if coordinates are
  /// too long integers on the grid, if the box of a hole is not inside that of the outer rings, or
  /// if the ring has a spike or less than three vertices.
  bool add(std::size_t ring, bool is_outer) {
    AddedRing<Coordinate> added(s_);
    const IndexRange vertices = region_.vertices_of(ring);
    return vertices.size() >= 3 && load(vertices, is_outer, added);
  }
  /// Must be called first if there are several outer rings. Takes the box of all. Returns false if
  /// coordinates are too long integers on the grid.
  [[gnu::noinline]] bool take_common_box() {
    Vec<Integer> low{};
    Vec<Integer> high{};
    bool is_first = true;
    for (const std::size_t polygon : region_.polygons()) {
      const IndexRange rings = region_.rings_of(polygon);
      if (rings.empty()) return false;
      for (const std::size_t v : region_.vertices_of(rings.front())) {
        Vec<Integer> at;
        if (!take(v, at)) return false;
        if (std::exchange(is_first, false)) low = high = at;
        low = {std::min(low.x, at.x), std::min(low.y, at.y)};
        high = {std::max(high.x, at.x), std::max(high.y, at.y)};
      }
    }
    const Vec<Integer> extent = minus(high, low);
    box_is_known_ = true;
    s_.least_extent = {HUGE_VAL, HUGE_VAL};
    return set_box(low, {static_cast<Coordinate>(extent.x), static_cast<Coordinate>(extent.y)});
  }

 private:
  using Coordinate = std::conditional_t<kWide, Integer, double>;

  /// Brings a coordinate to the grid. Returns false if it is not an integer there, or too long.
  [[nodiscard, gnu::always_inline]] bool take(const StoredCoordinate& c, int exp2, int exp10,
                                              Integer& value) const {
    const int tens = c.exp10 - exp10;
    const int twos = c.exp2 - exp2;
    value = Integer(c.payload);
    if constexpr (std::is_same_v<Integer, Int128> && SmallOperand::kMayBeLong) {
      // A stored number has 63 bits, and so has such a factor. This is most numbers.
      constexpr int kMostBits = 62;
      if (c.denominator_limbs == 0 && (tens | twos) >= 0 &&
          bits_of_ten_to(tens) + twos <= kMostBits) {
        value *= kPowersOfTen[static_cast<std::size_t>(tens)] << twos;
        return true;
      }
    }
    if constexpr (kWide) {
      if (c.denominator_limbs != 0 && !take_limbs(region_, c, value)) return false;
    }
    // The exponents of zero are of no matter.
    return value == Integer(0) || scale(tens, twos, value);
  }

  [[nodiscard]] bool take(std::size_t vertex, Vec<Integer>& at) const {
    return take(RegionAccess::x(region_, vertex), s_.exp2, s_.exp10, at.x) &&
           take(RegionAccess::y(region_, vertex), s_.exp2, s_.exp10, at.y);
  }

  [[nodiscard]] bool load(const IndexRange& vertices, bool is_outer, AddedRing<Coordinate>& ring) {
    double* const x = ring.row(SmallOperand::kX);
    double* const y = ring.row(SmallOperand::kY);
    double* const source = ring.row(SmallOperand::kVertexSource);
    auto* const at_whole = ring.whole();
    const int exp2 = s_.exp2;
    const int exp10 = s_.exp10;
    // Places are seen from the first vertex, until the box is known.
    Vec<Integer> first{};
    Vec<Coordinate> last{};
    Vec<Coordinate> low{};
    Vec<Coordinate> high{};
    std::uint32_t size = 0;
    for (const std::size_t v : vertices) {
      Integer at_x;
      Integer at_y;
      if (!take(RegionAccess::x(region_, v), exp2, exp10, at_x) ||
          !take(RegionAccess::y(region_, v), exp2, exp10, at_y)) {
        return false;
      }
      if (v == vertices.front()) first = {at_x, at_y};
      // Doubles round only places of rings that are too large.
      const Vec<Coordinate> place{static_cast<Coordinate>(at_x - first.x),
                                  static_cast<Coordinate>(at_y - first.y)};
      if constexpr (!kWide) {
        // Of most rings that are too wide, the second vertex shows it.
        if (std::max(std::abs(place.x), std::abs(place.y)) > SmallOperand::kWidest) return false;
      }
      // The last of equal vertices stays, because the edge to the next vertex has its index.
      if (size != 0 && place == last) --size;
      last = place;
      low = {std::min(low.x, place.x), std::min(low.y, place.y)};
      high = {std::max(high.x, place.x), std::max(high.y, place.y)};
      if constexpr (kWide) {
        at_whole[size] = place;
      } else {
        x[size] = place.x;
        y[size] = place.y;
      }
      source[size++] = static_cast<double>(v);
    }
    const Vec<Integer> corner = plus(first, as_integer(low));
    if (!take_box(corner, minus(high, low), is_outer)) return false;
    if constexpr (!kLong) {
      if (is_outer && s_.outer_rings == 0) set(s_.first, first);
    }
    const auto is_first_again = [&](std::uint32_t i) {
      if constexpr (kWide) return at_whole[i] == at_whole[0];
      return x[i] == x[0] && y[i] == y[0];
    };
    while (size > 1 && is_first_again(size - 1)) --size;
    const Vec<Integer> by = minus(first, corner_);
    for (std::uint32_t i = 0; i < size; ++i) {
      if constexpr (kWide) {
        at_whole[i] = plus(at_whole[i], by);
        x[i] = to_near_double(at_whole[i].x);
        y[i] = to_near_double(at_whole[i].y);
      } else {
        x[i] += static_cast<double>(by.x);
        y[i] += static_cast<double>(by.y);
      }
    }
    return ring.finish(is_outer, size, to_near_double(Integer(corner.x - corner_.x)));
  }
  /// Takes the box of all outer rings, by its lower left corner. Returns false if it is too wide.
  [[nodiscard]] bool set_box(const Vec<Integer>& corner, const Vec<Coordinate>& extent) {
    corner_ = corner;
    outer_extent_ = extent;
    s_.extent = {to_double(extent.x), to_double(extent.y)};
    if constexpr (kLong) {
      s_.long_offset = corner;
      s_.long_extent = extent;
    } else {
      set(s_.offset, corner);
      set(s_.whole_extent, as_integer(extent));
    }
    return std::max(s_.extent.x, s_.extent.y) <= (kLong   ? SmallOperand::kWidestFine
                                                  : kWide ? SmallOperand::kWidestWide
                                                          : SmallOperand::kWidest);
  }
  /// Takes the box of a ring. Returns false if that of an outer one is too wide, or if that of a
  /// hole is not inside the box of the outer rings.
  [[nodiscard]] bool take_box(const Vec<Integer>& corner, const Vec<Coordinate>& extent,
                              bool is_outer) {
    const Vec<double> near{to_double(extent.x), to_double(extent.y)};
    if (is_outer) {
      if (!box_is_known_) {
        s_.least_extent = near;
        return set_box(corner, extent);
      }
      s_.least_extent = {std::min(s_.least_extent.x, near.x), std::min(s_.least_extent.y, near.y)};
      return true;
    }
    s_.holes.push_back(near);
    const auto is_inside = [](Integer from, Coordinate size_of_hole, Coordinate size_of_outer) {
      return from >= Integer(0) && static_cast<Coordinate>(from) + size_of_hole <= size_of_outer;
    };
    return is_inside(corner.x - corner_.x, extent.x, outer_extent_.x) &&
           is_inside(corner.y - corner_.y, extent.y, outer_extent_.y);
  }
  static Vec<Integer> as_integer(const Vec<Coordinate>& v) {
    return {static_cast<Integer>(v.x), static_cast<Integer>(v.y)};
  }
  static void set(Vec<Int128>& to, const Vec<Integer>& value) {
    // One number after the other: copying a vector that was just stored in parts takes long.
    to.x = value.x;
    to.y = value.y;
  }

  const Region& region_;
  SmallOperand& s_;
  Vec<Integer> corner_{};           ///< the lower left corner of the outer rings' box
  Vec<Coordinate> outer_extent_{};  ///< of that box
  bool box_is_known_ = false;
};

/// Loads the rings of several polygons.
template <class Integer>
[[gnu::noinline]] bool load_polygons(const Region& region, RingLoader<Integer>& loader) {
  if (!loader.take_common_box()) return false;
  for (const bool outer : {true, false}) {
    for (const std::size_t polygon : region.polygons()) {
      const IndexRange rings = region.rings_of(polygon);
      for (const std::size_t ring : rings) {
        if ((ring == rings.front()) == outer && !loader.add(ring, outer)) return false;
      }
    }
  }
  return true;
}

/// Loads all rings of a region. The operand's grid must be set. See RingLoader.
template <class Integer>
bool load_rings(const Region& region, SmallOperand& s) {
  RingLoader<Integer> loader(region, s);
  if (SmallOperand::kMayHaveSeveral && region.polygon_count() > 1) {
    if (!load_polygons(region, loader)) return false;
    find_smallest(s);
    return true;
  }
  for (std::size_t ring = 0; ring < region.ring_count(); ++ring) {
    if (!loader.add(ring, ring == 0)) return false;
  }
  return true;
}

}  // namespace minksum
