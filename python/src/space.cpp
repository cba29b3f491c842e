// Binds configuration spaces of robots that move and turn.
#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "bindings.hpp"
#include "elementwise.hpp"
#include "lock.hpp"
#include "numbers.hpp"
#include "once.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minksum::python {
namespace {

Geometry required(nb::handle object) {
  const ShapePtr shape = operand_of(object);
  if (!shape) throw nb::type_error("None is not a geometry");
  return shape->geometry;
}

void set_up(ConfigurationOptions& setting, nb::handle reference, nb::handle workspace) {
  if (!reference.is_none()) setting.reference = require_point(reference, "reference");
  if (!workspace.is_none()) setting.workspace = required(workspace);
}

std::vector<Turn> turns_of(nb::handle angles, double tolerance) {
  if (PyLong_Check(angles.ptr())) {
    std::size_t count = 0;
    if (!nb::try_cast(angles, count)) throw nb::value_error("angles must be a positive count");
    return full_turn(count, tolerance);
  }
  std::vector<Turn> turns;
  for (nb::handle angle : angles) {
    turns.push_back(nearest_turn(require_number(angle, "each of the angles"), tolerance));
  }
  return turns;
}

nb::object slice_of(Slice slice, bool free) {
  static nb::handle kept;
  const nb::handle type = attribute_once(kept, "minksum._results", "Slice");
  const auto shape = [](Geometry geometry) {
    return nb::cast(std::make_shared<Shape>(Shape{std::move(geometry), 0}));
  };
  return type(exact_number(slice.turn.asked), slice.turn.degrees, slice.turn.off,
              exact_point(slice.turn.direction()), shape(std::move(slice.obstacles)),
              free ? shape(std::move(slice.free)) : nb::none());
}

nb::object reach_of(const Reach& found) {
  static nb::handle kept;
  const nb::handle type = attribute_once(kept, "minksum._results", "Reach");
  nb::list path;
  for (const Waypoint& point : found.path) {
    path.append(nb::make_tuple(exact_point(point.at), point.turn.degrees));
  }
  return type(found.reachable, path, found.slices, found.parts, exact_number(found.margin));
}

Configuration configuration_of(nb::handle object, const char* what) {
  if (PySequence_Check(object.ptr()) == 0 || nb::len(object) != 3) {
    throw nb::type_error((std::string(what) + " must be (x, y, degrees)").c_str());
  }
  return {{require_number(object[0], what), require_number(object[1], what)},
          require_number(object[2], what)};
}

}  // namespace

void bind_space(nb::module_& m) {
  nb::class_<ConfigurationSpace>(
      m, "ConfigurationSpace",
      "The configurations of a robot among obstacles, one slice for each angle.")
      .def(
          "__init__",
          [](ConfigurationSpace* self, nb::handle robot, nb::handle obstacles, nb::handle reference,
             nb::handle workspace, bool tight, const std::string& fill) {
            ConfigurationOptions setting;
            set_up(setting, reference, workspace);
            const Geometry moving = required(robot);
            const Geometry walls = required(obstacles);
            Call call;
            call.options().fill = rule_of(fill);
            if (tight) call.options().tight = true;
            call.run(false, [&] {
              new (self) ConfigurationSpace(moving, walls, setting, call.options());
            });
          },
          "robot"_a, "obstacles"_a, nb::kw_only(), "reference"_a = nb::none(),
          "workspace"_a = nb::none(), "tight"_a = false, "fill"_a = "automatic",
          nb::sig("def __init__(self, robot: GeometryLike, obstacles: GeometryLike, *, "
                  "reference: tuple[Number, Number] | None = None, "
                  "workspace: GeometryLike = None, tight: bool = False, "
                  "fill: str = 'automatic') -> None"))
      .def(
          "slice",
          [](const ConfigurationSpace& space, nb::handle degrees, bool free, double tolerance) {
            const Turn turn = nearest_turn(require_number(degrees, "degrees"), tolerance);
            Slice slice;
            {
              const Unlocked unlocked;
              slice = space.slice(turn, free);
            }
            return slice_of(std::move(slice), free);
          },
          "degrees"_a, nb::kw_only(), "free"_a = false, "tolerance"_a = 1e-3,
          nb::sig("def slice(self, degrees: Number, *, free: bool = False, "
                  "tolerance: float = 0.001) -> Slice"),
          "Return the slice of the exact rotation that is nearest to an angle.")
      .def(
          "turns",
          [](const ConfigurationSpace& /*space*/, nb::handle angles, double tolerance) {
            nb::list list;
            for (const Turn& turn : turns_of(angles, tolerance)) {
              list.append(exact_number(turn.asked));
            }
            return list;
          },
          "angles"_a, nb::kw_only(), "tolerance"_a = 1e-3,
          nb::sig("def turns(self, angles: int | typing.Iterable[Number], *, "
                  "tolerance: float = 0.001) -> list[Exact]"),
          "Return the angles of so many equal steps, or those that are given, as exact degrees.");
  m.def(
      "_exact", [](nb::handle value) { return exact_number(require_number(value, "a number")); },
      "value"_a, nb::sig("def _exact(value: Number) -> Exact"));
  m.def(
      "_direction",
      [](nb::handle degrees, double tolerance) {
        return exact_point(nearest_turn(require_number(degrees, "degrees"), tolerance).direction());
      },
      "degrees"_a, "tolerance"_a,
      nb::sig("def _direction(degrees: Number, tolerance: float) -> tuple[Exact, Exact]"));
  m.def(
      "reach",
      [](nb::handle robot, nb::handle obstacles, nb::handle start, nb::handle goal,
         nb::handle reference, nb::handle workspace, std::size_t angles, bool certain,
         MINKSUM_SETTINGS) {
        Call call(MINKSUM_SETTING_VALUES);
        ReachOptions setting;
        set_up(setting, reference, workspace);
        setting.angles = angles;
        setting.certain = certain;
        const Geometry moving = required(robot);
        const Geometry walls = required(obstacles);
        const Configuration from = configuration_of(start, "start");
        const Configuration to = configuration_of(goal, "goal");
        Reach found;
        call.run(false, [&] { found = reach(moving, walls, from, to, setting, call.options()); });
        return reach_of(found);
      },
      "robot"_a, "obstacles"_a, "start"_a, "goal"_a, nb::kw_only(), "reference"_a = nb::none(),
      "workspace"_a = nb::none(), "angles"_a = 72, "certain"_a = false, MINKSUM_SETTING_ARGS,
      nb::sig(signature(
          "reach",
          "robot: GeometryLike, obstacles: GeometryLike, start: tuple[Number, Number, Number], "
          "goal: tuple[Number, Number, Number]",
          "reference: tuple[Number, Number] | None = None, workspace: GeometryLike = None, "
          "angles: int = 72, certain: bool = False, ",
          "Reach")),
      "Return whether and how a robot gets from one configuration (x, y, degrees) to another: a "
      "`Reach`.");
}

}  // namespace minksum::python
