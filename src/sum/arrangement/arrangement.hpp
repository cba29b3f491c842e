// Stage 4: builds the arrangement of the convolution's segments, outside the cover only.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "machine/forest.hpp"
#include "minksum/testing.hpp"
#include "spatial/box_pairs.hpp"
#include "spatial/median_division.hpp"
#include "sum/arrangement/cell_box.hpp"
#include "sum/arrangement/visible_segments.hpp"
#include "sum/convolution/convolution.hpp"
#include "sum/cover/cover.hpp"

namespace minksum {

using KeptId = std::uint32_t;  ///< index of a kept segment
using NodeId = std::uint32_t;
using PieceId = std::uint32_t;
inline constexpr PieceId kNoPiece = 0xFFFFFFFFU;

/// A segment that touches an uncovered cell, with its approximate place. It may also be joined from
/// several segments that overlap on one line in one direction. Then a and b are the ends of the
/// whole, d leads from a to b, and `segment` is the first of the segments.
struct KeptSegment {
  Vec<double> a;
  Vec<double> b;
  Vec<double> d;
  Segment segment;
  std::uint32_t joined;  ///< 0, or one more than its index in `JoinScratch::joined`
  std::uint32_t line;    ///< equal for parallel segments, of either sense, and only for them
  DirectionRank rank;
  bool meets_cover;  ///< false if it is known that the clipped segment is near no covered cell
  Clip clip;

