#include "io/drawing/flatten.hpp"

#include <algorithm>
#include <cmath>

#include "io/drawing/cuts.hpp"

namespace minksum::io {
namespace {

Interval cross(const Span& a, const Span& b) { return a.x * b.y - a.y * b.x; }
Interval dot(const Span& a, const Span& b) { return a.x * b.x + a.y * b.y; }

/// The ends of a cut, and the vertex of the polyline there.
struct Cut {
  Point left;
  Point right;
  Point vertex;
  double before = 0;  ///< the parameters before and behind the cut up to which pieces are tested
  double behind = 0;  ///< against one quadrilateral; what lies between is tested against both
};

/// A cut as seen from a point.
struct SeenCut {
  Span left, right, vertex;

  SeenCut(const Point& origin, const Cut& cut)
      : left(span_between(origin, cut.left)),
        right(span_between(origin, cut.right)),
        vertex(span_between(origin, cut.vertex)) {}
};

/// The corners of a quadrilateral from cut 0 to cut 1, and both vertices.
struct Quad {
  Span left0, right0, left1, right1, vertex0, vertex1;
  bool begins = false;  ///< whether the curve begins at cut 0, which then is a point
  bool ends = false;

  Quad(const SeenCut& a, const SeenCut& b, bool begins_here, bool ends_here)
      : left0(a.left),
        right0(a.right),
        left1(b.left),
        right1(b.right),
        vertex0(a.vertex),
        vertex1(b.vertex),
        begins(begins_here),
        ends(ends_here) {}

  /// The end of the curve is the origin, which is exact. So a point there is found on its lines.
  static bool is_left(const Span& from, const Span& to, const Span& p) {
    const bool ends_at_origin = to.x.is_zero() && to.y.is_zero();
    return cross(to - from, p - (ends_at_origin ? to : from)).low >= 0;
  }
  [[nodiscard]] bool holds_beside(const Span& p) const {
    return is_left(right0, right1, p) && is_left(left1, left0, p);
  }
  [[nodiscard]] bool is_behind_begin(const Span& p) const {
    return begins || is_left(left0, right0, p);
  }
  [[nodiscard]] bool is_before_end(const Span& p) const {
    return ends || is_left(right1, left1, p);
  }
  [[nodiscard]] bool holds(const Span& p) const {
    return holds_beside(p) && is_behind_begin(p) && is_before_end(p);
  }
  [[nodiscard]] bool is_convex() const {
    const auto turns_left = [](const Span& a, const Span& b, const Span& c) {
      return cross(b - a, c - b).low > 0;
    };
    return (begins || (turns_left(left0, right0, right1) && turns_left(left1, left0, right0))) &&
           (ends || (turns_left(right0, right1, left1) && turns_left(right1, left1, left0)));
  }
  /// Tells whether all of it is so close to the curve, which passes both cuts. Let x be any point
  /// of it. Either the line through x, at right angles to the polyline, parts the cuts and so meets
  /// the curve, or it meets a cut.
  [[nodiscard]] bool is_within(double tolerance, RoundingSide side) const {
    const Span along = vertex1 - vertex0;
    const Interval length = square_root(dot(along, along));
    Interval left, right, slant;
    const auto widen = [](Interval& bound, const Interval& value) {
      bound.high = std::max(bound.high, value.high);
    };
    for (const Span* const p : {&left0, &right0, &left1, &right1}) {
      const Interval across = cross(along, *p - vertex0);
      widen(left, across);
      widen(right, -across);
    }
    for (const Span* const p : {&left0, &right0}) {
      const Interval off = dot(along, *p - vertex0);
      widen(slant, off);
      widen(slant, -off);
    }
    for (const Span* const p : {&left1, &right1}) {
      const Interval off = dot(along, *p - vertex1);
      widen(slant, off);
      widen(slant, -off);
    }
    const double width =
        side == RoundingSide::kNearest ? std::max(left.high, right.high) : left.high + right.high;
    const Interval sum = Interval(width) + slant.high + slant.high;
    return ((sum * Interval::widened(1, 1)) / length).high <= tolerance;
  }
};

/// The pieces of one curve, with what holds them.
class Ribbon {
 public:
  Ribbon(const Curve& curve, double width, bool box_turns, double tolerance, RoundingSide side,
         const VertexGrid& grid, Cancellation& cancellation)
      : curve_(curve),
        grid_(grid),
        grid_view_(grid, curve.from),
        tolerance_(tolerance),
        side_(side),
        near_(middle_of(curve)),
        pieces_(cut(near_, width, width / 4, box_turns, cancellation)),
        cuts_(pieces_.size() + 1) {
    cuts_.front() = {curve.from, curve.from, curve.from, 0, 0};
    cuts_.back() = {curve.to, curve.to, curve.to, 1, 1};
    seen_.reserve(cuts_.size());
    seen_.emplace_back(curve.from, cuts_.front());
  }

