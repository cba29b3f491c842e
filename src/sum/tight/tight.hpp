// Finds tight places: points inside the sum that the sum of the interiors misses.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "minksum/geometry.hpp"
#include "sum/filters/filters.hpp"

namespace minksum {

/// The placements x at which P and x − Q touch and have no play, or have play along a path only.
///
/// Let S = P ⊕ Q, let U = P° ⊕ Q° (which is open and has the closure S), and let X be the
/// complement of U. The tight places are the points of closure(S° ∖ U). For x in X, take all
/// contacts p + q = x. At each, take the cones of P at p and of Q at q, as open parts of the plane
/// around 0. Near x, U is x plus the union of the sums of one cone of each operand. X is x plus the
/// intersection C of the complements of these sums. x lies in S° if C has no inner points; then C
/// is 0 alone, or some rays. The proof takes one polygon of each operand at a time.
///
/// 1. *Segments bound X.* Take cones A of P and B of Q; A and −B are disjoint. If one is reflex,
///    say A, then A ⊕ B is A. The edges at p bound it, and the convex vertex q moves them. If both
///    are convex, the first and the last of their rays bound A ⊕ B. These are edges too. The vertex
///    that moves each edge is convex and has the edge's direction in its closed range. The
///    convolution takes half-open ranges: for parallel edges e and f, it has e moved by the start
///    of f, and f moved by the end of e. Follow such a contact along e to where it ends: at the end
///    of e or at the start of f. A reflex vertex there would let the insides meet. So the vertex is
///    convex, and its segment passes x.
/// 2. *Paths.* Let C be a line, and let no segment of another direction end at x or pass it. Then C
///    is an intersection of half-planes along this line, on both sides. So segments of both
///    directions pass x, which makes a slit. Along the line this changes only where another segment
///    ends or passes, at a node. So a slit is tight as a whole or nowhere (but for single points,
///    see 4).
/// 3. *Points.* C contains the intersection of the closed right half-planes of all segments at x.
///    If C is 0 alone, no closed half-plane contains all their directions: the node is crowded.
/// 4. *Touching rings.* A polygon has several cones, and gaps between them, where its rings touch.
///    (a) Suppose that no two of P's cones alternate with two of (x − Q)'s. Then each operand lies
///    in one gap of the other. That gap is a corner of one ring, and 1 holds with these two corners
///    for cones.
///    (b) Suppose that A, K, A', K' alternate. Then C = 0: moved by v, K must stay in its gap of P
///    and K' in its own gap. So v is in both gaps, which have only 0 in common. Such points are
///    `pinches`, whatever segments there are. Then neither inside is connected. The inside of P is
///    off Q, so it would lie beyond one ring of Q if it were connected. But A and A' are in
///    different gaps, and a ring passes x once.
///    (c) The convolution leaves out hole against hole. Suppose that corners of holes touch as in
///    (a). P's filling cannot lie in Q's hole while Q's filling lies in P's hole. So P, say, has
///    inner points in Q's hole and others beyond it. P is connected, so two cones of P, in
///    different gaps of Q, meet at a point. There (b) holds, and so x is a pinch.
///
/// All segments at a point of X are known, and so are all points that they share there. The reason
/// is that no point of X is in a covered cell (docs/pipeline.md, "3 Cover").
struct TightPlaces {
  std::vector<std::uint32_t> slits;  ///< indices of the arrangement's slits
  std::vector<NodeId> nodes;         ///< isolated points: no ends of slits, not on the boundary
  std::vector<SumVertex> pinches;    ///< isolated points too; may repeat themselves and `nodes`
};

/// A vertex that lies within an edge of another ring of its polygon.
struct EdgeCut {
  SiteId edge;
  SiteId at;
  SiteId last;  ///< as TouchingRings::last_edge
};

/// A corner of a polygon's inside at a point. The inside lies to the left of the edge `out`, and to
/// the right of the way back along the edge `in`.
struct Corner {
  SiteId out;
  SiteId in;
};

/// The points where rings of one polygon touch, with the corners there and the cuts of edges.
struct TouchingRings {
  std::vector<SiteId> last_edge;   ///< by site: the edge that ends its corner of the inside
  std::vector<EdgeCut> cuts;       ///< sorted by edge, and then along it
  std::vector<Corner> corners;     ///< corners at the touching points, point after point
  std::vector<SiteId> point;       ///< by touching point: a vertex there
  std::vector<std::uint32_t> end;  ///< by touching point: where its corners end
  bool parts_inside = false;       ///< whether the inside of a polygon may not be connected
};

/// Memory for the stage.
struct TightScratch {
  TouchingRings touching[2];
  std::vector<std::uint32_t> ring_of;  ///< by site
  std::vector<std::uint32_t> met;      ///< by ring: the last test in which it touched another one
  std::vector<std::uint8_t> marked;    ///< by node
};

/// Decides which slits, crowded nodes and pinches are tight. Each takes O(log n), plus the edges
/// that touch there, if boxes separate the others.
void find_tight_places(const Operands& operands, const Arrangement& arrangement, const Loops& loops,
                       const FilteredLoops& filtered, Predicates& predicates, BoxTrees& trees,
                       TightScratch& scratch, TightPlaces& places);

/// Writes the places as a resolved geometry (see Geometry).
void write_tight_places(const Operands& operands, const Arrangement& arrangement,
                        const TightPlaces& places, Cancellation& cancellation, Geometry& geometry);

/// Returns what is wrong with the places, or nothing. Points must be tight and isolated. Slits must
/// be free, or not, at other points than the ones that were tested.
[[nodiscard]] std::optional<std::string> check(const TightPlaces& places,
                                               const Arrangement& arrangement, const Loops& loops,
                                               const FilteredLoops& filtered,
                                               const Operands& operands);

// -- Steps ------------------------------------------------------------------------------------
/// Finds where rings of one polygon of an operand touch. O(n log n).
void find_touching_rings(const Operands& operands, int operand, const BoxTree& tree,
                         Predicates& predicates, TouchingRings& touching);

}  // namespace minksum
