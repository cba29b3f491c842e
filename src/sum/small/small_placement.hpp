// Tells whether a small sum lies on the right of a segment of its convolution, too.
#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "exact/sign.hpp"
#include "machine/vectors.hpp"
#include "sum/small/small_rings.hpp"
#include "sum/small/small_segments.hpp"

namespace minksum {

/// Tests points just on the right of a segment. Let x be one. It is in P ⊕ Q if and only if P and
/// x − Q have a point in common.
template <class Number>
class SmallPlacement {
 public:
  enum class Result : std::uint8_t { kInside, kOutside, kUnknown };

  /// A copy of Q is kept in `memory`. The holes of others than those `with_holes` are filled.
  SmallPlacement(const SmallNumbers<Number>& numbers, const SmallOperand& p, const SmallOperand& q,
                 const std::array<bool, 2>& with_holes, SmallOperand& memory)
      : numbers_(numbers), p_(p), q_(q), with_holes_(with_holes), turned_(memory) {}
  SmallPlacement(const SmallPlacement&) = delete;
  SmallPlacement& operator=(const SmallPlacement&) = delete;

  /// Tests a point between two places on the way of a segment. They are rounded fractions of the
  /// way. Returns kUnknown if they are too close to tell. O(p·q), eight at a time.
  [[nodiscard]] Result test(const SmallSegments& s, std::uint32_t segment, double from, double to) {
    constexpr int kMostHalvings = 40;  // the places are rounded by 2^-50 or so
    if (!(from < to)) return Result::kUnknown;
    // Of the multiples of 2^-halvings, the one nearest to the middle is clearly between them.
    halvings_ = 1 - std::ilogb(to - from);
    if (halvings_ > kMostHalvings) return Result::kUnknown;
    if (!edges_of_p_) turn_q();
    const Int128 steps = static_cast<std::int64_t>(std::ldexp((from + to) / 2, halvings_) + 0.5);
    way_ = lanes().get(s.way(), segment);
    const auto start = as_integers(lanes().get(s.at(), segment));
    const auto way = as_integers(way_);
    const auto set = [&](Int128 at, Int128 by, Int128 width, double& rounded, double& part) {
      const Scaled place = scaled(at - width) + product<Scaled>(by, steps);
      if constexpr (kWide) {
        rounded = std::ldexp(to_double(place), -halvings_);
      } else {
        const Int128 whole = place >> halvings_;
        rounded = static_cast<double>(whole);
        part = std::ldexp(static_cast<double>(place - scaled(whole)), -halvings_);
      }
      return place;
    };
    place_ = {set(start.x, way.x, turned_.whole_extent.x, at_.x, part_.x),
              set(start.y, way.y, turned_.whole_extent.y, at_.y, part_.y)};
    return do_boundaries_cross() ? Result::kInside : Result::kOutside;
  }

 private:
  void turn_q() {
    turn(q_, 2, turned_);
    const auto entries = [&](int i, const SmallOperand& o) {
      return with_holes_[static_cast<std::size_t>(i)] ? o.entries : o.size;
    };
    edges_of_p_.emplace(p_, entries(0, p_), numbers_.reach);
    edges_of_q_.emplace(turned_, entries(1, turned_), numbers_.reach);
  }
  static constexpr bool kWide = std::is_same_v<Number, Int128>;
  /// Holds a coordinate in steps of 2^-halvings.
  using Scaled = std::conditional_t<kWide, WideInt<3>, Int128>;

