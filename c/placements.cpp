// Implements the C interface for placing parts and for robots.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <span>
#include <vector>

#include "handles.hpp"

using namespace minksum;     // NOLINT(google-build-using-namespace)
using namespace minksum::c;  // NOLINT(google-build-using-namespace)

namespace {

std::optional<Point> point_of(const double reference[2]) {
  if (reference == nullptr) return std::nullopt;
  return Point{reference[0], reference[1]};
}

void set(const minksum_space_options* given, ConfigurationOptions& setting) {
  if (given == nullptr) return;
  setting.reference = {given->reference[0], given->reference[1]};
  if (given->workspace != nullptr) setting.workspace = given->workspace->value;
}

double tolerance_of(const minksum_space_options* given) {
  minksum_space_options standard;
  minksum_space_options_init(&standard);
  return given != nullptr ? given->tolerance : standard.tolerance;
}

/// The waypoints as pairs of points: the placement, and cosine and sine of the angle.
std::unique_ptr<minksum_geometry> exact_path(const Reach& found) {
  auto made = std::make_unique<minksum_geometry>();
  for (const Waypoint& waypoint : found.path) {
    made->value.points.push_back(waypoint.at);
    made->value.points.push_back(waypoint.turn.direction());
  }
  return made;
}

}  // namespace

minksum_status minksum_no_fit_polygon(const minksum_geometry* fixed, const minksum_geometry* moving,
                                      const double reference[2], const minksum_options* options,
                                      minksum_geometry** result, minksum_error* error) {
  return made(result, error, [&] {
    return no_fit_polygon(value_of(fixed), value_of(moving), point_of(reference),
                          options_of(options));
  });
}
minksum_status minksum_inner_fit_polygon(const minksum_geometry* bin, const minksum_geometry* part,
                                         const double reference[2], const minksum_options* options,
                                         minksum_geometry** result, minksum_error* error) {
  return made(result, error, [&] {
    return inner_fit_polygon(value_of(bin), value_of(part), point_of(reference),
                             options_of(options));
  });
}

minksum_status minksum_contacts(const minksum_geometry* no_fit, const double* xy, size_t n,
                                int* contacts, const minksum_options* options,
                                minksum_error* error) {
  return guarded(error, [&] {
    require((xy != nullptr && contacts != nullptr) || n == 0, "an argument is NULL");
    const Geometry& placements = value_of(no_fit);
    Options of_results = options_of(options);
    of_results.fill = FillRule::kAutomatic;
    of_results.regularize = false;
    const PointLocator area({placements.region, {}, {}}, of_results);
    const PointLocator tight({{}, placements.polylines, placements.points}, of_results);
    std::fill_n(contacts, n, 0);
    for (std::size_t i = 0; i < 2 * n; ++i) {
      if (std::isfinite(xy[i])) continue;
      Culprit culprit;
      culprit.vertex = i / 2;
      throw Error(ErrorCode::kBadInput, "a placement is not finite", culprit);
    }
    for (std::size_t i = 0; i < n; ++i) {
      if (i % 256 == 0 && of_results.progress && !of_results.progress({Stage::kSearch})) {
        std::fill_n(contacts, i, 0);
        throw Error(ErrorCode::kCancelled, "cancelled", {}, to_string(Stage::kSearch));
      }
      const Point at{xy[2 * i], xy[2 * i + 1]};
      const Location place = area.locate(at);
      const bool touching =
          place == Location::kBoundary || tight.locate(at) == Location::kBoundary;
      contacts[i] = touching                       ? MINKSUM_TOUCHING
                    : place == Location::kOutside ? MINKSUM_FREE
                                                  : MINKSUM_OVERLAPPING;
    }
  });
}

