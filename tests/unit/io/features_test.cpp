// Tests that the features of a text are read one by one, with what they and the text say.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "minksum/io.hpp"

namespace minksum::io {
namespace {

std::vector<Feature> features_of(FeatureReader& reader) {
  std::vector<Feature> features;
  while (auto feature = reader.next()) features.push_back(std::move(*feature));
  EXPECT_FALSE(reader.next().has_value());
  return features;
}

std::string refusal(const std::string& text, const ReadOptions& options = {}) {
  try {
    static_cast<void>(read_document(text, options));
  } catch (const ReadError& error) {
    return std::to_string(error.line()) + ':' + std::to_string(error.column()) + ": " +
           error.what();
  }
  return "no error";
}

TEST(Features, OfACollection) {
  const std::string text =
      "\xEF\xBB\xBF{\"type\": \"FeatureCollection\", \"crs\": {\"n\": 1},\n"
      R"("features": [{"type": "Feature", "id": "a", "properties": {"x": [1.50]},)"
      "\n"
      R"("geometry": {"type": "Point", "coordinates": [1, 2]}},)"
      "\n"
      R"({"type": "Feature", "geometry": null},)"
      R"({"type": "Feature", "geometry": {"type": "Polygon", "coordinates": []}},)"
      "\n"
      R"({"geometry": {"coordinates": [3, 4], "type": "Point"}, "id": 7, "type": "Feature"}]})";
  FeatureReader reader(text);
  const std::vector<Feature> features = features_of(reader);
  ASSERT_EQ(features.size(), 2U);
  EXPECT_EQ(features[0].geometry, (Geometry{{}, {}, {{1, 2}}}));
  EXPECT_EQ(features[0].properties, R"({"x": [1.50]})");
  EXPECT_EQ(features[0].id, "\"a\"");
  EXPECT_EQ(features[0].index, 0U);
  EXPECT_EQ(features[0].line, 2U);
  EXPECT_EQ(features[1].geometry, (Geometry{{}, {}, {{3, 4}}}));
  EXPECT_EQ(features[1].properties, "null");
  EXPECT_EQ(features[1].id, "7");
  EXPECT_EQ(features[1].index, 3U);
  EXPECT_EQ(features[1].line, 5U);
  EXPECT_EQ(reader.source().crs, R"({"n": 1})");
  EXPECT_EQ(reader.source().features, 4U);
  EXPECT_EQ(reader.source().null_geometries, 1U);
  EXPECT_EQ(reader.source().empty_geometries, 1U);
  const Document document = read_document(text);
  EXPECT_EQ(document.geometry, (Geometry{{}, {}, {{1, 2}, {3, 4}}}));
  EXPECT_EQ(document.source.features, 4U);
  EXPECT_EQ(document.properties, std::nullopt);
}

// The features may stand before the type, and members behind them.
TEST(Features, OfObjectsInAnyOrderAndNumber) {
  const std::string collection =
      R"({"features": [{"type": "Feature", "geometry": {"type": "Point", "coordinates": [1, 2]}}],)"
      R"( "x": 1, "type": "FeatureCollection", "crs": null})";
  const std::string point = R"({"type": "Point", "coordinates": [3, 4]})";
  for (const char* between : {"\n", "\r\n", "\n\x1E", " \x1E", "\n\n"}) {
    const std::string text = collection + between + point + between + collection + "\n";
    FeatureReader reader(text);
    EXPECT_EQ(features_of(reader).size(), 3U) << between;
    EXPECT_EQ(read_geometry("\x1E" + text).points.size(), 3U) << between;
  }
  EXPECT_EQ(refusal(point + ' ' + point),
            "1:42: expected the end of the line or of the text, found '{'");
  EXPECT_EQ(refusal(point + "\n{}"), "2:1: feature 2: an object has no member \"type\"");
  EXPECT_EQ(refusal(R"({"type":"FeatureCollection","features":[],"features":[]})"),
            "1:54: a second member \"features\"");
}

TEST(Features, OfAList) {
  const std::string digits = "0101000000000000000000f03f0000000000000040";
  const std::string text = "# a list\n\nSRID=5;POINT (1 2); LINESTRING (0 0,\n 1 1)\n\"" + digits +
                           "\"\n" + digits + " # c\n'POINT (3 4)';;POINT EMPTY\n";
  EXPECT_EQ(refusal(text).substr(0, 60),
            "7:15: geometry 6: expected POLYGON, LINESTRING, POINT, MULTI");
  const std::string good = text.substr(0, text.find(";;")) + ";\nPOINT EMPTY;\n";
  FeatureReader reader(good);
  const std::vector<Feature> features = features_of(reader);
  ASSERT_EQ(features.size(), 5U);
  EXPECT_EQ(features[0].line, 3U);
  EXPECT_EQ(features[1].geometry, (Geometry{{}, {{{0, 0}, {1, 1}}}, {}}));
  EXPECT_EQ(features[2].geometry, (Geometry{{}, {}, {{1, 2}}}));
  EXPECT_EQ(features[2].line, 5U);
  EXPECT_EQ(features[4].geometry, (Geometry{{}, {}, {{3, 4}}}));
  EXPECT_EQ(features[4].properties, "");
  EXPECT_EQ(reader.source().srid, 5);
  EXPECT_EQ(reader.source().features, 6U);
  EXPECT_EQ(reader.source().empty_geometries, 1U);
  EXPECT_EQ(features_of(reader).size(), 0U);
  FeatureReader broken("POINT (1 2)\nPOINT (3)\nPOINT (5 6)");
  EXPECT_TRUE(broken.next().has_value());
  EXPECT_THROW(static_cast<void>(broken.next()), ReadError);
  EXPECT_FALSE(broken.next().has_value());
}

// Each feature counts its own polygons and vertices.
TEST(Features, ErrorsNameTheFeature) {
  const std::string triangle = "POLYGON ((0 0, 1 0, 0 1, 0 0))\n";
  EXPECT_EQ(refusal(triangle + "POLYGON ((0 0, 1 0))"),
            "2:10: geometry 2: polygon 1, ring 1 is not closed: its last point must repeat the "
            "first");
  const std::string two = triangle + triangle;
  FeatureReader reader(two, {.max_vertices = 3});
  EXPECT_EQ(features_of(reader).size(), 2U);
  EXPECT_EQ(refusal(triangle + triangle, {.max_vertices = 3}),
            "2:19: geometry 2: more vertices than the limit of 3");
}

TEST(Features, ReferenceSystemsAgree) {
  EXPECT_EQ(read_document("SRID=4326;POINT (1 2)\nPOINT (3 4)\nSRID=4326;POINT EMPTY").source.srid,
            4326);
  EXPECT_EQ(read_document("SRID=0;POINT (1 2)\nSRID=-1;POINT (3 4)").source.srid, std::nullopt);
  EXPECT_EQ(refusal("SRID=1;POINT (1 2)\nSRID=2;POINT (1 2)"),
            "2:6: geometry 2: the reference system 2 differs from that of earlier geometries, 1; "
            "transform one of them first");
  EXPECT_EQ(refusal("SRID=3000000000;POINT (1 2)"),
            "1:6: the number of a reference system has 31 bits");
  EXPECT_EQ(refusal("0101000020e6100000000000000000f03f0000000000000040\nSRID=1;POINT (1 2)"),
            "2:6: geometry 2: the reference system 1 differs from that of earlier geometries, "
            "4326; transform one of them first");
  const std::string named = R"({"type":"Point","coordinates":[1,2],"crs":{"type":"name",)"
                            R"("properties":{"name":")";
  EXPECT_EQ(srid_of(read_document(named + "EPSG:4326\"}}}\n" + named +
                                  "urn:ogc:def:crs:OGC:1.3:CRS84\"}}}")
                        .source),
            4326);
  EXPECT_EQ(
      refusal(R"({"type":"FeatureCollection","crs":1,"features":[{"crs":2}]})"),
      "1:56: feature 1: this \"crs\" differs from an earlier one; transform one of them first");
}

TEST(Features, CoordinatesBeyondTwoAreDroppedOnRequest) {
  const ReadOptions drop{.drop_z = true};
  const Geometry point{{}, {}, {{1, 2}}};
  for (const char* text :
       {"POINT Z (1 2 3)", "POINTZ(1 2 3)", "POINT M (1 2 3)", "POINT ZM (1 2 3 4)",
        "POINT (1 2 3)", "POINT (1 2 3 4)", "POINT Z (1 2 NaN)", "POINT (1 2 -1e9)", "POINT (1 2)",
        R"({"type":"Point","coordinates":[1,2,3]})", R"({"type":"Point","coordinates":[1,2,3,4]})",
        "0101000080000000000000f03f00000000000000400000000000000840",
        "01e9030000000000000000f03f00000000000000400000000000000840",
        "01b90b0000000000000000f03f000000000000004000000000000008400000000000000840"}) {
    EXPECT_EQ(read_document(text, drop).geometry, point) << text;
    if (std::string(text) == "POINT (1 2)") continue;
    EXPECT_NE(refusal(text).find("(io::ReadOptions::drop_z keeps x and y)"), std::string::npos)
        << refusal(text);
  }
  EXPECT_TRUE(read_document("POLYGON Z EMPTY", drop).geometry.empty());
  EXPECT_EQ(refusal("LINESTRING (1 2, 3 4 5)", drop),
            "1:22: a point has 3 coordinates, where 2 are expected");
  EXPECT_EQ(refusal("LINESTRING Z (1 2, 3 4 5)", drop),
            "1:18: a point has 2 coordinates, where 3 are expected");
  EXPECT_EQ(refusal("POINT (1 2 3 4 5)", drop), "1:16: a point has more than four coordinates");
  EXPECT_EQ(refusal("POINT (1 2 x)", drop), "1:12: expected a number, found 'x'");
  EXPECT_EQ(refusal("0101000080000000000000f03f0000000000000040", drop),
            "1:1: byte 22: expected a height or measure, found the end");
}

TEST(Features, OfATable) {
  const std::string table =
      "name;wkb;n\r\n"
      "\"a \"\"b\"\"\";0101000020110f0000000000000000f03f0000000000000040;1\r\n"
      "\r\n"
      "none;;2\r\n"
      "\"c\n\td\";\"SRID=3857;POINT (1/3 5)\";3";
  EXPECT_EQ(detect_format(table), Format::kTable);
  FeatureReader reader(table);
  const std::vector<Feature> features = features_of(reader);
  ASSERT_EQ(features.size(), 2U);
  EXPECT_EQ(features[0].properties, R"({"name": "a \"b\"", "n": "1"})");
  EXPECT_EQ(features[0].geometry, (Geometry{{}, {}, {{1, 2}}}));
  EXPECT_EQ(features[0].line, 2U);
  EXPECT_EQ(features[1].properties, R"({"name": "c\u000a\u0009d", "n": "3"})");
  EXPECT_EQ(features[1].geometry, (Geometry{{}, {}, {{Rational(1, 3), 5}}}));
  EXPECT_EQ(features[1].index, 2U);
  EXPECT_EQ(reader.source().null_geometries, 1U);
  EXPECT_EQ(srid_of(reader.source()), 3857);
}

