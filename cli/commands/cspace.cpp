// minksum cspace: computes the configuration-space obstacles and the free space of a robot that
// moves and turns.
#include <algorithm>
#include <chrono>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "commands/subcommands.hpp"
#include "options/operation_options.hpp"
#include "options/robot_options.hpp"
#include "options/typed_numbers.hpp"
#include "output/json.hpp"
#include "output/numbers.hpp"
#include "output/output_file.hpp"
#include "output/picture_file.hpp"
#include "output/result_file.hpp"
#include "pictures/cspace_picture.hpp"
#include "process/failure.hpp"
#include "process/telling.hpp"

namespace minksum::cli {
namespace {

/// `minksum cspace ROBOT OBSTACLES ...`
struct CspaceArguments : RobotArguments, ResultArguments {
  std::string typed_angles;
  std::string typed_theta;
  double tolerance = 1e-3;
  std::vector<Turn> turns;
  bool free = false;
  std::string slices;  ///< a folder; empty = none
  std::string stats;   ///< empty = none
  bool tight = false;
  ConfigurationOptions setting;
};

/// The texts that the thread of a slice makes from it.
struct Written {
  std::string feature;
  std::vector<std::string> notes;  ///< what rounding loses
  std::string picture;
};

struct Totals {
  std::size_t slices = 0;
  std::size_t vertices = 0;
  double sum = 0;
  double largest = 0;
};

const Geometry& result_of(const Slice& slice, bool free) {
  return free ? slice.free : slice.obstacles;
}

std::string feature(const Slice& slice, const CspaceArguments& arguments,
                    std::vector<std::string>& notes) {
  const Turn& turn = slice.turn;
  const Json properties{{"theta", turn.asked.to_double()},
                        {"turned", turn.degrees},
                        {"quarter_turns", turn.quarters},
                        {"tan_half", turn.tan_half.to_string()},
                        {"off", turn.off},
                        {"part", arguments.free ? "free" : "obstacles"}};
  std::ostringstream out;
  out.exceptions(std::ios::badbit);
  out << R"({"type": "Feature", "properties": )" << properties.dump() << R"(, "geometry": )";
  io::write(out, rounded(result_of(slice, arguments.free), arguments, notes), io::Format::kGeoJson,
            arguments.coordinates);
  out << '}';
  return std::move(out).str();
}

/// Returns slice-000.svg and so on, with so many digits that names sort as the slices do.
std::string slice_file(const CspaceArguments& arguments, std::size_t index) {
  const std::string number = std::to_string(index);
  constexpr std::size_t kFewestDigits = 3;
  const std::size_t digits =
      std::max(kFewestDigits, std::to_string(arguments.turns.size() - 1).size());
  return arguments.slices + "/slice-" + std::string(digits - number.size(), '0') + number + ".svg";
}

void expect_files(const CspaceArguments& arguments, OutputFiles& files) {
  files.expect("-o", arguments.output);
  files.expect_if_any("--svg", arguments.picture);
  files.expect_if_any("--stats", arguments.stats);
  if (arguments.slices.empty()) return;
  make_folder(arguments.slices);
  for (std::size_t i = 0; i < arguments.turns.size(); ++i) {
    files.expect_own("--slices", slice_file(arguments, i));
  }
}

void write_statistics(const CspaceArguments& arguments, const Totals& totals, double seconds,
                      OutputFiles& files) {
  const auto count = static_cast<double>(totals.slices);
  const Json json{{"slices", totals.slices},
                  {"vertices", totals.vertices},
                  {"seconds", seconds},
                  {"seconds_per_slice", totals.sum / count},
                  {"slowest_slice", totals.largest}};
  files.write(arguments.stats, [&](std::ostream& out) { out << json.dump(2) << '\n'; });
}

class Run {
 public:
  Run(const CspaceArguments& arguments, OutputFiles& files)
      : arguments_(arguments),
        files_(files),
        setting_(arguments.setting),
        scene_(read_scene(arguments, setting_)) {}

  void all() {
    const auto begin = std::chrono::steady_clock::now();
    const ConfigurationSpace space(scene_.robot, scene_.obstacles, setting_, arguments_.options);
    const auto& turns = arguments_.turns;
    const CspacePicture picture(space, scene_.obstacles, setting_, arguments_.options,
                                arguments_.free);
    std::vector<Written> written(turns.size());
    Overview overview(picture, turns.size(), arguments_.free);
    Totals totals;
    files_.write(arguments_.output, [&](std::ostream& out) {
      out << R"({"type": "FeatureCollection", "features": [)";
      space.for_each_slice(
          turns, arguments_.free,
          [&](std::size_t i, Slice& slice) {
            written[i].feature = feature(slice, arguments_, written[i].notes);
            if (arguments_.slices.empty()) return;
            written[i].picture =
                made_for(slice_file(arguments_, i), [&] { return picture.one(slice); });
          },
          [&](std::size_t i, Slice& slice) {
            out << (i == 0 ? "\n" : ",\n") << std::exchange(written[i].feature, {});
            if (!arguments_.picture.empty()) {
              made_for(arguments_.picture, [&] { overview.offer(i, slice); });
            }
            count(slice, totals);
          });
      out << "\n]}\n";
    });
    tell_losses(written);
    for (std::size_t i = 0; i < turns.size() && !arguments_.slices.empty(); ++i) {
      save(written[i], i);
    }
    if (!arguments_.picture.empty()) {
      write_picture(files_, arguments_.picture, [&] { return std::move(overview).finish(); });
    }
    if (arguments_.stats.empty()) return;
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    write_statistics(arguments_, totals, seconds.count(), files_);
  }

