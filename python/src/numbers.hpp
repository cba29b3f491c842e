// Declares how exact numbers pass between Python and the library.
#pragma once

#include <nanobind/nanobind.h>

#include <minksum/minksum.hpp>
#include <optional>
#include <vector>

namespace minksum::python {

/// Returns the exact value of a Python number, and nothing if `value` is not one. Numbers are int,
/// float, Fraction, Decimal, NumPy's scalars, and texts such as "1/3". Throws Error(kBadInput) for
/// a float that is not finite, and for a text that is not a number.
[[nodiscard]] std::optional<Rational> number_of(nanobind::handle value);
/// Returns the same, and throws TypeError, which names `what`, for anything else.
[[nodiscard]] Rational require_number(nanobind::handle value, const char* what);
/// Returns a pair of numbers as a point. Throws TypeError, which names `what`, for anything else.
[[nodiscard]] Point require_point(nanobind::handle value, const char* what);

/// Returns the points of an iterable. What it throws names the index of the point.
[[nodiscard]] std::vector<Point> require_points(nanobind::handle values);

/// Returns an int for an integer, and a fractions.Fraction otherwise.
[[nodiscard]] nanobind::object exact_number(const Rational& value);
/// Returns a pair of exact numbers.
[[nodiscard]] nanobind::tuple exact_point(const Point& point);

}  // namespace minksum::python
