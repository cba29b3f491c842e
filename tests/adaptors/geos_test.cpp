#include "minksum/adaptors/geos.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdarg>
#include <limits>
#include <memory>
#include <string>

#include "adaptors/sources.hpp"
#include "support/messes.hpp"

namespace minksum::test {
namespace {

using adaptors::from_geos;
using adaptors::GeosGeometry;
using adaptors::to_geos;

class Geos : public testing::Test {
 protected:
  ~Geos() override { GEOS_finish_r(context_); }

  [[nodiscard]] GeosGeometry read(const char* wkt) const {
    GEOSWKTReader* const reader = GEOSWKTReader_create_r(context_);
    GeosGeometry made(GEOSWKTReader_read_r(context_, reader, wkt), {context_});
    GEOSWKTReader_destroy_r(context_, reader);
    return made;
  }
  [[nodiscard]] std::string text(const GeosGeometry& geometry) const {
    GEOSWKTWriter* const writer = GEOSWKTWriter_create_r(context_);
    GEOSWKTWriter_setTrim_r(context_, writer, 1);
    char* const made = GEOSWKTWriter_write_r(context_, writer, geometry.get());
    std::string result = made;
    GEOSFree_r(context_, made);
    GEOSWKTWriter_destroy_r(context_, writer);
    return result;
  }
  [[nodiscard]] std::string there(const Geometry& geometry) const {
    return text(to_geos(context_, geometry));
  }
  [[nodiscard]] Geometry back(const GeosGeometry& geometry) const {
    return from_geos(context_, geometry.get());
  }

