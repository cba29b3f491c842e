// Operands of a few vertices with short coordinates.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "minksum/region.hpp"
#include "predicate/formulas.hpp"

namespace minksum {

/// An operand of one ring of a few vertices, counter-clockwise, whose coordinates are short
/// integers: in arrays that vectors are loaded from. Edge i starts at vertex i.
struct SmallOperand {
  static constexpr std::size_t kMaxVertices = 32;
  /// Of the box of a sum: cross products of differences are integers that doubles hold.
  static constexpr int kMaxBits = 26;
  /// Arrays are filled up with zeros to a multiple of this.
  static constexpr std::size_t kLanes = 8;
  using Row = std::array<double, kMaxVertices>;

  std::uint32_t size = 0;
  std::uint32_t smallest = 0;  ///< the lexicographically smallest vertex
  bool convex = false;
  Vec<double> extent{};        ///< of the box, which is at (0, 0)
  Vec<std::int64_t> offset{};  ///< where the box is
  Vec<std::int64_t> first{};   ///< the first vertex of the region that it was read from
  int exp2 = 0;                ///< a step of the grid: 2^exp2 · 10^exp10
  int exp10 = 0;
  alignas(64) Row x;
  alignas(64) Row y;
  alignas(64) Row dx;
  alignas(64) Row dy;
  /// The edges before and after each convex vertex; zeros for reflex ones.
  alignas(64) Row in_x;
  alignas(64) Row in_y;
  alignas(64) Row out_x;
  alignas(64) Row out_y;
  std::array<std::uint32_t, kMaxVertices> vertex_source;  ///< vertex index in the region
  std::array<std::uint32_t, kMaxVertices> edge_source;    ///< edge index in the region
};

/// A set of vertices, or of segments.
using SmallMask = std::uint64_t;

alignas(64) inline constexpr auto kBitOf = [] {
  std::array<SmallMask, 64> bits{};
  for (std::size_t i = 0; i < bits.size(); ++i) bits[i] = SmallMask{1} << i;
  return bits;
}();
[[nodiscard]] constexpr SmallMask first_bits(std::size_t count) {
  return count == 64 ? ~SmallMask{0} : (SmallMask{1} << count) - 1;
}

/// How many entries of its arrays are filled.
[[nodiscard]] constexpr std::size_t filled_up(std::size_t size) {
  return (size + SmallOperand::kLanes - 1) / SmallOperand::kLanes * SmallOperand::kLanes;
}

/// Whether a region is such an operand, and legal; fills `small` if so. What is not clearly one is
/// not: faults are left to `validate`. O(n²) for n vertices, with a small constant.
bool read_small(const Region& region, SmallOperand& small);

/// The operand turned counter-clockwise by so many times 90 degrees, about the origin.
void turn(const SmallOperand& from, int quarters, SmallOperand& to);

/// The operand on the finer grid of these exponents; false if it does not fit.
bool refine(int exp2, int exp10, SmallOperand& operand);

}  // namespace minksum
