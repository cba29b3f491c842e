// Tests that each text that is not a region has the right code, message and place.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "minksum/io.hpp"

namespace minksum::io {
namespace {

constexpr ErrorCode kBad = ErrorCode::kBadInput;
constexpr ErrorCode kLimit = ErrorCode::kLimitExceeded;

struct Malformed {
  const char* name;
  std::string text;
  ErrorCode code;
  const char* message;   // part of the message
  std::size_t line = 0;  // 0: not checked
  std::size_t column = 0;
};

std::string polygon_json(const std::string& coordinates) {
  return R"({"type":"Polygon","coordinates":)" + coordinates + "}";
}

std::vector<Malformed> wkt_table() {
  const std::string open(10'000'000, '(');
  return {
      {"empty", "", kBad, "the file is empty", 1, 1},
      {"blank", " \n\t ", kBad, "empty but for white space"},
      {"truncated_word", "POLY", kBad,
       "expected POLYGON, MULTIPOLYGON or GEOMETRYCOLLECTION, "
       "found 'POLY'",
       1, 1},
      {"truncated_after_word", "POLYGON", kBad, "expected '(' or EMPTY, found the end of the text"},
      {"truncated_number", "POLYGON ((0 0, 1", kBad,
       "a space and the second coordinate, found the "
       "end",
       1, 17},
      {"truncated_ring", "POLYGON ((0 0, 1 0, 0 1, 0 0", kBad, "expected ',' or ')'", 1, 29},
      {"truncated_polygon", "POLYGON ((0 0, 1 0, 0 1, 0 0)", kBad, "expected ',' or ')'", 1, 30},
      {"trailing", "POLYGON EMPTY\nPOLYGON EMPTY POLYGON EMPTY", kBad,
       "geometry 2: expected the end of the line or ';' after a geometry, found 'POLYGON'", 2, 15},
      {"table", "\"POLYGON EMPTY\",a", kBad, "a table needs a first line that names its columns"},
      {"quote", "'POLYGON EMPTY\n", kBad, "expected the closing quote '"},
      {"open_ring", "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0),\n  (1 1, 2 1, 2 2, 1 2))", kBad,
       "polygon 1, ring 2 is not closed", 2, 3},
      {"nearly_closed", "POLYGON ((0.1 0, 1 0, 0 1, 0.10000000000000000001 0))", kBad,
       "not closed"},
      {"three_points", "POLYGON ((0 0, 1 0, 0 0))", kBad,
       "ring 1 has 3 points, a ring needs at "
       "least 4 with the first repeated",
       1, 10},
      {"one_point", "MULTIPOLYGON (((0 0, 1 0, 0 1, 0 0)), ((0 0)))", kBad,
       "polygon 2, ring 1 has 1 point,"},
      {"empty_ring", "POLYGON (EMPTY)", kBad, "a ring may not be EMPTY"},
      {"no_points", "POLYGON (())", kBad, "expected a number, found ')'"},
      {"nan", "POLYGON ((0 0, nan 0, 0 1, 0 0))", kBad, "must be a finite number, found 'nan'", 1,
       16},
      {"minus_infinity", "POLYGON ((0 0, 1 -Infinity, 0 1, 0 0))", kBad, "must be a finite number"},
      {"inf", "POLYGON ((0 0, inf 0, 0 1, 0 0))", kBad, "must be a finite number"},
      {"word_for_number", "POLYGON ((zero 0))", kBad, "expected a number, found 'zero'"},
      {"comma_decimal", "POLYGON ((0,5 1, 1 0))", kBad,
       "a space and the second coordinate, found "
       "','"},
      {"two_dots", "POLYGON ((0 0, 1.2.3 0))", kBad,
       "a space and the second coordinate, found "
       "'.3'"},
      {"glued_signs", "POLYGON ((0-1 0))", kBad, "a space and the second coordinate"},
      {"hexadecimal", "POLYGON ((0x10 0))", kBad, "a space and the second coordinate, found 'x10'"},
      {"bare_exponent", "POLYGON ((1e 0))", kBad, "expected the digits of an exponent"},
      {"zero_denominator", "POLYGON ((1/0 0))", kBad, "the denominator 0", 1, 11},
      {"no_denominator", "POLYGON ((1/ 0))", kBad, "expected a denominator"},
      {"fraction_of_decimals", "POLYGON ((1.5/2 0))", kBad, "a space and the second coordinate"},
      {"three_coordinates", "POLYGON ((0 0 0, 1 0 0, 0 1 0, 0 0 0))", kBad,
       "more than two coordinates", 1, 15},
      {"polygon_z", "POLYGON Z ((0 0 0, 1 0 0, 0 1 0, 0 0 0))", kBad,
       "POLYGON Z has more than two coordinates"},
      {"polygon_zm", "POLYGONZM EMPTY", kBad, "POLYGON ZM has more than two coordinates"},
      {"multipolygon_m", "MultiPolygon M EMPTY", kBad,
       "MULTIPOLYGON M has more than two coordinates"},
      {"point", "POINT (1 2)", kBad, "a region needs polygons: POINT has no area", 1, 1},
      {"linestring", "LINESTRING (0 0, 1 1)", kBad, "LINESTRING has no area", 1, 1},
      {"line_in_collection", "GEOMETRYCOLLECTION (LINESTRING (0 0, 1 1))", kBad,
       "LINESTRING has no area", 1, 21},
      {"curve", "CURVEPOLYGON EMPTY", kBad, "CURVEPOLYGON is not supported", 1, 1},
      {"bad_srid", "SRID=x;POLYGON EMPTY", kBad, "number of the reference system"},
      {"extra_parenthesis", "POLYGON (((0 0, 1 0, 0 1, 0 0)))", kBad,
       "expected a number, found "
       "'('"},
      {"missing_parenthesis", "MULTIPOLYGON ((0 0, 1 0, 0 1, 0 0))", kBad, "expected '('"},
      {"binary", std::string("\x8A\r\n\x1A\n\0\0", 7), kBad, "found byte 0x8a", 1, 1},
      {"nul_bytes", std::string("POLYGON ((0 0, \0 1))", 20), kBad, "found byte 0x00", 1, 16},
      {"utf16", std::string("\xFF\xFEP\0O\0", 6), kBad, "UTF-16"},
      {"utf16_unmarked", std::string("P\0O\0L\0", 6), kBad, "UTF-16"},
      {"utf8_column", "POLYGON ((\xC3\xA9 0))", kBad, "found byte 0xc3", 1, 11},
      {"parentheses", open, kLimit, "deeper than the limit of 32"},
      {"polygon_parentheses", "POLYGON " + open, kLimit, "deeper than the limit of 32"},
      {"collections",
       [] {
         std::string text;
         for (int i = 0; i < 100'000; ++i) text += "GEOMETRYCOLLECTION (";
         return text;
       }(),
       kLimit, "deeper than the limit of 32"},
      {"digits", "POLYGON ((" + std::string(10'000, '7') + " 0))", kLimit,
       "a number of 10000 digits; the limit is 4096", 1, 11},
      {"denominator_digits", "POLYGON ((1/" + std::string(5'000, '7') + " 0))", kLimit,
       "a number of 5000 digits"},
      {"exponent", "POLYGON ((0 0, 1e1000000000 0, 0 1, 0 0))", kLimit,
       "exponent of a number is beyond the limit of ±4096", 1, 16},
      {"tiny_exponent", "POLYGON ((0 0, 1e-99999999999999999999 0))", kLimit, "beyond the limit"},
      {"zero_exponent", "POLYGON ((0e5000 0))", kLimit, "beyond the limit"},
  };
}

std::vector<Malformed> geojson_table() {
  return {
      {"array", "[1, 2]", kBad, "expected a GeoJSON object with a member \"type\""},
      {"no_type", "{}", kBad, "no member \"type\"", 1, 1},
      {"unclosed", R"({"type":"Polygon")", kBad, "expected ',' or '}', found the end"},
      {"truncated", R"({"type":"Polygon","coordinates":[[[0,0],[1,)", kBad, "expected a number"},
      {"number_type", R"({"type":3})", kBad, "expected the type in quotes"},
      {"unknown_type", R"({"type":"Blob"})", kBad, "unknown type \"Blob\""},
      {"type_with_newline", R"({"type":"a\nb"})", kBad, "unknown type \"a?b\""},
      {"no_coordinates", R"({"type":"Polygon"})", kBad, "a Polygon has no member \"coordinates\""},
      {"no_geometry", R"({"type":"Feature"})", kBad, "a Feature has no member \"geometry\""},
      {"null_coordinates", polygon_json("null"), kBad, "coordinates of a Polygon is null"},
      {"point_type", R"({"type":"Point","coordinates":[1,2]})", kBad,
       "a region needs polygons: Point has no area", 1, 9},
      {"line_in_feature", R"({"type":"Feature","geometry":{"type":"LineString"}})", kBad,
       "LineString has no area"},
      {"feature_as_geometry", R"({"type":"Feature","geometry":{"type":"Feature","geometry":null}})",
       kBad, "a Feature may not stand here"},
      {"geometry_as_feature",
       R"({"type":"FeatureCollection","features":[{"type":"Polygon","coordinates":[]}]})", kBad,
       "expected a Feature, found the type \"Polygon\""},
      {"collection_in_collection",
       R"({"type":"FeatureCollection","features":[{"type":"FeatureCollection","features":[]}]})",
       kBad, "a FeatureCollection may not stand here"},
      {"too_shallow", polygon_json("[[0,0],[1,0],[0,1],[0,0]]"), kBad,
       "expected a position [x, y], found '0'"},
      {"too_deep", polygon_json("[[[[0,0],[1,0],[0,1],[0,0]]]]"), kBad,
       "arrays are nested too deep"},
      {"open_ring", polygon_json("[[[0,0],[1,0],\n[0,1],[1,1]]]"), kBad,
       "polygon 1, ring 1 is not closed", 1, 34},
      {"few_points", polygon_json("[[[0,0],[1,0],[0,0]]]"), kBad, "ring 1 has 3 points"},
      {"empty_ring", polygon_json("[[],[]]"), kBad, "ring 1 has 0 points"},
      {"one_coordinate", polygon_json("[[[0]]]"), kBad, "',' and the second coordinate"},
      {"three_coordinates", polygon_json("[[[0,0,0]]]"), kBad, "more than two coordinates"},
      {"nan", polygon_json("[[[NaN,0]]]"), kBad, "must be a finite number, found 'NaN'"},
      {"infinity", polygon_json("[[[0,-Infinity]]]"), kBad, "must be a finite number"},
      {"null_number", polygon_json("[[[null,0]]]"), kBad, "expected a number, found 'null'"},
      {"leading_zero", polygon_json("[[[01,0]]]"), kBad, "may not start with 0"},
      {"leading_plus", polygon_json("[[[+1,0]]]"), kBad, "expected a number, found '+1'"},
      {"leading_point", polygon_json("[[[.5,0]]]"), kBad, "expected a number, found '.5'"},
      {"trailing_point", polygon_json("[[[5.,0]]]"), kBad, "expected a digit after the point"},
      {"bare_quotient", polygon_json("[[[1/3,0]]]"), kBad, "',' and the second coordinate"},
      {"bad_string_number", polygon_json(R"([[["1/3x",0]]])"), kBad, "after the number"},
      {"empty_string_number", polygon_json(R"([[["",0]]])"), kBad, "expected a number"},
      {"trailing_comma", polygon_json("[[[0,0],]]"), kBad, "expected a position [x, y], found ']'"},
      {"single_quotes", "{'type':'Polygon'}", kBad, "expected the name of a member in quotes"},
      {"missing_colon", R"({"type" "Polygon"})", kBad, "expected ':'"},
      {"second_type", R"({"type":"Polygon","type":"Polygon"})", kBad, "a second member \"type\""},
      {"second_coordinates", R"({"type":"Polygon","coordinates":[],"coordinates":[]})", kBad,
       "a second member \"coordinates\""},
      {"trailing", R"({"type":"Polygon","coordinates":[]} {})", kBad,
       "expected the end of the line or of the text", 1, 37},
      {"open_string", R"({"type":"Poly)", kBad, "a string has no end", 1, 9},
      {"bad_escape", R"({"t\x":1})", kBad, "expected an escape that JSON knows"},
      {"bad_unicode", R"({"t\u12G4":1})", kBad, "expected four hexadecimal digits"},
      {"half_surrogate", R"({"t\ud800":1})", kBad, "surrogate"},
      {"control_character", "{\"a\nb\":1}", kBad, "control character"},
      {"bad_literal", R"({"a":nul})", kBad, "expected a JSON value, found 'nul'"},
      {"bad_property", R"({"a":{"b":[1,?]}})", kBad, "expected a JSON value, found '?'"},
      {"coordinates_object", polygon_json("{}"), kBad, "expected an array of rings, found '{'"},
      {"brackets", std::string(10'000'000, '['), kBad, "expected a GeoJSON object"},
      {"deep_property", R"({"a":)" + std::string(10'000'000, '['), kLimit,
       "deeper than the limit of 32"},
      {"deep_coordinates", R"({"coordinates":)" + std::string(10'000'000, '['), kLimit,
       "deeper than the limit of 32"},
      {"digits", polygon_json("[[[" + std::string(10'000, '3') + ",0]]]"), kLimit,
       "a number of 10000 digits"},
      {"exponent", polygon_json("[[[1e1000000000,0]]]"), kLimit, "beyond the limit of ±4096"},
  };
}

std::vector<Malformed> plain_table() {
  return {
      {"poly_truncated", "1\n4 out\n0 0\n1 0\n", kBad, "expected a number, found the end"},
      {"poly_kind", "1\n3 hole\n0 0\n1 0\n0 1\n1 2 3\n", kBad, "expected 'out' or 'in'", 2, 3},
      {"poly_hole_first", "1\n3 in\n0 0\n1 0\n0 1\n1 2 3\n", kBad, "no outer chain comes before"},
      {"poly_two_points", "1\n2 out\n0 0\n1 0\n1 2\n", kBad, "chain 1 has 2 points", 2, 1},
      {"poly_order_twice", "1\n3 out\n0 0\n1 0\n0 1\n1 2 2\n", kBad,
       "must name each of 1 to 3 once, found 2", 6, 5},
      {"poly_order_zero", "1\n3 out\n0 0\n1 0\n0 1\n0 1 2\n", kBad, "found 0"},
      {"poly_order_beyond", "1\n3 out\n0 0\n1 0\n0 1\n1 2 4\n", kBad, "found 4"},
      {"poly_order_short", "1\n3 out\n0 0\n1 0\n0 1\n1 2\n", kBad,
       "order of the points of chain 1"},
      {"poly_extra_chain", "1\n3 out\n0 0\n1 0\n0 1\n1 2 3\n3 out\n", kBad,
       "the end of the text after 1 chains"},
      {"poly_missing_chain", "2\n3 out\n0 0\n1 0\n0 1\n1 2 3\n", kBad,
       "the number of points of chain 2"},
      {"poly_glued", "1\n3 out\n-6.64248.788605\n1 0\n0 1\n1 2 3\n", kBad,
       "expected a space, found '.788605'", 3, 9},
      {"poly_huge_count", "1\n999999999999999999 out\n0 0\n", kBad, "found the end of the text"},
      {"poly_long_count", "1\n9999999999999999999999 out\n", kLimit, "more than 18 digits"},
      {"dat_truncated", "4\n0 0\n1 0\n", kBad, "expected a number, found the end"},
      {"dat_two_points", "2\n0 0\n1 0\n", kBad, "a ring has 2 points"},
      {"dat_word", "3\n0 0\n1 zero\n0 1\n", kBad, "expected a number, found 'zero'", 3, 3},
      {"dat_extra", "3\n0 0\n1 0\n0 1\n7 7\n", kBad, "found the end of the text"},
      {"dat_nan", "3\n0 0\n1 nan\n0 1\n", kBad, "must be a finite number"},
      {"dat_exponent", "3\n0 0\n1 1e5000\n0 1\n", kLimit, "beyond the limit"},
      {"dat_real_count", "3.5\n0 0\n1 0\n0 1\n", kBad, "expected the number of points"},
      {"comment_only", "# nothing\n", kBad, "found the end of the text"},
  };
}

// Returns texts that are not geometries either.
std::vector<Malformed> geometry_table() {
  const auto json = [](const std::string& type, const std::string& coordinates) {
    return R"({"type":")" + type + R"(","coordinates":)" + coordinates + "}";
  };
  return {
      {"word", "PINT (1 2)", kBad,
       "expected POLYGON, LINESTRING, POINT, MULTI... or GEOMETRYCOLLECTION, found 'PINT'", 1, 1},
      {"triangle", "TRIANGLE ((0 0, 1 0, 0 1, 0 0))", kBad, "TRIANGLE is not supported", 1, 1},
      {"point_z", "POINT Z (1 2 3)", kBad, "POINT Z has more than two coordinates"},
      {"line_m", "LINESTRINGM EMPTY", kBad, "LINESTRING M has more than two coordinates"},
      {"point_heights", "POINT (1 2 3)", kBad, "a point has more than two coordinates", 1, 12},
      {"multipoint_z", "MULTIPOINT ZM ((1 2 3 4))", kBad,
       "MULTIPOINT ZM has more than two coordinates"},
      {"point_open", "POINT (1 2", kBad, "expected ')', found the end of the text", 1, 11},
      {"two_points", "POINT (1 2, 3 4)", kBad, "expected ')', found ','", 1, 11},
      {"bare_point", "POINT 1 2", kBad, "expected '(' or EMPTY", 1, 7},
      {"half_point", "MULTIPOINT (1 2, 3)", kBad, "a space and the second coordinate", 1, 19},
      {"nan_point", "POINT (nan nan)", kBad, "must be a finite number", 1, 8},
      {"line_of_one", "MULTILINESTRING ((0 0, 1 1),\n (2 2))", kBad,
       "a line has 1 point, it needs at least 2", 2, 2},
      {"open_ring", "POLYGON ((0 0, 1 0))", kBad, "polygon 1, ring 1 is not closed", 1, 10},
      {"empty_ring", "POLYGON (EMPTY)", kBad, "a ring may not be EMPTY"},
      {"deep", "MULTILINESTRING ((((1 2))))", kBad, "expected a number, found '('"},
      {"parentheses", "MULTIPOINT " + std::string(100'000, '('), kLimit, "deeper than the limit"},
      {"json_line_of_one", json("LineString", "[[0,0]]"), kBad, "a line has 1 point", 1, 36},
      {"json_empty_ring", json("Polygon", "[[],[]]"), kBad, "ring 1 has 0 points, a ring needs"},
      {"json_flat_line", json("LineString", "[0,0]"), kBad, "expected a position [x, y]"},
      {"json_deep_point", json("Point", "[[0,0]]"), kBad, "arrays are nested too deep"},
      {"json_point_height", json("Point", "[0,0,0]"), kBad, "more than two coordinates"},
      {"json_null_point", json("Point", "null"), kBad, "the coordinates of a Point is null"},
      {"json_no_points", R"({"type":"MultiPoint"})", kBad, "has no member \"coordinates\""},
      {"json_feature", R"({"type":"Feature","geometry":{"type":"Blob"}})", kBad, "unknown type"},
      {"poly_no_points", "1\n0 out\n\n", kBad, "chain 1 has 0 points, a chain needs at least 1"},
      {"dat_no_points", "0\n0 0\n", kBad, "a ring has 0 points, it needs at least 1", 1, 1},
      {"dat_cut", "2\n0 0\n1\n", kBad, "found the end of the text"},
  };
}

template <typename Read>
void check(const Malformed& row, Read read_it) {
  try {
    read_it(row.text);
    ADD_FAILURE() << row.name << ": no error";
  } catch (const ReadError& error) {
    EXPECT_EQ(error.code(), row.code) << row.name << ": " << error.what();
    EXPECT_NE(std::string(error.what()).find(row.message), std::string::npos)
        << row.name << ": " << error.what();
    EXPECT_GE(error.line(), 1U) << row.name;
    if (row.line != 0) {
      EXPECT_EQ(error.line(), row.line) << row.name << ": " << error.what();
      EXPECT_EQ(error.column(), row.column) << row.name << ": " << error.what();
    }
  }
}

void check(const Malformed& row) {
  check(row, [](const std::string& text) { static_cast<void>(read(text)); });
}

TEST(Malformed, Wkt) {
  for (const Malformed& row : wkt_table()) check(row);
}

TEST(Malformed, GeoJson) {
  for (const Malformed& row : geojson_table()) check(row);
}

TEST(Malformed, PolyAndDat) {
  for (const Malformed& row : plain_table()) check(row);
}

TEST(Malformed, Geometries) {
  for (const Malformed& row : geometry_table()) {
    check(row, [](const std::string& text) { static_cast<void>(read_geometry(text)); });
  }
}

// Every prefix of a good text is an error or a region, and never crashes the reader.
TEST(Malformed, EveryPrefixIsHandled) {
  for (const std::string& text :
       {std::string("SRID=1;MULTIPOLYGON (((0 0, 1e2 0, 1/2 -.5, 0 0)), EMPTY)"),
        std::string(
            R"({"a":[true,{"\u00e9":"\\"}],"coordinates":[[[0,0],[1.5e1,0],["1/2",1],[0,0]]],)"
            R"("type":"Polygon"})"),
        std::string("1 # c\n3 out\n0 0\n1.5 0\n0 1/2\n2 1 3\n"),
        std::string("3\n0 0\n1 0\n0 1\n1\n3\n0 0 1/3 0 0 1")}) {
    EXPECT_NO_THROW(static_cast<void>(read(text))) << text;
    for (std::size_t length = 0; length < text.size(); ++length) {
      try {
        static_cast<void>(read(text.substr(0, length)));
      } catch (const ReadError& error) {
        EXPECT_EQ(error.code(), kBad) << text.substr(0, length);
      }
    }
  }
}

TEST(Malformed, DepthAndSizeLimitsAreThoseGiven) {
  ReadOptions limits;
  limits.max_depth = 3;
  const std::string nested = "GEOMETRYCOLLECTION (GEOMETRYCOLLECTION (POLYGON EMPTY))";
  EXPECT_TRUE(read(nested, limits).empty());
  limits.max_depth = 1;
  EXPECT_THROW(static_cast<void>(read(nested, limits)), ReadError);
  limits.max_bytes = nested.size() - 1;
  try {
    static_cast<void>(read(nested, limits));
    FAIL() << "no error";
  } catch (const ReadError& error) {
    EXPECT_EQ(error.code(), kLimit);
    EXPECT_NE(std::string(error.what()).find("54 bytes"), std::string::npos) << error.what();
  }
}

TEST(Files, AreReadOrSayWhyNot) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir());
  const std::filesystem::path file =
      folder / ("minksum_io_test_" + std::to_string(std::hash<std::string>{}(folder.string())));
  std::ofstream(file) << "POLYGON ((0 0, 1 0, 0 1, 0 0))\n";
  EXPECT_EQ(read_file(file.string()).vertex_count(), 3U);
  ReadOptions limits;
  limits.max_bytes = 31;
  EXPECT_EQ(read_file(file.string(), limits).vertex_count(), 3U);
  limits.max_bytes = 30;
  EXPECT_THROW(static_cast<void>(read_file(file.string(), limits)), ReadError);
  std::filesystem::remove(file);
  const auto reason = [](const std::string& path) -> std::string {
    try {
      static_cast<void>(read_file(path));
    } catch (const ReadError& error) {
      EXPECT_EQ(error.code(), kBad);
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(reason(file.string()), "cannot be read: No such file or directory");
  EXPECT_EQ(reason(folder.string()), "cannot be read: Is a directory");
  limits.max_bytes = 1'000'000;
  try {
    static_cast<void>(read_file("/dev/zero", limits));
    FAIL() << "no error";
  } catch (const ReadError& error) {
    EXPECT_EQ(error.code(), kLimit) << error.what();
  }
}

// Each text has millions of bytes and takes well under a second. The structure is compared.
TEST(Files, LargeTextsAreNoProblem) {
  constexpr int kCount = 200'000;
  std::string wkt = "POLYGON ((";
  std::string json = R"({"type":"Polygon","coordinates":[[)";
  const auto add = [&](int i) {
    const std::string x = std::to_string(i) + ".000001";
    const std::string y = std::to_string((i % 1000) * 37) + ".125";
    wkt += x + ' ' + y + ", ";
    json += '[' + x + ',' + y + "],";
  };
  for (int i = 0; i < kCount; ++i) add(i);
  wkt += "0.000001 0.125))";
  json += "[0.000001,0.125]]]}";
  ASSERT_GT(wkt.size(), 4'000'000U);
  const Region from_wkt = read(wkt);
  EXPECT_EQ(from_wkt.vertex_count(), static_cast<std::size_t>(kCount));
  EXPECT_EQ(from_wkt.exact_x(kCount - 1), Rational(199999000001, 1000000));
  EXPECT_EQ(from_wkt, read(json));
}

}  // namespace
}  // namespace minksum::io
