// Tests what is read of DXF: straight shapes exactly, curves by where they lie, and refusals.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "minksum/io.hpp"
#include "minksum/measure.hpp"
#include "minksum/resolve.hpp"
#include "unit/io/drawing/read_drawing.hpp"

namespace minksum::io {
namespace {

/// Writes tags as "code value code value ...", one a line.
std::string tags(const std::string& words) {
  std::string text;
  for (const char c : words) text += c == ' ' ? '\n' : c == '_' ? ' ' : c;
  return text + '\n';
}

std::string dxf(const std::string& entities, const std::string& before = "") {
  return tags((before.empty() ? "" : before + " ") + "0 SECTION 2 ENTITIES " +
              (entities.empty() ? "" : entities + " ") + "0 ENDSEC 0 EOF");
}

std::string line(const std::string& a, const std::string& b, const std::string& more = "") {
  const auto point = [](const std::string& xy, const char* x, const char* y) {
    const std::size_t comma = xy.find(',');
    return std::string(x) + xy.substr(0, comma) + y + xy.substr(comma + 1);
  };
  return "0 LINE" + more + point(a, " 10 ", " 20 ") + point(b, " 11 ", " 21 ");
}
const std::string kBox = "0 LWPOLYLINE 90 4 70 1 10 0 20 0 10 4 20 0 10 4 20 4 10 0 20 4";
const std::string kSmall = "0 LWPOLYLINE 90 4 70 1 10 1 20 1 10 3 20 1 10 3 20 3 10 1 20 3";
constexpr const char* kBoxWkt = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))";

TEST(Dxf, StraightShapesAreExact) {
  struct Case {
    std::string entities;
    std::string wkt;
  };
  const std::vector<Case> cases = {
      {"", "POLYGON EMPTY"},
      {kBox, kBoxWkt},
      {kBox + " " + kSmall, "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 3, 3 3, 3 1, 1 1))"},
      {kBox + " " + kBox, kBoxWkt},
      {kBox + " 0 LWPOLYLINE 70 1 10 4 20 4 10 4 20 0 10 0 20 0 10 0 20 4", kBoxWkt},
      {kBox + " 0 LWPOLYLINE 70 1 10 4 20 4 10 0 20 4 10 0 20 0 10 4 20 0", kBoxWkt},
      {kBox + " " + line("0,0", "4,0") + " " + line("0,4", "0,0") + " " + line("0,4", "4,4") + " " +
           line("4,4", "4,0"),
       kBoxWkt},
      {line("0,0", "4,0") + " " + line("0,4", "0,0") + " " + line("0,4", "4,4") + " " +
           line("4,4", "4,0"),
       kBoxWkt},
      {line("0,0", ".1,0") + " " + line("0.10,0", "1,1"), "LINESTRING (0 0, 1/10 0, 1 1)"},
      {line("0,0", "1,0") + " " + line("1,0", "0,0"), "LINESTRING (0 0, 1 0)"},
      {"0 POLYLINE 66 1 70 1 10 0 20 0 0 VERTEX 10 0 20 0 0 VERTEX 10 4 20 0 0 VERTEX 10 4 20 4 "
       "0 VERTEX 10 0 20 4 0 SEQEND",
       kBoxWkt},
      {"0 POLYLINE 70 0 0 VERTEX 10 0 20 0 0 VERTEX 10 4 20 0 0 VERTEX 70 16 10 9 20 9 0 SEQEND",
       "LINESTRING (0 0, 4 0)"},
      {"0 SOLID 10 0 20 0 11 4 21 0 12 0 22 4 13 4 23 4", kBoxWkt},
      {"0 LWPOLYLINE 70 1 230 -1 10 0 20 0 10 -4 20 0 10 -4 20 4 10 0 20 4", kBoxWkt},
      {"0 SPLINE 71 1 40 0 40 0 40 1 40 5 40 6 40 6 10 0 20 0 10 4 20 0 10 4 20 4 10 0 20 4 " +
           line("0,4", "0,0"),
       kBoxWkt},
      {"0 SPLINE 71 1 40 0 40 0 40 1 40 1 40 2 40 2 10 0 20 0 10 4 20 0 10 4 20 0 10 4 20 4",
       "LINESTRING (0 0, 4 0, 4 4)"},
      {line("0,0", "9,9", " 67 1") + " " + line("0,0", "9,9", " 60 1") + " " + kBox, kBoxWkt},
      {kBox + " 0 CIRCLE 10 0 20 0 40 0 0 ENDSEC", kBoxWkt},
      {"999 a_comment " + kBox + " 0 TEXT 1 LINE 10 0 20 0", kBoxWkt},
  };
  for (const auto& [entities, wkt] : cases) EXPECT_EQ(read_exactly(dxf(entities)), wkt) << entities;
}

