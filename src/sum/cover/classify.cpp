#include "sum/cover/classify.hpp"

#include <algorithm>
#include <cmath>

namespace minksum {
namespace {

/// For each quarter, one word with four sums of a byte each: near, losing, reduced, winding.
using Packed = std::array<std::int32_t, 4>;
/// A number of entries that signed bytes can count.
constexpr std::size_t kBlock = 120;
static_assert(kBlock % SegmentStack::kStride == 0);

struct Frame {
  float x;
  float y;
  float half;  ///< half a quarter's side
  float margin;
};

// The loop has no branches, so that the compiler turns it into vector code.
[[gnu::always_inline]] inline std::int32_t classify_block(
    const Frame& c, std::size_t count, const RoundedSegment* __restrict segment,
    const std::int32_t* __restrict id, std::int32_t* __restrict mask, Packed& sums) {
  const float reach = c.half + c.margin;
  const float doubt_here = 5 * c.half + 8;
  std::int32_t unsure_any = 0;
  std::int32_t s0 = 0;
  std::int32_t s1 = 0;
  std::int32_t s2 = 0;
  std::int32_t s3 = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const float dx = segment[i].dx;
    const float dy = segment[i].dy;
    const float rx = c.x - segment[i].x;
    const float ry = c.y - segment[i].y;
    const float ex = rx - dx;
    const float ey = ry - dy;
    const float left = dx * ry;
    const float right = dy * rx;
    const float cross = left - right;
    const float length = std::abs(dx) + std::abs(dy);
    const float error = (std::abs(left) + std::abs(right) + length * c.half) * 0x1p-21F;
    const float near = length * reach + error;
    const float doubt =
        -(1.25F * length + 2.5F * (std::abs(rx) + std::abs(ry)) + doubt_here + error);
    const float close = 2 * length + error;
    const std::int32_t to_right = std::min(rx, ex) <= c.margin;
    const std::int32_t to_left = std::max(rx, ex) >= -c.margin;
    const std::int32_t up = std::min(ry, ey) <= c.margin;
    const std::int32_t down = std::max(ry, ey) >= -c.margin;
    // `rising` and `falling` tell whether a line through the centres parts the segment's two ends.
    const float rising_start = rx - ry;
    const float rising_end = ex - ey;
    const float falling_start = rx + ry;
    const float falling_end = ex + ey;
    const std::int32_t rising = (rising_start > 0) ^ (rising_end > 0);
    const std::int32_t falling = (falling_start > 0) ^ (falling_end > 0);
    std::int32_t unsure = (rising_start == 0) | (rising_end == 0) | (falling_start == 0) |
                          (falling_end == 0) | (std::abs(cross) <= error);
    const std::int32_t before = cross > 0;
    const float difference = (dx - dy) * c.half;
    const float sum = (dx + dy) * c.half;
    const float cross0 = cross - difference;
    const float cross1 = cross - sum;
    const float cross2 = cross + sum;
    const float cross3 = cross + difference;
    const std::int32_t near0 = (std::abs(cross0) <= near) & to_left & down;
    const std::int32_t near1 = (std::abs(cross1) <= near) & to_right & down;
    const std::int32_t near2 = (std::abs(cross2) <= near) & to_left & up;
    const std::int32_t near3 = (std::abs(cross3) <= near) & to_right & up;
    unsure |= ((std::abs(cross0) <= close) & near0) | ((std::abs(cross1) <= close) & near1) |
              ((std::abs(cross2) <= close) & near2) | ((std::abs(cross3) <= close) & near3);
    const std::int32_t sure = unsure ^ 1;
    const std::int32_t after0 = cross0 > 0;
    const std::int32_t after1 = cross1 > 0;
    const std::int32_t after2 = cross2 > 0;
    const std::int32_t after3 = cross3 > 0;
    const std::int32_t step0 = (after0 - before) * (near0 & rising & sure);
    const std::int32_t step1 = (after1 - before) * (near1 & falling & sure);
    const std::int32_t step2 = (after2 - before) * (near2 & falling & sure);
    const std::int32_t step3 = (after3 - before) * (near3 & rising & sure);
    const std::int32_t counted = (id[i] >= 0 ? 0x10001 : 1);
    s0 += (-near0 & counted) + ((near0 & (cross0 >= doubt)) << 8) + step0 * (1 << 24);
    s1 += (-near1 & counted) + ((near1 & (cross1 >= doubt)) << 8) + step1 * (1 << 24);
    s2 += (-near2 & counted) + ((near2 & (cross2 >= doubt)) << 8) + step2 * (1 << 24);
    s3 += (-near3 & counted) + ((near3 & (cross3 >= doubt)) << 8) + step3 * (1 << 24);
    const std::int32_t any = near0 | near1 | near2 | near3;
    unsure &= any;
    mask[i] = near0 | (near1 << 1) | (near2 << 2) | (near3 << 3) | (unsure << 4);
    unsure_any |= unsure;
  }
  sums = {s0, s1, s2, s3};
  return unsure_any;
}

std::int64_t magnitude(std::int64_t x) { return x < 0 ? -x : x; }

/// A segment, and the way from its start to a quarter's centre.
struct Exact {
  std::int64_t dx;
  std::int64_t dy;
  std::int64_t rx;
  std::int64_t ry;
  Exact(const RoundedSegment& s, std::int64_t x, std::int64_t y)
      : dx(static_cast<std::int64_t>(s.dx)), dy(static_cast<std::int64_t>(s.dy)),
        rx(x - static_cast<std::int64_t>(s.x)), ry(y - static_cast<std::int64_t>(s.y)) {}
  [[nodiscard]] std::int64_t cross() const { return dx * ry - dy * rx; }
  /// Whether the centre, moved by (ε, ε²), is on the segment's left. `determinant` is that of the
  /// centre itself.
  [[nodiscard]] bool left_of(std::int64_t determinant) const {
    if (determinant != 0) return determinant > 0;
    return dy != 0 ? dy < 0 : dx > 0;
  }
  /// Returns the step of the winding number on the way to the centre from the point (right, up) ·
  /// half before it.
  [[nodiscard]] std::int32_t step(std::int64_t half, int right, int up) const {
    const bool after = left_of(cross());
    if (left_of(cross() - (dx * up - dy * right) * half) == after) return 0;
    // Tells on which side of the way's line a point lies. The line is moved as the centre is.
    const auto side = [&](std::int64_t x, std::int64_t y) {
      const std::int64_t value = y * right - x * up;
      return value != 0 ? value > 0 : up < 0;
    };
    if (side(rx, ry) == side(rx - dx, ry - dy)) return 0;
    return after ? 1 : -1;
  }
  /// Whether the segment may be within a unit of the centre, in x and y.
  [[nodiscard]] bool is_doubtful() const {
    constexpr std::int64_t kNear = 2;
    return magnitude(cross()) <= kNear * (magnitude(dx) + magnitude(dy)) &&
           std::max(rx, rx - dx) >= -kNear && std::min(rx, rx - dx) <= kNear &&
           std::max(ry, ry - dy) >= -kNear && std::min(ry, ry - dy) <= kNear;
  }
};

/// Decides in integers the segments of which `classify_block` was unsure, and counts them.
void decide_exactly(const QuadCell& cell, std::size_t begin, std::size_t end,
                    const SegmentStack& stack, std::array<Tally, 4>& tallies) {
  const std::int64_t half = cell.half / 2;
  for (std::size_t i = begin; i < end; ++i) {
    if ((stack.mask[i] & SegmentStack::kUnsure) == 0) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      if ((stack.mask[i] >> k & 1) == 0) continue;
      const int right = (k & 1) != 0 ? 1 : -1;
      const int up = (k & 2) != 0 ? 1 : -1;
      const Exact s(stack.segment[i], cell.x + right * half, cell.y + up * half);
      tallies[k].winding += s.step(half, right, up);
      tallies[k].doubtful += s.is_doubtful() ? 1 : 0;
    }
  }
}

}  // namespace

