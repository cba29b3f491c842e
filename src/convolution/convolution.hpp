// Stage 2: the convolution segments: the sum's boundary is among them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "operands/operands.hpp"

namespace minksum {

/// Directed segments. The sum lies on the left of each; only its right side can be free.
struct Convolution {
  std::vector<Segment> segments;
};

/// The edges of one operand by direction: those of rank r are [first[r], first[r + 1]).
struct EdgesByRank {
  std::vector<SiteId> edges;
  std::vector<std::uint32_t> first;
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
void reduced_convolution(const Operands& operands, const Limits& limits,
                         ConvolutionScratch& scratch, Convolution& convolution);

/// The full convolution (Wein 2006, as CGAL has it): reflex vertices too, each with all directions
/// counter-clockwise from that of its incoming to that of its outgoing edge. O(n·m).
void full_convolution(const Operands& operands, const Limits& limits,
                      ConvolutionScratch& scratch, Convolution& convolution);

/// What the signed convolution (Guibas, Ramshaw, Stolfi 1983) has beyond the reduced one: each reflex
/// vertex with the edges in its small range, traversed backwards. Together they are closed.
void reflex_convolution(const Operands& operands, const Limits& limits,
                        ConvolutionScratch& scratch, Convolution& convolution);

/// Whether each segment is one that the reduced rule makes (exactly once), or with `full` the full
/// one; what is wrong, if not.
[[nodiscard]] std::optional<std::string> check(const Convolution& convolution,
                                               const Operands& operands, bool full);

}  // namespace minksum
