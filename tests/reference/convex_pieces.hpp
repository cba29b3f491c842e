// Cuts a region with integer vertices into convex pieces along diagonals, in the obvious way.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "reference/exact.hpp"

namespace minksum::reference {

__extension__ typedef __int128 Int128;

template <class Int>
struct IntPt {
  Int x;
  Int y;
  friend bool operator==(const IntPt& a, const IntPt& b) { return a.x == b.x && a.y == b.y; }
  friend bool operator<(const IntPt& a, const IntPt& b) {
    return a.x != b.x ? a.x < b.x : a.y < b.y;
  }
  friend IntPt operator+(const IntPt& a, const IntPt& b) { return {a.x + b.x, a.y + b.y}; }
  friend IntPt operator-(const IntPt& a, const IntPt& b) { return {a.x - b.x, a.y - b.y}; }
};

template <class Int>
[[nodiscard]] Int cross(const IntPt<Int>& a, const IntPt<Int>& b) {
  return a.x * b.y - a.y * b.x;
}
template <class Int>
[[nodiscard]] int turn(const IntPt<Int>& a, const IntPt<Int>& b, const IntPt<Int>& c) {
  const Int value = cross(b - a, c - a);
  return value < 0 ? -1 : value > 0 ? 1 : 0;
}

template <class Int>
using IntLoop = std::vector<IntPt<Int>>;

/// Returns counter-clockwise convex polygons with disjoint interiors, whose union is the region
/// bounded by `rings`. The rings must have the interior on their left, and edges must meet only at
/// vertices (see `directed_and_noded`). Vertices in the middle of straight edges may remain.
template <class Int>
[[nodiscard]] std::vector<IntLoop<Int>> convex_pieces(const std::vector<IntLoop<Int>>& rings);

/// Returns the corners of the convex hull, counter-clockwise.
template <class Int>
[[nodiscard]] IntLoop<Int> convex_hull(IntLoop<Int> points);

extern template std::vector<IntLoop<std::int64_t>> convex_pieces(
    const std::vector<IntLoop<std::int64_t>>&);
extern template std::vector<IntLoop<Int128>> convex_pieces(const std::vector<IntLoop<Int128>>&);
extern template std::vector<IntLoop<Integer>> convex_pieces(const std::vector<IntLoop<Integer>>&);
extern template IntLoop<std::int64_t> convex_hull(IntLoop<std::int64_t>);
extern template IntLoop<Int128> convex_hull(IntLoop<Int128>);
extern template IntLoop<Integer> convex_hull(IntLoop<Integer>);

}  // namespace minksum::reference
