// Makes configuration-space obstacles and free space, slice by slice.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "machine/cancellation.hpp"
#include "machine/in_order.hpp"
#include "machine/part_progress.hpp"
#include "minksum/configuration_space.hpp"
#include "minksum/prepared_region.hpp"
#include "minksum/resolve.hpp"
#include "operations/configuration_space/free_part.hpp"
#include "operations/sum/fixed_sum.hpp"
#include "overlay/boolean.hpp"
#include "overlay/resolve_area.hpp"
#include "region/boxes.hpp"
#include "validation/fault.hpp"

namespace minksum {

struct ConfigurationSpace::State {
  ConfigurationOptions setting;
  Options options;
  Region robot;  ///< with its reference point at the origin
  Rational radius;
  Geometry obstacles;
  Region workspace;
  Geometry forbidden;                 ///< obstacles, and the outside of the workspace
  PreparedRegion prepared{Region()};  ///< the area of `forbidden`
};

namespace {

/// Returns an upper bound on the distances from the origin.
Rational radius_of(const Region& robot, const Options& options) {
  Cancellation cancellation(options, Stage::kSearch);
  Rational squared;
  Rational largest;  // coordinate
  for (std::size_t v = 0; v < robot.vertex_count(); ++v) {
    const Point at = robot.point(v);
    cancellation.check(8 * work_of(at));
    squared = std::max(squared, at.x * at.x + at.y * at.y);
    largest = std::max({largest, at.x, -at.x, at.y, -at.y});
  }
  const double root = std::sqrt(squared.to_double());
  for (const double candidate : {root, root * (1 + 0x1p-40)}) {
    if (!std::isfinite(candidate)) break;
    if (const Rational radius(candidate); radius * radius >= squared) return radius;
  }
  return largest * Rational(3, 2);
}

/// Returns −R(turn).
Region turned_mirror(const Region& robot, const Turn& turn, const Options& options) {
  return transform(robot, Affine::scaling(Rational(-1)).after(turn.map()), options);
}

/// Makes one slice. `shared` is for these obstacles, or null.
Slice make_slice(const ConfigurationSpace::State& state, const Box& boundary, const Turn& turn,
                 const SharedRaster* shared, bool with_free, const Options& options,
                 Workspace& workspace) {
  const auto begin = std::chrono::steady_clock::now();
  Slice slice;
  slice.turn = turn;
  SumRequest request(part_of(options));
  Geometry tight;
  if (with_free && state.options.tight.value_or(false)) request.want_tight_places(tight);
  Region mirrored = turned_mirror(state.robot, turn, options);
  if (state.forbidden.has_thin_parts()) {
    sum_of_geometries(state.forbidden, {std::move(mirrored), {}, {}}, request, workspace,
                      slice.obstacles);
  } else {
    minkowski_sum(state.prepared, mirrored, shared, request, workspace, slice.obstacles.region);
  }
  if (with_free) {
    slice.free.region = overlay::subtract(as_region(boundary), slice.obstacles.region, options);
    slice.free.polylines = std::move(tight.polylines);
    slice.free.points = std::move(tight.points);
    // A polyline may pass through a corner of the area. A resolved one ends there.
    if (slice.free.has_thin_parts()) slice.free = resolve(slice.free, part_of(options));
  }
  slice.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return slice;
}

}  // namespace

ConfigurationSpace::ConfigurationSpace(const Geometry& robot, const Geometry& obstacles,
                                       const ConfigurationOptions& setting,
                                       const Options& options) {
  State state;
  state.setting = setting;
  state.options = options;
  state.options.memory = nullptr;  // many threads may make slices
  const Point& reference = setting.reference;
  state.robot = transform(resolve_area(robot, 0, options).region,
                          Affine::translation(-reference.x, -reference.y), options);
  if (state.robot.empty()) refuse_operand("a robot needs an area", 0);
  state.obstacles = resolve(obstacles, options, 1);
  // minkowski_sum finds only tight places between areas, and none may be missing.
  if (options.tight.value_or(false) && state.obstacles.has_thin_parts()) {
    refuse_operand("places without play among obstacles with thin parts are not known", 1);
  }
  if (setting.workspace) {
    state.workspace = resolve_area(*setting.workspace, 2, options).region;
    if (state.workspace.empty()) refuse_operand("a workspace needs an area", 2);
  }
  set_up(std::move(state));
}

void ConfigurationSpace::set_up(State state) {
  const Options& options = state.options;
  state.radius = radius_of(state.robot, options);
  state.forbidden = state.obstacles;
  if (state.setting.workspace) {
    // If the robot is inside the workspace, its reference point is in the boundary. A robot with
    // its reference point there lies in the box widened by twice the radius. So the frame's outer
    // side is never seen.
    boundary_ = widened(*bounding_box(state.workspace, options), state.radius);
    const Region frame = as_region(widened(boundary_, state.radius * Rational(2)));
    const Geometry both[] = {state.obstacles,
                             {overlay::subtract(frame, state.workspace, options), {}, {}}};
    state.forbidden = overlay::unite(both, options);
  } else {
    Cancellation cancellation(options, Stage::kSearch);
    const auto box = bounding_box(state.obstacles, cancellation);
    boundary_ = widened(box ? *box : Box{}, state.radius * Rational(2));
  }
  state.prepared = PreparedRegion(state.forbidden.region, options);
  state_ = std::make_shared<const State>(std::move(state));
}

ConfigurationSpace ConfigurationSpace::grown(const Region& by) const {
  ConfigurationSpace space = *this;
  State state = *state_;
  state.robot = minkowski_sum(state.robot, by, part_of(state.options));
  space.set_up(std::move(state));
  return space;
}

void ConfigurationSpace::include(const Point& point) {
  if (state_->setting.workspace) return;
  std::optional<Box> box = boundary_;
  const Rational& by = state_->radius;
  enlarge(box, {point.x - by, point.y - by});
  enlarge(box, {point.x + by, point.y + by});
  boundary_ = *box;
}

const Rational& ConfigurationSpace::radius() const { return state_->radius; }
const Region& ConfigurationSpace::robot() const { return state_->robot; }

bool ConfigurationSpace::overlaps_obstacle(const Region& given) const {
  const Options& options = state_->options;
  const Region region = resolve_area(Geometry(given), -1, part_of(options)).region;
  Cancellation cancellation(options, Stage::kSearch);
  const Geometry& obstacles = state_->obstacles;
  if (!overlay::intersect(obstacles.region, region, options).empty()) return true;
  for (std::size_t p = 0; p < region.polygon_count() && obstacles.has_thin_parts(); ++p) {
    const FreePart part(Region(region.polygon(p)), options);
    const auto enters = [&](const Point& a, const Point& b) {
      return part.meets(a, b, Location::kInside, cancellation);
    };
    for (const Polyline& line : obstacles.polylines) {
      if (std::adjacent_find(line.begin(), line.end(), enters) != line.end()) return true;
    }
    for (const Point& point : obstacles.points) {
      if (enters(point, point)) return true;
    }
  }
  return false;
}

Slice ConfigurationSpace::slice(const Turn& turn, bool with_free) const {
  Workspace workspace;
  return slice(turn, with_free, workspace);
}

Slice ConfigurationSpace::slice(const Turn& turn, bool with_free, Workspace& workspace) const {
  return make_slice(*state_, boundary_, turn, nullptr, with_free, state_->options, workspace);
}

void ConfigurationSpace::for_each_slice(
    std::span<const Turn> turns, bool with_free,
    const std::function<void(std::size_t, Slice&)>& finish,
    const std::function<void(std::size_t, Slice&)>& visit) const {
  // For fewer slices, sharing would take longer than it saves.
  constexpr std::size_t kManySlices = 8;
  std::optional<SharedRaster> shared;
  if (turns.size() >= kManySlices && !state_->forbidden.region.empty() &&
      !state_->forbidden.has_thin_parts()) {
    const Region typical = turned_mirror(state_->robot, turns.front(), state_->options);
    shared = share_raster(state_->prepared, typical, 2 * state_->radius.to_double(),
                          SumRequest(part_of(state_->options)));
  }
  PartProgress progress(state_->options, turns.size());
  const auto make = [&](std::size_t i, Workspace& workspace) {
    Slice slice = make_slice(*state_, boundary_, turns[i], shared ? &*shared : nullptr, with_free,
                             progress.options(), workspace);
    if (finish) finish(i, slice);
    progress.finish_part();
    return slice;
  };
  for_each_in_order<Slice, Workspace>(turns.size(), state_->options.threads, progress.options(),
                                      make, visit);
}

std::vector<Slice> ConfigurationSpace::slices(std::span<const Turn> turns, bool with_free) const {
  std::vector<Slice> result;
  result.reserve(turns.size());
  for_each_slice(turns, with_free, {},
                 [&](std::size_t, Slice& slice) { result.push_back(std::move(slice)); });
  return result;
}

}  // namespace minksum
