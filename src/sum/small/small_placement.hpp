// Tells whether a small sum lies on the right of a segment of its convolution, too.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "sum/small/small_rings.hpp"
#include "sum/small/small_segments.hpp"

namespace minksum {

/// Tests points just on the right of a segment. Let x be one. It is in P ⊕ Q if and only if P and
/// x − Q have a point in common.
class SmallPlacement {
 public:
  enum class Result : std::uint8_t { kInside, kOutside, kUnknown };

  /// Copies of operands are kept in `memory`. The holes of others than those `with_holes` are
  /// filled.
  SmallPlacement(const SmallOperand& p, const SmallOperand& q, std::array<bool, 2> with_holes,
                 std::array<SmallOperand, 2>& memory)
      : p_(p), q_(q), with_holes_(with_holes), memory_(memory) {}

  /// Tests a point between two places on the way of a segment. They are rounded fractions of the
  /// way. Returns kUnknown if doubles do not hold its coordinates. O(p·q), eight at a time.
  [[nodiscard]] Result test(const SmallSegments& s, std::uint32_t segment, double from, double to) {
    if (!(from < to)) return Result::kUnknown;
    // Of the multiples of 2^-halvings, the one nearest to the middle is clearly between them.
    const int halvings = 1 - std::ilogb(to - from);
    if (halvings > halvings_ && !place(halvings)) return Result::kUnknown;
    const double steps = std::nearbyint(std::ldexp((from + to) / 2, halvings_));
    const Vec<double> way{s.dx[segment], s.dy[segment]};
    move_to({std::ldexp(s.x[segment], halvings_) + way.x * steps,
             std::ldexp(s.y[segment], halvings_) + way.y * steps});
    return do_boundaries_cross(way) ? Result::kInside : Result::kOutside;
  }

 private:
  /// Sets the copies: P, and Q turned by half a circle, both on a finer grid. Returns false if they
  /// do not fit there.
  [[nodiscard]] bool place(int halvings) {
    constexpr int kMost = 40;  // the ends of pieces are rounded by 2^-50 or so
    const double width = std::max(p_.extent.x + q_.extent.x, p_.extent.y + q_.extent.y);
    if (halvings > kMost || std::ldexp(width, halvings) > SmallOperand::kWidest) return false;
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
      SmallOperand& copy = memory_[i];
      turn(i == 0 ? p_ : q_, i == 0 ? 0 : 2, copy);
      copy.offset = {0, 0};
      const std::uint32_t entries = with_holes_[i] ? copy.entries : copy.size;
      if (!refine(copy.exp2 - halvings, copy.exp10, entries, copy, copy)) return false;
    }
    at_ = {memory_[1].extent.x, memory_[1].extent.y};
    halvings_ = halvings;
    return true;
  }
  void move_to(const Vec<double>& at) {
    SmallOperand& r = memory_[1];
    for (std::uint32_t i = 0; i < r.entries; ++i) {
      r[SmallOperand::kX][i] += at.x - at_.x;
      r[SmallOperand::kY][i] += at.y - at_.y;
    }
    at_ = at;
  }
  /// Whether the boundaries of P and x − Q cross. Where they do not, neither holds the other, since
  /// x − Q lies outside P where it would touch without the step to the right.
  [[nodiscard]] bool do_boundaries_cross(const Vec<double>& way) const {
    const SmallOperand& p = memory_[0];
    const SmallOperand& r = memory_[1];
    bool crossed = false;
    for_each_meeting<Int128>(p, p.entries, r, r.entries, [&](std::uint32_t i, std::uint32_t j) {
      crossed = do_cross(SmallRows(p, i), SmallRows(r, j), way);
      return !crossed;
    });
    return crossed;
  }
  /// Whether the first edges of `p` and `r` cross if r makes an infinitely small step to the right
  /// of a way, and a smaller one along it. Then no end is on the other's line.
  [[nodiscard]] static bool do_cross(const SmallRows& p, const SmallRows& r,
                                     const Vec<double>& way) {
    const SureCross<Int128> cross;
    const Vec<double> right{way.y, -way.x};
    const Vec<double> a{*p.dx, *p.dy};
    const Vec<double> b{*r.dx, *r.dy};
    const auto stepped = [&](double side, double by_right, double by_way) {
      return side != 0 ? side : by_right != 0 ? by_right : by_way;
    };
    const auto of_a = [&](double side) { return stepped(side, cross(a, right), cross(a, way)); };
    const auto of_b = [&](double side) { return stepped(side, cross(right, b), cross(way, b)); };
    const auto [start, end, along, left] = sides(cross, a, {*r.x - *p.x, *r.y - *p.y}, b);
    return (of_a(start) > 0) != (of_a(end) > 0) && (of_b(along) > 0) != (of_b(-left) > 0);
  }

  const SmallOperand& p_;
  const SmallOperand& q_;
  std::array<bool, 2> with_holes_;
  std::array<SmallOperand, 2>& memory_;
  int halvings_ = -1;  ///< how often the grid of the copies was halved; none have been made yet
  Vec<double> at_{};   ///< where the origin of Q lies
};

}  // namespace minksum
