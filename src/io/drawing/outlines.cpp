#include "io/drawing/outlines.hpp"

#include <algorithm>

#include "minksum/minkowski_sum.hpp"
#include "minksum/resolve.hpp"

namespace minksum::io {
namespace {

/// Tells whether the curve goes straight from its first point to its last one.
bool is_straight(std::span<const Point> controls) {
  const Point& a = controls.front();
  const Rational dx = controls.back().x - a.x;
  const Rational dy = controls.back().y - a.y;
  // A curve back to its first point is straight only if it never leaves it.
  if (a == controls.back()) return are_one_point(controls);
  Rational before;
  for (const Point& p : controls.subspan(1)) {
    const Rational x = p.x - a.x;
    const Rational y = p.y - a.y;
    if (dx * y != dy * x) return false;
    const Rational along = dx * x + dy * y;
    if (along < before) return false;
    before = along;
  }
  return true;
}

}  // namespace

void append_rings(Region& to, const Region& from, bool backwards, Cancellation& cancellation) {
  for (std::size_t ring = 0; ring < from.ring_count(); ++ring) {
    to.begin_polygon();
    to.begin_ring();
    const IndexRange vertices = from.vertices_of(ring);
    const std::size_t first = vertices.front();
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      cancellation.check(16);
      const std::size_t v = first + (backwards ? vertices.size() - 1 - i : i);
      to.add_vertex(from.exact_x(v), from.exact_y(v));
    }
  }
}

Outlines::Outlines(const TextCursor& cursor, const ReadOptions& options)
    : cursor_(cursor),
      limits_(options),
      options_{.cancel = options.cancel},
      cancellation_(options_) {
  const DrawingOptions& drawing = options.drawing;
  // The rest is for errors of what has irrational coordinates.
  if (drawing.tolerance) {
    flattener_.emplace(*drawing.tolerance * Rational(15, 16), drawing.side);
  }
}

const Flattener& Outlines::flattener(const std::string& why) {
  if (flattener_) return *flattener_;
  cursor_.fail(ErrorCode::kBadInput,
               why + ", and has to say how far that may be off (io::DrawingOptions::tolerance)",
               position_);
}

void Outlines::end_ring() {
  if (!(path_.front() == path_.back())) close();
  add_ring(end_chain());
}

void Outlines::set_map(const NearAffine& map) { map_ = map; }

Point Outlines::placed(const Point& point) {
  const Point image = map_(point);
  if (map_.is_exact()) return image;
  const VertexGrid& grid = flattener("a turned shape has irrational coordinates").grid();
  add_error(map_.error_at(point) + grid.size());
  return {grid.near(image.x), grid.near(image.y)};
}

void Outlines::push(const Point& point) {
  cancellation_.check(16);
  path_.push_back(point);
  if (++vertices_ <= limits_.max_vertices) return;
  cursor_.fail(ErrorCode::kLimitExceeded,
               "more vertices than the limit of " + std::to_string(limits_.max_vertices), position_,
               ExceededLimit{"io::ReadOptions::max_vertices", limits_.max_vertices});
}

Point Outlines::placed_near(const Span& point) {
  const VertexGrid& grid = flattener("a curve ends at irrational coordinates").grid();
  const Span moved = map_(point);
  const Affine& map = map_.map;
  const Interval x = moved.x + Interval::of(map.dx);
  const Interval y = moved.y + Interval::of(map.dy);
  add_error(map_.error_at({point.x.high, point.y.high}) +
            map_.error_at({point.x.low, point.y.low}) + grid.size() + (x.high - x.low) +
            (y.high - y.low));
  return {grid.near(Rational(x.middle())), grid.near(Rational(y.middle()))};
}

void Outlines::start_at(const Point& point) {
  path_ = {point};
  path_ribbons_ = {};
}

void Outlines::move_to(const Point& point) {
  error_ = 0;
  start_at(placed(point));
}

void Outlines::line_to(const Point& point) { push(placed(point)); }

void Outlines::bezier_to(std::span<const Point> controls) {
  std::vector<Point> all{path_.back()};
  for (const Point& control : controls) all.push_back(map_(control));
  all.back() = placed(controls.back());
  if (is_straight(all)) return push(all.back());
  for (const Point& control : controls) add_error(map_.error_at(control));
  add_curve(bezier_curve(all));
}

void Outlines::arc_to_placed(const Point& point, const Span& half, const Span& turned,
                             const Interval& bulge) {
  if (!map_.is_exact()) {
    // No point of the arc is farther from its end in either coordinate. That one's error is known.
    const auto most = [](const Interval& a) { return std::max(-a.low, a.high); };
    const double sides = most(half.x) + most(half.y) + most(turned.x) + most(turned.y);
    const double reach = 2 * sides * (1 + most(bulge));
    add_error(error_ + map_.scale_error * reach);
  }
  add_curve(elliptical_arc(path_.back(), point, map_(half), map_(turned), bulge));
}