  /// Tells whether the curve and its tolerance are proved. Places cuts and sets boxes on the way,
  /// so that none are placed in vain behind a piece that is not proved.
  [[nodiscard]] bool is_proved(Cancellation& cancellation) {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      cancellation.check(2000);
      if (i + 1 < pieces_.size()) place(i + 1);
      seen_.emplace_back(curve_.from, cuts_[i + 1]);
      if (!(pieces_[i].boxed ? box(i) : piece_is_held(i))) return false;
      if (i > 0 && !pieces_[i - 1].boxed && !pieces_[i].boxed && !cut_is_held(i)) return false;
    }
    return true;
  }

  void write(std::vector<Point>& path, Region& ribbons) const {
    for (std::size_t i = 1; i < cuts_.size(); ++i) path.push_back(cuts_[i].vertex);
    if (side_ == RoundingSide::kNearest) return;
    const auto begin = [&ribbons] {
      ribbons.begin_polygon();
      ribbons.begin_ring();
    };
    for (const auto& [low, high] : boxes_) {
      begin();
      ribbons.add_vertex(low.x, low.y);
      ribbons.add_vertex(high.x, low.y);
      ribbons.add_vertex(high.x, high.y);
      ribbons.add_vertex(low.x, high.y);
    }
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (pieces_[i].boxed) continue;
      const std::size_t first = i;
      while (i + 1 < pieces_.size() && !pieces_[i + 1].boxed) ++i;
      begin();
      for (std::size_t k = first; k <= i + 1; ++k) {
        ribbons.add_vertex(cuts_[k].right.x, cuts_[k].right.y);
      }
      for (std::size_t k = i + 2; k-- > first;) {
        if (cuts_[k].left == cuts_[k].right) continue;
        ribbons.add_vertex(cuts_[k].left.x, cuts_[k].left.y);
      }
    }
  }

