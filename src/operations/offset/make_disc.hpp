// Makes polygons for discs, and can be cancelled.
#pragma once

#include "machine/cancellation.hpp"
#include "minksum/offset.hpp"

namespace minksum {

/// Returns what `disc` returns.
[[nodiscard]] Region make_disc(const Rational& radius, const Rational& tolerance, RoundingSide side,
                               Cancellation& cancellation);

}  // namespace minksum
