#include "options/operation_options.hpp"

#include "options/sum_options.hpp"
#include "options/typed_numbers.hpp"
#include "process/failure.hpp"

namespace minksum::cli {
namespace {

using Operation = MorphologyArguments::Operation;

struct Words {
  const char* name;
  const char* what;
  const char* result;
};

Words words_of(Operation operation) {
  switch (operation) {
    case Operation::kDilate:
      return {"dilate", "Dilation: A grown by B", "dilation"};
    case Operation::kErode:
      return {"erode", "Erosion: where B fits into A", "erosion"};
    case Operation::kOpen:
      return {"open", "Opening: what B covers while it stays in A", "opening"};
    case Operation::kClose:
      break;
  }
  return {"close", "Closing: dilation, then erosion, by B", "closing"};
}

constexpr const char* kFilesFooter = R"(
Files as for `minksum sum`; one of them may be "-" for standard input.
)";

Option add_operand(const Command& command, const char* name, std::string& file, const char* what) {
  return command.add_option(name, file, what).required().type_name("FILE");
}

void require_one_standard_input(const std::string (&operands)[2], const std::string& names) {
  if (operands[0] == "-" && operands[1] == "-") {
    throw Failure(kWrongUsage, names + " cannot both be standard input");
  }
}

void require_file(const std::string& picture) {
  if (picture == "-") throw Failure(kWrongUsage, "--svg needs a file, not standard output");
}

}  // namespace

Command add_morphology(CommandLine& line, Operation operation, MorphologyArguments& arguments,
                       MorphologyText& typed, ProcessLimits& limits) {
  const Words words = words_of(operation);
  const Command command = line.add_command(words.name, words.what);
  command.footer(kFilesFooter);
  add_operand(command, "A", arguments.operands[0], "The set");
  add_operand(command, "B", arguments.operands[1], "The structuring element");
  add_result_options(command, arguments, typed, words.result);
  add_fill_option(command, arguments.options.fill);
  command.add_flag("--tight", arguments.tight,
                   operation == Operation::kDilate
                       ? "Keep what has no area: a dilation always does"
                       : "Keep what has no area: where B fits with no play");
  command.add_option("--svg", arguments.picture, "Draw A, B and the result").type_name("FILE");
  add_limit_options(command, limits, true);
  return command;
}

Command add_no_fit(CommandLine& line, bool inner_fit, NoFitArguments& arguments, NoFitText& typed,
                   ProcessLimits& limits) {
  const Command command =
      inner_fit ? line.add_command("ifp", "Inner-fit polygon: placements of a part in a bin")
                : line.add_command("nfp", "No-fit polygon: placements at which parts overlap");
  command.footer(kFilesFooter);
  add_operand(command, inner_fit ? "BIN" : "FIXED", arguments.operands[0],
              inner_fit ? "What the part has to stay in" : "The part that stays");
  add_operand(command, inner_fit ? "PART" : "MOVING", arguments.operands[1],
              "The part that is placed");
  command
      .add_option("--reference", typed.reference,
                  "The point that says where the part is (default: its first vertex)")
      .type_name("X,Y");
  add_result_options(command, arguments, typed, "polygon");
  command.add_option("--svg", arguments.picture, "Draw both shapes and the polygon")
      .type_name("FILE");
  if (!inner_fit) {
    const Option at =
        command
            .add_option("--at", typed.placements,
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

Command add_depth(CommandLine& line, DepthArguments& arguments, DepthText& typed,
                  ProcessLimits& limits) {
  const Command command =
      line.add_command("depth", "Penetration depth or distance, and the time of impact");
  command.footer(kFilesFooter);
  add_operand(command, "A", arguments.operands[0], "The shape that stays");
  add_operand(command, "B", arguments.operands[1], "The shape that moves");
  command.add_option("--along", typed.along, "How many times DX,DY can B move before it touches A?")
      .type_name("DX,DY");
  command.add_flag("--json", arguments.json, "As JSON");
  command.add_option("--svg", arguments.picture, "Draw A, and B before and after")
      .type_name("FILE");
  add_fill_option(command, arguments.options.fill);
  add_limit_options(command, limits, true);
  return command;
}

void convert(MorphologyArguments& arguments, const MorphologyText& typed) {
  require_one_standard_input(arguments.operands, "A and B");
  require_file(arguments.picture);
  convert_result(arguments, typed);
  arguments.options.tight = arguments.tight;
}

void convert(NoFitArguments& arguments, const NoFitText& typed) {
  require_one_standard_input(arguments.operands,
                             arguments.inner_fit ? "BIN and PART" : "FIXED and MOVING");
  require_file(arguments.picture);
  convert_result(arguments, typed);
  if (!typed.reference.empty()) {
    arguments.reference = parse_point("--reference", typed.reference);
  }
  for (const std::string& text : typed.placements) {
    arguments.placements.push_back(parse_point("--at", text));
  }
}

void convert(DepthArguments& arguments, const DepthText& typed) {
  require_one_standard_input(arguments.operands, "A and B");
  require_file(arguments.picture);
  if (typed.along.empty()) return;
  arguments.along = parse_point("--along", typed.along);
  if (*arguments.along == Point{}) {
    throw Failure(kWrongUsage, "--along takes a direction, which 0,0 is not");
  }
}

}  // namespace minksum::cli
