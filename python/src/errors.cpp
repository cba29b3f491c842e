#include "errors.hpp"

#include <nanobind/stl/string.h>

#include <minksum/io.hpp>
#include <string>
#include <typeinfo>

namespace nb = nanobind;

namespace minksum::python {
namespace {

const char* class_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::kBadInput:
      return "BadInputError";
    case ErrorCode::kLimitExceeded:
      return "LimitError";
    case ErrorCode::kCancelled:
      return "CancelledError";
    case ErrorCode::kInternal:
      break;
  }
  return "InternalError";
}

void set_index(const nb::object& exception, const char* name, std::size_t value) {
  if (value != Culprit::kNone) exception.attr(name) = value;
}

void set_place(const nb::object& exception, const Error& error, const Culprit& culprit) {
  if (culprit.operand >= 0) exception.attr("operand") = culprit.operand;
  set_index(exception, "polygon", culprit.polygon);
  set_index(exception, "ring", culprit.ring);
  set_index(exception, "vertex", culprit.vertex);
  if (error.limit()) {
    exception.attr("limit") = std::string(error.limit()->name);
  }
  if (const auto* in_text = dynamic_cast<const io::ReadError*>(&error)) {
    if (in_text->line() > 0) exception.attr("line") = in_text->line();
    if (in_text->column() > 0) exception.attr("column") = in_text->column();
  }
}

std::string element_text(const std::vector<std::size_t>& index) {
  if (index.empty()) return {};
  std::string text = "element ";
  for (std::size_t i = 0; i < index.size(); ++i) {
    text += (i == 0 ? "" : ", ") + std::to_string(index[i]);
  }
  return text + ": ";
}

std::string message_of(const Error& error, const Culprit& culprit,
                       const std::vector<std::size_t>& index) {
  std::string message = element_text(index);
  if (const auto* in_text = dynamic_cast<const io::ReadError*>(&error)) {
    if (in_text->line() > 0) {
      message += std::to_string(in_text->line()) + ":" + std::to_string(in_text->column()) + ": ";
    }
  }
  return message + error.what() + place_text(culprit);
}

void raise(const Error& error, const std::vector<std::size_t>& index, int operand) {
  const nb::object type = nb::module_::import_("minksum.errors").attr(class_of(error.code()));
  Culprit culprit = error.culprit();
  if (culprit.operand < 0) culprit.operand = operand;
  const nb::object exception = type(message_of(error, culprit, index));
  set_place(exception, error, culprit);
  if (index.size() == 1) {
    exception.attr("index") = index.front();
  } else if (!index.empty()) {
    nb::list all;
    for (const std::size_t i : index) all.append(i);
    exception.attr("index") = nb::tuple(all);
  }
  PyErr_SetObject(type.ptr(), exception.ptr());
}

void translate(const std::exception_ptr& thrown, void* /*payload*/) {
  try {
    std::rethrow_exception(thrown);
  } catch (const Error& error) {
    raise(error, {}, -1);
  } catch (const ElementError& element) {
    try {
      std::rethrow_exception(element.error);
    } catch (const Error& error) {
      raise(error, element.index, element.operand);
    }
  } catch (const std::bad_cast&) {
    PyErr_SetString(PyExc_TypeError, "an argument, or a part of one, is of a wrong type");
  }
}

}  // namespace

void rethrow_at(const std::vector<std::size_t>& index, int operand) {
  try {
    throw;
  } catch (const ElementError& inner) {
    throw ElementError{inner.error, inner.index.empty() ? index : inner.index,
                       inner.operand < 0 ? operand : inner.operand};
  } catch (const Error&) {
    throw ElementError{std::current_exception(), index, operand};
  } catch (const nb::builtin_exception& error) {
    Culprit culprit;
    culprit.operand = operand;
    const std::string message = element_text(index) + error.what() + place_text(culprit);
    throw nb::builtin_exception(error.type(), message.c_str());
  }
}

std::vector<std::size_t> place_in(const std::vector<std::size_t>& shape, std::size_t index) {
  std::vector<std::size_t> place(shape.size());
  for (std::size_t i = shape.size(); i-- > 0;) {
    place[i] = index % shape[i];
    index /= shape[i];
  }
  return place;
}

std::string place_text(const Culprit& culprit) {
  std::string place;
  const auto add = [&place](const char* name, std::size_t value) {
    if (value == Culprit::kNone) return;
    place += (place.empty() ? " (" : ", ") + std::string(name) + ' ' + std::to_string(value);
  };
  add("operand", culprit.operand < 0 ? Culprit::kNone : static_cast<std::size_t>(culprit.operand));
  add("polygon", culprit.polygon);
  add("ring", culprit.ring);
  add("vertex", culprit.vertex);
  return place.empty() ? place : place + ")";
}

std::string utf8(nb::handle text) {
  Py_ssize_t size = 0;
  const char* data = PyUnicode_AsUTF8AndSize(text.ptr(), &size);
  if (data == nullptr) throw nb::python_error();
  return {data, static_cast<std::size_t>(size)};
}

void register_errors() { nb::register_exception_translator(translate); }

}  // namespace minksum::python
