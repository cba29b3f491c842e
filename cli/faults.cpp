#include "faults.hpp"

#include "failure.hpp"
#include "numbers.hpp"

namespace minksum::cli {

std::string described(const Fault& fault) {
  std::string text = describe(fault.place);
  if (!text.empty()) text += ": ";
  return text + fault.message + " (near " + shortest(fault.x) + ' ' + shortest(fault.y) + ')';
}

nlohmann::ordered_json fault_json(const Fault& fault) {
  nlohmann::ordered_json json;
  const auto add = [&json](const char* key, std::size_t index) {
    if (index != Culprit::kNone) json[key] = index + 1;
  };
  add("polygon", fault.place.polygon);
  add("ring", fault.place.ring);
  add("vertex", fault.place.vertex);
  json["near"] = {fault.x, fault.y};
  json["message"] = fault.message;
  return json;
}

}  // namespace minksum::cli