  GEOSContextHandle_t context_ = GEOS_init_r();
};

TEST_F(Geos, RoundTripsOfRegions) {
  Random random(seed_from_environment(31));
  for (int i = 0; i < 300; ++i) {
    const Region region = random_source(random);
    const GeosGeometry made = to_geos(context_, region);
    ASSERT_EQ(GEOSGetNumGeometries_r(context_, made.get()),
              static_cast<int>(region.polygon_count()));
    ASSERT_EQ(back(made), Geometry(region)) << to_text(region);
    const Region other = scrambled(region, random);
    ASSERT_EQ(canonical(back(to_geos(context_, other)).region), region) << to_text(other);
  }
}

TEST_F(Geos, RoundTripsOfThinParts) {
  Random random(seed_from_environment(32));
  int mixed = 0;
  for (int i = 0; i < 300; ++i) {
    const Geometry geometry = resolve(random_mess(random));
    // A geometry with crossings at fractions has no form in doubles.
    const auto integer = [](const Point& p) { return p.x.is_integer() && p.y.is_integer(); };
    bool integers = true;
    for (std::size_t v = 0; v < geometry.region.vertex_count(); ++v) {
      integers = integers && integer(geometry.region.point(v));
    }
    for (const Polyline& line : geometry.polylines) {
      for (const Point& point : line) integers = integers && integer(point);
    }
    for (const Point& point : geometry.points) integers = integers && integer(point);
    if (!integers) continue;
    ++mixed;
    ASSERT_EQ(back(to_geos(context_, geometry)), geometry) << to_text(geometry);
  }
  EXPECT_GT(mixed, 50);
}

TEST_F(Geos, HasATypeForEach) {
  const Region square = rectangle(0, 0, 1, 1);
  const Polyline line{{0, 5}, {3, 5}};
  EXPECT_EQ(there({}), "POLYGON EMPTY");
  EXPECT_EQ(there(square), "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))");
  EXPECT_EQ(there(together(square, rectangle(2, 0, 3, 1))),
            "MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0)), ((2 0, 3 0, 3 1, 2 1, 2 0)))");
  EXPECT_EQ(there({{}, {line}}), "LINESTRING (0 5, 3 5)");
  EXPECT_EQ(there({{}, {line, line}}), "MULTILINESTRING ((0 5, 3 5), (0 5, 3 5))");
  EXPECT_EQ(there({{}, {}, {{7, 8}}}), "POINT (7 8)");
  EXPECT_EQ(there({{}, {}, {{7, 8}, {Rational(1, 2), 8}}}), "MULTIPOINT (7 8, 0.5 8)");
  EXPECT_EQ(there({square, {line}, {{7, 8}}}),
            "GEOMETRYCOLLECTION (POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0)), LINESTRING (0 5, 3 5), "
            "POINT (7 8))");
}

// Whatever directions rings have, holes become clockwise, and outer rings counter-clockwise.
TEST_F(Geos, DirectsRings) {
  const Region region =
      make_polygon({{0, 0}, {0, 9}, {9, 9}, {9, 0}}, {{{1, 1}, {2, 1}, {2, 2}, {1, 2}}});
  EXPECT_EQ(there(region), "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 1 2, 2 2, 2 1, 1 1))");
}

TEST_F(Geos, LeavesOutEmptyRings) {
  EXPECT_EQ(there(with_empty_rings()), there(without_empty_rings()));
  const Error error = error_of([&] { (void)to_geos(context_, hole_alone()); });
  EXPECT_EQ(error.code(), ErrorCode::kBadInput);
  EXPECT_EQ(place_of(error), "0 0 -");
}

TEST_F(Geos, ReadsEveryType) {
  const auto polygon = [](const Geometry& geometry) { return to_text(geometry.region); };
  const Geometry all = back(read(
      "GEOMETRYCOLLECTION (POLYGON Z ((0 0 1, 0 4 2, 4 0 3, 0 0 1)), POLYGON EMPTY,"
      "  GEOMETRYCOLLECTION (MULTIPOINT ((1 2), EMPTY, (3 4)), LINEARRING (0 0, 1 0, 1 1, 0 0)),"
      "  LINESTRING EMPTY, MULTILINESTRING ((5 5, 6 6)), POINT EMPTY, POINT (0.1 7))"));
  EXPECT_EQ(polygon(all), "MULTIPOLYGON (((0 0, 0 4, 4 0, 0 0)))");
  ASSERT_EQ(all.polylines.size(), 2U);
  EXPECT_EQ(all.polylines[0].size(), 4U);
  EXPECT_EQ(all.polylines[1].size(), 2U);
  ASSERT_EQ(all.points.size(), 3U);
  EXPECT_EQ(all.points[2].x, Rational(0.1));
  EXPECT_EQ(polygon(back(read("MULTIPOLYGON (EMPTY, ((0 0, 4 0, 0 4, 0 0), EMPTY))"))),
            "MULTIPOLYGON (((0 0, 4 0, 0 4, 0 0)))");
  EXPECT_TRUE(back(read("POLYGON EMPTY")) == Geometry());
}

TEST_F(Geos, TellsWhatIsBad) {
  // GEOS does not read such numbers from text, so they are put into rings one by one.
  const auto polygon_with = [&](double x) {
    GEOSCoordSequence* const points = GEOSCoordSeq_create_r(context_, 4, 2);
    const double xs[] = {0, 4, x, 0};
    const double ys[] = {0, 0, 4, 0};
    for (unsigned i = 0; i < 4; ++i) {
      GEOSCoordSeq_setXY_r(context_, points, i, xs[i], ys[i]);
    }
    return GeosGeometry(GEOSGeom_createPolygon_r(
                            context_, GEOSGeom_createLinearRing_r(context_, points), nullptr, 0),
                        {context_});
  };
  for (const double x : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    const Error error = error_of([&] { (void)back(polygon_with(x)); });
    EXPECT_EQ(error.code(), ErrorCode::kBadInput);
    EXPECT_EQ(place_of(error), "0 0 2");
    const GeosGeometry point(GEOSGeom_createPointFromXY_r(context_, x, 0), {context_});
    EXPECT_NE(std::string(error_of([&] { (void)back(point); }).what()).find("point 0"),
              std::string::npos);
  }
  EXPECT_EQ(error_of([&] { (void)from_geos(context_, nullptr); }).code(), ErrorCode::kBadInput);

  const Region two = together(rectangle(0, 0, 1, 1), make_polygon({{5, 5}, {6, 6}}));
  Error error = error_of([&] { (void)to_geos(context_, two); });
  EXPECT_EQ(error.code(), ErrorCode::kBadInput);
  EXPECT_EQ(place_of(error), "1 0 -");
  error = error_of([&] { (void)to_geos(context_, Geometry({}, {{{1, 1}}})); });
  EXPECT_EQ(error.code(), ErrorCode::kBadInput);
  // The parts that were made before must be destroyed, which a leak checker would notice.
  const Rational far(Decimal{1, 400});
  error = error_of([&] { (void)to_geos(context_, Geometry(two.polygon(0), {}, {{far, 1}})); });
  EXPECT_EQ(error.code(), ErrorCode::kLimitExceeded);
  error = error_of([&] { (void)to_geos(context_, scaled(frame_and_triangle(), far)); });
  EXPECT_EQ(error.code(), ErrorCode::kLimitExceeded);
  EXPECT_EQ(place_of(error), "0 0 1");
}

}  // namespace
}  // namespace minksum::test
