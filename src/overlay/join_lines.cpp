// Turns segments that overlap on one line into segments that do not.
#include <algorithm>

#include "overlay/subdivision.hpp"

namespace minksum::overlay {
namespace {

/// The change at a point of a line where one segment starts or ends.
struct LineEnd {
  PointId at = 0;
  Winding change;
  int belongs = 0;
  std::int32_t spared = 0;
};

/// Cuts the segments of one line at all of their ends, and adds up those of equal ends. Points of a
/// line are in order if their numbers are.
void join(std::span<const Segment> line, Cancellation& cancellation, std::vector<Segment>& joined) {
  std::vector<LineEnd> steps;
  for (const Segment& s : line) {
    steps.push_back({s.ends.low, s.change, s.belongs ? 1 : 0, s.spared});
    steps.push_back({s.ends.high, -s.change, s.belongs ? -1 : 0, -s.spared});
  }
  std::sort(steps.begin(), steps.end(),
            cancellation.counting([](const LineEnd& a, const LineEnd& b) { return a.at < b.at; }));
  LineEnd now = steps.front();
  for (std::size_t i = 1; i < steps.size(); ++i) {
    const LineEnd& step = steps[i];
    const Segment part{{now.change, now.belongs > 0, now.spared}, {now.at, step.at}};
    if (step.at != now.at && !part.idle()) joined.push_back(part);
    now = {step.at, now.change + step.change, now.belongs + step.belongs, now.spared + step.spared};
  }
}

}  // namespace

void join_lines(Segments& segments) {
  Cancellation& cancellation = segments.cancellation();
  std::vector<std::pair<ExactPoints::Line, Segment>> keyed;
  keyed.reserve(segments.list.size());
  for (const Segment& s : segments.list) {
    cancellation.check(32);
    keyed.emplace_back(segments.predicates.exact().line(s.ends), s);
  }
  std::sort(keyed.begin(), keyed.end(),
            cancellation.counting([](const auto& a, const auto& b) { return a.first < b.first; }));
  segments.list.clear();
  std::vector<Segment> line;
  for (std::size_t i = 0; i < keyed.size(); ++i) {
    cancellation.check(4);
    line.push_back(keyed[i].second);
    if (i + 1 < keyed.size() && keyed[i + 1].first == keyed[i].first) continue;
    join(line, cancellation, segments.list);
    line.clear();
  }
}

}  // namespace minksum::overlay