TEST(Dxf, BlocksAreInserted) {
  const std::string blocks =
      "0 SECTION 2 BLOCKS 0 BLOCK 2 b 10 1 20 1 0 LWPOLYLINE 70 1 10 1 20 1 10 2 20 1 10 2 20 2 "
      "0 ENDBLK 0 BLOCK 2 deep 10 0 20 0 0 INSERT 2 B 10 0 20 0 0 ENDBLK 0 BLOCK 2 self "
      "0 INSERT 2 self 10 0 20 0 0 ENDBLK 0 ENDSEC";
  const auto read_insert = [&blocks](const std::string& values) {
    return read_exactly(dxf("0 INSERT " + values, blocks));
  };
  EXPECT_EQ(read_insert("2 B 10 5 20 0"), "POLYGON ((5 0, 6 0, 6 1, 5 0))");
  EXPECT_EQ(read_insert("2 B 10 0 20 0 41 2 42 -3"), "POLYGON ((0 0, 2 -3, 2 0, 0 0))");
  EXPECT_EQ(read_insert("2 B 10 0 20 0 50 90"), "POLYGON ((-1 1, 0 0, 0 1, -1 1))");
  EXPECT_EQ(read_insert("2 B 10 1 20 0 230 -1"), "POLYGON ((-2 0, -1 0, -2 1, -2 0))");
  EXPECT_EQ(read_insert("2 Deep 10 0 20 0 41 1/1"),
            "78:2: expected the end of the number, found '/1'");
  EXPECT_EQ(read_insert("2 Deep 10 0 20 0"), "POLYGON ((0 0, 1 0, 1 1, 0 0))");
  EXPECT_EQ(read_insert("2 B 10 0 20 0 70 2 44 5"),
            "MULTIPOLYGON (((0 0, 1 0, 1 1, 0 0)), ((5 0, 6 0, 6 1, 5 0)))");
  EXPECT_EQ(read_insert("2 B 10 0 20 0 30 7"),
            "78:1: a point has a height other than 0 (io::ReadOptions::drop_z keeps x and y)");
  EXPECT_EQ(read_insert("2 self 10 0 20 0"), "54:1: blocks are nested deeper than the limit of 32");
  EXPECT_EQ(read_insert("2 c 10 0 20 0").substr(6), "no block has the name 'c'");
}

TEST(Dxf, LayersAndUnitsAreRead) {
  const std::string tables =
      "0 SECTION 2 HEADER 9 $INSUNITS 70 4 0 ENDSEC 0 SECTION 2 TABLES 0 TABLE 2 LAYER "
      "0 LAYER 2 Off 70 0 62 -7 0 LAYER 2 Frozen 70 1 62 7 0 ENDTAB 0 ENDSEC";
  const std::string text =
      dxf("0 LWPOLYLINE 8 cut 70 1 10 0 20 0 10 4 20 0 10 4 20 4 10 0 20 4 " +
              line("0,0", "1,0", " 8 Marks") + " " + line("0,0", "1,1", " 8 OFF") + " " +
              line("0,0", "1,2", " 8 frozen") + " 0 TEXT 8 0 0 HATCH 0 TEXT",
          tables);
  const Document document = read_document(text);
  EXPECT_EQ(document.source.unit, "mm");
  EXPECT_EQ(document.source.remarks,
            "open outlines, which are lines: 1; not read: 1 HATCH, 2 TEXT, 2 hidden entities");
  ReadOptions options;
  options.drawing.layer = "Cut";
  EXPECT_EQ(read_exactly(text, options), kBoxWkt);
  options.drawing.layer = "none";
  EXPECT_EQ(read_exactly(text, options),
            "1:1: nothing is drawn on the layer 'none' (io::DrawingOptions::layer); there are: 0, "
            "CUT, FROZEN, MARKS, OFF");
  EXPECT_EQ(read_document(dxf("")).source.unit, "not stated");
}

