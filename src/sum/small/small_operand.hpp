// Operands of few polygons with not too long coordinates and not too many vertices.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "exact/formulas.hpp"
#include "exact/wide_int.hpp"
#include "minksum/region.hpp"
#include "spatial/box.hpp"
#include "sum/small/lanes.hpp"
#include "sum/small/sides.hpp"

namespace minksum {

/// An operand whose coordinates are integers. Arrays hold the outer rings of its polygons,
/// counter-clockwise, so that vectors can be loaded from them. The rings of holes follow,
/// clockwise. Each ring starts at a multiple of eight. Edge i starts at vertex i. Entries between
/// rings are edges of length zero. If doubles do not hold the coordinates, the operand is wide: the
/// doubles are rounded, and another array holds the integers. If these have more than 125 bits, the
/// wide operand is long.
///
/// On a finer grid than its own, each coordinate is that on its own grid times a number of steps.
/// Doubles hold or round the product. If they round it, it is not computed until it is needed.
class SmallOperand {
 public:
  static constexpr std::size_t kMaxVertices = std::size_t{1} << 16;
  /// The most holes of a single polygon, so that a word has a bit for each ring.
  static constexpr std::size_t kMaxHoles = 63;
  /// The most rings of several polygons. Up to seven entries lie between two rings.
  static constexpr std::size_t kMaxRings = 4096;
  static constexpr std::size_t kMaxEntries = kMaxVertices + 7 * kMaxRings;
  /// The largest extent of a box, unless the operand is wide. Doubles hold twice the sum of two
  /// points of it.
  static constexpr double kWidest = 0x1p49;
  /// The largest extent of a wide operand's box on its own grid, unless it is long, and of any box
  /// on a finer grid.
  static constexpr double kWidestWide = 0x1p125;
  static constexpr double kWidestFine = 0x1p250;

  /// The properties of each vertex. Each property has an array. Entries behind a ring are its first
  /// vertex again, with zeros for all edges.
  enum Row : std::uint8_t {
    kX,
    kY,
    kDx,
    kDy,
    // The edges before and after a convex vertex; zeros for a reflex one.
    kInX,
    kInY,
    kOutX,
    kOutY,
    // Indices in the region.
    kVertexSource,
    kEdgeSource,
    kRows
  };

  std::uint32_t size = 0;         ///< of the outer rings: where the last one of them ends
  std::uint32_t outer_rings = 0;  ///< as many as there are polygons
  std::uint32_t smallest = 0;     ///< the lexicographically smallest vertex
  bool convex = false;            ///< whether it is one polygon, and its outer ring is convex
  /// How many convex vertices of outer rings are compatible with an edge, on average over eight
  /// directions. If all vertices are convex, this is how often the rings go round.
  double turning = 1;
  double turning_of_holes = 0;
  /// The number of entries that all rings take; `size` where holes are left out.
  std::uint32_t entries = 0;
  Vec<double> extent{};             ///< extent of the box, whose lower left corner is (0, 0)
  Vec<double> least_extent{};       ///< the least width and height of its polygons' boxes
  Vec<Int128> whole_extent{};       ///< the same in units of `steps`, not rounded
  std::vector<Vec<double>> holes;   ///< extents of the holes' boxes
  std::vector<std::uint32_t> ends;  ///< of the rings: of all outer ones, and of the holes
  double longest = 0;               ///< longest extent of an edge along an axis
  Vec<Int128> offset{};             ///< place of the box in the region, in units of `steps`
  Vec<Int128> first{};              ///< the first vertex of the region that it was read from
  int exp2 = 0;                     ///< a step of the grid: 2^exp2 · 10^exp10
  int exp10 = 0;
  /// How many steps of the grid a unit of whole numbers has: 1 unless doubles round the products.
  Int128 steps = 1;
  double units = 1;  ///< 1 / steps
  // Extent and offset of a long operand. Then those above have no meaning.
  Vec<WideNumber> long_extent{};
  Vec<WideNumber> long_offset{};

