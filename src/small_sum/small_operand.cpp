#include "small_sum/small_operand.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "machine/vectors.hpp"
#include "number/wide_int.hpp"
#include "region/region_access.hpp"
#include "small_sum/blocks.hpp"

namespace minksum {
namespace {

/// Sums of two offsets and two coordinates have their place in 64 bits.
constexpr std::int64_t kFarthest = std::int64_t{1} << 60;
constexpr std::int64_t kWidest = std::int64_t{1} << SmallOperand::kMaxBits;

bool fits(const Int128& offset) { return -kFarthest <= offset && offset <= kFarthest; }

/// Sets the exponents to the smallest in use; false if all coordinates are zero.
bool find_grid(const Region& region, SmallOperand& s) {
  bool known = false;
  for (std::size_t v = 0; v < region.vertex_count(); ++v) {
    for (const StoredCoordinate& c : {RegionAccess::x(region, v), RegionAccess::y(region, v)}) {
      if (c.payload == 0) continue;
      s.exp2 = known ? std::min<int>(s.exp2, c.exp2) : c.exp2;
      s.exp10 = known ? std::min<int>(s.exp10, c.exp10) : c.exp10;
      known = true;
    }
  }
  return known;
}

/// The vertices as they are given; false if they have no short integers on a common grid.
bool load(const Region& region, SmallOperand& s) {
  const std::size_t n = region.vertex_count();
  if (region.polygon_count() != 1 || region.ring_count() != 1 || n < 3 ||
      n > SmallOperand::kMaxVertices || !RegionAccess::limbs(region).empty() ||
      !find_grid(region, s)) {
    return false;
  }
  std::array<Vec<std::int64_t>, SmallOperand::kMaxVertices> at;
  bool fit = true;
  const auto integer = [&](const StoredCoordinate& c) -> std::int64_t {
    if (c.payload == 0) return 0;
    Int128 value = c.payload;
    for (int k = s.exp10; k < c.exp10 && fits(value); ++k) value *= 10;
    for (int k = s.exp2; k < c.exp2 && fits(value); ++k) value *= 2;
    fit = fit && fits(value);
    return static_cast<std::int64_t>(value);
  };
  Vec<std::int64_t> low{kFarthest, kFarthest};
  Vec<std::int64_t> high{-kFarthest, -kFarthest};
  for (std::size_t v = 0; v < n; ++v) {
    at[v] = {integer(RegionAccess::x(region, v)), integer(RegionAccess::y(region, v))};
    low = {std::min(low.x, at[v].x), std::min(low.y, at[v].y)};
    high = {std::max(high.x, at[v].x), std::max(high.y, at[v].y)};
  }
  if (!fit || high.x - low.x > kWidest || high.y - low.y > kWidest) return false;
  s.size = static_cast<std::uint32_t>(n);
  s.offset = low;
  s.first = at[0];
  s.extent = {static_cast<double>(high.x - low.x), static_cast<double>(high.y - low.y)};
  s.make_rows(n);
  s.sources.resize(n);
  for (std::uint32_t v = 0; v < n; ++v) {
    s[SmallOperand::kX][v] = static_cast<double>(at[v].x - low.x);
    s[SmallOperand::kY][v] = static_cast<double>(at[v].y - low.y);
    s.sources[v] = {v, v};
  }
  return true;
}

Vec<double> step(const SmallOperand& s, std::uint32_t from, std::uint32_t to) {
  return {s[SmallOperand::kX][to] - s[SmallOperand::kX][from],
          s[SmallOperand::kY][to] - s[SmallOperand::kY][from]};
}

/// Drops vertices in the middle of straight edges; false if one is repeated, or a spike.
bool drop_straight(SmallOperand& s) {
  std::array<bool, SmallOperand::kMaxVertices> stays;
  bool all = true;
  std::uint32_t before = s.size - 1;
  for (std::uint32_t i = 0; i < s.size; ++i) {
    const Vec<double> in = step(s, before, i);
    const Vec<double> out = step(s, i, i + 1 == s.size ? 0 : i + 1);
    stays[i] = cross(in, out) != 0;
    all = all && stays[i];
    if (!stays[i] && !(in.x * out.x + in.y * out.y > 0)) return false;
    before = i;
  }
  if (all) return true;
  double* const x = s[SmallOperand::kX];
  double* const y = s[SmallOperand::kY];
  std::uint32_t kept = 0;
  for (std::uint32_t i = 0; i < s.size; ++i) {
    if (!stays[i]) continue;
    x[kept] = x[i];
    y[kept] = y[i];
    s.sources[kept++] = s.sources[i];
  }
  s.size = kept;
  return kept >= 3;
}

void find_smallest(SmallOperand& s) {
  const double* const x = s[SmallOperand::kX];
  const double* const y = s[SmallOperand::kY];
  s.smallest = 0;
  for (std::uint32_t i = 1; i < s.size; ++i) {
    const bool less = x[i] != x[s.smallest] ? x[i] < x[s.smallest] : y[i] < y[s.smallest];
    if (less) s.smallest = i;
  }
}

/// Counter-clockwise, with the sources of edges.
void orient(SmallOperand& s) {
  find_smallest(s);
  const std::uint32_t n = s.size;
  const std::uint32_t i = s.smallest;
  if (cross(step(s, i == 0 ? n - 1 : i - 1, i), step(s, i, i + 1 == n ? 0 : i + 1)) > 0) return;
  std::reverse(s[SmallOperand::kX], s[SmallOperand::kX] + n);
  std::reverse(s[SmallOperand::kY], s[SmallOperand::kY] + n);
  std::reverse(s.sources.begin(), s.sources.begin() + n);
  s.smallest = n - 1 - i;
  // The edge that starts here is the one that started at the next vertex.
  for (std::uint32_t k = 0; k < n; ++k) {
    s.sources[k].edge = s.sources[k + 1 == n ? 0 : k + 1].vertex;
  }
}

/// What follows from the places.
void set_edges(SmallOperand& s) {
  const std::uint32_t n = s.size;
  double* const dx = s[SmallOperand::kDx];
  double* const dy = s[SmallOperand::kDy];
  for (std::uint32_t i = 0; i < n; ++i) {
    const Vec<double> d = step(s, i, i + 1 == n ? 0 : i + 1);
    dx[i] = d.x;
    dy[i] = d.y;
  }
  s.convex = true;
  std::uint32_t before = n - 1;
  for (std::uint32_t i = 0; i < n; ++i) {
    const bool convex = dx[before] * dy[i] - dy[before] * dx[i] > 0;
    s.convex &= convex;
    s[SmallOperand::kInX][i] = convex ? dx[before] : 0;
    s[SmallOperand::kInY][i] = convex ? dy[before] : 0;
    s[SmallOperand::kOutX][i] = convex ? dx[i] : 0;
    s[SmallOperand::kOutY][i] = convex ? dy[i] : 0;
    before = i;
  }
  for (int row = 0; row < SmallOperand::kRows; ++row) {
    double* const values = s[static_cast<SmallOperand::Row>(row)];
    std::fill(values + n, values + filled_up(n), 0.0);
  }
}

double mean_turning(const SmallOperand& s) {
  constexpr std::array<Vec<double>, 8> kDirections{
      {{1, 0}, {2, 1}, {1, 2}, {0, 1}, {-1, 0}, {-2, -1}, {-1, -2}, {0, -1}}};
  int meetings = 0;
  for (std::uint32_t v = 0; v < s.size; ++v) {
    const Vec<double> in{s[SmallOperand::kInX][v], s[SmallOperand::kInY][v]};
    const Vec<double> out{s[SmallOperand::kOutX][v], s[SmallOperand::kOutY][v]};
    for (const Vec<double>& d : kDirections) {
      meetings += (cross(in, d) > 0) & (cross(d, out) >= 0) ? 1 : 0;
    }
  }
  return meetings / 8.0;
}

/// The edges among eight or more that edge i meets.
[[gnu::always_inline]] inline LaneBits edges_meeting(const SmallOperand& s, std::uint32_t i,
                                                     std::size_t first, std::size_t count) {
  const double x = s[SmallOperand::kX][i];
  const double y = s[SmallOperand::kY][i];
  const double dx = s[SmallOperand::kDx][i];
  const double dy = s[SmallOperand::kDy][i];
  const double* const other_x = s[SmallOperand::kX] + first;
  const double* const other_y = s[SmallOperand::kY] + first;
  const double* const other_dx = s[SmallOperand::kDx] + first;
  const double* const other_dy = s[SmallOperand::kDy] + first;
  LaneBits met = 0;
  for (std::size_t t = 0; t < count; ++t) {
    const double ax = other_x[t] - x;
    const double ay = other_y[t] - y;
    const double turn = dx * other_dy[t] - dy * other_dx[t];
    const double start = dx * ay - dy * ax;
    const double along = ax * other_dy[t] - ay * other_dx[t];
    // Neither lies on one side of the other's line, and their boxes meet.
    const bool meets =
        (start * (start + turn) <= 0) & (along * (turn - along) >= 0) &
        (std::abs(2 * ax + other_dx[t] - dx) <= std::abs(dx) + std::abs(other_dx[t])) &
        (std::abs(2 * ay + other_dy[t] - dy) <= std::abs(dy) + std::abs(other_dy[t]));
    met |= meets ? kBitOf[t] : 0;
  }
  return met;
}

/// Whether no edge has a point in common with another one, but for the vertex between neighbours.
[[gnu::always_inline]] inline bool is_simple(const SmallOperand& s) {
  const std::uint32_t n = s.size;
  const bool few = n <= 64;
  SmallBlocks blocks;
  if (!few) {
    blocks.set(s[SmallOperand::kX], s[SmallOperand::kY], s[SmallOperand::kDx], s[SmallOperand::kDy],
               n);
  }
  bool simple = true;
  const auto count_beyond = [&](std::uint32_t i, std::size_t first, LaneBits met) {
    const auto bit = [&](std::uint32_t edge) {
      return edge - first < 64 ? kBitOf[edge - first] : LaneBits{0};
    };
    met &= first_bits(n - first);
    met &= ~(bit(i) | bit(i + 1 == n ? 0 : i + 1) | bit(i == 0 ? n - 1 : i - 1));
    simple &= met == 0;
  };
  for (std::uint32_t i = 0; i < n && simple; ++i) {
    if (few) {
      count_beyond(i, 0, edges_meeting(s, i, 0, filled_up(n)));
      continue;
    }
    const LaneBits near = blocks.near(s[SmallOperand::kX][i], s[SmallOperand::kY][i],
                                      s[SmallOperand::kDx][i], s[SmallOperand::kDy][i]);
    for_each_bit(near, [&](std::uint32_t block) {
      count_beyond(i, block * kLanes, edges_meeting(s, i, block * kLanes, kLanes));
    });
  }
  return simple;
}

}  // namespace

bool read_small(const Region& region, SmallOperand& s) {
  if (!load(region, s) || !drop_straight(s)) return false;
  orient(s);
  set_edges(s);
  if (!s.convex) s.turning = mean_turning(s);
  return with_vectors(
      widest_vectors(), [&]() __attribute__((always_inline)) { return is_simple(s); });
}

void turn(const SmallOperand& from, int quarters, SmallOperand& to) {
  const int turns = ((quarters % 4) + 4) % 4;
  const std::uint32_t n = from.size;
  to.size = n;
  to.turning = from.turning;
  to.extent = from.extent;
  to.offset = from.offset;
  to.exp2 = from.exp2;
  to.exp10 = from.exp10;
  to.sources = from.sources;
  to.make_rows(n);
  double* const x = to[SmallOperand::kX];
  double* const y = to[SmallOperand::kY];
  std::copy_n(from[SmallOperand::kX], n, x);
  std::copy_n(from[SmallOperand::kY], n, y);
  for (int k = 0; k < turns; ++k) {
    for (std::uint32_t i = 0; i < n; ++i) x[i] = std::exchange(y[i], x[i]);
    std::swap(to.extent.x, to.extent.y);
    for (std::uint32_t i = 0; i < n; ++i) x[i] = to.extent.x - x[i];
    to.offset = {-(to.offset.y + static_cast<std::int64_t>(to.extent.x)), to.offset.x};
  }
  find_smallest(to);
  set_edges(to);
}

bool refine(int exp2, int exp10, SmallOperand& s) {
  Int128 factor = 1;
  for (int k = exp10; k < s.exp10 && factor <= kWidest; ++k) factor *= 10;
  for (int k = exp2; k < s.exp2 && factor <= kWidest; ++k) factor *= 2;
  const auto longest = static_cast<Int128>(std::max(s.extent.x, s.extent.y));
  if (factor > kWidest || longest * factor > kWidest || !fits(s.offset.x * factor) ||
      !fits(s.offset.y * factor)) {
    return false;
  }
  const auto times = static_cast<double>(factor);
  for (int row = 0; row < SmallOperand::kRows; ++row) {
    double* const values = s[static_cast<SmallOperand::Row>(row)];
    for (std::uint32_t i = 0; i < s.size; ++i) values[i] *= times;
  }
  const auto by = static_cast<std::int64_t>(factor);
  s.extent = {s.extent.x * times, s.extent.y * times};
  s.offset = {s.offset.x * by, s.offset.y * by};
  s.exp2 = exp2;
  s.exp10 = exp10;
  return true;
}

}  // namespace minksum
