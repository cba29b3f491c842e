#include "io/drawing/dxf_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace minksum::io {
namespace {

const Interval kPi = Interval::widened(std::numbers::pi, std::numbers::pi);

/// Returns (cos, sin).
Span direction(const Interval& radians, int quarters) {
  switch (quarters < 0 ? 4 : quarters % 4) {
    case 0:
      return {1, 0};
    case 1:
      return {0, 1};
    case 2:
      return {-1, 0};
    case 3:
      return {0, -1};
    default:
      return direction_of(radians);
  }
}

Span combination(const Interval& a, const Point& u, const Interval& b, const Point& v) {
  return {a * Interval::of(u.x) + b * Interval::of(v.x),
          a * Interval::of(u.y) + b * Interval::of(v.y)};
}

}  // namespace

bool DxfShapes::add(const DxfEntity& entity, const NearAffine& map) {
  const std::string_view type = entity.type.value;
  const DxfValues values(tags_, entity);
  if (type == "SPLINE") {
    check_flat(entity);
    spline(values, entity, map);
    return true;
  }
  const bool own_plane = type == "ARC" || type == "CIRCLE" || type == "LWPOLYLINE" ||
                         type == "SOLID" || type == "TRACE" || type == "POLYLINE";
  constexpr int kThreeDimensional = 8, kMeshes = 16 | 64;
  const int flags = type == "POLYLINE" ? values.integer(70) : 0;
  if ((flags & kMeshes) != 0) return false;
  if (!own_plane && type != "LINE" && type != "ELLIPSE") return false;
  if ((type == "ARC" || type == "CIRCLE") && values.number(40).sign() == 0) return false;
  check_flat(entity);
  outlines_.forget_errors();
  const bool flat = own_plane && (flags & kThreeDimensional) == 0;
  outlines_.set_map(flat ? map.after(own(values, entity)) : map);
  if (type == "LINE") line(values);
  if (type == "ARC" || type == "CIRCLE") arc(values, entity, type == "CIRCLE");
  if (type == "ELLIPSE") ellipse(values, entity);
  if (type == "SOLID" || type == "TRACE") solid(values);
  if (type == "LWPOLYLINE") light_polyline(values, entity);
  if (type == "POLYLINE") polyline(values, flat);
  return true;
}

/// Heights are the codes 30 to 33 of points, and 38 of a whole entity.
void DxfShapes::check_flat(const DxfEntity& entity) const {
  if (drop_z_) return;
  for (const DxfTag& tag : entity.tags) {
    const bool height = (tag.code >= 30 && tag.code <= 33) || tag.code == 38;
    if (!height || tags_.number(tag).sign() == 0) continue;
    tags_.fail("a point has a height other than 0 (io::ReadOptions::drop_z keeps x and y)",
               tag.position);
  }
}

bool DxfShapes::is_mirrored(const DxfValues& values, const DxfEntity& entity) const {
  const Rational x = values.number(210, 0), y = values.number(220, 0), z = values.number(230, 1);
  if (x.sign() != 0 || y.sign() != 0 || z.sign() == 0) {
    tags_.fail("an entity is not drawn in the plane of x and y", entity.type.position);
  }
  return z.sign() < 0;
}

NearAffine DxfShapes::own(const DxfValues& values, const DxfEntity& entity) const {
  // Seen from below, the x axis points the other way.
  if (!is_mirrored(values, entity)) return {};
  return {Affine{-1, {}, {}, {}, 1, {}}};
}

void DxfShapes::end(bool is_closed) {
  if (is_closed && !(outlines_.here() == outlines_.start())) outlines_.close();
  (is_closed ? closed : open).push_back(outlines_.end_chain());
}

void DxfShapes::line(const DxfValues& values) {
  outlines_.move_to(values.point(10));
  outlines_.line_to(values.point(11));
  end(false);
}

void DxfShapes::solid(const DxfValues& values) {
  // The third and the fourth corner are exchanged in files. A triangle has the third one twice.
  outlines_.move_to(values.point(10));
  outlines_.line_to(values.point(11));
  if (values.find(13) != nullptr) outlines_.line_to(values.point(13));
  outlines_.line_to(values.point(12));
  end(true);
}