  /// Makes room for rows of so many vertices. Values must be set before they are read.
  void make_rows(std::size_t vertices, bool is_wide, bool is_long) {
    stride_ = filled_up(vertices);
    rows_.resize(kRows * stride_);
    whole_.resize(is_wide && !is_long ? stride_ : 0);
    is_long_ = is_long;
    if (is_long) long_.resize(stride_);
  }
  [[nodiscard]] bool is_wide() const { return !whole_.empty() || is_long(); }
  /// Whether small operands may be long. The module for browsers has no room for that code: there,
  /// the stages take such operands.
#if defined(__wasm__)
  static constexpr bool kMayBeLong = false;
#else
  static constexpr bool kMayBeLong = true;
#endif
  /// Whether they may have several polygons. The same holds for these.
  static constexpr bool kMayHaveSeveral = kMayBeLong;
  [[nodiscard]] bool has_several() const { return kMayHaveSeveral && outer_rings > 1; }
  /// Whether the integers have more than 125 bits.
  [[nodiscard]] bool is_long() const { return kMayBeLong && is_long_; }
  /// Sets the first entries of all properties but the sources to multiples of those of another one,
  /// which may be the same.
  void set_multiples(const SmallOperand& from, std::size_t count, double factor) {
    const auto set = [factor](const double* values, std::size_t many, double* products) {
      for (std::size_t i = 0; i < many; ++i) products[i] = values[i] * factor;
    };
    if (from.stride_ == stride_) {
      return set(from.rows_.data(), kVertexSource * stride_, rows_.data());
    }
    for (std::size_t row = 0; row < kVertexSource; ++row) {
      set(from.rows_.data() + row * from.stride_, count, rows_.data() + row * stride_);
    }
  }
  [[nodiscard]] double* operator[](Row row) { return rows_.data() + row * stride_; }
  [[nodiscard]] const double* operator[](Row row) const { return rows_.data() + row * stride_; }

  /// Returns the vertices of a wide operand, in units of `steps`: those of a long one are
  /// WideNumber.
  template <class Integer = Int128>
  [[nodiscard]] auto& whole() {
    return whole_of<Integer>(*this);
  }
  template <class Integer = Int128>
  [[nodiscard]] const auto& whole() const {
    return whole_of<Integer>(*this);
  }
  /// The same of any operand that is not long.
  [[nodiscard]] Vec<Int128> whole_at(std::size_t i) const {
    return is_wide() ? whole_[i] : whole_vector({(*this)[kX][i], (*this)[kY][i]});
  }
  /// Returns a vector as integers in units of `steps`, if doubles hold these. Multiplied by
  /// `units`, what doubles round is off by less than half a unit.
  [[nodiscard]] Vec<Int128> whole_vector(const Vec<double>& near) const {
    const auto whole = [this](double value) {
      const double number = value * units;
      return Int128{static_cast<std::int64_t>(number + (number < 0 ? -0.5 : 0.5))};
    };
    return {whole(near.x), whole(near.y)};
  }
  /// Returns the vector whose x is in this row: a vertex or an edge, but no edge before or after a
  /// reflex vertex.
  template <class Integer>
  [[nodiscard]] Vec<Integer> exact(int row, std::size_t i) const;
  /// Returns the extent and the offset on the operand's grid.
  template <class Integer>
  [[nodiscard]] Vec<Integer> exact_extent() const {
    return multiple<Integer>(whole_extent, long_extent);
  }
  template <class Integer>
  [[nodiscard]] Vec<Integer> exact_offset() const {
    return multiple<Integer>(offset, long_offset);
  }
  // Parts of `refine` and `turn` for long operands.
  void copy_long(const SmallOperand& from);
  void turn_long();
  /// Returns the largest coordinate of a long operand's box or its offset, rounded.
  [[nodiscard]] double long_reach() const;

  [[nodiscard]] VecRow at() const { return row(kX); }
  [[nodiscard]] VecRow way() const { return row(kDx); }
  [[nodiscard]] VecRow in() const { return row(kInX); }
  [[nodiscard]] VecRow out() const { return row(kOutX); }

  /// Whether both have one outer ring, the same vertex by vertex.
  [[nodiscard]] bool has_ring_of(const SmallOperand& other) const;

  /// The vertices at which an edge starts and ends.
  struct Ends {
    std::uint32_t from;
    std::uint32_t to;
  };
  /// Returns the ends of the edge before or after a vertex. For an entry between rings, both are
  /// the same. O(log rings).
  [[nodiscard]] Ends ends_of(bool before, std::uint32_t i) const;
  /// Returns the first vertex of a ring.
  [[nodiscard]] std::uint32_t begin_of(std::size_t ring) const {
    return ring == 0 ? 0 : static_cast<std::uint32_t>(filled_up(ends[ring - 1]));
  }
  /// Returns the ring that an edge belongs to, or before which an entry lies.
  [[nodiscard]] std::size_t ring_of(std::uint32_t edge) const {
    return static_cast<std::size_t>(std::upper_bound(ends.begin(), ends.end(), edge) -
                                    ends.begin());
  }

