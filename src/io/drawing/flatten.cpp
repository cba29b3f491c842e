#include "io/drawing/flatten.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "io/drawing/cuts.hpp"

namespace minksum::io {
namespace {

Interval cross(const Span& a, const Span& b) { return a.x * b.y - a.y * b.x; }
Interval dot(const Span& a, const Span& b) { return a.x * b.x + a.y * b.y; }

/// The ends of a cut between pieces, and the vertex of the polyline there.
struct Cut {
  GridPoint left;
  GridPoint right;
  GridPoint vertex;
  double before = 0;  ///< the parameters before and behind the cut up to which pieces are tested
  double behind = 0;  ///< against one quadrilateral; what lies between is tested against both
};

/// A cut as seen from a point. An end of the curve is a cut, too, which is a point.
struct SeenCut {
  Span left, right, vertex;

  explicit SeenCut(const Span& end) : left(end), right(end), vertex(end) {}
  SeenCut(const GridView& view, const Cut& cut)
      : left(view.span_to(cut.left)),
        right(view.span_to(cut.right)),
        vertex(view.span_to(cut.vertex)) {}
};

/// A side of a quadrilateral.
struct Side {
  Span along;
  Span on;  ///< a point on it

  /// The end of the curve is the origin, which is exact. So a point there is found on its lines.
  Side(const Span& from, const Span& to)
      : along(to - from), on(to.x.is_zero() && to.y.is_zero() ? to : from) {}

  [[nodiscard]] bool has_left(const Span& p) const { return cross(along, p - on).low >= 0; }
  [[nodiscard]] bool turns_left_to(const Side& next) const {
    return cross(along, next.along).low > 0;
  }
};

/// The quadrilateral from one cut to the next one.
class Quad {
 public:
  Quad(const SeenCut& from, const SeenCut& to, bool begins, bool ends)
      : from_(from),
        to_(to),
        right_(from.right, to.right),
        left_(to.left, from.left),
        begin_(from.left, from.right),
        end_(to.right, to.left),
        begins_(begins),
        ends_(ends) {}

  [[nodiscard]] bool holds_beside(const Span& p) const {
    return right_.has_left(p) && left_.has_left(p);
  }
  [[nodiscard]] bool is_behind_begin(const Span& p) const { return begins_ || begin_.has_left(p); }
  [[nodiscard]] bool is_before_end(const Span& p) const { return ends_ || end_.has_left(p); }
  [[nodiscard]] bool holds(const Span& p) const {
    return holds_beside(p) && is_behind_begin(p) && is_before_end(p);
  }
  [[nodiscard]] bool is_convex() const {
    return (begins_ || (begin_.turns_left_to(right_) && left_.turns_left_to(begin_))) &&
           (ends_ || (right_.turns_left_to(end_) && end_.turns_left_to(left_)));
  }
  /// Tells whether all of it is so close to the curve, which passes both cuts. Let x be any point
  /// of it. Either the line through x, at right angles to the polyline, parts the cuts and so meets
  /// the curve, or it meets a cut.
  [[nodiscard]] bool is_within(double tolerance, RoundingSide side) const {
    const Span along = to_.vertex - from_.vertex;
    const Interval length = square_root(dot(along, along));
    Interval left, right, slant;
    const auto widen = [](Interval& bound, const Interval& value) {
      bound.high = std::max(bound.high, value.high);
    };
    for (const SeenCut* const cut : {&from_, &to_}) {
      for (const Span* const p : {&cut->left, &cut->right}) {
        const Interval across = cross(along, *p - from_.vertex);
        widen(left, across);
        widen(right, -across);
        const Interval off = dot(along, *p - cut->vertex);
        widen(slant, off);
        widen(slant, -off);
      }
    }
    const double width =
        side == RoundingSide::kNearest ? std::max(left.high, right.high) : left.high + right.high;
    const Interval sum = Interval(width) + slant.high + slant.high;
    return ((sum * Interval::widened(1, 1)) / length).high <= tolerance;
  }