TEST(Features, TheColumnOfATable) {
  const std::string table = "a,b\nPOINT (1 2),\"LINESTRING (0 0, 1 0)\"\n";
  EXPECT_EQ(refusal(table),
            "1:1: several columns hold geometries: 'a' and 'b'; io::ReadOptions::column names the "
            "one to read");
  EXPECT_EQ(read_document(table, {.column = "a"}).geometry, (Geometry{{}, {}, {{1, 2}}}));
  EXPECT_EQ(refusal(table, {.column = "c"}),
            "1:1: there is no column 'c' (io::ReadOptions::column); there are 'a', 'b'");
  EXPECT_EQ(detect_format("wkt\n\"POINT (1 2)\"\n"), Format::kTable);
  EXPECT_EQ(detect_format("POLYGON EMPTY, "), Format::kWkt);
  EXPECT_EQ(detect_format("LINESTRING (0 0, 1 1)\n"), Format::kWkt);
  EXPECT_EQ(detect_format("SRID=1;POINT EMPTY"), Format::kWkt);
}

TEST(Features, TablesAsOtherProgramsWriteThem) {
  const Geometry point{{}, {}, {{1, 2}}};
  for (const char* table :
       {",geometry\n0,POINT (1 2)\n", ",geometry,n\n0,POINT (1 2),3\n",
        ";geometry\n0;POINT (1 2)\n", "\tgeometry\tn\n0\tPOINT (1 2)\ta\n",
        "\n \r\nid,geom\n1,POINT (1 2)\n", "\n\tgeom\n1\tPOINT (1 2)\n",
        "größe,geom\n1,POINT (1 2)\n", "名,geom\n1,POINT (1 2)\n",
        "name,the_geom,area (m2)\na,POINT (1 2),3\n", "ST_AsText(geom)\nPOINT (1 2)\n",
        "id\tst_astext(geom)\n1\tPOINT (1 2)\n", "\"st_astext\"\n\"POINT (1 2)\"\n",
        "id,geom\n1,NULL\n2,\\N\n3,null\n4,POINT (1 2)\n", "name,geom\nPoint Reyes,POINT (1 2)\n",
        "name,geom\nPoint,POINT(1 2)\n", "id,geom\n1,MULTIPOINT EMPTY\n2,point(1 2)\n"}) {
    EXPECT_EQ(detect_format(table), Format::kTable) << table;
    EXPECT_EQ(read_geometry(table), point) << table;
  }
  EXPECT_EQ(read_document("id,geom\n1,POINT Z(1 2 3)\n", {.drop_z = true}).geometry, point);
  for (const char* table : {"id,geom\n", "geom", "id,geom\n1,\n2,\n", "id,geom\n1,NULL\n"}) {
    EXPECT_TRUE(read_geometry(table) == Geometry{}) << table;
  }
  EXPECT_EQ(refusal("a,geom,wkt\n1,,\n"),
            "1:1: no column of this table holds WKT, or WKB in hexadecimal digits; there are 'a', "
            "'geom', 'wkt'");
  EXPECT_EQ(detect_format("POLIGON ((0 0, 1 0, 0 1, 0 0))\n"), Format::kWkt);
  EXPECT_EQ(detect_format("\xE9,name\n"), Format::kWkt);
  EXPECT_EQ(refusal("\xE9tage,geom\n1,POINT (1 2)\n"),
            "1:1: a cell is not UTF-8; convert it first, as by iconv -f latin1 -t utf-8");
}

