#include "small_sum/small_sum.hpp"

#include <algorithm>

#include "machine/vectors.hpp"
#include "number/wide_int.hpp"
#include "region/region_access.hpp"
#include "small_sum/outer_walk.hpp"

namespace minksum {
namespace {

/// Corners of the sum to vertices of a region.
class SmallWriter {
 public:
  SmallWriter(const SmallOperand& p, const SmallOperand& q, std::size_t corners, Region& region)
      : p_(p),
        q_(q),
        offset_{p.offset.x + q.offset.x, p.offset.y + q.offset.y},
        exp2_(static_cast<std::int16_t>(p.exp2)),
        exp10_(static_cast<std::int16_t>(p.exp10)),
        region_(region) {
    region.clear();
    RegionAccess::make_ring(region, corners, true);
  }
  void add(double x, double y, bool edge_of_first, SmallOrigin origin) {
    set(compact(static_cast<std::int64_t>(x) + offset_.x),
        compact(static_cast<std::int64_t>(y) + offset_.y), edge_of_first, origin);
  }
  void add(const SmallSegments& s, const SmallCorner& corner) {
    const std::uint32_t i = corner.segment;
    const bool first = i < s.first_size;
    if (corner.along == 0) return add(s.x[i], s.y[i], first, s.origin[i]);
    const StoredCoordinate x = store(s.x[i], s.dx[i], corner, offset_.x);
    const StoredCoordinate y = store(s.y[i], s.dy[i], corner, offset_.y);
    set(x, y, first, s.origin[i]);
  }
  /// When all corners are there: they may be fewer.
  void finish() { RegionAccess::keep_vertices(region_, size_); }

 private:
  [[nodiscard]] StoredCoordinate compact(std::int64_t value) const {
    return value == 0 ? StoredCoordinate{} : StoredCoordinate{value, exp2_, exp10_, 0, 0};
  }
  StoredCoordinate store(double start, double way, const SmallCorner& corner, std::int64_t offset) {
    const auto whole = static_cast<std::int64_t>(corner.whole);
    const Int128 moved =
        Int128{static_cast<std::int64_t>(way)} * static_cast<std::int64_t>(corner.along);
    const std::int64_t base = static_cast<std::int64_t>(start) + offset;
    const Int128 part = moved / whole;
    if (part * whole == moved) return compact(base + static_cast<std::int64_t>(part));
    const Int128 above = moved + Int128{base} * whole;
    const auto magnitude = static_cast<Uint128>(above < 0 ? -above : above);
    const auto low = static_cast<std::uint64_t>(magnitude);
    const auto high = static_cast<std::uint64_t>(magnitude >> 64);
    auto& limbs = RegionAccess::mutable_limbs(region_);
    const auto place = static_cast<std::int64_t>(limbs.size());
    std::uint16_t count = 1;
    limbs.push_back(low);
    if (high != 0) {
      limbs.push_back(high);
      count = 2;
    }
    limbs.push_back(static_cast<std::uint64_t>(whole));
    if (above < 0) count |= kNegativeLimbs;
    return {place, exp2_, exp10_, count, 1};
  }
  void set(const StoredCoordinate& x, const StoredCoordinate& y, bool edge_of_first,
           SmallOrigin origin) {
    RegionAccess::set_vertex(region_, size_, x, y);
    RegionAccess::set_origin(region_, size_++, source(edge_of_first, origin));
  }
  [[nodiscard]] EdgeOrigin source(bool edge_of_first, SmallOrigin origin) const {
    const SmallOperand& edges = edge_of_first ? p_ : q_;
    const SmallOperand& vertices = edge_of_first ? q_ : p_;
    return {edge_of_first ? Operand::kFirst : Operand::kSecond, edges.edge_source[origin.edge],
            vertices.vertex_source[origin.vertex]};
  }

  const SmallOperand& p_;
  const SmallOperand& q_;
  Vec<std::int64_t> offset_;
  std::int16_t exp2_;
  std::int16_t exp10_;
  Region& region_;
  std::size_t size_ = 0;
};

/// Edges of both in the order of their directions: all of the boundary.
void merge_convex(const SmallOperand& p, const SmallOperand& q, Region& result) {
  SmallWriter writer(p, q, p.size + q.size, result);
  std::uint32_t i = p.smallest;
  std::uint32_t j = q.smallest;
  std::uint32_t left_p = p.size;
  std::uint32_t left_q = q.size;
  while (left_p + left_q > 0) {
    // Neither is half a circle behind the other one: edges of a convex ring turn by less.
    const double turn = left_p == 0 ? -1 : left_q == 0 ? 1 : p.dx[i] * q.dy[j] - p.dy[i] * q.dx[j];
    const SmallOrigin origin =
        turn >= 0 ? SmallOrigin{static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(j)}
                  : SmallOrigin{static_cast<std::uint8_t>(j), static_cast<std::uint8_t>(i)};
    writer.add(p.x[i] + q.x[j], p.y[i] + q.y[j], turn >= 0, origin);
    if (turn >= 0) {
      i = i + 1 == p.size ? 0 : i + 1;
      --left_p;
    }
    if (turn <= 0) {
      j = j + 1 == q.size ? 0 : j + 1;
      --left_q;
    }
  }
  writer.finish();
}

bool walk(const SmallOperand& p, const SmallOperand& q, Region& result) {
  SmallSegments segments;
  SmallBoundary boundary;
  const double start_x = p.x[p.smallest] + q.x[q.smallest];
  const double start_y = p.y[p.smallest] + q.y[q.smallest];
  const auto find = [&]() __attribute__((always_inline)) {
    if (!list_segments(p, q, segments)) return false;
    SmallMeetings meetings;
    find_meetings(segments, meetings);
    return OuterWalk(segments, meetings, boundary).run(start_x, start_y);
  };
  if (!with_vectors(widest_vectors(), find)) return false;
  SmallWriter writer(p, q, boundary.size, result);
  for (std::uint32_t k = 0; k < boundary.size; ++k) writer.add(segments, boundary.corners[k]);
  return true;
}

}  // namespace

bool allow_small(const Limits& limits) {
  constexpr std::uint64_t kMost = kMaxSmallSegments * kMaxSmallSegments;
  return limits.max_segments >= kMost && limits.max_crossings >= kMost;
}

bool sum_small(const SmallOperand& p, const SmallOperand& q, Region& result) {
  if (p.exp2 != q.exp2 || p.exp10 != q.exp10) {
    const int exp2 = std::min(p.exp2, q.exp2);
    const int exp10 = std::min(p.exp10, q.exp10);
    SmallOperand fine_p = p;
    SmallOperand fine_q = q;
    return refine(exp2, exp10, fine_p) && refine(exp2, exp10, fine_q) &&
           sum_small(fine_p, fine_q, result);
  }
  constexpr double kWidest = std::int64_t{1} << SmallOperand::kMaxBits;
  if (p.extent.x + q.extent.x > kWidest || p.extent.y + q.extent.y > kWidest) return false;
  if (p.convex && q.convex) {
    merge_convex(p, q, result);
    return true;
  }
  return walk(p, q, result);
}

}  // namespace minksum
