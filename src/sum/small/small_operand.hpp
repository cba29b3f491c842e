// Operands of one polygon with short coordinates and not too many vertices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "exact/formulas.hpp"
#include "exact/wide_int.hpp"
#include "minksum/region.hpp"
#include "spatial/box.hpp"
#include "sum/small/lanes.hpp"

namespace minksum {

/// An operand of one polygon whose coordinates are short integers. Arrays hold its outer ring,
/// counter-clockwise, so that vectors can be loaded from them. The rings of holes follow,
/// clockwise, each from a multiple of eight on. Edge i starts at vertex i. Entries between rings
/// are edges of length zero.
class SmallOperand {
 public:
  /// All blocks of eight edges are compared. A ring of 4,000 vertices is still validated in 0.7 of
  /// the time that the stages take for that.
  static constexpr std::size_t kMaxVertices = 4096;
  static constexpr std::size_t kMaxHoles = 32;
  /// Up to seven entries lie between two rings.
  static constexpr std::size_t kMaxEntries = 4352;
  static_assert(kMaxVertices + 7 * (kMaxHoles + 1) <= kMaxEntries);
  /// The largest extent of a box. Doubles hold twice the sum of two points of it.
  static constexpr double kWidest = 0x1p49;

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

  std::uint32_t size = 0;      ///< of the outer ring
  std::uint32_t smallest = 0;  ///< the lexicographically smallest vertex
  bool convex = false;
  /// The number of convex vertices that meet an edge, on average over eight directions. If all
  /// vertices are convex, this is how often the ring goes round.
  double turning = 1;
  double turning_of_holes = 0;
  /// The number of entries that all rings take; `size` if those of the holes are not loaded.
  std::uint32_t entries = 0;
  Vec<double> extent{};            ///< extent of the box, whose lower left corner is (0, 0)
  std::vector<Vec<double>> holes;  ///< extents of the holes' boxes
  double longest = 0;              ///< longest extent of an edge along an axis
  Vec<std::int64_t> offset{};      ///< place of the box in the region
  Vec<std::int64_t> first{};       ///< the first vertex of the region that it was read from
  int exp2 = 0;                    ///< a step of the grid: 2^exp2 · 10^exp10
  int exp10 = 0;

  /// Makes room for rows of so many vertices. Values must be set before they are read.
  void make_rows(std::size_t vertices) {
    stride_ = filled_up(vertices);
    rows_.resize(kRows * stride_);
  }
  /// Returns the index in the region of a vertex, or of the edge that starts there.
  [[nodiscard]] std::uint32_t source(Row row, std::uint32_t vertex) const {
    return static_cast<std::uint32_t>((*this)[row][vertex]);
  }
  [[nodiscard]] double* operator[](Row row) { return rows_.data() + row * stride_; }
  [[nodiscard]] const double* operator[](Row row) const { return rows_.data() + row * stride_; }

 private:
  std::size_t stride_ = 0;
  std::vector<double> rows_;
};

/// The vertices and edges of a small operand, or of one of its rings.
struct SmallRows {
  const double* x;
  const double* y;
  const double* dx;
  const double* dy;
  explicit SmallRows(const SmallOperand& o, std::uint32_t begin = 0)
      : x(o[SmallOperand::kX] + begin),
        y(o[SmallOperand::kY] + begin),
        dx(o[SmallOperand::kDx] + begin),
        dy(o[SmallOperand::kDy] + begin) {}
};

/// How the cross products of edges with each other, and with differences of points of a box, are
/// computed: in doubles that hold them, or in doubles that round them and, where these do not tell
/// the sign, in integers of 128 bits.
enum class SmallNumberType : std::uint8_t { kDoubles, kRounded, kNone };

[[nodiscard]] inline SmallNumberType small_numbers(double longest, double width) {
  // A cross product is at most twice this.
  if (longest * width <= 0x1p52) return SmallNumberType::kDoubles;
  return width <= SmallOperand::kWidest ? SmallNumberType::kRounded : SmallNumberType::kNone;
}
/// Calls work() with the number type as its template argument.
template <class Work>
auto with_numbers(SmallNumberType type, Work work) {
  return type == SmallNumberType::kDoubles ? work.template operator()<double>()
                                           : work.template operator()<Int128>();
}

/// The holes of an operand while it is validated. The memory is kept from operand to operand.
struct SmallHoles {
  std::vector<SmallOperand> rings;
  std::vector<BoxOf<double>> boxes;
};

/// Fills `small` and returns true if a region is clearly small and valid. Faults of other regions
/// are left to `validate`. O(n²) for n vertices, with a small constant.
bool read_small(const Region& region, SmallHoles& holes, SmallOperand& small);
/// The two steps of that, for a caller who can tell in between that no small sum will follow. The
/// first one loads the outer ring alone, and the second one adds the holes'.
bool load_small(const Region& region, SmallOperand& small);
bool is_clearly_valid(const Region& region, SmallHoles& holes, SmallOperand& small);
/// Loads all rings of a region that is known to be valid.
bool load_valid(const Region& region, SmallOperand& small);
/// Tells in constant time whether `load_small` is worth while.
[[nodiscard]] bool has_small_size(const Region& region);

/// Loads the ring of a hole. Returns false if it is not clearly one: if it has a spike, or
/// coordinates that are too long.
bool load_hole(const Region& region, std::size_t ring, const SmallOperand& small,
               SmallOperand& hole);
/// Turns the ring of a hole clockwise, and adds it to its operand.
void add_hole(SmallOperand& hole, SmallOperand& small);

/// Turns an operand counter-clockwise by `quarters` times 90 degrees about the origin.
void turn(const SmallOperand& from, int quarters, SmallOperand& to);

/// Returns how many steps of the finer grid of these exponents one of the operand's steps has, or 0
/// if the operand does not fit on that grid.
[[nodiscard]] double refinement(int exp2, int exp10, const SmallOperand& operand);
/// Copies the first entries of an operand, all or those of the outer ring, to the finer grid of
/// these exponents. Returns false if it does not fit there. Both may be the same.
bool refine(int exp2, int exp10, std::uint32_t entries, const SmallOperand& from, SmallOperand& to);

}  // namespace minksum
