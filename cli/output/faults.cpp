#include "output/faults.hpp"

#include "process/failure.hpp"

namespace minksum::cli {
namespace {

Json indices(const Culprit& place) {
  Json json;
  const auto add = [&json](const char* key, std::size_t index) {
    if (index != Culprit::kNone) json[key] = index + 1;
  };
  add("polygon", place.polygon);
  add("ring", place.ring);
  add("vertex", place.vertex);
  return json;
}

}  // namespace

std::string described(const Fault& fault) {
  std::string text = describe(fault.place);
  if (!text.empty()) text += ": ";
  return text + to_string(fault);
}

Json fault_json(const Fault& fault) {
  Json json = indices(fault.place);
  if (fault.other.vertex != Culprit::kNone) json["meets"] = indices(fault.other);
  if (fault.at) {
    json["at"] = {fault.at->x.to_string(), fault.at->y.to_string()};
    json["near"] = {fault.at->x.to_double(), fault.at->y.to_double()};
  }
  json["message"] = fault.message;
  return json;
}

}  // namespace minksum::cli
