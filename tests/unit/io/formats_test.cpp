// Tests that each format is read exactly, and tests writing and round trips.
#include <gtest/gtest.h>

#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "minksum/io.hpp"
#include "minksum/round.hpp"
#include "support/random.hpp"

namespace minksum::io {
namespace {

using Style = Coordinates::Style;

std::string written(const Region& region, Format format, const Coordinates& style) {
  std::ostringstream out;
  write(out, region, format, style);
  return out.str();
}

Region unit_triangle() {
  Region region;
  region.begin_polygon();
  region.begin_ring();
  region.add_vertex(0, 0);
  region.add_vertex(1, 0);
  region.add_vertex(0, 1);
  return region;
}

const std::string kFrame = "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (3 3, 3 6, 6 6, 3 3))";

TEST(Wkt, NumbersAreWhatTheySay) {
  const Region region = read(
      "POLYGON ((0.1 -1/3, 1e3 +2.50, 123456789012345678901234567890.5 1e-400, .5 5., 0.1 -1/3))");
  ASSERT_EQ(region.vertex_count(), 4U);
  EXPECT_EQ(region.exact_x(0), Rational(1, 10));
  EXPECT_EQ(region.exact_y(0), Rational(-1, 3));
  EXPECT_EQ(region.exact_x(1), Rational(1000));
  EXPECT_EQ(region.exact_y(1), Rational(5, 2));
  EXPECT_EQ(region.exact_x(2).to_string(), "246913578024691357802469135781/2");
  EXPECT_EQ(region.exact_y(2), *Rational::parse("1e-400"));
  EXPECT_EQ(region.exact_x(3), Rational(1, 2));
  EXPECT_EQ(region.exact_y(3), Rational(5));
}

TEST(Wkt, TakesManySpellings) {
  const Region frame = read(kFrame);
  EXPECT_EQ(frame.hole_count(), 1U);
  for (const char* text :
       {"polygon((0 0,9 0,9 9,0 9,0 0),(3 3,3 6,6 6,3 3))",
        "  Polygon\n( (0 0\t, 9 0 ,9 9,0 9,0 0 ) ,\r\n(3 3, 3 6, 6 6, 3 3 ) ) \n",
        "SRID=4326;POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (3 3, 3 6, 6 6, 3 3))",
        "\xEF\xBB\xBFPOLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (3 3, 3 6, 6 6, 3 3))",
        "MULTIPOLYGON (((0 0, 9 0, 9 9, 0 9, 0 0), (3 3, 3 6, 6 6, 3 3)))",
        "MULTIPOLYGON (EMPTY, ((0 0, 9 0, 9 9, 0 9, 0 0), (3 3, 3 6, 6 6, 3 3)))",
        "GEOMETRYCOLLECTION (POLYGON EMPTY, GEOMETRYCOLLECTION (MULTIPOLYGON (((0 0, 9 0, 9 9, 0 "
        "9, "
        "0 0), (3 3, 3 6, 6 6, 3 3)))))"}) {
    EXPECT_EQ(read(text), frame) << text;
  }
  for (const char* text : {"POLYGON EMPTY", "multipolygon empty", "GEOMETRYCOLLECTION EMPTY"}) {
    EXPECT_TRUE(read(text).empty()) << text;
  }
  EXPECT_EQ(read("POLYGON ((0 0, 1 0, 0 1, 0.0 0/7))"), unit_triangle());
}

TEST(Wkt, IsWrittenInEveryStyle) {
  const Region region = read("POLYGON ((0 0.1, 1/3 0, -2.5 1e22, 0 0.1))");
  EXPECT_EQ(to_wkt(region), "POLYGON ((0 0.1, 0.3333333333333333 0, -2.5 1e+22, 0 0.1))");
  EXPECT_EQ(to_wkt(region, {Style::kExact}),
            "POLYGON ((0 1/10, 1/3 0, -5/2 10000000000000000000000, 0 1/10))");
  EXPECT_EQ(to_wkt(region, {Style::kDecimal, 2}),
            "POLYGON ((0.00 0.10, 0.33 0.00, -2.50 10000000000000000000000.00, 0.00 0.10))");
  EXPECT_EQ(to_wkt(read(kFrame)), kFrame);
  EXPECT_EQ(to_wkt(Region()), "POLYGON EMPTY");
  const std::string two = "MULTIPOLYGON (((0 0, 1 0, 0 1, 0 0)), ((5 5, 6 5, 5 6, 5 5)))";
  EXPECT_EQ(to_wkt(read(two)), two);
}

// A text of "()" would be no WKT at all.
TEST(Wkt, WhatHasNoVerticesIsEmpty) {
  Region region;
  region.begin_polygon();
  region.begin_ring();
  region.begin_ring();
  region.add_vertex(1, 2);
  EXPECT_EQ(to_wkt(region), "POLYGON (EMPTY, (1 2, 1 2))");
  EXPECT_EQ(to_wkt(Geometry{{}, {{}}, {}}), "LINESTRING EMPTY");
  EXPECT_EQ(to_wkt(Geometry{{}, {{}, {{0, 0}, {1, 1}}}, {}}),
            "MULTILINESTRING (EMPTY, (0 0, 1 1))");
}

TEST(Wkt, SoManyDigitsAreNotWritten) {
  for (const int digits : {-1, kMaxDecimals + 1}) {
    EXPECT_THROW((void)to_wkt(unit_triangle(), {Style::kDecimal, digits, {}}), Error);
  }
  EXPECT_NO_THROW((void)to_wkt(unit_triangle(), {Style::kDecimal, kMaxDecimals, {}}));
}

TEST(Wkt, DoublesOutOfRangeAreNotWritten) {
  const Region region = read("POLYGON ((0 0, 1e400 0, 0 1, 0 0))");
  EXPECT_THROW(static_cast<void>(to_wkt(region)), Error);
  EXPECT_EQ(read(to_wkt(region, {Style::kExact})), region);
}

TEST(GeoJson, TakesEveryContainer) {
  const std::string ring = "[[0,0],[1,0],[0.0,1e0],[0,0]]";
  const std::string polygon = R"({"type":"Polygon","coordinates":[)" + ring + "]}";
  const Region expected = unit_triangle();
  for (const std::string& text :
       {polygon, R"({"coordinates":[)" + ring + R"(],"bbox":[0,0,1,1],"type":"Polygon"})",
        R"({"type":"MultiPolygon","coordinates":[[)" + ring + "]]}",
        R"({"type":"Feature","properties":{"a":[1,{"b":null}]},"geometry":)" + polygon + "}",
        R"({"geometry":)" + polygon + R"(,"properties":null,"id":-1.5e3,"type":"Feature"})",
        R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},)"
        R"("geometry":)" +
            polygon + "}]}",
        R"({"features":[{"geometry":)" + polygon +
            R"(,"type":"Feature"}],)"
            R"("type":"FeatureCollection"})",
        R"({"type":"GeometryCollection","geometries":[)" + polygon + "]}",
        R"({"type":"Feature","geometry":{"type":"GeometryCollection","geometries":[)" + polygon +
            "]}}",
        R"({"\u0074ype":"Poly\u0067on","coordinates":[)" + ring + R"(],"é\ud83d\ude00":"\n"})",
        " \n\t" + polygon + "\r\n"}) {
    EXPECT_EQ(read(text), expected) << text;
  }
  for (const char* text :
       {R"({"type":"Polygon","coordinates":[]})", R"({"type":"MultiPolygon","coordinates":[[]]})",
        R"({"type":"FeatureCollection","features":[]})"}) {
    EXPECT_TRUE(read(text).empty()) << text;
  }
}

