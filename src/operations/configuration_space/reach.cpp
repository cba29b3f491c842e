// Searches a path through the graph of free parts of neighbouring slices.
#include "minksum/reach.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "operations/configuration_space/free_part.hpp"
#include "overlay/boolean.hpp"
#include "overlay/resolve_area.hpp"
#include "validation/fault.hpp"

namespace minksum {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

bool before(const Turn& a, const Turn& b) {
  return a.quarters != b.quarters ? a.quarters < b.quarters : a.tan_half < b.tan_half;
}

/// Returns the turns of all slices, counter-clockwise from 0, none twice.
std::vector<Turn> turns_of(const Turn& from, const Turn& to, const ReachOptions& setting) {
  std::vector<Turn> turns{from, to};
  const std::vector<Turn> even = full_turn(setting.angles, setting.tolerance);
  turns.insert(turns.end(), even.begin(), even.end());
  // Among equal turns an end's comes first, and stays.
  std::stable_sort(turns.begin(), turns.end(), before);
  const auto same = [](const Turn& a, const Turn& b) { return a.same_as(b); };
  turns.erase(std::unique(turns.begin(), turns.end(), same), turns.end());
  return turns;
}

/// Returns the tangent of half the angle from one turn counter-clockwise to another, or nothing for
/// half a turn.
std::optional<Rational> half_step(const Turn& from, const Turn& to) {
  const Point a = from.direction();
  const Point b = to.direction();
  const Rational below = Rational(1) + dot(a, b);
  if (below.sign() == 0) return std::nullopt;
  return cross(a, b) / below;
}

/// Returns by how much a robot of this radius must be grown, see `reach`.
Rational margin_of(const std::vector<Turn>& turns, const Rational& reach, double off) {
  // A degree is less than 0.01746 radians, and tan x < 1.001 x for x up to a degree.
  Rational largest(off * 0.0176);
  for (std::size_t i = 0; i < turns.size() && turns.size() > 1; ++i) {
    const auto half = half_step(turns[i], turns[(i + 1) % turns.size()]);
    if (!half || half->sign() <= 0) {
      refuse_input("to be certain, steps must be below half a turn: more angles are needed");
    }
    largest = std::max(largest, *half);
  }
  return reach * largest;
}

/// Returns an octagon that contains the disc. It cuts each corner of a square along a line |x| +
/// |y| = 17/12 r, which is more than √2 r.
Region octagon(const Rational& radius) {
  const Rational& r = radius;
  const Rational s = radius * Rational(5, 12);
  return Region(
      Polygon{{{r, -s}, {r, s}, {s, r}, {-s, r}, {-r, s}, {-r, -s}, {-s, -r}, {s, -r}}, {}});
}

/// A slice, taken apart.
struct FreeParts {
  Turn turn;
  std::vector<FreePart> parts;
  std::vector<Point> samples;  ///< a point strictly inside each part
};

FreeParts parts_of(const Slice& slice, const Options& options) {
  FreeParts result;
  result.turn = slice.turn;
  const Region& free = slice.free.region;
  for (const std::size_t polygon : free.polygons()) {
    Region alone(free.polygon(polygon));
    const Point any = alone.point(0);
    result.samples.push_back(point_within(alone, any, any, options));
    result.parts.emplace_back(std::move(alone), options);
  }
  return result;
}

double length_of(const std::vector<Point>& way) {
  double length = 0;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const Point step = minus(way[i], way[i - 1]);
    length += std::hypot(step.x.to_double(), step.y.to_double());
  }
  return length;
}

/// Searches the parts of all slices, and makes the path.
class Planner {
 public:
  Planner(std::vector<FreeParts> slices, const Configuration& from, const Configuration& to,
          const Rational& reach, const Options& options)
      : slices_(std::move(slices)),
        from_(from),
        to_(to),
        reach_(reach.to_double()),
        options_(options),
        cancellation_(options, Stage::kSearch) {
    for (const FreeParts& slice : slices_) finished_.emplace_back(slice.parts.size(), false);
  }

