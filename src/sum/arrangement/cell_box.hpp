// Boxes within a cell of the grid, kept so short that one subtraction compares two of them.
#pragma once

#include <algorithm>
#include <cstdint>

namespace minksum {

/// A box relative to a cell, rounded outwards to 2^-13 of the cell. One word holds four numbers of
/// 15 bits, each in a field of 16 bits: x0, y0, kMost − x1, kMost − y1.
///
/// Two boxes overlap if and only if each field of one is at most that field of the other's
/// `partner`. That compares x0, y0 with the other's x1, y1, and kMost − x1, kMost − y1 with its
/// kMost − x0, kMost − y0. The partner's fields have their free top bits set. So one subtraction of
/// words compares all four fields, without a borrow from field to field. A top bit stays if and
/// only if the partner's field is not smaller.
class CellBox {
 public:
  CellBox() = default;
  /// Takes coordinates in cells, from the cell's lower left corner. They are cut off farther than
  /// kReach from the cell, so the box holds the given box's part within kReach of the cell.
  CellBox(double x0, double y0, double x1, double y1)
      : word_(low(x0) | low(y0) << 16 | (kMost - high(x1)) << 32 | (kMost - high(y1)) << 48) {}

  static constexpr double kUnit = 0x1p-13;
  static constexpr double kReach = 0x1p-4;

  /// Returns the word that `overlaps` compares with. (Exchanging the halves of the box's word gives
  /// kMost − x1, kMost − y1, x0, y0.)
  [[nodiscard]] std::uint64_t partner() const {
    return (kMost * kOnes - (word_ << 32 | word_ >> 32)) | kTops;
  }
  /// Whether the box overlaps or touches the box that has this partner.
  [[nodiscard]] bool overlaps(std::uint64_t partner) const {
    return ((partner - word_) & kTops) == kTops;
  }
  /// Returns the lowest x, in units.
  [[nodiscard]] std::uint32_t left() const { return static_cast<std::uint32_t>(word_ & kMost); }
  /// Returns the highest x, in units.
  [[nodiscard]] std::uint32_t right() const {
    return static_cast<std::uint32_t>(kMost - (word_ >> 32 & kMost));
  }
  /// Returns the intersection with a box that this one overlaps.
  [[nodiscard]] CellBox within(const CellBox& other) const {
    CellBox result;
    for (int shift = 0; shift < 64; shift += 16) {
      result.word_ |= std::max(word_ >> shift & kMost, other.word_ >> shift & kMost) << shift;
    }
    return result;
  }

 private:
  static constexpr std::uint64_t kMost = 0x7FFF;
  static constexpr std::uint64_t kOnes = 0x0001'0001'0001'0001;
  static constexpr std::uint64_t kTops = 0x8000 * kOnes;

  // Truncation rounds down. The given values were rounded, too, by less than 4 ·
  // UniformGrid::kSlack. One more unit outwards makes up for that.
  static std::uint64_t low(double value) { return units(value) - 1; }
  static std::uint64_t high(double value) { return units(value) + 2; }
  static std::uint64_t units(double value) {
    const double inside = std::min(std::max(value, -kReach), 1 + kReach);
    return static_cast<std::uint64_t>(static_cast<std::int32_t>((inside + 2 * kReach) / kUnit));
  }

  std::uint64_t word_ = 0;
};

}  // namespace minksum
