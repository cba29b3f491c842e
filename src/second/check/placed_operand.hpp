// Decides without any sum whether x is in P ⊕ Q.
#pragma once

#include "minksum/locate.hpp"
#include "second/check/edge_tree.hpp"

namespace minksum::checking {

/// Answers for any number of points x whether x is in P ⊕ Q.
///
/// x is in P ⊕ Q if and only if P meets x − Q. Two closed sets meet if and only if two of their
/// edges do, or one set contains a connected part of the other. For that, any one point of the part
/// decides.
class PlacedOperand {
 public:
  /// Both operands must be resolved.
  PlacedOperand(const Geometry& p, const Geometry& q, Cancellation& cancellation)
      : cancellation_(cancellation),
        p_(p, cancellation),
        q_(q, cancellation),
        in_p_(p, part_of(cancellation.options())),
        in_q_(q, part_of(cancellation.options())) {}
  [[nodiscard]] bool in_sum(const Point& x) const;

 private:
  [[nodiscard]] bool edges_meet(const Corner& x) const;
  [[nodiscard]] bool leaves_meet(const Corner& x, std::size_t leaf_p, std::size_t leaf_q) const;

  Cancellation& cancellation_;
  EdgeTree p_;
  EdgeTree q_;
  PointLocator in_p_;
  PointLocator in_q_;
};

}  // namespace minksum::checking