TEST(GeoJson, NumbersAreWhatTheySay) {
  const Region region =
      read(R"({"type":"Polygon","coordinates":[[[0.1,"-1/3"],[12345678901234567890123,1E+2],)"
           R"([1e400,-0.5e-1],["0.1","-2/6"]]]})");
  ASSERT_EQ(region.vertex_count(), 3U);
  EXPECT_EQ(region.exact_x(0), Rational(1, 10));
  EXPECT_EQ(region.exact_y(0), Rational(-1, 3));
  EXPECT_EQ(region.exact_x(1).to_string(), "12345678901234567890123");
  EXPECT_EQ(region.exact_x(2), *Rational::parse("1e400"));
  EXPECT_EQ(region.exact_y(2), Rational(-1, 20));
}

TEST(GeoJson, ExactNumbersAreDecimalsWhereTheyCanBe) {
  const Region region = read("POLYGON ((0 0.1, 1/3 0, -5/8 1/1048576, 0 0.1))");
  EXPECT_EQ(written(region, Format::kGeoJson, {Style::kExact}),
            R"({"type": "Polygon", "coordinates": [[[0,0.1], ["1/3",0], )"
            R"([-0.625,0.00000095367431640625], [0,0.1]]]})");
  EXPECT_EQ(written(region, Format::kGeoJson, {}),
            R"({"type": "Polygon", "coordinates": [[[0,0.1], [0.3333333333333333,0], )"
            R"([-0.625,9.5367431640625e-07], [0,0.1]]]})");
  EXPECT_EQ(written(Region(), Format::kGeoJson, {}), R"({"type": "Polygon", "coordinates": []})");
}

TEST(Poly, ReadsChainsInTheirOrderOfVisits) {
  const Region region = read(
      "# a model\n2 # chains\n4 out\n0 0\n9 9 # glued in the middle\n9 0\n0 9\n1 3 2 4\n"
      "3 in\n3 3\n3 6\n6 6\n1 2 3\n");
  EXPECT_EQ(region, read(kFrame));
}

TEST(Poly, IsWritten) {
  EXPECT_EQ(written(read(kFrame), Format::kPoly, {}),
            "2\n4 out\n0 0\n9 0\n9 9\n0 9\n1 2 3 4\n3 in\n3 3\n3 6\n6 6\n1 2 3\n");
  EXPECT_EQ(written(Region(), Format::kPoly, {}), "0\n");
  EXPECT_TRUE(read("0\n").empty());
}