void Outlines::add_curve(const Curve& curve) {
  const Flattener& by = flattener("a curve becomes a polyline");
  const std::size_t before = path_.size();
  by.flatten(curve, path_, path_ribbons_, cancellation_);
  vertices_ += path_.size() - before - 1;
  const Point last = path_.back();
  path_.pop_back();
  push(last);
}

Chain Outlines::end_chain() {
  if (error_ > 0) widen_by_error();
  Chain chain{std::move(path_), std::move(path_ribbons_)};
  path_ = {};
  path_ribbons_ = {};
  return chain;
}

void Outlines::add_ring(Chain chain) {
  std::vector<Point>& path = chain.path;
  if (path.size() > 1 && path.front() == path.back()) path.pop_back();
  rings_.begin_polygon();
  rings_.begin_ring();
  for (const Point& p : path) rings_.add_vertex(p.x, p.y);
  append_rings(ribbons_, chain.ribbons, false, cancellation_);
}

void Outlines::add_polyline(const Chain& chain) {
  if (chain.path.size() == 1) return result_.points.push_back(chain.path[0]);
  if (!chain.ribbons.empty() && limits_.drawing.side == RoundingSide::kInside) {
    cursor_.fail(ErrorCode::kBadInput,
                 "a curve that encloses no area has no inside; the drawing is read on that side "
                 "(io::DrawingOptions::side)",
                 position_);
  }
  result_.polylines.push_back(chain.path);
  append_rings(line_ribbons_, chain.ribbons, false, cancellation_);
}

/// Makes the ribbons of the path as much wider as its points are off.
void Outlines::widen_by_error() {
  const DrawingOptions& drawing = limits_.drawing;
  // With e up to a 64th of the tolerance, √2·(2e + 1.5 steps) is below a 16th of it: the error, and
  // what is added for it on one side.
  if (Rational(64 * error_) > *drawing.tolerance) {
    cursor_.fail(ErrorCode::kLimitExceeded,
                 "the tolerance is too small for a turned shape with these coordinates", position_);
  }
  if (drawing.side == RoundingSide::kNearest || path_.size() < 2) return;
  const VertexGrid& grid = flattener_->grid();
  const Rational e = grid.near(Rational(error_)) + grid.step();
  const Region box(Polygon{{{-e, -e}, {e, -e}, {e, e}, {-e, e}}, {}});
  Options all = options_;
  all.fill = FillRule::kNonZero;
  path_ribbons_ =
      minkowski_sum(Geometry(std::move(path_ribbons_), {path_}), Geometry(box), all).region;
}

void Outlines::add_ribbons(Region& region, const Region& ribbons) const {
  if (ribbons.empty()) return;
  const bool inside = limits_.drawing.side == RoundingSide::kInside;
  Cancellation cancellation(options_);
  Region all;
  append_rings(all, region, false, cancellation);
  append_rings(all, ribbons, inside, cancellation);
  Options positive = options_;
  positive.fill = FillRule::kPositive;
  positive.regularize = true;
  region = resolve(Geometry(std::move(all)), positive).region;
}

void Outlines::append(const Region& region) {
  for (const std::size_t polygon : region.polygons()) {
    result_.region.begin_polygon();
    for (const std::size_t ring : region.rings_of(polygon)) {
      result_.region.begin_ring();
      for (const std::size_t v : region.vertices_of(ring)) {
        cancellation_.check(16);
        result_.region.add_vertex(region.exact_x(v), region.exact_y(v));
      }
    }
  }
}

void Outlines::end(FillRule rule) {
  if (!rings_.empty()) {
    Options reading = options_;
    reading.fill = rule;
    Geometry area = resolve(Geometry(std::move(rings_)), reading);
    const bool one_sided = !ribbons_.empty();
    add_ribbons(area.region, ribbons_);
    append(area.region);
    // Parts of rings without area are inside of the shape only where they are exact.
    if (!one_sided || limits_.drawing.side != RoundingSide::kInside) {
      for (Polyline& line : area.polylines) result_.polylines.push_back(std::move(line));
      for (Point& point : area.points) result_.points.push_back(std::move(point));
    }
  }
  if (!line_ribbons_.empty()) {
    Region area;
    add_ribbons(area, line_ribbons_);
    append(area);
  }
  rings_ = ribbons_ = line_ribbons_ = {};
}

}  // namespace minksum::io
