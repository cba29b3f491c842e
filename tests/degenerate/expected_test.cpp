// Tests the exact sums that the notes of pairs.tsv state. Tight places are tested elsewhere.
#include <gtest/gtest.h>

#include "degenerate/shapes.hpp"
#include "minksum/resolve.hpp"
#include "reference/canonical.hpp"
#include "reference/membership.hpp"
#include "support/data.hpp"
#include "support/geometries.hpp"

namespace {

using namespace minksum;
using namespace minksum::test;

std::string sum_of(const std::string& a, const std::string& b) {
  return to_text(reduced_sum(read_shape(a), read_shape(b)));
}
std::string region(const Region& region) { return to_text(reference::canonical(region)); }
std::string region(const std::string& wkt) { return region(parse_wkt(wkt)); }
std::string box(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1) {
  return region(rectangle(x0, y0, x1, y1));
}

class Expected : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!degenerate_path()) GTEST_SKIP() << "no data";
  }
};

TEST_F(Expected, FramesThatTheSquareFitsIntoWithoutPlayLoseTheirHoles) {
  EXPECT_EQ(sum_of("frame_a", "square2_centred"), box(-1, -1, 7, 7));
  EXPECT_EQ(sum_of("frame_long", "square2_centred"), box(-1, -1, 7, 10));
  EXPECT_EQ(sum_of("frame_l", "square2_centred"), box(-1, -1, 11, 11));
  EXPECT_EQ(sum_of("frame_plus", "square2_centred"), box(-1, -1, 13, 13));
  EXPECT_EQ(sum_of("maze_tight", "square2_centred"), box(-1, -1, 15, 15));
  EXPECT_EQ(sum_of("grid_holes", "unit_square"), box(0, 0, 12, 12));
  EXPECT_EQ(sum_of("grid_holes", "grid_holes"), box(0, 0, 22, 22));
  EXPECT_EQ(sum_of("peg_slot_a", "peg_slot_b"), box(-1, 0, 7, 9));
}

TEST_F(Expected, WhereThereIsPlayHolesRemain) {
  const auto framed = [](std::int64_t width, std::int64_t height,
                         const std::vector<Outline>& holes) {
    return region(make_polygon({{-1, -1}, {width, -1}, {width, height}, {-1, height}}, holes));
  };
  const Outline left{{2, 2}, {4, 2}, {4, 4}, {2, 4}};
  const Outline right{{12, 2}, {14, 2}, {14, 4}, {12, 4}};
  EXPECT_EQ(sum_of("frame_wide_l", "square2_centred"),
            framed(13, 9, {{{3, 3}, {4, 3}, {4, 4}, {3, 4}}}));
  EXPECT_EQ(sum_of("two_rooms_tight", "square2_centred"), framed(17, 7, {left, right}));
  EXPECT_EQ(sum_of("two_rooms_narrower", "square2_centred"), framed(17, 7, {left, right}));
  EXPECT_EQ(sum_of("two_rooms_wider", "square2_centred"),
            region("POLYGON ((-1 -1, 17 -1, 17 7, -1 7, -1 -1), (2 2, 4 2, 4 3, 12 3, 12 2, 14 2, "
                   "14 4, 12 4, 12 3.000000001, 4 3.000000001, 4 4, 2 4, 2 2))"));
  EXPECT_EQ(sum_of("rooms3", "square2_centred"),
            framed(27, 7, {left, {{10, 2}, {12, 2}, {12, 4}, {10, 4}},
                           {{18, 2}, {20, 2}, {20, 4}, {18, 4}}}));
}

TEST_F(Expected, PerfectFitsLeaveNoHole) {
  const std::pair<const char*, const char*> fits[] = {
      {"dovetail_a", "dovetail_b"},   {"triangle_hole_a", "triangle_hole_b"},
      {"hexagon_hole_a", "hexagon"},  {"star_hole_a", "star_b"},
      {"frame_decimal", "square_0_3"}, {"scalene_hole", "scalene_point_mirror"}};
  for (const auto& [a, b] : fits) {
    const Geometry sum = reduced_sum(read_shape(a), read_shape(b));
    EXPECT_FALSE(sum.has_thin_parts()) << a;
    EXPECT_EQ(sum.region.polygon_count(), 1U) << a;
    EXPECT_EQ(sum.region.hole_count(), 0U) << a;
    const reference::Pt fit = a == std::string("frame_decimal") ? reference::Pt{{2, 5}, {2, 5}}
                                                                : reference::Pt{0, 0};
    EXPECT_EQ(reference::locate(fit, sum.region), reference::Side::kInside) << a;
  }
}

