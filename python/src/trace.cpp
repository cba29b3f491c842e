// Binds the record of what the stages of a sum made.
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <utility>
#include <vector>

#include "bindings.hpp"
#include "elementwise.hpp"
#include "once.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minksum::python {
namespace {

template <class Number>
nb::object table_of(std::vector<Number> values, std::size_t columns) {
  auto* kept = new std::vector<Number>(std::move(values));
  const nb::capsule owner(kept,
                          [](void* p) noexcept { delete static_cast<std::vector<Number>*>(p); });
  return nb::cast(nb::ndarray<nb::numpy, Number, nb::ndim<2>>(
      kept->data(), {kept->size() / columns, columns}, owner));
}

nb::object points_of(const std::vector<Trace::Vertex>& vertices) {
  std::vector<double> values;
  for (const Trace::Vertex& v : vertices) values.insert(values.end(), {v.x, v.y});
  return table_of(std::move(values), 2);
}

nb::tuple segments_of(const std::vector<Trace::Segment>& segments) {
  std::vector<double> ends;
  std::vector<std::uint8_t> flags;
  for (const Trace::Segment& s : segments) {
    ends.insert(ends.end(), {s.from.x, s.from.y, s.to.x, s.to.y});
    flags.insert(flags.end(), {std::uint8_t{s.edge_of_first}, std::uint8_t{s.kept}});
  }
  return nb::make_tuple(table_of(std::move(ends), 4), table_of(std::move(flags), 2));
}

nb::object grid_of(const Trace::Grid& grid) {
  if (grid.columns == 0) return nb::none();
  std::vector<std::uint8_t> covered(grid.covered.begin(), grid.covered.end());
  return nb::make_tuple(grid.min_x, grid.min_y, grid.cell_width, grid.cell_height,
                        table_of(std::move(covered), grid.columns));
}

nb::list loops_of(const std::vector<Trace::Loop>& loops) {
  const char* const states[] = {"accepted", "rejected by nesting", "rejected by collision"};
  nb::list list;
  for (const Trace::Loop& loop : loops) {
    list.append(nb::make_tuple(points_of(loop.vertices), loop.positive,
                               states[static_cast<int>(loop.state)]));
  }
  return list;
}

nb::object trace_sum(nb::handle a, nb::handle b, MINKSUM_SETTINGS) {
  Call call(MINKSUM_SETTING_VALUES);
  const ShapePtr p = operand_of(a);
  const ShapePtr q = operand_of(b);
  if (!p || !q) throw nb::type_error("None is not a geometry");
  DetailedSum made;
  call.run(false,
           [&] { made = detailed_sum(p->geometry, q->geometry, call.options(), Detail::kTrace); });
  static nb::handle kept;
  const nb::handle type = attribute_once(kept, "minksum._results", "_trace");
  return type(to_object(Shape{std::move(made.sum), common_srid(*p, *q)}),
              segments_of(made.trace.convolution), grid_of(made.trace.cover),
              points_of(made.trace.nodes), segments_of(made.trace.pieces),
              loops_of(made.trace.loops));
}

}  // namespace

void bind_trace(nb::module_& m) {
  m.def("trace_sum", trace_sum, "a"_a, "b"_a, nb::kw_only(), MINKSUM_SETTING_ARGS,
        nb::sig(signature("trace_sum", "a: GeometryLike, b: GeometryLike", "", "Trace")),
        "Return what each stage of a sum made, and the sum: a `Trace`.");
}

}  // namespace minksum::python
