// Where and when a benchmark ran.
#pragma once

#include "child.hpp"

namespace minksum::bench {

/// Machine, memory, system, compiler, flags, date, versions of minksum and of the peers.
[[nodiscard]] Json describe_run();

}  // namespace minksum::bench
