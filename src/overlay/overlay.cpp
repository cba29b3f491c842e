#include "overlay/overlay.hpp"

#include "overlay/subdivision.hpp"

namespace minksum::overlay {

Geometry select(std::span<const Chain> chains, Inside inside,
                const std::optional<CancelToken>& cancel) {
  Cancellation cancellation(cancel);
  cancellation.check_now();
  const Segments segments = list_segments(chains);
  Contacts contacts;
  find_contacts(segments, cancellation, contacts);
  Subdivision subdivision = subdivide(segments, contacts, cancellation);
  sweep(segments, inside, cancellation, subdivision);
  Geometry result;
  extract_area(segments, subdivision, result.region);
  extract_thin(segments, subdivision, result);
  return result;
}

}  // namespace minksum::overlay