  /// Returns the part that may be boundary.
  [[nodiscard]] Line clipped() const { return clip.of({a, b}); }
};

/// A point where pieces begin or end. `point` is exact, and `at` is within `error` of it in each
/// component.
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

/// Kept segments, split at their nodes.
///
/// Every point of the sum's boundary at which two kept segments meet is one node, found on both.
/// Crossings inside the cover, in hidden parts, or on what was clipped off, may be missing. Pieces
/// are missing that run through the cover or a hidden part, or into what was clipped off, or that
/// begin or end on the left of another segment (but not beside joined ones, and not where tight
/// places are wanted). They are not boundary. Without them, loops may close that would not close
/// otherwise. No piece of such a loop is boundary: boundary pieces follow each other around a free
/// face, and nothing is within that face. No two pieces have the same ends. One of several equal
/// pieces stays; opposite pieces have the sum on both sides and are dropped.
struct Arrangement {
  /// The segments that were split, and then the members of joined ones. Pieces refer to members.
  std::vector<KeptSegment> kept;
  std::vector<Node> nodes;
  std::vector<Piece> pieces;
  std::uint64_t crossings = 0;  ///< proper crossings of kept segments
  // Tight places can be at slits and crowded nodes. Both are filled if tight places are wanted.
  std::vector<Piece> slits;     ///< one of each two opposite pieces
  std::vector<NodeId> crowded;  ///< nodes whose segments' directions no closed half-plane contains
};

/// A kept segment in a cell that it touches, with a box of its part there.
struct CellItem {
  CellBox box;
  std::uint32_t cell;
  KeptId segment;
};

/// Some of the kept segments, and the cells that they touch.
struct alignas(64) CellPart {   // threads fill neighbours: each needs cache lines of its own
  std::vector<CellItem> items;  ///< in order of their segments, numbered from 0 on
  KeptId before = 0;            ///< kept segments of earlier parts
  KeptId kept = 0;
};

/// What a thread notes of its slice of all items while it sorts them by cell. The last slice has
/// the stage's own `cell_end` in the place of `end`, and the first one `cells` of the stage.
struct alignas(64) CellSlice {       // threads fill neighbours: each needs cache lines of its own
  std::vector<std::uint32_t> end;    ///< by cell: how many items, and then where they end
  std::vector<std::uint32_t> cells;  ///< cells that have items
};

/// A point on a kept segment where another one meets it.
struct Event {
  double lambda;  ///< position along the segment, within `error`
  double error;
  KeptId segment;
  std::uint32_t point;  ///< number of the point, see ArrangementScratch
};

/// A proper crossing of two kept segments, at `lambda` along the first. The first comes from the
/// left of the second, and so the second comes from the right of the first.
struct Crossing {
  KeptId first;
  KeptId second;
  double lambda;
  double error;
};

/// A part of a kept segment that certainly lies inside the sum. Meetings there may be missing.
struct HiddenPart {
  KeptId segment;
  double from;  ///< position along the segment
  double to;
};

/// Where segments were found to meet, in a part of the cells.
struct alignas(64) Meetings {  // threads fill neighbours: each needs cache lines of its own
  std::vector<Crossing> crossings;
  std::vector<Event> events;  ///< points count crossings from those of this part on
  std::vector<HiddenPart> hidden;
  std::uint32_t before = 0;   ///< crossings of earlier parts
  bool lines_shared = false;  ///< whether segments are known to be on one line
};

/// A piece between two roots of points.
struct FoundPiece {
  std::uint32_t from_root;
  std::uint32_t to_root;
  KeptId maker;
};
struct alignas(64) FoundPieces {  // threads fill neighbours: each needs cache lines of its own
  std::vector<FoundPiece> pieces;
};

/// A piece's link in the list of pieces that share its lower node.
struct ListedPiece {
  PieceId next;
  bool cancelled;  ///< whether there is an opposite piece
};

/// A segment's direction at a point on it, its ends included.
struct Incident {
  std::uint32_t point;
  DirectionRank rank;
};

/// Segments that were joined: the members [first, end). The part of each that may be boundary
/// starts no earlier and ends later than that of the one before. `last` is the last of them.
struct JoinedSegments {
  Segment last;
  KeptId first;
  KeptId end;
};

/// A segment's position on its line. `line` is the cross product with the direction of the
/// segment's rank, modulo 2^64. `from` and `to` are its ends along that direction, or those of what
/// clipping has left, to whole steps of the grid.
struct LinePosition {
  std::uint64_t line;
  double from;
  double to;
  KeptId id;
};

/// A segment that passes a strip from one side to the other: where it enters and leaves.
struct StripLine {
  double left;
  double right;
  std::uint32_t item;
};

/// Crowds of short segments, each of which is divided apart. A group has a number in the place of a
/// segment's, after those of all segments.
struct SegmentGroups {
  struct Group {
    std::size_t begin;  ///< in `members`, to `end`; the first starts at the origin
    std::size_t end;
    double extent;  ///< no component of the members' ends is larger
  };
  std::vector<BoxedSegment> members;
  std::vector<Line> moved;  ///< the members where they are divided
  std::vector<Group> groups;
};

struct MovedCrowd;

/// Memory for crowds.
struct CrowdScratch {
  SegmentGroups groups;
  std::unique_ptr<MovedCrowd> moved;  ///< null before there is a group
  std::vector<BoxedSegment> items;
  std::vector<StripLine> lines;
  std::vector<std::uint32_t> by_right;  ///< lines, in their order on the right
};

/// Memory for the members of a group, where they are moved.
struct MovedCrowd {
  std::vector<KeptSegment> kept;  ///< by segment; only those of the members are set
  CrowdScratch memory;
};

/// Memory of one thread that finds crossings.
struct alignas(64) MeetingScratch {
  std::vector<std::pair<KeptId, KeptId>> near;  ///< pairs of a cell whose boxes overlap
  CrowdScratch crowds;
};

/// What was joined in some of the directions.
struct alignas(64) JoinedPart {  // threads fill neighbours: each needs cache lines of its own
  std::vector<KeptSegment> members;
  std::vector<JoinedSegments> joined;
  std::vector<KeptId> wholes;  ///< the first member of each, whose place the whole takes
};

/// What was joined in all directions, and memory for joining.
struct JoinScratch : JoinedPart {
  std::vector<Vec<double>> directions;       ///< by rank: an edge's vector
  std::vector<std::uint64_t> lines;          ///< by segment: equal on one line in one direction
  std::vector<KeptId> first_on_line;         ///< a hash table of the first segment of each line
  std::vector<std::uint8_t> shares_line;     ///< by segment: whether another one has its line
  std::vector<KeptId> candidates;            ///< segments that may share a line with others
  std::vector<LinePosition> places;          ///< direction by direction, and then along lines
  std::vector<std::uint32_t> begin_of_rank;  ///< in `places`
  std::vector<std::uint8_t> gone;            ///< by segment: whether another one contains it
  std::vector<JoinedPart> parts;             ///< of all tasks but the first
};

/// Memory for binning.
struct BinScratch {
  std::vector<Segment> ordered;
  std::vector<std::uint32_t> begin;  ///< by site: where its segments begin in `ordered`
  std::vector<Clip> clips;
};

/// Memory for the stage. Points have numbers: 2s and 2s + 1 are the ends of kept segment s, and
/// then come the crossings. Equal points are united in a forest. The smallest point of a tree is
/// its root.
struct ArrangementScratch {
  UniformGrid grid;       ///< the grid of the cells below
  bool covered = false;   ///< whether anything is covered
  bool by_cells = false;  ///< whether there are cells; there are none if nothing is covered
  Vec<double> extent{};   ///< the size of the sum's box, which starts at (0, 0)
  BoxPairScratch pairs;
  VisibleScratch visible;
  BinScratch bin;
  JoinScratch join;
  KeptId line_count = 0;  ///< kept segments that are split; members come after
  std::vector<CellPart> parts;
  std::vector<CellItem> in_cells;       ///< items cell by cell
  std::vector<std::uint32_t> cells;     ///< cells that have items
  std::vector<std::uint32_t> cell_end;  ///< by cell: where its items end in `in_cells`, or 0
  std::vector<CellSlice> slices;
  std::vector<MeetingScratch> meeting;  ///< by thread
  std::vector<Meetings> meetings;       ///< part by part; crossings are moved to the next list
  std::vector<Crossing> crossings;
  std::vector<HiddenPart> hidden;  ///< of all segments, in any order
  std::vector<Incident> incidents;
  std::vector<Event> sorted_events;
  std::vector<std::uint32_t> event_begin;  ///< by kept segment
  /// Which stretches between events have hidden parts: segment by segment, and of each segment one
  /// more than it has events. Empty if nothing is hidden.
  std::vector<std::uint8_t> hides;
  enum class Ordered : std::uint8_t { kNot, kRoughly, kWholly };
  std::vector<Ordered> ordered;  ///< by kept segment: how far threads have ordered its events
  std::vector<std::uint32_t> root_of_node;  ///< a point for each node
  std::vector<FoundPieces> found_pieces;    ///< by task, where threads find them
  std::vector<std::uint32_t> parent;
  std::vector<std::uint32_t> line_parent;  ///< a forest of segments known to be on one line
  bool lines_shared = false;               ///< whether segments are known to be on one line
  std::vector<NodeId> node_of_point;
  std::vector<PieceId> first_piece;     ///< by node: a list of pieces to nodes of higher numbers
  std::vector<ListedPiece> next_piece;  ///< by piece

