#include "sum/small/small_operand.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "machine/vectors.hpp"
#include "region/region_access.hpp"
#include "sum/small/small_rings.hpp"

namespace minksum {
namespace {

/// The largest offset and coordinate: sums of two offsets and two coordinates fit in 64 bits.
constexpr std::int64_t kFarthest = std::int64_t{1} << 60;

bool fits(const Int128& offset) { return -kFarthest <= offset && offset <= kFarthest; }

/// Sets the exponents to the smallest in use. Returns false if all coordinates are zero.
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

Vec<std::int64_t> step(const SmallOperand& s, std::uint32_t from, std::uint32_t to) {
  return {static_cast<std::int64_t>(s[SmallOperand::kX][to] - s[SmallOperand::kX][from]),
          static_cast<std::int64_t>(s[SmallOperand::kY][to] - s[SmallOperand::kY][from])};
}

Int128 exact_turn(const Vec<std::int64_t>& in, const Vec<std::int64_t>& out) {
  return Int128{in.x} * out.y - Int128{in.y} * out.x;
}

/// Sets the longest extent of an edge. Returns false if that is too long for any number type.
bool find_longest(SmallOperand& s) {
  const double* const x = s[SmallOperand::kX];
  const double* const y = s[SmallOperand::kY];
  s.longest = 0;
  std::uint32_t before = s.size - 1;
  for (std::uint32_t i = 0; i < s.size; ++i) {
    s.longest = std::max({s.longest, std::abs(x[i] - x[before]), std::abs(y[i] - y[before])});
    before = i;
  }
  return small_numbers(s.longest, std::max(s.extent.x, s.extent.y)) != SmallNumberType::kNone;
}

/// Loads the vertices of a ring as they are given, on a grid that is set. Returns false if they are
/// no short integers there. The origin is the box's lower left corner, unless `origin` is given.
bool load(const Region& region, const IndexRange& ring, const Vec<std::int64_t>* origin,
          SmallOperand& s) {
  const std::size_t n = ring.size();
  if (n < 3 || n > SmallOperand::kMaxVertices) return false;
  std::array<Vec<std::int64_t>, SmallOperand::kMaxVertices> at;
  bool fit = true;
  const auto integer = [&](const StoredCoordinate& c) -> std::int64_t {
    if (c.payload == 0) return 0;
    Int128 value = c.payload;
    if (c.exp10 == s.exp10 && c.exp2 == s.exp2 && fits(value)) return c.payload;
    for (int k = s.exp10; k < c.exp10 && fits(value); ++k) value *= 10;
    for (int k = s.exp2; k < c.exp2 && fits(value); ++k) value *= 2;
    fit = fit && fits(value);
    return static_cast<std::int64_t>(value);
  };
  Vec<std::int64_t> low{kFarthest, kFarthest};
  Vec<std::int64_t> high{-kFarthest, -kFarthest};
  for (std::size_t v = 0; v < n; ++v) {
    at[v] = {integer(RegionAccess::x(region, ring.front() + v)),
             integer(RegionAccess::y(region, ring.front() + v))};
    low = {std::min(low.x, at[v].x), std::min(low.y, at[v].y)};
    high = {std::max(high.x, at[v].x), std::max(high.y, at[v].y)};
  }
  if (!fit) return false;
  s.extent = {static_cast<double>(high.x - low.x), static_cast<double>(high.y - low.y)};
  const double width = std::max(s.extent.x, s.extent.y);
  if (width > SmallOperand::kWidest) return false;
  s.size = static_cast<std::uint32_t>(n);
  if (origin != nullptr) low = *origin;
  s.offset = low;
  s.first = at[0];
  s.make_rows(n);
  for (std::uint32_t v = 0; v < n; ++v) {
    s[SmallOperand::kX][v] = static_cast<double>(at[v].x - low.x);
    s[SmallOperand::kY][v] = static_cast<double>(at[v].y - low.y);
    s[SmallOperand::kVertexSource][v] = v;
    s[SmallOperand::kEdgeSource][v] = v;
  }
  return find_longest(s);
}

/// Drops vertices in the middle of straight edges. Returns false if a vertex is repeated or is the
/// tip of a spike.
bool drop_straight(SmallOperand& s) {
  std::array<bool, SmallOperand::kMaxVertices> stays;
  bool all = true;
  std::uint32_t before = s.size - 1;
  for (std::uint32_t i = 0; i < s.size; ++i) {
    const Vec<std::int64_t> in = step(s, before, i);
    const Vec<std::int64_t> out = step(s, i, i + 1 == s.size ? 0 : i + 1);
    stays[i] = exact_turn(in, out) != 0;
    all = all && stays[i];
    if (!stays[i] && !(Int128{in.x} * out.x + Int128{in.y} * out.y > 0)) return false;
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
    for (const auto row : {SmallOperand::kVertexSource, SmallOperand::kEdgeSource}) {
      s[row][kept] = s[row][i];
    }
    ++kept;
  }
  s.size = kept;
  return kept >= 3 && find_longest(s);
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

/// Makes the ring counter-clockwise, and keeps the sources of edges right.
void orient(SmallOperand& s) {
  find_smallest(s);
  const std::uint32_t n = s.size;
  const std::uint32_t i = s.smallest;
  if (exact_turn(step(s, i == 0 ? n - 1 : i - 1, i), step(s, i, i + 1 == n ? 0 : i + 1)) > 0)
    return;
  std::reverse(s[SmallOperand::kX], s[SmallOperand::kX] + n);
  std::reverse(s[SmallOperand::kY], s[SmallOperand::kY] + n);
  double* const vertex_source = s[SmallOperand::kVertexSource];
  std::reverse(vertex_source, vertex_source + n);
  s.smallest = n - 1 - i;
  // The edge that starts here is the one that started at the next vertex.
  std::rotate_copy(vertex_source, vertex_source + 1, vertex_source + n,
                   s[SmallOperand::kEdgeSource]);
}

/// Sets edges and convexity, which follow from the places.
void set_edges(SmallOperand& s) {
  const std::uint32_t n = s.size;
  double* const dx = s[SmallOperand::kDx];
  double* const dy = s[SmallOperand::kDy];
  s.convex = true;
  Vec<std::int64_t> in = step(s, n - 1, 0);
  for (std::uint32_t i = 0; i < n; ++i) {
    const Vec<std::int64_t> out = step(s, i, i + 1 == n ? 0 : i + 1);
    const bool convex = exact_turn(in, out) > 0;
    const auto value = [&](std::int64_t d) { return convex ? static_cast<double>(d) : 0.0; };
    s.convex &= convex;
    dx[i] = static_cast<double>(out.x);
    dy[i] = static_cast<double>(out.y);
    s[SmallOperand::kInX][i] = value(in.x);
    s[SmallOperand::kInY][i] = value(in.y);
    s[SmallOperand::kOutX][i] = value(out.x);
    s[SmallOperand::kOutY][i] = value(out.y);
    in = out;
  }
  for (int row = 0; row < SmallOperand::kVertexSource; ++row) {
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
      meetings += (cross(in, d) > 0) && (cross(d, out) >= 0) ? 1 : 0;
    }
  }
  return meetings / 8.0;
}

template <class Number>
bool is_simple_ring(const SmallOperand& s) {
  return with_vectors(
      widest_vectors(), [&]() __attribute__((always_inline)) { return is_simple<Number>(s); });
}

/// Whether a hole is simple and lies inside the outer ring, apart from the holes before it.
template <class Number>
bool is_clear_hole(const SmallOperand& hole, const SmallOperand& outer,
                   std::span<const SmallOperand> before, std::span<const BoxOf<double>> boxes) {
  const BoxOf<double>& box = boxes[before.size()];
  if (box.x0 < 0 || box.y0 < 0 || box.x1 > outer.extent.x || box.y1 > outer.extent.y ||
      !is_simple_ring<Number>(hole) || !holds<Number>(outer, hole) ||
      do_meet<Number>(hole, outer)) {
    return false;
  }
  for (std::size_t l = 0; l < before.size(); ++l) {
    if (box.meets(boxes[l]) && (do_meet<Number>(hole, before[l]) ||
                                holds<Number>(hole, before[l]) || holds<Number>(before[l], hole))) {
      return false;
    }
  }
  return true;
}

/// Reads the sizes of the holes. Returns false if they are many or not clearly valid, or if two
/// rings touch.
bool read_holes(const Region& region, SmallOperand& s) {
  const std::size_t count = region.ring_count() - 1;
  if (count > SmallOperand::kMaxHoles) return false;
  std::vector<SmallOperand> holes(count);
  std::vector<BoxOf<double>> boxes;
  for (std::size_t k = 0; k < count; ++k) {
    SmallOperand& hole = holes[k];
    hole.exp2 = s.exp2;
    hole.exp10 = s.exp10;
    if (!load(region, region.vertices_of(k + 1), &s.offset, hole) || !drop_straight(hole)) {
      return false;
    }
    set_edges(hole);
    boxes.push_back(box_of(hole));
    const SmallNumberType numbers =
        small_numbers(std::max(s.longest, hole.longest), std::max(s.extent.x, s.extent.y));
    const auto is_clear = [&]<class Number>() {
      return is_clear_hole<Number>(hole, s, std::span(holes).first(k), boxes);
    };
    if (numbers == SmallNumberType::kNone || !with_numbers(numbers, is_clear)) return false;
    s.holes.push_back(hole.extent);
  }
  return true;
}

}  // namespace

bool has_small_size(const Region& region, SmallHoles may_have) {
  return region.polygon_count() == 1 &&
         (may_have == SmallHoles::kSome || region.ring_count() == 1) &&
         region.vertex_count() <= SmallOperand::kMaxVertices && RegionAccess::limbs(region).empty();
}

bool load_small(const Region& region, SmallHoles may_have, SmallOperand& s) {
  if (!has_small_size(region, may_have) || !find_grid(region, s) ||
      !load(region, region.vertices_of(0), nullptr, s) || !drop_straight(s)) {
    return false;
  }
  s.holes.clear();
  orient(s);
  set_edges(s);
  s.turning = s.convex ? 1 : mean_turning(s);
  return true;
}

bool is_clearly_valid(const Region& region, SmallOperand& s) {
  const auto numbers = small_numbers(s.longest, std::max(s.extent.x, s.extent.y));
  return with_numbers(numbers, [&]<class Number>() { return is_simple_ring<Number>(s); }) &&
         read_holes(region, s);
}

bool read_small(const Region& region, SmallHoles may_have, SmallOperand& s) {
  return load_small(region, may_have, s) && is_clearly_valid(region, s);
}

void turn(const SmallOperand& from, int quarters, SmallOperand& to) {
  const int turns = ((quarters % 4) + 4) % 4;
  const std::uint32_t n = from.size;
  to.size = n;
  to.turning = from.turning;
  to.extent = from.extent;
  to.holes = from.holes;
  to.longest = from.longest;
  to.offset = from.offset;
  to.exp2 = from.exp2;
  to.exp10 = from.exp10;
  to.make_rows(n);
  double* const x = to[SmallOperand::kX];
  double* const y = to[SmallOperand::kY];
  for (const auto row : {SmallOperand::kX, SmallOperand::kY, SmallOperand::kVertexSource,
                         SmallOperand::kEdgeSource}) {
    std::copy_n(from[row], n, to[row]);
  }
  for (int k = 0; k < turns; ++k) {
    for (std::uint32_t i = 0; i < n; ++i) x[i] = std::exchange(y[i], x[i]);
    std::swap(to.extent.x, to.extent.y);
    for (std::uint32_t i = 0; i < n; ++i) x[i] = to.extent.x - x[i];
    to.offset = {-(to.offset.y + static_cast<std::int64_t>(to.extent.x)), to.offset.x};
  }
  if (turns % 2 != 0) {
    for (Vec<double>& hole : to.holes) std::swap(hole.x, hole.y);
  }
  find_smallest(to);
  set_edges(to);
}

bool refine(int exp2, int exp10, SmallOperand& s) {
  constexpr auto kMost = static_cast<Int128>(SmallOperand::kWidest);
  Int128 factor = 1;
  for (int k = exp10; k < s.exp10 && factor <= kMost; ++k) factor *= 10;
  for (int k = exp2; k < s.exp2 && factor <= kMost; ++k) factor *= 2;
  const auto extent = static_cast<Int128>(std::max(s.extent.x, s.extent.y));
  if (factor > kMost || extent * factor > kMost || !fits(s.offset.x * factor) ||
      !fits(s.offset.y * factor)) {
    return false;
  }
  const auto times = static_cast<double>(factor);
  for (int row = 0; row < SmallOperand::kVertexSource; ++row) {
    double* const values = s[static_cast<SmallOperand::Row>(row)];
    for (std::uint32_t i = 0; i < s.size; ++i) values[i] *= times;
  }
  const auto by = static_cast<std::int64_t>(factor);
  s.extent = {s.extent.x * times, s.extent.y * times};
  for (Vec<double>& hole : s.holes) hole = {hole.x * times, hole.y * times};
  s.longest *= times;
  s.offset = {s.offset.x * by, s.offset.y * by};
  s.exp2 = exp2;
  s.exp10 = exp10;
  return true;
}

}  // namespace minksum
