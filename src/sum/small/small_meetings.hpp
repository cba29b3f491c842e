// Finds the meetings of the segments of a small convolution.
#pragma once

#include "machine/vectors.hpp"
#include "sum/small/meeting_lists.hpp"
#include "sum/small/meeting_sets.hpp"

namespace minksum {

/// Finds meetings by such vectors, which the machine must have. Returns false if there are too many
/// meetings, or if finding them takes too long: the stages are faster then.
template <class Number, class Meetings>
bool find_meetings_by(Vectors vectors, const SmallSegments& s, Meetings& m) {
  return with_vectors(
      vectors, [&]() __attribute__((always_inline)) { return find_meetings<Number>(s, m); });
}

}  // namespace minksum
