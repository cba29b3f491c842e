// Binds no-fit polygons and tables of them.
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <tuple>

#include "bindings.hpp"
#include "elementwise.hpp"
#include "lock.hpp"
#include "numbers.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minksum::python {
namespace {

using Fit = Geometry (*)(const Geometry&, const Geometry&, const std::optional<Point>&,
                         const Options&);

void def_fit(nb::module_& m, const char* name, Fit fit, const char* a, const char* b,
             const char* doc) {
  m.def(
      name,
      [fit](nb::handle first, nb::handle second, nb::handle reference, const std::string& on_error,
            MINKSUM_SETTINGS) {
        Call call(MINKSUM_SETTING_VALUES);
        if (forgives(on_error)) call.forgive();
        std::optional<Point> at;
        if (!reference.is_none()) at = require_point(reference, "reference");
        return apply(call, first, second,
                     [&](const Geometry& x, const Geometry& y, const Options& options) {
                       return fit(x, y, at, options);
                     });
      },
      nb::arg(a).none(), nb::arg(b).none(), nb::kw_only(), "reference"_a = nb::none(),
      MINKSUM_ON_ERROR_ARG, MINKSUM_SETTING_ARGS,
      nb::sig(
          signature(name, std::string(a) + ": GeometryLike, " + b + ": GeometryLike",
                    std::string("reference: tuple[Number, Number] | None = None, ") + kOnError)),
      doc);
}

struct Table {
  NoFitTable table;
  std::size_t parts;

  [[nodiscard]] TurnedPart turned(nb::handle key) const {
    TurnedPart turned{0, 0};
    const bool pair = nb::isinstance<nb::tuple>(key) && nb::len(key) == 2;
    const nb::object part = pair ? nb::object(key[0]) : nb::borrow(key);
    if (!nb::try_cast(part, turned.part, false) ||
        (pair && !nb::try_cast(nb::object(key[1]), turned.turn, false)) || turned.part >= parts) {
      const std::string message = "there is no part or turn " +
                                  nb::cast<std::string>(nb::repr(key)) + " in a table of " +
                                  std::to_string(parts) + " parts";
      throw Error(ErrorCode::kBadInput, message);
    }
    return turned;
  }
  [[nodiscard]] ShapePtr at(nb::handle key) const {
    if (!nb::isinstance<nb::tuple>(key) || nb::len(key) != 2) {
      throw nb::type_error("a table is indexed by [i, j] or [(i, turn), (j, turn)]");
    }
    return std::make_shared<Shape>(Shape{table.at(turned(key[0]), turned(key[1])), 0, {}, true});
  }
};

Table make_table(nb::handle parts, int turns, MINKSUM_SETTINGS) {
  Call call(MINKSUM_SETTING_VALUES);
  const Operands operands = operands_of(parts);
  std::vector<Geometry> geometries;
  for (const ShapePtr& item : operands.array.items) {
    if (!item) throw nb::type_error("a part must not be None");
    geometries.push_back(item->geometry);
  }
  std::optional<NoFitTable> table;
  call.run(false, [&] { table.emplace(geometries, turns, call.options()); });
  return {*std::move(table), geometries.size()};
}

/// Returns the entries of some rows: all moving parts in all turns around each fixed one.
ShapeArrayPtr entries(const Table& table, std::size_t first, std::optional<std::size_t> end) {
  const std::size_t last = std::min(end.value_or(table.parts), table.parts);
  const auto turns = static_cast<std::size_t>(table.table.turns());
  auto array = std::make_shared<ShapeArray>();
  first = std::min(first, last);
  array->shape = {last - first, turns, table.parts, turns};
  array->items.resize((last - first) * turns * table.parts * turns);
  const Unlocked unlocked;
  std::size_t i = 0;
  for (std::size_t fixed = first; fixed < last; ++fixed) {
    for (std::size_t r = 0; r < turns; ++r) {
      for (std::size_t moving = 0; moving < table.parts; ++moving) {
        for (std::size_t s = 0; s < turns; ++s) {
          array->items[i++] = std::make_shared<Shape>(
              Shape{table.table.at({fixed, static_cast<int>(r)}, {moving, static_cast<int>(s)}),
                    0,
                    {},
                    true});
        }
      }
    }
  }
  return array;
}

nb::object contacts(const NoFitPolygon& polygon, nb::handle points) {
  nb::list names;
  const char* const words[] = {"free", "touching", "overlapping"};
  for (const Point& point : require_points(points)) {
    names.append(words[static_cast<int>(polygon.contact(point))]);
  }
  return names;
}

}  // namespace

