// Describes where and when a benchmark ran.
#pragma once

#include "child.hpp"

namespace minksum::bench {

/// Returns machine, memory, system, compiler, flags, date, and versions of minksum and the peers.
[[nodiscard]] Json describe_run();

}  // namespace minksum::bench
