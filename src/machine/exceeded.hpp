// Makes the error of a limit that the caller can set.
#pragma once

#include <cstdint>
#include <string>

#include "minksum/error.hpp"

namespace minksum {

/// Returns an error that says "BEFORE more than `most` AFTER (LIMIT)". `limit` is a name of the
/// public interface.
[[nodiscard]] inline Error exceeded(const char* limit, std::uint64_t most, const char* before,
                                    const char* after) {
  std::string message = before;
  message += " more than " + std::to_string(most) + " ";
  message += after;
  message += " (";
  message += limit;
  message += ")";
  return {ErrorCode::kLimitExceeded, message, {}, {}, ExceededLimit{limit, most}};
}

}  // namespace minksum
