// Tests what is read of SVG: straight shapes exactly, curves by where they lie, and refusals.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "minksum/io.hpp"
#include "minksum/measure.hpp"
#include "minksum/resolve.hpp"
#include "unit/io/drawing/read_drawing.hpp"

namespace minksum::io {
namespace {

std::string svg(const std::string& content, const std::string& attributes = "") {
  return "<svg xmlns='http://www.w3.org/2000/svg'" + attributes + ">" + content + "</svg>";
}

constexpr const char* kSquare = "POLYGON ((0 -1, 1 -1, 1 0, 0 0, 0 -1))";

TEST(Svg, StraightShapesAreExact) {
  struct Case {
    std::string content;
    std::string wkt;
  };
  const std::vector<Case> cases = {
      {"<rect width='1' height='1'/>", kSquare},
      {"<rect x='.1' y='0.2' width='1e-1' height='+.1'/>",
       "POLYGON ((1/10 -3/10, 1/5 -3/10, 1/5 -1/5, 1/10 -1/5, 1/10 -3/10))"},
      {"<rect width='0' height='1'/>", "POLYGON EMPTY"},
      {"<path d='M0 0h1v1H0z'/>", kSquare},
      {"<path d='m0,0 1,0 0,1-1 0z'/>", kSquare},
      {"<path d='M0 0L1 0V1L0 1'/>", kSquare},
      {"<path fill='none' d='M0 0L1 0V1L0 1'/>", "LINESTRING (0 -1, 1 -1, 1 0, 0 0)"},
      {"<path fill='none' d='M0 0H1V1H0V0'/>", kSquare},
      {"<path fill='none' d='M0 0H10m1 1L20 5zm1 0h1'/>",
       "MULTILINESTRING ((0 0, 10 0), (11 -1, 20 -5), (12 -1, 13 -1))"},
      {"<path d='M0 0L1.5.5-1-2z'/>", "POLYGON ((-1 2, 0 0, 3/2 -1/2, -1 2))"},
      {"<path d='M0 0C0 0 1 0 1 0S1 1 1 1Q1 1 0 1z'/>", kSquare},
      {"<path d='M0 0C0 0 0 0 0 0L1 0 1 1 0 1q0 0 0 0z'/>", kSquare},
      {"<path d='M0 0A0 5 0 0 1 1 0L1 1 0 1Z'/>", kSquare},
      {"<path d='M0 0H4V4H0zM1 1H3V3H1z'/>", "POLYGON ((0 -4, 4 -4, 4 0, 0 0, 0 -4))"},
      {"<path fill-rule='evenodd' d='M0 0H4V4H0zM1 1H3V3H1z'/>",
       "POLYGON ((0 -4, 4 -4, 4 0, 0 0, 0 -4), (1 -3, 1 -1, 3 -1, 3 -3, 1 -3))"},
      {"<path d='M0 0H4V4H0zm1 1v2h2v-2z'/>",
       "POLYGON ((0 -4, 4 -4, 4 0, 0 0, 0 -4), (1 -3, 1 -1, 3 -1, 3 -3, 1 -3))"},
      {"<path d='M0 0H1V1H0Zh-1v1z'/>",
       "MULTIPOLYGON (((-1 -1, 0 0, -1 0, -1 -1)), ((0 -1, 1 -1, 1 0, 0 0, 0 -1)))"},
      {"<path d='none'/><path d=''/><path/>", "POLYGON EMPTY"},
      {"<polygon points='0,0 1,0 1,1 0 1'/>", kSquare},
      {"<polyline fill='none' points='0 0,1 0,1 1'/>", "LINESTRING (0 0, 1 0, 1 -1)"},
      {"<polyline points='0 0,1 0,1 1'/>", "POLYGON ((0 0, 1 -1, 1 0, 0 0))"},
      {"<line x1='1' y1='2' x2='3' y2='4'/>", "LINESTRING (1 -2, 3 -4)"},
      {"<g transform='translate(-1-2) scale(.5)'><rect x='2' y='4' width='2' height='2'/></g>",
       kSquare},
      {"<rect transform='matrix(0 1 -1 0 1 0)' width='1' height='1'/>", kSquare},
      {"<rect transform='rotate(90, .5, .5)' width='1' height='1'/>", kSquare},
      {"<rect transform='rotate(90)' transform-origin=' .5 .5 ' width='1' height='1'/>", kSquare},
      {"<rect transform='scale(.5)' transform-origin='-1px,1px' x='1' y='-1' width='2' "
       "height='2'/>",
       kSquare},
      {"<rect transform-origin='center' width='1' height='1'/>", kSquare},
      {"<rect transform='skewX(45)' width='1' height='1'/>",
       "POLYGON ((0 0, 1 -1, 2 -1, 1 0, 0 0))"},
      {"<rect transform='skewY(-45)' width='1' height='1'/>",
       "POLYGON ((0 -1, 1 0, 1 1, 0 0, 0 -1))"},
      {"<defs><rect id='r' width='1' height='1'/></defs>", "POLYGON EMPTY"},
      {"<defs><rect id='r' width='1' height='1'/></defs><use href='#r' x='1' y='1'/>",
       "POLYGON ((1 -2, 2 -2, 2 -1, 1 -1, 1 -2))"},
      {"<use xmlns:xlink='x' xlink:href='#r'/><rect id='r' width='1' height='1'/>", kSquare},
      {"<symbol id='s' viewBox='0 0 4 4'><rect width='4' height='4'/></symbol>"
       "<use href='#s' width='1' height='1'/>",
       kSquare},
      {"<svg x='1' width='2' height='4' viewBox='0 0 1 1'><rect width='1' height='1'/></svg>",
       "POLYGON ((1 -3, 3 -3, 3 -1, 1 -1, 1 -3))"},
      {"<g display='none'><rect width='9' height='9'/></g><rect width='1' height='1'/>", kSquare},
      {"<g style='visibility:hidden'><rect width='9' height='9'/>"
       "<rect style='visibility: visible' width='1' height='1'/></g>",
       kSquare},
      {"<style><![CDATA[ .a, #b { fill : none } rect.c{display:none} ]]></style>"
       "<path class='x a' d='M0 0H1V1'/><rect class='c' width='1' height='1'/>",
       "LINESTRING (0 0, 1 0, 1 -1)"},
      {"<clipPath><rect width='1' height='1'/></clipPath>", "POLYGON EMPTY"},
      {"<rect width='1mm' height='1cm' transform='scale(127)'/>",
       "POLYGON ((0 -4800, 480 -4800, 480 0, 0 0, 0 -4800))"},
  };
  for (const auto& [content, wkt] : cases) EXPECT_EQ(read_exactly(svg(content)), wkt) << content;
}

TEST(Svg, OtherNamespacesAreNotDrawn) {
  const std::string declarations = " xmlns:x='http://x' xmlns:s='http://www.w3.org/2000/svg'";
  const std::string foreign =
      "<x:rect width='9' height='9'/><x:g><rect width='8' height='8'/></x:g>";
  EXPECT_EQ(read_exactly(svg(foreign, declarations)), "POLYGON EMPTY");
  // The prefix s stands for SVG, and nothing says what y is.
  for (const char* const rect : {"rect", "s:rect", "y:rect"}) {
    const std::string own = std::string("<") + rect + " width='1' height='1'/>";
    EXPECT_EQ(read_exactly(svg(foreign + own, declarations)), kSquare);
  }
  EXPECT_EQ(read_exactly("<s:svg" + declarations + "><s:rect width='1' height='1'/>" + foreign +
                         "</s:svg>"),
            kSquare);
}

// Each group draws the one before it ten times.
TEST(Svg, FramesScaleWhatTheyHold) {
  struct Case {
    const char* content;
    const char* attributes;
    const char* wkt;
  };
  constexpr const char* kPage = " viewBox='3 5 40 20'";
  constexpr const char* kFour = "POLYGON ((0 -4, 4 -4, 4 0, 0 0, 0 -4))";
  constexpr const char* kSixteen = "POLYGON ((0 -16, 16 -16, 16 0, 0 0, 0 -16))";
  const std::vector<Case> cases = {
      {"<svg viewBox='0 0 10 5'><rect width='4' height='4'/></svg>", kPage, kSixteen},
      {"<svg viewBox='0 0 10 5'><rect width='4' height='4'/></svg>", " width='40' height='20'",
       kSixteen},
      {"<svg viewBox='0 0 10 5' width='25%' height='25%'><rect width='4' height='4'/></svg>", kPage,
       kFour},
      {"<svg viewBox='0 0 9 9'><svg viewBox='0 0 9 9' width='9' height='9'><rect width='4' "
       "height='4'/></svg></svg>",
       " width='9' height='9'", kFour},
      {"<symbol id='s' viewBox='0 0 10 5'><rect width='4' height='4'/></symbol><use href='#s'/>",
       kPage, kSixteen},
      {"<defs><svg id='s' width='1' height='1' viewBox='0 0 10 5'><rect width='4' height='4'/>"
       "</svg></defs><use href='#s' width='10' height='5'/>",
       "", kFour},
      {"<svg width='0'><rect width='4' height='4'/></svg>", kPage, "POLYGON EMPTY"},
      {"<rect width='10%' height='20%'/>", kPage, kFour},
      {"<svg viewBox='0 0 10 5' width='8' height='8' preserveAspectRatio='none'><rect width='5' "
       "height='2.5'/></svg>",
       kPage, kFour},
      {"<rect width='4' height='4'/>", " width='40mm' height='30mm' viewBox='0 0 40 20'", kFour},
      {"<rect width='8' height='8'/>", " width='40mm' height='10mm' viewBox='0 0 40 20'", kFour},
      {"<rect width='4' height='2'/>",
       " width='40mm' height='40mm' viewBox='0 0 40 20' preserveAspectRatio='none'", kFour},
      {"<svg><rect width='4' height='4'/></svg>", "", kFour},
      {"<svg viewBox='0 0 1 1'><rect width='4' height='4'/></svg>", "",
       "1:42: the size of the frame is not known: it needs a width and a height, or the root does"},
      {"<svg viewBox='0 0 1 1' width='1' height='-1'/>", kPage,
       "1:102: the size of a frame is negative"},
  };
  for (const auto& [content, attributes, wkt] : cases) {
    EXPECT_EQ(read_exactly(svg(content, attributes)), wkt) << content << attributes;
  }
}

TEST(Svg, StylesSayWhatIsDrawn) {
  const std::string square = "<rect id='i' class='a\tk' width='1' height='1'/>";
  for (const std::string& shown :
       {"<style>rect{display:none} .k{display:inline}</style>" + square,
        "<style>@media print{.x{fill:red} .k{display:none}} @import 'a'; .k{}</style>" + square,
        "<style media='print'>rect{display:none}</style>" + square,
        "<style>#i{display:inline!important} rect{display:none!important}</style>" + square,
        std::string("<rect display='none' style='display:inline' width='1' height='1'/>"),
        "<style>rect{/*}*/}</style><g style='/*x*/display:inline'>" + square + "</g>",
        "<g id='g'>" + square + "</g><use ns1:href='#g'/><use href='#no'/><use href='b.svg#g'/>",
        "<switch><path systemLanguage='xx' d='M5 5h9v9'/>" + square +
            "<path d='M5 5h9v9'/></switch>"}) {
    EXPECT_EQ(read_exactly(svg(shown)), kSquare) << shown;
  }
  for (const std::string& removed :
       {"<style>rect{display:none!important} #i{display:inline}</style>" + square,
        "<g style='Display: NONE'>" + square + "</g>",
        "<g requiredExtensions='urn:x'>" + square + "</g>"}) {
    EXPECT_EQ(read_exactly(svg(removed)), "POLYGON EMPTY") << removed;
  }
  EXPECT_EQ(read_exactly(svg("<g fill-rule='evenodd'><path fill-rule='odd' d='M0 0H4V4H0zM1 1H3V3"
                             "H1z'/></g>")),
            "POLYGON ((0 -4, 4 -4, 4 0, 0 0, 0 -4), (1 -3, 1 -1, 3 -1, 3 -3, 1 -3))");
}

TEST(Svg, ReferencesAreReplaced) {
  const std::string type =
      "<!DOCTYPE svg [<!ENTITY hide \"display:none\"><!ENTITY one '1'> <!ENTITY % p 'x'>"
      "<!ENTITY size 'width=&one;'><!ENTITY loop '&loop;&loop;'>]>";
  const auto read = [&type](const std::string& content) {
    return read_exactly(type + svg(content));
  };
  const std::string square = "<rect width='&one;' height='&#49;&#x2e;0'/>";
  EXPECT_EQ(read(square), kSquare);
  EXPECT_EQ(read("<rect style='&hide;' width='1' height='1'/>"), "POLYGON EMPTY");
  EXPECT_EQ(read("<g id='a&amp;b&#xe9;'>" + square + "</g><use href='#a&amp;b&#xe9;'/>"), kSquare);
  EXPECT_EQ(read("<polygon points='0 0&#x9;1 0&#10;1 1 0 1'/>"), kSquare);
  EXPECT_EQ(read("<rect width='1' height='&none;'/>").substr(2),
            "203: expected a number, found '&'");
  EXPECT_EQ(read("<rect width='&loop;' height='1'/>").find("POLYGON"), std::string::npos);
}

TEST(Svg, WhatUseDrawsIsLimited) {
  std::string content = "<g id='g0'><rect width='1' height='1'/></g>";
  EXPECT_EQ(read_exactly(svg(content + "<use href='#g0'/>")), kSquare);
  for (int i = 1; i < 8; ++i) {
    std::string group = "\n<g id='g" + std::to_string(i) + "'>";
    for (int k = 0; k < 10; ++k) group += "<use href='#g" + std::to_string(i - 1) + "'/>";
    content += group + "</g>";
  }
  EXPECT_EQ(read_exactly(svg(content)), "3:81: 'use' draws more elements than the limit of 100000");
}

TEST(Svg, TheWidthNamesTheUnit) {
  const std::string rect = "<rect width='1' height='1'/>";
  const auto unit = [&rect](const std::string& attributes) {
    return read_document(svg(rect, attributes)).source.unit;
  };
  EXPECT_EQ(unit(""), "px");
  EXPECT_EQ(unit(" width='100' viewBox='0 0 1 1'"), "px");
  EXPECT_EQ(unit(" width='100%'"), "px");
  EXPECT_EQ(unit(" width='1in' height='2in' viewBox='0 0 1 2'"), "in");
  EXPECT_EQ(read_exactly(svg(rect, " width='5cm' height='5cm' viewBox='0 0 5 5'")), kSquare);
  EXPECT_EQ(read_exactly(svg(rect, " width='1mm' height='1mm' viewBox='0 0 4 4'")),
            "POLYGON ((0 -1/4, 1/4 -1/4, 1/4 0, 0 0, 0 -1/4))");
  EXPECT_EQ(read_exactly(svg(rect, " width='1in'")),
            "POLYGON ((0 -1/96, 1/96 -1/96, 1/96 0, 0 0, 0 -1/96))");
}

TEST(Svg, TheDocumentMayHaveAllThatXmlHas) {
  const std::string head =
      "\xEF\xBB\xBF<?xml version='1.0'?>\n<!DOCTYPE svg PUBLIC \"-//W3C\" \"a.dtd\" [\n"
      "<!ENTITY a \"]>\">\n]>\n<!-- <rect> -->\n";
  const std::string rect = "<s:rect width='1' height = \"1\"></s:rect>\n<s:text>a &lt; b</s:text>";
  const Document document =
      read_document(head + "<s:svg xmlns:s='x'>" + rect + "</s:svg>\n<!-- end -->\n");
  EXPECT_EQ(to_wkt(document.geometry), kSquare);
  EXPECT_EQ(document.source.remarks, "not read: 1 text");
}

TEST(Svg, CurvesNeedATolerance) {
  EXPECT_EQ(read_exactly(svg("<g>\n<circle r='1'/></g>")),
            "2:2: a curve becomes a polyline, and has to say how far that may be off "
            "(io::DrawingOptions::tolerance)");
  EXPECT_EQ(read_exactly(svg("<rect width='1' height='1' transform='rotate(30)'/>")),
            "1:42: a turned shape has irrational coordinates, and has to say how far that may be "
            "off (io::DrawingOptions::tolerance)");
}

TEST(Svg, CurvesHaveTheirAreaWithinTheTolerance) {
  constexpr double kPi = 3.141592653589793;
  struct Case {
    const char* content;
    double area;
    double perimeter;  // at least
  };
  const std::vector<Case> cases = {
      {"<circle cx='3' cy='4' r='2'/>", 4 * kPi, 13},
      {"<ellipse rx='3' ry='1'/>", 3 * kPi, 14},
      {"<ellipse rx='auto' ry='2'/>", 4 * kPi, 13},
      {"<rect width='10' height='8' rx='2'/>", 80 - (4 - kPi) * 4, 36},
      {"<rect width='10' height='8' rx='9' ry='1'/>", 80 - (4 - kPi) * 5, 36},
      {"<path d='M-2 0a2 2 0 1 0 4 0a2 2 0 1 0 -4 0'/>", 4 * kPi, 13},
      {"<path d='M0 0a1 1 0 014 0z'/>", 2 * kPi, 11},
      {"<path d='M0 0A4 2 0 0 0 4 2V0z'/>", 2 * kPi, 12},
      {"<path d='M0 0A2 4 90 0 0 4 2V0z'/>", 2 * kPi, 12},
      {"<path d='M0 0Q1 2 2 0T4 0'/>", 8.0 / 3, 10},
      {"<path d='M0 0C0 2 2 2 2 0S4-2 4 0'/>", 4.8, 14},
      {"<path d='M0 0C20 0 0 20 0 0Z'/>", 60, 40},
      {"<path d='M-5 -5L0 0C20 0 0 20 0 0H-5Z'/>", 72.5, 60},
      {"<path transform='rotate(30)' d='M0 0h3v2h-3z'/>", 6, 10},
      {"<circle r='1' transform='matrix(2 1 0 3 5 5)'/>", 6 * kPi, 20},
  };
  for (const auto& [content, area, perimeter] : cases) {
    for (const Rational& tolerance : {Rational(1, 10), Rational(1, 1000)}) {
      const double slack = perimeter * tolerance.to_double() + 1e-9;
      const auto read_area = [&tolerance, drawing = svg(content)](RoundingSide side) {
        const Geometry read = read_geometry(drawing, within(tolerance, side));
        return minksum::area(resolve(read).region).to_double();
      };
      EXPECT_NEAR(read_area(RoundingSide::kNearest), area, slack) << content;
      const double outside = read_area(RoundingSide::kOutside);
      EXPECT_GE(outside, area - 1e-9) << content;
      EXPECT_LE(outside, area + slack) << content;
      const double inside = read_area(RoundingSide::kInside);
      EXPECT_LE(inside, area + 1e-9) << content;
      EXPECT_GE(inside, area - slack) << content;
    }
  }
}

TEST(Svg, CurvesThatTurnSharplyAreRead) {
  for (const char* const d :
       {"M0 0C100 100 0 100 100 0", "M0 0C200 0-100 0 100 0V9", "M0 0C0 0 9 9 9 9V0",
        "M0 0C0 0 70 99 99 99", "M0 0C99 99 0 99 98 0", "M0 0C50 0 50 0 50 50S0 50 0 50",
        "M0 0A9 .001 0 0 0 9 0", "M0 0Q9 0 0 0V3", "M0 0Q-5-10 10 20L5 5",
        "M0 0C10 20 0 0 10 20L5 5", "M0 0A9 9 0 0 0 1e-4 0L5 5z", "M0 0Q0-.009 0 0L5 5"}) {
    for (const RoundingSide side :
         {RoundingSide::kNearest, RoundingSide::kOutside, RoundingSide::kInside}) {
      const std::string text = svg("<path d='" + std::string(d) + "'/>");
      EXPECT_NO_THROW(static_cast<void>(read_geometry(text, within(Rational(1, 100), side))))
          << d << ' ' << to_string(side);
    }
  }
}

TEST(Svg, EllipsesMayBeNeedles) {
  // These were refused as too small for their tolerances.
  const std::vector<std::pair<const char*, Rational>> cases = {
      {"M0 0a.0387124 1.09365e-5 292 0 1 .0937552 .0390764z", Rational(28, 1000)},
      {"M0 0a.189994 4.11733e-4 296 0 0 -.226338 -.0223885z", Rational(392, 10000)},
  };
  for (const auto& [path, tolerance] : cases) {
    const std::string drawing = svg("<path d='" + std::string(path) + "'/>");
    const auto read = [&, t = tolerance](RoundingSide side) {
      return resolve(read_geometry(drawing, within(t, side))).region;
    };
    const Region outside = read(RoundingSide::kOutside);
    EXPECT_FALSE(outside.empty()) << path;
    EXPECT_GE(area(outside), area(read(RoundingSide::kNearest))) << path;
    EXPECT_GE(area(outside), area(read(RoundingSide::kInside))) << path;
  }
}

TEST(Svg, ALineThatIsCurvedHasNoInside) {
  const std::string text = svg("<path fill='none' d='M0 0Q1 1 2 0'/>");
  EXPECT_TRUE(read_geometry(text, within(1)).region.empty());
  EXPECT_FALSE(read_geometry(text, within(1, RoundingSide::kOutside)).region.empty());
  EXPECT_EQ(read_exactly(text, within(1, RoundingSide::kInside)).substr(0, 49),
            "1:42: a curve that encloses no area has no inside");
}

TEST(Svg, FaultsHaveAPlace) {
  struct Case {
    std::string text;
    const char* message;
  };
  const std::vector<Case> cases = {
      {"<svg>", "1:2: the element 'svg' has no end tag"},
      {"<svg><g></svg>", "1:9: expected the end tag of 'g', found that of 'svg'"},
      {"<svg></svg></svg>", "1:12: an end tag without its begin"},
      {"<svg/><svg/>", "1:7: a document has one root element"},
      {"<svg/>x", "1:7: expected the end of the text, found 'x'"},
      {"<svg a=1/>", "1:8: expected a value in quotes, found '1/'"},
      {"<svg a='1/>", "1:8: the value of an attribute has no end"},
      {"<svg a'1'/>", "1:7: expected '=', found '''"},
      {"<svg><!-- </svg>", "1:6: a comment has no end"},
      {"<svg><![CDATA[</svg>", "1:6: a CDATA section has no end"},
      {svg("<path d='L1 1'/>"), "1:50: expected 'M', with which a path begins, found 'L1'"},
      {svg("<path d='M1'/>"), "1:52: expected a number, found the end of the text"},
      {svg("<path d='M1 1X'/>"), "1:54: expected a command of a path, found 'X'"},
      {svg("<path d='M0 0A1 1 0 2 0 1 1'/>"), "1:61: expected a flag, 0 or 1, found '2'"},
      {svg("<path d='M0 0L1/2 3'/>"), "1:56: expected a number, found '/2'"},
      {svg("<polygon points='1 2 3'/>"), "1:58: an odd number of coordinates"},
      {svg("<rect width='-1' height='1'/>"), "1:42: a rectangle's size is negative"},
      {svg("<rect width='1em' height='1'/>"),
       "1:54: the unit 'em' depends on what is around the element: use px or mm"},
      {svg("<circle r='-1'/>"), "1:42: a radius is negative"},
      {svg("<g id='a'><use href='#a'/></g>"),
       "1:52: elements refer to each other deeper than the limit of 32"},
      {svg("<g transform='turn(3)'/>"),
       "1:55: expected matrix, translate, scale, rotate, skewX or skewY with its numbers"},
      {svg("<rect transform='scale(2)' transform-origin='left 5%'/>"),
       "1:86: transform-origin is read as two numbers of px alone"},
      {svg("<rect transform='scale(2)' transform-origin='5'/>"),
       "1:87: expected a number, found the end of the text"},
      {svg("", " width='1mm' viewBox='0 0 1'"),
       "1:62: a viewBox has four numbers, the last two of which are positive"},
  };
  for (const auto& [text, message] : cases) EXPECT_EQ(read_exactly(text), message) << text;
  std::string deep;
  for (int i = 0; i < 40; ++i) deep += "<svg>";
  EXPECT_EQ(read_exactly(deep), "1:161: elements are nested deeper than the limit of 32");
  EXPECT_EQ(read_exactly(svg("<circle r='1'/>"), within(Rational(Decimal{1, -40}))),
            "1:42: the tolerance is too small for this curve beside its coordinates, which are "
            "proved in doubles");
}

}  // namespace
}  // namespace minksum::io
