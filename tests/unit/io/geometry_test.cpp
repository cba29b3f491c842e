// Tests reading, writing and round trips of areas, polylines and points in every format.
#include <gtest/gtest.h>

#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "minksum/io.hpp"
#include "support/random.hpp"

namespace minksum::io {
namespace {

using Style = Coordinates::Style;

std::string written(const Geometry& geometry, Format format, const Coordinates& style = {}) {
  std::ostringstream out;
  write(out, geometry, format, style);
  return out.str();
}

Region polygon(std::vector<std::pair<int, int>> ring) {
  Region region;
  region.begin_polygon();
  region.begin_ring();
  for (const auto& [x, y] : ring) region.add_vertex(x, y);
  return region;
}

const Polyline kBent = {{0, 0}, {Rational(1, 3), 2}, {5, 0}};
const Polyline kSegment = {{7, 7}, {8, 9}};

TEST(Geometries, Wkt) {
  const std::vector<std::pair<std::string, Geometry>> table = {
      {"POINT (1/2 -3)", {{}, {}, {{Rational(1, 2), -3}}}},
      {" point( 1e1 .5 ) ", {{}, {}, {{10, Rational(1, 2)}}}},
      {"POINT EMPTY", {}},
      {"MULTIPOINT ((1 2), (3 4), (1 2))", {{}, {}, {{1, 2}, {3, 4}, {1, 2}}}},
      {"MULTIPOINT (1 2, 3 4)", {{}, {}, {{1, 2}, {3, 4}}}},
      {"MULTIPOINT(1 2,EMPTY,(3 4))", {{}, {}, {{1, 2}, {3, 4}}}},
      {"MULTIPOINT EMPTY", {}},
      {"LINESTRING (0 0, 1/3 2, 5 0)", {{}, {kBent}, {}}},
      {"LINESTRING (1 1, 1 1)", {{}, {{{1, 1}, {1, 1}}}, {}}},
      {"LINESTRING EMPTY", {}},
      {"LINEARRING (7 7, 8 9)", {{}, {kSegment}, {}}},
      {"LinearRing EMPTY", {}},
      {"MULTILINESTRING ((0 0, 1/3 2, 5 0), EMPTY, (7 7, 8 9))", {{}, {kBent, kSegment}, {}}},
      {"SRID=7;MULTILINESTRING EMPTY", {}},
      {"GEOMETRYCOLLECTION (POINT (1 2), POLYGON ((0 0, 1 0, 0 1, 0 0)), GEOMETRYCOLLECTION "
       "(LINESTRING (7 7, 8 9), GEOMETRYCOLLECTION EMPTY), POINT (3 4), POLYGON EMPTY)",
       {polygon({{0, 0}, {1, 0}, {0, 1}}), {kSegment}, {{1, 2}, {3, 4}}}},
  };
  for (const auto& [text, geometry] : table) EXPECT_EQ(read_geometry(text), geometry) << text;
}

TEST(Geometries, GeoJson) {
  const auto json = [](const std::string& type, const std::string& coordinates) {
    return R"({"type":")" + type + R"(","coordinates":)" + coordinates + "}";
  };
  const std::vector<std::pair<std::string, Geometry>> table = {
      {json("Point", R"(["1/2",-3])"), {{}, {}, {{Rational(1, 2), -3}}}},
      {json("Point", " [ ] "), {}},
      {json("MultiPoint", "[[1,2],[3,4]]"), {{}, {}, {{1, 2}, {3, 4}}}},
      {json("MultiPoint", "[]"), {}},
      {json("Polygon", " [ [ ] ] "), {}},
      {json("MultiPolygon", "[[[]],[[[0,0],[1,0],[0,1],[0,0]]],[]]"),
       {polygon({{0, 0}, {1, 0}, {0, 1}}), {}, {}}},
      {json("LineString", "[[7,7],[8,9]]"), {{}, {kSegment}, {}}},
      {json("LineString", "[]"), {}},
      {json("MultiLineString", R"([[[0,0],["1/3",2],[5,0]],[],[[7,7],[8,9]]])"),
       {{}, {kBent, kSegment}, {}}},
      {R"({"coordinates":[1,2],"type":"Point"})", {{}, {}, {{1, 2}}}},
      {R"({"type":"FeatureCollection","features":[{"type":"Feature","geometry":)" +
           json("Point", "[1,2]") + R"(},{"geometry":{"geometries":[)" +
           json("LineString", "[[7,7],[8,9]]") + "," +
           json("Polygon", "[[[0,0],[1,0],[0,1],[0,0]]]") +
           R"(],"type":"GeometryCollection"},"type":"Feature"}]})",
       {polygon({{0, 0}, {1, 0}, {0, 1}}), {kSegment}, {{1, 2}}}},
  };
  for (const auto& [text, geometry] : table) EXPECT_EQ(read_geometry(text), geometry) << text;
}

TEST(Geometries, CollapsedRings) {
  const Region segment = polygon({{0, 0}, {4, 2}});
  const Region dot = polygon({{3, 5}});
  const Region twice = polygon({{3, 5}, {3, 5}, {3, 5}});
  const std::vector<std::pair<std::string, Region>> table = {
      {"POLYGON ((0 0, 4 2, 0 0))", segment},
      {"POLYGON ((3 5))", dot},
      {"POLYGON ((3 5, 3 5))", dot},
      {"POLYGON ((3 5, 3 5, 3 5, 3.0 10/2))", twice},
      {R"({"type":"Polygon","coordinates":[[[0,0],[4,2],[0,0]]]})", segment},
      {R"({"type":"Polygon","coordinates":[[[3,5]]]})", dot},
      {"1\n2 out\n0 0\n4 2\n1 2\n", segment},
      {"1\n1 out\n3 5\n1\n", dot},
      {"2\n0 0\n4 2\n", segment},
      {"1\n3 5\n", dot},
  };
  for (const auto& [text, region] : table) {
    EXPECT_EQ(read_geometry(text), (Geometry{region, {}, {}})) << text;
    if (region == twice) continue;  // it has three vertices, so its form has no fault
    EXPECT_THROW(static_cast<void>(read(text)), ReadError) << text;
  }
}

// If rings of one point were tried first, the first text would be three polygons. It is a region
// with a hole.
TEST(Geometries, DatMeansTheSameAsForRegions) {
  for (const char* text :
       {"3 0 0 9 0 0 9 1 4 2 3 1 1 2 2 1 3", "4 0 0 9 0 9 9 0 9\n1\n3 1 1 2 1 1 2"}) {
    EXPECT_EQ(read_geometry(text).region, read(text));
    EXPECT_EQ(read_geometry(text).region.hole_count(), 1U);
  }
  const char* const tiny = "1 4 2 3 1 1 2 2 1 3";
  EXPECT_THROW(static_cast<void>(read(tiny)), ReadError);
  EXPECT_EQ(read_geometry(tiny).region.polygon_count(), 2U);
}

TEST(Geometries, AreWrittenByKinds) {
  const Region triangle = polygon({{0, 0}, {1, 0}, {0, 1}});
  const std::string area = "POLYGON ((0 0, 1 0, 0 1, 0 0))";
  const std::vector<std::pair<std::string, Geometry>> table = {
      {"POLYGON EMPTY", {}},
      {area, {triangle, {}, {}}},
      {"LINESTRING (7 7, 8 9)", {{}, {kSegment}, {}}},
      {"MULTILINESTRING ((0 0, 1/3 2, 5 0), (7 7, 8 9))", {{}, {kBent, kSegment}, {}}},
      {"POINT (1 2)", {{}, {}, {{1, 2}}}},
      {"MULTIPOINT ((1 2), (3 4))", {{}, {}, {{1, 2}, {3, 4}}}},
      {"GEOMETRYCOLLECTION (" + area + ", POINT (1 2))", {triangle, {}, {{1, 2}}}},
      {"GEOMETRYCOLLECTION (LINESTRING (7 7, 8 9), MULTIPOINT ((1 2), (3 4)))",
       {{}, {kSegment}, {{1, 2}, {3, 4}}}},
      {"GEOMETRYCOLLECTION (" + area + ", LINESTRING (7 7, 8 9), POINT (1 2))",
       {triangle, {kSegment}, {{1, 2}}}},
  };
  for (const auto& [text, geometry] : table) {
    EXPECT_EQ(to_wkt(geometry, {Style::kExact}), text);
    EXPECT_EQ(read_geometry(text), geometry) << text;
  }
  const Geometry all = {triangle, {kBent}, {{1, Rational(2, 3)}}};
  EXPECT_EQ(written(all, Format::kGeoJson, {Style::kExact}),
            R"({"type": "GeometryCollection", "geometries": [{"type": "Polygon", "coordinates": )"
            R"([[[0,0], [1,0], [0,1], [0,0]]]}, {"type": "LineString", "coordinates": [[0,0], )"
            R"(["1/3",2], [5,0]]}, {"type": "Point", "coordinates": [1,"2/3"]}]})");
  EXPECT_EQ(written({}, Format::kGeoJson), R"({"type": "Polygon", "coordinates": []})");
  EXPECT_EQ(to_wkt(all, {Style::kDecimal, 1}),
            "GEOMETRYCOLLECTION (POLYGON ((0.0 0.0, 1.0 0.0, 0.0 1.0, 0.0 0.0)), LINESTRING (0.0 "
            "0.0, 0.3 2.0, 5.0 0.0), POINT (1.0 0.7))");
}

TEST(Geometries, PolyHasNoThinParts) {
  EXPECT_EQ(written({polygon({{0, 0}, {4, 2}}), {}, {}}, Format::kPoly),
            "1\n2 out\n0 0\n4 2\n1 2\n");
  for (const Geometry& thin : {Geometry{{}, {kSegment}, {}}, Geometry{{}, {}, {{1, 2}}}}) {
    try {
      static_cast<void>(written(thin, Format::kPoly));
      ADD_FAILURE() << "no error";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadInput);
    }
  }
  EXPECT_THROW(static_cast<void>(to_wkt({{}, {}, {{*Rational::parse("1e400"), 0}}})), Error);
}

TEST(Geometries, SvgDrawsStrokesAndDots) {
  const std::string svg =
      written({polygon({{0, 0}, {2, 0}, {0, 2}}), {{{0, 0}, {4, 4}}}, {{4, 0}}}, Format::kSvg);
  EXPECT_NE(svg.find("d=\"M30 970L500 970L30 500Z\n"), std::string::npos) << svg;
  EXPECT_NE(svg.find("d=\"M30 970L970 30\n"), std::string::npos) << svg;
  EXPECT_NE(svg.find("r=\"4\" cx=\"970\" cy=\"970\""), std::string::npos) << svg;
  const std::string dot = written({{}, {}, {{4, 0}}}, Format::kSvg);
  EXPECT_EQ(dot.find("<path"), std::string::npos) << dot;
  EXPECT_NE(dot.find("<circle"), std::string::npos) << dot;
}

Rational random_number(test::Random& random) {
  const int small = random.between(-50, 50);
  switch (random.below(3)) {
    case 0:
      return small;
    case 1:
      return Rational(Decimal{static_cast<std::int64_t>(random.next()), small});
    default:
      return Rational(small, random.between(1, 99));
  }
}

Geometry random_geometry(test::Random& random) {
  Geometry geometry;
  const auto point = [&random] { return Point{random_number(random), random_number(random)}; };
  for (int i = random.below(3); i > 0; --i) {
    geometry.region.begin_polygon();
    for (int ring = random.between(1, 2); ring > 0; --ring) {
      geometry.region.begin_ring();
      for (int v = random.between(1, 5); v > 0; --v) {
        const Point vertex = point();
        geometry.region.add_vertex(vertex.x, vertex.y);
      }
    }
  }
  for (int i = random.below(3); i > 0; --i) {
    geometry.polylines.emplace_back();
    for (int v = random.between(2, 5); v > 0; --v) geometry.polylines.back().push_back(point());
  }
  for (int i = random.below(3); i > 0; --i) geometry.points.push_back(point());
  return geometry;
}

TEST(Geometries, ExactTextComesBackEqual) {
  test::Random random(41);
  for (int i = 0; i < 500; ++i) {
    const Geometry geometry = random_geometry(random);
    for (const Format format : {Format::kWkt, Format::kGeoJson, Format::kPoly}) {
      if (format == Format::kPoly && geometry.has_thin_parts()) continue;
      const std::string text = written(geometry, format, {Style::kExact});
      EXPECT_EQ(read_geometry(text), geometry) << text;
    }
  }
}

// A text that is a region is the same geometry.
TEST(Geometries, RegionsAreReadAlike) {
  for (const char* text : {"POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (3 3, 3 6, 6 6, 3 3))",
                           R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[0,1],[0,0]]]})",
                           "1\n3 out\n0 0\n1 0\n0 1\n1 2 3\n", "3 0 0 1 0 0 1", "POLYGON EMPTY"}) {
    const Geometry geometry = read_geometry(text);
    EXPECT_EQ(geometry.region, read(text)) << text;
    EXPECT_FALSE(geometry.has_thin_parts());
  }
}

