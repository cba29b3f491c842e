// Binds what is asked about sets: areas, places, validity, depth, and the check of sums.
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "bindings.hpp"
#include "elementwise.hpp"
#include "numbers.hpp"
#include "once.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minksum::python {
namespace {

/// Makes objects of values, on the thread that has the interpreter's lock.
template <class Value, class Show>
std::vector<nb::object> shown(const std::vector<std::optional<Value>>& values, const Show& show) {
  std::vector<nb::object> objects;
  for (const auto& value : values) {
    objects.push_back(value ? nb::object(show(*value)) : nb::none());
  }
  return objects;
}

/// Computes a value for each element with the lock released, and then makes objects of the values.
template <class Value, class Compute, class Show>
nb::object ask_each(nb::handle a, const Compute& compute, const Show& show) {
  const Argument argument(a);
  Call call;
  if (argument.scalar()) {
    const Shape* shape = argument.shape();
    if (shape == nullptr) return nb::none();
    std::optional<Value> value;
    call.run(is_small(shape->geometry), [&] { value = compute(*shape, call.options()); });
    return show(*value);
  }
  const ShapeArray& array = argument.array().array;
  std::vector<std::optional<Value>> values(array.items.size());
  call.for_each(array.shape, [&](std::size_t i, const Options& options) {
    if (array.items[i]) values[i] = compute(*array.items[i], options);
  });
  return nested(shown(values, show), array.shape, false);
}

nb::object area_of(nb::handle a, bool exact) {
  if (exact) {
    return ask_each<Rational>(
        a, [](const Shape& s, const Options& options) { return area(set_of(s, options).region); },
        exact_number);
  }
  return ask_each<double>(
      a,
      [](const Shape& s, const Options& options) {
        return approximate_area(set_of(s, options).region);
      },
      [](double value) { return nb::float_(value); });
}

}  // namespace

nb::object bounds_of(nb::handle a, bool exact) {
  const auto box_of = [](const Shape& s, const Options& /*options*/) {
    const Geometry& g = s.geometry;
    Region corners = g.region;
    if (g.has_thin_parts()) {
      corners.begin_polygon();
      corners.begin_ring();
      for (const Polyline& line : g.polylines) {
        for (const Point& p : line) corners.add_vertex(p.x, p.y);
      }
      for (const Point& p : g.points) corners.add_vertex(p.x, p.y);
    }
    return bounding_box(corners);
  };
  return ask_each<std::optional<Box>>(a, box_of, [exact](const std::optional<Box>& box) {
    if (!box) return nb::object(nb::none());
    const auto number = [exact](const Rational& r) -> nb::object {
      if (exact) return exact_number(r);
      return nb::float_(r.to_double());
    };
    return nb::object(nb::make_tuple(number(box->min.x), number(box->min.y), number(box->max.x),
                                     number(box->max.y)));
  });
}

