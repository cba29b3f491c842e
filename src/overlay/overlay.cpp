#include "overlay/overlay.hpp"

#include "overlay/subdivision.hpp"

namespace minksum::overlay {

namespace {

// Lists the contacts. Far more touches than ends mean that many segments overlap on one line.
Contacts list_contacts(Segments& segments) {
  constexpr std::size_t kMany = 8;
  constexpr std::size_t kMaxTouches = std::size_t{1} << 28U;
  Contacts contacts;
  if (find_contacts(segments, kMany * (segments.list.size() + 64), contacts)) {
    return contacts;
  }
  join_lines(segments);
  contacts = {};
  if (!find_contacts(segments, kMaxTouches, contacts)) {
    throw Error(ErrorCode::kLimitExceeded, "more than 2^28 touches of segments in one overlay");
  }
  return contacts;
}

}  // namespace

Geometry select(std::span<const Chain> chains, const Rule& rule, const Options& options,
                std::uint64_t* crossings) {
  Cancellation cancellation(options, Stage::kOverlay);
  cancellation.look();
  Segments segments = list_segments(chains, cancellation);
  Subdivision subdivision = [&] {
    const Contacts contacts = list_contacts(segments);
    if (crossings != nullptr) *crossings = contacts.crossings.size();
    return subdivide(segments, contacts);
  }();
  cancellation.look();  // memory has been given back
  sweep(segments, rule, subdivision);
  Geometry result;
  extract_area(segments, subdivision, result.region);
  extract_thin(segments, subdivision, result);
  cancellation.look();
  subdivision = {};
  cancellation.look();
  return result;
}

}  // namespace minksum::overlay
