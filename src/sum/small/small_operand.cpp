#include "sum/small/small_operand.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "exact/sign.hpp"
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

/// The box of a ring's vertices as integers.
struct RingBox {
  Vec<std::int64_t> low{kFarthest, kFarthest};
  Vec<std::int64_t> high{-kFarthest, -kFarthest};

  [[nodiscard]] Vec<double> extent() const {
    return {static_cast<double>(high.x - low.x), static_cast<double>(high.y - low.y)};
  }
};

/// Calls visit(place) with each vertex as two integers on the operand's grid. Returns false if they
/// are no short ones.
template <class Visit>
bool for_each_place(const Region& region, const IndexRange& ring, const SmallOperand& s,
                    RingBox& box, Visit visit) {
  bool fit = true;
  const auto integer = [&](const StoredCoordinate& c) {
    std::int64_t value = c.payload;
    // The exponents of zero are of no matter.
    fit = fit && (value == 0 || scale(c.exp10 - s.exp10, c.exp2 - s.exp2, value));
    return value;
  };
  for (const std::size_t v : ring) {
    const Vec<std::int64_t> at{integer(RegionAccess::x(region, v)),
                               integer(RegionAccess::y(region, v))};
    if (!fit) return false;
    box.low = {std::min(box.low.x, at.x), std::min(box.low.y, at.y)};
    box.high = {std::max(box.high.x, at.x), std::max(box.high.y, at.y)};
    visit(at);
  }
  return true;
}

/// Loads the vertices of a ring as they are given, on a grid that is set. Drops repeated ones.
/// Returns false if they are no short integers there, or fewer than three. The origin is the box's
/// lower left corner, unless `origin` is given. The rows get `room` entries or as many as they
/// need.
bool load(const Region& region, const IndexRange& ring, const Vec<std::int64_t>* origin,
          std::size_t room, SmallOperand& s) {
  const std::size_t n = ring.size();
  if (n < 3) return false;
  s.make_rows(std::max(n, room));
  double* const x = s[SmallOperand::kX];
  double* const y = s[SmallOperand::kY];
  RingBox box;
  std::size_t count = 0;
  const auto set = [&](const Vec<std::int64_t>& at) {
    if (count == 0) s.first = at;
    x[count] = static_cast<double>(at.x - s.first.x);
    y[count++] = static_cast<double>(at.y - s.first.y);
  };
  if (!for_each_place(region, ring, s, box, set)) return false;
  s.extent = box.extent();
  if (std::max(s.extent.x, s.extent.y) > SmallOperand::kWidest) return false;
  s.offset = origin != nullptr ? *origin : box.low;
  s.size = 0;
  s.holes.clear();
  s.turning_of_holes = 0;
  const Vec<double> first{static_cast<double>(s.first.x - s.offset.x),
                          static_cast<double>(s.first.y - s.offset.y)};
  for (std::size_t v = 0; v < n; ++v) {
    const Vec<double> at{first.x + x[v], first.y + y[v]};
    // The last of equal vertices stays, because the edge to the next vertex has its index.
    if (s.size != 0 && at.x == x[s.size - 1] && at.y == y[s.size - 1]) --s.size;
    x[s.size] = at.x;
    y[s.size] = at.y;
    const auto source = static_cast<double>(ring.front() + v);
    s[SmallOperand::kVertexSource][s.size] = source;
    s[SmallOperand::kEdgeSource][s.size] = source;
    ++s.size;
  }
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

/// Returns in which eighth of the circle a vector lies, counter-clockwise. Of the eighths' borders,
/// those of the axes and diagonals, each belongs to one of them.
int eighth_of(const Vec<double>& d) {
  constexpr std::array<int, 8> kEighths{0, 1, 7, 6, 3, 2, 4, 5};
  const int left = d.x < 0 ? 4 : 0;
  const int down = d.y < 0 ? 2 : 0;
  const int steep = std::abs(d.y) >= std::abs(d.x) ? 1 : 0;
  return kEighths[static_cast<std::size_t>(left + down + steep)];
}

/// The turn of a ring at a vertex.
double bend(const Vec<double>& in, const Vec<double>& out) { return SureCross<Int128>{}(in, out); }

/// Sets edges and convexity, which follow from the places. Returns whether the ring turns at each
/// vertex.
bool set_bends(SmallOperand& s) {
  const std::uint32_t n = s.size;
  const double* const x = s[SmallOperand::kX];
  const double* const y = s[SmallOperand::kY];
  s.convex = true;
  s.longest = 0;
  bool turns = true;
  int meetings = 0;
  Vec<double> in{x[0] - x[n - 1], y[0] - y[n - 1]};
  int eighth = eighth_of(in);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = i + 1 == n ? 0 : i + 1;
    const Vec<double> out{x[next] - x[i], y[next] - y[i]};
    const double turn = bend(in, out);
    const bool convex = turn > 0;
    const int before = std::exchange(eighth, eighth_of(out));
    meetings += convex ? (eighth - before) & 7 : 0;
    turns &= turn != 0;
    s.convex &= convex;
    s.longest = std::max({s.longest, std::abs(out.x), std::abs(out.y)});
    s[SmallOperand::kDx][i] = out.x;
    s[SmallOperand::kDy][i] = out.y;
    s[SmallOperand::kInX][i] = convex ? in.x : 0;
    s[SmallOperand::kInY][i] = convex ? in.y : 0;
    s[SmallOperand::kOutX][i] = convex ? out.x : 0;
    s[SmallOperand::kOutY][i] = convex ? out.y : 0;
    in = out;
  }
  s.turning = meetings / 8.0;
  return turns;
}

