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

namespace {

int run_morphology(const MorphologyArguments& arguments) {
  run_on_operands(
      arguments, arguments.output, [&](const Geometry& a, const Geometry& b, OutputFiles& files) {
        const Geometry result = morphology(arguments, a, b);
        write_rounded(files, arguments, result);
        if (arguments.picture.empty()) return;
        const Options reading{.fill = arguments.options.fill};
        const Captions captions = captions_of(arguments.operation);
        write_picture(files, arguments.picture,
                      {resolve(a, reading), resolve(b, reading), result, nullptr, captions, true});
      });
  return kFine;
}

}  // namespace

void add_morphology(Program& program) {
  using enum MorphologyArguments::Operation;
  for (const auto operation : {kDilate, kErode, kOpen, kClose}) {
    MorphologyArguments arguments;
    arguments.operation = operation;
    program.add(add_morphology, run_morphology, arguments);
  }
}

}  // namespace minksum::cli
