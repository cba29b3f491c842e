// Draws a robot on its way.
#include <algorithm>
#include <cmath>

#include "commands/reach.hpp"
#include "minksum/resolve.hpp"
#include "pictures/figure_labels.hpp"
#include "pictures/picture_key.hpp"
#include "pictures/sum_picture.hpp"
#include "pictures/svg_picture.hpp"

namespace minksum::cli {
namespace {

constexpr double kPathCaption = 44;
constexpr double kPoses = 24;  ///< about how many poses are drawn on the way

double length_of(const std::vector<Waypoint>& path) {
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    length += std::hypot((path[i].at.x - path[i - 1].at.x).to_double(),
                         (path[i].at.y - path[i - 1].at.y).to_double());
  }
  return length;
}

/// Returns the poses to draw: along each move at even distances, and in turns after each tenth of a
/// circle.
std::vector<Waypoint> poses_on(const std::vector<Waypoint>& path) {
  std::vector<Waypoint> poses;
  const double step = length_of(path) / kPoses;
  double last_angle = path.front().turn.degrees;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Waypoint& a = path[i - 1];
    const Waypoint& b = path[i];
    const double length = std::hypot((b.at.x - a.at.x).to_double(), (b.at.y - a.at.y).to_double());
    const auto parts = step > 0 ? static_cast<int>(std::ceil(length / step)) : 0;
    for (int k = 0; k < parts; ++k) {
      const Rational t(k, parts);
      poses.push_back({{a.at.x + (b.at.x - a.at.x) * t, a.at.y + (b.at.y - a.at.y) * t}, a.turn});
    }
    if (std::abs(std::remainder(b.turn.degrees - last_angle, 360)) >= 36) {
      poses.push_back(b);
      last_angle = b.turn.degrees;
    }
  }
  return poses;
}

PicturePoint in_picture(const Point& point, const PictureTransform& placement) {
  return {placement.x(point.x.to_double()), placement.y(point.y.to_double())};
}

std::string note_on(const Reach& found) {
  if (!found.reachable) return "no way";
  std::size_t turns = 0;
  for (std::size_t i = 1; i < found.path.size(); ++i) {
    if (!found.path[i].turn.same_as(found.path[i - 1].turn)) ++turns;
  }
  const std::size_t moves = found.path.size() - 1 - turns;
  return grouped(moves) + (moves == 1 ? " move, " : " moves, ") + grouped(turns) +
         (turns == 1 ? " turn" : " turns");
}

}  // namespace

std::string reach_picture(const ReachArguments& arguments, const ReachOptions& setting,
                          const RobotScene& scene, const Reach& found) {
  const FillRule fill = arguments.options.fill;
  const Options reading{.fill = fill, .regularize = true};
  const Geometry obstacles = resolve(scene.obstacles, {.fill = fill});
  const Region robot = transform(resolve(scene.robot, reading).region,
                                 Affine::translation(-setting.reference.x, -setting.reference.y));
  const auto posed = [&](const Waypoint& pose) {
    const Affine to = Affine::translation(pose.at.x, pose.at.y);
    return transform(robot, to.after(pose.turn.map()));
  };
  const Region ends[] = {
      posed({arguments.from.at, nearest_turn(arguments.from.degrees, setting.tolerance)}),
      posed({arguments.to.at, nearest_turn(arguments.to.degrees, setting.tolerance)})};
  std::vector<Region> ghosts;
  if (found.reachable) {
    for (const Waypoint& pose : poses_on(found.path)) ghosts.push_back(posed(pose));
  }
  Extent extent;
  extent.include(obstacles);
  Region workspace;
  if (setting.workspace) workspace = resolve(*setting.workspace, reading).region;
  extent.include({workspace, {}, {}});
  for (const Region& end : ends) extent.include({end, {}, {}});
  for (const Region& ghost : ghosts) extent.include({ghost, {}, {}});

  const double scale = fitting_scale(extent, kPageWidth - 2 * kPageMargin,
                                     kPageHeight - 2 * kPageMargin - kPathCaption);
  const double width = std::max(extent.width() * scale, 420.0) + 2 * kPageMargin;
  std::vector<KeyEntry> key{{"first", "Obstacles"}, {"second", "The robot at start and goal"}};
  if (found.reachable) {
    key.push_back({"edge-second", "on its way", true});
    key.push_back({"thin tight", "Way of its reference point", true});
  }
  const double above = kPathCaption + kKeyRow * key_rows(key, width - 2 * kPageMargin);
  SvgPicture picture(width, extent.height() * scale + 2 * kPageMargin + above, "Reach");
  picture.text(kPageMargin, kPageMargin + 14, "title",
               found.reachable ? "Reachable" : "Not reachable");
  picture.text(kPageMargin, kPageMargin + 32, "note", note_on(found));
  draw_key(picture, key, kPageMargin, kPageMargin + kPathCaption - 2, width - 2 * kPageMargin);
  const PictureTransform placement(extent, kPageMargin, kPageMargin + above, scale);
  if (!workspace.empty()) picture.region(workspace, placement, "pale");
  picture.geometry(obstacles, placement, "first");
  for (const Region& ghost : ghosts) picture.region(ghost, placement, "edge-second");
  for (const Region& end : ends) picture.region(end, placement, "second");
  Geometry way;
  if (found.reachable) {
    Polyline line;
    for (const Waypoint& waypoint : found.path) line.push_back(waypoint.at);
    if (line.size() > 1) way.polylines.push_back(std::move(line));
  }
  way.points = {arguments.from.at, arguments.to.at};
  picture.thin_parts(way, placement, "tight");
  const PicturePoint at[] = {in_picture(arguments.from.at, placement),
                             in_picture(arguments.to.at, placement)};
  LabelPlaces places(width);
  for (int i = 0; i < 2; ++i) {
    constexpr const char* kNames[] = {"start", "goal"};
    constexpr double kLabelWidth = 38;
    // Away from the other end, where the way does not lead.
    const PicturePoint away = direction_between(at[1 - i], at[i]);
    const PicturePoint middle = places.place(at[i], away, 16, kLabelWidth, 14);
    picture.text(middle.x - kLabelWidth / 2, middle.y + 5, "title", kNames[i]);
  }
  return std::move(picture).finish();
}

}  // namespace minksum::cli
