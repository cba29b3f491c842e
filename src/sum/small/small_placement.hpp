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
  /// Without `with_holes`, an operand's holes are filled.
  SmallPlacement(double width, const SmallOperand& p, const SmallOperand& q,
                 const std::array<bool, 2>& with_holes, Memory& memory)
      : numbers_{reach_of(width)},
        p_(p),
        q_(q),
        with_holes_(with_holes),
        turned_(memory.turned),
        blocks_(memory.blocks) {}
  SmallPlacement(const SmallPlacement&) = delete;
  SmallPlacement& operator=(const SmallPlacement&) = delete;

  /// Tests a point between two places on the way of a segment. They are rounded fractions of the
  /// way. Returns kUnknown if they are too close to tell, if tests have taken too long, or if
  /// Int128 does not hold the coordinates.
  [[nodiscard]] Result test(const SmallSegments& s, std::uint32_t segment, double from, double to) {
    constexpr int kMostHalvings = 40;  // the places are rounded by 2^-50 or so
    if (!(from < to) || !numbers_.fit_int128()) return Result::kUnknown;
    // Of the multiples of 2^-halvings, the one nearest to the middle is clearly between them.
    halvings_ = 1 - std::ilogb(to - from);
    if (halvings_ > kMostHalvings) return Result::kUnknown;
    if (!edges_of_p_) turn_q();
    const Int128 steps = static_cast<std::int64_t>(std::ldexp((from + to) / 2, halvings_) + 0.5);
    way_ = s.way().exact<Int128>(segment);
    const Vec<Int128> start = s.at().exact<Int128>(segment);
    const auto set = [&](Int128 at, Int128 by, Int128 width, double& rounded) {
      const Scaled place = scaled(at - width * turned_.steps) + product<Scaled>(by, steps);
      rounded = std::ldexp(to_double(place), -halvings_);
      return place;
    };
    place_ = {set(start.x, way_.x, turned_.whole_extent.x, at_.x),
              set(start.y, way_.y, turned_.whole_extent.y, at_.y)};
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

  /// Tells whether the boundaries of P and x − Q cross. Where they do not, neither holds the other:
  /// without the step to the right they touch, from different sides.
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
    bool unsure = false;
    const auto is_left = [&](const Vec<double>& edge, const Vec<double>& point) {
      const double side = side_of(edge, point);
      unsure |= side == 0;
      return side > 0;
    };
    const SmallEdges& p = *edges_of_p_;
    const SmallEdges& q = *edges_of_q_;
    const bool crossed = do_cross(p.way[of_p], minus(q.at[of_q], p.at[of_p]), q.way[of_q], is_left);
    return unsure ? do_cross_exactly(of_p, of_q) : crossed;
  }
  [[nodiscard, gnu::noinline]] bool do_cross_exactly(std::uint32_t of_p, std::uint32_t of_q) const {
    using Vector = SureVec<Int128>;
    // Tells whether a point is on the left of an edge. The step is seen from the edge's operand.
    const auto is_left = [&](const Vector& edge, const Vector& point) {
      const double side = side_of(edge.near, point.near);
      return side != 0 ? side > 0 : is_left_exactly(edge.exact, point.exact);
    };
    const SureLanes<Int128> lanes{{numbers_.reach}};
    const SmallEdges& p = *edges_of_p_;
    const SmallEdges& q = *edges_of_q_;
    return do_cross(lanes.get(p.way, of_p), minus(lanes.get(q.at, of_q), lanes.get(p.at, of_p)),
                    lanes.get(q.way, of_q), is_left);
  }
  /// Whether two edges cross. The second one starts at `to`, seen from the start of the first.
  template <class Vector, class IsLeft>
  [[nodiscard, gnu::always_inline]] static bool do_cross(const Vector& a, const Vector& to,
                                                         const Vector& b, const IsLeft& is_left) {
    return is_left(a, to) != is_left(a, plus(to, b)) && is_left(b, to) != is_left(b, minus(to, a));
  }
  /// Returns the cross product of two vectors, or zero if its sign is not sure. The place of x is
  /// added to the second.
  [[nodiscard, gnu::always_inline]] double side_of(const Vec<double>& edge,
                                                   const Vec<double>& point) const {
    const double value = cross(edge, plus(point, at_));
    // With the units of `reach_of`, the place of x is off by 4u, and the point by 17u, at up to
    // three times the width. So the cross product is off by up to 36v.
    const double error = 2 * numbers_.reach * (std::abs(edge.x) + std::abs(edge.y));
    return std::abs(value) > error ? value : 0;
  }
  /// Tells the same for sure, and makes the step if the point is on the line.
  [[nodiscard]] bool is_left_exactly(const Vec<Int128>& edge, const Vec<Int128>& point) const {
    using Wide = WideInt<5>;
    const auto side = product<Wide>(edge.x, scaled(point.y) + place_.y) -
                      product<Wide>(edge.y, scaled(point.x) + place_.x);
    if (side != Wide(0)) return !side.negative();
    using Product = ProductOf<Int128>;
    const auto by_right = exact_cross<Product>(edge, Vec<Int128>{way_.y, -way_.x});
    if (by_right != Product(0)) return !by_right.negative();
    return sign_of(exact_cross<Product>(edge, way_)) == kPositive;
  }
  [[nodiscard]] Scaled scaled(Int128 value) const {
    return product<Scaled>(value, Int128{1} << halvings_);
  }

  SmallNumbers<WideNumber> numbers_;
  const SmallOperand& p_;
  const SmallOperand& q_;
  std::array<bool, 2> with_holes_;
  SmallOperand& turned_;
  std::array<SmallBlocks, 2>& blocks_;
  std::optional<SmallEdges> edges_of_p_;
  std::optional<SmallEdges> edges_of_q_;
  std::size_t pairs_left_ = 0;  ///< of blocks, for all tests
  int halvings_ = 0;
  Vec<Int128> way_{};    ///< of the segment
  Vec<double> at_{};     ///< where the turned Q lies
  Vec<Scaled> place_{};  ///< the same exactly, in steps of 2^-halvings
};

}  // namespace minksum
