#include "options/shared_options.hpp"

namespace minksum::cli {

void add_telling_options(const Command& command, Telling& telling) {
  const char* const group = "Messages on standard error";
  if (!command.has_option("--verbose")) {
    command
        .add_flag("-v,--verbose", telling.verbose,
                  "Say what was read, and what time and memory it took")
        .group(group);
  }
  command.add_flag("-q,--quiet", telling.quiet, "Say errors alone: no notes, no progress")
      .excludes("--verbose")
      .group(group);
  command
      .add_flag("--progress", telling.progress,
                "Say at once how far it is; by default after a second, and on a terminal alone")
      .group(group);
}

void add_threads_option(const Command& command, int& threads) {
  // What has this limit computes sums.
  if (!command.has_option("--max-segments") || command.has_option("--threads")) return;
  threads = 0;
  command.add_option("--threads", threads, "Threads that share the work; all cores without it")
      .in_range(1, 1024)
      .type_name("N");
}

}  // namespace minksum::cli
