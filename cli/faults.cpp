#include "faults.hpp"

#include <sstream>

#include "failure.hpp"

namespace minksum::cli {

std::string described(const Fault& fault) {
  std::ostringstream text;
  text.exceptions(std::ios::badbit);  // else a stream out of memory is just a shorter text
  text.precision(17);
  if (const std::string place = describe(fault.place); !place.empty()) text << place << ": ";
  text << fault.message << " (near " << fault.x << " " << fault.y << ")";
  return text.str();
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