/// Drops vertices in the middle of straight edges. Returns false if a vertex is the tip of a spike.
bool drop_straight(SmallOperand& s) {
  std::uint32_t kept = 0;
  Vec<double> in = edge(s, s.size - 1);
  for (std::uint32_t i = 0; i < s.size; ++i) {
    const Vec<double> out = edge(s, i);
    if (bend(in, out) != 0) {
      for (const auto row : {SmallOperand::kX, SmallOperand::kY, SmallOperand::kVertexSource,
                             SmallOperand::kEdgeSource}) {
        s[row][kept] = s[row][i];
      }
      ++kept;
    } else if (dot(in, out) < 0) {
      return false;
    }
    in = out;
  }
  s.size = kept;
  return kept >= 3;
}

/// Sets what follows from the places. Drops vertices in the middle of straight edges. Returns false
/// if a vertex is the tip of a spike. No vertex may be repeated.
bool set_edges(SmallOperand& s) {
  if (!set_bends(s) && (!drop_straight(s) || !set_bends(s))) return false;
  for (int row = 0; row < SmallOperand::kVertexSource; ++row) {
    double* const values = s[static_cast<SmallOperand::Row>(row)];
    const bool is_place = row == SmallOperand::kX || row == SmallOperand::kY;
    std::fill(values + s.size, values + filled_up(s.size), is_place ? values[0] : 0.0);
  }
  return true;
}

/// Turns the ring so that it runs counter-clockwise (positive) or clockwise, and keeps the sources
/// of edges right.
void orient(Sign way, SmallOperand& s) {
  find_smallest(s);
  const std::uint32_t n = s.size;
  const std::uint32_t i = s.smallest;
  const Vec<double> in = edge(s, i == 0 ? n - 1 : i - 1);
  if (sign_of(SureCross<Int128>{}(in, edge(s, i))) == way) return;
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

/// Returns how many entries the rows of an operand need.
std::size_t room_of(const Region& region) {
  std::size_t room = 0;
  for (std::size_t ring = 0; ring < region.ring_count(); ++ring) {
    room += filled_up(region.vertices_of(ring).size());
  }
  return room;
}

}  // namespace

bool load_hole(const Region& region, std::size_t ring, const SmallOperand& s, SmallOperand& hole) {
  hole.exp2 = s.exp2;
  hole.exp10 = s.exp10;
  return load(region, region.vertices_of(ring), &s.offset, 0, hole) && set_edges(hole);
}

