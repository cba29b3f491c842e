// Declares the functions that bind parts of the library.
#pragma once

#include <nanobind/nanobind.h>

namespace minksum::python {

void bind_geometry(nanobind::module_& m);
void bind_array(nanobind::module_& m);
void bind_arrow(nanobind::module_& m);
void bind_arrow_export(nanobind::module_& m);
void bind_flat(nanobind::module_& m);
void bind_readers(nanobind::module_& m);
void bind_sums(nanobind::module_& m);
void bind_sets(nanobind::module_& m);
void bind_measures(nanobind::module_& m);
void bind_no_fit(nanobind::module_& m);
void bind_trace(nanobind::module_& m);
void bind_space(nanobind::module_& m);

}  // namespace minksum::python