TEST(Dxf, EndsAreJoined) {
  const std::string text = dxf(line("0,0", "4,0") + " " + line("4,0.1", "4,4") + " " +
                               line("4,4", "0,4") + " " + line("-.1,4", "0,.05"));
  EXPECT_EQ(read_geometry(text).polylines.size(), 3U);
  ReadOptions options;
  options.drawing.join_ends = Rational(1, 10);
  EXPECT_EQ(read_exactly(text, options), "POLYGON ((-1/10 4, 0 1/20, 0 0, 4 0, 4 4, -1/10 4))");
  options.drawing.join_ends = Rational(9, 100);
  EXPECT_EQ(read_geometry(text, options).polylines.size(), 2U);
  std::string many;
  for (int i = 0; i < 12; ++i) many += line("0,0." + std::to_string(100 + i), "9,9") + " ";
  many.pop_back();
  options.drawing.join_ends = 1;
  EXPECT_NE(read_exactly(dxf(many), options).find("more than eight ends"), std::string::npos);
}

TEST(Dxf, CurvesHaveTheirAreaWithinTheTolerance) {
  constexpr double kPi = 3.141592653589793;
  struct Case {
    std::string entities;
    double area;
    double perimeter;  // at least
  };
  const std::vector<Case> cases = {
      {"0 CIRCLE 10 5 20 5 40 2", 4 * kPi, 13},
      {"0 ARC 10 5 20 5 40 2 50 30 51 30", 4 * kPi, 13},
      {"0 ARC 10 0 20 0 40 2 50 0 51 180 " + line("-2,0", "2,0"), 2 * kPi, 11},
      {"0 ARC 10 0 20 0 40 2 50 270 51 90 " + line("0,2", "0,-2"), 2 * kPi, 11},
      {"0 LWPOLYLINE 70 1 10 0 20 0 42 1 10 2 20 0 42 1", kPi, 7},
      {"0 LWPOLYLINE 70 1 10 0 20 0 42 -1 10 2 20 0 10 2 20 2 10 0 20 2", 4 + kPi / 2 - 2 * kPi / 2,
       10},
      {"0 LWPOLYLINE 70 1 10 0 20 0 42 3 10 2 20 0", 8.2725, 12},
      {"0 ELLIPSE 10 0 20 0 11 3 21 0 40 0.5 41 0 42 6.283185307179586", 4.5 * kPi, 16},
      {"0 ELLIPSE 10 0 20 0 11 3 21 3 40 0.25 41 1 42 7.283185307179586", 4.5 * kPi, 20},
      {"0 SPLINE 70 0 71 2 72 6 73 3 40 0 40 0 40 0 40 1 40 1 40 1 10 0 20 0 10 1 20 2 10 2 20 0 " +
           line("0,0", "2,0"),
       4.0 / 3, 7},
      {"0 SPLINE 71 2 40 0 40 0 40 0 40 0 40 1 40 1 40 1 40 1 40 1 10 9 20 9 10 0 20 0 10 1 20 2 "
       "10 2 20 0 10 9 20 0 10 9 20 0 " +
           line("0,0", "2,0"),
       4.0 / 3, 7},
  };
  for (const auto& [entities, area, perimeter] : cases) {
    for (const Rational& tolerance : {Rational(1, 10), Rational(1, 1000)}) {
      const double slack = perimeter * tolerance.to_double() + 1e-9;
      const auto read_area = [&, &entities = entities](RoundingSide side) {
        const Geometry read = read_geometry(dxf(entities), within(tolerance, side));
        return minksum::area(resolve(read).region).to_double();
      };
      EXPECT_NEAR(read_area(RoundingSide::kNearest), area, slack) << entities;
      EXPECT_GE(read_area(RoundingSide::kOutside), area - 1e-3) << entities;
      EXPECT_LE(read_area(RoundingSide::kOutside), area + slack) << entities;
      EXPECT_LE(read_area(RoundingSide::kInside), area + 1e-3) << entities;
      EXPECT_GE(read_area(RoundingSide::kInside), area - slack) << entities;
    }
  }
}

