// Keeps objects of Python that are made once.
#pragma once

#include <nanobind/nanobind.h>

namespace minksum::python {

/// Returns what `make` returned for the same `kept` at first. The interpreter's lock guards it: a
/// static that C++ guards would wait for another thread, which waits for that lock. While `make`
/// imports, other threads may call it, too.
template <class Make>
nanobind::handle once(nanobind::handle& kept, Make make) {
  if (!kept.is_valid()) {
    nanobind::object made = make();
    if (!kept.is_valid()) kept = made.release();
  }
  return kept;
}

/// Returns an attribute of a module in this way.
inline nanobind::handle attribute_once(nanobind::handle& kept, const char* module,
                                       const char* name) {
  return once(kept, [=] { return nanobind::module_::import_(module).attr(name); });
}

}  // namespace minksum::python
