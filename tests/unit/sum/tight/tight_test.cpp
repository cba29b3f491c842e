// Tests tight places of hand-made pairs that fit without any play.
#include "sum/tight/tight.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "minksum/minkowski_sum.hpp"
#include "minksum/prepared_region.hpp"
#include "minksum/testing.hpp"
#include "sum/pipeline.hpp"
#include "support/data.hpp"
#include "support/polygon_kinds.hpp"
#include "support/shapes.hpp"

namespace {

using namespace minksum;
using namespace minksum::test;

std::string text_of(const Point& p) { return p.x.to_string() + " " + p.y.to_string(); }

/// Returns a text such as "(3 3, 3 6) (0 0)": polylines, then points.
std::string text_of(const Geometry& tight) {
  std::string text;
  const auto add = [&](const std::vector<Point>& points) {
    text += text.empty() ? "(" : " (";
    for (std::size_t i = 0; i < points.size(); ++i)
      text += (i > 0 ? ", " : "") + text_of(points[i]);
    text += ")";
  };
  for (const Polyline& line : tight.polylines) add(line);
  for (const Point& point : tight.points) add({point});
  return text;
}

/// Returns the tight places of a pair. Expects the same in both orders, and the sum unchanged.
std::string tight_places(const Region& p, const Region& q) {
  SumSettings options;
  options.tight = true;
  options.check = true;
  const DetailedSum found = detailed_sum(p, q, options);
  EXPECT_EQ(found.sum.region, minkowski_sum(p, q));
  EXPECT_TRUE(found.tight.region.empty());
  const DetailedSum other = detailed_sum(q, p, options);
  EXPECT_EQ(other.sum, found.sum);
  EXPECT_EQ(text_of(other.tight), text_of(found.tight));
  options.cover = false;
  const DetailedSum uncovered = detailed_sum(p, q, options);
  EXPECT_EQ(uncovered.sum, found.sum);
  EXPECT_EQ(text_of(uncovered.tight), text_of(found.tight));
  return text_of(found.tight);
}
std::string tight_places(const std::string& p, const std::string& q) {
  return tight_places(parse_wkt(p), parse_wkt(q));
}

const char* const kSquare = "POLYGON ((-1 -1, 1 -1, 1 1, -1 1, -1 -1))";

TEST(TightPlaces, SquareInItsHole) {
  EXPECT_EQ(tight_places("POLYGON ((0 0, 6 0, 6 6, 0 6, 0 0), (2 2, 2 4, 4 4, 4 2, 2 2))", kSquare),
            "(3 3)");
  EXPECT_EQ(tight_places("POLYGON ((0 0, 6 0, 6 6, 0 6, 0 0), (2 2, 2 5, 5 5, 5 2, 2 2))", kSquare),
            "");
  EXPECT_EQ(
      tight_places("POLYGON ((0 0, 6 0, 6 6, 0 6, 0 0), (2 2, 2 4, 3.9 4, 3.9 2, 2 2))", kSquare),
      "");
  EXPECT_EQ(tight_places(rectangle(0, 0, 3, 4), rectangle(0, 0, 1, 1)), "");
}

TEST(TightPlaces, SlotsAndRooms) {
  EXPECT_EQ(tight_places("POLYGON ((0 0, 6 0, 6 6, 4 6, 4 2, 2 2, 2 6, 0 6, 0 0))",
                         "POLYGON ((-1 0, 1 0, 1 3, -1 3, -1 0))"),
            "(3 5, 3 9)");
  EXPECT_EQ(
      tight_places("POLYGON ((0 0, 12 0, 12 8, 0 8, 0 0), (2 2, 2 5, 10 5, 10 3, 5 3, 5 2, 2 2))",
                   kSquare),
      "(4 4, 9 4)");
  EXPECT_EQ(tight_places("POLYGON ((0 0, 16 0, 16 6, 0 6, 0 0), (1 1, 1 5, 5 5, 5 4, 11 4, 11 5, "
                         "15 5, 15 1, 11 1, 11 2, 5 2, 5 1, 1 1))",
                         kSquare),
            "(4 3, 12 3)");
}

TEST(TightPlaces, TInATShapedSlot) {
  const std::string sheet =
      "POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0), "
      "(2 6, 2 8, 8 8, 8 6, 6 6, 6 2, 4 2, 4 6, 2 6))";
  EXPECT_EQ(tight_places(sheet,
                         "POLYGON ((-2 -6, -2 -8, -8 -8, -8 -6, -6 -6, -6 -2, -4 -2, "
                         "-4 -6, -2 -6))"),
            "(0 0)");
  // A shorter foot cannot move either; a square one moves in both bars.
  EXPECT_EQ(tight_places(sheet,
                         "POLYGON ((-2 -6, -2 -8, -8 -8, -8 -6, -6 -6, -6 -5, -4 -5, "
                         "-4 -6, -2 -6))"),
            "(0 0)");
  EXPECT_EQ(tight_places(sheet, kSquare), "(3 7, 5 7) (5 3, 5 7) (5 7, 7 7)");
}

TEST(TightPlaces, PartAsLargeAsItsSheet) {
  const Region frame_around = parse_wkt(
      "POLYGON ((-10 -10, 1010 -10, 1010 1010, -10 1010, -10 -10), "
      "(0 0, 0 1000, 1000 1000, 1000 0, 0 0))");
  EXPECT_EQ(tight_places(frame_around, rectangle(-1000, -1000, 0, 0)), "(0 0)");
  EXPECT_EQ(tight_places(frame_around, rectangle(-1000, -600, 0, 0)), "(0 0, 0 400)");
}

TEST(TightPlaces, CornersThatHoldWithoutParallelEdges) {
  EXPECT_EQ(tight_places("POLYGON ((0 0, 8 0, 8 4, 5 4, 6 2, 2 2, 3 4, 0 4, 0 0))",
                         "POLYGON ((-2 -2, -6 -2, -5 -4, -3 -4, -2 -2))"),
            "(0 0)");
  // Each corner of the diamond is on the middle of an edge of the square hole.
  EXPECT_EQ(
      tight_places("POLYGON ((-9 -9, 9 -9, 9 9, -9 9, -9 -9), (-2 -2, -2 2, 2 2, 2 -2, -2 -2))",
                   "POLYGON ((2 0, 0 2, -2 0, 0 -2, 2 0))"),
      "(0 0)");
  // A triangle turned in another has three points of contact.
  EXPECT_EQ(tight_places("POLYGON ((-9 -9, 19 -9, 19 19, -9 19, -9 -9), (0 0, 4 8, 12 0, 0 0))",
                         "POLYGON ((-2 -4, -8 -4, -6 0, -2 -4))"),
            "(0 0)");
}

TEST(TightPlaces, RingsThatTouch) {
  // Two crescents hang in one another, so four parts touch at two points. Only there do pairs of
  // corners of both operands alternate.
  const std::string crescents =
      "POLYGON ((0 0, 4 8, 0 16, -4 8, 0 0), (0 0, -2 8, 0 16, 2 8, 0 0))";
  EXPECT_EQ(tight_places(crescents,
                         "POLYGON ((0 0, -5 -8, 0 -16, 2 -8, 0 0), "
                         "(0 0, -2 -8, 0 -16, -4 -8, 0 0))"),
            "(0 0)");
  // This part fits into a hole that touches the outer ring at its corner.
  EXPECT_EQ(tight_places("POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (0 0, 2 6, 6 6, 6 2, 0 0))",
                         "POLYGON ((0 0, -2 -6, -6 -6, -6 -2, 0 0))"),
            "(0 0)");
  // The hole's corner touches the middle of an edge, and the part has the form of the hole.
  EXPECT_EQ(tight_places("POLYGON ((-9 0, 9 0, 9 9, -9 9, -9 0), (0 0, -2 4, 2 4, 0 0))",
                         "POLYGON ((0 0, 2 -4, -2 -4, 0 0))"),
            "(0 0)");
}

TEST(TightPlaces, PartsOfAnOperand) {
  // Two squares side by side leave a slot; each alone would not.
  EXPECT_EQ(tight_places("MULTIPOLYGON (((0 0, 2 0, 2 2, 0 2, 0 0)), ((4 0, 6 0, 6 2, 4 2, 4 0)))",
                         kSquare),
            "(3 -1, 3 3)");
  // The island fits the slot, but the part is too wide for the room around the island.
  EXPECT_EQ(tight_places("MULTIPOLYGON (((0 0, 40 0, 40 40, 0 40, 0 0), "
                         "(15 15, 15 25, 25 25, 25 15, 15 15)), "
                         "((19 19, 21 19, 21 21, 19 21, 19 19)))",
                         "POLYGON ((0 0, 12 0, 12 8, 7 8, 7 4, 5 4, 5 8, 0 8, 0 0))"),
            "");
  EXPECT_EQ(tight_places("MULTIPOLYGON (((0 0, 40 0, 40 40, 0 40, 0 0), "
                         "(10 10, 10 30, 30 30, 30 10, 10 10)), "
                         "((19 19, 21 19, 21 21, 19 21, 19 19)))",
                         "POLYGON ((0 0, 12 0, 12 8, 7 8, 7 4, 5 4, 5 8, 0 8, 0 0))"),
            "(26 25, 26 29)");
  // Both operands have two squares that touch at a corner, which makes four quadrants.
  EXPECT_EQ(
      tight_places("MULTIPOLYGON (((0 0, 9 0, 9 9, 0 9, 0 0)), ((0 0, -9 0, -9 -9, 0 -9, 0 0)))",
                   "MULTIPOLYGON (((0 0, 2 0, 2 -2, 0 -2, 0 0)), ((0 0, -2 0, -2 2, 0 2, 0 0)))"),
      "(0 0)");
}

TEST(TightPlaces, OtherMethodsRefuse) {
  SumSettings options;
  options.tight = true;
  for (const Method method : {Method::kSigned, Method::kFull}) {
    options.method = method;
    try {
      (void)detailed_sum(rectangle(0, 0, 1, 1), rectangle(0, 0, 1, 1), options);
      FAIL() << "no error";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadInput);
    }
  }
}

