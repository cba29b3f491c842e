// minksum dilate, erode, open and close: apply the operations of morphology.
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

Geometry morphology(const MorphologyArguments& arguments, const Geometry& a, const Geometry& b) {
  constexpr decltype(&dilate) kOperations[] = {dilate, erode, open, close};
  return kOperations[static_cast<std::size_t>(arguments.operation)](a, b, arguments.options);
}

namespace {

int run_morphology(const MorphologyArguments& arguments) {
  return run_operation(arguments, morphology,
                       [](const MorphologyArguments& mine, const Geometry& a, const Geometry& b,
                          const Geometry& result, OutputFiles& files) {
                         const Options reading{.fill = mine.options.fill};
                         constexpr const char* kNames[] = {"A ⊕ B", "A ⊖ B", "A ∘ B", "A • B"};
                         const char* const name = kNames[static_cast<std::size_t>(mine.operation)];
                         const Captions captions{name, "A", "B", name};
                         // Only erosion has tight places; the thin parts of other results are made
                         // of thin operands.
                         const bool has_tight =
                             mine.tight && mine.operation == MorphologyArguments::Operation::kErode;
                         const Geometry tight({}, result.polylines, result.points);
                         const Geometry shown = has_tight ? Geometry(result.region) : result;
                         write_picture(files, mine.picture,
                                       {resolve(a, reading), resolve(b, reading), shown,
                                        has_tight ? &tight : nullptr, captions, true});
                       });
}

}  // namespace

void add_morphology(Program& program) {
  using enum MorphologyArguments::Operation;
  for (const auto operation : {kDilate, kErode, kOpen, kClose}) {
    MorphologyArguments arguments;
    arguments.operation = operation;
    program.add(describe_morphology, run_morphology, arguments);
  }
}

}  // namespace minksum::cli