 private:
  /// Sets cut i, between two pieces, at right angles to the curve.
  void place(std::size_t i) {
    const Piece& before = pieces_[i - 1];
    const Piece& behind = pieces_[i];
    const auto end = near_[before.part].between(before.begin, before.end).back();
    const auto x = end.x;
    const auto y = end.y;
    Vector<double> along{0, 0};
    double count = 0;
    for (const Piece* const piece : {&before, &behind}) {
      if (piece->boxed) continue;
      const Extent& extent = piece->extent;
      along.x += extent.chord.x / extent.length;
      along.y += extent.chord.y / extent.length;
      ++count;
    }
    const double step = grid_.size();
    Cut& cut = cuts_[i];
    cut.vertex = grid_view_.near(x, y);
    cut.left = cut.right = cut.vertex;
    if (count == 0) return;
    // Moved edges meet so much farther away than the edges are moved.
    const double square = along.x * along.x + along.y * along.y;
    const double factor = count / square;
    const Vector<double> across{-along.y * factor, along.x * factor};
    double right = 0, left = 0;
    for (const Piece* const piece : {&before, &behind}) {
      if (piece->boxed) continue;
      // Where the ribbon is a triangle, it must be wider if its cut is moved away from its tip.
      const Extent& extent = piece->extent;
      double away = 0;
      if (i == 1 && piece == &before) away = 1;
      if (i + 1 == pieces_.size() && piece == &behind) away = -1;
      away *= (across.x * extent.chord.x + across.y * extent.chord.y) / extent.length;
      const auto widened = [&](double width, double moved) {
        return width / std::max(1 - std::max(moved * width / extent.length, 0.0), 0.1);
      };
      right = std::max(right, widened(extent.right, -away));
      left = std::max(left, widened(extent.left, away));
    }
    // Ends are rounded by less than a step, and what lies beside the cut bends less than a step.
    const double margin = 2 * step;
    const auto at = [&](double width) {
      return grid_view_.near(x + width * across.x, y + width * across.y);
    };
    cut.right = at(-(right + margin));
    cut.left = at(left + margin);
    cut.vertex = side_ == RoundingSide::kNearest ? at((left - right) / 2) : cut.right;
    cut.before = before.boxed ? before.end : beside(before, false);
    cut.behind = behind.boxed ? behind.begin : beside(behind, true);
  }

  /// Returns the parameter of a piece that is some steps behind its begin, or before its end.
  [[nodiscard]] double beside(const Piece& piece, bool behind) const {
    const double length = piece.end - piece.begin;
    double size = std::min(2 * grid_.size() / piece.extent.length, 0.25) * length;
    for (; size < length / 4; size *= 2) {
      const double at = behind ? piece.begin + size : piece.end - size;
      const Bezier<double> rest = behind ? near_[piece.part].between(piece.begin, at)
                                         : near_[piece.part].between(at, piece.end);
      const auto [ax, ay] = rest.front();
      const auto [bx, by] = rest.back();
      if (std::hypot(bx - ax, by - ay) >= 1.5 * grid_.size()) break;
    }
    return behind ? piece.begin + size : piece.end - size;
  }

  [[nodiscard]] Quad quad(std::size_t i) const {
    return {seen_[i], seen_[i + 1], i == 0, i + 1 == pieces_.size()};
  }
  /// Returns the last one as seen from the end of the curve.
  [[nodiscard]] Quad last_quad() const {
    const std::size_t last = pieces_.size() - 1;
    return {SeenCut(curve_.to, cuts_[last]), SeenCut(curve_.to, cuts_[last + 1]), last == 0, true};
  }

  template <class Test>
  [[nodiscard]] static bool all_controls(const Bezier<Interval>& curve, Test test) {
    bool all = true;
    for_each_control(curve, [&](const Span& p) { all = all && test(p); });
    return all;
  }

  [[nodiscard]] bool piece_is_held(std::size_t i) const {
    const Piece& piece = pieces_[i];
    const bool last = i + 1 == pieces_.size();
    const Quad here = last ? last_quad() : quad(i);
    if (!here.is_convex() || !here.is_within(tolerance_, side_)) return false;
    const double begin = i == 0 ? piece.begin : cuts_[i].behind;
    const double end = last ? piece.end : cuts_[i + 1].before;
    if (!(begin < end)) return false;
    const Bezier<Interval> curve =
        last ? curve_.ending.between(0, 1 - begin) : curve_.parts[piece.part].between(begin, end);
    return all_controls(curve, [&](const Span& p) { return here.holds(p); });
  }

  [[nodiscard]] bool cut_is_held(std::size_t i) const {
    const Quad before = quad(i - 1);
    const Quad behind = quad(i);
    const auto test = [&](const Span& p) {
      return before.holds_beside(p) && behind.holds_beside(p) && before.is_behind_begin(p) &&
             behind.is_before_end(p);
    };
    return all_controls(before_cut(i), test) && all_controls(behind_cut(i), test);
  }
  [[nodiscard]] Bezier<Interval> before_cut(std::size_t i) const {
    const Piece& piece = pieces_[i - 1];
    return curve_.parts[piece.part].between(cuts_[i].before, piece.end);
  }
  [[nodiscard]] Bezier<Interval> behind_cut(std::size_t i) const {
    const Piece& piece = pieces_[i];
    return curve_.parts[piece.part].between(piece.begin, cuts_[i].behind);
  }

