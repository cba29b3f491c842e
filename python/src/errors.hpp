// Declares how errors of the library become exceptions of Python.
#pragma once

#include <nanobind/nanobind.h>

#include <cstddef>
#include <exception>
#include <minksum/minksum.hpp>
#include <optional>
#include <vector>

namespace minksum::python {

/// An error in one element of an array call.
struct ElementError {
  std::exception_ptr error;        ///< what the element threw
  std::vector<std::size_t> index;  ///< the element's index along each dimension
};

/// Makes errors of the library exceptions of `minksum.errors`.
void register_errors();

}  // namespace minksum::python
