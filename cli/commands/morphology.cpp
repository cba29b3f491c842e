// minksum dilate, erode, open and close: apply the operations of morphology.
#include <memory>
#include <ostream>

#include "commands/commands.hpp"
#include "commands/operations.hpp"
#include "commands/subcommands.hpp"
#include "minksum/resolve.hpp"
#include "options/operation_options.hpp"
#include "output/output_file.hpp"
#include "output/result_file.hpp"
#include "pictures/sum_picture.hpp"
#include "process/failure.hpp"

namespace minksum::cli {
namespace {

using Operation = MorphologyArguments::Operation;

Captions captions_of(Operation operation) {
  const auto named = [](const char* result) { return Captions{result, "A", "B", result}; };
  switch (operation) {
    case Operation::kDilate:
      return named("A ⊕ B");
    case Operation::kErode:
      return named("A ⊖ B");
    case Operation::kOpen:
      return named("A ∘ B");
    case Operation::kClose:
      break;
  }
  return named("A • B");
}

}  // namespace

Geometry morphology(const MorphologyArguments& arguments, const Geometry& a, const Geometry& b) {
  switch (arguments.operation) {
    case Operation::kDilate:
      return dilate(a, b, arguments.options);
    case Operation::kErode:
      return erode(a, b, arguments.options);
    case Operation::kOpen:
      return open(a, b, arguments.options);
    case Operation::kClose:
      break;
  }
  return close(a, b, arguments.options);
}

int run_morphology(const MorphologyArguments& arguments) {
  OutputFiles files;
  files.expect("-o", arguments.output);
  files.expect_if_any("--svg", arguments.picture);
  const Geometry a =
      read_operand(arguments.operands[0], arguments.limits, arguments.options.fill).geometry;
  const Geometry b =
      read_operand(arguments.operands[1], arguments.limits, arguments.options.fill).geometry;
  try {
    const Geometry result = morphology(arguments, a, b);
    write_rounded(files, arguments, result);
    if (!arguments.picture.empty()) {
      const Options reading{.fill = arguments.options.fill};
      const Drawing drawing{resolve(a, reading),
                            resolve(b, reading),
                            result,
                            nullptr,
                            captions_of(arguments.operation),
                            true,
                            {}};
      files.write(arguments.picture, [&](std::ostream& out) { out << sum_picture(drawing); });
    }
  } catch (const Error& error) {
    fail_about(error, arguments.operands);
  }
  files.finish();
  return kFine;
}

void add_morphology(Program& program) {
  using enum MorphologyArguments::Operation;
  for (const auto operation : {kDilate, kErode, kOpen, kClose}) {
    const auto arguments = std::make_shared<MorphologyArguments>();
    const auto typed = std::make_shared<MorphologyText>();
    arguments->operation = operation;
    program.add(add_morphology(program.line, operation, *arguments, *typed, program.limits),
                arguments, typed, run_morphology);
  }
}

}  // namespace minksum::cli