  /// Puts a box around a piece, both its cuts, and what lies beside them.
  [[nodiscard]] bool box(std::size_t i) {
    double low_x = 0, high_x = 0, low_y = 0, high_y = 0;
    bool begun = false;
    const auto take = [&](const Span& p) {
      low_x = begun ? std::min(low_x, p.x.low) : p.x.low;
      high_x = begun ? std::max(high_x, p.x.high) : p.x.high;
      low_y = begun ? std::min(low_y, p.y.low) : p.y.low;
      high_y = begun ? std::max(high_y, p.y.high) : p.y.high;
      begun = true;
    };
    const Piece& piece = pieces_[i];
    for_each_control(curve_.parts[piece.part].between(piece.begin, piece.end), take);
    if (i > 0 && !pieces_[i - 1].boxed) for_each_control(before_cut(i), take);
    if (i + 1 < pieces_.size() && !pieces_[i + 1].boxed) for_each_control(behind_cut(i + 1), take);
    for (const SeenCut* const cut : {&seen_[i], &seen_[i + 1]}) {
      for (const Span& p : {cut->left, cut->right, cut->vertex}) take(p);
    }
    const double step = grid_.size();
    const Point low = grid_view_.near(low_x - step, low_y - step);
    const Point high = grid_view_.near(high_x + step, high_y + step);
    boxes_.emplace_back(low, high);
    const Rational width = high.x - low.x;
    const Rational height = high.y - low.y;
    return width * width + height * height <= Rational(tolerance_) * Rational(tolerance_);
  }

  const Curve& curve_;
  const VertexGrid& grid_;
  GridView grid_view_;
  double tolerance_;
  RoundingSide side_;
  DoubleCurve near_;
  std::vector<Piece> pieces_;
  std::vector<Cut> cuts_;
  std::vector<SeenCut> seen_;  ///< from the curve's begin
  std::vector<std::pair<Point, Point>> boxes_;
};

}  // namespace

Flattener::Flattener(const Rational& tolerance, RoundingSide side)
    : tolerance_(std::max(Interval::of(tolerance).low, 0.0)), side_(side), grid_(tolerance) {}

void Flattener::flatten(const Curve& curve, std::vector<Point>& path, Region& ribbons,
                        Cancellation& cancellation) const {
  // A proof needs some thousand roundings' room beside the coordinates.
  double size = 0;
  for (const Bezier<Interval>& part : curve.parts) {
    for (std::size_t i = 0; i < part.size(); ++i) {
      const auto [x, y] = part.at(i);
      size = std::max({size, std::abs(x.low), std::abs(x.high), std::abs(y.low), std::abs(y.high)});
    }
  }
  if (!(tolerance_ > 1e-10 * size && size < 1e100)) fail_too_small_tolerance();
  // Nine steps are for rounding. If a proof fails, the curve is cut into more pieces. Turns as
  // sharp as that of a hairpin may need pieces much narrower than the tolerance, or else boxes,
  // which add vertices. Cuts are wider than pieces by four steps, so pieces of fewer than six would
  // hardly make narrower cuts.
  const double widest = (side_ == RoundingSide::kNearest ? 2 : 1) * tolerance_ - 9 * grid_.size();
  for (const bool box_turns : {false, true}) {
    for (double width = widest; width > 6 * grid_.size(); width *= 0.8) {
      Ribbon ribbon(curve, width, box_turns, tolerance_, side_, grid_, cancellation);
      if (ribbon.is_proved(cancellation)) return ribbon.write(path, ribbons);
    }
  }
  fail_too_small_tolerance();
}

}  // namespace minksum::io
