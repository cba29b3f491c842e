// Tests that files of formats that are not read are refused by their names.
#include <gtest/gtest.h>

#include <string>
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
}

}  // namespace
}  // namespace minksum::io