TEST(Geometries, EveryPrefixIsHandled) {
  for (const std::string& text :
       {std::string("GEOMETRYCOLLECTION (MULTIPOINT ((0 0), 1e2 0), LINESTRING (1/2 -.5, 0 0))"),
        std::string(R"({"type":"MultiLineString","coordinates":[[[0,0],["1/2",1]],[]]})"),
        std::string("2\n1 out\n0 0\n1\n2 in\n3 4\n5 6\n2 1\n"), std::string("2\n0 0\n1 0\n")}) {
    EXPECT_NO_THROW(static_cast<void>(read_geometry(text))) << text;
    for (std::size_t length = 0; length < text.size(); ++length) {
      try {
        static_cast<void>(read_geometry(text.substr(0, length)));
      } catch (const ReadError& error) {
        EXPECT_EQ(error.code(), ErrorCode::kBadInput) << text.substr(0, length);
      }
    }
  }
}

TEST(Geometries, VerticesAreCounted) {
  const std::vector<std::pair<std::string, std::size_t>> table = {
      {"POLYGON ((0 0, 1 0, 0 1, 0 0), (0 0, 1 0, 0 1, 0 0))", 6},
      {"MULTIPOINT (1 2, 3 4)", 2},
      {"GEOMETRYCOLLECTION (LINESTRING (1 2, 3 4), POINT (1 2), POLYGON ((0 0)))", 4},
      {R"({"type":"LineString","coordinates":[[0,0],[1,0],[0,1]]})", 3},
      {"1\n3 out\n0 0\n1 0\n0 1\n1 2 3\n", 3},
      {"3 0 0 1 0 0 1", 3},
  };
  for (const auto& [text, vertices] : table) {
    ReadOptions limits;
    limits.max_vertices = vertices;
    EXPECT_NO_THROW(static_cast<void>(read_geometry(text, limits))) << text;
    limits.max_vertices = vertices - 1;
    try {
      static_cast<void>(read_geometry(text, limits));
      ADD_FAILURE() << text << ": no error";
    } catch (const ReadError& error) {
      EXPECT_EQ(error.code(), ErrorCode::kLimitExceeded) << text;
      EXPECT_EQ(std::string(error.what()),
                "more vertices than the limit of " + std::to_string(vertices - 1));
      EXPECT_GE(error.line(), 1U) << text;
    }
  }
}

