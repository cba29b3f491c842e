// Loads the rings of small operands as integers of any of three sizes.
#pragma once

#include <algorithm>
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
    s.longest = 0;
    s.turning_of_holes = 0;
    s.holes.clear();
    s.ends.clear();
  }

  /// Adds a ring, the outer one first, without repeated vertices. Returns false if coordinates are
  /// too long integers on the grid, if the box of a hole is not inside that of the outer ring, or
  /// if the ring has a spike or less than three vertices.
  bool add(std::size_t ring) {
    AddedRing<Coordinate> added(s_);
    const IndexRange vertices = region_.vertices_of(ring);
    return vertices.size() >= 3 && load(vertices, ring == 0, added);
  }

 private:
  using Coordinate = std::conditional_t<kWide, Integer, double>;

  /// Brings a coordinate to the grid. Returns false if it is not an integer there, or too long.
  [[nodiscard, gnu::always_inline]] bool take(const StoredCoordinate& c, int exp2, int exp10,
                                              Integer& value) const {
    value = Integer(c.payload);
    if constexpr (kWide) {
      if (c.denominator_limbs != 0 && !take_limbs(region_, c, value)) return false;
    }
    // The exponents of zero are of no matter.
    return value == Integer(0) || scale(c.exp10 - exp10, c.exp2 - exp2, value);
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
      if (is_outer) set(s_.first, first);
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
  /// Takes the box of a ring, by its lower left corner. Returns false if it is too wide, or if it
  /// is a hole's and not inside that of the outer ring.
  [[nodiscard]] bool take_box(const Vec<Integer>& corner, const Vec<Coordinate>& extent,
                              bool is_outer) {
    const Vec<double> near{to_double(extent.x), to_double(extent.y)};
    if (is_outer) {
      corner_ = corner;
      outer_extent_ = extent;
      s_.extent = near;
      if constexpr (kLong) {
        s_.long_offset = corner;
        s_.long_extent = extent;
      } else {
        set(s_.offset, corner);
        set(s_.whole_extent, as_integer(extent));
      }
      return std::max(near.x, near.y) <= (kLong   ? SmallOperand::kWidestFine
                                          : kWide ? SmallOperand::kWidestWide
                                                  : SmallOperand::kWidest);
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
  Vec<Integer> corner_{};           ///< the lower left corner of the outer ring's box
  Vec<Coordinate> outer_extent_{};  ///< of that box
};

/// Loads all rings of a region. The operand's grid must be set. See RingLoader.
template <class Integer>
bool load_rings(const Region& region, SmallOperand& s) {
  RingLoader<Integer> loader(region, s);
  for (std::size_t ring = 0; ring < region.ring_count(); ++ring) {
    if (!loader.add(ring)) return false;
  }
  return true;
}

}  // namespace minksum
