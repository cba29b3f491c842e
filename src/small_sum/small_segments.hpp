// The reduced convolution of two small operands, and where its segments lie to one another.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "small_sum/small_operand.hpp"

namespace minksum {

inline constexpr std::size_t kMaxSmallSegments = 64;

template <class Visit>
[[gnu::always_inline]] inline void for_each_bit(SmallMask mask, Visit visit) {
  for (; mask != 0; mask &= mask - 1) visit(static_cast<std::uint32_t>(std::countr_zero(mask)));
}

/// An edge of one operand, moved by a vertex of the other.
struct SmallOrigin {
  std::uint8_t edge;
  std::uint8_t vertex;
};

/// All numbers are integers of so few bits that every product and sum is exact.
struct SmallSegments {
  using Row = std::array<double, kMaxSmallSegments>;
  std::uint32_t size = 0;
  std::uint32_t first_size = 0;  ///< how many are edges of the first operand
  alignas(64) Row x;
  alignas(64) Row y;
  alignas(64) Row dx;
  alignas(64) Row dy;
  std::array<SmallOrigin, kMaxSmallSegments> origin;

  [[nodiscard]] SmallMask all() const { return first_bits(size); }
};

/// The vertices that meet an edge of this direction: in (in, out], or [in, out).
[[gnu::always_inline]] inline SmallMask vertices_meeting(const SmallOperand& o, double ex,
                                                         double ey, bool with_out) {
  SmallMask mask = 0;
  const std::size_t n = filled_up(o.size);
  for (std::size_t v = 0; v < n; ++v) {
    const double after_in = o.in_x[v] * ey - o.in_y[v] * ex;
    const double before_out = ex * o.out_y[v] - ey * o.out_x[v];
    const bool meets =
        with_out ? (after_in > 0) & (before_out >= 0) : (after_in >= 0) & (before_out > 0);
    mask |= meets ? kBitOf[v] : 0;
  }
  return mask;
}

[[gnu::always_inline]] inline bool list_segments(const SmallOperand& edges,
                                                 const SmallOperand& vertices, bool with_out,
                                                 SmallSegments& s) {
  for (std::uint32_t e = 0; e < edges.size; ++e) {
    const double ex = edges.dx[e];
    const double ey = edges.dy[e];
    const SmallMask mask = vertices_meeting(vertices, ex, ey, with_out);
    if (s.size + static_cast<std::uint32_t>(std::popcount(mask)) > kMaxSmallSegments) return false;
    for_each_bit(mask, [&](std::uint32_t v) {
      s.x[s.size] = edges.x[e] + vertices.x[v];
      s.y[s.size] = edges.y[e] + vertices.y[v];
      s.dx[s.size] = ex;
      s.dy[s.size] = ey;
      s.origin[s.size] = {static_cast<std::uint8_t>(e), static_cast<std::uint8_t>(v)};
      ++s.size;
    });
  }
  return true;
}

/// The reduced convolution; false if there are too many.
[[gnu::always_inline]] inline bool list_segments(const SmallOperand& p, const SmallOperand& q,
                                                 SmallSegments& s) {
  s.size = 0;
  if (!list_segments(p, q, true, s)) return false;
  s.first_size = s.size;
  if (!list_segments(q, p, false, s)) return false;
  for (std::size_t i = s.size; i < filled_up(s.size); ++i) {
    s.x[i] = s.y[i] = s.dx[i] = s.dy[i] = 0;
  }
  return true;
}

/// Which start here.
[[gnu::always_inline]] inline SmallMask starting_at(const SmallSegments& s, double x, double y) {
  SmallMask mask = 0;
  const std::size_t n = filled_up(s.size);
  for (std::size_t t = 0; t < n; ++t) mask |= (s.x[t] == x) & (s.y[t] == y) ? kBitOf[t] : 0;
  return mask & s.all();
}

/// By segments, whom each meets on its way and may be left for.
struct SmallMeetings {
  using Masks = std::array<SmallMask, kMaxSmallSegments>;
  Masks right;   ///< from a point behind its start, leading to its right
  Masks at_end;  ///< at its end: leading to its left, on its line, or ending there, too
  unsigned right_count = 0;
};

[[gnu::always_inline]] inline void find_meetings(const SmallSegments& s, SmallMeetings& m) {
  const std::size_t n = filled_up(s.size);
  const SmallMask all = s.all();
  m.right_count = 0;
  for (std::uint32_t of = 0; of < s.size; ++of) {
    const double x = s.x[of];
    const double y = s.y[of];
    const double dx = s.dx[of];
    const double dy = s.dy[of];
    SmallMask right = 0;
    SmallMask at_end = 0;
    for (std::size_t t = 0; t < n; ++t) {
      const double ax = s.x[t] - x;
      const double ay = s.y[t] - y;
      const double start = dx * ay - dy * ax;            // how far t starts on the left
      const double turn = dx * s.dy[t] - dy * s.dx[t];   // and how much farther it ends there
      const double end = start + turn;
      const double along = ax * s.dy[t] - ay * s.dx[t];  // they meet at along / turn of the way
      const bool to_right = (start >= 0) & (end < 0) & (along < 0) & (along >= turn);
      const bool ends = (along == turn) & (start <= 0) & (end >= 0);
      right |= to_right ? kBitOf[t] : 0;
      at_end |= ends ? kBitOf[t] : 0;
    }
    m.right[of] = right & all;
    m.at_end[of] = at_end & all & ~kBitOf[of];
    m.right_count += static_cast<unsigned>(std::popcount(right & all));
  }
}

}  // namespace minksum
