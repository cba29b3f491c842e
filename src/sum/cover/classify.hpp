// Classifies segments by the four quarters of a cell: the inner loop of the division.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "machine/make_room.hpp"
#include "machine/vectors.hpp"

namespace minksum {

/// A segment of the signed convolution: its start and its vector. The winding number is greater by
/// one on the segment's left. Coordinates are integers of at most 24 bits, so floats hold them and
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
  std::vector<std::int32_t> id;    ///< index in the reduced convolution, or negative
  std::vector<std::int32_t> mask;  ///< bit k: near quarter k; bit 4: unsure

  /// Lists start and end at multiples of kStride. Segments that are near nothing fill lists up.
  static constexpr std::size_t kStride = 8;
  static constexpr std::int32_t kUnsure = 16;

  void grow(std::size_t size, Cancellation& cancellation) {
    if (id.size() >= size) return;
    resize_in_pieces(segment, size, cancellation);
    resize_in_pieces(id, size, cancellation);
    resize_in_pieces(mask, size, cancellation);
  }
  /// Copies those of the entries [begin, end) whose masks have `bit` to `to` and on. Returns where
  /// the copies end. May write one entry more.
  std::size_t copy(std::size_t begin, std::size_t end, std::int32_t bit, std::size_t to);
  /// Fills up the list that ends at `end`. Returns where the next list may start.
  std::size_t fill_up(std::size_t end) {
    for (; end % kStride != 0; ++end) {
      segment[end] = {-0x1p26F, -0x1p26F, 0, 0};
      id[end] = -1;
    }
    return end;
  }
};

/// A cell under division: its centre and half its side, in integer units.
struct QuadCell {
  std::int64_t x;
  std::int64_t y;
  std::int64_t half;
};

/// The counts that `classify` makes of a list, for one quarter.
struct Tally {
  std::int32_t near = 0;
  std::int32_t reduced = 0;   ///< near segments that are in the reduced convolution
  std::int32_t losing = 0;    ///< near segments that may have the quarter's centre on their left
  std::int32_t doubtful = 0;  ///< near segments that rounding may have moved over that centre
  std::int32_t winding = 0;   ///< change of the winding number from the cell's centre to that one
};

/// Counts the entries [begin, end) for each quarter, and sets their masks. Quarter k is on the
/// right if k & 1, and above if k & 2. Segments within `margin` of a quarter are near it.
///
/// Floats hold the way r from an end to the centre exactly, and so they do edges times a power of
/// two. A determinant is off by at most five roundings of terms whose sizes sum up to B, so by less
/// than B · 2^-21. If this error leaves a sign open, or if a segment is within two units of a
/// centre, the segment is *unsure*. It is decided again in integers. Counts that need not be exact
/// err on the safe side.
std::array<Tally, 4> classify(const QuadCell& cell, std::int64_t margin, std::size_t begin,
                              std::size_t end, Vectors vectors, Cancellation& cancellation,
                              SegmentStack& stack);

/// Returns what entry i adds to the winding number of the cell's centre. The entry adds something
/// if it crosses the ray from the centre to the right.
[[nodiscard]] std::int32_t winding_step_along_ray(const QuadCell& cell, std::size_t i,
                                                  const SegmentStack& stack);

}  // namespace minksum