namespace {

nb::dict fault_of(const Fault& fault) {
  nb::dict dict;
  const auto place = [](const Culprit& culprit) -> nb::object {
    if (culprit.polygon == Culprit::kNone) return nb::none();
    const auto index = [](std::size_t i) -> nb::object {
      if (i == Culprit::kNone) return nb::none();
      return nb::int_(i);
    };
    return nb::make_tuple(index(culprit.polygon), index(culprit.ring), index(culprit.vertex));
  };
  dict["message"] = to_string(fault);
  dict["place"] = place(fault.place);
  dict["other"] = place(fault.other);
  dict["at"] = fault.at ? nb::object(exact_point(*fault.at)) : nb::none();
  return dict;
}

nb::object contact_of(const std::optional<EdgeOrigin>& contact) {
  if (!contact) return nb::none();
  return nb::make_tuple(static_cast<int>(contact->edge_operand), contact->edge, contact->vertex);
}

nb::object depth_of(const std::optional<Depth>& depth) {
  if (!depth) return nb::none();
  static nb::handle kept;
  const nb::handle type = attribute_once(kept, "minksum._results", "Depth");
  return type(depth->overlapping, exact_point(depth->vector), exact_number(depth->squared),
              depth->distance, contact_of(depth->contact));
}

/// Computes a value for each pair with the lock released, and then makes objects of the values.
template <class Value, class Compute, class Show>
nb::object ask_pairs(Call& call, nb::handle a, nb::handle b, const Compute& compute,
                     const Show& show) {
  const Argument left(a, 0, call.forgives());
  const Argument right(b, 1, call.forgives());
  const Operands& first = left.array();
  const Operands& second = right.array();
  const Pairs pairs(first, second);
  std::vector<std::optional<Value>> values(pairs.size());
  for_each_pair(call, first, second, pairs,
                [&](std::size_t i, const Shape& x, const Shape& y, const Options& options) {
                  (void)common_srid(x, y);
                  values[i] = compute(x.geometry, y.geometry, options);
                });
  return nested(shown(values, show), pairs.shape(), first.scalar && second.scalar);
}

nb::object locate_all(nb::handle a, nb::handle points, MINKSUM_SETTINGS) {
  Call call(MINKSUM_SETTING_VALUES);
  const ShapePtr shape = operand_of(a);
  if (!shape) return nb::none();
  const std::vector<Point> asked = require_points(points);
  auto* places = new std::vector<std::int8_t>(asked.size());
  const nb::capsule owner(
      places, [](void* p) noexcept { delete static_cast<std::vector<std::int8_t>*>(p); });
  call.run(false, [&] {
    const PointLocator locator(shape->geometry, call.options());
    for (std::size_t i = 0; i < asked.size(); ++i) {
      (*places)[i] = static_cast<std::int8_t>(static_cast<int>(locator.locate(asked[i])) - 1);
    }
  });
  return nb::cast(
      nb::ndarray<nb::numpy, std::int8_t, nb::ndim<1>>(places->data(), {places->size()}, owner));
}

nb::dict check_of(const SumCheck& check) {
  nb::dict dict;
  nb::list faults;
  for (const Fault& fault : check.faults) faults.append(fault_of(fault));
  nb::list examples;
  for (const Disagreement& example : check.examples) {
    examples.append(nb::make_tuple(exact_point(example.at), example.in_result));
  }
  const char* const proofs[] = {"holds", "refuted", "not tried"};
  dict["ok"] = check.ok();
  dict["proof"] = proofs[static_cast<int>(check.proof)];
  dict["points"] = check.points;
  dict["disagreements"] = check.disagreements;
  dict["examples"] = examples;
  dict["faults"] = faults;
  dict["thin_parts_differ"] = check.thin_parts_differ;
  return dict;
}

Affine affine_of(const std::vector<nb::object>& matrix) {
  if (matrix.size() != 6) {
    throw nb::value_error("matrix must have six numbers: a, b, d, e, xoff, yoff");
  }
  const auto number = [&matrix](std::size_t i) { return require_number(matrix[i], "matrix"); };
  return {number(0), number(1), number(4), number(2), number(3), number(5)};
}

void bind_pairs(nb::module_& m) {
  m.def(
      "penetration_depth",
      [](nb::handle a, nb::handle b, const std::string& on_error, MINKSUM_SETTINGS) {
        Call call(MINKSUM_SETTING_VALUES);
        if (forgives(on_error)) call.forgive();
        return ask_pairs<std::optional<Depth>>(
            call, a, b,
            [](const Geometry& x, const Geometry& y, const Options& options) {
              return penetration_depth(x, y, options);
            },
            depth_of);
      },
      "a"_a.none(), "b"_a.none(), nb::kw_only(), MINKSUM_ON_ERROR_ARG, MINKSUM_SETTING_ARGS,
      nb::sig(signature("penetration_depth", "a: GeometryLike, b: GeometryLike", kOnError,
                        "typing.Any")),
      "Return how two sets stand to each other: a `Depth` with the shortest move of b after which "
      "they touch. None if one of them is empty.");
  m.def(
      "time_of_impact",
      [](nb::handle a, nb::handle b, nb::handle direction, const std::string& on_error,
         MINKSUM_SETTINGS) {
        Call call(MINKSUM_SETTING_VALUES);
        if (forgives(on_error)) call.forgive();
        const Point along = require_point(direction, "direction");
        return ask_pairs<std::optional<Rational>>(
            call, a, b,
            [&along](const Geometry& x, const Geometry& y, const Options& options) {
              return time_of_impact(x, y, along, options);
            },
            [](const std::optional<Rational>& when) -> nb::object {
              return when ? exact_number(*when) : nb::none();
            });
      },
      "a"_a.none(), "b"_a.none(), "direction"_a, nb::kw_only(), MINKSUM_ON_ERROR_ARG,
      MINKSUM_SETTING_ARGS,
      nb::sig(signature("time_of_impact",
                        "a: GeometryLike, b: GeometryLike, direction: tuple[Number, Number]",
                        kOnError, "typing.Any")),
      "Return the smallest factor f >= 0 for which b, moved by f times the direction, meets a; "
      "None if there is none.");
  m.def(
      "covers",
      [](nb::handle b, nb::handle a, const std::string& on_error, MINKSUM_SETTINGS) {
        Call call(MINKSUM_SETTING_VALUES);
        if (forgives(on_error)) call.forgive();
        return ask_pairs<bool>(
            call, b, a,
            [](const Geometry& x, const Geometry& y, const Options& options) {
              return contains(x.region, y.region, options);
            },
            [](bool value) { return nb::bool_(value); });
      },
      "b"_a.none(), "a"_a.none(), nb::kw_only(), MINKSUM_ON_ERROR_ARG, MINKSUM_SETTING_ARGS,
      nb::sig(signature("covers", "b: GeometryLike, a: GeometryLike", kOnError, "typing.Any")),
      "Return whether the area of a lies within that of b.");
  m.def(
      "check_sum",
      [](nb::handle result, nb::handle p, nb::handle q, nb::handle within, MINKSUM_SETTINGS) {
        Call call(MINKSUM_SETTING_VALUES);
        const ShapePtr sum = operand_of(result);
        const ShapePtr first = operand_of(p);
        const ShapePtr second = operand_of(q);
        if (!sum || !first || !second) throw nb::type_error("None is not a geometry");
        (void)common_srid(*first, *second);
        (void)common_srid(*sum, *first);
        (void)common_srid(*sum, *second);
        CheckOptions how;
        how.within = require_number(within, "within");
        SumCheck check;
        call.run(false, [&] {
          check = check_sum(sum->geometry, first->geometry, second->geometry, how, call.options());
        });
        return check_of(check);
      },
      "result"_a, "p"_a, "q"_a, nb::kw_only(), "within"_a = 0, MINKSUM_SETTING_ARGS,
      nb::sig(signature("check_sum", "result: GeometryLike, p: GeometryLike, q: GeometryLike",
                        "within: Number = 0, ", "dict[str, typing.Any]")),
      "Verify or refute that `result` is the sum of p and q, by methods that share nothing with "
      "`minkowski_sum`. Returns a dict with 'ok', 'proof' and what speaks against the result.");
}

}  // namespace

