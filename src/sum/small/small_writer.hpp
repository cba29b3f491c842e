// Writes corners of a small sum as vertices of a region.
#pragma once

#include <type_traits>

#include "region/region_access.hpp"
#include "sum/small/boundary_walk.hpp"

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
  static constexpr bool kWide = std::is_same_v<Number, WideNumber>;

 public:
  /// Makes room for `corners` vertices, which may be too many. `between` of them are not at the
  /// start of a segment.
  SmallWriter(const SmallNumbers<Number>& numbers, const SmallOperand& p, const SmallOperand& q,
              std::size_t corners, std::size_t between, Region& region)
      : numbers_(numbers),
        edge_source_{q[SmallOperand::kEdgeSource], p[SmallOperand::kEdgeSource]},
        vertex_source_{p[SmallOperand::kVertexSource], q[SmallOperand::kVertexSource]},
        offset_(plus(offset_of(p), offset_of(q))),
        exp2_(static_cast<std::int16_t>(p.exp2)),
        exp10_(static_cast<std::int16_t>(p.exp10)),
        region_(region) {
    region.clear();
    std::size_t limbs = 4 * between;  // most numerators and denominators take one
    if constexpr (kWide) {
      // A sum of vertices takes two limbs and a denominator of one, mostly, and a crossing four and
      // three, for each coordinate. Beyond 127 bits, they take about twice as many.
      few_ = numbers.fit_int128() && fits(offset_.x) && fits(offset_.y);
      limbs = (few_ ? 1 : 2) * (14 * between + 6 * (corners - between));
    }
    RegionAccess::make_ring(region, {corners, corners, 1, 1, limbs});
  }
  /// Adds the sum of two vertices. The origin is of the edge that starts there.
  void add(const VecRow& p, std::size_t i, const VecRow& q, std::size_t j,
           const SegmentOrigin& origin) {
    set(with_lanes(
        [&](const auto& lanes) { return vertex(plus(lanes.get(p, i), lanes.get(q, j)), origin); }));
  }
  void add(const WayFractions<Number>& ways, const SmallSegments& s, const SmallCorner& corner) {
    set(vertex(ways, s, corner));
  }
  [[nodiscard]] SmallVertex vertex(const WayFractions<Number>& ways, const SmallSegments& s,
                                   const SmallCorner& corner) {
    const std::uint32_t i = corner.segment;
    return with_lanes([&](const auto& lanes) {
      const auto start = lanes.get(s.at(), i);
      if (corner.is_start()) return vertex(start, s.origin[i]);
      const auto part = ways.exact(lanes, i, corner.crossed_by);
      const double passed = to_double(part.numerator) / to_double(part.denominator);
      const auto way = lanes.get(s.way(), i);
      const auto at = moved(as_integers(start));
      const auto by = as_integers(way);
      const StoredCoordinate x = store(at.x, by.x, part, near_of(way).x * passed);
      const StoredCoordinate y = store(at.y, by.y, part, near_of(way).y * passed);
      const Vec<double> rounded{near_of(start).x + near_of(way).x * passed,
                                near_of(start).y + near_of(way).y * passed};
      return SmallVertex{rounded, x, y, origin_of(s.origin[i])};
    });
  }
  /// Must be called after the last corner, if there may be fewer than there is room for.
  void finish() { RegionAccess::keep_vertices(region_, size_); }

 private:
  using Coordinate = std::conditional_t<kWide, WideNumber, std::int64_t>;
  /// Up to here, products of way or offset with a part of a way take at most 128 bits.
  static constexpr std::int64_t kFewBits = std::int64_t{1} << 60;

  [[nodiscard]] static Vec<Coordinate> offset_of(const SmallOperand& o) {
    if constexpr (kWide) {
      return o.exact_offset<WideNumber>();
    } else {
      return {static_cast<std::int64_t>(o.offset.x), static_cast<std::int64_t>(o.offset.y)};
    }
  }
  /// Whether a number has up to 126 bits.
  [[nodiscard]] static bool fits(const WideNumber& value) {
    const WideNumber magnitude = value.magnitude();
    return (magnitude.limb(1) >> 62U | magnitude.limb(2) | magnitude.limb(3)) == 0;
  }
  template <class Compute>
  [[nodiscard]] SmallVertex with_lanes(const Compute& compute) {
    if constexpr (kWide) {
      if (few_) return compute(SureLanes<Int128>{{numbers_.reach}});
    }
    return compute(sure_lanes(numbers_));
  }
  /// Returns a point's place in the regions' plane.
  template <class Value>
  [[nodiscard]] Vec<Value> moved(const Vec<Value>& at) const {
    if constexpr (std::is_same_v<Value, Coordinate>) {
      return plus(at, offset_);
    } else {
      return {at.x + offset_.x.to_int128(), at.y + offset_.y.to_int128()};
    }
  }
  template <class Value>
  [[nodiscard]] StoredCoordinate whole(const Value& value) {
    if (value == Value(0)) return {};
    const auto few = static_cast<std::int64_t>(as_limbs(value).limb(0));
    if (Value(few) == value) return {few, exp2_, exp10_, 0, 0};
    return quotient(as_limbs(value), WideInt<1>(1));
  }
  template <class Value, class Integer>
  StoredCoordinate store(const Value& base, const Value& way, const Quotient<Integer>& part,
                         double near) {
    if constexpr (std::is_same_v<Value, WideNumber>) {
      if (way == WideNumber(0)) return whole(base);
      const auto above =
          product<WideInt<12>>(way, part.numerator) + product<WideInt<12>>(base, part.denominator);
      return above == WideInt<12>(0) ? StoredCoordinate{} : quotient(above, part.denominator);
    } else if constexpr (kWide) {
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
  template <class Wide, class Value, class Part>
  [[gnu::noinline]] StoredCoordinate store(Value base, Value way, const Part& above,
                                           const Part& below, double near) {
    const auto moved = product<Wide>(way, above);
    // This is the quotient if that is an integer: it is off by less than a half, and otherwise the
    // rest tells.
    auto quotient = static_cast<Value>(near + (near < 0 ? -0.5 : 0.5));
    auto rest = moved - product<Wide>(quotient, below);
    if constexpr (kWide) {
      const double more = to_double(rest) / to_double(below);
      const auto step = static_cast<Value>(more + (more < 0 ? -0.5 : 0.5));
      quotient += step;
      // Mostly it is no integer, and the lowest limbs tell.
      const auto low = static_cast<std::uint64_t>(step) * below.limb(0);
      if (rest.limb(0) == low) rest = rest - product<Wide>(step, below);
    }
    if (rest == Wide(0)) return whole(base + quotient);
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
  template <class Vector>
  [[nodiscard]] SmallVertex vertex(const Vector& at, const SegmentOrigin& origin) {
    const auto place = moved(as_integers(at));
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

  SmallNumbers<Number> numbers_;
  // By `of_first`: indices in the region of the edge's operand, and of the vertex's.
  std::array<const double*, 2> edge_source_;
  std::array<const double*, 2> vertex_source_;
  Vec<Coordinate> offset_;
  std::int16_t exp2_;
  std::int16_t exp10_;
  bool few_ = true;  ///< whether a sum's coordinates have up to 127 bits
  Region& region_;
  std::size_t size_ = 0;
};

}  // namespace minksum