std::optional<std::string> properties_of(const std::string& text) {
  return read_document(text).properties;
}

TEST(Properties, AreThoseOfTheOnlyFeature) {
  const std::string geometry = R"("geometry":{"type":"Point","coordinates":[1,2]})";
  const std::string feature =
      R"({"type":"Feature","properties":{"n": 1.50, "s":"\u00e9"},)" + geometry + "}";
  const std::string properties = R"({"n": 1.50, "s":"\u00e9"})";
  EXPECT_EQ(properties_of(feature), properties);
  EXPECT_EQ(properties_of("\xEF\xBB\xBF " + feature), properties);
  EXPECT_EQ(properties_of(R"({"features":[)" + feature + R"( ],"type":"FeatureCollection"})"),
            properties);
  EXPECT_EQ(properties_of(R"({"type":"Feature",)" + geometry + "}"), "null");
  EXPECT_EQ(properties_of(R"({"properties": null ,"type":"Feature",)" + geometry + "}"), "null");
  for (const std::string& other :
       {R"({"type":"FeatureCollection","features":[)" + feature + "," + feature + "]}",
        std::string(R"({"type":"FeatureCollection","features":[]})"),
        std::string(R"({"type":"Point","coordinates":[1,2],"properties":{"a":1}})"),
        std::string("POINT (1 2)")}) {
    EXPECT_EQ(properties_of(other), std::nullopt) << other;
  }
}

}  // namespace
}  // namespace minksum::io