void add_hole(SmallOperand& hole, SmallOperand& s) {
  orient(kNegative, hole);
  const auto begin = static_cast<std::uint32_t>(filled_up(s.entries));
  for (int row = 0; row < SmallOperand::kRows; ++row) {
    const auto at = static_cast<SmallOperand::Row>(row);
    std::copy_n(hole[at], filled_up(hole.size), s[at] + begin);
  }
  s.entries = begin + hole.size;
  s.longest = std::max(s.longest, hole.longest);
  s.turning_of_holes += hole.turning;
}

bool has_small_size(const Region& region) {
  return region.polygon_count() == 1 && region.ring_count() <= 1 + SmallOperand::kMaxHoles &&
         region.vertex_count() <= SmallOperand::kMaxVertices && RegionAccess::limbs(region).empty();
}

bool load_small(const Region& region, SmallOperand& s) {
  if (!has_small_size(region) || !find_grid(region, s) ||
      !load(region, region.vertices_of(0), nullptr, room_of(region), s) || !set_edges(s)) {
    return false;
  }
  orient(kPositive, s);
  s.entries = s.size;
  for (std::size_t ring = 1; ring < region.ring_count(); ++ring) {
    RingBox box;
    if (!for_each_place(region, region.vertices_of(ring), s, box, [](const auto&) {})) return false;
    s.holes.push_back(box.extent());
  }
  return true;
}

bool load_valid(const Region& region, SmallOperand& s) {
  if (!load_small(region, s)) return false;
  SmallOperand hole;
  for (std::size_t ring = 1; ring < region.ring_count(); ++ring) {
    if (!load_hole(region, ring, s, hole)) return false;
    add_hole(hole, s);
  }
  return true;
}

void turn(const SmallOperand& from, int quarters, SmallOperand& to) {
  const int turns = ((quarters % 4) + 4) % 4;
  to = from;
  const std::size_t entries = filled_up(to.entries);
  using Rows = std::pair<SmallOperand::Row, SmallOperand::Row>;
  for (int k = 0; k < turns; ++k) {
    for (const auto& [row_x, row_y] :
         {Rows{SmallOperand::kX, SmallOperand::kY}, Rows{SmallOperand::kDx, SmallOperand::kDy},
          Rows{SmallOperand::kInX, SmallOperand::kInY},
          Rows{SmallOperand::kOutX, SmallOperand::kOutY}}) {
      const double width = row_x == SmallOperand::kX ? to.extent.y : 0;
      double* const x = to[row_x];
      double* const y = to[row_y];
      for (std::size_t i = 0; i < entries; ++i) {
        const double before = std::exchange(y[i], x[i]);
        x[i] = width - before;
      }
    }
    std::swap(to.extent.x, to.extent.y);
    for (Vec<double>& hole : to.holes) std::swap(hole.x, hole.y);
    to.offset = {-(to.offset.y + static_cast<std::int64_t>(to.extent.x)), to.offset.x};
  }
  find_smallest(to);
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

bool refine(int exp2, int exp10, std::uint32_t entries, const SmallOperand& from,
            SmallOperand& to) {
  const double times = refinement(exp2, exp10, from);
  if (times == 0) return false;
  const auto by = static_cast<std::int64_t>(times);
  to.size = from.size;
  to.smallest = from.smallest;
  to.convex = from.convex;
  to.turning = from.turning;
  to.extent = {from.extent.x * times, from.extent.y * times};
  to.turning_of_holes = from.turning_of_holes;
  to.entries = entries;
  to.holes = from.holes;
  for (Vec<double>& hole : to.holes) hole = {hole.x * times, hole.y * times};
  to.longest = from.longest * times;
  to.offset = {from.offset.x * by, from.offset.y * by};
  to.first = from.first;
  to.exp2 = exp2;
  to.exp10 = exp10;
  const std::size_t room = filled_up(entries);
  if (&to != &from) to.make_rows(room);
  for (int row = 0; row < SmallOperand::kRows; ++row) {
    const double* const values = from[static_cast<SmallOperand::Row>(row)];
    double* const scaled = to[static_cast<SmallOperand::Row>(row)];
    const double factor = row < SmallOperand::kVertexSource ? times : 1;
    for (std::size_t i = 0; i < room; ++i) scaled[i] = values[i] * factor;
  }
  return true;
}

}  // namespace minksum
