// Binds the operations whose results are sets: sums, morphology, offsets, boolean operations.
#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>

#include <deque>
#include <string>
#include <string_view>

#include "bindings.hpp"
#include "elementwise.hpp"
#include "numbers.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minksum::python {
namespace {

void def_binary(nb::module_& m, const char* name, const BinaryOperation& operation,
                const char* doc) {
  m.def(
      name,
      [operation](nb::handle a, nb::handle b, const std::string& on_error, MINKSUM_SETTINGS) {
        Call call(MINKSUM_SETTING_VALUES);
        if (forgives(on_error)) call.forgive();
        return apply(call, a, b, operation);
      },
      "a"_a.none(), "b"_a.none(), nb::kw_only(), MINKSUM_ON_ERROR_ARG, MINKSUM_SETTING_ARGS,
      nb::sig(signature(name, "a: GeometryLike, b: GeometryLike", kOnError)), doc);
}

void def_tight_binary(nb::module_& m, const char* name, const BinaryOperation& operation,
                      const char* doc) {
  m.def(
      name,
      [operation](nb::handle a, nb::handle b, bool tight, const std::string& on_error,
                  MINKSUM_SETTINGS) {
        Call call(MINKSUM_SETTING_VALUES);
        if (forgives(on_error)) call.forgive();
        if (tight) call.options().tight = true;
        return apply(call, a, b, operation);
      },
      "a"_a.none(), "b"_a.none(), nb::kw_only(), "tight"_a = false, MINKSUM_ON_ERROR_ARG,
      MINKSUM_SETTING_ARGS,
      nb::sig(signature(name, "a: GeometryLike, b: GeometryLike",
                        std::string("tight: bool = False, ") + kOnError)),
      doc);
}

Geometry areas(const Geometry& a, const Geometry& b, const Options& options,
               Region (*operation)(const Region&, const Region&, const Options&)) {
  Options reading = options;
  reading.regularize = true;
  return operation(resolve(a, reading, 0).region, resolve(b, reading, 1).region, options);
}

Geometry union_of(const Geometry& a, const Geometry& b, const Options& options) {
  const Geometry both[] = {resolve(a, options, 0), resolve(b, options, 1)};
  return unite(both, options);
}

Geometry common_area(const Geometry& a, const Geometry& b, const Options& options) {
  return areas(a, b, options, intersect);
}

Geometry area_without(const Geometry& a, const Geometry& b, const Options& options) {
  return areas(a, b, options, subtract);
}

Geometry area_of_one(const Geometry& a, const Geometry& b, const Options& options) {
  return areas(a, b, options, symmetric_difference);
}

Geometry plain_sum(const Geometry& a, const Geometry& b, const Options& options) {
  return minkowski_sum(a, b, options);
}

Geometry mirror(const Geometry& a, const Options& options) {
  return resolve(reflect(a, options), options);
}

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

OffsetOptions offset_shape(nb::handle tolerance, const std::string& side, const std::string& join,
                           const std::string& cap, nb::handle miter_limit) {
  OffsetOptions shape;
  shape.side = side_of(side);
  shape.join = choice<Join>(join, "join",
                            {{"round", Join::kRound},
                             {"miter", Join::kMiter},
                             {"mitre", Join::kMiter},
                             {"square", Join::kSquare},
                             {"bevel", Join::kBevel}});
  shape.cap = choice<Cap>(cap, "cap",
                          {{"round", Cap::kRound},
                           {"butt", Cap::kButt},
                           {"flat", Cap::kButt},
                           {"square", Cap::kSquare}});
  shape.miter_limit = require_number(miter_limit, "miter_limit");
  if (!tolerance.is_none()) shape.tolerance = require_number(tolerance, "tolerance");
  return shape;
}

void bind_offset(nb::module_& m) {
  m.def(
      "offset",
      [](nb::handle a, nb::handle distance, nb::handle tolerance, const std::string& side,
         const std::string& join, const std::string& cap, nb::handle miter_limit,
         const std::string& on_error, MINKSUM_SETTINGS) {
        Call call(MINKSUM_SETTING_VALUES);
        if (forgives(on_error)) call.forgive();
        const Rational by = require_number(distance, "distance");
        const OffsetOptions shape = offset_shape(tolerance, side, join, cap, miter_limit);
        return apply(call, a, [&](const Geometry& g, const Options& options) {
          return offset(g, by, shape, options);
        });
      },
      "a"_a.none(), "distance"_a, nb::kw_only(), "tolerance"_a = nb::none(), "side"_a = "nearest",
      "join"_a = "round", "cap"_a = "round", "miter_limit"_a = 2, MINKSUM_ON_ERROR_ARG,
      MINKSUM_SETTING_ARGS,
      nb::sig(signature("offset", "a: GeometryLike, distance: Number",
                        "tolerance: Number | None = None, side: str = 'nearest', "
                        "join: str = 'round', cap: str = 'round', miter_limit: Number = 2, " +
                            std::string(kOnError))),
      "Return the set grown by a distance, or shrunk if the distance is negative.\n\n"
      "Parameters\n----------\n"
      "a : GeometryLike\n    A geometry, or an array of them.\n"
      "distance : Number\n    The distance, in the unit of the coordinates.\n"
      "tolerance : Number, optional\n    How far the result may deviate; a thousandth of the "
      "distance without it.\n"
      "side : {'nearest', 'outside', 'inside'}\n    'outside' contains the true offset, and "
      "'inside' lies within it.\n"
      "join : {'round', 'miter', 'square', 'bevel'}\n    The shape at corners.\n"
      "cap : {'round', 'butt', 'square'}\n    The shape at ends of polylines.\n"
      "miter_limit : Number\n    The longest miter, divided by the distance.\n\n"
      "Examples\n--------\n>>> import minksum\n"
      ">>> square = minksum.box(0, 0, 2, 2)\n"
      ">>> print(minksum.offset(square, 1, join='miter'))\n"
      "POLYGON ((-1 -1, 3 -1, 3 3, -1 3, -1 -1))");
}

void bind_unary(nb::module_& m) {
  const auto def = [&m](const char* name, const UnaryOperation& operation, const char* doc) {
    m.def(
        name,
        [operation](nb::handle a, const std::string& on_error, MINKSUM_SETTINGS) {
          Call call(MINKSUM_SETTING_VALUES);
          if (forgives(on_error)) call.forgive();
          return apply(call, a, operation);
        },
        "a"_a.none(), nb::kw_only(), MINKSUM_ON_ERROR_ARG, MINKSUM_SETTING_ARGS,
        nb::sig(signature(name, "a: GeometryLike", kOnError)), doc);
  };
  def(
      "resolve", [](const Geometry& a, const Options& options) { return resolve(a, options); },
      "Return the set of points that a geometry means by the fill rule, in canonical form.");
  def("reflect", mirror, "Return the point mirror at the origin.");
}

void bind_rounded(nb::module_& m) {
  m.def(
      "rounded",
      [](nb::handle a, std::optional<int> decimals, const std::string& side,
         const std::string& on_error, MINKSUM_SETTINGS) {
        Call call(MINKSUM_SETTING_VALUES);
        if (forgives(on_error)) call.forgive();
        RoundOptions target;
        target.side = side_of(side);
        target.decimals = decimals;
        return apply(call, a, [&](const Geometry& g, const Options& options) {
          return round(resolve(g, options), target, options);
        });
      },
      "a"_a.none(), nb::kw_only(), "decimals"_a = nb::none(), "side"_a = "nearest",
      MINKSUM_ON_ERROR_ARG, MINKSUM_SETTING_ARGS,
      nb::sig(signature(
          "rounded", "a: GeometryLike",
          std::string("decimals: int | None = None, side: str = 'nearest', ") + kOnError)),
      "Return a valid set near the exact one whose coordinates are doubles, or decimals with so "
      "many digits. With side 'outside' the result contains the exact set, and with 'inside' it "
      "lies within it.");
}

void bind_union_all(nb::module_& m) {
  m.def(
      "union_all",
      [](nb::handle geometries, MINKSUM_SETTINGS) {
        Call call(MINKSUM_SETTING_VALUES);
        const Operands operands = operands_of(geometries);
        auto result = std::make_shared<Shape>();
        call.run(false, [&] {
          std::vector<Geometry> sets;
          for (const ShapePtr& item : operands.array.items) {
            if (!item) continue;
            result->srid = common_srid(*result, *item);
            sets.push_back(resolve(item->geometry, call.options()));
          }
          result->geometry = unite(sets, call.options());
        });
        return to_object(result);
      },
      "geometries"_a, nb::kw_only(), MINKSUM_SETTING_ARGS,
      nb::sig(signature("union_all", "geometries: GeometryLike", "", "Geometry")),
      "Return the union of all elements. Missing ones count as empty.");
}

/// Adds an operator between geometries and arrays to both classes.
void def_operator(nb::module_& m, const char* name, const BinaryOperation& operation) {
  for (const char* type : {"Geometry", "GeometryArray"}) {
    static std::deque<std::string> kept;
    const std::string& text =
        kept.emplace_back(std::string("def ") + name + "(self, other: GeometryLike) -> " +
                          "Geometry | GeometryArray | None");
    nb::cpp_function_def(
        [operation, name](nb::handle a, nb::handle b) -> nb::object {
          if (!nb::isinstance<Shape>(b) && !nb::isinstance<ShapeArray>(b)) {
            return nb::borrow(Py_NotImplemented);
          }
          Call call;
          return name == std::string_view("__add__") ? apply_shapes(call, a, b, kept_sum)
                                                     : apply(call, a, b, operation);
        },
        nb::scope(m.attr(type)), nb::name(name), nb::is_method(), nb::is_operator(),
        nb::arg("other"), nb::sig(text.c_str()));
  }
}

void bind_operators(nb::module_& m) {
  def_operator(m, "__add__", plain_sum);
  def_operator(m, "__or__", union_of);
  def_operator(m, "__and__", common_area);
  def_operator(m, "__sub__", area_without);
  def_operator(m, "__xor__", area_of_one);
  for (const char* type : {"Geometry", "GeometryArray"}) {
    nb::cpp_function_def(
        [](nb::handle a) {
          Call call;
          return apply(call, a, mirror);
        },
        nb::scope(m.attr(type)), nb::name("__neg__"), nb::is_method(), nb::is_operator(),
        nb::sig(type == std::string_view("Geometry") ? "def __neg__(self) -> Geometry"
                                                     : "def __neg__(self) -> GeometryArray"));
  }
}

}  // namespace

