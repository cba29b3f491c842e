#include "reference/open_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "reference/membership.hpp"

namespace minksum::reference {
namespace {

/// Doubles near numbers are off by far less than this share of the largest number. A cross product
/// of their differences is off by far less than this share of that number's square.
constexpr double kDoubt = 1e-12;

double magnitude(const Spot& p) { return std::max(std::abs(p.x), std::abs(p.y)); }
double magnitude(const Span& s) { return std::max(magnitude(s.a), magnitude(s.b)); }

/// Returns 1 if a, b, c turn left, -1 if right, 0 if they lie in one line.
int turn(const Spot& a, const Spot& b, const Spot& c) {
  const double size = std::max({magnitude(a), magnitude(b), magnitude(c)});
  const double cross = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  if (std::abs(cross) > kDoubt * size * size + 1e-300) return cross < 0 ? -1 : 1;
  return turn(a.at, b.at, c.at);
}

/// Returns whether the boxes of two spans are certainly apart.
bool apart(const Span& s, const Span& t) {
  const double doubt = kDoubt * std::max(magnitude(s), magnitude(t));
  const auto beyond = [doubt](double a, double b, double c, double d) {
    return std::min(a, b) > std::max(c, d) + doubt || std::min(c, d) > std::max(a, b) + doubt;
  };
  return beyond(s.a.x, s.b.x, t.a.x, t.b.x) || beyond(s.a.y, s.b.y, t.a.y, t.b.y);
}

Number cross(const Pt& a, const Pt& b) { return a.x * b.y - a.y * b.x; }
Number dot(const Pt& a, const Pt& b) { return a.x * b.x + a.y * b.y; }

void add_meetings_with(const Span& span, const Span& other, std::vector<Number>& found) {
  const int c = turn(span.a, span.b, other.a);
  const int d = turn(span.a, span.b, other.b);
  if (c * d > 0) return;
  const Pt way = minus(span.b.at, span.a.at);
  if (c == 0 && d == 0) {
    for (const Spot* end : {&other.a, &other.b}) {
      found.push_back(dot(minus(end->at, span.a.at), way) / dot(way, way));
    }
    return;
  }
  if (turn(other.a, other.b, span.a) * turn(other.a, other.b, span.b) > 0) return;
  const Pt edge = minus(other.b.at, other.a.at);
  found.push_back(cross(minus(other.a.at, span.a.at), edge) / cross(way, edge));
}

std::vector<Span> edges_of(const Loops& loops) {
  std::vector<Span> edges;
  for (const Loop& loop : loops) {
    const Spot first(loop.back());
    Spot last = first;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      Spot next = i + 1 < loop.size() ? Spot(loop[i]) : first;
      edges.push_back({std::move(last), next});
      last = std::move(next);
    }
  }
  return edges;
}

Span box_of(const std::vector<Span>& edges) {
  Spot low = edges[0].a;
  Spot high = low;
  for (const Span& edge : edges) {
    low.x = std::min(low.x, edge.a.x);
    low.y = std::min(low.y, edge.a.y);
    high.x = std::max(high.x, edge.a.x);
    high.y = std::max(high.y, edge.a.y);
  }
  return {low, high};
}

}  // namespace

Pt minus(const Pt& a, const Pt& b) { return {Number(a.x - b.x), Number(a.y - b.y)}; }

Spot::Spot(Pt point)
    : at(std::move(point)), x(at.x.convert_to<double>()), y(at.y.convert_to<double>()) {}

Pt Span::along(const Number& t) const {
  return {Number(a.at.x + (b.at.x - a.at.x) * t), Number(a.at.y + (b.at.y - a.at.y) * t)};
}

OpenPolygon::OpenPolygon(const Loops& loops) : OpenPolygon(loops, point_strictly_inside(loops)) {}

OpenPolygon::OpenPolygon(const Loops& loops, Pt inner)
    : edges_(edges_of(loops)), inner_(std::move(inner)), box_(box_of(edges_)) {}

Side OpenPolygon::locate(const Spot& spot) const {
  bool inside = false;
  for (const auto& [a, b] : edges_) {
    const double doubt = kDoubt * std::max({magnitude(spot), magnitude(a), magnitude(b)});
    if (std::min(a.y, b.y) > spot.y + doubt || std::max(a.y, b.y) < spot.y - doubt ||
        std::max(a.x, b.x) < spot.x - doubt) {
      continue;
    }
    const int side = turn(a, b, spot);
    if (side == 0 && on_segment(spot.at, a.at, b.at)) return Side::kBoundary;
    // The ray goes to the right of the spot; an edge owns its lower end only.
    const bool a_below = a.at.y.compare(spot.at.y) <= 0;
    if (a_below == (b.at.y.compare(spot.at.y) <= 0)) continue;
    if (a_below ? side > 0 : side < 0) inside = !inside;
  }
  return inside ? Side::kInside : Side::kOutside;
}

bool OpenPolygon::is_entered_by(const Span& span) const {
  return !apart(span, box_) && meets(span, Side::kInside);
}

bool OpenPolygon::meets(const Span& span, Side side) const {
  std::vector<Number> meetings;
  add_meetings(span, edges_, meetings);
  const std::vector<Number> gaps = between_meetings(std::move(meetings));
  return std::any_of(gaps.begin(), gaps.end(),
                     [&](const Number& t) { return locate(Spot(span.along(t))) == side; });
}

void add_meetings(const Span& span, const std::vector<Span>& others, std::vector<Number>& found) {
  if (span.a.at == span.b.at) return;
  for (const Span& other : others) {
    if (!apart(span, other)) add_meetings_with(span, other, found);
  }
}

std::vector<Number> between_meetings(std::vector<Number> meetings) {
  meetings.emplace_back(0);
  meetings.emplace_back(1);
  std::erase_if(meetings, [](const Number& t) { return t.sign() < 0 || t.compare(1) > 0; });
  std::sort(meetings.begin(), meetings.end(),
            [](const Number& a, const Number& b) { return a.compare(b) < 0; });
  std::vector<Number> gaps;
  for (std::size_t i = 1; i < meetings.size(); ++i) {
    if (meetings[i] == meetings[i - 1]) continue;
    gaps.push_back((meetings[i] + meetings[i - 1]) / 2);
  }
  return gaps;
}

bool insides_meet(const OpenPolygon& a, const OpenPolygon& b) {
  // If the insides meet, the inside of a lies in b, or an edge of b enters the inside of a.
  if (b.locate(a.inner()) == Side::kInside) return true;
  return std::any_of(b.edges().begin(), b.edges().end(),
                     [&](const Span& edge) { return a.is_entered_by(edge); });
}

}  // namespace minksum::reference
