// Where the segments of a small convolution meet.
#pragma once

#include "machine/vectors.hpp"
#include "sum/small/meeting_lists.hpp"
#include "sum/small/meeting_sets.hpp"
#include "sum/small/meetings_avx512.hpp"

namespace minksum {

/// By such vectors, which the machine must have. False if there are too many, or finding them takes
/// too long: the stages are faster then.
template <class Number, class Meetings>
bool find_meetings_by(Vectors vectors, const SmallSegments& s, Meetings& m) {
#ifdef MINKSUM_HAS_AVX512
  if constexpr (std::is_same_v<Meetings, SmallMeetingSets>) {
    if (vectors == Vectors::kAvx512) return find_meetings_by_avx512<Number>(s, m);
  }
#endif
  return with_vectors(
      vectors, [&]() __attribute__((always_inline)) { return find_meetings<Number>(s, m); });
}

}  // namespace minksum