minksum_status minksum_no_fit_table_new(const minksum_geometry* const* parts, size_t count,
                                        int turns, const minksum_options* options,
                                        minksum_no_fit_table** result, minksum_error* error) {
  return made(result, error, [&] {
    require(parts != nullptr || count == 0, "an argument is NULL");
    std::vector<Geometry> copies;
    for (const minksum_geometry* part : std::span(parts, count)) copies.push_back(value_of(part));
    return NoFitTable(copies, turns, options_of(options));
  });
}
void minksum_no_fit_table_free(minksum_no_fit_table* table) { delete table; }
minksum_status minksum_no_fit_table_at(const minksum_no_fit_table* table, size_t fixed,
                                       int fixed_turn, size_t moving, int moving_turn,
                                       minksum_geometry** result, minksum_error* error) {
  return made(result, error, [&] {
    return value_of(table).at({fixed, fixed_turn}, {moving, moving_turn});
  });
}

void minksum_space_options_init(minksum_space_options* space_options) {
  if (space_options == nullptr) return;
  *space_options = {{0, 0}, nullptr, ReachOptions().tolerance};
}

minksum_status minksum_space_new(const minksum_geometry* robot, const minksum_geometry* obstacles,
                                 const minksum_space_options* space_options,
                                 const minksum_options* options, minksum_space** result,
                                 minksum_error* error) {
  if (result == nullptr) return tell(error, MINKSUM_BAD_INPUT, "the result has nowhere to go");
  *result = nullptr;
  return guarded(error, [&] {
    ConfigurationOptions setting;
    set(space_options, setting);
    const double tolerance = tolerance_of(space_options);
    static_cast<void>(nearest_turn(0, tolerance));  // refuses a bad one now, not at the first slice
    *result = new minksum_space{
        ConfigurationSpace(value_of(robot), value_of(obstacles), setting, options_of(options)),
        tolerance};
  });
}
void minksum_space_free(minksum_space* space) { delete space; }
minksum_status minksum_space_slice(const minksum_space* space, double degrees,
                                   minksum_geometry** obstacles, minksum_geometry** free_space,
                                   minksum_error* error) {
  if (free_space != nullptr) *free_space = nullptr;
  Geometry free;
  const minksum_status status = made(obstacles, error, [&] {
    const Turn turn = nearest_turn(degrees, (value_of(space), space->tolerance));
    Slice slice = space->value.slice(turn, free_space != nullptr);
    free = std::move(slice.free);
    return std::move(slice.obstacles);
  });
  if (status != MINKSUM_OK || free_space == nullptr) return status;
  const minksum_status second = made(free_space, error, [&] { return std::move(free); });
  if (second == MINKSUM_OK) return second;
  minksum_geometry_free(*obstacles);
  *obstacles = nullptr;
  return second;
}

minksum_status minksum_find_path(const minksum_geometry* robot, const minksum_geometry* obstacles,
                                 minksum_configuration from, minksum_configuration to,
                                 size_t angles, int certain,
                                 const minksum_space_options* space_options,
                                 const minksum_options* options, minksum_reach* result,
                                 minksum_error* error) {
  return guarded(error, [&] {
    minksum_reach& answer = result_at(result);
    ReachOptions setting;
    set(space_options, setting);
    setting.angles = angles;
    setting.certain = certain != 0;
    setting.tolerance = tolerance_of(space_options);
    const Reach found =
        reach(value_of(robot), value_of(obstacles), {{from.x, from.y}, from.degrees},
              {{to.x, to.y}, to.degrees}, setting, options_of(options));
    if (!found.path.empty()) {
      std::unique_ptr<minksum_geometry> exact = exact_path(found);
      answer.path = static_cast<minksum_configuration*>(
          std::calloc(found.path.size(), sizeof(minksum_configuration)));
      if (answer.path == nullptr) throw std::bad_alloc();
      answer.exact = exact.release();
    }
    for (const Waypoint& waypoint : found.path) {
      answer.path[answer.count++] = {waypoint.at.x.to_double(), waypoint.at.y.to_double(),
                                     waypoint.turn.degrees};
    }
    answer.reachable = found.reachable ? 1 : 0;
  });
}
void minksum_reach_free(minksum_reach* reach) {
  if (reach == nullptr) return;
  std::free(reach->path);
  minksum_geometry_free(reach->exact);
  *reach = {};
}
