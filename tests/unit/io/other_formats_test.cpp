// Tests that files of formats that are not read are refused by their names.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "minksum/io.hpp"

namespace minksum::io {
namespace {

TEST(OtherFormats, AreNamed) {
  struct Other {
    std::string text;
    const char* message;
  };
  using namespace std::string_literals;
  const std::vector<Other> others = {
    {"\0\0\x27\x0A\0\0\0\0"s, "this looks like a Shapefile, which is not read: give it"},
    {"\x1F\x8B\x08", "this looks like a gzip archive, which is not read: unpack it first"},
    {"SQLite format 3\0..."s, "this looks like an SQLite database, such as GeoPackage"},
    {"AutoCAD Binary DXF\r\n", "this looks like a binary DXF drawing, which is not read: export"},
    {"<ogr:FeatureCollection xmlns:ogr='x'>", "this looks like GML"},
    {"\xEF\xBB\xBF<kml>", "this looks like KML"},
    {"<!DOCTYPE html><HTML>", "this looks like a page in HTML"},
    {"<", "this looks like XML"},
    {"<!-- no end", "this looks like XML"},
#if !defined(__wasm__)  // the module for browsers has no room to name it
    {"# a square\n4 2 0 1\n1 0 0 1\n2 1 0 1\n3 1 1 1\n4 0 1 1\n4 1\n1 1 2 1\n",
     "this looks like a file of Triangle (.poly, .node), which is not read: write its outlines"},
    {"3 2 1 0\r\n\r\n0 0 0 7\r\n1 1 0 7\r\n2 1 1 7\r\n", "this looks like a file of Triangle"},
    {"0 2 0 1\n3 1\n1 1 2 1\n", "this looks like a file of Triangle"},
#endif
  };
  for (const Other& other : others) {
    try {
      static_cast<void>(read_geometry(other.text));
      ADD_FAILURE() << other.message;
    } catch (const ReadError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with(other.message)) << error.what();
      EXPECT_EQ(error.line(), 1U);
      EXPECT_EQ(error.column(), 1U);
    }
  }
  EXPECT_EQ(read("3\n0 0\n1 0\n0 1\n"s).vertex_count(), 3U);
  EXPECT_EQ(read("4 2 0 0\n1 0 0 1\n1\n"s).vertex_count(), 4U);
}

#if !defined(__wasm__)  // the module for browsers has no room to name these
TEST(OtherFormats, JsonIsNamed) {
  const std::string topology = "this looks like TopoJSON, which is not read: convert it to GeoJSON";
  const std::string esri = "this looks like Esri JSON, which is not read: ask its server for";
  const std::string square = R"({"rings": [[[0, 0], [0, 1], [1, 1], [0, 0]]]})";
  const std::vector<std::pair<std::string, std::string>> others = {
      {R"({"type": "Topology", "objects": {}, "arcs": []})", topology},
      {R"({"arcs": [], "objects": {}, "type": "Topology"})", topology},
      {square, esri},
      {R"({"paths": [[[0, 0], [1, 1]]]})", esri},
      {R"({"x": 1, "y": 2, "spatialReference": {"wkid": 4326}})", esri},
      {R"({"geometryType": "esriGeometryPolygon", "features": [{"geometry": )" + square + "}]}",
       esri},
      {R"({"type": "FeatureCollection", "features": [{"attributes": {}, "geometry": )" + square +
           "}]}",
       "feature 1: " + esri},
      {R"({"x": 1, "y": 2})", "an object has no member \"type\""},
  };
  for (const auto& [text, message] : others) {
    try {
      static_cast<void>(read_geometry(text));
      ADD_FAILURE() << text;
    } catch (const ReadError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with(message)) << error.what();
    }
  }
  EXPECT_EQ(read_geometry(R"({"rings": 1, "type": "Point", "coordinates": [1, 2]})"),
            (Geometry{{}, {}, {{1, 2}}}));
}
#endif

}  // namespace
}  // namespace minksum::io
