// Where the segments of a small convolution meet.
#pragma once

#include "machine/vectors.hpp"
#include "sum/small/meeting_lists.hpp"
#include "sum/small/meeting_sets.hpp"

namespace minksum {

/// By such vectors, which the machine must have. False if there are too many, or finding them takes
/// too long: the stages are faster then.
template <class Number, class Meetings>
bool find_meetings_by(Vectors vectors, const SmallSegments& s, Meetings& m) {
  return with_vectors(
      vectors, [&]() __attribute__((always_inline)) { return find_meetings<Number>(s, m); });
}

}  // namespace minksum
