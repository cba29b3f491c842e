// Defines what the steps of an overlay pass on: segments, contacts, and the subdivided plane.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "machine/cancellation.hpp"
#include "overlay/load_points.hpp"
#include "overlay/overlay.hpp"
#include "overlay/predicates.hpp"

namespace minksum::overlay {

using SegmentId = std::uint32_t;
using NodeId = std::uint32_t;
using PieceId = std::uint32_t;
inline constexpr std::uint32_t kNone = 0xFFFFFFFFU;

/// What chains make of the points between two ends. Seen from low to high, windings on the left are
/// greater by `change` than those on the right.
struct Share {
  Winding change;
  bool belongs = false;
  std::int32_t spared = 0;

  void add(const Share& other) {
    change = change + other.change;
    belongs |= other.belongs;
    spared += other.spared;
  }
  /// Tells whether this makes no difference to any result.
  [[nodiscard]] bool idle() const { return change == Winding{} && !belongs && spared == 0; }
};

/// Adds up the shares of neighbours that have the same ends, and drops what is idle. Returns the
/// new end.
template <class Iterator, class Same>
[[nodiscard]] Iterator merge_equal(Iterator first, Iterator last, Same same) {
  Iterator kept = first;
  for (Iterator next = first; next != last; ++next) {
    if (kept != first && same(*(kept - 1), *next)) {
      (kept - 1)->add(*next);
    } else {
      *kept++ = *next;
    }
  }
  return std::remove_if(first, kept, [](const Share& share) { return share.idle(); });
}

/// A segment; no two have the same ends.
struct Segment : Share {
  Ends ends;
};

/// Distinct points in lexicographic order, and the segments between them. The predicates hold the
/// operation's Cancellation.
struct Segments {
  Predicates predicates;
  std::vector<Source> sources;        ///< by point: one vertex at the point
  std::vector<std::uint8_t> belongs;  ///< by point: a chain of this point alone belongs
  std::vector<Segment> list;

  [[nodiscard]] Cancellation& cancellation() const { return predicates.cancellation(); }
};

/// A point that lies inside a segment.
struct Touch {
  SegmentId segment;
  PointId point;
  friend auto operator<=>(const Touch&, const Touch&) = default;
};
/// Two segments whose insides cross, first < second.
struct Crossing {
  SegmentId first;
  SegmentId second;
  friend auto operator<=>(const Crossing&, const Crossing&) = default;
};
struct Contacts {
  std::vector<Touch> touches;  ///< each once, and each crossing once
  std::vector<Crossing> crossings;
};
/// How many contacts are sought. Those found twice may count twice.
struct MostContacts {
  std::size_t touches;
  std::size_t crossings;
};

struct Node {
  ApproximateLocation at;
  ExactLocation place;
  bool belongs = false;
};

/// Part of a segment between two nodes, with no node inside. Pieces meet only at nodes, and no two
/// have the same ends.
struct Piece : Share {
  NodeId low = 0;
  NodeId high = 0;
  SegmentId segment = 0;

  // Set by the sweep:
  bool thin = false;          ///< in the result, without area beside it
  bool inside_above = false;  ///< whether the face on the left, seen from low to high, is inside
  bool inside_below = false;
  /// The nearest piece of the area's boundary straight below, through pieces that are inside on
  /// both sides. kNone if the face below is not inside.
  PieceId ground = kNone;
  std::uint32_t place_at_low = 0;  ///< in Subdivision::around
  std::uint32_t place_at_high = 0;

  [[nodiscard]] bool is_boundary() const { return inside_above != inside_below; }
};

/// A subdivided plane. Nodes are in lexicographic order, so their numbers compare as their points.
struct Subdivision {
  std::vector<Node> nodes;
  std::vector<Piece> pieces;               ///< by low node, then counter-clockwise
  std::vector<std::uint32_t> first_piece;  ///< by node, and one more: its first piece

  // Set by the sweep:
  std::vector<PieceId> around;              ///< pieces counter-clockwise around each node, from
                                            ///< straight down (excluded)
  std::vector<std::uint32_t> first_around;  ///< by node, and one more
  /// By node: whether the face just left of it is inside, and the ground there (see Piece).
  std::vector<std::uint8_t> inside_left;
  std::vector<PieceId> ground_left;
};

[[noreturn]] inline void broken(const char* what) {
  throw Error(ErrorCode::kInternal, what, {}, "overlay");
}

// -- Steps, in their order -----------------------------------------------------------------------
/// Lists points and segments. Equal points become one, equal segments too, and closed chains are
/// directed. `cancellation` must live as long as the segments.
[[nodiscard]] Segments list_segments(std::span<const Chain> chains, Cancellation& cancellation);

/// Finds all touches and crossings. Cells are divided at medians, and each segment's box is cut to
/// its cell. If two segments meet, they do so in some cell where both boxes hold the point. Gives
/// up and returns false if there are more contacts than `most`. Throws Error(kLimitExceeded) as
/// `select` does.
[[nodiscard]] bool find_contacts(const Segments& segments, const MostContacts& most,
                                 Contacts& contacts);

/// Finds all touches of segments that neither cross nor overlap, in O(n log n). Such segments are
/// those that the returned list, which is by segment, has 0 for.
[[nodiscard]] std::vector<std::uint8_t> sweep_contacts(const Segments& segments,
                                                       std::vector<Touch>& touches);

/// Replaces segments that overlap on one line by segments that do not. If k segments contain each
/// other, they have up to k² touches, and become at most 2k segments. Joining pays only for such
/// crowds. O(n log n).
void join_lines(Segments& segments);

/// Cuts segments at their contacts. Nodes are equal if their exact locations are. O((n + c) log (n
/// + c)) for n segments and c contacts.
[[nodiscard]] Subdivision subdivide(const Segments& segments, const Contacts& contacts);

/// Fills in the members that the sweep finds, and clears `belongs` of nodes that the rule does not
/// keep. A line moves over the nodes in their order and keeps the pieces that it meets in a
/// balanced tree. No pieces cross, so their order changes only at nodes. A place is sought, by
/// exact comparison, only where no piece ends. O(n log n).
void sweep(const Segments& segments, const Rule& rule, Subdivision& subdivision);

/// Extracts the closed area, in canonical form.
void extract_area(const Segments& segments, const Subdivision& subdivision, Region& area);

/// Extracts the parts of the result outside of the area, as maximal polylines and points.
void extract_thin(const Segments& segments, const Subdivision& subdivision, Geometry& geometry);

}  // namespace minksum::overlay
