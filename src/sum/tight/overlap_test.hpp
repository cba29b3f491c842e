// Decides whether the insides of P and x − Q meet, for x in any position.
#pragma once

#include <vector>

#include "sum/tight/tight.hpp"

namespace minksum {

/// A placement: a node, or the point on a segment that a probe names (not the point off it).
struct ContactPosition {
  const Node* node = nullptr;
  Probe probe{};
  Vec<double> at{};
  double error = 0;
};

/// Decides exactly for placements x whether P° meets (x − Q)°.
///
/// They meet if and only if
/// 1. two edges cross, or
/// 2. at a point of both boundaries a corner of one meets a corner of the other, or
/// 3. a vertex of a ring that does not touch the other's boundary lies in the other's inside.
/// Each of these is enough. Now suppose that 1 and 2 fail. A ring with a point inside the other
/// operand cannot come to that operand's boundary. The ring's own inside lies along the ring, and
/// would come there with it. So that ring is one of 3. If there is no such ring, each component of
/// an inside is in one component of the plane without the other's boundary. Then two components are
/// equal and 2 holds, or all are disjoint. Edges are cut where rings of their polygon touch them.
/// So near an inner point of an edge, the polygon's inside is half a disk.
///
/// Edges cross or touch if and only if x lies in the closed parallelogram of both. The sides of
/// four convolution lines on which x lies decide that. Trees of boxes find the pairs that may.
class OverlapTest {
 public:
  OverlapTest(const Operands& operands, BoxTrees& trees, Predicates& predicates,
              TightScratch& scratch);
  [[nodiscard]] bool overlaps(const ContactPosition& x);

 private:
  /// A part of an edge between touching points. The part's corner starts with the part, and ends
  /// with `last`.
  struct EdgePart {
    SiteId edge;
    SiteId from;
    SiteId to;
    SiteId last;
  };
  /// The open range of directions from `begin` counter-clockwise to `end`.
  struct Arc {
    std::uint32_t begin;
    std::uint32_t end;
  };

  /// Whether a box of P and one of x − Q may meet.
  [[nodiscard]] bool near(const BoxTree::Box& p, const BoxTree::Box& q) const;
  [[nodiscard]] bool leaves_overlap(std::size_t leaf_p, std::size_t leaf_q);
  [[nodiscard]] bool parts_overlap(const EdgePart& e, const EdgePart& f);
  [[nodiscard]] bool overlap_on_line(const EdgePart& e, const EdgePart& f);
  [[nodiscard]] bool a_ring_is_inside(int operand);
  [[nodiscard]] bool is_inside(std::size_t ring, int operand);
  [[nodiscard]] bool has_inside(int operand, SiteId vertex);

  template <class Visit>
  [[nodiscard]] bool any_part(SiteId edge, int operand, Visit visit) const;
  void touch(const EdgePart& e, const EdgePart& f) {
    scratch_.met[scratch_.ring_of[e.edge]] = number_;
    scratch_.met[scratch_.ring_of[f.edge]] = number_;
  }
  /// Returns the corner of P, or of x − Q, that starts with a part. x − Q is turned by half a
  /// circle against Q. `half_plane` returns what is inside along the part.
  [[nodiscard]] Arc corner(const EdgePart& part) const;
  [[nodiscard]] Arc half_plane(const EdgePart& part) const;
  [[nodiscard]] bool meet(const Arc& a, const Arc& b) const;

  /// Returns the side of an edge, moved by a vertex, on which x lies.
  [[nodiscard]] Sign side(SiteId edge, SiteId vertex);
  /// Returns the sign of x − (a + b) along an axis.
  [[nodiscard]] Sign compare(SiteId a, SiteId b, Axis axis);

  const Operands& o_;
  BoxTrees& trees_;
  Predicates& predicates_;
  TightScratch& scratch_;
  ContactPosition x_;
  double doubt_ = 0;
  std::uint32_t number_ = 0;
};

}  // namespace minksum
