#include "machine/exceeded.hpp"

#include <string>

namespace minksum {

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
