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

constexpr int kMostTwos = 60;  // a higher power of two is beyond the largest offset, too
constexpr auto kPowersOfTen = [] {
  std::array<std::int64_t, 19> powers{1};
  for (std::size_t k = 1; k < powers.size(); ++k) powers[k] = 10 * powers[k - 1];
  return powers;
}();
/// Multiplies by 10^tens · 2^twos. Returns false if the product is too large for an offset.
inline bool scale(int tens, int twos, std::int64_t& value) {
  if ((tens | twos) == 0) return -kFarthest <= value && value <= kFarthest;
  if (tens >= static_cast<int>(kPowersOfTen.size()) || twos > kMostTwos) return value == 0;
  return !__builtin_mul_overflow(value, kPowersOfTen[static_cast<std::size_t>(tens)], &value) &&
         !__builtin_mul_overflow(value, std::int64_t{1} << twos, &value) && -kFarthest <= value &&
         value <= kFarthest;
}

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

/// The vertices of a ring as integers, and their box.
struct RingPlaces {
  std::array<Vec<std::int64_t>, SmallOperand::kMaxVertices> at;
  Vec<std::int64_t> low{kFarthest, kFarthest};
  Vec<std::int64_t> high{-kFarthest, -kFarthest};

  [[nodiscard]] Vec<double> extent() const {
    return {static_cast<double>(high.x - low.x), static_cast<double>(high.y - low.y)};
  }
};

/// Returns false if the vertices are no short integers on the operand's grid.
bool place_vertices(const Region& region, const IndexRange& ring, const SmallOperand& s,
                    RingPlaces& places) {
  bool fit = true;
  const auto integer = [&](const StoredCoordinate& c) {
    std::int64_t value = c.payload;
    // The exponents of zero are of no matter.
    fit = fit && (value == 0 || scale(c.exp10 - s.exp10, c.exp2 - s.exp2, value));
    return value;
  };
  for (std::size_t v = 0; v < ring.size(); ++v) {
    const Vec<std::int64_t> at{integer(RegionAccess::x(region, ring.front() + v)),
                               integer(RegionAccess::y(region, ring.front() + v))};
    if (!fit) return false;
    places.at[v] = at;
    places.low = {std::min(places.low.x, at.x), std::min(places.low.y, at.y)};
    places.high = {std::max(places.high.x, at.x), std::max(places.high.y, at.y)};
  }
  return true;
}

