#include "small_sum/small_operand.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "machine/vectors.hpp"
#include "number/wide_int.hpp"
#include "region/region_access.hpp"

namespace minksum {
namespace {

/// Sums of two offsets and two coordinates have their place in 64 bits.
constexpr std::int64_t kFarthest = std::int64_t{1} << 60;

bool fits(const Int128& offset) { return -kFarthest <= offset && offset <= kFarthest; }

/// The vertices as they are given; false if they have no short integers on a common grid.
bool load(const Region& region, SmallOperand& s) {
  const std::size_t n = region.vertex_count();
  if (region.polygon_count() != 1 || region.ring_count() != 1 || n < 3 ||
      n > SmallOperand::kMaxVertices || !RegionAccess::limbs(region).empty()) {
    return false;
  }
  bool known = false;
  for (std::size_t v = 0; v < n; ++v) {
    for (const StoredCoordinate& c : {RegionAccess::x(region, v), RegionAccess::y(region, v)}) {
      if (c.payload == 0) continue;
      s.exp2 = known ? std::min<int>(s.exp2, c.exp2) : c.exp2;
      s.exp10 = known ? std::min<int>(s.exp10, c.exp10) : c.exp10;
      known = true;
    }
  }
  if (!known) return false;
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
  constexpr std::int64_t kWidest = std::int64_t{1} << SmallOperand::kMaxBits;
  if (!fit || high.x - low.x > kWidest || high.y - low.y > kWidest) return false;
  s.size = static_cast<std::uint32_t>(n);
  s.offset = low;
  s.first = at[0];
  s.extent = {static_cast<double>(high.x - low.x), static_cast<double>(high.y - low.y)};
  for (std::uint32_t v = 0; v < n; ++v) {
    s.x[v] = static_cast<double>(at[v].x - low.x);
    s.y[v] = static_cast<double>(at[v].y - low.y);
    s.vertex_source[v] = v;
  }
  return true;
}

double turn_at(const SmallOperand& s, std::uint32_t before, std::uint32_t at, std::uint32_t after) {
  return (s.x[at] - s.x[before]) * (s.y[after] - s.y[at]) -
         (s.y[at] - s.y[before]) * (s.x[after] - s.x[at]);
}

/// Drops vertices in the middle of straight edges; false if one is repeated, or a spike.
bool drop_straight(SmallOperand& s) {
  std::uint32_t kept = 0;
  std::array<bool, SmallOperand::kMaxVertices> stays;
  for (std::uint32_t i = 0; i < s.size; ++i) {
    const std::uint32_t before = i == 0 ? s.size - 1 : i - 1;
    const std::uint32_t after = i + 1 == s.size ? 0 : i + 1;
    stays[i] = turn_at(s, before, i, after) != 0;
    const double ahead = (s.x[i] - s.x[before]) * (s.x[after] - s.x[i]) +
                         (s.y[i] - s.y[before]) * (s.y[after] - s.y[i]);
    if (!stays[i] && !(ahead > 0)) return false;
  }
  for (std::uint32_t i = 0; i < s.size; ++i) {
    if (!stays[i]) continue;
    s.x[kept] = s.x[i];
    s.y[kept] = s.y[i];
    s.vertex_source[kept++] = s.vertex_source[i];
  }
  s.size = kept;
  return kept >= 3;
}

void find_smallest(SmallOperand& s) {
  s.smallest = 0;
  for (std::uint32_t i = 1; i < s.size; ++i) {
    if (std::pair(s.x[i], s.y[i]) < std::pair(s.x[s.smallest], s.y[s.smallest])) s.smallest = i;
  }
}

/// Counter-clockwise, with the sources of edges.
void orient(SmallOperand& s) {
  find_smallest(s);
  const std::uint32_t n = s.size;
  const std::uint32_t i = s.smallest;
  const bool reversed = turn_at(s, i == 0 ? n - 1 : i - 1, i, i + 1 == n ? 0 : i + 1) < 0;
  if (reversed) {
    std::reverse(s.x.begin(), s.x.begin() + n);
    std::reverse(s.y.begin(), s.y.begin() + n);
    std::reverse(s.vertex_source.begin(), s.vertex_source.begin() + n);
    s.smallest = n - 1 - s.smallest;
  }
  std::copy_n(s.vertex_source.begin(), n, s.edge_source.begin());
  // The edge that starts here is the one that started at the next vertex.
  if (reversed) {
    std::rotate(s.edge_source.begin(), s.edge_source.begin() + 1, s.edge_source.begin() + n);
  }
}

/// What follows from the places.
void set_edges(SmallOperand& s) {
  const std::uint32_t n = s.size;
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t after = i + 1 == n ? 0 : i + 1;
    s.dx[i] = s.x[after] - s.x[i];
    s.dy[i] = s.y[after] - s.y[i];
  }
  s.convex = true;
  std::uint32_t before = n - 1;
  for (std::uint32_t i = 0; i < n; ++i) {
    const bool convex = s.dx[before] * s.dy[i] - s.dy[before] * s.dx[i] > 0;
    s.convex &= convex;
    s.in_x[i] = convex ? s.dx[before] : 0;
    s.in_y[i] = convex ? s.dy[before] : 0;
    s.out_x[i] = convex ? s.dx[i] : 0;
    s.out_y[i] = convex ? s.dy[i] : 0;
    before = i;
  }
  for (auto* row : {&s.x, &s.y, &s.dx, &s.dy, &s.in_x, &s.in_y, &s.out_x, &s.out_y}) {
    std::fill(row->begin() + n, row->begin() + static_cast<std::ptrdiff_t>(filled_up(n)), 0.0);
  }
}

/// Whether no edge has a point in common with another one, but for the vertex between neighbours.
[[gnu::always_inline]] inline bool is_simple(const SmallOperand& s) {
  const std::size_t n = filled_up(s.size);
  const SmallMask all = first_bits(s.size);
  std::uint32_t before = s.size - 1;
  bool simple = true;
  for (std::uint32_t i = 0; i < s.size; ++i) {
    const double x = s.x[i];
    const double y = s.y[i];
    const double dx = s.dx[i];
    const double dy = s.dy[i];
    SmallMask met = 0;
    for (std::size_t t = 0; t < n; ++t) {
      const double ax = s.x[t] - x;
      const double ay = s.y[t] - y;
      const double turn = dx * s.dy[t] - dy * s.dx[t];
      const double start = dx * ay - dy * ax;
      const double along = ax * s.dy[t] - ay * s.dx[t];
      // Neither lies on one side of the other's line, and their boxes meet.
      const bool meets = (start * (start + turn) <= 0) & (along * (turn - along) >= 0) &
                         (std::abs(2 * ax + s.dx[t] - dx) <= std::abs(dx) + std::abs(s.dx[t])) &
                         (std::abs(2 * ay + s.dy[t] - dy) <= std::abs(dy) + std::abs(s.dy[t]));
      met |= meets ? kBitOf[t] : 0;
    }
    const std::uint32_t after = i + 1 == s.size ? 0 : i + 1;
    simple &= (met & all) == (kBitOf[before] | kBitOf[i] | kBitOf[after]);
    before = i;
  }
  return simple;
}

}  // namespace

