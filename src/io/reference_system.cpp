// Translates between the two names of a reference system: a number, and the `crs` of GeoJSON.
#include <algorithm>
#include <charconv>

#include "io/formats.hpp"

namespace minksum::io {

namespace {

constexpr std::int32_t kWgs84 = 4326;

// Returns the number in a name such as "EPSG:3857", "urn:ogc:def:crs:EPSG::3857" or
// "http://www.opengis.net/def/crs/EPSG/0/3857", which stands in quotes somewhere in the member.
std::optional<std::int32_t> number_of(std::string_view crs) {
  if (crs.find("CRS84\"") != std::string_view::npos) return kWgs84;
  const std::size_t name = crs.find("EPSG");
  if (name == std::string_view::npos) return {};
  const std::size_t end = crs.find('"', name);
  if (end == std::string_view::npos) return {};
  std::string_view digits = crs.substr(name, end - name);
  digits.remove_prefix(std::min(digits.find_last_of(":/") + 1, digits.size()));
  std::int32_t number = 0;
  const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc() || stop != digits.data() + digits.size()) return {};
  return number;
}

}  // namespace

std::optional<std::int32_t> srid_of(const SourceInfo& source) {
  return source.srid ? source.srid : number_of(source.crs);
}

std::optional<std::int32_t> srid_of(const Coordinates& style) {
  return style.srid ? style.srid : number_of(style.crs);
}

std::string crs_of(const Coordinates& style) {
  if (!style.crs.empty() || !style.srid) return style.crs;
  return R"({"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::)" +
         std::to_string(*style.srid) + R"("}})";
}

}  // namespace minksum::io
