// Binds Minkowski sums, which keep prepared operands, may be told in detail, and have an operator.
#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>

#include <string>

#include "bindings.hpp"
#include "elementwise.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minksum::python {
namespace {

/// Returns the prepared form of an operand that was in a sum before, or null.
const PreparedRegion* prepared(const Shape& shape, const Options& options) {
  // A prepared form does not know which way rings run, which other rules ask.
  if (options.fill != FillRule::kAutomatic) return nullptr;
  return shape.prepared.get(shape.geometry, options);
}

/// Returns the sum by the prepared forms of operands, where there are such.
Geometry kept_sum(const Shape& a, const Shape& b, const Options& options) {
  if (is_small(a.geometry, b.geometry)) return minkowski_sum(a.geometry, b.geometry, options);
  const PreparedRegion* p = prepared(a, options);
  const PreparedRegion* q = prepared(b, options);
  if (p != nullptr && q != nullptr) return minkowski_sum(*p, *q, options);
  const Geometry& other = p != nullptr ? b.geometry : a.geometry;
  if ((p != nullptr || q != nullptr) && !other.has_thin_parts()) {
    try {
      return p != nullptr ? minkowski_sum(*p, other.region, options)
                          : minkowski_sum(other.region, *q, options);
    } catch (const Error& error) {
      // Its rings cross, which is read by the fill rule below.
      if (error.code() != ErrorCode::kBadInput) throw;
    }
  }
  return minkowski_sum(a.geometry, b.geometry, options);
}

nb::dict statistics_of(const Statistics& found) {
  nb::dict dict;
  dict["seconds"] = found.seconds;
  dict["small"] = found.small;
  dict["convolution_segments"] = found.convolution_segments;
  dict["segments_kept"] = found.segments_kept;
  dict["crossings"] = found.crossings;
  dict["loops"] = found.loops;
  dict["rejected_by_nesting"] = found.rejected_by_nesting;
  dict["rejected_by_collision"] = found.rejected_by_collision;
  dict["grid_cells"] = found.grid_cells;
  dict["covered_cells"] = found.covered_cells;
  dict["coordinate_bits"] = found.coordinate_bits;
  dict["by_filter"] = found.by_filter;
  dict["by_fixed_width"] = found.by_fixed_width;
  dict["by_arbitrary"] = found.by_arbitrary;
  return dict;
}

/// Returns sums with tight places, statistics, or both, as a tuple.
nb::object detailed(Call& call, nb::handle a, nb::handle b, bool tight, bool return_stats) {
  const Argument left(a, 0, call.forgives());
  const Argument right(b, 1, call.forgives());
  const Operands& first = left.array();
  const Operands& second = right.array();
  const Pairs pairs(first, second);
  ShapeArray sums{std::vector<ShapePtr>(pairs.size()), pairs.shape()};
  ShapeArray places = sums;
  std::vector<std::optional<Statistics>> statistics(pairs.size());
  if (tight) call.options().tight = true;
  for_each_pair(call, first, second, pairs,
                [&](std::size_t i, const Shape& x, const Shape& y, const Options& options) {
                  const std::int32_t srid = common_srid(x, y);
                  DetailedSum result = detailed_sum(x.geometry, y.geometry, options);
                  sums.items[i] = std::make_shared<Shape>(Shape{std::move(result.sum), srid});
                  places.items[i] = std::make_shared<Shape>(Shape{std::move(result.tight), srid});
                  statistics[i] = result.statistics;
                });
  std::vector<nb::object> told;
  for (const auto& each : statistics) {
    told.push_back(each ? nb::object(statistics_of(*each)) : nb::none());
  }
  const bool scalar = first.scalar && second.scalar;
  const auto shown = [scalar](ShapeArray array) {
    return scalar ? to_object(array.items.front()) : to_object(std::move(array));
  };
  nb::list parts;
  parts.append(shown(std::move(sums)));
  if (tight) parts.append(shown(std::move(places)));
  if (return_stats) parts.append(nested(told, pairs.shape(), scalar));
  return nb::tuple(parts);
}

nb::object sum(nb::handle a, nb::handle b, bool tight, bool return_stats,
               const std::string& on_error, MINKSUM_SETTINGS) {
  Call call(MINKSUM_SETTING_VALUES);
  if (forgives(on_error)) call.forgive();
  if (!tight && !return_stats) return apply_shapes(call, a, b, kept_sum);
  return detailed(call, a, b, tight, return_stats);
}

}  // namespace

void bind_sums(nb::module_& m) {
  m.def(
      "minkowski_sum", sum, "a"_a.none(), "b"_a.none(), nb::kw_only(), "tight"_a = false,
      "return_stats"_a = false, MINKSUM_ON_ERROR_ARG, MINKSUM_SETTING_ARGS,
      nb::sig(signature("minkowski_sum", "a: GeometryLike, b: GeometryLike",
                        std::string("tight: bool = False, return_stats: bool = False, ") + kOnError,
                        "typing.Any")),
      "Return the Minkowski sum { p + q | p in a, q in b }, exactly.\n\n"
      "Parameters\n----------\n"
      "a, b : GeometryLike\n    Geometries, or arrays that are broadcast against each other.\n"
      "tight : bool\n    Whether a pair (sum, tight places) is returned. Tight places are points "
      "and polylines\n    at which one operand fits into the other without play.\n"
      "return_stats : bool\n    Whether a dict of what was counted is returned behind the sum.\n"
      "on_error : {'raise', 'none'}\n    By 'none', an element of an array that is bad input or "
      "passes a limit gives None.\n"
      "fill : str\n    How rings are read: 'automatic', 'evenodd', 'nonzero', 'positive', "
      "'negative' or\n    'strict', which refuses rings that are not valid.\n"
      "regularize : bool\n    Whether polylines, points and spikes of the operands are "
      "dropped.\n"
      "threads : int, optional\n    How many threads share the work; all cores without it.\n"
      "max_segments, max_crossings : int, optional\n    Limits on the computation.\n"
      "timeout : float, optional\n    Seconds after which LimitError is raised.\n"
      "progress : callable, optional\n    Called with the name of the stage, at most 20 times a "
      "second. False stops the call.\n"
      "cancel : CancelToken, optional\n    Stops the call from another thread.\n\n"
      "Returns\n-------\n"
      "Geometry or GeometryArray\n    None where an operand is None.\n\n"
      "Examples\n--------\n>>> import minksum\n"
      ">>> room = minksum.box(0, 0, 4, 3)\n"
      ">>> robot = minksum.from_wkt('POLYGON ((0 0, 1/3 0, 0 1, 0 0))')\n"
      ">>> print(minksum.minkowski_sum(room, robot))\n"
      "POLYGON ((0 0, 13/3 0, 13/3 3, 4 4, 0 4, 0 0))");
  def_operator(m, "__add__", kept_sum);
  m.def(
      "prepare",
      [](nb::handle a) {
        const Operands operands = operands_of(a);
        Call call;
        call.run(false, [&] {
          for (const ShapePtr& item : operands.array.items) {
            if (item) item->prepared.fill(item->geometry, call.options());
          }
        });
        return operands.scalar ? to_object(operands.array.items.front())
                               : to_object(operands.array);
      },
      "a"_a, nb::sig("def prepare(a: GeometryLike) -> typing.Any"),
      "Return the geometry, or the array, with what the next sums need made ready. An operand of "
      "several sums is made ready in the second one without it.");
}

}  // namespace minksum::python
