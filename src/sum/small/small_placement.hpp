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

  /// A copy of Q is kept in `memory`. The holes of others than those `with_holes` are filled.
  SmallPlacement(const SmallOperand& p, const SmallOperand& q,
                 const std::array<bool, 2>& with_holes, SmallOperand& memory)
      : p_(p), q_(q), with_holes_(with_holes), turned_(memory) {}
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
    way_ = {s.dx[segment], s.dy[segment]};
    const auto set = [&](double start, double way, double width, double& whole, Int128& parts) {
      parts = scaled(start) + whole_number<Int128>(way) * steps;
      whole = static_cast<double>(static_cast<std::int64_t>(parts >> halvings_));
      parts -= scaled(whole);
      whole -= width;
      return std::ldexp(static_cast<double>(parts), -halvings_);
    };
    part_ = {set(s.x[segment], way_.x, turned_.extent.x, at_.x, parts_.x),
             set(s.y[segment], way_.y, turned_.extent.y, at_.y, parts_.y)};
    return do_boundaries_cross() ? Result::kInside : Result::kOutside;
  }

 private:
  void turn_q() {
    turn(q_, 2, turned_);
    const auto entries = [&](int i, const SmallOperand& o) {
      return with_holes_[static_cast<std::size_t>(i)] ? o.entries : o.size;
    };
    edges_of_p_.emplace(p_, entries(0, p_));
    edges_of_q_.emplace(turned_, entries(1, turned_));
  }
  /// Whether the boundaries of P and x − Q cross. Where they do not, neither holds the other, since
  /// x − Q lies outside P where it would touch without the step to the right.
  [[nodiscard]] bool do_boundaries_cross() const {
    return with_vectors(
        widest_vectors(), [&]() __attribute__((always_inline)) {
          bool crossed = false;
          // The part of x that is no integer moves Q by less than 1.
          const Vec<double> by{-at_.x, -at_.y};
          for_each_near(
              *edges_of_p_, *edges_of_q_, by, 1, [&](std::uint32_t i, std::uint32_t first) {
                const SmallRows& p = edges_of_p_->rows;
                const BoxOf<double> box =
                    moved(box_of_segment(p.x[i], p.y[i], p.dx[i], p.dy[i]), by, 1);
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
    const SmallRows& p = edges_of_p_->rows;
    const SmallRows& q = edges_of_q_->rows;
    const Vec<double> right{way_.y, -way_.x};
    const Vec<double> a{p.dx[of_p], p.dy[of_p]};
    const Vec<double> b{q.dx[of_q], q.dy[of_q]};
    const Vec<double> to{at_.x + q.x[of_q] - p.x[of_p], at_.y + q.y[of_q] - p.y[of_p]};
    // Tells whether a point is on the left of an edge. The step is seen from the edge's operand.
    const auto is_left = [&](const Vec<double>& edge, const Vec<double>& point) {
      const Sign side = side_of(edge, point);
      if (side != kZero) return side == kPositive;
      const double by_right = SureCross<Int128>{}(edge, right);
      return (by_right != 0 ? by_right : SureCross<Int128>{}(edge, way_)) > 0;
    };
    return is_left(a, to) != is_left(a, {to.x + b.x, to.y + b.y}) &&
           is_left(b, to) != is_left(b, {to.x - a.x, to.y - a.y});
  }
  /// Returns the sign of the cross product of two vectors. The part of x that is no integer is
  /// added to the second one.
  [[nodiscard]] Sign side_of(const Vec<double>& edge, const Vec<double>& to) const {
    const double left = edge.x * (to.y + part_.y);
    const double right = edge.y * (to.x + part_.x);
    // Three roundings by 2^-53 of these products at most.
    if (std::abs(left - right) > 0x1p-50 * (std::abs(left) + std::abs(right))) {
      return sign_of(left - right);
    }
    const Vec<Int128> exact{scaled(to.x) + parts_.x, scaled(to.y) + parts_.y};
    return sign_of(product<WideInt<3>>(whole_number<Int128>(edge.x), exact.y) -
                   product<WideInt<3>>(whole_number<Int128>(edge.y), exact.x));
  }
  [[nodiscard]] Int128 scaled(double value) const {
    return whole_number<Int128>(value) * (Int128{1} << halvings_);
  }

  const SmallOperand& p_;
  const SmallOperand& q_;
  std::array<bool, 2> with_holes_;
  SmallOperand& turned_;  ///< Q turned by half a circle
  std::optional<SmallEdges> edges_of_p_;
  std::optional<SmallEdges> edges_of_q_;
  int halvings_ = 0;
  Vec<double> way_{};    ///< of the segment
  Vec<double> at_{};     ///< where the turned Q lies, rounded down to integers
  Vec<double> part_{};   ///< what was rounded
  Vec<Int128> parts_{};  ///< the same in steps of 2^-halvings
};

}  // namespace minksum
