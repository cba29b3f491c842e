// Finds exactly, edge by edge, what gets into the open inside of a polygon.
#pragma once

#include <vector>

#include "reference/exact.hpp"

namespace minksum::reference {

[[nodiscard]] Pt minus(const Pt& a, const Pt& b);

/// An exact point with doubles near it, which decide wherever they leave no doubt.
struct Spot {
  explicit Spot(Pt point);
  Pt at;
  double x;
  double y;
};

/// A closed segment; a point if both ends are equal.
struct Span {
  Spot a;
  Spot b;
  /// Returns a + t(b − a).
  [[nodiscard]] Pt along(const Number& t) const;
};

/// A polygon whose inside is connected.
class OpenPolygon {
 public:
  explicit OpenPolygon(const Loops& loops);
  /// Does the same if a point strictly inside is known already.
  OpenPolygon(const Loops& loops, Pt inner);

  [[nodiscard]] const std::vector<Span>& edges() const { return edges_; }
  [[nodiscard]] const Spot& inner() const { return inner_; }
  [[nodiscard]] Side locate(const Spot& spot) const;
  /// Returns whether some point of the span is inside.
  [[nodiscard]] bool is_entered_by(const Span& span) const;
  /// Returns whether no point of the span is outside.
  [[nodiscard]] bool holds(const Span& span) const { return !meets(span, Side::kOutside); }

 private:
  /// Returns whether some point of the span is on this side, which is not the boundary.
  [[nodiscard]] bool meets(const Span& span, Side side) const;

  std::vector<Span> edges_;
  Spot inner_;
  Span box_;  ///< from the smaller to the larger corner, as doubles tell
};

/// Appends all t in [0, 1] at which a + t(b − a) reaches or leaves another span, or passes an end
/// of one along which it runs. Nothing changes between two such t. More t may be appended.
void add_meetings(const Span& span, const std::vector<Span>& others, std::vector<Number>& found);

/// Returns one t from each gap between the meetings, 0 and 1, in order.
[[nodiscard]] std::vector<Number> between_meetings(std::vector<Number> meetings);

/// Returns whether some point is inside both polygons.
[[nodiscard]] bool insides_meet(const OpenPolygon& a, const OpenPolygon& b);

}  // namespace minksum::reference