TEST(Dat, TellsTheLayoutsApart) {
  EXPECT_EQ(read("3 0 0 1 0 0 1"), unit_triangle());
  EXPECT_EQ(read("3\n0 0\n1/1 0\n0 1.0\n0\n"), unit_triangle());
  EXPECT_EQ(read("4 0 0 9 0 9 9 0 9\n1\n3 3 3 3 6 6 6\n"), read(kFrame));
  const Region two = read("3\n0 0 1 0 0 1\n3\n5 5 6 5 5 6\n");
  EXPECT_EQ(two.polygon_count(), 2U);
  EXPECT_EQ(two.hole_count(), 0U);
  const Region mixed = read("4 0 0 9 0 9 9 0 9\n1\n3 3 3 3 6 6 6\n3\n50 50 60 50 50 60\n0");
  EXPECT_EQ(mixed.polygon_count(), 2U);
  EXPECT_EQ(mixed.hole_count(), 1U);
}

TEST(Formats, AreToldByContent) {
  EXPECT_EQ(detect_format(" {"), Format::kGeoJson);
  EXPECT_EQ(detect_format("[1]"), Format::kGeoJson);
  EXPECT_EQ(detect_format("\xEF\xBB\xBF polygon"), Format::kWkt);
  EXPECT_EQ(detect_format("# c\n1\n3 out\n"), Format::kPoly);
  EXPECT_EQ(detect_format("3\n0 0\n"), Format::kDat);
  EXPECT_EQ(detect_format("0"), Format::kPoly);
  EXPECT_EQ(detect_format("3 0 0 1 0 0 1"), Format::kDat);
  EXPECT_EQ(detect_format("3\n1e1 0 4 0 0 4"), Format::kDat);
  EXPECT_EQ(detect_format(""), Format::kWkt);
  EXPECT_EQ(detect_format("?"), Format::kWkt);
}

TEST(Svg, IsOnePathInAFrame) {
  const std::string svg = written(read(kFrame), Format::kSvg, {});
  EXPECT_EQ(svg.find("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 1000 1000\">"), 0U);
  EXPECT_NE(svg.find("d=\"M30 970L970 970L970 30L30 30Z\nM"), std::string::npos) << svg;
  EXPECT_NE(svg.find("fill-rule=\"evenodd\""), std::string::npos);
  EXPECT_NE(written(Region(), Format::kSvg, {}).find("d=\"\""), std::string::npos);
  const Region huge = read("POLYGON ((-1e308 0, 1e308 0, 0 1e308, -1e308 0))");
  EXPECT_NE(written(huge, Format::kSvg, {}).find("M30 500L970 500L500 30Z"), std::string::npos);
  std::ostringstream out;
  EXPECT_THROW(write(out, Region(), Format::kDat), Error);
}

// The numbers are of any kind, and rings need not be valid to be read and written.
Region random_region(test::Random& random) {
  const auto number = [&random]() -> Rational {
    const auto small = random.between(-50, 50);
    switch (random.below(5)) {
      case 0:
        return Rational(small);
      case 1:
        return Rational(Decimal{static_cast<std::int64_t>(random.next()), small});
      case 2:
        return Rational(small, random.between(1, 99));
      case 3:
        return Rational(static_cast<double>(small) * 0.1);
      default:
        return Rational(static_cast<std::int64_t>(random.next())) *
               Rational(small, static_cast<std::int64_t>(random.next() >> 1U) + 1);
    }
  };
  Region region;
  const int polygons = random.below(4);
  for (int p = 0; p < polygons; ++p) {
    region.begin_polygon();
    const int rings = random.between(1, 3);
    for (int r = 0; r < rings; ++r) {
      region.begin_ring();
      const int vertices = random.between(3, 9);
      for (int v = 0; v < vertices; ++v) region.add_vertex(number(), number());
    }
  }
  return region;
}

TEST(Formats, ExactTextComesBackEqual) {
  test::Random random(31);
  for (int i = 0; i < 400; ++i) {
    const Region region = random_region(random);
    for (const Format format : {Format::kWkt, Format::kGeoJson, Format::kPoly}) {
      const std::string text = written(region, format, {Style::kExact});
      EXPECT_EQ(detect_format(text), format);
      EXPECT_EQ(read(text), region) << text;
    }
  }
}

TEST(Formats, ShortestDoublesComeBackAsTheSameDoubles) {
  test::Random random(32);
  for (int i = 0; i < 100; ++i) {
    const Region region = random_region(random);
    for (const Format format : {Format::kWkt, Format::kGeoJson, Format::kPoly}) {
      const Region again = read(written(region, format, {}));
      ASSERT_EQ(again.vertex_count(), region.vertex_count());
      for (std::size_t v = 0; v < region.vertex_count(); ++v) {
        EXPECT_EQ(again.x(v), region.x(v));
        EXPECT_EQ(again.y(v), region.y(v));
      }
    }
  }
}

}  // namespace
}  // namespace minksum::io