TEST(Dxf, SplinesMayHaveKinks) {
  const std::string text = dxf(
      "0 SPLINE 71 2 40 0 40 0 40 0 40 2 40 2 40 3 40 4 40 4 40 4 41 7.6 41 .94 41 .124 41 .388 "
      "41 8.25 41 .2 10 .8 20 1.6 10 92 20 -442 10 -227 20 223 10 -11 20 425 10 -285 20 145 10 "
      "-453 "
      "20 276");
  // Points that come four times are corners, with parts that are points, too.
  const std::string corners = dxf(
      "0 SPLINE 71 3 40 0 40 0 40 0 40 0 40 1 40 2 40 3 40 4 40 5 40 6 40 7 40 7 40 7 40 7 10 0 20 "
      "0 "
      "10 0 20 0 10 4 20 0 10 4 20 0 10 4 20 0 10 4 20 0 10 3 20 3 10 3 20 3 10 3 20 3 10 0 20 0");
  for (const Rational& tolerance : {Rational(10), Rational(1), Rational(1, 100)}) {
    for (const RoundingSide side : {RoundingSide::kNearest, RoundingSide::kOutside}) {
      EXPECT_NO_THROW(static_cast<void>(read_geometry(text, within(tolerance, side))));
      EXPECT_NO_THROW(static_cast<void>(read_geometry(corners, within(tolerance, side))));
    }
  }
}

TEST(Dxf, FaultsHaveAPlace) {
  struct Case {
    std::string text;
    const char* message;
  };
  const std::vector<Case> cases = {
      {tags("0 SECTION 2 ENTITIES"),
       "5:1: expected a code, or the end of the drawing (EOF), found the end of the text"},
      {tags("0 SECTION 2 ENTITIES 0 LINE 10"),
       "8:1: expected the value of code 10, found the end "
       "of the text"},
      {dxf("x LINE"), "5:1: expected the code of a value, an integer, found 'x'"},
      {dxf("0 LINE 10 1 20 a 11 1 21 1"), "10:1: expected a number, found 'a'"},
      {dxf("0 LINE 10 1 20 1,5 11 1 21 1"), "10:2: expected the end of the number, found ','"},
      {dxf("0 LINE 10 1 20 1 11 1"), "6:1: LINE has no value of code 21"},
      {dxf("0 CIRCLE 10 0 20 0 40 -1"), "6:1: a radius must be positive"},
      {dxf("0 CIRCLE 10 0 20 0 40 1"),
       "6:1: a curve becomes a polyline, and has to say how far that may be off "
       "(io::DrawingOptions::tolerance)"},
      {dxf("0 LINE 10 0 20 0 30 1 11 1 21 1"),
       "12:1: a point has a height other than 0 (io::ReadOptions::drop_z keeps x and y)"},
      {dxf("0 CIRCLE 10 0 20 0 40 1 210 1"), "6:1: an entity is not drawn in the plane of x and y"},
      {dxf("0 SPLINE 70 0 71 3 11 0 21 0"),
       "6:1: a spline has fit points alone; its control points are needed"},
      {dxf("0 SPLINE 71 3 10 0 20 0"),
       "6:1: a spline's numbers of control points and of knots do not fit its degree"},
      {dxf("0 SPLINE 71 1 40 0 40 0 40 1 40 1 40 2 40 2 10 0 20 0 10 4 20 0 10 4 20 1 10 4 20 4"),
       "6:1: a spline jumps at a knot that occurs more often than its degree; write the pieces "
       "before and behind it as splines of their own"},
      {dxf("0 SPLINE 71 40 10 0 20 0"), "6:1: the degree of a spline must be from 1 to 11"},
      {dxf("0 ELLIPSE 10 0 20 0 11 1 21 0 40 0"), "6:1: the ratio of axes must be positive"},
      {tags("0 SECTION 2 ENTITIES 0 EOF"), "6:1: expected ENDSEC"},
      {tags("0 SECTION 2 ENTITIES 0 ENDSEC 0 LINE"),
       "8:1: expected a section, or the end of the drawing (EOF)"},
  };
  for (const auto& [text, message] : cases) EXPECT_EQ(read_exactly(text), message) << text;
  EXPECT_EQ(read_exactly(tags("0 SECTION 2 HEADER 9 $A 1 B 0 ENDSEC 9 $C 70 2 0 ENDSEC 0 EOF")),
            "POLYGON EMPTY");
  const std::string binary = "AutoCAD Binary DXF\r\n\x1A";
  EXPECT_NE(read_exactly(binary).find("a binary DXF drawing, which is not read"),
            std::string::npos);
}

}  // namespace
}  // namespace minksum::io
