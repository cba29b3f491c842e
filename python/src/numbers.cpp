#include "numbers.hpp"

#include <nanobind/stl/string.h>

#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "errors.hpp"
#include "once.hpp"

namespace nb = nanobind;

namespace minksum::python {
namespace {

std::vector<std::uint64_t> limbs_of(nb::handle magnitude) {
  const auto bits = nb::cast<std::size_t>(magnitude.attr("bit_length")());
  std::vector<std::uint64_t> limbs((bits + 63) / 64);
  const nb::bytes digits =
      nb::cast<nb::bytes>(magnitude.attr("to_bytes")(limbs.size() * 8, "little"));
  const auto* from = static_cast<const unsigned char*>(digits.data());
  for (std::size_t i = 0; i < digits.size(); ++i) {
    limbs[i / 8] |= static_cast<std::uint64_t>(from[i]) << (i % 8 * 8);
  }
  return limbs;
}

Rational quotient(nb::handle numerator, nb::handle denominator) {
  const nb::object magnitude = nb::steal(PyNumber_Absolute(numerator.ptr()));
  if (!magnitude.is_valid()) throw nb::python_error();
  if (PyLong_Check(numerator.ptr()) == 0 || PyLong_Check(denominator.ptr()) == 0 ||
      nb::cast<bool>(denominator.attr("__lt__")(0))) {
    throw nb::type_error("a fraction needs integers, of which the denominator is positive");
  }
  const std::vector<std::uint64_t> above = limbs_of(magnitude);
  const std::vector<std::uint64_t> below = limbs_of(denominator);
  const bool negative = nb::cast<bool>(numerator.attr("__lt__")(0));
  return Rational::from_limbs(negative, above.data(), above.size(), below.data(), below.size());
}

Rational integer(nb::handle value) {
  int overflow = 0;
  const long long plain = PyLong_AsLongLongAndOverflow(value.ptr(), &overflow);
  if (overflow == 0) {
    if (plain == -1 && PyErr_Occurred() != nullptr) throw nb::python_error();
    return {std::int64_t{plain}};
  }
  return quotient(value, nb::int_(1));
}

nb::object integer_object(std::span<const std::uint64_t> limbs, bool negative) {
  std::string bytes;
  for (const std::uint64_t limb : limbs) {
    for (int shift = 0; shift < 64; shift += 8) bytes += static_cast<char>(limb >> shift);
  }
  const nb::object type = nb::borrow(reinterpret_cast<PyObject*>(&PyLong_Type));
  nb::object value = type.attr("from_bytes")(nb::bytes(bytes.data(), bytes.size()), "little");
  return negative ? nb::object(-value) : value;
}

Rational from_text(nb::handle value) {
  const std::string text = utf8(value);
  std::optional<Rational> number = Rational::parse(text);
  if (!number) throw Error(ErrorCode::kBadInput, "'" + text + "' is not a number");
  return *std::move(number);
}

[[noreturn]] void refuse_infinite(nb::handle value) {
  throw Error(ErrorCode::kBadInput,
              "a finite number is expected, not " + nb::cast<std::string>(nb::str(value)));
}

}  // namespace

std::optional<Rational> number_of(nb::handle value) {
  if (PyFloat_Check(value.ptr())) {
    const double number = PyFloat_AsDouble(value.ptr());
    if (!std::isfinite(number)) refuse_infinite(value);
    return Rational(number);
  }
  if (PyLong_Check(value.ptr())) return integer(value);
  if (PyUnicode_Check(value.ptr())) return from_text(value);
  if (nb::hasattr(value, "__index__")) {
    const nb::object index = nb::steal(PyNumber_Index(value.ptr()));
    if (!index.is_valid()) throw nb::python_error();
    return integer(index);
  }
  if (nb::hasattr(value, "numerator") && nb::hasattr(value, "denominator")) {
    return quotient(value.attr("numerator"), value.attr("denominator"));
  }
  // Decimal, and NumPy's floats of other widths. Either refuses what is not finite.
  if (nb::hasattr(value, "as_integer_ratio")) {
    nb::object ratio;
    try {
      ratio = value.attr("as_integer_ratio")();
    } catch (nb::python_error& error) {
      if (!error.matches(PyExc_ValueError) && !error.matches(PyExc_OverflowError)) throw;
      refuse_infinite(value);
    }
    return quotient(ratio[0], ratio[1]);
  }
  return std::nullopt;
}

Rational require_number(nb::handle value, const char* what) {
  try {
    std::optional<Rational> number = number_of(value);
    if (number) return *std::move(number);
  } catch (const Error& error) {
    throw Error(error.code(), std::string(what) + ": " + error.what());
  }
  const std::string message = std::string(what) +
                              " must be a number: int, float, Fraction, "
                              "Decimal, or a text such as '1/3'";
  throw nb::type_error(message.c_str());
}

Point require_point(nb::handle value, const char* what) {
  if (!PyUnicode_Check(value.ptr()) && PySequence_Check(value.ptr()) != 0 && nb::len(value) == 2) {
    return {require_number(value[0], what), require_number(value[1], what)};
  }
  const std::string message = std::string(what) + " must be a pair of numbers (x, y)";
  throw nb::type_error(message.c_str());
}

std::vector<Point> require_points(nb::handle values) {
  std::vector<Point> points;
  for (nb::handle value : values) {
    try {
      points.push_back(require_point(value, "a point"));
    } catch (...) {
      rethrow_at({points.size()});
    }
  }
  return points;
}

nb::object exact_number(const Rational& value) {
  const Rational::Limbs limbs = value.limbs();
  nb::object numerator = integer_object(limbs.numerator, limbs.negative);
  if (value.is_integer()) return numerator;
  static nb::handle kept;
  const nb::handle fraction = attribute_once(kept, "minksum._fractions", "coprime");
  return fraction(numerator, integer_object(limbs.denominator, false));
}

nb::tuple exact_point(const Point& point) {
  return nb::make_tuple(exact_number(point.x), exact_number(point.y));
}

}  // namespace minksum::python
