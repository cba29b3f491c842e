#include "errors.hpp"

#include <nanobind/stl/string.h>

#include <minksum/io.hpp>
#include <string>

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

void set_place(const nb::object& exception, const Error& error) {
  const Culprit& culprit = error.culprit();
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

// Where operands are listed in a message: "(operand 0, polygon 1, ring 2, vertex 3)".
std::string message_of(const Error& error, const std::vector<std::size_t>& index) {
  std::string message;
  if (!index.empty()) {
    message = "element ";
    for (std::size_t i = 0; i < index.size(); ++i) {
      message += (i == 0 ? "" : ", ") + std::to_string(index[i]);
    }
    message += ": ";
  }
  if (const auto* in_text = dynamic_cast<const io::ReadError*>(&error)) {
    if (in_text->line() > 0) {
      message += std::to_string(in_text->line()) + ":" + std::to_string(in_text->column()) + ": ";
    }
  }
  message += error.what();
  std::string place;
  const auto add = [&place](const char* name, std::size_t value) {
    if (value == Culprit::kNone) return;
    place += (place.empty() ? " (" : ", ") + std::string(name) + ' ' + std::to_string(value);
  };
  const Culprit& culprit = error.culprit();
  add("operand", culprit.operand < 0 ? Culprit::kNone : static_cast<std::size_t>(culprit.operand));
  add("polygon", culprit.polygon);
  add("ring", culprit.ring);
  add("vertex", culprit.vertex);
  return place.empty() ? message : message + place + ")";
}

void raise(const Error& error, const std::vector<std::size_t>& index) {
  const nb::object type = nb::module_::import_("minksum.errors").attr(class_of(error.code()));
  const nb::object exception = type(message_of(error, index));
  set_place(exception, error);
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
    raise(error, {});
  } catch (const ElementError& element) {
    try {
      std::rethrow_exception(element.error);
    } catch (const Error& error) {
      raise(error, element.index);
    }
  }
}

}  // namespace

void register_errors() { nb::register_exception_translator(translate); }

}  // namespace minksum::python