  /// Returns the events on a segment.
  [[nodiscard]] std::span<Event> events_of(KeptId s) {
    return std::span(sorted_events).subspan(event_begin[s], event_begin[s + 1] - event_begin[s]);
  }
  [[nodiscard]] std::span<const Event> events_of(KeptId s) const {
    return std::span(sorted_events).subspan(event_begin[s], event_begin[s + 1] - event_begin[s]);
  }
};

/// Builds the arrangement: for k segments in O(k · cells per segment + pairs within uncovered cells
/// + c log c). Among all pairs of boxes, pairs that share columns take the place of cells.
void arrange(const Operands& operands, const Convolution& convolution, const Cover& cover,
             const SumSettings& options, Predicates& predicates, ArrangementScratch& scratch,
             Arrangement& arrangement);

/// Builds the arrangement by merging, if each operand is one convex ring. Then all edges in order
/// of direction are the sum's boundary (Guibas, Ramshaw, Stolfi 1983). O(n + m).
void arrange_convex(const Operands& operands, Cancellation& cancellation, Arrangement& arrangement);

// -- Steps ------------------------------------------------------------------------------------
/// Joins segments that overlap or touch on one line in one direction, and drops segments that
/// others contain. Of clipped segments, the parts count that may be boundary. Does nothing unless
/// doubles hold coordinates (B ≤ 52). O(k + j log j), of which j segments may share a line with
/// others.
///
/// Then coinciding pieces are found once instead of once for each pair. So are the points at which
/// they end or meet others. The union of segments is the same. Its arrangement is the same but for
/// nodes in the middle of a line at which nothing else ends. Vectors d of joined segments have one
/// bit more than edges have, and are exact. Their cross products are differences of products below
/// 2^(2B+2), which are exact for B ≤ 25, and bounded as others are beyond.
void join_lines(const Operands& operands, Cancellation& cancellation, JoinScratch& scratch,
                std::vector<KeptSegment>& kept);
/// Fills `kept`, and the lists of the cover's cells if crossings are to be looked for there.
void bin_segments(const Operands& operands, const Convolution& convolution, const Cover& cover,
                  const Limits& limits, Cancellation& cancellation, ArrangementScratch& scratch,
                  Arrangement& arrangement);
/// Fills crossings, events and hidden parts, and unites points that pairs of segments share.
void find_crossings(const Operands& operands, const Cover& cover, const SumSettings& options,
                    Predicates& predicates, ArrangementScratch& scratch, Arrangement& arrangement);
/// Orders events along each segment, unites equal ones, and makes nodes and pieces. O(c log c) for
/// c incidences.
///
/// If tight places are wanted, it keeps pieces inside the sum, where these are. It also lists slits
/// and crowded nodes. Around a crowded node, each turn from one of its segments' directions to the
/// next is by less than half a circle. All segments that are known to pass the node count, whether
/// their pieces stay or not.
void split_segments(const Operands& operands, const Cover& cover, bool tight_wanted,
                    Predicates& predicates, ArrangementScratch& scratch, Arrangement& arrangement);

/// Returns the segment whose end is the end of a kept one.
[[nodiscard]] inline const Segment& last_segment(const KeptSegment& s, const JoinScratch& scratch) {
  return s.joined == 0 ? s.segment : scratch.joined[s.joined - 1].last;
}

/// Compares nodes exactly, with the filter in front.
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

/// Returns what is wrong with the arrangement, or nothing. Pieces and nodes must fit exactly.
[[nodiscard]] std::optional<std::string> check(const Arrangement& arrangement,
                                               const Operands& operands);

}  // namespace minksum
