#include "batch/feature_text.hpp"

#include <algorithm>
#include <sstream>
#include <utility>

#include "output/json_members.hpp"
#include "pictures/sum_picture.hpp"
#include "process/failure.hpp"
#include "process/telling.hpp"

namespace minksum::cli {
namespace {

// Returns JSON on one line. Strings in JSON hold no line ends.
std::string on_one_line(std::string json) {
  std::ranges::replace_if(
      json, [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return json;
}

std::string written(const Geometry& geometry, io::Format format,
                    const io::Coordinates& coordinates) {
  std::ostringstream text;
  text.exceptions(std::ios::badbit);  // without this, a lack of memory just shortens the text
  io::write(text, geometry, format, coordinates);
  return std::move(text).str();
}

std::string with_id(const io::Feature& feature) {
  return feature.id.empty() ? "" : ", \"id\": " + on_one_line(feature.id);
}

std::string geojson_of(const io::Feature& feature, const Geometry& geometry,
                       io::Coordinates coordinates, bool alone) {
  const std::string crs = alone ? on_one_line(io::crs_of(coordinates)) : "";
  coordinates.srid.reset();
  coordinates.crs.clear();
  const std::string properties = feature.properties.empty() ? "null" : feature.properties;
  return R"({"type": "Feature")" + with_id(feature) +
         ", \"properties\": " + on_one_line(properties) +
         ", \"geometry\": " + written(geometry, io::Format::kGeoJson, coordinates) +
         (crs.empty() ? "" : ", \"crs\": " + crs) + "}";
}

std::string json_of(const io::Feature& feature, const Json& answer) {
  const std::string& properties = feature.properties;
  return "{\"feature\": " + std::to_string(feature.index + 1) + with_id(feature) +
         (properties.empty() ? "" : ", \"properties\": " + on_one_line(properties)) +
         ", \"result\": " + answer.dump() + "}";
}

}  // namespace

std::string answer_member(const EachSettings& settings, const io::Feature& feature,
                          const FeatureAnswer& answer, const io::Coordinates& coordinates) {
  if (const Json* const json = std::get_if<Json>(&answer)) {
    return "\"feature\":" + json_of(feature, *json);
  }
  const Geometry& geometry = std::get<Geometry>(answer);
  if (settings.result.format == io::Format::kGeoJson) {
    return "\"feature\":" + geojson_of(feature, geometry, coordinates, settings.result.lines);
  }
  return "\"text\":" + to_json(written(geometry, settings.result.format, coordinates));
}

FeatureText::FeatureText(const EachSettings& settings)
    : collection_(!settings.json && settings.result.format == io::Format::kGeoJson &&
                  !settings.result.lines) {}

std::string FeatureText::begin(const io::Coordinates& coordinates) {
  if (!collection_) return "";
  const std::string crs = io::crs_of(coordinates);
  has_crs_ = !crs.empty();
  return "{\"type\": \"FeatureCollection\", " + (has_crs_ ? "\"crs\": " + crs + ", " : "") +
         "\"features\": [";
}

std::string FeatureText::add(std::string_view line) {
  std::string text;
  const auto members = json_members(line);
  if (!members) throw Error(ErrorCode::kInternal, "a line of results is not JSON");
  for (const auto& [key, value] : *members) {
    if (key == "note" || key == "lost") {
      Told& told = key == "note" ? notes_ : losses_;
      if (told.count++ == 0) told.first = json_string(value).value_or("");
    }
    if (key == "error") {
      for (const auto& part : json_members(value).value_or(std::vector<JsonMember>())) {
        if (part.key == "message") tell(json_string(part.value).value_or(""));
      }
    }
    if (key != "text" && key != "feature") continue;
    if (collection_) text += any_ ? ",\n" : "\n";
    text += key == "text" ? json_string(value).value_or("") : std::string(value);
    if (!collection_) text += '\n';
    any_ = true;
  }
  return text;
}

std::string FeatureText::end(const io::Coordinates& coordinates) const {
  if (!collection_) return "";
  const std::string crs = has_crs_ ? "" : io::crs_of(coordinates);
  return "\n]" + (crs.empty() ? "" : ", \"crs\": " + crs) + "}\n";
}

void FeatureText::tell_notes() const {
  const auto tell_first = [](const Told& told, const std::string& more) {
    if (told.count == 0) return;
    note(told.first + (told.count > 1 ? more + grouped(told.count - 1) + " more features" : ""));
  };
  tell_first(notes_, "; so are ");
  tell_first(losses_, "; it loses parts of ");
}

}  // namespace minksum::cli