  [[nodiscard]] std::size_t part_count() const {
    std::size_t count = 0;
    for (const FreeParts& slice : slices_) count += slice.parts.size();
    return count;
  }
  [[nodiscard]] std::size_t slice_of(const Turn& turn) const {
    for (std::size_t i = 0; i < slices_.size(); ++i) {
      if (slices_[i].turn.same_as(turn)) return i;
    }
    throw Error(ErrorCode::kInternal, "a turn has no slice", {}, "reach");
  }

  /// Returns the path; empty if there is none.
  std::vector<Waypoint> find(std::size_t first, std::size_t last) {
    // The robot is there already, even if it has no play.
    if (first == last && from_.at == to_.at) return {{from_.at, slices_[first].turn}};
    for (std::size_t p = 0; p < slices_[first].parts.size(); ++p) {
      if (slices_[first].parts[p].contains(from_.at)) {
        offer({0, kNone, first, p, true, from_.at, {}});
      }
    }
    while (!open_.empty()) {
      cancellation_.check(16);
      std::pop_heap(open_.begin(), open_.end(), later);
      Step step = std::move(open_.back());
      open_.pop_back();
      if (step.slice == kNone) return path_to(step);
      if (finished_[step.slice][step.part]) continue;
      if (step.known || make_known(step)) finish(std::move(step), last);
    }
    return {};
  }

 private:
  /// A way to enter a part: from another part by a turn, or at the start. `slice` is kNone for the
  /// last step, which leads to the goal.
  struct Step {
    /// The cost of the way up to the turn and of the turn; a lower bound unless the way is known.
    double cost;
    std::size_t parent;  ///< index of the step before, in done_
    std::size_t slice;
    std::size_t part;
    bool known;              ///< whether the way is known
    Point at;                ///< where the robot turns
    std::vector<Point> way;  ///< the way in the parent's part, to `at`
    std::size_t number = 0;  ///< the order of offers: the first of equal costs is taken
  };
  static bool later(const Step& a, const Step& b) {
    return a.cost != b.cost ? a.cost > b.cost : a.number > b.number;
  }

  [[nodiscard]] const FreePart& part(const Step& step) const {
    return slices_[step.slice].parts[step.part];
  }
  void offer(Step step) {
    step.number = ++offered_;
    open_.push_back(std::move(step));
    std::push_heap(open_.begin(), open_.end(), later);
  }

  /// Finds out whether and where the robot can turn. Returns false if it cannot, or if it must
  /// first go somewhere. In that case the step is offered again with its cost.
  bool make_known(Step& step) {
    const Step& from = done_[step.parent];
    const FreePart& here = part(from);
    const FreePart& there = part(step);
    step.known = true;
    step.at = from.at;
    const Location location = there.locate(from.at);
    if (location == Location::kInside) return true;
    if (!joined(from, step)) return false;
    if (location == Location::kBoundary) return true;
    step.at = point_within(overlay::intersect(here.region(), there.region(), options_), from.at,
                           to_.at, options_);
    step.way = here.way(from.at, step.at, cancellation_);
    step.cost += length_of(step.way);
    offer(std::move(step));
    return false;
  }

  void finish(Step step, std::size_t last) {
    finished_[step.slice][step.part] = true;
    const std::size_t index = done_.size();
    done_.push_back(std::move(step));
    const Step& here = done_.back();
    if (here.slice == last && part(here).contains(to_.at)) {
      std::vector<Point> way = part(here).way(here.at, to_.at, cancellation_);
      const double cost = here.cost + length_of(way);
      offer({cost, index, kNone, kNone, true, to_.at, std::move(way)});
    }
    const std::size_t n = slices_.size();
    for (const std::size_t s : {(here.slice + 1) % n, (here.slice + n - 1) % n}) {
      const double angle =
          std::remainder(slices_[s].turn.degrees - slices_[here.slice].turn.degrees, 360) * 0.0175;
      const double cost = here.cost + std::abs(angle) * reach_;
      for (std::size_t p = 0; p < slices_[s].parts.size(); ++p) {
        cancellation_.check(8);
        if (!finished_[s][p]) offer({cost, index, s, p, false, {}, {}});
      }
    }
  }

