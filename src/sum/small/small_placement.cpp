#include "sum/small/small_placement.hpp"

#include <cmath>

#include "exact/sign.hpp"
#include "machine/vectors.hpp"

namespace minksum {
namespace {

/// Whether two edges cross. The second one starts at `to`, seen from the start of the first.
template <class Vector, class IsLeft>
[[nodiscard, gnu::always_inline]] inline bool do_cross(const Vector& a, const Vector& to,
                                                       const Vector& b, const IsLeft& is_left) {
  return is_left(a, to) != is_left(a, plus(to, b)) && is_left(b, to) != is_left(b, minus(to, a));
}

}  // namespace

SmallPlacement::Result SmallPlacement::test(const SmallSegments& s, std::uint32_t segment,
                                            double from, double to) {
  constexpr int kMostHalvings = 40;  // the places are rounded by 2^-50 or so
  if (!(from < to)) return Result::kUnknown;
  // Of the multiples of 2^-halvings, the one nearest to the middle is clearly between them.
  halvings_ = 1 - std::ilogb(to - from);
  if (halvings_ > kMostHalvings) return Result::kUnknown;
  if (!edges_of_p_) turn_q();
  const auto steps = static_cast<std::int64_t>(std::ldexp((from + to) / 2, halvings_) + 0.5);
  numbers_.fit_int128() ? take(s, segment, steps, short_) : take(s, segment, steps, long_);
  return test_boundaries();
}

void SmallPlacement::turn_q() {
  turn(q_, 2, turned_);
  const auto entries = [&](int i, const SmallOperand& o) {
    return with_holes_[static_cast<std::size_t>(i)] ? o.entries : o.size;
  };
  edges_of_p_.emplace(p_, entries(0, p_), numbers_.reach, blocks_[0]);
  edges_of_q_.emplace(turned_, entries(1, turned_), numbers_.reach, blocks_[1]);
  pairs_left_ = 4 * most_pairs(std::size_t{p_.entries} + q_.entries);
}

template <class Integer>
void SmallPlacement::take(const SmallSegments& s, std::uint32_t segment, std::int64_t steps,
                          Exact<Integer>& exact) {
  using Scaled = typename Exact<Integer>::Scaled;
  exact.way = s.way().exact<Integer>(segment);
  const Vec<Integer> start = s.at().exact<Integer>(segment);
  const Vec<Integer> extent = turned_.exact_extent<Integer>();
  const auto set = [&](const Integer& at, const Integer& by, const Integer& width,
                       double& rounded) {
    const Scaled place = scaled<Scaled>(Integer(at - width)) + product<Scaled>(by, steps);
    rounded = std::ldexp(to_double(place), -halvings_);
    return place;
  };
  exact.place = {set(start.x, exact.way.x, extent.x, at_.x),
                 set(start.y, exact.way.y, extent.y, at_.y)};
}

[[gnu::always_inline]] inline double SmallPlacement::side_of(const Vec<double>& edge,
                                                             const Vec<double>& point) const {
  const double value = cross(edge, plus(point, at_));
  // With the units of `reach_of`, the place of x is off by 4u, and the point by 17u, at up to
  // three times the width. So the cross product is off by up to 36v.
  const double error = 2 * numbers_.reach * (std::abs(edge.x) + std::abs(edge.y));
  return std::abs(value) > error ? value : 0;
}

template <class Integer>
[[gnu::noinline]] bool SmallPlacement::is_left_exactly(const Exact<Integer>& exact,
                                                       const Vec<Integer>& edge,
                                                       const Vec<Integer>& point) const {
  using Scaled = typename Exact<Integer>::Scaled;
  using Side = typename Exact<Integer>::Side;
  const auto side = product<Side>(edge.x, scaled<Scaled>(point.y) + exact.place.y) -
                    product<Side>(edge.y, scaled<Scaled>(point.x) + exact.place.x);
  if (side != Side(0)) return !side.negative();
  using Product = ProductOf<Integer>;
  const auto by_right = exact_cross<Product>(edge, Vec<Integer>{exact.way.y, -exact.way.x});
  if (by_right != Product(0)) return !by_right.negative();
  return sign_of(exact_cross<Product>(edge, exact.way)) == kPositive;
}

template <class Integer>
[[gnu::noinline]] bool SmallPlacement::do_cross_exactly(std::uint32_t of_p, std::uint32_t of_q,
                                                        const Exact<Integer>& exact) const {
  using Vector = SureVec<Integer>;
  // Tells whether a point is on the left of an edge. The step is seen from the edge's operand.
  const auto is_left = [&](const Vector& edge, const Vector& point) {
    const double side = side_of(edge.near, point.near);
    return side != 0 ? side > 0 : is_left_exactly(exact, edge.exact, point.exact);
  };
  const SureLanes<Integer> lanes{{numbers_.reach}};
  const SmallEdges& p = *edges_of_p_;
  const SmallEdges& q = *edges_of_q_;
  return minksum::do_cross(lanes.get(p.way, of_p),
                           minus(lanes.get(q.at, of_q), lanes.get(p.at, of_p)),
                           lanes.get(q.way, of_q), is_left);
}

bool SmallPlacement::do_cross(std::uint32_t of_p, std::uint32_t of_q) const {
  bool unsure = false;
  const auto is_left = [&](const Vec<double>& edge, const Vec<double>& point) {
    const double side = side_of(edge, point);
    unsure |= side == 0;
    return side > 0;
  };
  const SmallEdges& p = *edges_of_p_;
  const SmallEdges& q = *edges_of_q_;
  const bool crossed =
      minksum::do_cross(p.way[of_p], minus(q.at[of_q], p.at[of_p]), q.way[of_q], is_left);
  if (!unsure) return crossed;
  return numbers_.fit_int128() ? do_cross_exactly(of_p, of_q, short_)
                               : do_cross_exactly(of_p, of_q, long_);
}

SmallPlacement::Result SmallPlacement::test_boundaries() {
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

}  // namespace minksum
