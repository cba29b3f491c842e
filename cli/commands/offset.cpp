// minksum offset: grows or shrinks a shape by a distance.
#include "commands/operations.hpp"
#include "commands/subcommands.hpp"
#include "minksum/resolve.hpp"
#include "options/operation_options.hpp"
#include "output/result_file.hpp"
#include "pictures/sum_picture.hpp"

namespace minksum::cli {
namespace {

int run_offset(const OffsetArguments& arguments) {
  run_on_operands(
      arguments, arguments.output, [&](const Geometry& a, const Geometry&, OutputFiles& files) {
        const Geometry result = offset(a, arguments.distance, arguments.shape, arguments.options);
        write_rounded(files, arguments, result);
        if (arguments.picture.empty()) return;
        const Captions captions{"Offset", "A", nullptr, "Offset"};
        write_picture(
            files, arguments.picture,
            {resolve(a, {.fill = arguments.options.fill}), {}, result, nullptr, captions, true});
      });
  return kFine;
}

}  // namespace

void add_offset(Program& program) { program.add(add_offset, run_offset); }

}  // namespace minksum::cli