 private:
  void tell_losses(const std::vector<Written>& written) const {
    const auto loses = [](const Written& slice) { return !slice.notes.empty(); };
    const auto first = std::ranges::find_if(written, loses);
    if (first == written.end()) return;
    const auto more = std::ranges::count_if(written, loses) - 1;
    note("slice " + std::to_string(first - written.begin() + 1) + ": " + first->notes.front() +
         (more > 0 ? "; it loses parts of " + std::to_string(more) + " more slices" : ""));
  }
  void save(const Written& written, std::size_t i) const {
    files_.write(slice_file(arguments_, i), [&](std::ostream& out) { out << written.picture; });
  }
  void count(const Slice& slice, Totals& totals) const {
    ++totals.slices;
    totals.vertices += result_of(slice, arguments_.free).region.vertex_count();
    totals.sum += slice.seconds;
    totals.largest = std::max(totals.largest, slice.seconds);
  }

  const CspaceArguments& arguments_;
  OutputFiles& files_;
  ConfigurationOptions setting_;
  RobotScene scene_;
};

std::vector<Turn> range_of_turns(const std::string& text, double tolerance) {
  const auto numbers = parse_numbers("--theta", text, 3, ':', "0:90:1.5");
  const Rational& from = numbers[0];
  const Rational& to = numbers[1];
  const Rational& step = numbers[2];
  if (step.sign() <= 0) throw Failure(kWrongUsage, "--theta needs a step above 0");
  if (to < from) throw Failure(kWrongUsage, "--theta goes from the smaller to the larger angle");
  if ((to - from) / step >= Rational(kMostTurns)) {
    throw Failure(kWrongUsage, "--theta is for up to " + std::to_string(kMostTurns) + " angles");
  }
  std::vector<Turn> turns;
  for (Rational angle = from; angle <= to; angle = angle + step) {
    turns.push_back(nearest_turn(angle, tolerance));
  }
  return turns;
}

Command describe_cspace(CommandLine& line, CspaceArguments& arguments, ProcessLimits& limits) {
  const Command command = line.add_command(
      "cspace", "Configuration space: where a robot that moves and turns meets obstacles");
  add_robot_options(command, arguments, arguments.setting);
  command.add_option("--angles", arguments.typed_angles, "Slices at N angles of a full turn")
      .type_name("N");
  command.add_option("--theta", arguments.typed_theta, "Slices at these angles, in degrees")
      .type_name("FROM:TO:STEP")
      .excludes("--angles");
  command
      .add_option("--angle-tolerance", arguments.tolerance,
                  "How many degrees an angle may be off to be a rational turn (default 0.001)")
      .check(between(1e-10, 1))
      .type_name("D");
  command.add_flag("--free", arguments.free, "Free space, not the obstacles");
  command.add_flag("--tight", arguments.tight,
                   "With --free: where the robot has no play as well, as points and polylines");
  add_result_options(command, arguments, "slices");
  command.remove_option("--format");  // the output is always GeoJSON
  add_picture_option(command, arguments.picture, "Draw some of the slices");
  command.add_option("--slices", arguments.slices, "Draw each slice into a file in this folder")
      .type_name("DIR");
  command.add_option("--stats", arguments.stats, "Sizes and times as JSON").type_name("FILE");
  add_limit_options(command, limits, true);
  return command;
}

/// Converts and checks what no option can check alone. Throws a Failure for wrong usage.
void convert(CspaceArguments& arguments) {
  require_one_standard_input(arguments);
  convert_numbers(arguments);
  require_picture("--svg", arguments.picture);
  if (arguments.stats == "-" && arguments.output.empty()) {
    throw Failure(kWrongUsage, "slices and statistics cannot both go to standard output");
  }
  if (arguments.tight && !arguments.free) {
    throw Failure(kWrongUsage, "--tight is about free space: it needs --free");
  }
  arguments.options.tight = arguments.tight;
  if (!arguments.typed_theta.empty()) {
    arguments.turns = range_of_turns(arguments.typed_theta, arguments.tolerance);
    return;
  }
  if (arguments.typed_angles.empty()) {
    throw Failure(kWrongUsage, "cspace needs --angles or --theta");
  }
  arguments.turns = full_turn(parse_angles(arguments.typed_angles), arguments.tolerance);
}

int run_cspace(const CspaceArguments& arguments) {
  OutputFiles files;
  expect_files(arguments, files);
  Run run(arguments, files);
  try {
    run.all();
  } catch (const Error& error) {
    fail_about_scene(error, arguments);
  }
  files.finish();
  return kFine;
}

}  // namespace

void add_cspace(Program& program) { program.add(describe_cspace, run_cspace); }

}  // namespace minksum::cli