TEST(Features, TablesNeedNames) {
  const std::string digits = "0101000000000000000000f03f0000000000000040";
#if !defined(__wasm__)  // the module for browsers has no room for these errors
  const std::string message =
      "1:1: this looks like a table, and a table needs a first line that names its columns, such "
      "as id,wkt";
  for (const std::string& table :
       {std::string("a,POINT (1 2)\n"), std::string("1,\"POLYGON ((0 0, 1 0, 0 1, 0 0))\"\n"),
        std::string("1;POLYGON ((0 0, 1 0, 0 1, 0 0));b\n"), std::string("1\tPOINT (1 2)\tb\n"),
        "1," + digits + "\n",
        // The first row was taken for names, and its geometry was lost.
        "a," + digits + "\nb," + digits + "\n"}) {
    EXPECT_EQ(refusal(table), message) << table;
  }
  EXPECT_EQ(refusal("\n a,POINT (1 2)\n").substr(0, 8), "2:1: thi");
#endif
  const Geometry points{{}, {}, {{1, 2}, {3, 4}}};
  for (const std::string& list :
       {std::string("# a, POINT (5 6)\nPOINT (1 2); POINT (3 4)"),
        std::string("'POINT (1 2)'; \"POINT (3 4)\""), std::string("SRID=5;MULTIPOINT (1 2, 3 4)"),
        std::string("GEOMETRYCOLLECTION\t(\tPOINT (1 2), POINT (3 4))"),
        "\"" + digits + "\";POINT (3 4)", digits + ";POINT (3 4)"}) {
    EXPECT_EQ(read_geometry(list), points) << list;
  }
  EXPECT_NE(refusal("COMPOUNDCURVE (CIRCULARSTRING (0 0, 1 1, 2 0), LINESTRING (2 0, 3 0))")
                .find("COMPOUNDCURVE is not supported"),
            std::string::npos);
}

