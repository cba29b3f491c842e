// Stage 4: the arrangement of the convolution segments, outside the cover only.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "spatial/box_pairs.hpp"
#include "sum/arrangement/cell_box.hpp"
#include "sum/arrangement/visible_segments.hpp"
#include "sum/convolution/convolution.hpp"
#include "sum/cover/cover.hpp"

namespace minksum {

using KeptId = std::uint32_t;  ///< index of a kept segment
using NodeId = std::uint32_t;
using PieceId = std::uint32_t;
inline constexpr PieceId kNoPiece = 0xFFFFFFFFU;
/// Two ends of each kept segment and all crossings are numbered in 32 bits: there are at most so
/// many kept segments, and so many crossings.
inline constexpr std::uint64_t kMostNumbered = std::uint64_t{1} << 30;

/// A segment that touches an uncovered cell, with its approximate place. Or several that overlap on
/// one line in one direction, joined to one: then a and b are its ends, d leads from one to the
/// other, and `segment` is the first of them.
struct KeptSegment {
  Vec<double> a;
  Vec<double> b;
  Vec<double> d;
  Segment segment;
  std::uint32_t joined;  ///< 0, or one more than its number among those joined
  std::uint32_t line;    ///< equal for parallel segments, of either sense, and only for them
  DirectionRank rank;
  bool meets_cover;      ///< false if it is near no covered cell
};

/// A point where pieces end: exactly `point`, within `error` per component of `at`.
struct Node {
  NodePoint point;
  Vec<double> at;
  double error;
};

/// A part of a kept segment between two nodes, directed as the segment is.
struct Piece {
  NodeId from;
  NodeId to;
  KeptId segment;
};

/// Kept segments split at their nodes.
///
/// Complete where it matters: every point of the sum's boundary at which two kept segments meet is
/// one node, found on both. Crossings inside the cover may be missing, and pieces that run through
/// it, or begin or end on the left of another segment, are: they are not boundary. A loop that such
/// pieces would have kept from closing is made of pieces that are not boundary either: those that
/// are follow each other around a free face, and nothing is within it. No two pieces have the same
/// ends: of equal ones one stays; opposite ones have the sum on both sides and are dropped.
struct Arrangement {
  /// First those that were split, then the members of joined ones: pieces refer to the members.
  std::vector<KeptSegment> kept;
  std::vector<Node> nodes;
  std::vector<Piece> pieces;
  std::uint64_t crossings = 0;  ///< proper crossings of kept segments
  // Where tight places can be; filled if they are wanted.
  std::vector<Piece> slits;     ///< of each two opposite pieces one
  std::vector<NodeId> crowded;  ///< nodes whose segments' directions no closed half-plane contains
};

/// A kept segment in a cell that it touches, with a box of its part there.
struct CellItem {
  CellBox box;
  std::uint32_t cell;
  KeptId segment;
};

/// A point on a kept segment where another one meets it.
struct Event {
  double lambda;  ///< position along the segment, within `error`
  double error;
  KeptId segment;
  std::uint32_t point;  ///< see ArrangementScratch
};

/// A proper crossing of two kept segments, at `lambda` along the first. That one comes from the
/// left of the second; so the second comes from the right of the first.
struct Crossing {
  KeptId first;
  KeptId second;
  double lambda;
  double error;
};

/// A piece's place in the list of those with its lower node.
struct ListedPiece {
  PieceId next;
  bool cancelled;  ///< there is an opposite piece
};

/// A segment's direction at a point on it, its ends included.
struct Incident {
  std::uint32_t point;
  DirectionRank rank;
};

/// Segments that were joined: the members [first, end), which run ahead of each other at both ends.
struct JoinedSegments {
  Segment last;
  KeptId first;
  KeptId end;
};

/// A segment's line, as the cross product with the direction of its rank, rounded, and its ends
/// along that.
struct LinePosition {
  double line;
  double from;
  double to;
  DirectionRank rank;
  KeptId id;
};

/// Memory for joining.
struct JoinScratch {
  std::vector<SiteId> edge_of_rank;
  std::vector<LinePosition> places;
  std::vector<KeptSegment> members;
  std::vector<KeptSegment> result;
  std::vector<JoinedSegments> joined;
};

/// Memory for binning.
struct BinScratch {
  std::vector<Segment> ordered;
  std::vector<std::uint32_t> place;  ///< by site: where its segments are in `ordered`
  std::vector<std::uint8_t> shared;  ///< by rank: whether several edges have it
};

/// Memory for the stage. Points are numbered: 2s and 2s + 1 are the ends of kept segment s, then
/// come the crossings. Equal points are united in a forest whose roots are their smallest members.
struct ArrangementScratch {
  UniformGrid grid;   ///< of the cells below
  bool swept = false;   ///< there are none: all segments are swept at once
  Vec<double> extent{};  ///< of all segments, from (0, 0) on; if swept
  BoxPairScratch pairs;
  VisibleScratch visible;
  BinScratch bin;
  JoinScratch join;
  KeptId line_count = 0;                   ///< kept segments that are split; members come after
  std::vector<CellItem> items;             ///< in order of their segments,
  std::vector<CellItem> in_cells;          ///< and cell by cell
  std::vector<std::uint32_t> cells;        ///< those that have items
  std::vector<std::uint32_t> cell_end;     ///< by cell: where its items end in `in_cells`, or 0
  std::vector<KeptId> kept_id;             ///< by segment, if the cover is divided
  std::vector<std::uint32_t> leaf_end;     ///< by leaf: where its items end in `in_cells`
  std::vector<KeptId> hash_table;
  std::vector<std::vector<CellItem>> stack;  ///< items of a cell, level by level of its division
  std::vector<CellItem> sweep_order;
  std::vector<Crossing> crossings;
  std::vector<Event> events;
  std::vector<Incident> incidents;
  std::vector<Event> sorted_events;
  std::vector<std::uint32_t> event_begin;  ///< by kept segment
  std::vector<std::uint32_t> parent;
  std::vector<std::uint32_t> line_parent;  ///< the same for segments known to be on one line
  bool lines_shared = false;               ///< there are such
  std::vector<NodeId> node_of_point;
  std::vector<PieceId> first_piece;     ///< by node: a list of pieces to nodes of higher numbers
  std::vector<ListedPiece> next_piece;  ///< by piece
};

/// Builds it.
/// O(k · cells per segment + pairs within uncovered cells + c log c).
void arrange(const Operands& operands, const Convolution& convolution, const Cover& cover,
             const Options& options, Predicates& predicates, ArrangementScratch& scratch,
             Arrangement& arrangement);

/// The same where each operand is one convex ring, by merging: their edges in order of direction
/// are the sum's boundary (Guibas, Ramshaw, Stolfi 1983). O(n + m).
void arrange_convex(const Operands& operands, Cancellation& cancellation, Arrangement& arrangement);

// -- Steps ------------------------------------------------------------------------------------
/// Whether so many segments share directions that many may share lines, and their places in
/// doubles are exact (B ≤ 52).
[[nodiscard]] bool lines_are_joined(const Operands& operands, std::size_t segments);
/// If wanted: joins segments that overlap, or touch, on one line in one direction; drops what
/// others contain. Then coinciding pieces and the points at which they end or meet others are found
/// once instead of once for each pair. The union of segments is the same, and so is its
/// arrangement, but for nodes in the middle of a line at which nothing else ends. Vectors d of
/// joined segments have one bit more than edges have, and are exact: their cross products are
/// differences of products below 2^(2B+2), exact for B ≤ 25, and bounded as others are beyond.
/// O(k log k).
void join_lines(const Operands& operands, bool wanted, Cancellation& cancellation,
                JoinScratch& scratch, std::vector<KeptSegment>& kept);
/// Fills `kept` and the cells' lists. The cells are the cover's; where it covers nothing, they are
/// of a size that suits the segments, and none are needed if boxes of segments hardly overlap.
void bin_segments(const Operands& operands, const Convolution& convolution, const Cover& cover,
                  const Limits& limits, Cancellation& cancellation, ArrangementScratch& scratch,
                  Arrangement& arrangement);
/// The same from the leaves of a divided cover. O(segments listed).
void bin_leaves(const Operands& operands, const Convolution& convolution, const Cover& cover,
                Cancellation& cancellation, ArrangementScratch& scratch, Arrangement& arrangement);
/// Fills crossings and events, unites points that pairs of segments share.
void find_crossings(const Cover& cover, const Options& options, Predicates& predicates,
                    ArrangementScratch& scratch, Arrangement& arrangement);
/// Orders events along each segment, unites equal ones, makes nodes and pieces.
///
/// If tight places are wanted, keeps pieces inside the sum, where these are, and lists slits and
/// crowded nodes: around these, each turn from one of their segments' directions to the next is by
/// less than half a circle. All segments that are known to pass count, whether their pieces stay or
/// not. O(c log c) for c incidences.
void split_segments(const Operands& operands, const Cover& cover, bool tight_wanted,
                    Predicates& predicates, ArrangementScratch& scratch, Arrangement& arrangement);

/// The segment with whose end a kept one ends.
[[nodiscard]] inline const Segment& last_segment(const KeptSegment& s, const JoinScratch& scratch) {
  return s.joined == 0 ? s.segment : scratch.joined[s.joined - 1].last;
}

/// The root of a point.
inline std::uint32_t find_root(std::vector<std::uint32_t>& parent, std::uint32_t point) {
  while (parent[point] != point) {
    parent[point] = parent[parent[point]];
    point = parent[point];
  }
  return point;
}
inline void unite(std::vector<std::uint32_t>& parent, std::uint32_t a, std::uint32_t b) {
  a = find_root(parent, a);
  b = find_root(parent, b);
  if (a < b) parent[b] = a;
  if (b < a) parent[a] = b;
}

/// Whether pieces and nodes fit together, exactly; what is wrong, if not.
[[nodiscard]] std::optional<std::string> check(const Arrangement& arrangement,
                                               const Operands& operands);

}  // namespace minksum
