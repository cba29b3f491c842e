// Compares offsets with GEOS's buffers, on real shapes (MINKSUM_DATA) and on random ones.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "minksum/boolean.hpp"
#include "minksum/measure.hpp"
#include "minksum/resolve.hpp"
#include "minksum/round.hpp"
#include "property/offsets.hpp"
#include "support/data.hpp"
#include "support/geos_geometry.hpp"

namespace minksum {
namespace {

using namespace test;

constexpr int kQuadrantSegments = 64;

/// The error of GEOS as a share of the distance. GEOS leaves out reflex vertices that are less than
/// a hundredth of the distance deep, and inscribes arcs that are off by less than 10^-4.
const Rational kGeosTolerance(102, 10000);

Region buffer(const Geometry& a, double distance, const OffsetOptions& options) {
  const GeosContext context(GEOS_init_r());
  GEOSContextHandle_t const geos = context.get();
  const GeosGeometry input = to_geos(geos, a);
  constexpr std::array kGeosJoins{GEOSBUF_JOIN_ROUND, GEOSBUF_JOIN_MITRE, GEOSBUF_JOIN_MITRE,
                                  GEOSBUF_JOIN_BEVEL};
  constexpr std::array kGeosCaps{GEOSBUF_CAP_ROUND, GEOSBUF_CAP_FLAT, GEOSBUF_CAP_SQUARE};
  const GeosGeometry result(
      GEOSBufferWithStyle_r(geos, input.get(), distance, kQuadrantSegments,
                            kGeosCaps[static_cast<std::size_t>(options.cap)],
                            kGeosJoins[static_cast<std::size_t>(options.join)],
                            options.miter_limit.to_double()),
      {geos});
  if (result == nullptr) throw std::runtime_error("GEOS made no buffer");
  return from_geos(geos, result.get());
}

double perimeter(const Region& region) {
  double sum = 0;
  for (std::size_t ring = 0; ring < region.ring_count(); ++ring) {
    const IndexRange range = region.vertices_of(ring);
    std::size_t before = range.front() + range.size() - 1;
    for (const std::size_t v : range) {
      sum += std::hypot(region.x(v) - region.x(before), region.y(v) - region.y(before));
      before = v;
    }
  }
  return sum;
}

/// Returns the operand in doubles, as GEOS sees it.
Geometry in_doubles(const Geometry& geometry) { return round(resolve(geometry)); }

/// Expects that GEOS's buffer contains our inner offset by a smaller distance, and lies in our
/// outer offset by a larger one.
void expect_round_agreement(const std::string& name, const Geometry& a, const Rational& d) {
  OffsetOptions options;
  const Region theirs = resolve({buffer(a, d.to_double(), options), {}, {}}).region;
  const Rational size = d.sign() < 0 ? -d : d;
  options.side = RoundingSide::kOutside;
  EXPECT_TRUE(contains(offset(a, d + size * kGeosTolerance, options).region, theirs)) << name;
  options.side = RoundingSide::kInside;
  EXPECT_TRUE(contains(theirs, offset(a, d - size * kGeosTolerance, options).region)) << name;
}

/// Expects that the area in which both differ is at most the length of both boundaries times both
/// tolerances.
void expect_agreement_by_area(const std::string& name, const Geometry& a, const Rational& d,
                              const OffsetOptions& options) {
  const Region theirs = resolve({buffer(a, d.to_double(), options), {}, {}}).region;
  const Region ours = offset(a, d, options).region;
  const double size = std::fabs(d.to_double());
  const double tolerance = size * (kGeosTolerance.to_double() + 0.001);
  const double difference = approximate_area(symmetric_difference(ours, theirs));
  EXPECT_LE(difference, (perimeter(ours) + perimeter(theirs)) * tolerance)
      << name << ", " << to_string(options.join) << ", " << to_string(options.cap) << ", distance "
      << d << ": areas " << approximate_area(ours) << " and " << approximate_area(theirs);
}

Rational part_of_size(const Region& region, int part) {
  const Box box = *bounding_box(region);
  const Rational size = (box.max.x - box.min.x) / Rational(part);
  return Rational(std::round(size.to_double() * 1e6) / 1e6);
}

TEST(OffsetBesideGeos, RealShapes) {
  const auto data = data_path();
  if (!data) GTEST_SKIP();
  for (const char* const name :
       {"paper/bird.wkt", "paper/lookalike_hand2.wkt", "paper/hole5.wkt",
        "paper/neuron_original.wkt", "paper/star2.wkt", "nesting/baldacci1_hide_0.wkt",
        "nesting/albano_0.wkt", "fonts/dejavusans_u0040_at.wkt",
        "fonts/dejavusans_u0026_ampersand.wkt", "gis/lesotho_10m.wkt", "gis/us_louisiana.wkt",
        "gis/norway_50m.wkt", "gis/us_hawaii.wkt"}) {
    const Geometry a = in_doubles({read_wkt(*data / name), {}, {}});
    for (const int part : {20, 200}) {
      const Rational d = part_of_size(a.region, part);
      for (const Rational& by : {d, -d}) {
        expect_round_agreement(name, a, by);
        for (const Join join : {Join::kRound, Join::kMiter, Join::kBevel}) {
          OffsetOptions options;
          options.join = join;
          options.miter_limit = 1000;
          expect_agreement_by_area(name, a, by, options);
        }
      }
    }
  }
}

TEST(OffsetBesideGeos, CapsOfPolylines) {
  Random random(seed_from_environment(1));
  for (int i = 0; i < count_from_environment(60); ++i) {
    Geometry lines;
    lines.polylines.push_back(random_simple_polyline(random, 8, 20));
    const Rational d(random.between(1, 12), 8);
    for (const Cap cap : {Cap::kRound, Cap::kButt, Cap::kSquare}) {
      for (const Join join : {Join::kRound, Join::kMiter, Join::kBevel}) {
        OffsetOptions options;
        options.join = join;
        options.cap = cap;
        options.miter_limit = 1000;
        expect_agreement_by_area(to_text(lines), lines, d, options);
      }
    }
    expect_round_agreement(to_text(lines), lines, d);
  }
}

TEST(OffsetBesideGeos, RandomRegions) {
  Random random(seed_from_environment(2));
  for (int i = 0; i < count_from_environment(60); ++i) {
    const Geometry a{random_region(random), {}, {}};
    const Rational d(random.between(1, 12) * (i % 2 == 0 ? 1 : -1), 8);
    const std::string name = to_text(a);
    expect_round_agreement(name, a, d);
    for (const Join join : {Join::kRound, Join::kMiter, Join::kBevel}) {
      OffsetOptions options;
      options.join = join;
      options.miter_limit = 1000;
      expect_agreement_by_area(name, a, d, options);
    }
  }
}

}  // namespace
}  // namespace minksum
