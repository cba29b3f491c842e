// Defines exact points and predicates for the reference, with rationals and written for clarity.
#pragma once

#ifdef MINKSUM_TESTS_HAVE_GMP
#include <boost/multiprecision/gmp.hpp>
#else
#include <boost/multiprecision/cpp_int.hpp>
#endif
#include <vector>

#include "minksum/region.hpp"

namespace minksum::reference {

// GMP's numbers are faster: tests of overlays took 37 s with Boost's own, and take 15 s.
#ifdef MINKSUM_TESTS_HAVE_GMP
using IntegerBackend = boost::multiprecision::gmp_int;
using NumberBackend = boost::multiprecision::gmp_rational;
#else
using IntegerBackend = boost::multiprecision::cpp_int_backend<>;
using NumberBackend = boost::multiprecision::cpp_rational_backend;
#endif
using Integer = boost::multiprecision::number<IntegerBackend, boost::multiprecision::et_off>;
using Number = boost::multiprecision::number<NumberBackend, boost::multiprecision::et_off>;

struct Pt {
  Number x;
  Number y;
  friend bool operator==(const Pt& a, const Pt& b) { return a.x == b.x && a.y == b.y; }
  friend bool operator<(const Pt& a, const Pt& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }
};

using Loop = std::vector<Pt>;     ///< a closed ring, first vertex not repeated
using Loops = std::vector<Loop>;  ///< a polygon: the outer ring, then the holes

[[nodiscard]] Number to_number(const Rational& value);
[[nodiscard]] Rational to_rational(const Number& value);
[[nodiscard]] Pt to_pt(const Point& point);
[[nodiscard]] std::vector<Loops> to_loops(const Region& region);
[[nodiscard]] Region to_region(const std::vector<Loops>& polygons);

/// Returns 1 if a, b, c turn left, -1 if right, 0 if they lie in one line.
[[nodiscard]] int turn(const Pt& a, const Pt& b, const Pt& c);
/// Returns the sign of the cross product of b - a and d - c.
[[nodiscard]] int cross_sign(const Pt& a, const Pt& b, const Pt& c, const Pt& d);
/// Returns whether p is on the closed segment ab.
[[nodiscard]] bool on_segment(const Pt& p, const Pt& a, const Pt& b);
/// Returns whether the closed segments ab and cd share a point.
[[nodiscard]] bool segments_meet(const Pt& a, const Pt& b, const Pt& c, const Pt& d);
/// Returns whether the open segments cross in one point that is an end of neither.
[[nodiscard]] bool cross_properly(const Pt& a, const Pt& b, const Pt& c, const Pt& d);
[[nodiscard]] Pt midpoint(const Pt& a, const Pt& b);
/// Returns twice the signed area, which is positive for counter-clockwise rings.
[[nodiscard]] Number doubled_area(const Loop& loop);

enum class Side { kOutside, kBoundary, kInside };
/// Returns where p lies with respect to the area inside a closed polygonal line (even-odd).
[[nodiscard]] Side locate(const Pt& p, const Loop& loop);

/// Returns whether a clockwise turn around `node` from `back` meets `a` before `b`. The direction
/// `back` itself counts as a full turn.
[[nodiscard]] bool clockwise_before(const Pt& node, const Pt& back, const Pt& a, const Pt& b);

}  // namespace minksum::reference