Point DxfShapes::placed(const Ellipse& ellipse, const Angle& angle) {
  const auto& [c, u, v] = ellipse;
  switch (angle.quarters < 0 ? 4 : angle.quarters % 4) {
    case 0:
      return outlines_.placed({c.x + u.x, c.y + u.y});
    case 1:
      return outlines_.placed({c.x + v.x, c.y + v.y});
    case 2:
      return outlines_.placed({c.x - u.x, c.y - u.y});
    case 3:
      return outlines_.placed({c.x - v.x, c.y - v.y});
    default:
      break;
  }
  const Span way = direction(angle.radians, -1);
  const Span off = combination(way.x, u, way.y, v);
  return outlines_.placed_near({Interval::of(c.x) + off.x, Interval::of(c.y) + off.y});
}

/// Adds an arc from one angle to a larger one, which is cut at quarter turns.
void DxfShapes::add_arcs(const Ellipse& ellipse, const Angle& from, const Angle& to,
                         bool is_closed) {
  const double quarter = std::numbers::pi / 2;
  std::vector<Angle> angles{from};
  // An angle that is less than this before a quarter turn makes no arc of its own.
  constexpr double kClose = 1e-6;
  for (int k = static_cast<int>(std::floor(from.radians.middle() / quarter)) + 1;
       k * quarter < to.radians.middle() - kClose; ++k) {
    if (k * quarter < from.radians.middle() + kClose) continue;
    angles.push_back({Interval(k) * kPi * Interval(0.5), k});
  }
  angles.push_back(to);
  outlines_.start_at(placed(ellipse, from));
  const Point start = outlines_.here();
  Span before = direction(from.radians, from.quarters);
  for (std::size_t i = 1; i < angles.size(); ++i) {
    const Span behind = direction(angles[i].radians, angles[i].quarters);
    const Interval x = (behind.x - before.x) * Interval(0.5);
    const Interval y = (behind.y - before.y) * Interval(0.5);
    const Span part = direction_of((angles[i].radians - angles[i - 1].radians) * Interval(0.25));
    const bool last = i + 1 == angles.size();
    const Point end = last && is_closed ? start : placed(ellipse, angles[i]);
    if (!(end == outlines_.here())) {
      outlines_.arc_to_placed(end, combination(x, ellipse.u, y, ellipse.v),
                              combination(x, ellipse.v, -y, ellipse.u), part.y / part.x);
    }
    before = behind;
  }
  end(is_closed);
}

void DxfShapes::arc(const DxfValues& values, const DxfEntity& entity, bool whole) {
  const Rational radius = values.number(40);
  if (radius.sign() <= 0) tags_.fail("a radius must be positive", entity.type.position);
  const Ellipse circle{values.point(10), {radius, 0}, {0, radius}};
  const Rational from = whole ? Rational() : values.number(50);
  Rational to = whole ? Rational() : values.number(51);
  const auto turned_up = [&](const Rational& angle) {
    const double turns = std::floor(((from - angle) / Rational(360)).to_double()) + 1;
    if (!(std::abs(turns) < 1e6)) tags_.fail("an angle is too large", entity.type.position);
    Rational up = angle + Rational(360) * Rational(turns);
    while (up - Rational(360) > from) up = up - Rational(360);
    while (up <= from) up = up + Rational(360);
    return up;
  };
  to = turned_up(to);
  const auto angle = [](const Rational& degrees) {
    const Rational quarters = degrees / Rational(90);
    Angle result{Interval::of(degrees) * kPi / Interval(180)};
    if (quarters.is_integer() && quarters.sign() >= 0) {
      result.quarters = static_cast<int>(quarters.to_double());
    }
    return result;
  };
  add_arcs(circle, angle(from), angle(to), to - from == Rational(360));
}