TEST_F(Expected, DecimalsFitWhereDoublesHavePlay) {
  const auto as_doubles = [](const std::string& name) {
    const Region exact = read_shape(name).region;
    Region region;
    for (const std::size_t polygon : exact.polygons()) {
      region.begin_polygon();
      for (const std::size_t ring : exact.rings_of(polygon)) {
        region.begin_ring();
        for (const std::size_t v : exact.vertices_of(ring)) {
          region.add_vertex(exact.x(v), exact.y(v));
        }
      }
    }
    return Geometry{region, {}, {}};
  };
  const Geometry sum = reduced_sum(as_doubles("frame_decimal"), as_doubles("square_0_3"));
  ASSERT_EQ(sum.region.hole_count(), 1U);
  const IndexRange hole = sum.region.vertices_of(1);
  ASSERT_EQ(hole.size(), 4U);
  const Rational side(0x1p-55);
  const Point low = sum.region.point(hole.front());
  const Point high = sum.region.point(hole.front() + 2);
  EXPECT_EQ(low.x, Rational(0.1) + Rational(0.3));
  EXPECT_EQ(high.x - low.x, side);
  EXPECT_EQ(high.y - low.y, side);
}

TEST_F(Expected, HugeCoordinatesCancelOrGrowExactly) {
  const Geometry small = reduced_sum(read_shape("huge_2p53"), read_shape("huge_2p53_neg"));
  for (std::size_t v = 0; v < small.region.vertex_count(); ++v) {
    EXPECT_TRUE(small.region.exact_x(v).is_integer() || small.region.exact_x(v).bits() < 16);
    EXPECT_LE(std::abs(small.region.x(v)), 6);
    EXPECT_LE(std::abs(small.region.y(v)), 6);
  }
  const Region mirror = reference::canonical(scaled(small.region, -1));
  EXPECT_EQ(to_text(mirror), to_text(small.region));
  constexpr std::int64_t kSide = (std::int64_t{1} << 53) + 1;
  EXPECT_EQ(sum_of("huge_2p53_hole", "unit_square"), box(0, 0, kSide, kSide));
}

TEST_F(Expected, ADifferenceBodyIsCentrallySymmetric) {
  const Geometry body = reduced_sum(read_shape("scalene"), read_shape("scalene_point_mirror"));
  EXPECT_EQ(to_text(reference::canonical(scaled(body.region, -1))), to_text(body.region));
  EXPECT_EQ(reference::locate({0, 0}, body.region), reference::Side::kInside);
}

TEST_F(Expected, PointsMoveAndNothingGivesNothing) {
  for (const char* name : {"triangle", "l_shape", "frame_a", "multi_island", "segment", "empty"}) {
    const Geometry shape = resolve(read_shape(name));
    EXPECT_EQ(sum_of(name, "empty"), to_text(Geometry{})) << name;
    EXPECT_EQ(sum_of("empty_multi", name), to_text(Geometry{})) << name;
    EXPECT_EQ(sum_of(name, "point_origin"), to_text(shape)) << name;
    if (shape.has_thin_parts()) continue;
    EXPECT_EQ(sum_of(name, "point"), to_text(Geometry{moved(shape.region, 2, 3), {}, {}})) << name;
  }
  EXPECT_EQ(sum_of("point", "point"), to_text(make_lines({}, {{4, 6}})));
  EXPECT_EQ(sum_of("segment", "point"), to_text(make_lines({{{2, 3}, {6, 5}}})));
}

TEST_F(Expected, Sweeps) {
  EXPECT_EQ(sum_of("triangle", "segment"), region(make_polygon({{0, 0}, {3, 0}, {7, 2}, {5, 4},
                                                                {1, 2}})));
  EXPECT_EQ(sum_of("triangle", "segment_horizontal"),
            region(make_polygon({{-3, 0}, {6, 0}, {4, 2}, {-2, 2}})));
  EXPECT_EQ(sum_of("segment", "segment"), to_text(make_lines({{{0, 0}, {8, 4}}})));
  EXPECT_EQ(sum_of("segment", "segment_horizontal"),
            region(make_polygon({{-3, 0}, {3, 0}, {7, 2}, {1, 2}})));
  EXPECT_EQ(sum_of("polyline_l", "unit_square"),
            region(make_polygon({{0, 0}, {5, 0}, {5, 4}, {4, 4}, {4, 1}, {0, 1}})));
  const Outline l_shape{{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}};
  const Outline l_moved{{5, 1}, {9, 1}, {9, 3}, {7, 3}, {7, 5}, {5, 5}};
  EXPECT_EQ(sum_of("multi_points", "l_shape"), region(make_region({{l_shape}, {l_moved}})));
  // A hole that takes away all of its polygon leaves the rim, which the square sweeps along.
  EXPECT_EQ(sum_of("hole_equals_outer", "unit_square"),
            region(make_polygon({{0, 0}, {5, 0}, {5, 5}, {0, 5}},
                                {{{1, 1}, {4, 1}, {4, 4}, {1, 4}}})));
}

}  // namespace
