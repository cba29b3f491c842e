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

/// Whether a box is inside another one.
bool holds(const BoxOf<double>& box, const BoxOf<double>& other) {
  return box.x0 <= other.x0 && other.x1 <= box.x1 && box.y0 <= other.y0 && other.y1 <= box.y1;
}

}  // namespace

SmallPlacement::Result SmallPlacement::test(const SmallSegments& s, std::uint32_t segment,
                                            double from, double to) {
  constexpr int kMostHalvings = 40;  // the places are off by less than 2^-46
  if (!(from < to)) return Result::kUnknown;
  // Of the multiples of 2^-halvings, the one nearest to the middle is clearly between them.
  halvings_ = 1 - std::ilogb(to - from);
  if (halvings_ > kMostHalvings) return Result::kUnknown;
  if (!edges_of_p_) turn_q(s.size);
  const auto steps = static_cast<std::int64_t>(std::ldexp((from + to) / 2, halvings_) + 0.5);
  numbers_.fit_int128() ? take(s, segment, steps, short_) : take(s, segment, steps, long_);
  const Result result = test_boundaries();
  const bool may_hold = p_.has_several() || q_.has_several();
  return result == Result::kOutside && may_hold ? test_others() : result;
}

void SmallPlacement::turn_q(std::size_t segments) {
  turn(q_, 2, turned_);
  const auto entries = [&](int i, const SmallOperand& o) {
    return with_holes_[static_cast<std::size_t>(i)] ? o.entries : o.size;
  };
  edges_of_p_.emplace(p_, entries(0, p_), numbers_.reach, blocks_[0]);
  edges_of_q_.emplace(turned_, entries(1, turned_), numbers_.reach, blocks_[1]);
  // A pair of blocks takes 8 ns. The stages take some 200 ns for each segment, and some
  // microseconds more for any sum. The 110 tests of a spiral and a small one take three pairs for
  // each segment.
  constexpr std::size_t kPairsForSegment = 8;
  pairs_left_ = kPairsForSegment * segments + 1000;
  boxes_.clear();
  const SmallOperand& several = p_.has_several() ? p_ : turned_;
  if (!several.has_several()) return;
  const SmallEdges& edges = p_.has_several() ? *edges_of_p_ : *edges_of_q_;
  for (std::size_t ring = 0; several.begin_of(ring) < edges.size; ++ring) {
    const Vec<double> first = several.at()[several.begin_of(ring)];
    BoxOf<double>& box = boxes_.emplace_back(BoxOf<double>{first.x, first.y, first.x, first.y});
    for (std::uint32_t v = several.begin_of(ring); v < several.ends[ring]; ++v) {
      const Vec<double> at = several.at()[v];
      box.add({at.x, at.y, at.x, at.y});
    }
  }
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

SmallPlacement::Result SmallPlacement::test_others() {
  const bool is_p = p_.has_several();
  const SmallOperand& several = is_p ? p_ : turned_;
  const SmallOperand& other = is_p ? turned_ : p_;
  const SmallEdges& edges = is_p ? *edges_of_p_ : *edges_of_q_;
  const SmallEdges& edges_of_other = is_p ? *edges_of_q_ : *edges_of_p_;
  // How the other operand is moved, seen from the corner of the first one's box, and the reverse.
  const Vec<double> by = is_p ? at_ : Vec<double>{-at_.x, -at_.y};
  const Vec<double> back{-by.x, -by.y};
  const double reach = 2 * numbers_.reach;
  const BoxOf<double> other_box = moved({0, 0, other.extent.x, other.extent.y}, by, 0);
  bool may_hold = false;
  for (std::size_t ring = 0; ring < several.outer_rings; ++ring) {
    const BoxOf<double>& box = boxes_[ring];
    may_hold |= holds(moved(box, {}, reach), other_box);
    if (!holds(moved(other_box, {}, reach), box)) continue;
    const auto add_all = [&](const Vec<double>& point, int& winding) {
      return add_winding(edges_of_other, 0, edges_of_other.size, point, winding);
    };
    const Result held = place_ring(several, ring, back, add_all);
    if (held != Result::kOutside) return held;
  }
  if (!may_hold) return Result::kOutside;
  const auto add_near = [&](const Vec<double>& point, int& winding) {
    const BoxOf<double> near{point.x - reach, point.y - reach, point.x + reach, point.y + reach};
    for (std::size_t ring = 0; ring < boxes_.size(); ++ring) {
      if (boxes_[ring].meets(near) &&
          !add_winding(edges, several.begin_of(ring), several.ends[ring], point, winding)) {
        return false;
      }
    }
    return true;
  };
  return place_ring(other, 0, by, add_near);
}

template <class AddWinding>
SmallPlacement::Result SmallPlacement::place_ring(const SmallOperand& operand, std::size_t ring,
                                                  const Vec<double>& by,
                                                  const AddWinding& add_winding) {
  for (std::uint32_t v = operand.begin_of(ring); v < operand.ends[ring] && pairs_left_ > 0; ++v) {
    int winding = 0;
    if (!add_winding(plus(operand.at()[v], by), winding)) continue;
    return winding != 0 ? Result::kInside : Result::kOutside;
  }
  return Result::kUnknown;
}

bool SmallPlacement::add_winding(const SmallEdges& edges, std::uint32_t begin, std::uint32_t end,
                                 const Vec<double>& point, int& winding) {
  const double reach = 2 * numbers_.reach;
  const BoxOf<double> ray{point.x - reach, point.y - reach, HUGE_VAL, point.y + reach};
  for (std::size_t block = begin / kLanes; block * kLanes < end; ++block) {
    if (!edges.blocks.box_of(block).meets(ray)) continue;
    if (pairs_left_ == 0) return false;
    --pairs_left_;
    bool is_sure = true;
    for_each_bit(edges.near(block, ray), [&](std::uint32_t lane) {
      const std::size_t e = block * kLanes + lane;
      if (e >= end) return;
      const Vec<double> way = edges.way[e];
      const Vec<double> from = minus(point, edges.at[e]);
      // The cross product is off by up to 36v, as in `side_of`.
      const double side = cross(way, from);
      is_sure = is_sure && std::abs(from.y) > reach && std::abs(from.y - way.y) > reach &&
                std::abs(side) > reach * (std::abs(way.x) + std::abs(way.y));
      if (way.y > 0 && side > 0) ++winding;
      if (way.y < 0 && side < 0) --winding;
    });
    if (!is_sure) return false;
  }
  return true;
}

}  // namespace minksum
