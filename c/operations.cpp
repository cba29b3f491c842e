// Implements operations of the C interface: sums, uses of sums, and questions about sets.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "handles.hpp"

using namespace minksum;     // NOLINT(google-build-using-namespace)
using namespace minksum::c;  // NOLINT(google-build-using-namespace)

namespace {

using Handle = minksum_geometry;

/// A function of two sets.
template <class Operation>
minksum_status binary(const Handle* a, const Handle* b, const minksum_options* options,
                      Handle** result, minksum_error* error, Operation operation) {
  return made(result, error,
              [&] { return Geometry(operation(value_of(a), value_of(b), options_of(options))); });
}

/// Runs a boolean operation of areas, each of which is read by the fill rule.
template <class Operation>
minksum_status of_areas(const Handle* a, const Handle* b, const minksum_options* options,
                        Handle** result, minksum_error* error, Operation operation) {
  return made(result, error, [&] {
    return Geometry(operation(value_of(a).region, value_of(b).region, options_of(options)));
  });
}

std::optional<Rational> impact(const Handle* a, const Handle* b, const double direction[2],
                               const minksum_options* options) {
  require(direction != nullptr, "an argument is NULL");
  return time_of_impact(value_of(a), value_of(b), {direction[0], direction[1]},
                        options_of(options));
}

}  // namespace

minksum_status minksum_sum(const Handle* a, const Handle* b, const minksum_options* options,
                           Handle** result, minksum_error* error) {
  return binary(a, b, options, result, error,
                [](const Geometry& p, const Geometry& q, const Options& o) {
                  return minkowski_sum(p, q, o);
                });
}
minksum_status minksum_dilate(const Handle* a, const Handle* b, const minksum_options* options,
                              Handle** result, minksum_error* error) {
  return binary(a, b, options, result, error, dilate);
}
minksum_status minksum_erode(const Handle* a, const Handle* b, const minksum_options* options,
                             Handle** result, minksum_error* error) {
  return binary(a, b, options, result, error, erode);
}
minksum_status minksum_open(const Handle* a, const Handle* b, const minksum_options* options,
                            Handle** result, minksum_error* error) {
  return binary(a, b, options, result, error, minksum::open);
}
minksum_status minksum_close(const Handle* a, const Handle* b, const minksum_options* options,
                             Handle** result, minksum_error* error) {
  return binary(a, b, options, result, error, minksum::close);
}

minksum_status minksum_unite(const Handle* a, const Handle* b, const minksum_options* options,
                             Handle** result, minksum_error* error) {
  return made(result, error, [&] {
    const std::array<Geometry, 2> both{value_of(a), value_of(b)};
    return unite(both, options_of(options));
  });
}
minksum_status minksum_intersect(const Handle* a, const Handle* b, const minksum_options* options,
                                 Handle** result, minksum_error* error) {
  return of_areas(a, b, options, result, error, intersect);
}
minksum_status minksum_subtract(const Handle* a, const Handle* b, const minksum_options* options,
                                Handle** result, minksum_error* error) {
  return of_areas(a, b, options, result, error, subtract);
}
minksum_status minksum_symmetric_difference(const Handle* a, const Handle* b,
                                            const minksum_options* options, Handle** result,
                                            minksum_error* error) {
  return of_areas(a, b, options, result, error, symmetric_difference);
}

minksum_status minksum_prepare(const Handle* geometry, const minksum_options* options,
                               minksum_prepared** result, minksum_error* error) {
  return made(result, error, [&] {
    const Geometry& given = value_of(geometry);
    require(!given.has_thin_parts(), "what is prepared has no polylines and points");
    return PreparedRegion(given.region, options_of(options));
  });
}
void minksum_prepared_free(minksum_prepared* prepared) { delete prepared; }
minksum_status minksum_sum_prepared(const minksum_prepared* a, const minksum_prepared* b,
                                    const minksum_options* options, Handle** result,
                                    minksum_error* error) {
  return made(result, error, [&] {
    return Geometry(minkowski_sum(value_of(a), value_of(b), options_of(options)));
  });
}

void minksum_offset_options_init(minksum_offset_options* offset_options) {
  if (offset_options == nullptr) return;
  *offset_options = {MINKSUM_JOIN_ROUND, MINKSUM_CAP_ROUND, MINKSUM_NEAREST,
                     OffsetOptions().miter_limit.to_double(), 0};
}
minksum_status minksum_offset(const Handle* geometry, double distance,
                              const minksum_offset_options* offset_options,
                              const minksum_options* options, Handle** result,
                              minksum_error* error) {
  return made(result, error, [&] {
    OffsetOptions shape;
    if (offset_options != nullptr) {
      shape.join = as<Join>(offset_options->join);
      shape.cap = as<Cap>(offset_options->cap);
      shape.side = as<RoundingSide>(offset_options->side);
      shape.miter_limit = offset_options->miter_limit;
      if (offset_options->tolerance != 0) shape.tolerance = offset_options->tolerance;
    }
    return offset(value_of(geometry), distance, shape, options_of(options));
  });
}
minksum_status minksum_disc(double radius, double tolerance, minksum_side side, Handle** result,
                            minksum_error* error) {
  return made(result, error,
              [&] { return Geometry(disc(radius, tolerance, as<RoundingSide>(side))); });
}

