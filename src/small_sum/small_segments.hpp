// The reduced convolution of two small operands.
#pragma once

#include "small_sum/blocks.hpp"
#include "small_sum/small_operand.hpp"

namespace minksum {

/// All numbers are integers. `Number`, below, holds all cross products of their differences.
struct SmallSegments {
  static constexpr std::size_t kMax = kLanes * SmallBlocks::kMax;
  using Row = std::array<double, kMax>;
  /// An edge of one operand, moved by a vertex of the other.
  struct Origin {
    std::uint16_t edge;
    std::uint16_t vertex;
    bool of_first;  ///< whose edge it is
  };

  std::uint32_t size;
  alignas(64) Row x;
  alignas(64) Row y;
  alignas(64) Row dx;
  alignas(64) Row dy;
  std::array<Origin, kMax> origin;
};

/// Of up to 64 vertices, those that meet an edge of this direction: in (in, out].
template <class Number>
[[gnu::always_inline]] inline LaneBits vertices_meeting(const SmallOperand& o, std::size_t first,
                                                        std::size_t count, Number dx, Number dy) {
  const double* const in_x = o[SmallOperand::kInX] + first;
  const double* const in_y = o[SmallOperand::kInY] + first;
  const double* const out_x = o[SmallOperand::kOutX] + first;
  const double* const out_y = o[SmallOperand::kOutY] + first;
  LaneBits bits = 0;
  const auto number = [](double d) { return static_cast<Number>(d); };
  for (std::size_t v = 0; v < count / kLanes * kLanes; ++v) {
    const bool meets = (number(in_x[v]) * dy - number(in_y[v]) * dx > 0) &
                       (dx * number(out_y[v]) - dy * number(out_x[v]) >= 0);
    bits |= meets ? kBitOf[v] : 0;
  }
  return bits;
}
/// Of up to 64 edges, those whose direction is in [in, out).
template <class Number>
[[gnu::always_inline]] inline LaneBits edges_between(const SmallOperand& o, std::size_t first,
                                                     std::size_t count, const Vec<Number>& in,
                                                     const Vec<Number>& out) {
  const double* const dx = o[SmallOperand::kDx] + first;
  const double* const dy = o[SmallOperand::kDy] + first;
  LaneBits bits = 0;
  for (std::size_t e = 0; e < count / kLanes * kLanes; ++e) {
    const auto ex = static_cast<Number>(dx[e]);
    const auto ey = static_cast<Number>(dy[e]);
    const bool between = (in.x * ey - in.y * ex >= 0) & (ex * out.y - ey * out.x > 0);
    bits |= between ? kBitOf[e] : 0;
  }
  return bits;
}

/// The reduced convolution, in the order of the first operand's ring: what is near in the plane is
/// mostly near in the list. False if there are too many.
template <class Number>
[[gnu::always_inline]] inline bool list_segments(const SmallOperand& p, const SmallOperand& q,
                                                 SmallSegments& s) {
  const std::size_t n = filled_up(q.size);
  std::uint32_t size = 0;
  struct Rows {
    const double* x;
    const double* y;
    const double* dx;
    const double* dy;
    explicit Rows(const SmallOperand& o)
        : x(o[SmallOperand::kX]),
          y(o[SmallOperand::kY]),
          dx(o[SmallOperand::kDx]),
          dy(o[SmallOperand::kDy]) {}
  };
  const Rows of_p(p);
  const Rows of_q(q);
  const auto append = [&](const Rows& edges, std::size_t e, const Rows& vertices, std::size_t v,
                          bool of_first) __attribute__((always_inline)) {
    s.x[size] = edges.x[e] + vertices.x[v];
    s.y[size] = edges.y[e] + vertices.y[v];
    s.dx[size] = edges.dx[e];
    s.dy[size] = edges.dy[e];
    s.origin[size] = {static_cast<std::uint16_t>(e), static_cast<std::uint16_t>(v), of_first};
    ++size;
  };
  const auto fit = [&](LaneBits bits) {
    return size + static_cast<std::uint32_t>(std::popcount(bits)) <= SmallSegments::kMax;
  };
  for (std::uint32_t i = 0; i < p.size; ++i) {
    const auto number = [&](SmallOperand::Row row) { return static_cast<Number>(p[row][i]); };
    const Vec<Number> in{number(SmallOperand::kInX), number(SmallOperand::kInY)};
    const Vec<Number> out{number(SmallOperand::kOutX), number(SmallOperand::kOutY)};
    const Number dx = number(SmallOperand::kDx);
    const Number dy = number(SmallOperand::kDy);
    for (std::size_t first = 0; first < n; first += 64) {
      const std::size_t count = std::min<std::size_t>(n - first, 64);
      const LaneBits at_vertex =
          in.x == 0 && in.y == 0 ? 0 : edges_between(q, first, count, in, out);
      if (!fit(at_vertex)) return false;
      for_each_bit(at_vertex, [&](std::uint32_t e) { append(of_q, first + e, of_p, i, false); });
      const LaneBits of_edge = vertices_meeting(q, first, count, dx, dy);
      if (!fit(of_edge)) return false;
      for_each_bit(of_edge, [&](std::uint32_t v) { append(of_p, i, of_q, first + v, true); });
    }
  }
  s.size = size;
  for (std::size_t i = size; i < filled_up(size); ++i) s.x[i] = s.y[i] = s.dx[i] = s.dy[i] = 0;
  return true;
}

}  // namespace minksum
