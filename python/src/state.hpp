// Declares the exact form of geometries as bytes, for pickles and caches.
#pragma once

#include <string>
#include <string_view>

#include "shape.hpp"

namespace minksum::python {

/// Returns a geometry as bytes. The form has the letters "MKS", the version 1, the number of the
/// reference system, and then the parts. Counts are varints of 7 bits a byte, the low ones first. A
/// number is the count of its numerator's bytes, doubled, plus 1 if it is negative; these bytes,
/// the low ones first; and the same for its denominator, which has no byte if it is 1. Origins of
/// edges are not kept.
[[nodiscard]] std::string state_of(const Shape& shape);
/// Reads such bytes. Throws Error(kBadInput), which names the byte, for any other.
[[nodiscard]] Shape shape_from_state(std::string_view bytes);

}  // namespace minksum::python
