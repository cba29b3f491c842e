// minksum reach: tells whether and how a robot gets from one configuration to another.
#include "commands/reach.hpp"

#include <cmath>
#include <ostream>

#include "commands/subcommands.hpp"
#include "options/operation_options.hpp"
#include "options/typed_numbers.hpp"
#include "output/json.hpp"
#include "output/numbers.hpp"
#include "output/output_file.hpp"
#include "output/picture_file.hpp"
#include "output/statistics_json.hpp"
#include "process/failure.hpp"
#include "process/stopwatch.hpp"
#include "process/telling.hpp"

namespace minksum::cli {
namespace {

Json turn_json(const Turn& turn) {
  return {{"theta", turn.asked.to_double()},
          {"turned", turn.degrees},
          {"quarter_turns", turn.quarters},
          {"tan_half", turn.tan_half.to_string()},
          {"off", turn.off}};
}

void write_json(std::ostream& out, const Reach& found) {
  Json path = Json::array();
  for (const Waypoint& waypoint : found.path) {
    Json one{{"at", {waypoint.at.x.to_double(), waypoint.at.y.to_double()}},
             {"at_exact", {waypoint.at.x.to_string(), waypoint.at.y.to_string()}}};
    one.update(turn_json(waypoint.turn));
    path.push_back(std::move(one));
  }
  const Json json{{"reachable", found.reachable},
                  {"slices", found.slices},
                  {"parts", found.parts},
                  {"margin", found.margin.to_double()},
                  {"margin_exact", found.margin.to_string()},
                  {"path", std::move(path)}};
  out << json.dump(2) << '\n';
}

/// Throws if a waypoint is beyond doubles, because lines of text and GeoJSON have only doubles.
void require_doubles(const Reach& found) {
  for (const Waypoint& waypoint : found.path) {
    if (std::isfinite(waypoint.at.x.to_double()) && std::isfinite(waypoint.at.y.to_double())) {
      continue;
    }
    throw Error(ErrorCode::kLimitExceeded,
                "the path is beyond the range of doubles; --json has exact numbers", {}, {},
                ExceededLimit{"pictures"});
  }
}

/// Writes yes or no, and then a line for each waypoint.
void write_text(std::ostream& out, const Reach& found) {
  require_doubles(found);
  out << (found.reachable ? "yes\n" : "no\n");
  for (const Waypoint& waypoint : found.path) {
    out << shortest(waypoint.at.x.to_double()) << ' ' << shortest(waypoint.at.y.to_double()) << ' '
        << shortest(waypoint.turn.asked.to_double()) << '\n';
  }
}

/// Writes the path as a line. A line needs two points, even if nothing moves.
void write_geojson(std::ostream& out, const Reach& found) {
  require_doubles(found);
  Json line = nullptr;
  Json theta = Json::array();
  if (found.reachable) {
    Json coordinates = Json::array();
    const auto add = [&](const Waypoint& waypoint) {
      coordinates.push_back({waypoint.at.x.to_double(), waypoint.at.y.to_double()});
      theta.push_back(waypoint.turn.asked.to_double());
    };
    for (const Waypoint& waypoint : found.path) add(waypoint);
    if (found.path.size() == 1) add(found.path.front());
    line = {{"type", "LineString"}, {"coordinates", std::move(coordinates)}};
  }
  const Json feature{{"type", "Feature"},
                     {"properties",
                      {{"reachable", found.reachable},
                       {"theta", std::move(theta)},
                       {"margin", found.margin.to_double()}}},
                     {"geometry", std::move(line)}};
  out << feature.dump() << '\n';
}

[[noreturn]] void fail_about_reach(const Error& error, const ReachArguments& arguments) {
  const int operand = error.culprit().operand;
  if (operand == 3 || operand == 4) {
    std::string line = std::string(operand == 3 ? "--from" : "--to") + ": " + error.what();
    if (arguments.setting.certain) line += " (grown by the margin of --certain)";
    throw Failure(kBadInput, line);
  }
  fail_about_scene(error, arguments);
}

Command describe_reach(CommandLine& line, ReachArguments& arguments, ProcessLimits& limits) {
  const Command command = line.add_command(
      "reach", "Whether a robot that moves and turns gets from one place to another, and how");
  add_robot_options(command, arguments, arguments.setting);
  const auto add_end = [command](const char* name, Configuration& end, const char* what) {
    const auto take = [name, &end](const std::string& text) {
      const auto numbers = parse_numbers(name, text, 3, ',', "1.5,-2/3,90");
      end = {{numbers[0], numbers[1]}, numbers[2]};
    };
    command.add_option(name, take, what).required().type_name("X,Y,THETA");
  };
  add_end("--from", arguments.from, "Where it is: its reference point, and its turn in degrees");
  add_end("--to", arguments.to, "Where it is to go");
  command
      .add_option(
          "--angles",
          [&arguments](const std::string& text) { arguments.setting.angles = parse_angles(text); },
          "It turns in steps of a full turn over N")
      .required()
      .type_name("N");
  command
      .add_option("--angle-tolerance", arguments.setting.tolerance,
                  "How many degrees an angle may be off to be a rational turn (default 0.001)")
      .check(between(1e-10, 1))
      .type_name("D");
  command.add_flag("--certain", arguments.setting.certain,
                   "Free of collisions at all angles between as well: the robot is grown for "
                   "that");
  command.add_flag("--json", arguments.json, "As JSON, with exact numbers");
  command.add_option("-o,--output", arguments.output, "The path as a GeoJSON Feature")
      .type_name("FILE");
  add_picture_option(command, arguments.picture, "Draw the robot on its way");
  add_limit_options(command, limits, true);
  return command;
}

// Nothing is known between slices, so "no" is an answer about these alone.
std::string what_no_means(const Reach& found, const ReachOptions& setting, double seconds) {
  return "\"no\" means: not with these " + std::to_string(found.slices) + " slices; --angles " +
         std::to_string(2 * setting.angles) + " looks twice as closely, in about " +
         readable_seconds(2 * seconds);
}

int run_reach(const ReachArguments& arguments) {
  OutputFiles files;
  files.expect("the answer", "");
  files.expect_if_any("-o", arguments.output);
  files.expect_if_any("--svg", arguments.picture);
  ReachOptions setting = arguments.setting;
  const RobotScene scene = read_scene(arguments, setting);
  std::string caveat;
  try {
    const Stopwatch watch;
    const Reach found = reach(scene.robot, scene.obstacles, arguments.from, arguments.to, setting,
                              arguments.options);
    if (!found.reachable) caveat = what_no_means(found, setting, watch.seconds());
    if (!arguments.output.empty()) {
      files.write(arguments.output, [&](std::ostream& out) { write_geojson(out, found); });
    }
    if (!arguments.picture.empty()) {
      write_picture(files, arguments.picture,
                    [&] { return reach_picture(arguments, setting, scene, found); });
    }
    write_standard_output([&](std::ostream& out) {
      arguments.json ? write_json(out, found) : write_text(out, found);
    });
  } catch (const Error& error) {
    fail_about_reach(error, arguments);
  }
  files.finish();
  if (!caveat.empty()) note(caveat);
  return kFine;
}

}  // namespace

void convert(const ReachArguments& arguments) {
  require_one_standard_input(arguments);
  if (arguments.output == "-") {
    throw Failure(kWrongUsage, "-o needs a file, not standard output");
  }
  require_picture("--svg", arguments.picture);
}

void add_reach(Program& program) { program.add(describe_reach, run_reach); }

}  // namespace minksum::cli