minksum_status minksum_resolve(const Handle* geometry, const minksum_options* options,
                               Handle** result, minksum_error* error) {
  return made(result, error, [&] { return resolve(value_of(geometry), options_of(options)); });
}
minksum_status minksum_round(const Handle* geometry, minksum_side side, int decimals,
                             const minksum_options* options, Handle** result,
                             minksum_error* error) {
  return made(result, error, [&] {
    RoundOptions target;
    target.side = as<RoundingSide>(side);
    if (decimals >= 0) target.decimals = decimals;
    const Geometry& given = value_of(geometry);
    if (given.has_thin_parts()) return round_with_tight_places(given, target, options_of(options));
    return minksum::round(given, target, options_of(options));
  });
}
minksum_status minksum_transform(const Handle* geometry, const double m[6],
                                 const minksum_options* options, Handle** result,
                                 minksum_error* error) {
  return made(result, error, [&] {
    require(m != nullptr, "an argument is NULL");
    const Affine map{m[0], m[1], m[2], m[3], m[4], m[5]};
    return transform(value_of(geometry), map, options_of(options));
  });
}

minksum_status minksum_validate(const Handle* geometry, const minksum_options* options,
                                minksum_error* faults, size_t capacity, size_t* count,
                                minksum_error* error) {
  return guarded(error, [&] {
    std::size_t& found_count = result_at(count);
    require(faults != nullptr || capacity == 0, "an argument is NULL");
    const auto found = validate(value_of(geometry).region, capacity, options_of(options));
    for (const Fault& fault : found) {
      const Error cause(ErrorCode::kBadInput, to_string(fault), fault.place);
      tell(&faults[found_count++], MINKSUM_BAD_INPUT, cause.what(), &cause);
    }
  });
}
minksum_status minksum_area(const Handle* geometry, double* area, minksum_error* error) {
  return guarded(error, [&] {
    double& found = result_at(area);
    found = approximate_area(value_of(geometry).region);
  });
}
minksum_status minksum_bounding_box(const Handle* geometry, double box[4], int* found,
                                    minksum_error* error) {
  return guarded(error, [&] {
    if (box != nullptr) std::fill_n(box, 4, 0.0);
    int& is_there = result_at(found);
    require(box != nullptr, "the result has nowhere to go");
    const auto exact = bounding_box(value_of(geometry).region);
    is_there = exact ? 1 : 0;
    const Box sides = exact.value_or(Box{});
    box[0] = sides.min.x.to_double();
    box[1] = sides.min.y.to_double();
    box[2] = sides.max.x.to_double();
    box[3] = sides.max.y.to_double();
  });
}

minksum_status minksum_locator_new(const Handle* geometry, const minksum_options* options,
                                   minksum_locator** result, minksum_error* error) {
  return made(result, error, [&] { return PointLocator(value_of(geometry), options_of(options)); });
}
void minksum_locator_free(minksum_locator* locator) { delete locator; }
minksum_status minksum_locate(const minksum_locator* locator, double x, double y,
                              minksum_location* location, minksum_error* error) {
  return guarded(error, [&] {
    minksum_location& found = result_at(location);
    found = static_cast<minksum_location>(value_of(locator).locate({x, y}));
  });
}

minksum_status minksum_penetration_depth(const Handle* a, const Handle* b,
                                         const minksum_options* options, minksum_depth* depth,
                                         minksum_error* error) {
  return guarded(error, [&] {
    minksum_depth& answer = result_at(depth);
    const auto found = penetration_depth(value_of(a), value_of(b), options_of(options));
    if (!found) return;
    answer = {1,
              found->overlapping ? 1 : 0,
              {found->vector.x.to_double(), found->vector.y.to_double()},
              found->distance};
  });
}
minksum_status minksum_depth_vector(const Handle* a, const Handle* b,
                                    const minksum_options* options, Handle** result,
                                    minksum_error* error) {
  return binary(a, b, options, result, error,
                [](const Geometry& p, const Geometry& q, const Options& o) {
                  const auto found = penetration_depth(p, q, o);
                  return found ? Geometry({}, {}, {found->vector}) : Geometry();
                });
}
minksum_status minksum_time_of_impact(const Handle* a, const Handle* b, const double direction[2],
                                      const minksum_options* options, double* factor, int* found,
                                      minksum_error* error) {
  return guarded(error, [&] {
    if (factor != nullptr) *factor = 0;
    int& is_there = result_at(found);
    double& answer = result_at(factor);
    const auto time = impact(a, b, direction, options);
    if (!time) return;
    is_there = 1;
    answer = time->to_double();
  });
}
minksum_status minksum_impact_factor(const Handle* a, const Handle* b, const double direction[2],
                                     const minksum_options* options, Handle** result,
                                     minksum_error* error) {
  return made(result, error, [&] {
    const auto time = impact(a, b, direction, options);
    return time ? Geometry({}, {}, {{*time, 0}}) : Geometry();
  });
}

minksum_status minksum_check_sum(const Handle* result, const Handle* a, const Handle* b,
                                 double within, const minksum_options* options,
                                 minksum_sum_check* check, minksum_error* error) {
  return guarded(error, [&] {
    minksum_sum_check& answer = result_at(check);
    CheckOptions how;
    how.within = within;
    const SumCheck found =
        check_sum(value_of(result), value_of(a), value_of(b), how, options_of(options));
    const int proved = found.proof == Proof::kHolds ? 1 : found.proof == Proof::kRefuted ? 0 : -1;
    answer = {found.ok() ? 1 : 0, found.faults.size(), found.points, found.disagreements, proved};
  });
}
