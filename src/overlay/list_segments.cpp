// Turns chains into distinct points and distinct segments.
#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>

#include "machine/make_room.hpp"
#include "overlay/subdivision.hpp"

namespace minksum::overlay {
namespace {

/// Lists all vertices of all chains, one after the other.
std::vector<Source> list_sources(std::span<const Chain> chains) {
  std::size_t count = 0;
  for (const Chain& chain : chains) count += chain.end - chain.begin;
  if (count > std::numeric_limits<std::uint32_t>::max() / 4) {
    throw Error(ErrorCode::kLimitExceeded, "more than 2^30 vertices in one overlay");
  }
  std::vector<Source> sources;
  sources.reserve(count);
  for (const Chain& chain : chains) {
    for (std::size_t v = chain.begin; v < chain.end; ++v) sources.push_back({chain.region, v});
  }
  return sources;
}

/// Sorts the points and keeps one of equal points. Returns the number of each vertex's point.
std::vector<PointId> merge_points(std::vector<Source> sources, Segments& segments) {
  std::vector<PointId> order(sources.size());
  std::iota(order.begin(), order.end(), 0U);
  const Predicates& predicates = segments.predicates;
  const auto before = [&](PointId a, PointId b) {
    return a != b && predicates.compare(a, b) == kNegative;
  };
  std::sort(order.begin(), order.end(), segments.cancellation().counting(before));
  std::vector<PointId> point_of(sources.size());
  std::vector<PointId> distinct;
  for (const PointId p : order) {
    segments.cancellation().check();
    if (distinct.empty() || predicates.compare(distinct.back(), p) != kZero) {
      append(distinct, p, segments.cancellation());
      append(segments.sources, sources[p], segments.cancellation());
    }
    point_of[p] = static_cast<PointId>(distinct.size() - 1);
  }
  segments.predicates.pick(distinct);
  return point_of;
}

Winding directed_weight(const Chain& chain, std::span<const PointId> points,
                        const Predicates& predicates) {
  if (!chain.closed || chain.direction == Chain::Direction::kAsGiven) return chain.weight;
  const Sign sign = predicates.area_sign(points);
  const bool reversed = chain.direction == Chain::Direction::kCounterClockwise ? sign == kNegative
                                                                               : sign == kPositive;
  return reversed ? -chain.weight : chain.weight;
}

void merge_segments(std::vector<Segment>& list, Cancellation& cancellation) {
  std::sort(list.begin(), list.end(), cancellation.counting([](const Segment& a, const Segment& b) {
    return a.ends.low != b.ends.low ? a.ends.low < b.ends.low : a.ends.high < b.ends.high;
  }));
  const auto same = cancellation.counting([](const Segment& a, const Segment& b) {
    return a.ends.low == b.ends.low && a.ends.high == b.ends.high;
  });
  list.erase(merge_equal(list.begin(), list.end(), same), list.end());
}

}  // namespace

Segments list_segments(std::span<const Chain> chains, Cancellation& cancellation) {
  Segments segments;
  std::vector<Source> sources = list_sources(chains);
  cancellation.check(chains.size() + sources.size());
  LoadedPoints loaded = load_points(sources, cancellation);
  segments.predicates =
      Predicates(std::move(loaded.points), sources.size(), loaded.work, cancellation);
  const std::vector<PointId> point_of = merge_points(std::move(sources), segments);
  segments.belongs.assign(segments.sources.size(), 0);
  std::size_t first = 0;
  for (const Chain& chain : chains) {
    const auto points = std::span(point_of).subspan(first, chain.end - chain.begin);
    first += points.size();
    cancellation.check(1 + points.size());
    if (points.empty()) continue;
    const auto is_first = [&](PointId p) { return p == points[0]; };
    if (chain.belongs && std::all_of(points.begin(), points.end(), is_first)) {
      segments.belongs[points[0]] = 1;
    }
    const Winding weight = directed_weight(chain, points, segments.predicates);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool last = i + 1 == points.size();
      if (last && !chain.closed) break;
      const PointId a = points[i];
      const PointId b = points[last ? 0 : i + 1];
      const auto add = [&](const Ends& ends, const Winding& change) {
        append(segments.list, {{change, chain.belongs, chain.spared}, ends}, cancellation);
      };
      if (a < b) add({a, b}, weight);
      if (b < a) add({b, a}, -weight);
    }
  }
  merge_segments(segments.list, cancellation);
  return segments;
}

}  // namespace minksum::overlay
