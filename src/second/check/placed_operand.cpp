#include "second/check/placed_operand.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "region/point_arithmetic.hpp"
#include "region/point_predicates.hpp"

namespace minksum::checking {
namespace {

/// Tells whether c is between a and b, if all three are in one line.
bool between(const Corner& a, const Corner& b, const Corner& c) {
  return compare_x(a, c) * compare_x(c, b) >= 0 && compare_y(a, c) * compare_y(c, b) >= 0;
}

bool edges_share_point(const Corner& a, const Corner& b, const Corner& c, const Corner& d) {
  const int abc = turn(a, b, c), abd = turn(a, b, d), cda = turn(c, d, a), cdb = turn(c, d, b);
  if (abc * abd < 0 && cda * cdb < 0) return true;
  return (abc == 0 && between(a, b, c)) || (abd == 0 && between(a, b, d)) ||
         (cda == 0 && between(c, d, a)) || (cdb == 0 && between(c, d, b));
}

/// Returns a box that contains x − v for each v in `box`.
DoubleBox placed(const Corner& x, const DoubleBox& box) {
  const double reach = std::max({std::abs(x.x), std::abs(x.y), std::abs(box.x0), std::abs(box.x1),
                                 std::abs(box.y0), std::abs(box.y1)});
  const double slack = 2 * x.error + 0x1p-51 * reach;
  if (!std::isfinite(slack)) return kEverything;
  return {x.x - box.x1 - slack, x.y - box.y1 - slack, x.x - box.x0 + slack, x.y - box.y0 + slack};
}

}  // namespace

bool PlacedOperand::in_sum(const Point& x) const {
  const Corner at(x);
  if (edges_meet(at)) return true;
  // No two edges meet, so each connected part lies wholly inside the other set or wholly outside.
  const auto holds_part = [&](const EdgeTree& set, const PointLocator& in_set,
                              const EdgeTree& other) {
    return std::ranges::any_of(other.heads(), [&](std::size_t head) {
      cancellation_.check(2);
      const Corner& v = other.corner(head);
      if (!set.box(1).meets(around(Corner(at, v)))) return false;
      cancellation_.check(work_of(*v.vertex));
      return in_set.locate(minus(x, *v.vertex)) != Location::kOutside;
    });
  };
  return holds_part(p_, in_p_, q_) || holds_part(q_, in_q_, p_);  // x − p in Q
}

bool PlacedOperand::edges_meet(const Corner& x) const {
  std::vector<std::pair<std::size_t, std::size_t>> stack{{1, 1}};
  while (!stack.empty()) {
    cancellation_.check(4);
    const auto [p, q] = stack.back();
    stack.pop_back();
    if (!p_.box(p).meets(placed(x, q_.box(q)))) continue;
    const bool leaf_p = p_.is_leaf(p);
    const bool leaf_q = q_.is_leaf(q);
    if (leaf_p && leaf_q) {
      if (leaves_meet(x, p, q)) return true;
    } else if (leaf_q || (!leaf_p && p <= q)) {
      stack.emplace_back(2 * p, q);
      stack.emplace_back(2 * p + 1, q);
    } else {
      stack.emplace_back(p, 2 * q);
      stack.emplace_back(p, 2 * q + 1);
    }
  }
  return false;
}

bool PlacedOperand::leaves_meet(const Corner& x, std::size_t leaf_p, std::size_t leaf_q) const {
  for (std::size_t f = q_.first_edge(leaf_q); f < q_.last_edge(leaf_q); ++f) {
    const Corner c(x, q_.corner(q_.edges()[f].from));
    const Corner d(x, q_.corner(q_.edges()[f].to));
    for (std::size_t e = p_.first_edge(leaf_p); e < p_.last_edge(leaf_p); ++e) {
      cancellation_.check(2 * (p_.work() + q_.work()));
      const Edge& edge = p_.edges()[e];
      if (edges_share_point(p_.corner(edge.from), p_.corner(edge.to), c, d)) return true;
    }
  }
  return false;
}

}  // namespace minksum::checking
