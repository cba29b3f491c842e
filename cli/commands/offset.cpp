// minksum offset: grows or shrinks a shape by a distance.
#include "commands/operations.hpp"
#include "commands/subcommands.hpp"
#include "minksum/resolve.hpp"
#include "options/operation_options.hpp"
#include "options/unused_options.hpp"
#include "output/result_file.hpp"
#include "pictures/sum_picture.hpp"

namespace minksum::cli {
namespace {

int run_offset(const OffsetArguments& arguments) {
  mark_taken(ReadingOption::kTolerance);  // the result takes it, whatever is read
  return run_operation(
      arguments,
      [](const OffsetArguments& mine, const Geometry& a, const Geometry&) {
        return offset(a, mine.distance, mine.shape, mine.options);
      },
      [](const OffsetArguments& mine, const Geometry& a, const Geometry&, const Geometry& result,
         OutputFiles& files) {
        const Captions captions{"Offset", "A", nullptr, "Offset"};
        write_picture(
            files, mine.picture,
            {resolve(a, {.fill = mine.options.fill}), {}, result, nullptr, captions, true});
      });
}

}  // namespace

void add_offset(Program& program) { program.add(describe_offset, run_offset); }

}  // namespace minksum::cli