TEST(TightPlaces, PreparedOperandsAndReusedMemory) {
  const Region sheet = frame({{{2, 2}, {2, 4}, {4, 4}, {4, 2}}}, 2);
  const PreparedRegion p(sheet);
  const PreparedRegion q(parse_wkt(kSquare));
  Workspace memory;
  for (Workspace* const kept : {static_cast<Workspace*>(nullptr), &memory}) {
    const Options options{.tight = true, .memory = kept};
    EXPECT_EQ(text_of(detailed_sum(p, q, options).tight), "(3 3)");
    EXPECT_EQ(text_of(detailed_sum(q, q, options).tight), "");
  }
  EXPECT_TRUE(detailed_sum(p, PreparedRegion(Region{}), {.tight = true}).tight.empty());
}

/// Keeps the results of all stages of one sum, for the checker.
struct Stages : StageMemory {
  Stages(const Region& p, const Region& q) {
    Geometry places;
    SumRequest request;
    request.cover = false;  // the points inside the sum serve the tests of the checker
    request.want_tight_places(places);
    Region sum;
    run_pipeline({p}, {q}, request, *this, sum);
  }
  [[nodiscard]] std::optional<std::string> fault() const {
    return check(tight, arrangement, loops, filtered, operands);
  }
};

TEST(TightPlaces, CheckerRejects) {
  // A slot ends in one room, and the part fits the other room exactly.
  const Region rooms = parse_wkt(
      "POLYGON ((0 0, 20 0, 20 8, 0 8, 0 0), (2 2, 2 5, 10 5, 10 3, 5 3, 5 2, 2 2), "
      "(14 2, 14 4, 16 4, 16 2, 14 2))");
  const Stages good(rooms, parse_wkt(kSquare));
  ASSERT_EQ(good.fault(), std::nullopt);
  ASSERT_GE(good.tight.slits.size(), 1U);
  ASSERT_EQ(good.tight.nodes.size(), 1U);
  const auto fault_after = [&](auto damage) {
    Stages s(rooms, parse_wkt(kSquare));
    damage(s);
    return s.fault().value_or("");
  };
  EXPECT_EQ(fault_after([](Stages& s) { s.tight.slits.clear(); }), "a slit was misjudged");
  EXPECT_EQ(fault_after([](Stages& s) { s.tight.slits.push_back(s.tight.slits[0]); }),
            "a slit is listed twice");
  EXPECT_EQ(fault_after([](Stages& s) { s.tight.slits.push_back(1000); }), "a slit is not there");
  EXPECT_EQ(fault_after([](Stages& s) { s.tight.nodes.push_back(s.tight.nodes[0]); }),
            "a point is on the boundary or a slit, or listed twice");
  EXPECT_EQ(fault_after([](Stages& s) {
              s.tight.nodes.push_back(s.arrangement.slits[s.tight.slits[0]].to);
            }),
            "a point is on the boundary or a slit, or listed twice");
  EXPECT_EQ(fault_after([](Stages& s) { s.tight.nodes.push_back(100000); }),
            "a point is not there");
  // Most other points inside the sum are in the sum of the insides.
  std::size_t not_tight = 0;
  for (NodeId node = 0; node < good.arrangement.nodes.size(); ++node) {
    const std::string fault = fault_after([node](Stages& s) { s.tight.nodes = {node}; });
    if (fault == "a point is not tight") ++not_tight;
  }
  EXPECT_GE(not_tight, 1U);
  for (SiteId v = 0; v < good.operands.split; ++v) {
    const SumVertex pinch{v, good.operands.split};
    const std::string fault = fault_after([&](Stages& s) { s.tight.pinches = {pinch}; });
    if (fault == "a pinch is not tight") ++not_tight;
  }
  EXPECT_GE(not_tight, 2U);
}

