// Stage 2: lists the convolution's segments, which contain the sum's boundary.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sum/operands/operands.hpp"

namespace minksum {

/// The most segments that are kept or listed, and the most crossings: numbers of segments' ends and
/// of crossings have 32 bits.
inline constexpr std::uint64_t kMostNumbered = std::uint64_t{1} << 30;

/// A convolution's directed segments. The sum lies on the left of each; only the right side can be
/// free. Very many segments are only counted: most lie inside the sum and are never needed.
struct Convolution {
  std::vector<Segment> segments;  ///< all if `listed()`, else one of each `step` in turn
  std::uint64_t size = 0;         ///< the number of all segments
  std::uint64_t step = 1;
  [[nodiscard]] bool listed() const { return step == 1; }
};

/// The edges of one operand by direction. Edges [first[r], first[r + 1]) have rank r.
struct EdgesByRank {
  std::vector<SiteId> edges;
  std::vector<std::uint32_t> first;
};

/// A run of `length` ranks of directions, counter-clockwise from `from` on.
struct RankRange {
  DirectionRank from;
  DirectionRank length;
};

/// Memory for the stage.
struct ConvolutionScratch {
  EdgesByRank all;
  EdgesByRank outer;  ///< edges of outer rings only
};

/// Lists the reduced convolution (Behar and Lien, section IV-A): the segments of each convex vertex
/// and its compatible edges of the other operand. O(n + m + k).
///
/// Vertices of the first operand own the half-open range [in, out), those of the second (in, out].
/// Then each of two parallel edges is moved by one end of the other, and nothing is lost or
/// doubled. A hole never meets a hole. Only area counts between two thin operands, and parallel
/// edges alone sweep none. There an edge is listed where the other walk turns to its left: with
/// [in, out] at vertices within, and with (in, out) at ends, where the walk turns back.
void reduced_convolution(const Operands& operands, const Limits& limits, Cancellation& cancellation,
                         ConvolutionScratch& scratch, Convolution& convolution);

/// Lists the reduced convolution if it has at most `many` segments, and else a sample of it. The
/// sample has `kSample` to 2 · `kSample` segments.
/// O(n + m + min(k, many)).
void reduced_convolution_or_sample(const Operands& operands, const Limits& limits,
                                   std::uint64_t many, Cancellation& cancellation,
                                   ConvolutionScratch& scratch, Convolution& convolution);
/// So many are looked at only where few of them are visible. With 1,024, of which 70 to 160 were
/// visible, no crossing was seen where there were 10,000.
inline constexpr std::size_t kSample = 4096;
/// Of a listed convolution, if it has enough. With 128, sums that take 16 to 50 µs without a cover
/// took up to 1.5 times as long as with 64.
inline constexpr std::size_t kFewestSampled = 64;

/// Returns the directions of the edges that are compatible with a convex vertex.
[[nodiscard]] RankRange reduced_range(const Operands& operands, SiteId vertex);

/// Whether a segment equals one that comes first along the first operand's rings. The operands must
/// be equal. Then an edge at a vertex is listed for both, unless it is parallel to an edge at that
/// vertex.
[[nodiscard]] bool is_copy(const Operands& operands, const Segment& segment);

/// Lists the full convolution (Wein 2006, as CGAL has it), to which reflex vertices contribute too.
/// Each takes all directions counter-clockwise from its incoming to its outgoing edge. O(n·m).
void full_convolution(const Operands& operands, const Limits& limits, Cancellation& cancellation,
                      ConvolutionScratch& scratch, Convolution& convolution);

// -- Clipping ---------------------------------------------------------------------------------
/// A segment in doubles.
struct Line {
  Vec<double> start;
  Vec<double> end;
};

/// The part of a segment that may be boundary. Both numbers are shares of the segment's length.
struct Clip {
  float from = 0;
  float to = 1;
  [[nodiscard]] bool is_whole() const { return from == 0 && to == 1; }
  [[nodiscard]] bool is_empty() const { return from >= to; }
  /// Returns that part of a line.
  [[nodiscard]] Line of(const Line& line) const {
    const Vec<double>& a = line.start;
    const Vec<double>& b = line.end;
    const auto at = [&](double share) {
      return Vec<double>{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
    };
    return {from == 0 ? a : at(from), to == 1 ? b : at(to)};
  }
};

/// Finds parts of segments that certainly lie inside the sum, by a look at the operand of the
/// segment's vertex near that vertex.
///
/// Let s = p + e be a segment of a vertex p of P and an edge e of Q. Let an edge f of P cross the
/// line of s where s has the parameter c; c may be less than 0, or more than 1. Then the points of
/// s between c and 1 + c lie in the interior of the parallelogram e ⊕ f, and so of P ⊕ Q. No such
/// point x is a tight place either, since e crosses an edge of x − P.
///
/// So if P returns to the line ahead of p, only the beginning of s is left, and if it returns
/// behind p, only the end. If it returns on both sides, and the ways to there are shorter than e
/// together, nothing is left. That is so at most convex vertices of a P that is small and rough
/// beside e. There no cells of a grid are so small that they would fit inside P.
class SegmentClipper {
 public:
  explicit SegmentClipper(const Operands& operands)
      : operands_(&operands), bounds_(operands.bounds) {}
  /// For rings that are not such operands'.
  explicit SegmentClipper(const RoundingBounds& bounds) : bounds_(bounds) {}
  /// The work of a segment (see Cancellation), at most.
  static constexpr std::uint64_t kUnits = 8;
  /// The vertices of rings.
  struct Rings {
    const double* x;
    const double* y;
    const SiteId* next;
    const SiteId* previous;
  };
  /// Returns the part that may be boundary; it is empty if there is none. O(1). The segment is an
  /// edge of one operand, d, moved by a vertex of the other one's rings.
  [[nodiscard]] Clip clip(const Vec<double>& d, const Rings& rings, SiteId vertex) const;
  [[nodiscard]] Clip clip(const Segment& segment) const;

 private:
  void cut(const Vec<double>& d, const Vec<double>& a, const Vec<double>& b, Clip& clip) const;
  void walk(const Vec<double>& d, const Rings& rings, const SiteId* step, SiteId vertex,
            Clip& clip) const;
  const Operands* operands_ = nullptr;
  RoundingBounds bounds_;
};

/// Returns what is wrong with the convolution, or nothing. Each listed segment must be made exactly
/// once by the reduced rule, or with `full` by the full one. If not all are listed, their number
/// must be right.
[[nodiscard]] std::optional<std::string> check(const Convolution& convolution,
                                               const Operands& operands, bool full);

}  // namespace minksum
