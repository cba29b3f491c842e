// The extension module: minksum._core.
#include <nanobind/nanobind.h>

#include <minksum/minksum.hpp>
#include <minksum/version.hpp>

#include "bindings.hpp"
#include "errors.hpp"
#include "lock.hpp"

namespace nb = nanobind;

NB_MODULE(_core, m) {
  using minksum::CancelToken;
  minksum::python::register_errors();
  nb::module_::import_("atexit").attr("register")(
      nb::cpp_function(minksum::python::InterpreterEnd::come));
  nb::class_<CancelToken>(m, "CancelToken", "Stops calls from any thread.")
      .def(nb::init<>())
      .def("cancel", &CancelToken::cancel, "Stop every call that has the token.")
      .def_prop_ro("cancelled", &CancelToken::cancelled, "Whether somebody asked to stop.");
  minksum::python::bind_geometry(m);
  minksum::python::bind_array(m);
  minksum::python::bind_arrow(m);
  minksum::python::bind_flat(m);
  minksum::python::bind_readers(m);
  minksum::python::bind_sums(m);
  minksum::python::bind_sets(m);
  minksum::python::bind_measures(m);
  minksum::python::bind_no_fit(m);
  minksum::python::bind_trace(m);
  minksum::python::bind_space(m);
}