 private:
  SeenCut from_;
  SeenCut to_;
  Side right_, left_, begin_, end_;
  bool begins_;  ///< whether the curve begins at the first cut, which then is a point
  bool ends_;
};

void add_box(const VertexGrid& grid, const GridBox& box, Region& ribbons) {
  const Point low = grid.at(box.low);
  const Point high = grid.at(box.high);
  ribbons.begin_polygon();
  ribbons.begin_ring();
  ribbons.add_vertex(low.x, low.y);
  ribbons.add_vertex(high.x, low.y);
  ribbons.add_vertex(high.x, high.y);
  ribbons.add_vertex(low.x, high.y);
}

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
        // Quadrilaterals have margins of two steps at each side, so none is proved for a few steps.
        pieces_(cut(near_, {width, width / 4, 16 * grid.size()}, box_turns, cancellation)),
        cuts_(pieces_.size()) {
    seen_.reserve(pieces_.size() + 1);
    seen_.emplace_back(Span{});
  }

  /// Tells whether the curve and its tolerance are proved. Places cuts and sets boxes on the way,
  /// so that none are placed in vain behind a piece that is not proved.
  [[nodiscard]] bool is_proved(Cancellation& cancellation) {
    std::optional<Quad> before;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      cancellation.check(2000);
      if (is_last(i)) {
        seen_.emplace_back(span_between(curve_.from, curve_.to));
      } else {
        place(i + 1);
        seen_.emplace_back(grid_view_, cuts_[i + 1]);
      }
      if (pieces_[i].boxed) {
        if (!box(i)) return false;
        before.reset();
        continue;
      }
      const Quad here(seen_[i], seen_[i + 1], i == 0, is_last(i));
      if (!(is_last(i) ? last_piece_is_held() : piece_is_held(i, here))) return false;
      if (before && !cut_is_held(i, *before, here)) return false;
      before = here;
    }
    return true;
  }

