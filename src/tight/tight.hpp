// Tight places: what the sum has in its interior and the sum of the interiors has not.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "filters/filters.hpp"
#include "minksum/geometry.hpp"

namespace minksum {

/// Where P and x − Q touch and have no play, or play along a path only.
///
/// Let S = P ⊕ Q, U = P° ⊕ Q° (open, with closure S), X its complement. Tight are the points of
/// closure(S° ∖ U). For x in X take all contacts p + q = x, and at each the cones of P at p and of Q
/// at q (as parts of the plane around 0, open). Near x, U is x plus the union of the sums of one cone
/// of each, X is x plus the intersection C of the complements. x lies in S° if C has no inner points:
/// it is a point or some rays then.
///
/// 1. *X's cone is made by reduced segments.* Take cones A of P and B of Q, A and −B disjoint. Either
///    one is reflex: A ⊕ B is A then, bounded by two edges at p, moved by the convex vertex q. Or both
///    are convex, and A ⊕ B is bounded by the first and the last ray of both: edges too, and the
///    vertex that moves each is convex and has the edge's direction in its closed range. The range
///    that counts is half-open: of parallel edges e and f, that touch along a piece, e moved by the
///    start of f counts and f moved by the end of e. Follow the contact along e to where it ends: at
///    the end of e or the start of f. A reflex vertex there would let the insides meet; so it is
///    convex, and its segment passes x. (Hole against hole does not count: see 4.)
/// 2. *Paths.* Where C is a line and no ray of another direction ends, X's cone is the intersection
///    of half-planes with that line, of both sides: so segments of both directions pass, and the piece
///    of the arrangement is a slit. Where that changes along a line a segment of another direction
///    ends or passes, which is a node. So a slit is tight as a whole or nowhere.
/// 3. *Points.* C = {0} contains the intersection of the closed right half-planes of all segments
///    through x: so their directions are not all in one closed half-plane, and x is crowded. (Two
///    that cross never are enough.)
/// 4. *Touching rings.* Where rings of one polygon touch, it has several cones. Suppose that two of
///    P's and two of Q's alternate around x. The one pair's gaps and the other's are disjoint then,
///    and C = {0}: `pinches` has these, whatever segments there are. If no two alternate, all of Q's
///    cones are in one gap of P's, that is beyond one corner of one ring, and the reverse: and what 1
///    says of cones holds for these two corners. Both corners may be those of holes only if pairs
///    alternate elsewhere: P is connected, has inner points in Q's hole and beyond it, so passes a
///    point where it touches itself and Q's ring at once. And pairs alternate only if the insides of
///    both polygons are not connected (a path between cones, inside, would separate the others).
///
/// All segments through a point of X are known there, and where they meet, because no such point is
/// in a covered cell (docs/pipeline.md, "Cover").
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

/// Two rays of a polygon's inside at a point: it lies left of `out`, and right of where the edge `in`
/// came from.
struct Corner {
  SiteId out;
  SiteId in;
};

/// Where rings of one polygon touch: parts of edges between such points, and their corners.
struct TouchingRings {
  std::vector<SiteId> last_edge;  ///< by site: the edge that ends its corner of the inside
  std::vector<EdgeCut> cuts;      ///< by edge, then along it
  std::vector<Corner> corners;    ///< at the touching points, point after point
  std::vector<SiteId> point;      ///< a vertex at each such point
  std::vector<std::uint32_t> end;  ///< of each point's corners
  bool parts_inside = false;      ///< whether the inside of a polygon may not be connected
};

/// Memory for the stage.
struct TightScratch {
  TouchingRings touching[2];
  std::vector<std::uint32_t> ring_of;   ///< by site
  std::vector<std::uint32_t> met;       ///< by ring: the number of the last test in which it did
  std::vector<std::uint8_t> marked;     ///< by node
  std::vector<BoxPair> stack;
};

/// Decides slits, crowded nodes and pinches. O(log n) and what touches for each, if boxes separate
/// the rest.
void find_tight_places(const Operands& operands, const Arrangement& arrangement,
                       const Loops& loops, const FilteredLoops& filtered,
                       const std::function<void()>& stop, Predicates& predicates, BoxTrees& trees,
                       TightScratch& scratch, TightPlaces& places);

/// The places as a geometry, resolved (see Geometry).
void write_tight_places(const Operands& operands, const Arrangement& arrangement,
                        const TightPlaces& places, Geometry& geometry);

/// Whether points are what they should be, and slits are free, or not, at other points than the ones
/// that were tested; what is wrong, if not.
[[nodiscard]] std::optional<std::string> check(const TightPlaces& places,
                                               const Arrangement& arrangement, const Loops& loops,
                                               const FilteredLoops& filtered,
                                               const Operands& operands);

// -- Steps ------------------------------------------------------------------------------------
/// Finds where rings of one polygon of an operand touch. O(n log n).
void find_touching_rings(const Operands& operands, int operand, const BoxTree& tree,
                         Predicates& predicates, TouchingRings& touching);

}  // namespace minksum
