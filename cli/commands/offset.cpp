// minksum offset: grows or shrinks a shape by a distance.
#include "commands/offset.hpp"

#include <map>
#include <ostream>

#include "commands/subcommands.hpp"
#include "minksum/resolve.hpp"
#include "options/sum_options.hpp"
#include "options/typed_numbers.hpp"
#include "output/output_file.hpp"
#include "output/result_file.hpp"
#include "pictures/sum_picture.hpp"
#include "process/failure.hpp"

namespace minksum::cli {
namespace {

const std::map<std::string, Join> kJoins = {{"round", Join::kRound},
                                            {"miter", Join::kMiter},
                                            {"square", Join::kSquare},
                                            {"bevel", Join::kBevel}};
const std::map<std::string, Cap> kCaps = {
    {"round", Cap::kRound}, {"butt", Cap::kButt}, {"square", Cap::kSquare}};

constexpr const char* kFooter = R"(
Files as for `minksum sum`; FILE may be "-" for standard input. Numbers as 1.5, 1e-3 or 2/3.
)";

template <typename Value>
void choose(const std::map<std::string, Value>& values, const std::string& typed, Value& value) {
  if (!typed.empty()) value = values.at(typed);
}

void draw(const OffsetArguments& arguments, const Geometry& a, const Geometry& result,
          OutputFiles& files) {
  const Options reading{.fill = arguments.options.fill};
  Drawing drawing{resolve(a, reading), {}, result, nullptr, {}, true, {}};
  drawing.captions = {"Offset", "A", nullptr, "Offset"};
  files.write(arguments.picture, [&](std::ostream& out) { out << sum_picture(drawing); });
}

}  // namespace

Command add_offset(CommandLine& line, OffsetArguments& arguments, OffsetText& typed,
                   ProcessLimits& limits) {
  const Command command = line.add_command("offset", "A grown or shrunk by a distance");
  command.footer(kFooter);
  command.add_option("FILE", arguments.operand, "The set").required().type_name("FILE");
  command.add_option("-d,--distance", typed.distance, "How far; negative: shrunk")
      .required()
      .type_name("D");
  command
      .add_option("--join", typed.join, "At corners: round (the default), miter, square or bevel")
      .one_of(names_of(kJoins))
      .type_name("JOIN");
  command.add_option("--cap", typed.cap, "At ends of polylines: round (the default), butt, square")
      .one_of(names_of(kCaps))
      .type_name("CAP");
  command
      .add_option("--miter-limit", typed.miter_limit,
                  "How many times the distance a miter may reach; 2 without it; else square")
      .type_name("M");
  command
      .add_option("--tolerance", typed.tolerance,
                  "How far the result may be off; a thousandth of the distance without it")
      .type_name("T");
  command
      .add_option(
          "--side", typed.side,
          "nearest (the default), outside (contains the true offset), inside (within it); "
          "these two for round joins and caps only, and followed by --round if that is not given")
      .one_of(names_of(rounding_sides()))
      .type_name("SIDE");
  add_result_options(command, arguments, typed, "result");
  add_fill_option(command, arguments.options.fill);
  command.add_option("--svg", arguments.picture, "Draw A and its offset").type_name("FILE");
  add_limit_options(command, limits, true);
  return command;
}

void convert(OffsetArguments& arguments, const OffsetText& typed) {
  if (arguments.picture == "-") {
    throw Failure(kWrongUsage, "--svg needs a file, not standard output");
  }
  convert_result(arguments, typed);
  OffsetOptions& shape = arguments.shape;
  arguments.distance = parse_number("--distance", typed.distance);
  choose(kJoins, typed.join, shape.join);
  choose(kCaps, typed.cap, shape.cap);
  choose(rounding_sides(), typed.side, shape.side);
  if (!typed.miter_limit.empty()) {
    shape.miter_limit = parse_number("--miter-limit", typed.miter_limit);
    if (shape.miter_limit < Rational(1)) {
      throw Failure(kWrongUsage, "--miter-limit must be at least 1");
    }
  }
  if (!typed.tolerance.empty()) {
    shape.tolerance = parse_number("--tolerance", typed.tolerance);
    if (shape.tolerance->sign() <= 0) {
      throw Failure(kWrongUsage, "--tolerance must be positive");
    }
  }
  const bool round = shape.join == Join::kRound && shape.cap == Cap::kRound;
  if (shape.side != RoundingSide::kNearest && !round) {
    throw Failure(kWrongUsage, "--side is for round joins and caps only");
  }
  // By default, rounding the output keeps the side of the offset.
  if (typed.round.empty()) arguments.rounding = shape.side;
}

int run_offset(const OffsetArguments& arguments) {
  OutputFiles files;
  files.expect("-o", arguments.output);
  files.expect_if_any("--svg", arguments.picture);
  const Geometry a =
      read_operand(arguments.operand, arguments.limits, arguments.options.fill).geometry;
  try {
    const Geometry result = offset(a, arguments.distance, arguments.shape, arguments.options);
    write_rounded(files, arguments, result);
    if (!arguments.picture.empty()) draw(arguments, a, result, files);
  } catch (const Error& error) {
    fail_about(error, {arguments.operand, ""});
  }
  files.finish();
  return kFine;
}

void add_offset(Program& program) { program.add(add_offset, run_offset); }

}  // namespace minksum::cli