/// Loads the vertices of a ring as they are given, on a grid that is set. Drops repeated ones.
/// Returns false if they are no short integers there, or fewer than three. The origin is the box's
/// lower left corner, unless `origin` is given.
bool load(const Region& region, const IndexRange& ring, const Vec<std::int64_t>* origin,
          SmallOperand& s) {
  const std::size_t n = ring.size();
  RingPlaces places;
  if (n < 3 || !place_vertices(region, ring, s, places)) return false;
  s.extent = places.extent();
  if (std::max(s.extent.x, s.extent.y) > SmallOperand::kWidest) return false;
  const Vec<std::int64_t> low = origin != nullptr ? *origin : places.low;
  s.offset = low;
  s.first = places.at[0];
  s.make_rows(n);
  s.size = 0;
  for (std::uint32_t v = 0; v < n; ++v) {
    const Vec<std::int64_t>& at = places.at[v];
    // The last of equal vertices stays, because the edge to the next vertex has its index.
    if (v != 0 && at.x == places.at[v - 1].x && at.y == places.at[v - 1].y) --s.size;
    s[SmallOperand::kX][s.size] = static_cast<double>(at.x - low.x);
    s[SmallOperand::kY][s.size] = static_cast<double>(at.y - low.y);
    s[SmallOperand::kVertexSource][s.size] = v;
    s[SmallOperand::kEdgeSource][s.size] = v;
    ++s.size;
  }
  const double* const x = s[SmallOperand::kX];
  const double* const y = s[SmallOperand::kY];
  while (s.size > 1 && x[s.size - 1] == x[0] && y[s.size - 1] == y[0]) --s.size;
  return s.size >= 3;
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

Vec<double> edge(const SmallOperand& s, std::uint32_t i) {
  return {s[SmallOperand::kDx][i], s[SmallOperand::kDy][i]};
}

/// The ways from and to the vertices of a ring, and to which side the ring turns there.
struct RingBends {
  std::array<double, SmallOperand::kMaxVertices> at;

  /// Sets the edges, too. Returns whether the ring turns at each vertex.
  bool set(SmallOperand& s) {
    const double* const x = s[SmallOperand::kX];
    const double* const y = s[SmallOperand::kY];
    double* const dx = s[SmallOperand::kDx];
    double* const dy = s[SmallOperand::kDy];
    const std::uint32_t last = s.size - 1;
    for (std::uint32_t i = 0; i < last; ++i) {
      dx[i] = x[i + 1] - x[i];
      dy[i] = y[i + 1] - y[i];
    }
    dx[last] = x[0] - x[last];
    dy[last] = y[0] - y[last];
    bool all = true;
    Vec<double> in{dx[last], dy[last]};
    for (std::uint32_t i = 0; i < s.size; ++i) {
      const Vec<double> out{dx[i], dy[i]};
      at[i] = SureCross<Int128>{}(in, out);
      all &= at[i] != 0;
      in = out;
    }
    return all;
  }
};

/// Drops vertices in the middle of straight edges. Returns false if a vertex is the tip of a spike.
bool drop_straight(SmallOperand& s, const RingBends& bends) {
  const double* const dx = s[SmallOperand::kDx];
  const double* const dy = s[SmallOperand::kDy];
  std::uint32_t kept = 0;
  std::uint32_t before = s.size - 1;
  for (std::uint32_t i = 0; i < s.size; ++i) {
    if (bends.at[i] != 0) {
      for (const auto row : {SmallOperand::kX, SmallOperand::kY, SmallOperand::kVertexSource,
                             SmallOperand::kEdgeSource}) {
        s[row][kept] = s[row][i];
      }
      ++kept;
    } else if (dx[before] * dx[i] + dy[before] * dy[i] < 0) {
      return false;
    }
    before = i;
  }
  s.size = kept;
  return kept >= 3;
}

/// Sets edges and convexity, which follow from the places. Drops vertices in the middle of straight
/// edges. Returns false if a vertex is the tip of a spike. No vertex may be repeated.
bool set_edges(SmallOperand& s) {
  RingBends bends;
  if (!bends.set(s) && (!drop_straight(s, bends) || !bends.set(s))) return false;
  const std::uint32_t n = s.size;
  const double* const dx = s[SmallOperand::kDx];
  const double* const dy = s[SmallOperand::kDy];
  s.convex = true;
  s.longest = 0;
  std::uint32_t before = n - 1;
  for (std::uint32_t i = 0; i < n; ++i) {
    const bool convex = bends.at[i] > 0;
    s.convex &= convex;
    s.longest = std::max({s.longest, std::abs(dx[i]), std::abs(dy[i])});
    s[SmallOperand::kInX][i] = convex ? dx[before] : 0;
    s[SmallOperand::kInY][i] = convex ? dy[before] : 0;
    s[SmallOperand::kOutX][i] = convex ? dx[i] : 0;
    s[SmallOperand::kOutY][i] = convex ? dy[i] : 0;
    before = i;
  }
  for (int row = 0; row < SmallOperand::kVertexSource; ++row) {
    double* const values = s[static_cast<SmallOperand::Row>(row)];
    std::fill(values + n, values + filled_up(n), 0.0);
  }
  return true;
}

/// Makes the ring counter-clockwise, and keeps the sources of edges right.
void orient(SmallOperand& s) {
  find_smallest(s);
  const std::uint32_t n = s.size;
  const std::uint32_t i = s.smallest;
  const Vec<double> in = edge(s, i == 0 ? n - 1 : i - 1);
  if (SureCross<Int128>{}(in, edge(s, i)) > 0) return;
  double* const x = s[SmallOperand::kX];
  double* const y = s[SmallOperand::kY];
  std::reverse(x, x + n);
  std::reverse(y, y + n);
  double* const vertex_source = s[SmallOperand::kVertexSource];
  std::reverse(vertex_source, vertex_source + n);
  // The edge that starts here is the one that started at the next vertex.
  std::rotate_copy(vertex_source, vertex_source + 1, vertex_source + n,
                   s[SmallOperand::kEdgeSource]);
  s.smallest = n - 1 - i;
  static_cast<void>(set_edges(s));
}

/// Returns in which eighth of the circle a vector lies, counter-clockwise from the positive x axis.
int eighth_of(const Vec<double>& d) {
  const bool lower = d.y < 0 || (d.y == 0 && d.x < 0);
  const Vec<double> upper{lower ? -d.x : d.x, lower ? -d.y : d.y};
  const int eighth = upper.x > 0 ? (upper.y >= upper.x ? 1 : 0) : (-upper.x >= upper.y ? 3 : 2);
  return eighth + (lower ? 4 : 0);
}

double mean_turning(const SmallOperand& s) {
  const SmallRows rows(s);
  int meetings = 0;
  int in = eighth_of({rows.dx[s.size - 1], rows.dy[s.size - 1]});
  for (std::uint32_t v = 0; v < s.size; ++v) {
    const int out = eighth_of({rows.dx[v], rows.dy[v]});
    const bool convex = s[SmallOperand::kInX][v] != 0 || s[SmallOperand::kInY][v] != 0;
    meetings += convex ? (out - in) & 7 : 0;
    in = out;
  }
  return meetings / 8.0;
}

template <class Number>
bool is_simple_ring(const SmallOperand& s) {
  return with_vectors(
      widest_vectors(), [&]() __attribute__((always_inline)) { return is_simple<Number>(s); });
}
template <class Number>
bool do_rings_meet(const SmallOperand& a, const SmallOperand& b) {
  return with_vectors(
      widest_vectors(), [&]() __attribute__((always_inline)) { return do_meet<Number>(a, b); });
}

/// Whether a hole is simple and lies inside the outer ring, apart from the holes before it.
template <class Number>
bool is_clear_hole(const SmallOperand& hole, const SmallOperand& outer,
                   std::span<const SmallOperand> before, std::span<const BoxOf<double>> boxes) {
  const BoxOf<double>& box = boxes[before.size()];
  if (box.x0 < 0 || box.y0 < 0 || box.x1 > outer.extent.x || box.y1 > outer.extent.y ||
      !is_simple_ring<Number>(hole) || !holds<Number>(outer, hole) ||
      do_rings_meet<Number>(hole, outer)) {
    return false;
  }
  for (std::size_t l = 0; l < before.size(); ++l) {
    if (box.meets(boxes[l]) && (do_rings_meet<Number>(hole, before[l]) ||
                                holds<Number>(hole, before[l]) || holds<Number>(before[l], hole))) {
      return false;
    }
  }
  return true;
}

/// Returns false if a hole is not clearly valid, or if two rings touch.
bool are_holes_clearly_valid(const Region& region, const SmallOperand& s, SmallHoles& holes) {
  const std::size_t count = s.holes.size();
  if (holes.rings.size() < count) holes.rings.resize(count);
  holes.boxes.clear();
  for (std::size_t k = 0; k < count; ++k) {
    SmallOperand& hole = holes.rings[k];
    hole.exp2 = s.exp2;
    hole.exp10 = s.exp10;
    if (!load(region, region.vertices_of(k + 1), &s.offset, hole) || !set_edges(hole)) {
      return false;
    }
    holes.boxes.push_back(box_of(hole));
    const SmallNumberType numbers =
        small_numbers(std::max(s.longest, hole.longest), std::max(s.extent.x, s.extent.y));
    const auto is_clear = [&]<class Number>() {
      return is_clear_hole<Number>(hole, s, std::span(holes.rings).first(k), holes.boxes);
    };
    if (numbers == SmallNumberType::kNone || !with_numbers(numbers, is_clear)) return false;
  }
  return true;
}

}  // namespace

