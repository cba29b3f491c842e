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
class SmallPlacement {
 public:
  enum class Result : std::uint8_t { kInside, kOutside, kUnknown };

  struct Memory {
    SmallOperand turned;  ///< Q turned by half a circle
    std::array<SmallBlocks, 2> blocks;
  };
  /// The holes of others than those `with_holes` are filled.
  SmallPlacement(double width, const SmallOperand& p, const SmallOperand& q,
                 const std::array<bool, 2>& with_holes, Memory& memory)
      : numbers_{0x1p-48 * width},
        p_(p),
        q_(q),
        with_holes_(with_holes),
        turned_(memory.turned),
        blocks_(memory.blocks) {}
  SmallPlacement(const SmallPlacement&) = delete;
  SmallPlacement& operator=(const SmallPlacement&) = delete;

  /// Tests a point between two places on the way of a segment. They are rounded fractions of the
  /// way. Returns kUnknown if they are too close to tell, or if tests have taken too long.
  [[nodiscard]] Result test(const SmallSegments& s, std::uint32_t segment, double from, double to) {
    constexpr int kMostHalvings = 40;  // the places are rounded by 2^-50 or so
    if (!(from < to)) return Result::kUnknown;
    // Of the multiples of 2^-halvings, the one nearest to the middle is clearly between them.
    halvings_ = 1 - std::ilogb(to - from);
    if (halvings_ > kMostHalvings) return Result::kUnknown;
    if (!edges_of_p_) turn_q();
    const Int128 steps = static_cast<std::int64_t>(std::ldexp((from + to) / 2, halvings_) + 0.5);
    way_ = lanes_.get(s.way(), segment);
    const Vec<Int128> start = lanes_.get(s.at(), segment).exact;
    const auto set = [&](Int128 at, Int128 by, Int128 width, double& rounded) {
      const Scaled place = scaled(at - width) + product<Scaled>(by, steps);
      rounded = std::ldexp(to_double(place), -halvings_);
      return place;
    };
    place_ = {set(start.x, way_.exact.x, turned_.whole_extent.x, at_.x),
              set(start.y, way_.exact.y, turned_.whole_extent.y, at_.y)};
    return test_boundaries();
  }

 private:
  void turn_q() {
    turn(q_, 2, turned_);
    const auto entries = [&](int i, const SmallOperand& o) {
      return with_holes_[static_cast<std::size_t>(i)] ? o.entries : o.size;
    };
    edges_of_p_.emplace(p_, entries(0, p_), numbers_.reach, blocks_[0]);
    edges_of_q_.emplace(turned_, entries(1, turned_), numbers_.reach, blocks_[1]);
    pairs_left_ = 4 * most_pairs(std::size_t{p_.entries} + q_.entries);
  }
  /// Holds a coordinate in steps of 2^-halvings.
  using Scaled = WideInt<3>;

  /// Tells whether the boundaries of P and x − Q cross. Where they do not, neither holds the other,
  /// since x − Q lies outside P where it would touch without the step to the right.
  [[nodiscard]] Result test_boundaries() {
    return with_vectors(
        widest_vectors(), [&]() __attribute__((always_inline)) {
          bool crossed = false;
          const Vec<double> by{-at_.x, -at_.y};
          const bool done = for_each_near(
              *edges_of_p_, *edges_of_q_, by, numbers_.reach, pairs_left_,
              [&](std::uint32_t i, std::uint32_t first) {
                const Vec<double> at = edges_of_p_->at[i];
                const Vec<double> way = edges_of_p_->way[i];
                const BoxOf<double> box =
                    moved(box_of_segment(at.x, at.y, way.x, way.y), by, numbers_.reach);
                for_each_bit(edges_of_q_->near(first / kLanes, box), [&](std::uint32_t lane) {
                  crossed = crossed || do_cross(i, first + lane);
                });
                return !crossed;
              });
          if (crossed) return Result::kInside;
          return done ? Result::kOutside : Result::kUnknown;
        });
  }
  /// Whether two edges cross if that of x − Q makes an infinitely small step to the right of the
  /// way, and a smaller one along it. Then no end is on the other's line.
  [[nodiscard]] bool do_cross(std::uint32_t of_p, std::uint32_t of_q) const {
    const SureVec<Int128> a = lanes_.get(edges_of_p_->way, of_p);
    const SureVec<Int128> b = lanes_.get(edges_of_q_->way, of_q);
    // From the start of one edge to that of the other.
    const SureVec<Int128> to =
        minus(lanes_.get(edges_of_q_->at, of_q), lanes_.get(edges_of_p_->at, of_p));
    const SureVec<Int128> right{{way_.near.y, -way_.near.x}, {way_.exact.y, -way_.exact.x}};
    // Tells whether a point is on the left of an edge. The step is seen from the edge's operand.
    const auto is_left = [&](const SureVec<Int128>& edge, const SureVec<Int128>& point) {
      const Sign side = side_of(edge, point);
      if (side != kZero) return side == kPositive;
      const double by_right = lanes_.turn(edge, right);
      return (by_right != 0 ? by_right : lanes_.turn(edge, way_)) > 0;
    };
    return is_left(a, to) != is_left(a, plus(to, b)) && is_left(b, to) != is_left(b, minus(to, a));
  }
  /// Returns the sign of the cross product of two vectors. The place of x is added to the second.
  [[nodiscard]] Sign side_of(const SureVec<Int128>& edge, const SureVec<Int128>& to) const {
    const Vec<double>& way = edge.near;
    const double value = cross(way, plus(to.near, at_));
    // With the units of SmallNumbers, the place of x is off by 4u and twice as wide as the sum. So
    // the cross product is off by less than 17v.
    if (std::abs(value) > numbers_.reach * (std::abs(way.x) + std::abs(way.y))) {
      return sign_of(value);
    }
    return sign_of(product<WideInt<5>>(edge.exact.x, scaled(to.exact.y) + place_.y) -
                   product<WideInt<5>>(edge.exact.y, scaled(to.exact.x) + place_.x));
  }
  [[nodiscard]] Scaled scaled(Int128 value) const {
    return product<Scaled>(value, Int128{1} << halvings_);
  }

  SmallNumbers<Int128> numbers_;
  SureLanes<Int128> lanes_{numbers_};
  const SmallOperand& p_;
  const SmallOperand& q_;
  std::array<bool, 2> with_holes_;
  SmallOperand& turned_;
  std::array<SmallBlocks, 2>& blocks_;
  std::optional<SmallEdges> edges_of_p_;
  std::optional<SmallEdges> edges_of_q_;
  std::size_t pairs_left_ = 0;  ///< of blocks, for all tests
  int halvings_ = 0;
  SureVec<Int128> way_{};  ///< of the segment
  Vec<double> at_{};       ///< where the turned Q lies
  Vec<Scaled> place_{};    ///< the same exactly, in steps of 2^-halvings
};

}  // namespace minksum