  void write(std::vector<Point>& path, Region& ribbons) const {
    for (std::size_t i = 1; i < cuts_.size(); ++i) path.push_back(grid_.at(cuts_[i].vertex));
    path.push_back(curve_.to);
    if (side_ == RoundingSide::kNearest) return;
    for (const GridBox& box : boxes_) add_box(grid_, box, ribbons);
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (pieces_[i].boxed) continue;
      const std::size_t first = i;
      while (i + 1 < pieces_.size() && !pieces_[i + 1].boxed) ++i;
      const auto add = [&ribbons](const Point& p) { ribbons.add_vertex(p.x, p.y); };
      ribbons.begin_polygon();
      ribbons.begin_ring();
      if (first == 0) add(curve_.from);
      for (std::size_t k = std::max<std::size_t>(first, 1); k < cuts_.size() && k <= i + 1; ++k) {
        add(grid_.at(cuts_[k].right));
      }
      if (is_last(i)) add(curve_.to);
      for (std::size_t k = std::min(i + 2, cuts_.size()); k-- > std::max<std::size_t>(first, 1);) {
        if (cuts_[k].left != cuts_[k].right) add(grid_.at(cuts_[k].left));
      }
    }
  }

 private:
  [[nodiscard]] bool is_last(std::size_t piece) const { return piece + 1 == pieces_.size(); }

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
    // Where they turn back, this has no bound, and nothing that is so wide is proved.
    const double factor = std::min(count / square, 100.0);
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

  template <class Test>
  [[nodiscard]] static bool all_controls(const Bezier<Interval>& curve, Test test) {
    bool all = true;
    for_each_control(curve, [&](const Span& p) { all = all && test(p); });
    return all;
  }

  [[nodiscard]] bool piece_is_held(std::size_t i, const Quad& here) const {
    const double begin = i == 0 ? pieces_[i].begin : cuts_[i].behind;
    const double end = cuts_[i + 1].before;
    return begin < end && is_held(curve_.parts[pieces_[i].part].between(begin, end), here);
  }
  /// Is seen from the end of the curve.
  [[nodiscard]] bool last_piece_is_held() const {
    const std::size_t last = pieces_.size() - 1;
    const double begin = last == 0 ? pieces_[last].begin : cuts_[last].behind;
    const SeenCut from = last == 0 ? SeenCut(span_between(curve_.to, curve_.from))
                                   : SeenCut(GridView(grid_, curve_.to), cuts_[last]);
    return begin < 1 && is_held(curve_.ending.between(0, 1 - begin),
                                Quad(from, SeenCut(Span{}), last == 0, true));
  }
  [[nodiscard]] bool is_held(const Bezier<Interval>& curve, const Quad& here) const {
    return here.is_convex() && here.is_within(tolerance_, side_) &&
           all_controls(curve, [&](const Span& p) { return here.holds(p); });
  }

  [[nodiscard]] bool cut_is_held(std::size_t i, const Quad& before, const Quad& behind) const {
    const auto test = [&](const Span& p) {
      return before.holds_beside(p) && behind.holds_beside(p) && before.is_behind_begin(p) &&
             behind.is_before_end(p);
    };
    // What lies beside a cut is so short that its own hull mostly tells.
    const auto is_held = [&](const Bezier<Interval>& curve) {
      bool all = true;
      for (std::size_t k = 0; k < curve.size(); ++k) all = all && test(curve.at(k));
      return all || all_controls(curve, test);
    };
    return is_held(before_cut(i)) && is_held(behind_cut(i));
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
    Hull hull;
    const auto take = [&hull](const Span& p) { hull.take(p); };
    const Piece& piece = pieces_[i];
    for_each_control(curve_.parts[piece.part].between(piece.begin, piece.end), take);
    if (i > 0 && !pieces_[i - 1].boxed) for_each_control(before_cut(i), take);
    if (!is_last(i) && !pieces_[i + 1].boxed) for_each_control(behind_cut(i + 1), take);
    for (const SeenCut* const cut : {&seen_[i], &seen_[i + 1]}) {
      for (const Span& p : {cut->left, cut->right, cut->vertex}) take(p);
    }
    boxes_.push_back(grid_view_.around(hull));
    return grid_.has_diagonal_within(boxes_.back(), tolerance_);
  }

  const Curve& curve_;
  const VertexGrid& grid_;
  GridView grid_view_;
  double tolerance_;
  RoundingSide side_;
  DoubleCurve near_;
  std::vector<Piece> pieces_;
  std::vector<Cut> cuts_;  ///< cut i is where piece i begins; there is none at the curve's begin
  std::vector<SeenCut> seen_;  ///< from the curve's begin, both ends of the curve as well
  std::vector<GridBox> boxes_;
};

}  // namespace

Flattener::Flattener(const Rational& tolerance, RoundingSide side)
    : tolerance_(std::max(Interval::of(tolerance).low, 0.0)), side_(side), grid_(tolerance) {}

void Flattener::flatten(const Curve& curve, std::vector<Point>& path, Region& ribbons,
                        Cancellation& cancellation) const {
  // A proof needs some thousand roundings' room beside the coordinates, and products of a few
  // numbers must not overflow.
  constexpr double kMost = 1e100;
  double size = 0;
  bool bounded = true;
  Hull hull;
  hull.take({});
  hull.take(span_between(curve.from, curve.to));
  for (const Bezier<Interval>& part : curve.parts) {
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Control<Interval>& control = part[i];
      const Span at = part.at(i);
      hull.take(at);
      for (const double v : {at.x.low, at.x.high, at.y.low, at.y.high}) {
        size = std::max(size, std::abs(v));
      }
      for (const Interval& v : {control.x, control.y, control.w, at.x, at.y}) {
        bounded = bounded && -v.low < kMost && v.high < kMost;
      }
      bounded = bounded && control.w.low > 1 / kMost;
    }
  }
  if (!(bounded && tolerance_ > 1e-10 * size)) fail_too_small_tolerance();
  // A curve that is smaller than the tolerance needs no pieces.
  if (size < tolerance_) {
    const GridBox box = GridView(grid_, curve.from).around(hull);
    if (grid_.has_diagonal_within(box, tolerance_)) {
      path.push_back(curve.to);
      if (side_ != RoundingSide::kNearest) add_box(grid_, box, ribbons);
      return;
    }
  }
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
