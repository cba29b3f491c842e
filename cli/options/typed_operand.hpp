// Declares operands that are typed, where others are the names of files.
#pragma once

#include <optional>
#include <string>

#include "minksum/io.hpp"

namespace minksum::cli {

/// Returns whether an operand is a geometry as WKT, such as "POLYGON ((0 0, 1 0, 0 1))", and not
/// the name of a file, such as "polygon (1).wkt".
[[nodiscard]] bool is_typed_wkt(const std::string& operand);

/// Returns the shape that an operand names, around the origin: "disc:R", "box:WxH" or "ngon:N:R".
/// Returns nothing for any other text. A note tells what is not exactly that shape. Throws a
/// Failure for wrong usage.
[[nodiscard]] std::optional<Geometry> named_shape(const std::string& operand,
                                                  const io::DrawingOptions& drawing);

}  // namespace minksum::cli