void bind_measures(nb::module_& m) {
  m.def("area", area_of, "a"_a.none(), nb::kw_only(), "exact"_a = false,
        nb::sig("def area(a: GeometryLike, *, exact: bool = False) -> typing.Any"),
        "Return the area as a float, or exactly.");
  m.def("bounds", bounds_of, "a"_a.none(), nb::kw_only(), "exact"_a = false,
        nb::sig("def bounds(a: GeometryLike, *, exact: bool = False) -> typing.Any"),
        "Return (xmin, ymin, xmax, ymax), or None for the empty set.");
  m.def("locate", locate_all, "a"_a, "points"_a, nb::kw_only(), MINKSUM_SETTING_ARGS,
        nb::sig(signature("locate", "a: GeometryLike, points: typing.Iterable[typing.Any]", "",
                          "numpy.typing.NDArray[numpy.int8]")),
        "Return for each point -1 if it is outside, 0 on the boundary, and 1 inside, exactly.");
  m.def(
      "validate",
      [](nb::handle a, std::size_t max_faults) {
        const ShapePtr shape = operand_of(a);
        if (!shape) throw nb::type_error("None is not a geometry");
        Call call;
        std::vector<Fault> faults;
        call.run(is_small(shape->geometry),
                 [&] { faults = validate(shape->geometry.region, max_faults, call.options()); });
        nb::list list;
        for (const Fault& fault : faults) list.append(fault_of(fault));
        return list;
      },
      "a"_a, "max_faults"_a = 100,
      nb::sig("def validate(a: GeometryLike, max_faults: int = 100) -> "
              "list[dict[str, typing.Any]]"),
      "Return the faults of a geometry's polygons: dicts with 'message', 'place' and 'other' "
      "(polygon, ring, vertex) and 'at', the exact location.");
  m.def(
      "is_valid",
      [](nb::handle a) {
        return ask_each<bool>(
            a,
            [](const Shape& s, const Options& options) {
              return validate(s.geometry.region, 1, options).empty();
            },
            [](bool value) { return nb::bool_(value); });
      },
      "a"_a.none(), nb::sig("def is_valid(a: GeometryLike) -> typing.Any"),
      "Return whether all polygons are valid operands.");
  m.def(
      "affine_transform",
      [](nb::handle a, const std::vector<nb::object>& matrix) {
        const Affine map = affine_of(matrix);
        Call call;
        return apply(call, a, [&map](const Geometry& g, const Options& options) {
          return resolve_with_tight_places(transform(g, map, options), options);
        });
      },
      "a"_a.none(), "matrix"_a,
      nb::sig("def affine_transform(a: GeometryLike, matrix: typing.Sequence[Number]) -> "
              "Geometry | GeometryArray | None"),
      "Return the exact image under (x, y) -> (a x + b y + xoff, d x + e y + yoff); the matrix is "
      "[a, b, d, e, xoff, yoff], as in shapely.affinity. Places without play of a no-fit polygon "
      "are kept.");
  bind_pairs(m);
}

}  // namespace minksum::python
