// Tests that the calls a new user writes first compile and do what they say.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <new>
#include <ranges>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

#include "minksum/io.hpp"
#include "minksum/minksum.hpp"
#include "minksum/testing.hpp"
#include "support/shapes.hpp"

namespace minksum {
namespace {

const Polygon kTriangle{{{0, 0}, {2, 0}, {0.5, 1}}, {}};

TEST(Face, NumbersOfAnyTypeAreTakenExactly) {
  Region region;
  region.begin_polygon();
  region.begin_ring();
  region.add_vertex(1, 2.5);
  region.add_vertex(1LL, 2u);
  region.add_vertex(Rational(1, 3), 0.1);
  region.add_vertex(1.5F, std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(region.point(0), (Point{1, Rational(5, 2)}));
  EXPECT_EQ(region.point(1), (Point{1, 2}));
  EXPECT_EQ(region.point(2), (Point{Rational(1, 3), Rational(0.1)}));
  EXPECT_EQ(region.exact_y(3).to_string(), "18446744073709551615");
  const Rational size = std::vector<int>(3).size();
  EXPECT_EQ(size, 3);
  EXPECT_EQ(Rational(1, 2.5), Rational(2, 5));
  EXPECT_EQ(Rational(std::numeric_limits<std::uint64_t>::max(), 1).sign(), 1);
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    const auto names_vertex = [&](auto add) {
      try {
        add();
        ADD_FAILURE() << "it was taken";
      } catch (const Error& error) {
        EXPECT_EQ(error.culprit().vertex, 4U);
      }
    };
    names_vertex([&] { region.add_vertex(1, bad); });
    names_vertex([&] { region.add_vertex(bad, 1.5); });
  }
}

TEST(Face, ShapesConvertToWhatIsAskedFor) {
  const Region region = kTriangle;
  const Geometry geometry = region;
  const PreparedRegion prepared(region);
  const Region sum = minkowski_sum(region, region);
  EXPECT_EQ(minkowski_sum(kTriangle, kTriangle), sum);
  EXPECT_EQ(minkowski_sum(region, geometry), Geometry(sum));
  EXPECT_EQ(minkowski_sum(region, prepared), sum);
  EXPECT_EQ(minkowski_sum(prepared, region), sum);
  EXPECT_EQ(offset(region, 1), offset(geometry, Rational(1)));
  EXPECT_EQ(offset(geometry, 0.5), offset(geometry, Rational(1, 2)));
  EXPECT_EQ(no_fit_polygon(region, region), no_fit_polygon(geometry, geometry));
  Workspace workspace;
  Region result;
  EXPECT_TRUE(minkowski_sum(region, prepared, Options{}, workspace, result).ok());
  EXPECT_EQ(result, sum);
  EXPECT_TRUE(minkowski_sum(prepared, result, Options{}, workspace, result).ok());
  EXPECT_EQ(result, minkowski_sum(region, sum));
}

TEST(Face, ArraysGoInAndOut) {
  const std::vector<std::array<double, 2>> points{{0, 0}, {2, 0}, {0.5, 1}};
  EXPECT_EQ(Region::from_points(points), Region(kTriangle));
  const std::vector<double> coordinates{0, 0, 9, 0, 0, 9, 1, 1, 1, 2, 2, 1, 20, 0, 21, 0, 20, 1};
  const Region region = Region::from_flat(coordinates, std::vector<std::int64_t>{0, 3, 6, 9},
                                          std::vector<std::int64_t>{0, 2, 3});
  EXPECT_EQ(region.polygon_count(), 2U);
  EXPECT_EQ(region.hole_count(), 1U);
  EXPECT_EQ(region.flat().coordinates, coordinates);
  EXPECT_EQ(Region::from_flat(region.flat()), region);
  EXPECT_EQ(Region::from_flat({}), Region());
  std::vector<double> read;
  std::vector<bool> holes;
  for (const RingView ring : region.rings()) {
    holes.push_back(ring.is_hole());
    for (const auto& [x, y] : ring.points()) read.insert(read.end(), {x, y});
    EXPECT_EQ(ring.exact_points()[0], region.point(region.vertices_of(ring.index()).front()));
  }
  EXPECT_EQ(read, coordinates);
  const auto rings = region.rings();
  EXPECT_EQ(std::ranges::count_if(rings, &RingView::is_hole), 1);
  EXPECT_EQ(std::vector<RingView>(rings.begin(), rings.end()).size(), 3U);
  EXPECT_EQ(holes, (std::vector<bool>{false, true, false}));
}

TEST(Face, RangesAreViewsWithRandomAccess) {
  const Region region = kTriangle;
  const RingView ring(region, 0);
  const auto check = [](const auto& range) {
    using Range = std::remove_cvref_t<decltype(range)>;
    static_assert(std::ranges::random_access_range<Range> && std::ranges::sized_range<Range>);
    static_assert(std::ranges::view<Range> && std::ranges::borrowed_range<Range>);
    EXPECT_EQ(range.end() - range.begin(), static_cast<std::ptrdiff_t>(range.size()));
    EXPECT_EQ(range.begin() + 1 - 1, range.begin());
    EXPECT_LT(range.begin(), range.end());
  };
  check(region.rings());
  check(region.vertices_of(0));
  check(ring.points());
  check(ring.exact_points());
  std::vector<Point> backwards;
  std::ranges::reverse_copy(ring.exact_points(), std::back_inserter(backwards));
  EXPECT_EQ(backwards, (std::vector<Point>{{0.5, 1}, {2, 0}, {0, 0}}));
  const auto top = std::ranges::max_element(ring.points(), {}, &ApproximatePoint::y);
  EXPECT_EQ((*top).x, 0.5);
  EXPECT_EQ(region.vertices_of(0).back(), 2U);
  EXPECT_EQ(region.vertices_of(0)[1], 1U);
  EXPECT_EQ(ring.points().front(), (ApproximatePoint{0, 0}));
  EXPECT_EQ(ring.exact_points().back(), (Point{0.5, 1}));
}

TEST(Face, NumbersAndPointsAreKeysAndCount) {
  Rational number = 1;
  number += 2;
  number *= Rational(1, 3);
  number -= 0.5;
  number /= Rational(1, 2);
  EXPECT_EQ(number, 1);
  EXPECT_LT((Point{1, 2}), (Point{1, Rational(5, 2)}));
  EXPECT_LT((Point{1, 9}), (Point{2, 0}));
  std::unordered_map<Point, int> seen;
  ++seen[{Rational(2, 4), 1}];
  ++seen[{0.5, 1}];
  EXPECT_EQ(seen.size(), 1U);
  EXPECT_EQ(std::hash<Rational>()(Rational(0)), std::hash<Rational>()(-Rational(0)));
  Region region;
  region.begin_polygon();
  region.begin_ring();
  for (const Point& point : kTriangle.outer) region.add_vertex(point);
  EXPECT_EQ(region, Region(kTriangle));
  EXPECT_EQ(bounding_box(region), bounding_box(region));
  EXPECT_EQ(region.flat(), region.flat());
  EXPECT_EQ(Affine{.dx = 3}, Affine::translation(3, 0));
}

TEST(Face, ShapesOfAnyKindAreUnited) {
  const Region region = kTriangle;
  const Geometry line({}, {{{5, 5}, {6, 6}}});
  EXPECT_EQ(unite(std::vector<Region>(3, region)), region);
  EXPECT_EQ(unite(region, line), Geometry(region, line.polylines));
  EXPECT_EQ(unite(kTriangle, kTriangle), region);
}

TEST(Face, FlatArraysThatDoNotFitAreRefused) {
  using Offsets = std::vector<std::int64_t>;
  const std::vector<double> xy{0, 0, 1, 0, 0, 1};
  const auto fails = [](const std::vector<double>& c, const Offsets& rings,
                        const Offsets& polygons) {
    EXPECT_THROW(static_cast<void>(Region::from_flat(c, rings, polygons)), Error);
  };
  fails({0, 0, 1}, {0, 1}, {0, 1});
  fails(xy, {0, 4}, {0, 1});
  fails(xy, {0, 2}, {0, 1});
  fails(xy, {1, 3}, {0, 1});
  fails(xy, {0, 2, 1, 3}, {0, 3});
  fails(xy, {0, -1, 3}, {0, 2});
  fails(xy, {0, 3}, {0, 2});
  fails(xy, {}, {0});
  fails(xy, {0, 3}, {});
}

TEST(Face, RegionsPrint) {
  const Region region = kTriangle;
  std::ostringstream out;
  out << region << ' ' << Geometry(region);
  EXPECT_EQ(out.str(), "POLYGON ((0 0, 2 0, 0.5 1, 0 0)) POLYGON ((0 0, 2 0, 0.5 1, 0 0))");
  EXPECT_EQ(io::to_geojson(region),
            R"({"type": "Polygon", "coordinates": [[[0,0], [2,0], [0.5,1], [0,0]]]})");
}

TEST(Face, EveryOperationCanBeAttempted) {
  const Geometry plate{test::rectangle(0, 0, 9, 9)};
  Geometry grown;
  Outcome outcome = attempt([&] { grown = offset(plate, 1); });
  EXPECT_TRUE(outcome.ok());
  EXPECT_FALSE(grown.empty());
  outcome = attempt([&] { grown = erode(plate, {}); });
  ASSERT_FALSE(outcome.ok());
  EXPECT_EQ(outcome.error->code(), ErrorCode::kBadInput);
  EXPECT_EQ(outcome.error->culprit().operand, 1);
  Workspace workspace;
  Region sum;
  const Region bow_tie{Polygon{{{0, 0}, {4, 4}, {4, 0}, {0, 4}}}};
  outcome = attempt([&] { return minkowski_sum(bow_tie, bow_tie, Options{}, workspace, sum); });
  ASSERT_FALSE(outcome.ok());
  EXPECT_EQ(outcome.error->code(), ErrorCode::kBadInput);
  outcome = attempt([] { throw std::bad_alloc(); });
  ASSERT_FALSE(outcome.ok());
  EXPECT_EQ(outcome.error->limit()->name, "memory");
}

TEST(Face, WhatACallbackThrowsLeavesNoResultBehind) {
  std::vector<std::array<std::int64_t, 2>> comb;
  for (std::int64_t i = 0; i < 400; ++i) comb.push_back({i, i % 2 == 0 ? 1 : 99});
  comb.push_back({400, -1});
  comb.push_back({-1, -1});
  const Region region = Region::from_points(comb);
  Workspace workspace;
  bool done = false;
  for (int most = 0; !done; most = 2 * most + 1) {
    int calls = 0;
    const Options options{.progress = [&](const Progress&) -> bool {
      if (calls++ == most) throw 1;
      return true;
    }};
    Region result = kTriangle;
    try {
      done = minkowski_sum(region, region, options, workspace, result).ok();
      EXPECT_FALSE(result.empty());
    } catch (int) {
      EXPECT_TRUE(result.empty());
    }
  }
}

TEST(Face, WhatEndsWithTheExpressionLeavesNoReference) {
  static_assert(!std::is_constructible_v<io::FeatureReader, std::string>);
  static_assert(std::is_constructible_v<io::FeatureReader, const std::string&>);
  static_assert(std::is_constructible_v<io::FeatureReader, const char*>);
  static_assert(std::is_constructible_v<io::FeatureReader, std::string_view>);
  static_assert(!std::is_reference_v<decltype(std::declval<NoFitPolygon>().geometry())>);
  static_assert(!std::is_reference_v<decltype(std::declval<PreparedRegion>().region())>);
  const Region region = kTriangle;
  const Region& given = PreparedRegion(region).region();
  EXPECT_EQ(given, region);
  const Geometry& polygon = NoFitPolygon(region, region).geometry();
  EXPECT_EQ(polygon, no_fit_polygon(region, region));
}

TEST(Face, MemoryIsKeptFromCallToCall) {
  Workspace memory;
  const Options options{.memory = &memory};
  const Geometry plate{test::rectangle(0, 0, 9, 9)};
  const Geometry part{kTriangle};
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(minkowski_sum(plate, part, options), minkowski_sum(plate, part));
    EXPECT_EQ(erode(plate, part, options), erode(plate, part));
    EXPECT_EQ(no_fit_polygon(plate, part, {}, options), no_fit_polygon(plate, part));
    EXPECT_EQ(offset(plate, 1, {.join = Join::kMiter}, options),
              offset(plate, 1, {.join = Join::kMiter}));
  }
}

TEST(Face, WhatIsAskedForBesideTheSumChangesNothing) {
  const Region region = kTriangle;
  std::vector<Stage> stages;
  const Options watched{.progress = [&](const Progress& progress) {
    stages.push_back(progress.stage);
    return true;
  }};
  const DetailedSum plain = detailed_sum(region, region, watched);
  EXPECT_TRUE(plain.statistics.small);  // as without statistics and progress
  EXPECT_EQ(stages, std::vector<Stage>{Stage::kOperands});
  EXPECT_TRUE(plain.trace.pieces.empty());
  const DetailedSum traced = detailed_sum(region, region, {.tight = true}, Detail::kTrace);
  EXPECT_FALSE(traced.statistics.small);
  EXPECT_FALSE(traced.trace.pieces.empty());
  EXPECT_EQ(traced.sum, plain.sum);
  EXPECT_EQ(plain.sum.region, minkowski_sum(region, region));
}

TEST(Face, ErrorsNameTheLimitThatWasPassed) {
  const Region region = kTriangle;
  SumSettings options;
  options.limits.max_segments = 2;
  options.method = Method::kSigned;
  Workspace workspace;
  Region result;
  const Outcome outcome = minkowski_sum(region, region, options, workspace, result);
  ASSERT_FALSE(outcome.ok());
  ASSERT_TRUE(outcome.error->limit().has_value());
  EXPECT_EQ(outcome.error->limit()->name, "Limits::max_segments");
  EXPECT_EQ(outcome.error->limit()->value, 2U);
}

TEST(Face, WhatIsMovedFromIsStillGood) {
  CancelToken token;
  Options options;
  options.cancel = std::move(token);
  token.cancel();  // NOLINT(bugprone-use-after-move)
  EXPECT_TRUE(options.cancel->cancelled());
  PreparedRegion first(Region{kTriangle});
  const PreparedRegion second = std::move(first);
  EXPECT_EQ(minkowski_sum(first, second),
            minkowski_sum(second, second));  // NOLINT(bugprone-use-after-move)
  PointLocator locator{Geometry(Region{kTriangle})};
  const PointLocator other = std::move(locator);
  EXPECT_EQ(locator.locate({0, 0}), other.locate({0, 0}));  // NOLINT(bugprone-use-after-move)
  const Region region{kTriangle};
  NoFitPolygon polygon(region, region);
  const NoFitPolygon same = std::move(polygon);
  EXPECT_EQ(polygon.geometry(), same.geometry());  // NOLINT(bugprone-use-after-move)
  EXPECT_EQ(polygon.contact({0, 0}), same.contact({0, 0}));
  Workspace workspace;
  Region result;
  EXPECT_TRUE(minkowski_sum(region, region, Options{}, workspace, result).ok());
  Workspace taken = std::move(workspace);
  for (Workspace* const memory : {&workspace, &taken}) {  // NOLINT(bugprone-use-after-move)
    EXPECT_TRUE(minkowski_sum(region, region, Options{}, *memory, result).ok());
    EXPECT_EQ(result, minkowski_sum(region, region));
  }
}

TEST(Face, EnumeratorsThatDoNotExistAreRefusedByName) {
  const Region region{kTriangle};
  const std::array<Geometry, 2> two{region, region};
  const PreparedRegion prepared(region);
  const auto expect_refused = [](const std::string& option, const auto& call) {
    const Outcome outcome = attempt(call);
    ASSERT_FALSE(outcome.ok()) << option;
    EXPECT_EQ(outcome.error->code(), ErrorCode::kBadInput);
    EXPECT_EQ(outcome.error->what(), "there is no such " + option);
  };
  for (const int number : {-1, 99}) {
    Options options;
    options.fill = static_cast<FillRule>(number);
    const auto fill = [&](const auto& call) { expect_refused("fill", call); };
    fill([&] { (void)minkowski_sum(region, region, options); });
    fill([&] { (void)minkowski_sum(two[0], two[1], options); });
    fill([&] { (void)minkowski_sum(prepared, prepared, options); });
    fill([&] { (void)minkowski_sum(Region(), Region(), options); });
    fill([&] { (void)resolve(Geometry(), options); });
    fill([&] { (void)resolve(two[0], options); });
    fill([&] { (void)unite(two, options); });
    fill([&] { (void)round(region, {}, options); });
    fill([&] { (void)area(region, options); });
    fill([&] { (void)offset(region, 1, {}, options); });
    fill([&] { (void)no_fit_polygon(region, region, {}, options); });
    fill([&] { (void)NoFitTable(two, 4, options); });
    fill([&] { (void)PointLocator(region, options); });
    fill([&] { (void)ConfigurationSpace(region, region, {}, options); });
    fill([&] { (void)check_sum(region, region, region, {}, options); });
    const auto side = static_cast<RoundingSide>(number);
    expect_refused("side", [&] { (void)round(region, {.side = side}); });
    expect_refused("side", [&] { (void)disc(1, 1, side); });
    expect_refused("side", [&] { (void)offset(region, 1, {.side = side}); });
    expect_refused("join", [&] { (void)offset(region, 1, {.join = static_cast<Join>(number)}); });
    expect_refused("cap", [&] { (void)offset(region, 0, {.cap = static_cast<Cap>(number)}); });
    expect_refused("detail", [&] {
      (void)detailed_sum(region, region, Options{}, static_cast<Detail>(number));
    });
    SumSettings settings;
    settings.method = static_cast<Method>(number);
    Workspace workspace;
    Region result;
    expect_refused("method", [&] { (void)minkowski_sum(region, region, settings); });
    EXPECT_FALSE(minkowski_sum(region, region, settings, workspace, result).ok());
    settings.method = Method::kReduced;
    settings.arithmetic = static_cast<Arithmetic>(number);
    expect_refused("arithmetic", [&] { (void)minkowski_sum(two[0], two[1], settings); });
    expect_refused("format", [&] { (void)io::to_text(region, static_cast<io::Format>(number)); });
    const io::Coordinates style{static_cast<io::Coordinates::Style>(number)};
    for (const auto format : {io::Format::kWkt, io::Format::kSvg, io::Format::kWkb}) {
      expect_refused("style", [&] { (void)io::to_text(region, format, style); });
    }
    expect_refused("side", [&] {
      (void)io::read("POLYGON ((0 0, 1 0, 0 1, 0 0))", {.drawing = {.side = side}});
    });
    EXPECT_STREQ(to_string(options.fill), "unknown");
    EXPECT_STREQ(to_string(side), "unknown");
    EXPECT_STREQ(to_string(static_cast<Stage>(number)), "unknown");
    EXPECT_STREQ(to_string(static_cast<Join>(number)), "unknown");
    EXPECT_STREQ(to_string(static_cast<Cap>(number)), "unknown");
  }
}

TEST(Face, OperationsThatAreCancelledBeforehandDoNotBegin) {
  const Region region{kTriangle};
  const std::array<Geometry, 2> two{region, region};
  const NoFitTable table(two);
  Options options;
  options.cancel.emplace().cancel();
  const auto expect_cancelled = [](const char* what, const auto& call) {
    const Outcome outcome = attempt(call);
    ASSERT_FALSE(outcome.ok()) << what;
    EXPECT_EQ(outcome.error->code(), ErrorCode::kCancelled) << what;
  };
  expect_cancelled("prepare", [&] { (void)PreparedRegion(region, options); });
  expect_cancelled("locator", [&] { (void)PointLocator(region, options); });
  expect_cancelled("sum", [&] { (void)minkowski_sum(region, Region(), options); });
  expect_cancelled("sum of geometries", [&] { (void)minkowski_sum(two[0], Geometry(), options); });
  expect_cancelled("area", [&] { (void)area(region, options); });
  expect_cancelled("approximate area", [&] { (void)approximate_area(region, options); });
  expect_cancelled("bounding box", [&] { (void)bounding_box(region, options); });
  expect_cancelled("coordinate bits", [&] { (void)coordinate_bits(Region(), options); });
  expect_cancelled("transform", [&] { (void)transform(region, Affine::scaling(3), options); });
  expect_cancelled("reflect", [&] { (void)reflect(two[0], options); });
  expect_cancelled("contains", [&] { (void)contains(region, region, options); });
  expect_cancelled("validate", [&] { (void)validate(Region(), 1, options); });
  expect_cancelled("round", [&] { (void)round(region, {}, options); });
  expect_cancelled("offset", [&] { (void)offset(region, 0, {}, options); });
  expect_cancelled("table", [&] { (void)table.at({0, 0}, {1, 0}, options); });
  expect_cancelled("space", [&] { (void)ConfigurationSpace(region, region, {}, options); });
  for (const char* const text : {"POLYGON ((0 0, 1 0, 0 1, 0 0))", "{\"type\": \"Point\"}", "1",
                                 "<svg/>", "0 0\n1 0\n0 1\n", "a,WKT\n1,POINT (1 1)\n"}) {
    expect_cancelled(text, [&] { (void)io::read(text, {.cancel = options.cancel}); });
  }
  for (const auto format : {io::Format::kWkt, io::Format::kGeoJson, io::Format::kPoly,
                            io::Format::kWkb, io::Format::kHexWkb}) {
    expect_cancelled(
        "write", [&] { (void)io::to_text(Geometry(region), format, {.cancel = options.cancel}); });
  }
}

}  // namespace
}  // namespace minksum