 private:
  [[nodiscard]] VecRow row(Row x) const {
    return {(*this)[x], (*this)[static_cast<Row>(x + 1)], this, x};
  }
  template <class Integer, class Self>
  [[nodiscard]] static auto& whole_of(Self& self) {
    if constexpr (std::is_same_v<Integer, Int128>) {
      return self.whole_;
    } else {
      return self.long_;
    }
  }
  /// Returns the product with `steps` of the one that is in use.
  template <class Integer>
  [[nodiscard]] Vec<Integer> multiple(const Vec<Int128>& v, const Vec<WideNumber>& if_long) const {
    if (is_long()) return as<Integer>(long_multiple(if_long));
    if (steps == 1) return {Integer(v.x), Integer(v.y)};
    return {product<Integer>(v.x, steps), product<Integer>(v.y, steps)};
  }
  /// Returns a vector that is known to fit.
  template <class Integer>
  [[nodiscard]] static Vec<Integer> as(const Vec<WideNumber>& v) {
    if constexpr (std::is_same_v<Integer, Int128>) {
      return {v.x.to_int128(), v.y.to_int128()};
    } else {
      return v;
    }
  }
  [[nodiscard]] Vec<WideNumber> long_multiple(const Vec<WideNumber>& v) const;
  [[nodiscard]] Vec<WideNumber> long_exact(int row, std::size_t i) const;

  std::size_t stride_ = 0;
  std::vector<double> rows_;
  std::vector<Vec<Int128>> whole_;
  bool is_long_ = false;
  std::vector<Vec<WideNumber>> long_;
};

template <class Integer>
Vec<Integer> VecRow::exact(std::size_t i) const {
  return operand->exact<Integer>(property, i);
}

/// How the cross products of edges with each other, and with differences of points of a box, are
/// computed.
enum class SmallNumberType : std::uint8_t { kDoubles, kRounded, kWide, kNone };

[[nodiscard]] inline SmallNumberType small_numbers(bool wide, double longest, double width) {
  if (wide || width > SmallOperand::kWidest) {
    return width <= SmallOperand::kWidestFine ? SmallNumberType::kWide : SmallNumberType::kNone;
  }
  // A cross product is at most twice this.
  return longest * width <= 0x1p52 ? SmallNumberType::kDoubles : SmallNumberType::kRounded;
}
/// Calls work(numbers) for this type, which is not kNone, and coordinates up to `width`. `Wide`
/// holds those of a wide operand.
template <class Wide, class Work>
auto with_numbers(SmallNumberType type, double width, Work work) {
  if (type == SmallNumberType::kDoubles) return work(SmallNumbers<double>{});
  if (type == SmallNumberType::kRounded) return work(SmallNumbers<std::uint64_t>{});
  return work(SmallNumbers<Wide>{reach_of(width)});
}

class SmallBlocks;

/// Fills `small` and returns true if a region is clearly small and valid. Faults of other regions
/// are left to `validate`. O(n²) for n vertices, with a small constant: for each block of eight
/// edges it looks at one box for each 512 edges.
bool read_small(const Region& region, SmallOperand& small);
/// The two steps of that. The first one loads all rings, also of some regions that are not valid.
/// It returns false if the region is not small, or if a ring cannot be valid.
bool load_small(const Region& region, SmallOperand& small);
[[nodiscard]] bool is_clearly_valid(const SmallOperand& small, SmallBlocks& memory);
/// The same of a long operand.
bool load_long(const Region& region, SmallOperand& small);
[[nodiscard]] bool is_long_valid(const SmallOperand& small, SmallBlocks& memory);
/// Tells in constant time whether `load_small` is worth while.
[[nodiscard]] bool has_small_size(const Region& region);

/// Sets the smallest vertex of all outer rings.
void find_smallest(SmallOperand& operand);
/// Sets the ring of each entry, and the smallest vertex of each outer ring.
void find_rings(const SmallOperand& operand, std::vector<std::uint32_t>& ring_of,
                std::vector<std::uint32_t>& smallest);

/// Turns an operand counter-clockwise by `quarters` times 90 degrees about the origin.
void turn(const SmallOperand& from, int quarters, SmallOperand& to);

/// How an operand fits on a finer grid.
struct Refinement {
  double steps = 0;  ///< how many of the grid's one of its steps has; 0 if it does not fit there
  bool rounded = false;  ///< whether doubles round its coordinates there
};
[[nodiscard]] Refinement finer_grid(int exp2, int exp10, const SmallOperand& operand);
[[nodiscard]] inline Refinement refinement(int exp2, int exp10, const SmallOperand& operand) {
  const bool same = operand.exp2 == exp2 && operand.exp10 == exp10;
  return same ? Refinement{1, operand.is_wide()} : finer_grid(exp2, exp10, operand);
}
/// Copies the first entries of an operand, all or those of the outer ring, from its own grid to the
/// finer one of these exponents, on which it must fit. Both operands may be the same.
void refine(int exp2, int exp10, std::uint32_t entries, const SmallOperand& from, SmallOperand& to);

}  // namespace minksum
