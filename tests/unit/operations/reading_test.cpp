// Tests how every operation reads its operands: a polyline without vertices is nothing, one of one
// vertex is a point, and the fill rule says what rings enclose.
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "minksum/boolean.hpp"
#include "minksum/check.hpp"
#include "minksum/configuration_space.hpp"
#include "minksum/depth.hpp"
#include "minksum/io.hpp"
#include "minksum/locate.hpp"
#include "minksum/morphology.hpp"
#include "minksum/no_fit.hpp"
#include "minksum/offset.hpp"
#include "minksum/reach.hpp"
#include "minksum/resolve.hpp"
#include "minksum/round.hpp"
#include "minksum/testing.hpp"
#include "minksum/transform.hpp"
#include "support/messes.hpp"
#include "support/random.hpp"
#include "support/shapes.hpp"

namespace minksum {
namespace {

using test::rectangle;

/// One set, with such parts and resolved.
struct Pair {
  Geometry given;
  Geometry plain;
};
std::vector<Pair> pairs() {
  const Region square = rectangle(0, 0, 4, 3);
  const Polyline wall{{6, 0}, {9, 2}};
  return {
      {{{}, {{}}, {}}, {}},
      {{{}, {{{2, 7}}}, {}}, {{}, {}, {{2, 7}}}},
      {{{}, {{{2, 7}, {2, 7}}}, {}}, {{}, {}, {{2, 7}}}},
      {{square, {{}, {{1, 1}}, {{9, 9}}}, {}}, {square, {}, {{9, 9}}}},
      {{square, {{}, wall}, {{7, 7}}}, {square, {wall}, {{7, 7}}}},
  };
}

template <class Operation>
void expect_equal(const char* name, Operation operation) {
  for (const Pair& pair : pairs()) {
    const auto run = [&](const Geometry& geometry) -> std::string {
      try {
        return operation(geometry);
      } catch (const Error& error) {
        return error.what();
      }
    };
    EXPECT_EQ(run(pair.given), run(pair.plain)) << name;
  }
}
std::string text(const Geometry& geometry) { return io::to_wkt(geometry); }

TEST(EmptyParts, EveryOperationTakesThem) {
  const Geometry other{rectangle(0, 0, 2, 1), {{{0, 0}, {0, 5}}}, {}};
  const Geometry area{rectangle(0, 0, 2, 1), {}, {}};
  const Geometry hall{rectangle(-20, -20, 20, 20), {}, {}};
  expect_equal("resolve", [](const Geometry& g) { return text(resolve(g)); });
  for (const Method method : {Method::kReduced, Method::kSigned}) {
    SumSettings options;
    options.method = method;
    expect_equal("sum", [&](const Geometry& g) { return text(minkowski_sum(g, other, options)); });
    expect_equal("sum", [&](const Geometry& g) { return text(minkowski_sum(area, g, options)); });
    expect_equal("sum", [&](const Geometry& g) { return text(minkowski_sum(g, g, options)); });
  }
  for (const FillRule fill : {FillRule::kNonZero, FillRule::kStrict}) {
    SumSettings options;
    options.fill = fill;
    expect_equal("sum", [&](const Geometry& g) { return text(minkowski_sum(g, other, options)); });
  }
  expect_equal("tight", [&](const Geometry& g) {
    const DetailedSum found = detailed_sum(g, area, {.tight = true});
    return text(found.sum) + text(found.tight);
  });
  expect_equal("dilate", [&](const Geometry& g) { return text(dilate(g, area)); });
  expect_equal("erode", [&](const Geometry& g) { return text(erode(hall, g)); });
  expect_equal("erode", [&](const Geometry& g) { return text(erode(g, area)); });
  expect_equal("open", [&](const Geometry& g) { return text(open(hall, g)); });
  expect_equal("close", [&](const Geometry& g) { return text(close(g, area)); });
  expect_equal("no_fit", [&](const Geometry& g) { return text(no_fit_polygon(area, g)); });
  expect_equal("inner_fit", [&](const Geometry& g) { return text(inner_fit_polygon(g, area)); });
  expect_equal("depth", [&](const Geometry& g) {
    const auto found = penetration_depth(area, g);
    return found ? found->squared.to_string() : "none";
  });
  expect_equal("impact", [&](const Geometry& g) {
    const auto found = time_of_impact(g, area, {1, 0});
    return found ? found->to_string() : "none";
  });
  for (const Join join : {Join::kRound, Join::kMiter, Join::kBevel, Join::kSquare}) {
    for (const Cap cap : {Cap::kRound, Cap::kButt, Cap::kSquare}) {
      for (const int distance : {-1, 0, 1}) {
        OffsetOptions options;
        options.join = join;
        options.cap = cap;
        options.tolerance = Rational(1, 10);
        expect_equal("offset", [&](const Geometry& g) {
          return text(offset(g, Rational(distance), options));
        });
      }
    }
  }
  expect_equal("cspace", [&](const Geometry& g) {
    return text(ConfigurationSpace(area, g).slice(nearest_turn(30), true).obstacles);
  });
  expect_equal("check", [&](const Geometry& g) {
    return std::to_string(check_sum(minkowski_sum(g, area), g, area).ok());
  });
  expect_equal("unite", [&](const Geometry& g) {
    const Geometry both[] = {resolve(g), other};
    return text(unite(both));
  });
  expect_equal("round", [&](const Geometry& g) { return text(round(resolve(g))); });
  expect_equal("transform", [&](const Geometry& g) {
    return text(resolve(transform(g, Affine::quarter_turns(1))));
  });
  expect_equal("locate", [&](const Geometry& g) {
    return std::to_string(static_cast<int>(PointLocator(g).locate({2, 7})));
  });
}

TEST(EmptyParts, RingsWithoutVerticesHaveNoPlaces) {
  Region region;
  region.begin_polygon();
  region.begin_ring();
  EXPECT_EQ(validate(region).size(), 1U);
  region.begin_ring();
  for (const Point& p : {Point{0, 0}, Point{1, 0}, Point{0, 1}}) region.add_vertex(p.x, p.y);
  EXPECT_EQ(PointLocator(region).locate({5, 5}), Location::kOutside);
}

TEST(EmptyParts, APolygonWithoutRingsIsNothingByEachMethod) {
  Region region = rectangle(0, 0, 4, 4);
  region.begin_polygon();
  ASSERT_TRUE(validate(region).empty());
  for (const Method method : {Method::kReduced, Method::kSigned}) {
    SumSettings settings;
    settings.method = method;
    EXPECT_EQ(minkowski_sum(region, rectangle(0, 0, 1, 1), settings), rectangle(0, 0, 5, 5));
  }
}

TEST(EmptyParts, APolylineWithoutVerticesHasAPicture) {
  EXPECT_NE(io::to_text(Geometry({}, {{}}, {}), io::Format::kSvg).find("</svg>"),
            std::string::npos);
}

/// Calls an operation with two sets, to be read by the fill rule of the options.
using Operation =
    std::function<std::string(const Geometry& a, const Geometry& b, const Options& options)>;

std::vector<Operation> operations() {
  const auto of_sets = [](auto function) -> Operation {
    return [function](const Geometry& a, const Geometry& b, const Options& options) {
      return text(function(a, b, options));
    };
  };
  const Point reference{1, 2};
  return {
      of_sets(
          [](const auto& a, const auto& b, const Options& o) { return minkowski_sum(a, b, o); }),
      of_sets([](const auto& a, const auto& b, const Options& o) { return dilate(a, b, o); }),
      of_sets([](const auto& a, const auto& b, const Options& o) { return erode(a, b, o); }),
      of_sets([](const auto& a, const auto& b, const Options& o) { return open(a, b, o); }),
      of_sets([](const auto& a, const auto& b, const Options& o) { return close(a, b, o); }),
      of_sets([](const auto& a, const auto&, const Options& o) {
        OffsetOptions shape;
        shape.tolerance = Rational(1, 10);
        return offset(a, 1, shape, o);
      }),
      of_sets([=](const auto& a, const auto& b, const Options& o) {
        return no_fit_polygon(a, b, reference, o);
      }),
      of_sets([=](const auto& a, const auto& b, const Options& o) {
        return inner_fit_polygon(a, b, reference, o);
      }),
      of_sets([](const auto& a, const auto& b, const Options& o) {
        const ConfigurationSpace space(a, b, {}, o);
        return space.slice(nearest_turn(30), true).free;
      }),
      of_sets([=](const auto& a, const auto& b, const Options& o) {
        const ConfigurationSpace space(a, Geometry{}, {.workspace = b}, o);
        return space.slice(nearest_turn(0), true).obstacles;
      }),
      [](const auto& a, const auto& b, const Options& o) {
        const auto found = penetration_depth(a, b, o);
        return found ? found->squared.to_string() + (found->overlapping ? " in" : " out") : "";
      },
      [](const auto& a, const auto& b, const Options& o) {
        const auto found = time_of_impact(a, b, {1, 3}, o);
        return found ? found->to_string() : "";
      },
      [=](const auto& a, const auto& b, const Options& o) {
        const NoFitPolygon polygon(a, b, reference, o);
        std::string contacts;
        for (int x = -3; x < 9; ++x) {
          contacts += std::to_string(static_cast<int>(polygon.contact({x, 2})));
        }
        return contacts;
      },
      [](const auto& a, const auto& b, const Options& o) {
        return std::to_string(check_sum(Geometry{}, a, b, {}, o).ok());
      },
      [](const auto& a, const auto& b, const Options& o) {
        ReachOptions few;
        few.angles = 2;
        const Configuration from{{9, 9}, {}};
        const Configuration to{{-1, 3}, {}};
        return std::to_string(reach(a, b, from, to, few, o).reachable);
      },
  };
}

TEST(Reading, RegionsBesideObstaclesMayCrossThemselves) {
  Options negative;  // is for the obstacles
  negative.fill = FillRule::kNegative;
  const Geometry obstacle(test::make_polygon({{2, 2}, {2, 3}, {3, 3}, {3, 2}}));
  const ConfigurationSpace space(rectangle(0, 0, 1, 1), obstacle, {}, {});
  // This ring goes around the obstacle twice.
  const Region twice =
      test::make_polygon({{0, 0}, {6, 0}, {6, 6}, {1, 6}, {1, 1}, {5, 1}, {5, 5}, {0, 5}});
  EXPECT_TRUE(space.overlaps_obstacle(twice));
  EXPECT_FALSE(space.overlaps_obstacle(rectangle(0, 0, 2, 2)));
  const ConfigurationSpace same(test::make_polygon({{0, 0}, {0, 1}, {1, 1}, {1, 0}}), obstacle, {},
                                negative);
  EXPECT_TRUE(same.overlaps_obstacle(twice));
}

TEST(Reading, EveryOperationReadsByTheFillRule) {
  test::Random random(20);
  for (const FillRule rule : {FillRule::kAutomatic, FillRule::kEvenOdd, FillRule::kNonZero,
                              FillRule::kPositive, FillRule::kNegative}) {
    for (const bool tight : {false, true}) {
      for (int i = 0; i < 3; ++i) {
        const Geometry a = test::random_mess(random);
        const Geometry b = test::random_mess(random);
        Options plain;
        plain.tight = tight;
        Options reading = plain;
        reading.fill = rule;
        const Geometry read_a = resolve(a, reading);
        const Geometry read_b = resolve(b, reading);
        const std::vector<Operation> all = operations();
        for (std::size_t k = 0; k < all.size(); ++k) {
          const auto run = [&](const auto& p, const auto& q, const Options& options) {
            try {
              return all[k](p, q, options);
            } catch (const Error& error) {
              return std::string(error.what());
            }
          };
          EXPECT_EQ(run(a, b, reading), run(read_a, read_b, plain))
              << "operation " << k << ", " << to_string(rule) << (tight ? ", tight" : "");
        }
      }
    }
  }
}

}  // namespace
}  // namespace minksum