bool has_small_size(const Region& region) {
  return region.polygon_count() == 1 && region.ring_count() <= 1 + SmallOperand::kMaxHoles &&
         region.vertex_count() <= SmallOperand::kMaxVertices && RegionAccess::limbs(region).empty();
}

bool load_small(const Region& region, SmallOperand& s) {
  if (!has_small_size(region) || !find_grid(region, s) ||
      !load(region, region.vertices_of(0), nullptr, s) || !set_edges(s)) {
    return false;
  }
  s.holes.clear();
  for (std::size_t ring = 1; ring < region.ring_count(); ++ring) {
    RingPlaces places;
    if (!place_vertices(region, region.vertices_of(ring), s, places)) return false;
    s.holes.push_back(places.extent());
  }
  orient(s);
  s.turning = mean_turning(s);
  return true;
}

bool is_clearly_valid(const Region& region, const SmallOperand& s, SmallHoles& holes) {
  const auto numbers = small_numbers(s.longest, std::max(s.extent.x, s.extent.y));
  const auto is_simple = [&]<class Number>() { return is_simple_ring<Number>(s); };
  // A ring that turns left everywhere, and goes round once, is simple.
  const bool goes_round_once = s.convex && s.turning == 1;
  return (goes_round_once || with_numbers(numbers, is_simple)) &&
         are_holes_clearly_valid(region, s, holes);
}

