#include "io/drawing/near_affine.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "minksum/configuration_space.hpp"

namespace minksum::io {
namespace {

constexpr double kUp = 1 + 1e-9;  // more than all roundings of a few operations on bounds

double size_of(const Rational& value) { return std::abs(value.to_double()); }

/// Returns how much longer, in the larger coordinate, an image is at most than a vector.
double norm_of(const Affine& map) {
  return kUp * std::max(size_of(map.xx) + size_of(map.xy), size_of(map.yx) + size_of(map.yy));
}

}  // namespace

NearAffine NearAffine::after(const NearAffine& first) const {
  NearAffine result{map.after(first.map)};
  if (is_exact() && first.is_exact()) return result;
  const double norm = norm_of(map);
  const double shift = std::max(size_of(first.map.dx), size_of(first.map.dy));
  result.scale_error =
      kUp * (norm * first.scale_error + scale_error * (norm_of(first.map) + first.scale_error));
  result.shift_error =
      kUp * (norm * first.shift_error + scale_error * (shift + first.shift_error) + shift_error);
  return result;
}

Span NearAffine::operator()(const Span& v) const {
  const auto sum = [&v](const Rational& f, const Rational& g) {
    return Interval::of(f) * v.x + Interval::of(g) * v.y;
  };
  return {sum(map.xx, map.xy), sum(map.yx, map.yy)};
}

double NearAffine::error_at(const Point& point) const {
  return kUp * (scale_error * std::max(size_of(point.x), size_of(point.y)) + shift_error);
}

NearAffine NearAffine::rotation(const Rational& degrees) {
  constexpr double kFinest = 1e-10;  // of degrees, the least that turns allow
  const Turn turn = nearest_turn(degrees, kFinest);
  // A point moves by its distance times the angle, and the distance is at most √2·r.
  return {turn.map(), kUp * std::numbers::sqrt2 * turn.off * std::numbers::pi / 180, 0};
}

NearAffine NearAffine::skew_x(const Rational& degrees) {
  const double about = degrees.to_double();
  NearAffine result;
  const auto eighths = static_cast<std::int64_t>(std::round(std::min(std::abs(about), 1e6) / 45));
  if (degrees == Rational(45 * eighths) || degrees == Rational(-45 * eighths)) {
    const int sign = degrees.sign();
    if (eighths % 2 == 1) result.map.xy = eighths % 4 == 1 ? sign : -sign;
    return result;
  }
  const double tangent = std::tan(about * (std::numbers::pi / 180));
  result.map.xy = Rational(tangent);
  // The angle is off by a few roundings, and the tangent's slope is 1 + tan².
  result.scale_error = 1e-14 * (1 + tangent * tangent) * (1 + std::abs(about));
  return result;
}

Span direction_of(const Interval& radians) {
  const double angle = radians.middle();
  // Functions of the library are off by far less, and slopes are at most 1.
  const double off = (radians.high - radians.low) + 1e-15;
  const Interval error(-off, off);
  return {Interval(std::cos(angle)) + error, Interval(std::sin(angle)) + error};
}

}  // namespace minksum::io