void bind_sets(nb::module_& m) {
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
  def_binary(
      m, "dilate",
      [](const Geometry& a, const Geometry& b, const Options& o) { return dilate(a, b, o); },
      "Return the dilation of a by b: the Minkowski sum by another name.");
  def_tight_binary(
      m, "erode",
      [](const Geometry& a, const Geometry& b, const Options& o) { return erode(a, b, o); },
      "Return the erosion { x | x + b inside a }: where b can be put inside a. With `tight`, "
      "places without play are kept as points and polylines.");
  def_tight_binary(
      m, "opening",
      [](const Geometry& a, const Geometry& b, const Options& o) { return open(a, b, o); },
      "Return the opening: the union of all translates of b inside a.");
  def_tight_binary(
      m, "closing",
      [](const Geometry& a, const Geometry& b, const Options& o) { return close(a, b, o); },
      "Return the closing of a by b: what no translate of -b outside of a can reach.");
  def_binary(m, "union", union_of, "Return the union.");
  def_binary(m, "intersection", common_area, "Return the closure of what has area in both sets.");
  def_binary(m, "difference", area_without,
             "Return the closure of what has area in a and not in b.");
  def_binary(m, "symmetric_difference", area_of_one,
             "Return the closure of what has area in exactly one of the sets.");
  bind_offset(m);
  bind_unary(m);
  bind_rounded(m);
  bind_union_all(m);
  bind_operators(m);
  m.def(
      "prepare",
      [](nb::handle a) {
        const Operands operands = operands_of(a);
        for (const ShapePtr& item : operands.array.items) {
          if (item) item->prepared.fill(item->geometry);
        }
        return operands.scalar ? to_object(operands.array.items.front())
                               : to_object(operands.array);
      },
      "a"_a, nb::sig("def prepare(a: GeometryLike) -> typing.Any"),
      "Return the geometry, or the array, with what the next sums need made ready. An operand of "
      "several sums is made ready in the second one without it.");
}

}  // namespace minksum::python
