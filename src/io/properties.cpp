// Finds the properties of a GeoJSON Feature.
#include <optional>
#include <string>

#include "io/formats.hpp"
#include "io/json_cursor.hpp"

namespace minksum::io {

namespace {

class PropertiesReader {
 public:
  PropertiesReader(std::string_view text, const ReadLimits& limits)
      : json_(text, limits.max_depth) {}

  // Reads the object at which the cursor stands.
  std::optional<std::string> object() {
    std::string type;
    std::string properties = "null";
    std::optional<std::size_t> features;
    json_.object("'{'", [&](const std::string& name) {
      const std::size_t start = json_.text().position();
      if (name == "type" && json_.peek() == '"') {
        type = json_.take_string();
        return;
      }
      json_.skip_value();
      if (name == "features") features = start;
      if (name == "properties") {
        properties = json_.text().text().substr(start, json_.text().position() - start);
      }
    });
    if (type == "Feature") return properties;
    if (type == "FeatureCollection" && features) return only_feature(*features);
    return {};
  }

 private:
  std::optional<std::string> only_feature(std::size_t features) {
    json_.text().move_to(features);
    std::size_t count = 0;
    std::size_t first = 0;
    json_.array("an array of features", [&] {
      if (count++ == 0) first = json_.text().position();
      json_.skip_value();
    });
    if (count != 1) return {};
    json_.text().move_to(first);
    return object();
  }

  JsonCursor json_;
};

}  // namespace

std::optional<std::string> geojson_properties(std::string_view text, const ReadLimits& limits) {
  return PropertiesReader(text, limits).object();
}

}  // namespace minksum::io