  /// Whether the boundaries of P and x − Q cross. Where they do not, neither holds the other, since
  /// x − Q lies outside P where it would touch without the step to the right.
  [[nodiscard]] bool do_boundaries_cross() const {
    return with_vectors(
        widest_vectors(), [&]() __attribute__((always_inline)) {
          bool crossed = false;
          const Vec<double> by{-at_.x, -at_.y};
          for_each_near(
              *edges_of_p_, *edges_of_q_, by, reach(), [&](std::uint32_t i, std::uint32_t first) {
                const Vec<double> at = edges_of_p_->at[i];
                const Vec<double> way = edges_of_p_->way[i];
                const BoxOf<double> box =
                    moved(box_of_segment(at.x, at.y, way.x, way.y), by, reach());
                for_each_bit(edges_of_q_->near(first / kLanes, box), [&](std::uint32_t lane) {
                  crossed = crossed || do_cross(i, first + lane);
                });
                return !crossed;
              });
          return crossed;
        });
  }
  /// Whether two edges cross if that of x − Q makes an infinitely small step to the right of the
  /// way, and a smaller one along it. Then no end is on the other's line.
  [[nodiscard]] bool do_cross(std::uint32_t of_p, std::uint32_t of_q) const {
    const auto lanes = this->lanes();
    const auto a = lanes.get(edges_of_p_->way, of_p);
    const auto b = lanes.get(edges_of_q_->way, of_q);
    // From the start of one edge to that of the other.
    const auto to = minus(lanes.get(edges_of_q_->at, of_q), lanes.get(edges_of_p_->at, of_p));
    auto right = way_;
    turn_right(right);
    // Tells whether a point is on the left of an edge. The step is seen from the edge's operand.
    const auto is_left = [&](const auto& edge, const auto& point) {
      const Sign side = side_of(edge, point);
      if (side != kZero) return side == kPositive;
      const double by_right = lanes.turn(edge, right);
      return (by_right != 0 ? by_right : lanes.turn(edge, way_)) > 0;
    };
    return is_left(a, to) != is_left(a, plus(to, b)) && is_left(b, to) != is_left(b, minus(to, a));
  }
  static void turn_right(Vec<double>& v) { v = {v.y, -v.x}; }
  template <class Exact>
  static void turn_right(SureVec<Exact>& v) {
    turn_right(v.near);
    v.exact = {v.exact.y, Exact{0} - v.exact.x};
  }
  /// Returns the sign of the cross product of two vectors. The place of x is added to the second.
  template <class Vector>
  [[nodiscard]] Sign side_of(const Vector& edge, const Vector& to) const {
    const Vec<double>& way = near_of(edge);
    const double left = way.x * (near_of(to).y + at_.y + part_.y);
    const double right = way.y * (near_of(to).x + at_.x + part_.x);
    // Without rounded points, three roundings by 2^-53 of these products at most.
    const double error = kWide ? numbers_.reach * (std::abs(way.x) + std::abs(way.y))
                               : 0x1p-50 * (std::abs(left) + std::abs(right));
    if (std::abs(left - right) > error) return sign_of(left - right);
    const auto by = as_integers(edge);
    const auto from = as_integers(to);
    using Wide = WideInt<kWide ? 5 : 3>;
    return sign_of(product<Wide>(by.x, scaled(from.y) + place_.y) -
                   product<Wide>(by.y, scaled(from.x) + place_.x));
  }
  /// How far apart edges may be whose boxes are near. What is no integer of the place of x moves Q
  /// by less than 1.
  [[nodiscard]] double reach() const { return 1 + numbers_.reach; }
  [[nodiscard]] Scaled scaled(Int128 value) const {
    return product<Scaled>(value, Int128{1} << halvings_);
  }
  /// Cross products of edges are exact by these. Those of places are computed here.
  [[nodiscard]] auto lanes() const { return sure_lanes(numbers_); }

  SmallNumbers<Number> numbers_;
  const SmallOperand& p_;
  const SmallOperand& q_;
  std::array<bool, 2> with_holes_;
  SmallOperand& turned_;  ///< Q turned by half a circle
  std::optional<SmallEdges> edges_of_p_;
  std::optional<SmallEdges> edges_of_q_;
  int halvings_ = 0;
  SmallVec<Number> way_{};  ///< of the segment
  Vec<double> at_{};        ///< where the turned Q lies, rounded down to integers
  Vec<double> part_{};      ///< what was rounded, unless Q is wide
  Vec<Scaled> place_{};     ///< the same in steps of 2^-halvings
};

}  // namespace minksum
