#include "options/operation_options.hpp"

#include <map>

#include "help/spelling.hpp"
#include "options/sum_options.hpp"
#include "options/typed_numbers.hpp"
#include "output/picture_file.hpp"
#include "process/failure.hpp"

namespace minksum::cli {
namespace {

using Operation = MorphologyArguments::Operation;

struct Words {
  const char* name;
  const char* what;
  const char* result;
};

/// By Operation.
constexpr Words kOperationWords[] = {
    {"dilate", "Dilation: A grown by B", "dilation"},
    {"erode", "Erosion: where B fits into A", "erosion"},
    {"open", "Opening: what B covers while it stays in A", "opening"},
    {"close", "Closing: dilation, then erosion, by B", "closing"}};

constexpr const char* kOffsetFooter = R"(
Files as for `minksum sum`; FILE may be "-" for standard input. Numbers as 1.5, 1e-3 or 2/3.
)";
constexpr const char* kFilesFooter = R"(
Files as for `minksum sum`; one of them may be "-" for standard input.
)";

void require_free_output(const std::string& stats, bool has_output) {
  if (stats != "-" || has_output) return;
  throw Failure(kWrongUsage, "--stats - needs -o FILE: standard output already takes the result");
}

const std::map<std::string, Join> kJoins = {{"round", Join::kRound},
                                            {"miter", Join::kMiter},
                                            {"mitre", Join::kMiter},
                                            {"square", Join::kSquare},
                                            {"bevel", Join::kBevel}};
const std::map<std::string, Cap> kCaps = {
    {"round", Cap::kRound}, {"butt", Cap::kButt}, {"square", Cap::kSquare}};

void take_reference(NoFitArguments& arguments, const std::string& text) {
  using enum NoFitArguments::Reference;
  static const std::map<std::string, NoFitArguments::Reference> kNames = {
      {"first", kFirst}, {"lower-left", kLowerLeft}, {"centroid", kCentroid}};
  const auto found = kNames.find(in_lower_case(text));
  arguments.named = found != kNames.end() ? found->second : kPoint;
  if (found != kNames.end()) return;
  if (text.find(',') == std::string::npos) {
    throw Failure(kWrongUsage, "--reference takes X,Y, first, lower-left or centroid, not '" +
                                   text + "'" + did_you_mean(text, names_of(kNames)));
  }
  arguments.reference = parse_point("--reference", text);
}

}  // namespace

void require_one_standard_input(const std::string (&operands)[2], const std::string& names) {
  if (operands[0] == "-" && operands[1] == "-") {
    throw Failure(kWrongUsage, names + " cannot both be standard input");
  }
}

void convert_operation(ResultArguments& result, const OperandArguments& operands) {
  require_picture("--svg", operands.picture);
  convert_result(result);
  require_free_output(operands.stats, !result.output.empty());
}

void add_picture_option(const Command& command, std::string& picture, const char* what) {
  command.add_option("--svg", picture, what).type_name("FILE");
}

void add_stats_option(const Command& command, std::string& stats) {
  command.add_option("--stats", stats, "Write sizes and times as JSON").type_name("FILE");
}

Command describe_morphology(CommandLine& line, MorphologyArguments& arguments,
                            ProcessLimits& limits) {
  const Words& words = kOperationWords[static_cast<std::size_t>(arguments.operation)];
  const Command command = line.add_command(words.name, words.what);
  command.footer(kFilesFooter);
  add_operand(command, "A", arguments.operands[0], "The set");
  add_operand(command, "B", arguments.operands[1], "The structuring element");
  add_result_options(command, arguments, words.result);
  add_fill_option(command, arguments.options.fill);
  command.add_flag("--tight", arguments.tight,
                   arguments.operation == Operation::kDilate
                       ? "Keep what has no area: a dilation always does"
                       : "Keep what has no area: where B fits with no play");
  add_picture_option(command, arguments.picture, "Draw A, B and the result");
  add_stats_option(command, arguments.stats);
  add_each_options(command, arguments, {"--svg"});
  add_limit_options(command, limits, true);
  return command;
}

Command describe_no_fit(CommandLine& line, NoFitArguments& arguments, ProcessLimits& limits) {
  const bool inner_fit = arguments.inner_fit;
  const Command command =
      inner_fit ? line.add_command("ifp", "Inner-fit polygon: placements of a part in a bin")
                : line.add_command("nfp", "No-fit polygon: placements at which parts overlap");
  command.footer(kFilesFooter);
  add_operand(command, inner_fit ? "BIN" : "FIXED", arguments.operands[0],
              inner_fit ? "What the part has to stay in" : "The part that stays");
  add_operand(command, inner_fit ? "PART" : "MOVING", arguments.operands[1],
              "The part that is placed");
  command
      .add_option(
          "--reference", [&arguments](const std::string& text) { take_reference(arguments, text); },
          "The point that says where the part is: X,Y, or first (its first vertex; the default), "
          "lower-left (of its box) or centroid")
      .type_name("POINT");
  add_result_options(command, arguments, "polygon");
  add_picture_option(command, arguments.picture, "Draw both shapes and the polygon");
  add_stats_option(command, arguments.stats);
  add_each_options(command, arguments, {"--svg"});
  if (!inner_fit) {
    const Option at =
        command
            .add_option("--at", arguments.typed_placements,
                        "Instead of the polygon: is this placement free, touching or overlapping? "
                        "May be given again")
            .type_name("X,Y")
            .repeats();
    for (const char* const other : {"--svg", "-o", "--format", "--coords", "--round"}) {
      at.excludes(other);
    }
  }
  add_fill_option(command, arguments.options.fill);
  add_limit_options(command, limits, true);
  return command;
}

