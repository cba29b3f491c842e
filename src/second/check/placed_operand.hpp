// Is x in P ⊕ Q, decided without any sum?
#pragma once

#include "second/check/edge_tree.hpp"

namespace minksum::checking {

/// Whether the closed set that has these edges holds c: by the parity of the edges of rings to its
/// right, or because c lies on an edge. O(log n + edges at c's height).
[[nodiscard]] bool contains(const EdgeTree& tree, const Corner& c, Cancellation& cancellation);

/// P and Q, to be asked for any number of points.
///
/// x is in P ⊕ Q if and only if P meets x − Q. Two closed sets meet if and only if two of their
/// edges do, or else one holds a connected part of the other: any one point of it.
class PlacedOperand {
 public:
  /// Both resolved.
  PlacedOperand(const Geometry& p, const Geometry& q, Cancellation& cancellation)
      : cancellation_(cancellation), p_(p, cancellation), q_(q, cancellation) {}
  [[nodiscard]] bool in_sum(const Point& x) const;

 private:
  [[nodiscard]] bool edges_meet(const Corner& x) const;
  [[nodiscard]] bool leaves_meet(const Corner& x, std::size_t leaf_p, std::size_t leaf_q) const;

  Cancellation& cancellation_;
  EdgeTree p_;
  EdgeTree q_;
};

}  // namespace minksum::checking
