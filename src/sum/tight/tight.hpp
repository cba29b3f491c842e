// Tight places: what the sum has in its interior and the sum of the interiors has not.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "minksum/geometry.hpp"
#include "sum/filters/filters.hpp"

namespace minksum {

/// Where P and x − Q touch and have no play, or play along a path only.
///
/// Let S = P ⊕ Q, U = P° ⊕ Q° (open, with closure S), X the complement of U. Tight are the points
/// of closure(S° ∖ U). For x in X take all contacts p + q = x, and at each the cones of P at p and
/// of Q at q (as open parts of the plane around 0). Near x, U is x plus the union of the sums of
/// one cone of each, and X is x plus the intersection C of their complements. x lies in S° if C has
/// no inner points: then it is 0 alone, or some rays. Take one polygon of each operand at a time.
///
/// 1. *Segments bound X.* Take cones A of P and B of Q; A and −B are disjoint. Either one is
///    reflex, say A: then A ⊕ B is A, bounded by the edges at p, which the convex vertex q moves.
///    Or both are convex, and A ⊕ B is bounded by the first and the last of their rays: edges too,
///    and the vertex that moves each is convex and has the edge's direction in its closed range.
///    What the convolution takes is a half-open range: of parallel edges e and f, e moved by the
///    start of f and f moved by the end of e. Follow such a contact along e to where it ends: at
///    the end of e or at the start of f. A reflex vertex there would let the insides meet. So it is
///    convex, and its segment passes x.
/// 2. *Paths.* Let C be a line, and no segment of another direction end at x or pass it. Then C is
///    an intersection of half-planes along this line, of both sides, so segments of both directions
///    pass: a slit. Along the line this changes only where another segment ends or passes, at a
///    node. So a slit is tight as a whole or (but for single points, see 4) nowhere.
/// 3. *Points.* C contains the intersection of the closed right half-planes of all segments at x.
///    If C is 0 alone, no closed half-plane contains all their directions: the node is crowded.
/// 4. *Touching rings.* A polygon has several cones, and gaps between them, where its rings touch.
///    (a) If no two of P's cones alternate with two of (x − Q)'s, then each operand lies in one gap
///    of the other, which is a corner of one ring, and 1 holds with these two corners for cones.
///    (b) If A, K, A', K' alternate, then C = 0: moved by v, K must stay in its gap of P and K' in
///    its own, so v is in both, and gaps have only 0 in common. These are `pinches`, whatever
///    segments there are. Then neither inside is connected: that of P is off Q, so if connected it
///    lies beyond one ring of Q; but A and A' are in different gaps, and a ring passes x once.
///    (c) The convolution leaves out hole against hole. Suppose that corners of holes touch as in
///    (a). P's filling cannot lie in Q's hole and Q's in P's; so P, say, has inner points in Q's
///    hole and others beyond it. P is connected, so two cones of it, in different gaps of Q, meet
///    at a point: there (b) holds, and x is a pinch by that.
///
/// All segments at a point of X and all their meetings there are known, because no such point is in
/// a covered cell (docs/pipeline.md, "Cover").
struct TightPlaces {
  std::vector<std::uint32_t> slits;  ///< of the arrangement
  std::vector<NodeId> nodes;         ///< no end of a slit, not on the sum's boundary
  std::vector<SumVertex> pinches;    ///< isolated too; may be the same points, repeatedly
};

/// A vertex on the inside of an edge of another ring of its polygon.
struct EdgeCut {
  SiteId edge;
  SiteId at;
  SiteId last;  ///< as TouchingRings::last_edge
};

/// Two rays of a polygon's inside at a point: it lies left of `out`, and right of where the edge
/// `in` came from.
struct Corner {
  SiteId out;
  SiteId in;
};

/// Where rings of one polygon touch: parts of edges between such points, and their corners.
struct TouchingRings {
  std::vector<SiteId> last_edge;   ///< by site: the edge that ends its corner of the inside
  std::vector<EdgeCut> cuts;       ///< by edge, then along it
  std::vector<Corner> corners;     ///< at the touching points, point after point
  std::vector<SiteId> point;       ///< a vertex at each such point
  std::vector<std::uint32_t> end;  ///< of each point's corners
  bool parts_inside = false;       ///< whether the inside of a polygon may not be connected
};

/// Memory for the stage.
struct TightScratch {
  TouchingRings touching[2];
  std::vector<std::uint32_t> ring_of;  ///< by site
  std::vector<std::uint32_t> met;      ///< by ring: the number of the last test in which it did
  std::vector<std::uint8_t> marked;    ///< by node
};

/// Decides slits, crowded nodes and pinches. O(log n) and what touches for each, if boxes separate
/// the rest.
void find_tight_places(const Operands& operands, const Arrangement& arrangement, const Loops& loops,
                       const FilteredLoops& filtered, Predicates& predicates, BoxTrees& trees,
                       TightScratch& scratch, TightPlaces& places);

/// The places as a geometry, resolved (see Geometry).
void write_tight_places(const Operands& operands, const Arrangement& arrangement,
                        const TightPlaces& places, Cancellation& cancellation, Geometry& geometry);

/// Whether points are what they should be, and slits are free, or not, at other points than the
/// ones that were tested; what is wrong, if not.
[[nodiscard]] std::optional<std::string> check(const TightPlaces& places,
                                               const Arrangement& arrangement, const Loops& loops,
                                               const FilteredLoops& filtered,
                                               const Operands& operands);

// -- Steps ------------------------------------------------------------------------------------
/// Finds where rings of one polygon of an operand touch. O(n log n).
void find_touching_rings(const Operands& operands, int operand, const BoxTree& tree,
                         Predicates& predicates, TouchingRings& touching);

}  // namespace minksum
