// Do the insides of P and x − Q meet, where x is in any position?
#pragma once

#include <vector>

#include "sum/tight/tight.hpp"

namespace minksum {

/// A point of the plane of sums: a node, or a point of a segment (the probe's, not off it).
struct ContactPosition {
  const Node* node = nullptr;
  Probe probe{};
  Vec<double> at{};
  double error = 0;
};

/// Decides for placements x whether P° meets (x − Q)°, exactly.
///
/// They do if and only if
/// 1. two edges cross, or
/// 2. at a point of both boundaries a corner of one meets a corner of the other, or
/// 3. a vertex of a ring that does not touch the other's boundary lies in the other's inside.
/// Each is enough. If 1 and 2 fail: a ring with a point inside the other cannot come to the other's
/// boundary (its own inside, along it, would come there with it), so it is one of 3. If there is no
/// such ring, each component of an inside is in one component of the rest: then both are equal and
/// 2 holds, or they are disjoint. Edges are cut where rings of their polygon touch them, so that
/// what is inside one polygon near an edge's inner point is half a disk.
///
/// Edges cross or touch if and only if x lies in the closed parallelogram of both: four sides of
/// convolution lines to x. Trees of boxes find the pairs that may.
class OverlapTest {
 public:
  OverlapTest(const Operands& operands, BoxTrees& trees, Predicates& predicates,
              TightScratch& scratch);
  [[nodiscard]] bool overlaps(const ContactPosition& x);

 private:
  /// A part of an edge between touching points. Its corner starts with it and ends with `last`.
  struct EdgePart {
    SiteId edge;
    SiteId from;
    SiteId to;
    SiteId last;
  };
  /// Directions from `begin` counter-clockwise up to `end`, both not included.
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
  /// The corner of P that starts with a part, or of x − Q, which is turned by half a circle; and
  /// what is inside along the part.
  [[nodiscard]] Arc corner(const EdgePart& part) const;
  [[nodiscard]] Arc half_plane(const EdgePart& part) const;
  [[nodiscard]] bool meet(const Arc& a, const Arc& b) const;

  /// On which side of an edge moved by a vertex x lies.
  [[nodiscard]] Sign side(SiteId edge, SiteId vertex);
  /// Sign of x − (a + b) along an axis.
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
