// Declares the writer of formats that are nested lists: WKT and GeoJSON.
#pragma once

#include <array>
#include <string_view>

#include "io/writer.hpp"

namespace minksum::io {

/// What the nested lists of a format look like.
struct Notation {
  enum Kind { kPolygon, kMultiPolygon, kLine, kMultiLine, kPoint, kMultiPoint, kCollection };

  std::array<std::string_view, 7> begin;  ///< by Kind: what comes before its content
  std::string_view end;                   ///< what comes after it
  char open;                              ///< the brackets of a list, and of a lone point
  char close;
  std::string_view empty;  ///< a list without elements
  char separator;          ///< between the coordinates of a point
  bool bare_points;        ///< points of rings and lines have no brackets
};

/// Writes several kinds as a collection, and an empty geometry as an empty polygon. `last` stands
/// before the end of the whole.
void write_nested(Writer& writer, const GeometryView& geometry, const Notation& notation,
                  std::string_view last = {});

}  // namespace minksum::io