void bind_no_fit(nb::module_& m) {
  def_fit(m, "no_fit_polygon", no_fit_polygon, "fixed", "moving",
          "Return the placements of the reference point of `moving` at which the parts touch or "
          "overlap. They overlap in its interior and touch on its boundary, and on its polylines "
          "and points, which are places without play. The reference point is the first vertex of "
          "`moving` without `reference`.");
  def_fit(m, "inner_fit_polygon", inner_fit_polygon, "bin", "part",
          "Return the placements of the reference point of `part` at which it lies inside the "
          "bin. Places without play are polylines and points.");
  nb::class_<NoFitPolygon>(m, "NoFitPolygon",
                           "A no-fit polygon that is asked many times whether parts touch.")
      .def(
          "__init__",
          [](NoFitPolygon* self, nb::handle fixed, nb::handle moving, nb::handle reference) {
            const ShapePtr a = operand_of(fixed);
            const ShapePtr b = operand_of(moving);
            if (!a || !b) throw nb::type_error("None is not a geometry");
            std::optional<Point> at;
            if (!reference.is_none()) at = require_point(reference, "reference");
            (void)common_srid(*a, *b);
            Call call;
            call.run(is_small(a->geometry, b->geometry), [&] {
              new (self) NoFitPolygon(a->geometry, b->geometry, at, call.options());
            });
          },
          "fixed"_a, "moving"_a, nb::kw_only(), "reference"_a = nb::none(),
          nb::sig("def __init__(self, fixed: GeometryLike, moving: GeometryLike, *, "
                  "reference: tuple[Number, Number] | None = None) -> None"))
      .def_prop_ro(
          "geometry",
          [](const NoFitPolygon& p) {
            return std::make_shared<Shape>(Shape{p.geometry(), 0});
          },
          "The polygon itself.")
      .def("contact", contacts, "points"_a,
           nb::sig("def contact(self, points: typing.Iterable[typing.Any]) -> list[str]"),
           "Return for each placement 'free', 'touching' or 'overlapping', exactly.");
  nb::class_<Table>(m, "NoFitTable",
                    "The no-fit polygons of all pairs of parts in all directions. `table[i, j]` "
                    "is that of part j around part i, and `table[(i, r), (j, s)]` has them turned "
                    "by r and s times 360 / turns degrees. A part's reference point is its first "
                    "vertex.")
      .def(
          "__init__",
          [](Table* self, nb::handle parts, int turns, MINKSUM_SETTINGS) {
            new (self) Table(make_table(parts, turns, MINKSUM_SETTING_VALUES));
          },
          "parts"_a, nb::kw_only(), "turns"_a = 4, MINKSUM_SETTING_ARGS,
          nb::sig(signature("__init__", "self, parts: GeometryLike", "turns: int = 4, ", "None")))
      .def("__getitem__", &Table::at, "key"_a,
           nb::sig("def __getitem__(self, key: tuple[int, int] | "
                   "tuple[tuple[int, int], tuple[int, int]]) -> Geometry"))
      .def("__len__", [](const Table& t) { return t.parts; })
      .def_prop_ro(
          "turns", [](const Table& t) { return t.table.turns(); },
          "The number of directions in which parts are laid.")
      .def("entries", entries, "first"_a = 0, "end"_a = nb::none(),
           "Return the entries of the rows from `first` up to, but without, `end`, as an array of "
           "shape (rows, turns, parts, turns).");
}

}  // namespace minksum::python
