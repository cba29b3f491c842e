#include "io/drawing/notes.hpp"

#include <utility>

namespace minksum::io {

void finish(Geometry geometry, const std::string& unit, const Ignored& ignored,
            const std::string& remarks, GeometryBuilder& builder) {
  if (builder.rules() == Rules::kRegion && geometry.has_thin_parts()) {
    throw ReadError(ErrorCode::kBadInput,
                    "the drawing has lines that enclose no area; only areas are expected", 1, 1);
  }
  std::string list;
  for (const auto& [name, count] : ignored) {
    list += list.empty() ? "not read: " : ", ";
    list += std::to_string(count) + ' ' + name;
  }
  builder.source().remarks = remarks + (remarks.empty() || list.empty() ? "" : "; ") + list;
  builder.source().unit = unit;
  builder.set_feature(std::move(geometry));
}

}  // namespace minksum::io
