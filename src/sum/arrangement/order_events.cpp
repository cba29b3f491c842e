#include "sum/arrangement/order_events.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "machine/share_by_key.hpp"

namespace minksum {
namespace {

class EventOrder {
 public:
  EventOrder(Predicates& predicates, ArrangementScratch& scratch, const Arrangement& arrangement)
      : predicates_(predicates),
        cancellation_(predicates.cancellation()),
        scratch_(scratch),
        arrangement_(arrangement),
        points_(predicates, scratch, arrangement) {}

  /// Groups events by segment.
  void group() {
    std::size_t events = 0;
    for (const Meetings& part : scratch_.meetings) events += part.events.size();
    limit_events(events);
    const auto& parts = scratch_.meetings;
    share_by_key(
        arrangement_.kept.size(),
        parts.size(), [&](std::size_t i) -> const auto& { return parts[i].events; },
        [&](std::size_t i, Event event) {
          if (event.point >= points_.ends()) event.point += parts[i].before;
          return std::pair(event.segment, event);
        },
        cancellation_, scratch_.event_begin, scratch_.sorted_events);
  }

  /// Orders the events on each segment. Threads order those that doubles tell apart, on most
  /// segments. The order of the others, and the decisions that it takes, depend on which points are
  /// known to be equal. Each segment may show more equal points, so the calling thread orders these
  /// segments one by one.
  void order() {
    constexpr std::uint64_t kUnitsOfEvent = 8;
    const std::size_t lines = scratch_.line_count;
    const std::uint64_t units = kUnitsOfEvent * scratch_.sorted_events.size();
    auto& done = scratch_.ordered;
    if (tasks_for(units, cancellation_) == 1) {
      in_pieces(lines, cancellation_, [&](std::size_t begin, std::size_t end) {
        for (std::size_t s = begin; s < end; ++s) order(static_cast<KeptId>(s), Ordered::kNot);
      });
      return;
    }
    resize_in_pieces(done, lines, cancellation_);
    share_each(lines, units / (lines + 1) + 1, cancellation_,
               [&](std::size_t s, Cancellation& own) {
                 done[s] = order_if_clear(static_cast<KeptId>(s), own);
               });
    in_pieces(lines, cancellation_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t s = begin; s < end; ++s) {
        if (done[s] != Ordered::kWholly) order(static_cast<KeptId>(s), done[s]);
      }
    });
  }

 private:
  using Ordered = ArrangementScratch::Ordered;
  static constexpr std::size_t kFew = 12;
  /// Bisection of a list of kFew events takes this many comparisons.
  static constexpr std::size_t kNear = 4;
  static constexpr std::size_t kMany = 4096;

  /// Throws if there are too many events. Each piece ends at an event or at its segment's end, so
  /// the number of pieces is bounded too.
  void limit_events(std::size_t events) const {
    if (events + scratch_.line_count < kNoPiece) return;
    throw Error(ErrorCode::kLimitExceeded, "segments meet at 2^32 places or more");
  }
  /// Whether two points on s are certainly equal: they are known to be, or one line crosses s at
  /// both.
  bool same(KeptId s, std::uint32_t a, std::uint32_t b) {
    if (find_root(scratch_.parent, a) == find_root(scratch_.parent, b)) return true;
    if (a < points_.ends() || b < points_.ends()) return false;
    return find_root(scratch_.line_parent, points_.other(s, a)) ==
           find_root(scratch_.line_parent, points_.other(s, b));
  }
  Sign compare(KeptId s, const Event& a, const Event& b) {
    if (std::abs(a.lambda - b.lambda) > a.error + b.error) return sign_of(a.lambda - b.lambda);
    if (same(s, a.point, b.point)) return kZero;
    return predicates_.compare_along(arrangement_.kept[s].segment, a.lambda, a.error,
                                     points_.on(s, a.point), b.lambda, b.error,
                                     points_.on(s, b.point));
  }

  static void sort_roughly(std::span<Event> events, Cancellation& cancellation) {
    const auto before = [](const Event& a, const Event& b) { return a.lambda < b.lambda; };
    if (events.size() > kMany) {
      std::sort(events.begin(), events.end(), cancellation.counting(before));
    } else {
      std::sort(events.begin(), events.end(), before);
    }
  }
  /// Sorts the events on s, and unites equal ones. Rounded positions bring events almost into
  /// order. Insertion then costs about one exact comparison each, and meets all equal neighbours.
  /// Where an event is not near its place, bisection finds it.
  void order(KeptId s, Ordered ordered) {
    const std::span<Event> events = scratch_.events_of(s);
    if (events.size() < 2) return;
    cancellation_.check(4 * events.size());
    if (events.size() > kFew && ordered == Ordered::kNot) sort_roughly(events, cancellation_);
    for (std::size_t i = 1; i < events.size(); ++i) {
      const Event event = events[i];
      const auto follows = [&](std::size_t j) { return compare(s, events[j], event); };
      std::size_t place = i;
      Sign order = kNegative;
      while (place > 0 && i - place < kNear && (order = follows(place - 1)) == kPositive) --place;
      if (order == kPositive && place > 0) {
        const auto after = std::partition_point(
            events.begin(), events.begin() + static_cast<std::ptrdiff_t>(place),
            [&](const Event& e) { return compare(s, e, event) != kPositive; });
        place = static_cast<std::size_t>(after - events.begin());
        order = place > 0 ? follows(place - 1) : kNegative;
      }
      const std::span moved = events.subspan(place, i - place);
      std::copy_backward(moved.begin(), moved.end(), events.subspan(0, i + 1).end());
      events[place] = event;
      if (order == kZero) unite(scratch_.parent, events[place - 1].point, event.point);
    }
  }
  /// Orders the events on s if rounded positions tell all of them apart. Otherwise few events stay
  /// as they are, and many are sorted roughly.
  [[nodiscard]] Ordered order_if_clear(KeptId s, Cancellation& cancellation) const {
    const std::span<Event> events = scratch_.events_of(s);
    if (events.size() < 2) return Ordered::kWholly;
    cancellation.check(4 * events.size());
    const auto are_near = [](const Event& a, const Event& b) {
      return !(b.lambda - a.lambda > a.error + b.error);
    };
    if (events.size() > kFew) {
      sort_roughly(events, cancellation);
      return std::ranges::adjacent_find(events, are_near) == events.end() ? Ordered::kWholly
                                                                          : Ordered::kRoughly;
    }
    std::array<Event, kFew> copy;
    const std::span sorted(copy.data(), events.size());
    std::ranges::copy(events, sorted.begin());
    sort_roughly(sorted, cancellation);
    if (std::ranges::adjacent_find(sorted, are_near) != sorted.end()) return Ordered::kNot;
    std::ranges::copy(sorted, events.begin());
    return Ordered::kWholly;
  }

  Predicates& predicates_;
  Cancellation& cancellation_;
  ArrangementScratch& scratch_;
  const Arrangement& arrangement_;
  SharedPoints points_;
};

}  // namespace

void order_events(Predicates& predicates, ArrangementScratch& scratch,
                  const Arrangement& arrangement) {
  EventOrder events(predicates, scratch, arrangement);
  events.group();
  events.order();
}

}  // namespace minksum
