// Writes corners of a small sum as vertices of a region.
#pragma once

#include <type_traits>

#include "region/region_access.hpp"
#include "sum/small/outer_walk.hpp"

namespace minksum {

/// A vertex of a result.
struct SmallVertex {
  Vec<double> rounded;  ///< its place without the offset
  StoredCoordinate x;
  StoredCoordinate y;
  EdgeOrigin origin;
};

/// Makes vertices of corners, and writes the outer ring's to a region.
template <class Number>
class SmallWriter {
  static constexpr bool kWide = std::is_same_v<Number, Int128>;

 public:
  /// Makes room for `corners` vertices, which may be too many. `between` of them are not at the
  /// start of a segment.
  SmallWriter(const SmallOperand& p, const SmallOperand& q, std::size_t corners,
              std::size_t between, Region& region)
      : edge_source_{q[SmallOperand::kEdgeSource], p[SmallOperand::kEdgeSource]},
        vertex_source_{p[SmallOperand::kVertexSource], q[SmallOperand::kVertexSource]},
        offset_{static_cast<Coordinate>(p.offset.x + q.offset.x),
                static_cast<Coordinate>(p.offset.y + q.offset.y)},
        exp2_(static_cast<std::int16_t>(p.exp2)),
        exp10_(static_cast<std::int16_t>(p.exp10)),
        region_(region) {
    region.clear();
    // Most numerators and denominators take one limb, or four and three if operands are wide.
    constexpr std::size_t kLimbs = kWide ? 14 : 4;
    constexpr std::size_t kLimbsOfStart = kWide ? 6 : 0;
    const std::size_t limbs = kLimbs * between + kLimbsOfStart * (corners - between);
    RegionAccess::make_ring(region, {corners, corners, 1, 1, limbs});
  }
  /// Adds the sum of two vertices. The origin is of the edge that starts there.
  void add(const SmallVec<Number>& at, const SegmentOrigin& origin) { set(vertex(at, origin)); }
  void add(const WayFractions<Number>& ways, const SmallSegments& s, const SmallCorner& corner) {
    set(vertex(ways, s, corner));
  }
  [[nodiscard]] SmallVertex vertex(const WayFractions<Number>& ways, const SmallSegments& s,
                                   const SmallCorner& corner) {
    const std::uint32_t i = corner.segment;
    const auto start = ways.at(i);
    if (corner.is_start()) return vertex(start, s.origin[i]);
    const auto part = ways.exact(i, corner.crossed_by);
    const double passed = to_double(part.numerator) / to_double(part.denominator);
    const auto way = ways.way(i);
    const Vec<Coordinate> at = plus(as_integers(start), offset_);
    const Vec<Coordinate> by = as_integers(way);
    const StoredCoordinate x = store(at.x, by.x, part, near_of(way).x * passed);
    const StoredCoordinate y = store(at.y, by.y, part, near_of(way).y * passed);
    const Vec<double> rounded{near_of(start).x + near_of(way).x * passed,
                              near_of(start).y + near_of(way).y * passed};
    return {rounded, x, y, origin_of(s.origin[i])};
  }
  /// Must be called after the last corner, if there may be fewer than there is room for.
  void finish() { RegionAccess::keep_vertices(region_, size_); }

 private:
  using Integer = typename WayFractions<Number>::Integer;
  using Coordinate = std::conditional_t<kWide, Int128, std::int64_t>;
  /// Up to here, products of way or offset with a part of a way take at most 128 bits.
  static constexpr std::int64_t kFewBits = std::int64_t{1} << 60;

  [[nodiscard]] StoredCoordinate whole(Coordinate value) {
    if (value == 0) return {};
    const auto few = static_cast<std::int64_t>(value);
    if (few == value) return {few, exp2_, exp10_, 0, 0};
    return quotient(as_limbs(value), WideInt<1>(1));
  }
  StoredCoordinate store(Coordinate base, Coordinate way, const Quotient<Integer>& part,
                         double near) {
    if constexpr (kWide) {
      return store<WideInt<6>>(base, way, part.numerator, part.denominator, near);
    } else {
      if (part.denominator <= kFewBits) {
        return store<Int128>(base, way, static_cast<std::int64_t>(part.numerator),
                             static_cast<std::int64_t>(part.denominator), near);
      }
      return store<WideInt<3>>(base, way, part.numerator, part.denominator, near);
    }
  }
  /// Stores base + way · above / below, where `Wide` holds the products, and `near` is nearly the
  /// second part.
  template <class Wide, class Part>
  [[gnu::noinline]] StoredCoordinate store(Coordinate base, Coordinate way, const Part& above,
                                           const Part& below, double near) {
    const auto moved = product<Wide>(way, above);
    // This is the quotient if that is an integer: it is off by less than a half, and otherwise the
    // rest tells.
    auto quotient = static_cast<Coordinate>(near + (near < 0 ? -0.5 : 0.5));
    if constexpr (kWide) {
      const double rest = to_double(moved - product<Wide>(quotient, below)) / to_double(below);
      quotient += static_cast<Coordinate>(rest + (rest < 0 ? -0.5 : 0.5));
    }
    if (product<Wide>(quotient, below) == moved) return whole(base + quotient);
    return this->quotient(as_limbs(moved + product<Wide>(base, below)), as_limbs(below));
  }
  template <class Above, class Below>
  StoredCoordinate quotient(const Above& above, const Below& below) {
    const auto place = static_cast<std::int64_t>(RegionAccess::limbs(region_).size());
    const auto append = [&](const auto& magnitude) {
      std::size_t count = magnitude.limbs().size();
      while (magnitude.limb(count - 1) == 0) --count;
      RegionAccess::append_limbs(region_, magnitude.limbs().first(count));
      return static_cast<std::uint16_t>(count);
    };
    std::uint16_t count = append(above.magnitude());
    if (above.negative()) count |= kNegativeLimbs;
    return {place, exp2_, exp10_, count, append(below)};
  }
  [[nodiscard]] SmallVertex vertex(const SmallVec<Number>& at, const SegmentOrigin& origin) {
    const Vec<Coordinate> place = plus(as_integers(at), offset_);
    return {near_of(at), whole(place.x), whole(place.y), origin_of(origin)};
  }
  [[nodiscard]] EdgeOrigin origin_of(const SegmentOrigin& origin) const {
    const std::size_t k = origin.of_first;
    return {k != 0 ? Operand::kFirst : Operand::kSecond,
            static_cast<std::uint32_t>(edge_source_[k][origin.edge]),
            static_cast<std::uint32_t>(vertex_source_[k][origin.vertex])};
  }
  void set(const SmallVertex& vertex) {
    RegionAccess::set_vertex(region_, size_, vertex.x, vertex.y);
    RegionAccess::set_origin(region_, size_++, vertex.origin);
  }

  // By `of_first`: indices in the region of the edge's operand, and of the vertex's.
  std::array<const double*, 2> edge_source_;
  std::array<const double*, 2> vertex_source_;
  Vec<Coordinate> offset_;
  std::int16_t exp2_;
  std::int16_t exp10_;
  Region& region_;
  std::size_t size_ = 0;
};

}  // namespace minksum