bool read_small(const Region& region, SmallOperand& s) {
  if (!load(region, s) || !drop_straight(s)) return false;
  orient(s);
  set_edges(s);
  return with_vectors(
      widest_vectors(), [&]() __attribute__((always_inline)) { return is_simple(s); });
}

void turn(const SmallOperand& from, int quarters, SmallOperand& to) {
  const int turns = ((quarters % 4) + 4) % 4;
  to.size = from.size;
  to.extent = from.extent;
  to.offset = from.offset;
  to.exp2 = from.exp2;
  to.exp10 = from.exp10;
  const std::uint32_t n = from.size;
  std::copy_n(from.x.begin(), n, to.x.begin());
  std::copy_n(from.y.begin(), n, to.y.begin());
  std::copy_n(from.vertex_source.begin(), n, to.vertex_source.begin());
  std::copy_n(from.edge_source.begin(), n, to.edge_source.begin());
  for (int k = 0; k < turns; ++k) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const double x = to.x[i];
      to.x[i] = to.extent.y - to.y[i];
      to.y[i] = x;
    }
    to.offset = {-(to.offset.y + static_cast<std::int64_t>(to.extent.y)), to.offset.x};
    std::swap(to.extent.x, to.extent.y);
  }
  find_smallest(to);
  set_edges(to);
}

bool refine(int exp2, int exp10, SmallOperand& s) {
  constexpr std::int64_t kWidest = std::int64_t{1} << SmallOperand::kMaxBits;
  Int128 factor = 1;
  for (int k = exp10; k < s.exp10 && factor <= kWidest; ++k) factor *= 10;
  for (int k = exp2; k < s.exp2 && factor <= kWidest; ++k) factor *= 2;
  const auto longest = static_cast<Int128>(std::max(s.extent.x, s.extent.y));
  if (factor > kWidest || longest * factor > kWidest || !fits(s.offset.x * factor) ||
      !fits(s.offset.y * factor)) {
    return false;
  }
  const auto times = static_cast<double>(factor);
  for (auto* row : {&s.x, &s.y, &s.dx, &s.dy, &s.in_x, &s.in_y, &s.out_x, &s.out_y}) {
    for (std::uint32_t i = 0; i < s.size; ++i) (*row)[i] *= times;
  }
  const auto by = static_cast<std::int64_t>(factor);
  s.extent = {s.extent.x * times, s.extent.y * times};
  s.offset = {s.offset.x * by, s.offset.y * by};
  s.exp2 = exp2;
  s.exp10 = exp10;
  return true;
}

}  // namespace minksum
