#include "overlay/overlay.hpp"

#include <limits>

#include "overlay/subdivision.hpp"

namespace minksum::overlay {

namespace {

constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();

/// Returns a number that is far more than that of the segments' ends. So many touches mean that
/// many segments overlap on one line. So many crossings take longer than all the rest. On unions of
/// eleven files, 2 took up to 1.3 times as long as 8 where crossings remain, and 32 up to 2.5 times
/// where they do not.
std::size_t far_more(const Segments& segments) {
  constexpr std::size_t kMany = 8;
  return kMany * (segments.list.size() + 64);
}

/// Lists the contacts, or returns nothing if there are more crossings than that.
std::optional<Contacts> list_contacts(Segments& segments, std::size_t most_crossings) {
  constexpr std::size_t kMaxTouches = std::size_t{1} << 28U;
  Contacts contacts;
  if (find_contacts(segments, {far_more(segments), most_crossings}, contacts)) return contacts;
  if (contacts.crossings.size() > most_crossings) return std::nullopt;
  join_lines(segments);
  contacts = {};
  if (find_contacts(segments, {kMaxTouches, most_crossings}, contacts)) return contacts;
  if (contacts.crossings.size() > most_crossings) return std::nullopt;
  throw Error(ErrorCode::kLimitExceeded, "more than 2^28 touches of segments in one overlay");
}

std::optional<Geometry> select(std::span<const Chain> chains, const Rule& rule,
                               const Options& options, bool if_few_cross,
                               std::uint64_t* crossings) {
  Cancellation cancellation(options, Stage::kOverlay);
  cancellation.look();
  Segments segments = list_segments(chains, cancellation);
  Subdivision subdivision;
  {
    const auto contacts = list_contacts(segments, if_few_cross ? far_more(segments) : kNoLimit);
    if (!contacts) return std::nullopt;
    if (crossings != nullptr) *crossings = contacts->crossings.size();
    subdivision = subdivide(segments, *contacts);
  }
  cancellation.look();  // memory has been given back
  sweep(segments, rule, subdivision);
  std::optional<Geometry> result(std::in_place);
  extract_area(segments, subdivision, result->region);
  extract_thin(segments, subdivision, *result);
  cancellation.look();
  subdivision = {};
  cancellation.look();
  return result;
}

}  // namespace

Geometry select(std::span<const Chain> chains, const Rule& rule, const Options& options,
                std::uint64_t* crossings) {
  return *select(chains, rule, options, false, crossings);
}
std::optional<Geometry> select_if_few_cross(std::span<const Chain> chains, const Rule& rule,
                                            const Options& options) {
  return select(chains, rule, options, true, nullptr);
}

}  // namespace minksum::overlay
