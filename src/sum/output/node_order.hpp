// Compares nodes exactly, with the filter in front.
#pragma once

#include "sum/arrangement/arrangement.hpp"

namespace minksum {

class NodeOrder {
 public:
  NodeOrder(const Arrangement& arrangement, Predicates& predicates)
      : nodes_(&arrangement.nodes), predicates_(&predicates) {}

  Sign compare(NodeId a, NodeId b, Axis axis) const {
    if (a == b) return kZero;
    const Node& p = (*nodes_)[a];
    const Node& q = (*nodes_)[b];
    return predicates_->compare(p.point, p.at, p.error, q.point, q.at, q.error, axis);
  }
  /// Compares by x, and then by y.
  Sign compare(NodeId a, NodeId b) const {
    const Sign by_x = compare(a, b, Axis::kX);
    return by_x != kZero ? by_x : compare(a, b, Axis::kY);
  }
  /// Returns the side of a segment on which a node lies.
  Sign orientation(const Segment& segment, NodeId node) const {
    const Node& n = (*nodes_)[node];
    return predicates_->orientation(segment, n.point, n.at, n.error);
  }

 private:
  const std::vector<Node>* nodes_;
  Predicates* predicates_;
};

}  // namespace minksum