Command describe_offset(CommandLine& line, OffsetArguments& arguments, ProcessLimits& limits) {
  const Command command = line.add_command("offset", "A grown or shrunk by a distance");
  OffsetOptions& shape = arguments.shape;
  command.footer(kOffsetFooter);
  add_operand(command, "FILE", arguments.operands[0], "The set");
  command
      .add_option(
          "-d,--distance",
          [&arguments](const std::string& text) {
            arguments.distance = parse_number("--distance", text);
          },
          "How far; negative: shrunk")
      .required()
      .type_name("D");
  add_choice(command, "--join", kJoins, shape.join,
             "At corners: round (the default), miter, square or bevel")
      .type_name("JOIN");
  add_choice(command, "--cap", kCaps, shape.cap,
             "At ends of polylines: round (the default), butt, square")
      .type_name("CAP");
  command
      .add_option(
          "--miter-limit,--mitre-limit",
          [&arguments](const std::string& text) {
            arguments.miter_limit = parse_number("--miter-limit", text);
            if (*arguments.miter_limit >= Rational(1)) return;
            throw Failure(kWrongUsage, "--miter-limit must be at least 1");
          },
          "How many times the distance a miter may reach; 2 without it; else square")
      .type_name("M");
  command
      .add_option(
          "--tolerance",
          [&shape, &limits](const std::string& text) {
            limits.read.drawing.tolerance = shape.tolerance = parse_number("--tolerance", text);
            if (shape.tolerance->sign() > 0) return;
            throw Failure(kWrongUsage, "--tolerance must be positive");
          },
          "How far the result may be off; a thousandth of the distance without it")
      .type_name("T");
  add_choice(command, "--side", rounding_sides(), shape.side,
             "nearest (the default), outside (contains the true offset), inside (within it); "
             "these two for round joins and caps only, and followed by --round if that is not "
             "given")
      .type_name("SIDE");
  add_result_options(command, arguments, "result");
  add_fill_option(command, arguments.options.fill);
  add_picture_option(command, arguments.picture, "Draw A and its offset");
  add_stats_option(command, arguments.stats);
  add_each_options(command, arguments, {"--svg"});
  add_limit_options(command, limits, true);
  return command;
}

Command describe_depth(CommandLine& line, DepthArguments& arguments, ProcessLimits& limits) {
  const Command command =
      line.add_command("depth", "Penetration depth or distance, and the time of impact");
  command.footer(kFilesFooter);
  add_operand(command, "A", arguments.operands[0], "The shape that stays");
  add_operand(command, "B", arguments.operands[1], "The shape that moves");
  command
      .add_option(
          "--along",
          [&arguments](const std::string& text) {
            arguments.along = parse_point("--along", text);
            if (!(*arguments.along == Point{})) return;
            throw Failure(kWrongUsage, "--along takes a direction, which 0,0 is not");
          },
          "How many times DX,DY can B move before it touches A?")
      .type_name("DX,DY");
  command.add_flag("--json", arguments.json, "As JSON");
  add_picture_option(command, arguments.picture, "Draw A, and B before and after");
  add_stats_option(command, arguments.stats);
  add_each_options(command, arguments, {"--svg"});
  add_fill_option(command, arguments.options.fill);
  add_limit_options(command, limits, true);
  return command;
}

void convert(MorphologyArguments& arguments) {
  require_one_standard_input(arguments.operands, "A and B");
  convert_operation(arguments, arguments);
  arguments.options.tight = arguments.tight;
}

void convert(NoFitArguments& arguments) {
  require_one_standard_input(arguments.operands,
                             arguments.inner_fit ? "BIN and PART" : "FIXED and MOVING");
  convert_operation(arguments, arguments);
  for (const std::string& text : arguments.typed_placements) {
    arguments.placements.push_back(parse_point("--at", text));
  }
}

void convert(OffsetArguments& arguments) {
  convert_operation(arguments, arguments);
  OffsetOptions& shape = arguments.shape;
  if (arguments.miter_limit && shape.join != Join::kMiter) {
    throw Failure(kWrongUsage, "--miter-limit has no meaning without --join miter");
  }
  shape.miter_limit = arguments.miter_limit.value_or(shape.miter_limit);
  // An offset grows with its operand, so an operand that is a drawing takes the same side.
  arguments.limits.drawing.side = shape.side;
  const bool round = shape.join == Join::kRound && shape.cap == Cap::kRound;
  if (shape.side != RoundingSide::kNearest && !round) {
    throw Failure(kWrongUsage, "--side is for round joins and caps only");
  }
  // By default, rounding the output keeps the side of the offset.
  if (arguments.typed_rounding.empty()) arguments.rounding = shape.side;
}

void convert(DepthArguments& arguments) {
  require_one_standard_input(arguments.operands, "A and B");
  require_picture("--svg", arguments.picture);
  require_free_output(arguments.stats, false);
}

}  // namespace minksum::cli
