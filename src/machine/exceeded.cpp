#include "machine/exceeded.hpp"

#include <string>

namespace minksum {

namespace {
// Made in advance, as its text needs memory. Copies share the text.
const Error kOutOfMemory(ErrorCode::kLimitExceeded, "out of memory", {}, {},
                         ExceededLimit{"memory"});
}  // namespace

Outcome detail::out_of_memory() noexcept { return {kOutOfMemory}; }

Error exceeded(const char* limit, std::uint64_t most, const char* before, const char* after) {
  std::string message = before;
  message += " more than " + std::to_string(most) + " ";
  message += after;
  message += " (";
  message += limit;
  message += ")";
  return {ErrorCode::kLimitExceeded, message, {}, {}, ExceededLimit{limit, most}};
}

}  // namespace minksum
