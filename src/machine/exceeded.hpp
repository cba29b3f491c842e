// Makes the error of a limit that the caller can set.
#pragma once

#include <cstdint>

#include "minksum/error.hpp"

namespace minksum {

/// Returns an error that says "BEFORE more than `most` AFTER (LIMIT)". `limit` is a name of the
/// public interface.
[[nodiscard]] Error exceeded(const char* limit, std::uint64_t most, const char* before,
                             const char* after);

}  // namespace minksum
