// The open inside of a polygon, and what gets into it: exact, edge by edge.
#pragma once

#include <vector>

#include "reference/exact.hpp"

namespace minksum::reference {

[[nodiscard]] Pt minus(const Pt& a, const Pt& b);

/// An exact point and doubles near it, which decide what they leave no doubt about.
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
  /// a + t(b − a).
  [[nodiscard]] Pt along(const Number& t) const;
};

/// A polygon whose inside is connected.
class OpenPolygon {
 public:
  explicit OpenPolygon(const Loops& loops);
  /// The same, of which a point strictly inside is known already.
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
  Span box_;  ///< from its smaller to its larger corner, up to what doubles tell
};

/// Appends those t in [0, 1], and maybe others, at which a + t(b − a) gets onto one of these spans,
/// off one, or past an end of one that it runs along. Between two of them nothing changes.
void add_meetings(const Span& span, const std::vector<Span>& others, std::vector<Number>& found);

/// One t from each gap between these, 0 and 1, in order.
[[nodiscard]] std::vector<Number> between_meetings(std::vector<Number> meetings);

/// Returns whether a point is inside of both.
[[nodiscard]] bool insides_meet(const OpenPolygon& a, const OpenPolygon& b);

}  // namespace minksum::reference
