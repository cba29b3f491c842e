// Declares how errors of the library become exceptions of Python.
#pragma once

#include <nanobind/nanobind.h>

#include <cstddef>
#include <exception>
#include <minksum/minksum.hpp>
#include <optional>
#include <string>
#include <vector>

namespace minksum::python {

/// An error in one element of an array, or while an operand was read.
struct ElementError {
  std::exception_ptr error;        ///< an Error
  std::vector<std::size_t> index;  ///< the element's index along each dimension; empty = no array
  int operand = -1;                ///< the operand that was read; -1 = not known
};

/// Throws the exception that is being handled once more, with the element or the operand that it
/// is about. To be called while an exception is handled. What objects of Python raise stays itself.
[[noreturn]] void rethrow_at(const std::vector<std::size_t>& index, int operand = -1);

/// Returns the index along each dimension of an element, counted with the last dimension fastest.
[[nodiscard]] std::vector<std::size_t> place_in(const std::vector<std::size_t>& shape,
                                                std::size_t index);

/// Returns " (polygon 1, ring 2, vertex 3)", or nothing if no place is known.
[[nodiscard]] std::string place_text(const Culprit& culprit);

/// Returns the UTF-8 of a `str`, and throws UnicodeEncodeError if it has none.
[[nodiscard]] std::string utf8(nanobind::handle text);

/// Makes errors of the library exceptions of `minksum.errors`.
void register_errors();

}  // namespace minksum::python
