// Computes single values.
#include <cmath>

#include "state.hpp"

namespace minksum::sql {

namespace {

/// Tells whether sums may take the operand's rings as they are. Other fill rules look at how rings
/// are directed, which a prepared region does not.
bool may_prepare(const Options& options) {
  return options.fill == FillRule::kAutomatic || options.fill == FillRule::kStrict;
}

/// Prepares an operand that came again, unless it has thin parts. Returns how many it prepared.
int prepare(Operand& operand, int index, const Options& options) {
  if (!operand.again || operand.unfit || operand.prepared || !may_prepare(options)) return 0;
  const Geometry set = resolve(operand.geometry, options, index);
  operand.unfit = set.has_thin_parts();
  if (!operand.unfit) operand.prepared.emplace(set.region, options);
  operand.prepared_by = options.fill;
  return operand.unfit ? 0 : 1;
}

bool is_prepared(const Operand& operand, const Options& options) {
  return operand.prepared && operand.prepared_by == options.fill;
}

/// Returns the sum by prepared operands where they came before.
Geometry sum(Operand& p, Operand& q, const Options& options, int& prepared) {
  prepared = prepare(p, 0, options) + prepare(q, 1, options);
  if (is_prepared(p, options) && is_prepared(q, options)) {
    return minkowski_sum(*p.prepared, *q.prepared, options);
  }
  if (!is_prepared(p, options) && !is_prepared(q, options)) {
    return minkowski_sum(p.geometry, q.geometry, options);
  }
  const bool first = is_prepared(p, options);
  const Operand& other = first ? q : p;
  if (other.geometry.has_thin_parts()) return minkowski_sum(p.geometry, q.geometry, options);
  Region region;
  Region made;
  const auto add = [&](const Region& given) {
    return first ? minkowski_sum(*p.prepared, given, options, *options.memory, made)
                 : minkowski_sum(given, *q.prepared, options, *options.memory, made);
  };
  // Most operands are valid, which this call finds out by itself.
  const Outcome outcome = add(other.geometry.region);
  if (outcome.ok()) return made;
  if (outcome.error->code() != ErrorCode::kBadInput || options.fill == FillRule::kStrict) {
    throw Error(*outcome.error);
  }
  return minkowski_sum(p.geometry, q.geometry, options);
}

Rational exactly(mink_bytes text, const char* argument) {
  const auto number = Rational::parse(view(text));
  if (number) return *number;
  throw Refusal{MINK_BAD_TEXT,
                std::string(argument) + " is not a number: \"" + std::string(view(text)) + '"',
                {},
                "Write a number such as 1.5, 1e-3 or 2/3."};
}

Rational finite(double number, const char* argument) {
  if (std::isfinite(number)) return Rational(number);
  throw Refusal{MINK_BAD_INPUT, std::string(argument) + " is infinite or NaN", {}, ""};
}

/// Returns a number that was given as float8 or as text.
Rational first_number(const mink_request& request, const char* argument) {
  return request.text && request.exact.data != nullptr ? exactly(request.exact, argument)
                                                       : finite(request.numbers[0], argument);
}

OffsetOptions shape_of(const mink_request& request) {
  OffsetOptions shape;
  shape.join =
      choose(request.join, "join_style", {Join::kRound, Join::kMiter, Join::kSquare, Join::kBevel});
  shape.cap = choose(request.cap, "cap_style", {Cap::kRound, Cap::kButt, Cap::kSquare});
  shape.side = side_of(request.side, "side");
  shape.miter_limit = finite(request.numbers[1], "miter_limit");
  if (request.numbers[2] != 0) shape.tolerance = finite(request.numbers[2], "tolerance");
  return shape;
}

Geometry disc_of(const mink_request& request, const Options& options) {
  const Rational radius = finite(request.numbers[0], "radius");
  OffsetOptions shape;
  const bool given = request.numbers[1] != 0;
  shape.tolerance = given ? finite(request.numbers[1], "tolerance") : radius / Rational(1000);
  shape.side = side_of(request.side, "side");
  if (radius.sign() <= 0 || shape.tolerance->sign() <= 0) {
    return disc(radius, *shape.tolerance, shape.side);  // which says what is wrong
  }
  // The same polygon as by `disc`, which cannot be cancelled.
  return offset(Geometry({}, {}, {Point{}}), radius, shape, options);
}

/// Returns the reference point that was given as a third operand.
std::optional<Point> reference(mink_state& state, const mink_request& request,
                               const Options& options) {
  if (request.operand_count < 3) return {};
  const Geometry& given = operand(state, request, 2, options).geometry;
  if (given.points.size() == 1 && given.polylines.empty() && given.region.empty()) {
    return given.points.front();
  }
  throw Refusal{MINK_BAD_INPUT, "the reference must be one point",
                "The place is operand 3, counted from 1."};
}

Geometry boolean(mink_operation operation, const Operand& a, const Operand& b,
                 const Options& options) {
  if (operation == MINK_UNION) {
    const std::array<Geometry, 2> both{a.geometry, b.geometry};
    return unite(both, options);
  }
  const Region& p = a.geometry.region;
  const Region& q = b.geometry.region;
  if (operation == MINK_INTERSECTION) return intersect(p, q, options);
  if (operation == MINK_DIFFERENCE) return subtract(p, q, options);
  return symmetric_difference(p, q, options);
}

/// Computes an operation whose answer is a set.
Geometry set_of(mink_state& state, const mink_request& request, const Options& options,
                int& prepared) {
  if (request.operation == MINK_DISC) return disc_of(request, options);
  Operand& a = operand(state, request, 0, options);
  if (request.operation == MINK_RESOLVE) return resolve(a.geometry, options, 0);
  if (request.operation == MINK_OFFSET) {
    return offset(a.geometry, first_number(request, "distance"), shape_of(request), options);
  }
  Operand& b = operand(state, request, 1, options);
  switch (request.operation) {
    case MINK_SUM:
      return sum(a, b, options, prepared);
    case MINK_ERODE:
      return erode(a.geometry, b.geometry, options);
    case MINK_OPEN:
      return open(a.geometry, b.geometry, options);
    case MINK_CLOSE:
      return close(a.geometry, b.geometry, options);
    case MINK_NO_FIT_POLYGON:
      return no_fit_polygon(a.geometry, b.geometry, reference(state, request, options), options);
    case MINK_INNER_FIT_POLYGON:
      return inner_fit_polygon(a.geometry, b.geometry, reference(state, request, options), options);
    case MINK_UNION:
    case MINK_INTERSECTION:
    case MINK_DIFFERENCE:
    case MINK_SYM_DIFFERENCE:
      return boolean(request.operation, a, b, options);
    default:
      throw Error(ErrorCode::kInternal, "an operation has no case");
  }
}

double in_range(double number) {
  if (std::isfinite(number)) return number;
  throw Error(ErrorCode::kLimitExceeded, "an answer is beyond the range of doubles");
}

mink_status depth_of(mink_state& state, const mink_request& request, mink_answer& answer,
                     const Options& options) {
  const Operand& a = operand(state, request, 0, options);
  const Operand& b = operand(state, request, 1, options);
  const auto depth = penetration_depth(a.geometry, b.geometry, options);
  if (!depth) return MINK_NULL;
  answer.truth = depth->overlapping;
  answer.numbers[0] = in_range(depth->distance);
  answer.numbers[1] = in_range(depth->vector.x.to_double());
  answer.numbers[2] = in_range(depth->vector.y.to_double());
  state.exact = depth->squared.to_string();
  answer.exact = {state.exact.data(), state.exact.size()};
  return MINK_OK;
}

mink_status impact_of(mink_state& state, const mink_request& request, mink_answer& answer,
                      const Options& options) {
  const Operand& a = operand(state, request, 0, options);
  const Operand& b = operand(state, request, 1, options);
  const Point direction{finite(request.numbers[0], "dx"), finite(request.numbers[1], "dy")};
  const auto time = time_of_impact(a.geometry, b.geometry, direction, options);
  if (!time) return MINK_NULL;
  answer.numbers[0] = in_range(time->to_double());
  return MINK_OK;
}

mink_status is_sum(mink_state& state, const mink_request& request, mink_answer& answer,
                   const Options& options) {
  const Operand& result = operand(state, request, 0, options);
  const Operand& p = operand(state, request, 1, options);
  const Operand& q = operand(state, request, 2, options);
  CheckOptions how;
  how.within = finite(request.numbers[0], "within");
  const SumCheck check = check_sum(result.geometry, p.geometry, q.geometry, how, options);
  answer.truth = check.ok();
  // That nothing speaks against a result proves nothing.
  return check.ok() && check.proof == Proof::kNotTried ? MINK_NULL : MINK_OK;
}

}  // namespace

}  // namespace minksum::sql

mink_status mink_compute(mink_state* state, const mink_request* request, mink_answer* answer,
                         mink_error* error) {
  using namespace minksum::sql;  // NOLINT(google-build-using-namespace)
  return guarded(error, [&] {
    state->srid.reset();
    answer->prepared = 0;
    const minksum::Options options = options_of(*state, *request);
    switch (request->operation) {
      case MINK_DEPTH:
        return depth_of(*state, *request, *answer, options);
      case MINK_IMPACT:
        return impact_of(*state, *request, *answer, options);
      case MINK_IS_SUM:
        return is_sum(*state, *request, *answer, options);
      default:
        break;
    }
    const minksum::RoundOptions target{side_of(request->round, "round"), {}};
    const minksum::Geometry set = set_of(*state, *request, options, answer->prepared);
    answer->sets[0] = write(*state, set, request->text, target, options, 0,
                            request->operation == MINK_NO_FIT_POLYGON);
    return MINK_OK;
  });
}
