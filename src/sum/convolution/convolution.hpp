// Stage 2: the convolution segments: the sum's boundary is among them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sum/operands/operands.hpp"

namespace minksum {

/// Directed segments. The sum lies on the left of each; only its right side can be free. Where
/// there are many they are only counted: most are inside the sum, and need never be listed.
struct Convolution {
  std::vector<Segment> segments;  ///< all, if `listed()`; else of each `step` in turn one
  std::uint64_t size = 0;         ///< how many there are
  std::uint64_t step = 1;
  [[nodiscard]] bool listed() const { return step == 1; }
};

/// The edges of one operand by direction: those of rank r are [first[r], first[r + 1]).
struct EdgesByRank {
  std::vector<SiteId> edges;
  std::vector<std::uint32_t> first;
};

/// Ranks of directions, counter-clockwise: `length` of them, from `from` on.
struct RankRange {
  DirectionRank from;
  DirectionRank length;
};

/// Memory for the stage.
struct ConvolutionScratch {
  EdgesByRank all;
  EdgesByRank outer;  ///< without those of holes
};

/// The reduced convolution (Behar and Lien, section IV-A): each convex vertex with the edges of the
/// other operand whose directions lie between those of its two edges. Vertices of the first operand
/// own the half-open range [in, out), those of the second (in, out]: then of two parallel edges
/// each is moved by one end of the other, and nothing is lost or doubled. A hole never meets a
/// hole. Between two thin operands parallel edges by themselves sweep no area, which is all that is
/// wanted here: an edge is listed where the other walk turns to its left, that is, at vertices with
/// [in, out] and at ends, where the walk turns back, with (in, out). O(n + m + k).
void reduced_convolution(const Operands& operands, const Limits& limits, Cancellation& cancellation,
                         ConvolutionScratch& scratch, Convolution& convolution);

/// The same; but if there are more than `many`, only a sample of `kSample` to twice as many (if so
/// many there are) is listed. O(n + m + min(k, many)).
void reduced_convolution_or_sample(const Operands& operands, const Limits& limits,
                                   std::uint64_t many, Cancellation& cancellation,
                                   ConvolutionScratch& scratch, Convolution& convolution);
inline constexpr std::size_t kSample = 256;

/// The directions of the edges that meet a convex vertex in the reduced convolution.
[[nodiscard]] RankRange reduced_range(const Operands& operands, SiteId vertex);

/// The full convolution (Wein 2006, as CGAL has it): reflex vertices too, each with all directions
/// counter-clockwise from that of its incoming to that of its outgoing edge. O(n·m).
void full_convolution(const Operands& operands, const Limits& limits, Cancellation& cancellation,
                      ConvolutionScratch& scratch, Convolution& convolution);

/// What the signed convolution (Guibas, Ramshaw, Stolfi 1983) has beyond the reduced one: each
/// reflex vertex with the edges in its small range, traversed backwards. Together they are closed.
void reflex_convolution(const Operands& operands, const Limits& limits, Cancellation& cancellation,
                        ConvolutionScratch& scratch, Convolution& convolution);

/// Whether each segment is one that the reduced rule makes (exactly once), or with `full` the full
/// one, and if not all are listed, whether their number is right. What is wrong, if not.
[[nodiscard]] std::optional<std::string> check(const Convolution& convolution,
                                               const Operands& operands, bool full);

}  // namespace minksum