TEST(Features, ReferenceSystemsAreWritten) {
  const Geometry point{{}, {}, {{1, 2}}};
  const Coordinates by_number{.srid = 3857};
  EXPECT_EQ(to_wkt(point, by_number), "SRID=3857;POINT (1 2)");
  EXPECT_EQ(to_geojson(point, by_number),
            R"({"type": "Point", "coordinates": [1,2], "crs": {"type": "name", "properties": )"
            R"({"name": "urn:ogc:def:crs:EPSG::3857"}}})");
  const std::string crs = R"({"type":"name","properties":{"name":"EPSG:25832"}})";
  const Coordinates by_name{.crs = crs};
  EXPECT_EQ(to_wkt(point, by_name), "SRID=25832;POINT (1 2)");
  const Geometry both{{}, {{{0, 0}, {1, 0}}}, {{1, 2}}};
  for (const Geometry& geometry : {point, both}) {
    const io::Document again = read_document(to_geojson(geometry, by_name));
    EXPECT_EQ(again.geometry, geometry);
    EXPECT_EQ(again.source.crs, crs);
    const io::Document binary = read_document(to_wkb(geometry, by_number));
    EXPECT_EQ(binary.geometry, geometry);
    EXPECT_EQ(binary.source.srid, 3857);
  }
  EXPECT_EQ(srid_of(SourceInfo{.crs = R"({"name": "urn:ogc:def:crs:OGC:1.3:CRS84"})"}), 4326);
  EXPECT_EQ(srid_of(SourceInfo{.crs = R"({"name": "urn:ogc:def:crs:OGC:2:Mars"})"}), std::nullopt);
}

}  // namespace
}  // namespace minksum::io