std::size_t SegmentStack::copy(std::size_t begin, std::size_t end, std::int32_t bit,
                               std::size_t to) {
  RoundedSegment* const segments = segment.data();
  std::int32_t* const number = id.data();
  const std::int32_t* const near = mask.data();
  // Every entry is written, but only some are kept. That leaves no branch to predict.
  for (std::size_t i = begin; i < end; ++i) {
    segments[to] = segments[i];
    number[to] = number[i];
    to += (near[i] & bit) != 0 ? 1U : 0U;
  }
  return to;
}

std::int32_t winding_step_along_ray(const QuadCell& cell, std::size_t i,
                                    const SegmentStack& stack) {
  const Exact s(stack.segment[i], cell.x, cell.y);
  const bool start_below = s.ry >= 0;
  const bool end_below = s.ry - s.dy >= 0;
  if (start_below == end_below) return 0;
  const bool left = s.left_of(s.cross());
  if (start_below) return left ? 1 : 0;
  return left ? 0 : -1;
}

std::array<Tally, 4> classify(const QuadCell& cell, std::int64_t margin, std::size_t begin,
                              std::size_t end, Vectors vectors, Cancellation& cancellation,
                              SegmentStack& stack) {
  std::array<Tally, 4> tallies{};
  const Frame frame{static_cast<float>(cell.x), static_cast<float>(cell.y),
                    static_cast<float>(cell.half / 2), static_cast<float>(margin)};
  for (std::size_t i = begin; i < end; i += kBlock) {
    Packed sums;
    const std::size_t count = std::min(kBlock, end - i);
    cancellation.check(count);
    const std::int32_t unsure = with_vectors(vectors, [&]() __attribute__((always_inline)) {
      return classify_block(frame, count, stack.segment.data() + i, stack.id.data() + i,
                            stack.mask.data() + i, sums);
    });
    for (std::size_t k = 0; k < 4; ++k) {
      tallies[k].near += sums[k] & 0xFF;
      tallies[k].losing += (sums[k] >> 8) & 0xFF;
      tallies[k].reduced += (sums[k] >> 16) & 0xFF;
      tallies[k].winding += sums[k] >> 24;
    }
    if (unsure != 0) decide_exactly(cell, i, i + count, stack, tallies);
  }
  return tallies;
}

}  // namespace minksum
