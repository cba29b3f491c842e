#include "options/robot_options.hpp"

#include <algorithm>

#include "options/sum_options.hpp"
#include "options/typed_numbers.hpp"
#include "output/result_file.hpp"
#include "process/failure.hpp"
#include "process/telling.hpp"

namespace minksum::cli {

void add_robot_options(const Command& command, RobotArguments& arguments,
                       ConfigurationOptions& setting) {
  Options& options = arguments.options;
  command.footer("\nFiles as for `minksum sum`; one of them may be \"-\" for standard input.\n");
  add_operand(command, "ROBOT", arguments.operands[0], "What moves and turns");
  add_operand(command, "OBSTACLES", arguments.operands[1], "What it must not overlap");
  command.add_option("--workspace", arguments.workspace, "What the robot has to stay inside")
      .type_name("FILE");
  command
      .add_option(
          "--reference",
          [&setting](const std::string& text) {
            setting.reference = parse_point("--reference", text);
          },
          "The robot's point that says where it is, and that it turns about (default 0,0)")
      .type_name("X,Y");
  add_fill_option(command, options.fill);
}

void require_one_standard_input(const RobotArguments& arguments) {
  const auto& operands = arguments.operands;
  const auto inputs = std::count(std::begin(operands), std::end(operands), "-") +
                      (arguments.workspace == "-" ? 1 : 0);
  if (inputs > 1) throw Failure(kWrongUsage, "only one file can be standard input");
}

std::size_t parse_angles(const std::string& text) {
  const auto count = parse_count(text);
  if (count && *count > 0 && *count <= kMostTurns) return static_cast<std::size_t>(*count);
  throw Failure(kWrongUsage, "--angles takes a number from 1 to " + std::to_string(kMostTurns) +
                                 ", not '" + text + "'");
}

RobotScene read_scene(const RobotArguments& arguments, ConfigurationOptions& setting) {
  const FillRule fill = arguments.options.fill;
  io::Document robot = read_operand(arguments.operands[0], arguments.limits, fill);
  io::Document obstacles = read_operand(arguments.operands[1], arguments.limits, fill);
  if (has_system(in_system_of({}, {robot.source, obstacles.source}, arguments.operands))) {
    note("the reference system of the operands is not named in the result");
  }
  RobotScene scene{std::move(robot.geometry), std::move(obstacles.geometry)};
  if (!arguments.workspace.empty()) {
    setting.workspace = read_operand(arguments.workspace, arguments.limits, fill).geometry;
  }
  return scene;
}

void fail_about_scene(const Error& error, const RobotArguments& arguments) {
  if (error.culprit().operand == 2) throw failure_of(error, arguments.workspace);
  fail_about(error, arguments.operands);
}

}  // namespace minksum::cli
