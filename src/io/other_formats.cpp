// Names formats that are not read, by how files of them begin, and says what to do.
#include <algorithm>
#include <array>
#include <vector>

#include "io/drawing/xml.hpp"
#include "io/formats.hpp"
#include "io/text_cursor.hpp"

namespace minksum::io {

namespace {

// Stands for the advice on formats that GDAL opens.
constexpr const char* kByGdal = "";
constexpr const char* kUnpack = "unpack it first";
constexpr const char* kPicture =
    "a picture has no coordinates that could be read; take the file that it was made from";
constexpr const char* kDrawing = "export its outlines as SVG or as DXF in ASCII";

struct Other {
  std::string_view begin;
  const char* name;
  const char* advice;
};

using namespace std::string_view_literals;

// The first bytes of files, as their specifications have them.
constexpr std::array kOthers = {
    Other{"\x1F\x8B"sv, "a gzip archive", kUnpack},
    Other{"BZh"sv, "a bzip2 archive", kUnpack},
    Other{"\xFD"
          "7zXZ\0"sv,
          "an xz archive", kUnpack},
    Other{"\x28\xB5\x2F\xFD"sv, "a Zstandard archive", kUnpack},
    Other{"7z\xBC\xAF"sv, "a 7z archive", kUnpack},
    Other{"PK\3\4"sv, "a zip archive, or a file that is one, such as KMZ or a zipped Shapefile",
          kByGdal},
    Other{"\0\0\x27\x0A"sv, "a Shapefile", kByGdal},
    Other{"SQLite format 3\0"sv, "an SQLite database, such as GeoPackage or SpatiaLite", kByGdal},
    Other{"fgb\3"sv, "FlatGeobuf", kByGdal},
    Other{"PAR1"sv, "Parquet", kByGdal},
    Other{"ARROW1"sv, "Arrow", kByGdal},
    Other{"Version "sv, "a MapInfo file (MIF)", kByGdal},
    Other{"!table"sv, "a MapInfo file (TAB)", kByGdal},
    Other{"AutoCAD Binary DXF"sv, "a binary DXF drawing", kDrawing},
    Other{"AC10"sv, "a DWG drawing", kDrawing},
    Other{"ISO-10303-21"sv, "a STEP model", kDrawing},
    Other{"%PDF-"sv, "PDF", kDrawing},
    Other{"%!PS"sv, "PostScript", kDrawing},
    Other{"\x89PNG"sv, "a PNG picture", kPicture},
    Other{"\xFF\xD8\xFF"sv, "a JPEG picture", kPicture},
    Other{"GIF8"sv, "a GIF picture", kPicture},
    Other{"II*\0"sv, "a TIFF picture", kPicture},
    Other{"MM\0*"sv, "a TIFF picture", kPicture},
};

// By the name of a document's first element, without its prefix and in lower case.
constexpr std::array kElements = {
    Other{"kml", "KML", kByGdal},
    Other{"featurecollection", "GML", kByGdal},
    Other{"gml", "GML", kByGdal},
    Other{"gpx", "GPX", kByGdal},
    Other{"osm", "OpenStreetMap data", kByGdal},
    Other{"html", "a page in HTML", "perhaps an error page was saved in place of the file"},
};

/// Returns the name of the first element of an XML document, or "" if the text ends before its end.
std::string first_element(TextCursor cursor) {
  const auto skip_past = [&cursor](std::string_view end) {
    const std::size_t found = cursor.rest().find(end);
    cursor.advance(found == std::string_view::npos ? cursor.rest().size() : found + end.size());
  };
  for (;;) {
    cursor.skip_space();
    if (cursor.rest().starts_with("<!--")) {
      skip_past("-->");
    } else if (cursor.rest().starts_with("<?")) {
      skip_past("?>");
    } else if (cursor.rest().starts_with("<!")) {
      cursor.advance(std::min(length_of_declaration(cursor.rest()), cursor.rest().size()));
    } else {
      break;
    }
  }
  if (!cursor.accept('<')) return {};
  std::string name;
  for (; is_letter(cursor.peek()) || is_digit(cursor.peek()) || cursor.peek() == ':';
       cursor.advance()) {
    const char c = cursor.peek();
    if (c == ':') {
      name.clear();
    } else {
      name += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
  }
  return cursor.at_end() ? "" : name;
}

// The module for browsers has no room to name these.
#if defined(__wasm__)
bool looks_like_triangle(const TextCursor& /*cursor*/) { return false; }
#else
using Words = std::vector<std::string_view>;

/// Takes the words of the next line that has some. A line that no file of Triangle has is not taken
/// to its end, because all of a text may be one line.
Words words_of_next_line(TextCursor& cursor) {
  constexpr std::size_t kMost = 100;
  constexpr std::size_t kLongest = 5000;
  Words words;
  cursor.skip_space_and_comments();
  while (!cursor.at_end() && cursor.peek() != '\n' && cursor.peek() != '#') {
    const std::string_view rest = cursor.rest().substr(0, kLongest);
    const std::size_t size = std::min(rest.find_first_of(" \t\r\n#"), rest.size());
    if (size == kLongest || words.size() == kMost) return {};
    if (size > 0) words.push_back(rest.substr(0, size));
    cursor.advance(std::max(size, std::size_t{1}));
  }
  return words;
}

// A file of Triangle has a line of four numbers: how many points there are, 2 for the plane, how
// many attributes a point has, and whether it has a mark. Then each point has a line with its
// number, x, y, attributes and mark. Without this test, it may be read as `.dat` by chance.
bool looks_like_triangle(TextCursor cursor) {
  const Words head = words_of_next_line(cursor);
  const bool are_counts = std::ranges::all_of(
      head, [](std::string_view word) { return std::ranges::all_of(word, is_digit); });
  if (head.size() != 4 || !are_counts || head[1] != "2" || head[2].size() > 1 ||
      (head[3] != "0" && head[3] != "1")) {
    return false;
  }
  if (head[0] == "0") return true;  // the points are in a file of their own
  const auto size = static_cast<std::size_t>(3 + (head[2][0] - '0') + (head[3][0] - '0'));
  const Words first = words_of_next_line(cursor);
  const Words second = words_of_next_line(cursor);
  if (first.size() != size || second.size() != size) return false;
  return (first[0] == "0" && second[0] == "1") || (first[0] == "1" && second[0] == "2");
}
#endif

OtherFormat other(const Other& row) { return {row.name, row.advice, row.advice == kByGdal}; }

}  // namespace

// A DXF drawing has pairs of lines, a number and its value; the first pair begins a section. Pairs
// with 999 are comments.
bool looks_like_dxf(std::string_view text) {
  TextCursor cursor(text);
  const auto take_line = [&cursor] {
    const std::string_view rest = cursor.rest();
    const std::string_view line = rest.substr(0, rest.find('\n'));
    cursor.advance(std::min(line.size() + 1, rest.size()));
    const std::size_t from = line.find_first_not_of(" \t\r");
    if (from == std::string_view::npos) return std::string_view();
    return line.substr(from, line.find_last_not_of(" \t\r") + 1 - from);
  };
  for (;;) {
    const std::string_view number = take_line();
    const std::string_view value = take_line();
    if (number != "999") return number == "0" && value == "SECTION";
  }
}

bool looks_like_svg(std::string_view text) { return first_element(TextCursor(text)) == "svg"; }

std::optional<OtherFormat> find_other_format(std::string_view text) {
  for (const Other& row : kOthers) {
    if (text.starts_with(row.begin)) return other(row);
  }
  TextCursor cursor(text);
  if (looks_like_triangle(cursor)) {
    return OtherFormat{"a file of Triangle (.poly, .node)",
                       "write its outlines as WKT or GeoJSON, or as .dat: rings, each a count and "
                       "its points",
                       false};
  }
  cursor.skip_space();
  if (cursor.peek() != '<') return {};
  const std::string element = first_element(cursor);
  if (element.empty() || element == "svg") return {};
  for (const Other& row : kElements) {
    if (element == row.begin) return other(row);
  }
  return OtherFormat{"XML of an unknown kind", "SVG, KML, GML and GPX are", false};
}

std::string refusal_of_json([[maybe_unused]] std::string_view word) {
#if !defined(__wasm__)
  if (word == "Topology") {
    return "this looks like TopoJSON, which is not read: convert it to GeoJSON, as by ogr2ogr -f "
           "GeoJSON result.json FILE";
  }
  constexpr std::array kEsriMembers = {"rings"sv,        "paths"sv,           "curveRings"sv,
                                       "curvePaths"sv,   "attributes"sv,      "fieldAliases"sv,
                                       "geometryType"sv, "spatialReference"sv};
  if (std::ranges::find(kEsriMembers, word) != kEsriMembers.end()) {
    return "this looks like Esri JSON, which is not read: ask its server for f=geojson, or convert "
           "it to GeoJSON; ogr2ogr reads sets of features: ogr2ogr -f GeoJSON result.json FILE";
  }
#endif
  return {};
}

void refuse(const OtherFormat& format, bool is_file) {
  const std::string advice =
      !format.by_gdal ? format.advice
      : is_file       ? "GDAL opens it, but is not installed here (libgdal); or convert it "
                        "elsewhere: ogr2ogr -f GeoJSON result.json FILE"
                : "give it as a file, which GDAL opens if it is installed, or convert it first: "
                  "ogr2ogr -f GeoJSON result.json FILE";
  throw ReadError(ErrorCode::kBadInput,
                  "this looks like " + format.name + ", which is not read: " + advice, 1, 1);
}

}  // namespace minksum::io
