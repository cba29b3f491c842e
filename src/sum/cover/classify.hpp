// How segments lie to the four quarters of a cell: the inner loop of the division.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "machine/make_room.hpp"
#include "machine/vectors.hpp"

namespace minksum {

/// A segment of the signed convolution: where it starts, and its edge. The winding number is
/// greater by one on its left. Coordinates are integers of at most 24 bits: floats hold them and
/// their differences exactly.
struct alignas(16) RoundedSegment {
  float x;
  float y;
  float dx;
  float dy;
};

/// Lists of segments, one behind the other.
struct SegmentStack {
  std::vector<RoundedSegment> segment;
  std::vector<std::int32_t> id;    ///< in the reduced convolution, or negative
  std::vector<std::int32_t> mask;  ///< bit k: near quarter k; bit 4: unsure

  /// Lists start and end at multiples of this, filled up with segments that are near nothing.
  static constexpr std::size_t kStride = 8;
  static constexpr std::int32_t kUnsure = 16;

  void grow(std::size_t size, Cancellation& cancellation) {
    if (id.size() >= size) return;
    resize_in_pieces(segment, size, cancellation);
    resize_in_pieces(id, size, cancellation);
    resize_in_pieces(mask, size, cancellation);
  }
  /// Puts those of the entries [begin, end) that have this bit in their masks at `to` and on, and
  /// may write one more; where they end.
  std::size_t copy(std::size_t begin, std::size_t end, std::int32_t bit, std::size_t to);
  /// Fills up the list that ends at `end`; where the next may start.
  std::size_t fill_up(std::size_t end) {
    for (; end % kStride != 0; ++end) {
      segment[end] = {-0x1p26F, -0x1p26F, 0, 0};
      id[end] = -1;
    }
    return end;
  }
};

/// A cell under division: its centre and half its side. Integers, in units.
struct QuadCell {
  std::int64_t x;
  std::int64_t y;
  std::int64_t half;
};

/// The sums over a list, for one quarter.
struct Tally {
  std::int32_t near = 0;
  std::int32_t reduced = 0;   ///< of these, from the reduced convolution
  std::int32_t losing = 0;    ///< of these, such as may have the quarter's centre on their left
  std::int32_t doubtful = 0;  ///< of these, such as rounding may have moved over that centre
  std::int32_t winding = 0;   ///< the step of the winding number from the cell's centre to that one
};

/// Quarter k is the right one if k & 1, the upper one if k & 2. Sets the masks of the entries
/// [begin, end): segments within `margin` of a quarter count as near to it.
///
/// In floats: r, the way from an end to the centre, is exact, and so are edges times a power of
/// two. A determinant is off by five roundings, at most, of terms whose sizes sum up to B: by less
/// than B · 2^-21. Signs that this cannot tell, and segments within two units of a centre, are
/// *unsure*, and looked at again in integers. What decides nothing exact errs on the safe side.
std::array<Tally, 4> classify(const QuadCell& cell, std::int64_t margin, std::size_t begin,
                              std::size_t end, Vectors vectors, Cancellation& cancellation,
                              SegmentStack& stack);

/// What entry i adds to the winding number of the cell's centre if it crosses the ray from there to
/// the right.
[[nodiscard]] std::int32_t winding_step_along_ray(const QuadCell& cell, std::size_t i,
                                                  const SegmentStack& stack);

}  // namespace minksum
