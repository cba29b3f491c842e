#include "sum/small/small_operand.hpp"

#include <algorithm>
#include <limits>
#include <type_traits>

#include "region/region_access.hpp"
#include "sum/small/added_ring.hpp"

namespace minksum {
namespace {

/// Sets the exponents to the smallest in use. Returns false if all coordinates are zero.
bool find_grid(const Region& region, SmallOperand& s) {
  constexpr int kNone = std::numeric_limits<int>::max();
  int exp2 = kNone;
  int exp10 = kNone;
  const auto add = [&](const StoredCoordinate& c) {
    const bool is_zero = (c.payload == 0) & (c.denominator_limbs == 0);
    exp2 = std::min<int>(exp2, is_zero ? kNone : c.exp2);
    exp10 = std::min<int>(exp10, is_zero ? kNone : c.exp10);
  };
  const std::size_t count = region.vertex_count();
  for (std::size_t v = 0; v < count; ++v) {
    add(RegionAccess::x(region, v));
    add(RegionAccess::y(region, v));
  }
  s.exp2 = exp2;
  s.exp10 = exp10;
  s.steps = 1;
  s.units = 1;
  return exp2 != kNone;
}

/// Sets `value` to the numerator of a coordinate that has limbs. Returns false if it is too long,
/// or if there is a denominator.
bool take_limbs(const Region& region, const StoredCoordinate& c, Int128& value) {
  const auto limbs = RegionAccess::limbs(region).subspan(static_cast<std::size_t>(c.payload));
  const std::size_t count = c.numerator_limbs & kLimbCountMask;
  if (count > 2 || c.denominator_limbs != 1 || limbs[count] != 1) return false;
  const std::uint64_t high = count == 2 ? limbs[1] : 0;
  if (high >> 62U != 0) return false;
  value = static_cast<Int128>(high) << 64U | (count > 0 ? limbs[0] : 0);
  if ((c.numerator_limbs & kNegativeLimbs) != 0) value = -value;
  return true;
}

/// Adds the rings of a region to an operand whose grid is set. With Int128 as the integer type, the
/// operand is wide.
template <class Integer>
class RingLoader {
  static constexpr bool kWide = std::is_same_v<Integer, Int128>;

 public:
  RingLoader(const Region& region, SmallOperand& s) : region_(region), s_(s) {
    s.make_rows(region.vertex_count() + (kLanes - 1) * region.ring_count(), kWide);
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
    AddedRing<kWide> added(s_);
    const IndexRange vertices = region_.vertices_of(ring);
    return vertices.size() >= 3 && load(vertices, ring == 0, added);
  }

 private:
  using Coordinate = std::conditional_t<kWide, Int128, double>;

  /// Brings a coordinate to the grid. Returns false if it is not an integer there, or too long.
  [[nodiscard, gnu::always_inline]] bool take(const StoredCoordinate& c, int exp2, int exp10,
                                              Integer& value) const {
    value = c.payload;
    if constexpr (kWide) {
      if (c.denominator_limbs != 0 && !take_limbs(region_, c, value)) return false;
    }
    // The exponents of zero are of no matter.
    return value == 0 || scale(c.exp10 - exp10, c.exp2 - exp2, value);
  }

  [[nodiscard]] bool load(const IndexRange& vertices, bool is_outer, AddedRing<kWide>& ring) {
    double* const x = ring.row(SmallOperand::kX);
    double* const y = ring.row(SmallOperand::kY);
    double* const source = ring.row(SmallOperand::kVertexSource);
    Vec<Int128>* const at_whole = ring.whole();
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
    if (is_outer) set(s_.first, first);
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
    return ring.finish(is_outer, size, to_near_double(corner.x - corner_.x));
  }
  /// Takes the box of a ring, by its lower left corner. Returns false if it is too wide, or if it
  /// is a hole's and not inside that of the outer ring.
  [[nodiscard]] bool take_box(const Vec<Integer>& corner, const Vec<Coordinate>& extent,
                              bool is_outer) {
    const Vec<double> near{static_cast<double>(extent.x), static_cast<double>(extent.y)};
    if (is_outer) {
      corner_ = corner;
      outer_extent_ = extent;
      s_.extent = near;
      set(s_.offset, corner);
      set(s_.whole_extent, as_integer(extent));
      return std::max(near.x, near.y) <=
             (kWide ? SmallOperand::kWidestWide : SmallOperand::kWidest);
    }
    s_.holes.push_back(near);
    const auto is_inside = [](Integer from, Coordinate size_of_hole, Coordinate size_of_outer) {
      return from >= 0 && static_cast<Coordinate>(from) + size_of_hole <= size_of_outer;
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

template <class Integer>
bool load(const Region& region, SmallOperand& s) {
  RingLoader<Integer> loader(region, s);
  for (std::size_t ring = 0; ring < region.ring_count(); ++ring) {
    if (!loader.add(ring)) return false;
  }
  return true;
}

}  // namespace

template <class Integer>
Vec<Integer> SmallOperand::exact(int row, std::size_t i) const {
  Vec<Int128> value{};
  if (row == kX) {
    value = whole_at(i);
  } else if (is_wide()) {
    const auto [from, to] = ends_of(row == kInX, static_cast<std::uint32_t>(i));
    value = minus(whole_[to], whole_[from]);
  } else {
    value =
        whole_vector({(*this)[static_cast<Row>(row)][i], (*this)[static_cast<Row>(row + 1)][i]});
  }
  if (steps == 1) return {Integer(value.x), Integer(value.y)};
  return {product<Integer>(value.x, steps), product<Integer>(value.y, steps)};
}
template Vec<Int128> SmallOperand::exact(int, std::size_t) const;
template Vec<WideNumber> SmallOperand::exact(int, std::size_t) const;

SmallOperand::Ends SmallOperand::ends_of(bool before, std::uint32_t i) const {
  std::uint32_t begin = 0;
  std::uint32_t end = size;
  for (auto ring = ends.begin(); i >= end && ring != ends.end(); ++ring) {
    begin = static_cast<std::uint32_t>(filled_up(end));
    end = *ring;
  }
  if (i < begin || i >= end) return {i, i};
  if (before) return {(i == begin ? end : i) - 1, i};
  return {i, i + 1 == end ? begin : i + 1};
}

bool SmallOperand::has_ring_of(const SmallOperand& other) const {
  if (size != other.size) return false;
  for (std::size_t i = 0; i < size; ++i) {
    if (exact<WideNumber>(kX, i) != other.exact<WideNumber>(kX, i)) return false;
  }
  return true;
}

void find_smallest(SmallOperand& s) { s.smallest = smallest_of(s, 0, s.size, 0); }

bool has_small_size(const Region& region) {
  return region.polygon_count() == 1 && region.ring_count() <= 1 + SmallOperand::kMaxHoles &&
         region.vertex_count() <= SmallOperand::kMaxVertices;
}

bool load_small(const Region& region, SmallOperand& s) {
  if (!has_small_size(region) || !find_grid(region, s)) return false;
  const bool has_limbs = !RegionAccess::limbs(region).empty();
  return (!has_limbs && load<std::int64_t>(region, s)) || load<Int128>(region, s);
}

}  // namespace minksum
