// Binds the other operations whose results are sets: morphology, offsets, boolean operations.
#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>

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
  return operation(a.region, b.region, options);
}

Geometry union_of(const Geometry& a, const Geometry& b, const Options& options) {
  const Geometry both[] = {a, b};
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

Geometry mirror(const Geometry& a, const Options& options) {
  return resolve_with_tight_places(reflect(a, options), options);
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
          return round_with_tight_places(g, target, options);
        });
      },
      "a"_a.none(), nb::kw_only(), "decimals"_a = nb::none(), "side"_a = "nearest",
      MINKSUM_ON_ERROR_ARG, MINKSUM_SETTING_ARGS,
      nb::sig(signature(
          "rounded", "a: GeometryLike",
          std::string("decimals: int | None = None, side: str = 'nearest', ") + kOnError)),
      "Return a valid set near the exact one whose coordinates are doubles, or decimals with so "
      "many digits. With side 'outside' the result contains the exact set, and with 'inside' it "
      "lies within it. Polylines and points that all lie within the area, as the places without "
      "play of a no-fit polygon do, are rounded to the nearest, whatever the side.");
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
            sets.push_back(item->geometry);
          }
          result->geometry = unite(sets, call.options());
        });
        return to_object(result);
      },
      "geometries"_a, nb::kw_only(), MINKSUM_SETTING_ARGS,
      nb::sig(signature("union_all", "geometries: GeometryLike", "", "Geometry")),
      "Return the union of all elements. Missing ones count as empty.");
}

void bind_operators(nb::module_& m) {
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
}

}  // namespace minksum::python
