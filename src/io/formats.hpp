// One reader and one writer a format.
#pragma once

#include <ostream>
#include <string_view>

#include "minksum/io.hpp"

namespace minksum::io {

[[nodiscard]] Region read_wkt(std::string_view text, const ReadLimits& limits);
[[nodiscard]] Region read_geojson(std::string_view text, const ReadLimits& limits);
[[nodiscard]] Region read_poly(std::string_view text);
[[nodiscard]] Region read_dat(std::string_view text);

void write_wkt(std::ostream& out, const Region& region, const Coordinates& style);
void write_geojson(std::ostream& out, const Region& region, const Coordinates& style);
void write_poly(std::ostream& out, const Region& region, const Coordinates& style);
void write_svg(std::ostream& out, const Region& region);

}  // namespace minksum::io
