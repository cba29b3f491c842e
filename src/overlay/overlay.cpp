#include "overlay/overlay.hpp"

#include "overlay/subdivision.hpp"

namespace minksum::overlay {

namespace {

// Far more touches than ends: many segments overlap on one line.
Contacts list_contacts(Segments& segments, Cancellation& cancellation) {
  constexpr std::size_t kMany = 8;
  constexpr std::size_t kMaxTouches = std::size_t{1} << 28U;
  Contacts contacts;
  if (find_contacts(segments, kMany * (segments.list.size() + 64), cancellation, contacts)) {
    return contacts;
  }
  join_lines(segments);
  contacts = {};
  if (!find_contacts(segments, kMaxTouches, cancellation, contacts)) {
    throw Error(ErrorCode::kLimitExceeded, "more than 2^28 touches of segments in one overlay");
  }
  return contacts;
}

}  // namespace

Geometry select(std::span<const Chain> chains, const Rule& rule,
                const std::optional<CancelToken>& cancel) {
  Cancellation cancellation(cancel);
  cancellation.check_now();
  Segments segments = list_segments(chains);
  const Contacts contacts = list_contacts(segments, cancellation);
  Subdivision subdivision = subdivide(segments, contacts, cancellation);
  sweep(segments, rule, cancellation, subdivision);
  Geometry result;
  extract_area(segments, subdivision, result.region);
  extract_thin(segments, subdivision, result);
  return result;
}

}  // namespace minksum::overlay
