#include "sum/small/small_operand.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>

#include "exact/sign.hpp"
#include "region/region_access.hpp"
#include "sum/small/small_grid.hpp"

namespace minksum {
namespace {

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
template <class Integer>
struct RingBox {
  static constexpr Integer kFar =
      std::is_same_v<Integer, Int128> ? Integer{1} << kFarthestBits : Integer{kFarthest};
  Vec<Integer> low{kFar, kFar};
  Vec<Integer> high{-kFar, -kFar};

  [[nodiscard]] Vec<double> extent() const {
    return {static_cast<double>(high.x - low.x), static_cast<double>(high.y - low.y)};
  }
};

/// Calls visit(place) with each vertex as two integers on the operand's grid. Returns false if they
/// are too long.
template <class Integer, class Visit>
bool for_each_place(const Region& region, const IndexRange& ring, const SmallOperand& s,
                    RingBox<Integer>& box, Visit visit) {
  bool fit = true;
  const auto integer = [&](const StoredCoordinate& c) {
    Integer value = c.payload;
    // The exponents of zero are of no matter.
    fit = fit && (value == 0 || scale(c.exp10 - s.exp10, c.exp2 - s.exp2, value));
    return value;
  };
  for (const std::size_t v : ring) {
    const Vec<Integer> at{integer(RegionAccess::x(region, v)), integer(RegionAccess::y(region, v))};
    if (!fit) return false;
    box.low = {std::min(box.low.x, at.x), std::min(box.low.y, at.y)};
    box.high = {std::max(box.high.x, at.x), std::max(box.high.y, at.y)};
    visit(at);
  }
  return true;
}

template <class Integer>
Vec<Int128> widened(const Vec<Integer>& v) {
  return {v.x, v.y};
}

/// Loads the vertices of a ring as they are given, on a grid that is set. Drops repeated ones.
/// Returns false if they are too long integers there, or fewer than three. The origin is the box's
/// lower left corner, unless `origin` is given. The rows get `room` entries or as many as they
/// need. With Int128 as the integer type, the operand is wide.
template <class Integer>
bool load(const Region& region, const IndexRange& ring, const Vec<Int128>* origin, std::size_t room,
          SmallOperand& s) {
  constexpr bool kWide = std::is_same_v<Integer, Int128>;
  const std::size_t n = ring.size();
  if (n < 3) return false;
  s.make_rows(std::max(n, room), kWide);
  double* const x = s[SmallOperand::kX];
  double* const y = s[SmallOperand::kY];
  Vec<Int128>* const whole = s.whole(SmallOperand::kAt);
  RingBox<Integer> box;
  Vec<Integer> first{};
  std::size_t count = 0;
  // Places are seen from the first one, until the box is known.
  const auto set = [&](const Vec<Integer>& at) {
    if (count == 0) first = at;
    if constexpr (kWide) {
      whole[count++] = minus(at, first);
    } else {
      x[count] = static_cast<double>(at.x - first.x);
      y[count++] = static_cast<double>(at.y - first.y);
    }
  };
  if (!for_each_place(region, ring, s, box, set)) return false;
  s.first = widened(first);
  s.extent = box.extent();
  s.whole_extent = widened(minus(box.high, box.low));
  const double widest = kWide ? SmallOperand::kWidestWide : SmallOperand::kWidest;
  if (std::max(s.extent.x, s.extent.y) > widest) return false;
  s.offset = origin != nullptr ? *origin : widened(box.low);
  s.size = 0;
  s.holes.clear();
  s.ends.clear();
  s.turning_of_holes = 0;
  const Vec<Int128> to_first = minus(s.first, s.offset);
  const Vec<double> near_first = rounded(to_first);
  for (std::size_t v = 0; v < n; ++v) {
    // The last of equal vertices stays, because the edge to the next vertex has its index.
    if constexpr (kWide) {
      const Vec<Int128> at = plus(to_first, whole[v]);
      if (s.size != 0 && at.x == whole[s.size - 1].x && at.y == whole[s.size - 1].y) --s.size;
      whole[s.size] = at;
      const Vec<double> near = rounded(at);
      x[s.size] = near.x;
      y[s.size] = near.y;
    } else {
      const Vec<double> at{near_first.x + x[v], near_first.y + y[v]};
      if (s.size != 0 && at.x == x[s.size - 1] && at.y == y[s.size - 1]) --s.size;
      x[s.size] = at.x;
      y[s.size] = at.y;
    }
    const auto source = static_cast<double>(ring.front() + v);
    s[SmallOperand::kVertexSource][s.size] = source;
    s[SmallOperand::kEdgeSource][s.size] = source;
    ++s.size;
  }
  const auto is_first_again = [&](std::uint32_t i) {
    if constexpr (kWide) return whole[i].x == whole[0].x && whole[i].y == whole[0].y;
    return x[i] == x[0] && y[i] == y[0];
  };
  while (s.size > 1 && is_first_again(s.size - 1)) --s.size;
  return s.size >= 3;
}

/// An edge of an operand, as cross products of edges need it.
template <bool kWide>
auto edge(const SmallOperand& s, std::uint32_t i) {
  if constexpr (kWide) {
    return SureVec<Int128>{s.way()[i], s.whole(SmallOperand::kWay)[i]};
  } else {
    return s.way()[i];
  }
}
/// The way from a vertex to another one.
template <bool kWide>
auto way_between(const SmallOperand& s, std::uint32_t from, std::uint32_t to) {
  if constexpr (kWide) {
    const Vec<Int128>* const whole = s.whole(SmallOperand::kAt);
    const Vec<Int128> way = minus(whole[to], whole[from]);
    return SureVec<Int128>{rounded(way), way};
  } else {
    return minus(s.at()[to], s.at()[from]);
  }
}

/// Computes the turn of a ring at a vertex.
auto bends(const SmallOperand& s) {
  const SureLanes<Int128> wide{{0x1p-48 * std::max(s.extent.x, s.extent.y)}};
  return [wide]<class Vector>(const Vector& in, const Vector& out) {
    if constexpr (std::is_same_v<Vector, Vec<double>>) {
      bool unsure = false;
      const double turn = RoundedLanes{unsure}.turn(in, out);
      using Lanes = SureLanes<std::uint64_t>;
      return unsure ? Lanes{}.turn(Lanes::of_whole(in), Lanes::of_whole(out)) : turn;
    } else {
      return wide.turn(in, out);
    }
  };
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

/// Sets edges and convexity, which follow from the places. Returns whether the ring turns at each
/// vertex.
template <bool kWide>
bool set_bends(SmallOperand& s) {
  const std::uint32_t n = s.size;
  s.convex = true;
  s.longest = 0;
  bool turns = true;
  int meetings = 0;
  const auto bend = bends(s);
  auto in = way_between<kWide>(s, n - 1, 0);
  int eighth = eighth_of(near_of(in));
  for (std::uint32_t i = 0; i < n; ++i) {
    const auto out = way_between<kWide>(s, i, i + 1 == n ? 0 : i + 1);
    const double turn = bend(in, out);
    const bool convex = turn > 0;
    const Vec<double>& near_in = near_of(in);
    const Vec<double>& near_out = near_of(out);
    const int before = std::exchange(eighth, eighth_of(near_out));
    meetings += convex ? (eighth - before) & 7 : 0;
    turns &= turn != 0;
    s.convex &= convex;
    s.longest = std::max({s.longest, std::abs(near_out.x), std::abs(near_out.y)});
    s[SmallOperand::kDx][i] = near_out.x;
    s[SmallOperand::kDy][i] = near_out.y;
    s[SmallOperand::kInX][i] = convex ? near_in.x : 0;
    s[SmallOperand::kInY][i] = convex ? near_in.y : 0;
    s[SmallOperand::kOutX][i] = convex ? near_out.x : 0;
    s[SmallOperand::kOutY][i] = convex ? near_out.y : 0;
    if constexpr (kWide) {
      s.whole(SmallOperand::kIn)[i] = in.exact;
      s.whole(SmallOperand::kWay)[i] = out.exact;
    }
    in = out;
  }
  s.turning = meetings / 8.0;
  return turns;
}

/// Drops vertices in the middle of straight edges. Returns false if a vertex is the tip of a spike.
template <bool kWide>
bool drop_straight(SmallOperand& s) {
  std::uint32_t kept = 0;
  const auto bend = bends(s);
  auto in = edge<kWide>(s, s.size - 1);
  for (std::uint32_t i = 0; i < s.size; ++i) {
    const auto out = edge<kWide>(s, i);
    if (bend(in, out) != 0) {
      for (const auto row : {SmallOperand::kX, SmallOperand::kY, SmallOperand::kVertexSource,
                             SmallOperand::kEdgeSource}) {
        s[row][kept] = s[row][i];
      }
      if constexpr (kWide) s.whole(SmallOperand::kAt)[kept] = s.whole(SmallOperand::kAt)[i];
      ++kept;
    } else if (dot(near_of(in), near_of(out)) < 0) {
      return false;
    }
    in = out;
  }
  s.size = kept;
  return kept >= 3;
}

/// Sets what follows from the places. Drops vertices in the middle of straight edges. Returns false
/// if a vertex is the tip of a spike. No vertex may be repeated.
template <bool kWide>
bool set_edges(SmallOperand& s) {
  if (!set_bends<kWide>(s) && (!drop_straight<kWide>(s) || !set_bends<kWide>(s))) return false;
  for (int row = 0; row < SmallOperand::kVertexSource; ++row) {
    double* const values = s[static_cast<SmallOperand::Row>(row)];
    const bool is_place = row == SmallOperand::kX || row == SmallOperand::kY;
    std::fill(values + s.size, values + filled_up(s.size), is_place ? values[0] : 0.0);
  }
  for (int row = 0; kWide && row < SmallOperand::kWholeRows; ++row) {
    Vec<Int128>* const values = s.whole(static_cast<SmallOperand::WholeRow>(row));
    const Vec<Int128> value = row == SmallOperand::kAt ? values[0] : Vec<Int128>{};
    std::fill(values + s.size, values + filled_up(s.size), value);
  }
  return true;
}

/// Turns the ring so that it runs counter-clockwise (positive) or clockwise, and keeps the sources
/// of edges right.
template <bool kWide>
void orient(Sign way, SmallOperand& s) {
  find_smallest(s);
  const std::uint32_t n = s.size;
  const std::uint32_t i = s.smallest;
  if (sign_of(bends(s)(edge<kWide>(s, i == 0 ? n - 1 : i - 1), edge<kWide>(s, i))) == way) return;
  double* const x = s[SmallOperand::kX];
  double* const y = s[SmallOperand::kY];
  std::reverse(x, x + n);
  std::reverse(y, y + n);
  if constexpr (kWide) {
    Vec<Int128>* const whole = s.whole(SmallOperand::kAt);
    std::reverse(whole, whole + n);
  }
  double* const vertex_source = s[SmallOperand::kVertexSource];
  std::reverse(vertex_source, vertex_source + n);
  // The edge that starts here is the one that started at the next vertex.
  std::rotate_copy(vertex_source, vertex_source + 1, vertex_source + n,
                   s[SmallOperand::kEdgeSource]);
  s.smallest = n - 1 - i;
  static_cast<void>(set_edges<kWide>(s));
}

/// Returns how many entries the rows of an operand need.
std::size_t room_of(const Region& region) {
  std::size_t room = 0;
  for (std::size_t ring = 0; ring < region.ring_count(); ++ring) {
    room += filled_up(region.vertices_of(ring).size());
  }
  return room;
}

/// Loads the outer ring and the holes' boxes.
template <class Integer>
bool load_outer(const Region& region, SmallOperand& s) {
  constexpr bool kWide = std::is_same_v<Integer, Int128>;
  if (!load<Integer>(region, region.vertices_of(0), nullptr, room_of(region), s) ||
      !set_edges<kWide>(s)) {
    return false;
  }
  orient<kWide>(kPositive, s);
  s.entries = s.size;
  for (std::size_t ring = 1; ring < region.ring_count(); ++ring) {
    RingBox<Integer> box;
    if (!for_each_place(region, region.vertices_of(ring), s, box, [](const auto&) {})) return false;
    s.holes.push_back(box.extent());
  }
  return true;
}

}  // namespace

void find_smallest(SmallOperand& s) {
  const double* const x = s[SmallOperand::kX];
  const double* const y = s[SmallOperand::kY];
  const Vec<Int128>* const whole = std::as_const(s).whole(SmallOperand::kAt);
  // Rounding keeps the order of numbers that it does not make equal.
  const auto is_less = [&](std::uint32_t i, std::uint32_t j) {
    if (whole != nullptr && x[i] == x[j] && whole[i].x != whole[j].x) {
      return whole[i].x < whole[j].x;
    }
    if (x[i] != x[j]) return x[i] < x[j];
    return whole != nullptr ? whole[i].y < whole[j].y : y[i] < y[j];
  };
  s.smallest = 0;
  for (std::uint32_t i = 1; i < s.size; ++i) {
    if (is_less(i, s.smallest)) s.smallest = i;
  }
}

bool load_hole(const Region& region, std::size_t ring, const SmallOperand& s, SmallOperand& hole) {
  hole.exp2 = s.exp2;
  hole.exp10 = s.exp10;
  const IndexRange vertices = region.vertices_of(ring);
  if (s.is_wide()) {
    return load<Int128>(region, vertices, &s.offset, 0, hole) && set_edges<true>(hole);
  }
  return load<std::int64_t>(region, vertices, &s.offset, 0, hole) && set_edges<false>(hole);
}

void add_hole(SmallOperand& hole, SmallOperand& s) {
  s.is_wide() ? orient<true>(kNegative, hole) : orient<false>(kNegative, hole);
  const auto begin = static_cast<std::uint32_t>(filled_up(s.entries));
  for (int row = 0; row < SmallOperand::kRows; ++row) {
    const auto at = static_cast<SmallOperand::Row>(row);
    std::copy_n(hole[at], filled_up(hole.size), s[at] + begin);
  }
  for (int row = 0; s.is_wide() && row < SmallOperand::kWholeRows; ++row) {
    const auto at = static_cast<SmallOperand::WholeRow>(row);
    std::copy_n(hole.whole(at), filled_up(hole.size), s.whole(at) + begin);
  }
  s.entries = begin + hole.size;
  s.ends.push_back(s.entries);
  s.longest = std::max(s.longest, hole.longest);
  s.turning_of_holes += hole.turning;
}

bool has_small_size(const Region& region) {
  return region.polygon_count() == 1 && region.ring_count() <= 1 + SmallOperand::kMaxHoles &&
         region.vertex_count() <= SmallOperand::kMaxVertices && RegionAccess::limbs(region).empty();
}

bool load_small(const Region& region, SmallOperand& s) {
  return has_small_size(region) && find_grid(region, s) &&
         (load_outer<std::int64_t>(region, s) || load_outer<Int128>(region, s));
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

}  // namespace minksum