  /// Tells whether the interiors meet.
  [[nodiscard]] bool joined(const Step& a, const Step& b) const {
    const FreePart& first = part(a);
    const FreePart& second = part(b);
    if (!first.box().meets(second.box())) return false;
    return second.locate(slices_[a.slice].samples[a.part]) == Location::kInside ||
           first.locate(slices_[b.slice].samples[b.part]) == Location::kInside ||
           !overlay::intersect(first.region(), second.region(), options_).empty();
  }

  [[nodiscard]] std::vector<Waypoint> path_to(const Step& goal) {
    std::vector<const Step*> steps{&goal};
    while (steps.back()->parent != kNone) steps.push_back(&done_[steps.back()->parent]);
    std::reverse(steps.begin(), steps.end());
    std::vector<Waypoint> path{{from_.at, slices_[steps[0]->slice].turn}};
    for (std::size_t i = 1; i < steps.size(); ++i) {
      append(part(*steps[i - 1]), steps[i]->way, path);
      if (steps[i]->slice == kNone) break;
      path.push_back({path.back().at, slices_[steps[i]->slice].turn});
    }
    return path;
  }
  /// Appends moves within a part, after one more test that each of them lies there.
  void append(const FreePart& within, const std::vector<Point>& way, std::vector<Waypoint>& path) {
    const Turn turn = path.back().turn;
    for (std::size_t i = 1; i < way.size(); ++i) {
      if (!within.sees(way[i - 1], way[i], cancellation_)) {
        throw Error(ErrorCode::kInternal, "a move leaves free space", {}, "reach");
      }
      path.push_back({way[i], turn});
    }
  }

  std::vector<FreeParts> slices_;
  const Configuration& from_;
  const Configuration& to_;
  double reach_;
  const Options& options_;
  Cancellation cancellation_;
  std::vector<std::vector<bool>> finished_;
  std::vector<Step> open_;  ///< a heap
  std::vector<Step> done_;
  std::size_t offered_ = 0;
};

/// Throws if the robot is not free at an end (operand 3 or 4).
void require_free(const ConfigurationSpace& space, const Configuration& end, const Turn& turn,
                  const ReachOptions& setting, const Options& options, int operand) {
  const Region placed =
      transform(space.robot(), Affine::translation(end.at.x, end.at.y).after(turn.map()), options);
  const std::string where = operand == 3 ? " at the start" : " at the goal";
  if (setting.workspace &&
      !overlay::contains(resolve_area(*setting.workspace, 2, options).region, placed, options)) {
    refuse_operand("the robot leaves the workspace" + where, operand);
  }
  if (space.overlaps_obstacle(placed)) {
    refuse_operand("the robot overlaps an obstacle" + where, operand);
  }
}

}  // namespace

Reach reach(const Geometry& robot, const Geometry& obstacles, const Configuration& from,
            const Configuration& to, const ReachOptions& setting, const Options& options) {
  const Turn first = nearest_turn(from.degrees, setting.tolerance);
  const Turn last = nearest_turn(to.degrees, setting.tolerance);
  const std::vector<Turn> turns = turns_of(first, last, setting);
  Reach result;
  Options regular = options;
  regular.tight = false;  // ways without play do not count
  ConfigurationSpace space(robot, obstacles, setting, regular);
  if (setting.certain) {
    result.margin = margin_of(turns, space.radius(), std::max(first.off, last.off));
    if (result.margin.sign() > 0) space = space.grown(octagon(result.margin));
  }
  space.include(from.at);
  space.include(to.at);
  require_free(space, from, first, setting, options, 3);
  require_free(space, to, last, setting, options, 4);
  std::vector<FreeParts> parts(turns.size());
  space.for_each_slice(
      turns, true, [&](std::size_t i, Slice& slice) { parts[i] = parts_of(slice, options); },
      [](std::size_t, Slice&) {});
  Planner planner(std::move(parts), from, to, space.radius(), options);
  result.slices = turns.size();
  result.parts = planner.part_count();
  result.path = planner.find(planner.slice_of(first), planner.slice_of(last));
  result.reachable = !result.path.empty();
  return result;
}

}  // namespace minksum
