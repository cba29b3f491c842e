#include "reference/exact.hpp"

#include <algorithm>
#include <cstdint>

namespace minksum::reference {

namespace {

Integer from_limbs(const std::vector<std::uint64_t>& limbs) {
  Integer value = 0;
  for (auto limb = limbs.rbegin(); limb != limbs.rend(); ++limb) value = (value << 64) + *limb;
  return value;
}

std::vector<std::uint64_t> to_limbs(Integer value) {
  std::vector<std::uint64_t> limbs;
  for (; value != 0; value >>= 64) {
    limbs.push_back(Integer(value & std::uint64_t{0xFFFFFFFFFFFFFFFF}).convert_to<std::uint64_t>());
  }
  return limbs;
}

}  // namespace

// Numbers may have more digits than parsing accepts, so the limbs are used.
Number to_number(const Rational& value) {
  const Rational::Limbs limbs = value.limbs();
  const Integer numerator = from_limbs(limbs.numerator);
  return {limbs.negative ? Integer(-numerator) : numerator, from_limbs(limbs.denominator)};
}

Rational to_rational(const Number& value) {
  const auto n = to_limbs(abs(numerator(value)));
  const auto d = to_limbs(denominator(value));
  return Rational::from_limbs(value < 0, n.data(), n.size(), d.data(), d.size());
}

Pt to_pt(const Point& point) { return {to_number(point.x), to_number(point.y)}; }

std::vector<Loops> to_loops(const Region& region) {
  std::vector<Loops> polygons;
  for (const std::size_t polygon : region.polygons()) {
    Loops loops;
    for (const std::size_t ring : region.rings_of(polygon)) {
      Loop loop;
      for (const std::size_t v : region.vertices_of(ring)) loop.push_back(to_pt(region.point(v)));
      loops.push_back(std::move(loop));
    }
    polygons.push_back(std::move(loops));
  }
  return polygons;
}

Region to_region(const std::vector<Loops>& polygons) {
  Region region;
  for (const Loops& loops : polygons) {
    region.begin_polygon();
    for (const Loop& loop : loops) {
      region.begin_ring();
      for (const Pt& p : loop) region.add_vertex(to_rational(p.x), to_rational(p.y));
    }
  }
  return region;
}

int cross_sign(const Pt& a, const Pt& b, const Pt& c, const Pt& d) {
  const Number left = (b.x - a.x) * (d.y - c.y);
  const Number right = (b.y - a.y) * (d.x - c.x);
  return left.compare(right) < 0 ? -1 : left.compare(right) > 0 ? 1 : 0;
}

int turn(const Pt& a, const Pt& b, const Pt& c) { return cross_sign(a, b, a, c); }

bool on_segment(const Pt& p, const Pt& a, const Pt& b) {
  const auto between = [](const Number& v, const Number& s, const Number& t) {
    return (s <= v && v <= t) || (t <= v && v <= s);
  };
  return between(p.x, a.x, b.x) && between(p.y, a.y, b.y) && turn(a, b, p) == 0;
}

bool cross_properly(const Pt& a, const Pt& b, const Pt& c, const Pt& d) {
  return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

bool segments_meet(const Pt& a, const Pt& b, const Pt& c, const Pt& d) {
  return on_segment(a, c, d) || on_segment(b, c, d) || on_segment(c, a, b) || on_segment(d, a, b) ||
         cross_properly(a, b, c, d);
}

Pt midpoint(const Pt& a, const Pt& b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2}; }

Number doubled_area(const Loop& loop) {
  Number sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Pt& a = loop[i];
    const Pt& b = loop[(i + 1) % loop.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

Side locate(const Pt& p, const Loop& loop) {
  bool inside = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Pt& a = loop[i];
    const Pt& b = loop[(i + 1) % loop.size()];
    if (on_segment(p, a, b)) return Side::kBoundary;
    // The ray goes to the right of p; an edge owns its lower end only.
    if ((a.y <= p.y) == (b.y <= p.y)) continue;
    const int side = turn(a, b, p);
    if (a.y <= p.y ? side > 0 : side < 0) inside = !inside;
  }
  return inside ? Side::kInside : Side::kOutside;
}

namespace {

// Classifies the clockwise turn from `back`: 0 is less than half a turn, 1 is half, 2 is more, and
// 3 is a full turn.
int clockwise_class(const Pt& node, const Pt& back, const Pt& p) {
  const int side = turn(node, back, p);
  if (side < 0) return 0;
  if (side > 0) return 2;
  const Number dot = (back.x - node.x) * (p.x - node.x) + (back.y - node.y) * (p.y - node.y);
  return dot < 0 ? 1 : 3;
}

}  // namespace

bool clockwise_before(const Pt& node, const Pt& back, const Pt& a, const Pt& b) {
  const int class_a = clockwise_class(node, back, a);
  const int class_b = clockwise_class(node, back, b);
  if (class_a != class_b) return class_a < class_b;
  return turn(node, a, b) < 0;
}

}  // namespace minksum::reference
