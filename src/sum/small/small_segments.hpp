// Lists the reduced convolution of two small operands.
#pragma once

#include <tuple>
#include <utility>

#include "sum/small/blocks.hpp"
#include "sum/small/sides.hpp"
#include "sum/small/small_operand.hpp"

namespace minksum {

/// The segments of a small sum. All numbers are integers. The type `Number` in the functions below
/// holds all cross products of their differences. If that is not `double`, doubles may round them.
struct SmallSegments {
  static constexpr std::size_t kMaxBlocks = 192;
  static constexpr std::size_t kMax = kLanes * kMaxBlocks;
  using Blocks = SmallBlocks<kMaxBlocks>;
  /// Rows are longer than kMax, so that entries of the same index lie in different places of a
  /// page. Then a store to one row does not hold up loads from another.
  using Row = std::array<double, kMax + 128>;
  /// An edge of one operand, moved by a vertex of the other.
  struct Origin {
    std::uint16_t edge;
    std::uint16_t vertex;
    bool of_first;  ///< whether the edge is the first operand's
  };

  std::uint32_t size;
  alignas(64) Row x;
  alignas(64) Row y;
  alignas(64) Row dx;
  alignas(64) Row dy;
  std::array<Origin, kMax> origin;
  Blocks blocks;

  /// Returns those of a block's eight entries that are segments.
  [[nodiscard]] LaneBits lanes_of(std::size_t block) const {
    return first_bits(std::min<std::size_t>(size - block * kLanes, kLanes));
  }
  /// Returns those of a block's eight entries whose boxes meet `box`.
  [[nodiscard, gnu::always_inline]] LaneBits near(std::size_t block,
                                                  const BoxOf<double>& box) const {
    const std::size_t first = block * kLanes;
    return segments_near(&x[first], &y[first], &dx[first], &dy[first], box);
  }
  /// Whether segment i was listed before segment j. Segments are listed by vertices of the first
  /// ring.
  [[nodiscard]] bool is_before(std::uint32_t i, std::uint32_t j) const {
    const auto place = [this](std::uint32_t k) {
      const Origin& o = origin[k];
      return o.of_first ? std::tuple(o.edge, true, o.vertex) : std::tuple(o.vertex, false, o.edge);
    };
    return place(i) < place(j);
  }
  /// Must be called when all segments are listed. Fills up the rows, so that they can be read eight
  /// entries at a time.
  [[gnu::always_inline]] void finish() {
    for (std::size_t i = size; i < filled_up(size); ++i) x[i] = y[i] = dx[i] = dy[i] = 0;
    blocks.set(x.data(), y.data(), dx.data(), dy.data(), size);
  }
  /// Whether far more blocks are near one another than need be. A block of segments that are listed
  /// in a good order has about three near ones, with itself. Ordering takes as long as comparing
  /// ten pairs of blocks.
  [[nodiscard, gnu::always_inline]] bool is_out_of_order() const {
    std::size_t left = 3 * blocks.size + 10;
    if (blocks.size * (blocks.size + 1) / 2 <= left) return false;
    for (std::size_t i = 0; i < blocks.size; ++i) {
      for (std::size_t first = i / kLanes * kLanes; first < blocks.size; first += 64) {
        const auto near = static_cast<std::size_t>(std::popcount(blocks.near_from(i, first)));
        if (near > left) return true;
        left -= near;
      }
    }
    return false;
  }
};

/// Returns the most meetings on the right that so many segments may have. If they have more, most
/// corners lie inside, and the stages are faster. With 2 for each segment in place of 1.5, the nine
/// sums that changed took 1.04 times as long on the geometric mean.
[[nodiscard]] constexpr std::uint32_t most_right_meetings(std::uint32_t segments) {
  return segments + segments / 2 + 16;
}

/// Returns those of up to 64 vertices that meet an edge of this direction: it is in (in, out].
template <class Number>
[[gnu::always_inline]] inline LaneBits vertices_meeting(const SmallOperand& o, std::size_t first,
                                                        std::size_t count,
                                                        const Vec<double>& edge) {
  const double* const in_x = o[SmallOperand::kInX] + first;
  const double* const in_y = o[SmallOperand::kInY] + first;
  const double* const out_x = o[SmallOperand::kOutX] + first;
  const double* const out_y = o[SmallOperand::kOutY] + first;
  const auto meets = [&](const auto& cross, std::size_t v) __attribute__((always_inline)) {
    const bool meet =
        (cross({in_x[v], in_y[v]}, edge) > 0) & (cross(edge, {out_x[v], out_y[v]}) >= 0);
    return meet ? kBitOf[v] : 0;
  };
  return test_lanes<Number>(count / kLanes * kLanes, meets);
}
/// Returns those of up to 64 edges whose direction is in [in, out).
template <class Number>
[[gnu::always_inline]] inline LaneBits edges_between(const SmallOperand& o, std::size_t first,
                                                     std::size_t count, const Vec<double>& in,
                                                     const Vec<double>& out) {
  const double* const dx = o[SmallOperand::kDx] + first;
  const double* const dy = o[SmallOperand::kDy] + first;
  const auto between = [&](const auto& cross, std::size_t e) __attribute__((always_inline)) {
    const Vec<double> edge{dx[e], dy[e]};
    return ((cross(in, edge) >= 0) & (cross(edge, out) > 0)) ? kBitOf[e] : 0;
  };
  return test_lanes<Number>(count / kLanes * kLanes, between);
}

/// Lists the reduced convolution in the order of the first operand's rings. So segments that are
/// near in the plane are mostly near in the list. The holes of others than those `with_holes` are
/// filled. Returns false if there are too many segments.
template <class Number>
[[gnu::always_inline]] inline bool list_segments(const SmallOperand& p, const SmallOperand& q,
                                                 const std::array<bool, 2>& with_holes,
                                                 SmallSegments& s) {
  const std::uint32_t m = with_holes[0] ? p.entries : p.size;
  const std::size_t n = filled_up(with_holes[1] ? q.entries : q.size);
  std::uint32_t size = 0;
  const SmallRows of_p(p);
  const SmallRows of_q(q);
  const auto append = [&](const SmallRows& edges, std::size_t e, const SmallRows& vertices,
                          std::size_t v, bool of_first) __attribute__((always_inline)) {
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
  for (std::uint32_t i = 0; i < m; ++i) {
    const Vec<double> in{p[SmallOperand::kInX][i], p[SmallOperand::kInY][i]};
    const Vec<double> out{p[SmallOperand::kOutX][i], p[SmallOperand::kOutY][i]};
    const Vec<double> edge{of_p.dx[i], of_p.dy[i]};
    for (std::size_t first = 0; first < n; first += 64) {
      const std::size_t count = std::min<std::size_t>(n - first, 64);
      const LaneBits at_vertex =
          in.x == 0 && in.y == 0 ? 0 : edges_between<Number>(q, first, count, in, out);
      if (!fit(at_vertex)) return false;
      for_each_bit(at_vertex, [&](std::uint32_t e) { append(of_q, first + e, of_p, i, false); });
      const LaneBits of_edge = vertices_meeting<Number>(q, first, count, edge);
      if (!fit(of_edge)) return false;
      for_each_bit(of_edge, [&](std::uint32_t v) { append(of_p, i, of_q, first + v, true); });
    }
  }
  s.size = size;
  s.finish();
  return true;
}

/// Sorts segments by squares of a 16th of the sum's width, in the order of Hilbert's curve. Then
/// segments that are near one another in the plane are near in the list. O(s).
class SmallOrder {
 public:
  [[gnu::always_inline]] void apply(const SmallSegments& from, double width, SmallSegments& to) {
    const double scale = kSide / (width + 1);
    place_.fill(0);
    for (std::uint32_t i = 0; i < from.size; ++i) {
      const auto column = static_cast<std::uint32_t>((from.x[i] + from.dx[i] / 2) * scale);
      const auto row = static_cast<std::uint32_t>((from.y[i] + from.dy[i] / 2) * scale);
      square_[i] = kCurve[row * kSide + column];
      ++place_[square_[i] + std::size_t{1}];
    }
    for (std::size_t k = 1; k < place_.size(); ++k) place_[k] += place_[k - 1];
    to.size = from.size;
    for (std::uint32_t i = 0; i < from.size; ++i) {
      const std::uint32_t at = place_[square_[i]]++;
      to.x[at] = from.x[i];
      to.y[at] = from.y[i];
      to.dx[at] = from.dx[i];
      to.dy[at] = from.dy[i];
      to.origin[at] = from.origin[i];
    }
    to.finish();
  }

 private:
  /// With 32, sums took up to 6 % more instructions, and hardly fewer blocks were near one another.
  static constexpr std::uint32_t kSide = 16;
  /// By row and column: a square's place on the curve.
  static constexpr auto kCurve = [] {
    std::array<std::uint16_t, kSide * kSide> curve{};
    for (std::uint32_t square = 0; square < curve.size(); ++square) {
      std::uint32_t x = square % kSide;
      std::uint32_t y = square / kSide;
      std::uint32_t place = 0;
      for (std::uint32_t half = kSide / 2; half > 0; half /= 2) {
        const bool right = (x & half) != 0;
        const bool upper = (y & half) != 0;
        place += half * half * (right ? (upper ? 2U : 3U) : (upper ? 1U : 0U));
        // The curve enters each quarter turned its own way.
        if (upper) continue;
        if (right) {
          x = kSide - 1 - x;
          y = kSide - 1 - y;
        }
        std::swap(x, y);
      }
      curve[square] = static_cast<std::uint16_t>(place);
    }
    return curve;
  }();
  std::array<std::uint16_t, kSide * kSide + 1> place_;
  std::array<std::uint16_t, SmallSegments::kMax> square_;
};

}  // namespace minksum