struct Expected {
  const char* p;
  const char* q;
  const char* tight;
};

TEST(TightPlaces, DegenerateData) {
  const auto data = data_path();
  if (!data) GTEST_SKIP() << "no folder of shapes";
  const Expected all[] = {
      {"frame_a", "square2_centred", "(3 3)"},
      {"frame_long", "square2_centred", "(3 3, 3 6)"},
      {"frame_l", "square2_centred", "(3 7, 3 3, 7 3)"},
      {"frame_plus", "square2_centred", "(3 6, 6 6) (6 3, 6 6) (6 6, 6 9) (6 6, 9 6)"},
      {"frame_wide_l", "square2_centred", "(4 4, 9 4)"},
      {"two_rooms_tight", "square2_centred", "(4 3, 12 3)"},
      {"two_rooms_wider", "square2_centred", ""},
      {"two_rooms_narrower", "square2_centred", ""},
      {"peg_slot_a", "peg_slot_b", "(3 5, 3 9)"},
      {"dovetail_a", "dovetail_b", "(0 0)"},
      {"triangle_hole_a", "triangle_hole_b", "(0 0)"},
      {"hexagon_hole_a", "hexagon", "(0 0)"},
      {"star_hole_a", "star_b", "(0 0)"},
      {"frame_decimal", "square_0_3", "(2/5 2/5)"},
      {"rooms3", "square2_centred", "(4 3, 10 3) (12 3, 18 3) (20 3, 24 3)"},
      {"maze_tight", "square2_centred", "(3 3, 11 3, 11 7, 3 7, 3 11, 11 11)"},
      {"huge_2p53_hole", "unit_square", "(4503599627370497 4503599627370497)"},
      {"scalene_hole", "scalene_point_mirror", "(0 0)"},
      {"scalene_hole", "scalene", ""},
  };
  for (const Expected& e : all) {
    const auto read = [&](const char* name) {
      return read_wkt(*data / "degenerate" / (std::string(name) + ".wkt"));
    };
    EXPECT_EQ(tight_places(read(e.p), read(e.q)), e.tight) << e.p << ", " << e.q;
  }
}

}  // namespace