void DxfShapes::ellipse(const DxfValues& values, const DxfEntity& entity) {
  const Point major = values.point(11);
  Rational ratio = values.number(40);
  if (ratio.sign() <= 0) tags_.fail("the ratio of axes must be positive", entity.type.position);
  if (is_mirrored(values, entity)) ratio = -ratio;
  const Ellipse shape{values.point(10), major, {-ratio * major.y, ratio * major.x}};
  const Rational full(6.283185307179586);
  const Rational from = values.number(41, 0);
  Rational to = values.number(42, full);
  constexpr double kMost = 1e6;
  if (!(std::abs(from.to_double()) < kMost && std::abs(to.to_double()) < kMost)) {
    tags_.fail("an angle is too large", entity.type.position);
  }
  // A file cannot say 2π exactly, so an ellipse that lacks less than a millionth is closed.
  const double sweep = (to - from).to_double();
  const double turn = 2 * std::numbers::pi;
  const bool is_closed = std::abs(sweep - turn) < 1e-6;
  if (is_closed && from.sign() == 0) return add_arcs(shape, {0, 0}, {kPi + kPi, 4}, true);
  const Interval begin = Interval::of(from);
  Interval end = is_closed ? begin + kPi + kPi : Interval::of(to);
  for (double turns = std::ceil(-sweep / turn); turns > 0; --turns) end = end + kPi + kPi;
  for (; end.middle() - begin.middle() > turn + 1e-6; end = end - kPi - kPi) {
  }
  add_arcs(shape, {begin, from.sign() == 0 ? 0 : -1}, {end, -1}, is_closed);
}

void DxfShapes::light_polyline(const DxfValues& values, const DxfEntity& entity) {
  std::vector<Vertex> vertices;
  for (const DxfTag& tag : entity.tags) {
    if (tag.code == 10) vertices.push_back({{tags_.number(tag), 0}, 0});
    if (vertices.empty()) continue;
    if (tag.code == 20) vertices.back().point.y = tags_.number(tag);
    if (tag.code == 42) vertices.back().bulge = tags_.number(tag);
  }
  add_polyline(vertices, (values.integer(70) & 1) != 0);
}

void DxfShapes::polyline(const DxfValues& values, bool is_flat) {
  const bool is_closed = (values.integer(70) & 1) != 0;
  constexpr int kFrame = 16;  // control points of a spline that the other vertices show
  std::vector<Vertex> vertices;
  DxfEntity entity;
  for (;;) {
    const DxfTag tag = tags_.peek();
    if (tag.value != "VERTEX") {
      if (tag.value == "SEQEND") tags_.next(entity);
      break;
    }
    tags_.next(entity);
    check_flat(entity);
    const DxfValues vertex(tags_, entity);
    if ((vertex.integer(70) & kFrame) != 0) continue;
    vertices.push_back({vertex.point(10), is_flat ? vertex.number(42, 0) : Rational()});
  }
  add_polyline(vertices, is_closed);
}

void DxfShapes::add_polyline(const std::vector<Vertex>& vertices, bool is_closed) {
  if (vertices.empty()) return;
  outlines_.move_to(vertices[0].point);
  const std::size_t count = vertices.size();
  for (std::size_t i = 0; i + (is_closed ? 0 : 1) < count; ++i) {
    const auto& [from, bulge] = vertices[i];
    const Point& to = vertices[(i + 1) % count].point;
    if (from == to) continue;
    if (bulge.sign() == 0) {
      outlines_.line_to(to);
      continue;
    }
    const Span half{Interval::of((to.x - from.x) / Rational(2)),
                    Interval::of((to.y - from.y) / Rational(2))};
    outlines_.arc_to(to, half, {-half.y, half.x},
                     bulge == Rational(1) ? Interval(1) : Interval::of(bulge));
  }
  end(is_closed);
}

