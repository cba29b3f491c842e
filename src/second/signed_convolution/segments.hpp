// Step 2 of the signed method: lists pairs of loops and their signed convolutions, by indices
// alone.
//
// The source is Guibas, Ramshaw, Stolfi, "A kinetic framework for computational geometry", FOCS
// 1983.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "machine/cancellation.hpp"
#include "minksum/testing.hpp"
#include "second/signed_convolution/operands.hpp"

namespace minksum::signed_sum {

/// Index of a Layer.
using LayerId = std::uint32_t;
/// Index of a pair of parts, one of each operand.
using PairId = std::uint32_t;

/// A pair of loops whose convolution has winding numbers of its own.
///
/// For two outer rings, the winding number at x is positive if and only if x is in the sum of the
/// filled parts. For a hole and the other part's outer ring, it is -1 if and only if the filled
/// part fits into the hole at x. Then x is not in the sum. Only holes wider and higher than the
/// other part have a layer.
struct Layer {
  PairId pair = 0;
  bool is_hole = false;
  const IntegerRing* p = nullptr;
  const IntegerRing* q = nullptr;
};

/// An edge of one loop, moved by a vertex of the other, that counts `multiplicity` times in the
/// edge's direction.
struct SignedSegment {
  LayerId layer = 0;
  std::uint32_t p_index = 0;  ///< edge of p if edge_of_p, otherwise vertex of p
  std::uint32_t q_index = 0;
  bool edge_of_p = false;
  std::int8_t multiplicity = 0;
};

[[nodiscard]] std::vector<Layer> make_layers(const IntegerOperands& operands,
                                             Cancellation& cancellation);

/// Returns the signed convolutions of all layers, layer after layer.
[[nodiscard]] std::vector<SignedSegment> signed_segments(const IntegerOperands& operands,
                                                         std::span<const Layer> layers,
                                                         const SumSettings& options,
                                                         Cancellation& cancellation);

/// Tells whether the segments form closed cycles in every layer: at each pair of vertices, as many
/// come in as go out. The half-open rules for parallel edges must achieve this.
[[nodiscard]] bool is_closed(std::span<const Layer> layers, std::span<const SignedSegment> segments,
                             Cancellation& cancellation);

}  // namespace minksum::signed_sum
