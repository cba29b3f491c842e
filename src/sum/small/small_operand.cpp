#include "sum/small/small_operand.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "exact/sign.hpp"
#include "region/region_access.hpp"
#include "sum/small/small_grid.hpp"

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

/// Returns all ones if a cross product is positive, and zero otherwise.
std::uint64_t turns_left(double cross) {
  return static_cast<std::uint64_t>(std::bit_cast<std::int64_t>(0.0 - cross) >> 63U);
}

bool is_same(const Vec<Int128>& a, const Vec<Int128>& b) { return a.x == b.x && a.y == b.y; }

/// Returns in which eighth of the circle a vector lies, counter-clockwise. Of the eighths' borders,
/// those of the axes and diagonals, each belongs to one of them.
int eighth_of(const Vec<double>& d) {
  static constexpr std::array<int, 8> kEighths{0, 1, 7, 6, 3, 2, 4, 5};
  const std::uint64_t left = std::bit_cast<std::uint64_t>(d.x) >> 63U << 2U;
  const std::uint64_t down = std::bit_cast<std::uint64_t>(d.y) >> 63U << 1U;
  const std::uint64_t steep = std::abs(d.y) >= std::abs(d.x) ? 1 : 0;
  return kEighths[left | down | steep];
}

/// Returns the lexicographically smallest of the entries from `begin` to before `end`, of which
/// `left` is the smallest x.
std::uint32_t smallest_of(const SmallOperand& s, std::uint32_t begin, std::uint32_t end,
                          double left) {
  const double* const x = s[SmallOperand::kX];
  const double* const y = s[SmallOperand::kY];
  const Vec<Int128>* const whole = s.whole(SmallOperand::kAt);
  std::uint32_t smallest = end;
  for (std::uint32_t i = begin; i < end; ++i) {
    // Rounding keeps the order of numbers that it does not make equal.
    if (x[i] != left) continue;
    const auto is_less = [&](std::uint32_t j) {
      if (whole == nullptr) return y[i] < y[j];
      return whole[i].x != whole[j].x ? whole[i].x < whole[j].x : whole[i].y < whole[j].y;
    };
    if (smallest == end || is_less(smallest)) smallest = i;
  }
  return smallest;
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

  /// Adds a ring, the outer one first. Drops repeated vertices, and those in the middle of straight
  /// edges. Turns the ring so that the region is on its left. Returns false if coordinates are too
  /// long integers on the grid, if the box of a hole is not inside that of the outer ring, or if
  /// the ring has a spike or less than three vertices.
  bool add(std::size_t ring) {
    begin_ = static_cast<std::uint32_t>(filled_up(s_.entries));
    const bool is_outer = ring == 0;
    const IndexRange vertices = region_.vertices_of(ring);
    if (vertices.size() < 3 || !load(vertices, is_outer) || !orient(is_outer)) return false;
    Bends bends = set_bends();
    if (!bends.turn_all) {
      if (!drop_straight()) return false;
      bends = set_bends();
    }
    set_edge_sources();
    fill_up();
    s_.entries = begin_ + size_;
    s_.longest = std::max(s_.longest, bends.longest);
    if (is_outer) {
      s_.size = size_;
      s_.smallest = smallest_;
      s_.convex = bends.convex;
      s_.turning = bends.turning;
    } else {
      s_.ends.push_back(s_.entries);
      s_.turning_of_holes += bends.turning;
    }
    return true;
  }

 private:
  using Vector = std::conditional_t<kWide, SureVec<Int128>, Vec<double>>;

  [[nodiscard]] double* row(SmallOperand::Row at) const { return s_[at] + begin_; }
  [[nodiscard]] Vec<Int128>* whole(SmallOperand::WholeRow at) const {
    return s_.whole(at) + begin_;
  }
  /// Returns the way between two of the ring's vertices.
  [[nodiscard]] Vector way(std::uint32_t from, std::uint32_t to) const {
    if constexpr (kWide) {
      const Vec<Int128> way = minus(whole(SmallOperand::kAt)[to], whole(SmallOperand::kAt)[from]);
      return {rounded(way), way};
    } else {
      const double* const x = row(SmallOperand::kX);
      const double* const y = row(SmallOperand::kY);
      return {x[to] - x[from], y[to] - y[from]};
    }
  }
  [[nodiscard]] std::uint32_t before(std::uint32_t i) const { return (i == 0 ? size_ : i) - 1; }
  [[nodiscard]] std::uint32_t after(std::uint32_t i) const { return i + 1 == size_ ? 0 : i + 1; }
  /// Positive if the ring turns left from one edge to the next one.
  [[nodiscard, gnu::always_inline]] double turn(const Vector& in, const Vector& out) const {
    if constexpr (kWide) {
      return SureLanes<Int128>{{0x1p-48 * std::max(s_.extent.x, s_.extent.y)}}.turn(in, out);
    } else {
      const double turn = cross(in, out);  // its sign is exact, unless it is zero
      using Lanes = SureLanes<std::uint64_t>;
      return turn == 0 ? Lanes{}.turn(Lanes::of_whole(in), Lanes::of_whole(out)) : turn;
    }
  }

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

  /// Loads the places of a ring's vertices.
  [[nodiscard]] bool load(const IndexRange& vertices, bool is_outer) {
    double* const x = row(SmallOperand::kX);
    double* const y = row(SmallOperand::kY);
    double* const source = row(SmallOperand::kVertexSource);
    Vec<Int128>* const at_whole = whole(SmallOperand::kAt);
    const int exp2 = s_.exp2;
    const int exp10 = s_.exp10;
    Vec<Integer> first{};
    Vec<Integer> last{};
    Vec<Integer> low{};
    Vec<Integer> high{};
    std::uint32_t size = 0;
    for (const std::size_t v : vertices) {
      Vec<Integer> at;
      if (!take(RegionAccess::x(region_, v), exp2, exp10, at.x) ||
          !take(RegionAccess::y(region_, v), exp2, exp10, at.y)) {
        return false;
      }
      if (size == 0) {
        first = low = high = at;
      } else if (at.x == last.x && at.y == last.y) {
        --size;  // the last of equal vertices stays, because the edge to the next has its index
      }
      last = at;
      low = {std::min(low.x, at.x), std::min(low.y, at.y)};
      high = {std::max(high.x, at.x), std::max(high.y, at.y)};
      // Places are seen from the first vertex, until the box is known.
      if constexpr (kWide) {
        at_whole[size] = minus(at, first);
      } else {
        x[size] = static_cast<double>(at.x - first.x);
        y[size] = static_cast<double>(at.y - first.y);
      }
      source[size++] = static_cast<double>(v);
    }
    size_ = size;
    const Vec<Integer> extent = minus(high, low);
    const Vec<double> near_extent{static_cast<double>(extent.x), static_cast<double>(extent.y)};
    if (is_outer) {
      constexpr double kWidest = kWide ? SmallOperand::kWidestWide : SmallOperand::kWidest;
      if (std::max(near_extent.x, near_extent.y) > kWidest) return false;
      corner_ = low;
      outer_extent_ = extent;
      s_.extent = near_extent;
      set(s_.first, first);
      set(s_.offset, low);
      set(s_.whole_extent, extent);
    } else {
      if (low.x < corner_.x || high.x - corner_.x > outer_extent_.x) return false;
      if (low.y < corner_.y || high.y - corner_.y > outer_extent_.y) return false;
      s_.holes.push_back(near_extent);
    }
    left_ = static_cast<double>(low.x - corner_.x);
    move_by(minus(first, corner_));
    const auto is_first_again = [&](std::uint32_t i) {
      if constexpr (kWide) return is_same(at_whole[i], at_whole[0]);
      return x[i] == x[0] && y[i] == y[0];
    };
    while (size_ > 1 && is_first_again(size_ - 1)) --size_;
    return size_ >= 3;
  }
  static void set(Vec<Int128>& to, const Vec<Integer>& value) {
    // One number after the other: copying a vector that was just stored in parts takes long.
    to.x = value.x;
    to.y = value.y;
  }
  void move_by(const Vec<Integer>& by) {
    double* const x = row(SmallOperand::kX);
    double* const y = row(SmallOperand::kY);
    for (std::uint32_t i = 0; i < size_; ++i) {
      if constexpr (kWide) {
        Vec<Int128>& at = whole(SmallOperand::kAt)[i];
        at = plus(at, by);
        x[i] = static_cast<double>(at.x);
        y[i] = static_cast<double>(at.y);
      } else {
        x[i] += static_cast<double>(by.x);
        y[i] += static_cast<double>(by.y);
      }
    }
  }

  /// Turns the ring so that it runs counter-clockwise or clockwise. Returns false if the smallest
  /// vertex is the tip of a spike.
  [[nodiscard]] bool orient(bool counter_clockwise) {
    smallest_ = smallest_of(s_, begin_, begin_ + size_, left_) - begin_;
    const double turn_there =
        turn(way(before(smallest_), smallest_), way(smallest_, after(smallest_)));
    reversed_ = turn_there > 0 != counter_clockwise;
    if (!reversed_) return turn_there != 0;
    const auto reverse = [this](auto* values) { std::reverse(values, values + size_); };
    reverse(row(SmallOperand::kX));
    reverse(row(SmallOperand::kY));
    reverse(row(SmallOperand::kVertexSource));
    if constexpr (kWide) reverse(whole(SmallOperand::kAt));
    smallest_ = size_ - 1 - smallest_;
    return turn_there != 0;
  }
  void set_edge_sources() {
    const double* const source = row(SmallOperand::kVertexSource);
    // In a reversed ring, the edge that starts here is the one that started at the next vertex.
    std::rotate_copy(source, source + (reversed_ ? 1 : 0), source + size_,
                     row(SmallOperand::kEdgeSource));
  }

  struct Bends {
    bool turn_all;  ///< whether the ring turns at each vertex
    bool convex;
    double turning;
    double longest;
  };
  /// Sets the edges, which follow from the places.
  Bends set_bends() {
    double* const dx = row(SmallOperand::kDx);
    double* const dy = row(SmallOperand::kDy);
    double* const in_x = row(SmallOperand::kInX);
    double* const in_y = row(SmallOperand::kInY);
    double* const out_x = row(SmallOperand::kOutX);
    double* const out_y = row(SmallOperand::kOutY);
    bool turn_all = true;
    std::uint64_t all_convex = ~std::uint64_t{0};
    double longest = 0;
    int meetings = 0;
    Vector in = way(size_ - 1, 0);
    int eighth = eighth_of(near_of(in));
    for (std::uint32_t i = 0; i < size_; ++i) {
      const Vector out = way(i, after(i));
      const double turned = turn(in, out);
      // All ones or none keep the loop free of branches.
      const std::uint64_t convex = turns_left(turned);
      const auto if_convex = [convex](double value) {
        return std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) & convex);
      };
      const Vec<double>& near_in = near_of(in);
      const Vec<double>& near_out = near_of(out);
      const int last = std::exchange(eighth, eighth_of(near_out));
      meetings += static_cast<int>(static_cast<std::uint64_t>(eighth - last) & convex & 7U);
      turn_all &= turned != 0;
      all_convex &= convex;
      longest = std::max({longest, std::abs(near_out.x), std::abs(near_out.y)});
      dx[i] = near_out.x;
      dy[i] = near_out.y;
      in_x[i] = if_convex(near_in.x);
      in_y[i] = if_convex(near_in.y);
      out_x[i] = if_convex(near_out.x);
      out_y[i] = if_convex(near_out.y);
      if constexpr (kWide) {
        whole(SmallOperand::kIn)[i] = in.exact;
        whole(SmallOperand::kWay)[i] = out.exact;
      }
      in = out;
    }
    return {turn_all, all_convex != 0, meetings / 8.0, longest};
  }

  /// Drops vertices in the middle of straight edges. Returns false if a vertex is the tip of a
  /// spike.
  [[nodiscard]] bool drop_straight() {
    std::uint32_t kept = 0;
    Vector in = way(size_ - 1, 0);
    const Vector last = in;
    for (std::uint32_t i = 0; i < size_; ++i) {
      const Vector out = i + 1 == size_ ? last : way(i, i + 1);
      if (i == smallest_) smallest_ = kept;
      if (turn(in, out) != 0) {
        for (const auto at : {SmallOperand::kX, SmallOperand::kY, SmallOperand::kVertexSource}) {
          row(at)[kept] = row(at)[i];
        }
        if constexpr (kWide) whole(SmallOperand::kAt)[kept] = whole(SmallOperand::kAt)[i];
        ++kept;
      } else if (dot(near_of(in), near_of(out)) < 0) {
        return false;
      }
      in = out;
    }
    size_ = kept;
    return kept >= 3;
  }

  /// Fills the rows up, so that they can be read eight entries at a time.
  void fill_up() {
    double* const x = row(SmallOperand::kX);
    double* const y = row(SmallOperand::kY);
    const auto end = static_cast<std::uint32_t>(filled_up(size_));
    for (std::uint32_t i = size_; i < end; ++i) {
      x[i] = x[0];
      y[i] = y[0];
      for (const auto at : {SmallOperand::kDx, SmallOperand::kDy, SmallOperand::kInX,
                            SmallOperand::kInY, SmallOperand::kOutX, SmallOperand::kOutY}) {
        row(at)[i] = 0;
      }
      if constexpr (kWide) {
        whole(SmallOperand::kAt)[i] = whole(SmallOperand::kAt)[0];
        whole(SmallOperand::kWay)[i] = whole(SmallOperand::kIn)[i] = {};
      }
    }
  }

  const Region& region_;
  SmallOperand& s_;
  Vec<Integer> corner_{};        ///< the lower left corner of the outer ring's box
  Vec<Integer> outer_extent_{};  ///< of that box
  std::uint32_t begin_ = 0;      ///< of the ring's entries
  std::uint32_t size_ = 0;
  std::uint32_t smallest_ = 0;
  bool reversed_ = false;
  double left_ = 0;  ///< the smallest x of its vertices
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