DxfShapes::Spline DxfShapes::take_spline(const DxfValues& values, const DxfEntity& entity) const {
  const std::size_t at = entity.type.position;
  const auto refuse_unless = [&](bool condition, const char* what) {
    if (!condition) tags_.fail(what, at);
  };
  const int degree = values.integer(71, 3);
  constexpr int kHighest = static_cast<int>(Bezier<double>::kMostControls) - 1;
  refuse_unless(degree >= 1 && degree <= kHighest, "the degree of a spline must be from 1 to 11");
  const auto p = static_cast<std::size_t>(degree);
  Spline spline{p, {}, {}, {}};
  auto& [_, controls, knots, weights] = spline;
  for (const DxfTag& tag : entity.tags) {
    if (tag.code == 40) knots.push_back(tags_.number(tag));
    if (tag.code == 41) weights.push_back(tags_.number(tag));
    if (tag.code == 10) controls.push_back({tags_.number(tag), 0});
    if (tag.code == 20 && !controls.empty()) controls.back().y = tags_.number(tag);
  }
  const std::size_t n = controls.size();
  refuse_unless(n > 0, "a spline has fit points alone; its control points are needed");
  refuse_unless(n > p && knots.size() == n + p + 1,
                "a spline's numbers of control points and of knots do not fit its degree");
  refuse_unless(std::is_sorted(knots.begin(), knots.end()), "the knots of a spline decrease");
  refuse_unless(knots[p] < knots[n], "a spline has no length");
  if (weights.empty()) weights.assign(n, 1);
  refuse_unless(weights.size() == n, "a spline has not one weight for each control point");
  for (const Rational& weight : weights) {
    refuse_unless(weight.sign() > 0, "a weight of a spline is not positive");
  }
  // Where the first knot or the last one comes too often, some control points take no part.
  std::size_t first = 0;
  while (knots[first + p + 1] == knots[p]) ++first;
  std::size_t count = n - first;
  while (knots[first + count - 1] == knots[n]) --count;
  const auto keep = [first](auto& list, std::size_t size) {
    list.erase(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(first));
    list.resize(size);
  };
  keep(controls, count);
  keep(weights, count);
  keep(knots, count + p + 1);
  for (std::size_t i = p + 1; i + p < count; ++i) {
    refuse_unless(knots[i] != knots[i + p] || controls[i - 1] == controls[i],
                  "a spline jumps at a knot that occurs more often than its degree; write the "
                  "pieces before and behind it as splines of their own");
  }
  return spline;
}

void DxfShapes::spline(const DxfValues& values, const DxfEntity& entity, const NearAffine& map) {
  const auto [p, controls, knots, weights] = take_spline(values, entity);
  const std::size_t n = controls.size();
  const Point& first = controls.front();
  const bool is_point = are_one_point(controls);
  if (p == 1 || is_point) {
    outlines_.set_map(map);
    outlines_.move_to(first);
    for (std::size_t i = 1; i < n && !is_point; ++i) outlines_.line_to(controls[i]);
    return end(first == controls.back());
  }
  outlines_.set_map(map);
  outlines_.forget_errors();
  const bool clamped = knots[0] == knots[p] && knots[n] == knots[n + p];
  Point from = outlines_.placed(controls.front());
  Point to = outlines_.placed(controls.back());
  std::vector<Point> moved;
  for (const Point& control : controls) {
    outlines_.add_error(map.error_at(control));
    moved.push_back(map(control));
  }
  if (!clamped) {
    // The ends are not control points. They are found first, and rounded.
    outlines_.set_map({});
    const auto end_of = [&](const Vector<Interval>& end) {
      return outlines_.placed_near(
          {Interval::of(moved[0].x) + end.x, Interval::of(moved[0].y) + end.y});
    };
    const auto parts = spline_parts(moved[0], p, moved, knots, weights);
    from = end_of(parts.front().front());
    to = end_of(parts.back().back());
    const Rational step = outlines_.flattener("a curve becomes a polyline").grid().step();
    const auto near = [&](const Rational& a, const Rational& b) {
      return a - b <= step && b - a <= step;
    };
    if ((values.integer(70) & 1) != 0 && near(from.x, to.x) && near(from.y, to.y)) {
      outlines_.add_error((step + step).to_double());
      to = from;
    }
  }
  outlines_.start_at(from);
  outlines_.add_curve(spline_curve(from, to, p, moved, knots, weights));
  end(from == to);
}

}  // namespace minksum::io