bool read_small(const Region& region, SmallHoles& holes, SmallOperand& small) {
  return load_small(region, small) && is_clearly_valid(region, small, holes);
}

void turn(const SmallOperand& from, int quarters, SmallOperand& to) {
  const int turns = ((quarters % 4) + 4) % 4;
  const std::uint32_t n = from.size;
  to.size = n;
  to.turning = from.turning;
  to.extent = from.extent;
  to.holes = from.holes;
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
  static_cast<void>(set_edges(to));
}

double refinement(int exp2, int exp10, const SmallOperand& s) {
  const int tens = s.exp10 - exp10;
  const int twos = s.exp2 - exp2;
  if ((tens | twos) == 0) return 1;
  std::int64_t factor = 1;
  Vec<std::int64_t> offset = s.offset;
  const bool fine =
      scale(tens, twos, factor) && scale(tens, twos, offset.x) && scale(tens, twos, offset.y);
  const auto times = static_cast<double>(factor);
  const double width = times * std::max(s.extent.x, s.extent.y);
  return fine && width <= SmallOperand::kWidest ? times : 0;
}

bool refine(int exp2, int exp10, const SmallOperand& from, SmallOperand& to) {
  const double times = refinement(exp2, exp10, from);
  if (times == 0) return false;
  const auto by = static_cast<std::int64_t>(times);
  to.size = from.size;
  to.smallest = from.smallest;
  to.convex = from.convex;
  to.turning = from.turning;
  to.extent = {from.extent.x * times, from.extent.y * times};
  to.holes.resize(from.holes.size());
  for (std::size_t k = 0; k < from.holes.size(); ++k) {
    to.holes[k] = {from.holes[k].x * times, from.holes[k].y * times};
  }
  to.longest = from.longest * times;
  to.offset = {from.offset.x * by, from.offset.y * by};
  to.first = from.first;
  to.exp2 = exp2;
  to.exp10 = exp10;
  if (&to != &from) to.make_rows(from.size);
  for (int row = 0; row < SmallOperand::kRows; ++row) {
    const double* const values = from[static_cast<SmallOperand::Row>(row)];
    double* const scaled = to[static_cast<SmallOperand::Row>(row)];
    const double factor = row < SmallOperand::kVertexSource ? times : 1;
    for (std::size_t i = 0; i < filled_up(from.size); ++i) scaled[i] = values[i] * factor;
  }
  return true;
}

}  // namespace minksum
