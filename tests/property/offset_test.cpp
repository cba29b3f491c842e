// Tests offsets with all joins and caps by known results and laws.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "minksum/boolean.hpp"
#include "minksum/measure.hpp"
#include "minksum/resolve.hpp"
#include "minksum/transform.hpp"
#include "property/offsets.hpp"
#include "support/messes.hpp"

namespace minksum {
namespace {

using namespace test;

Geometry mapped(const Geometry& a, const Affine& map) { return resolve(transform(a, map)); }

TEST(Offset, RectanglesMoveExactly) {
  const Rational d = *Rational::parse("1.2345678901");
  for (const Rational& by : {d, -d, Rational(1, 3), Rational(-1, 3)}) {
    const Geometry square = of_area(rectangle(0, 0, 8, 5));
    const Region expected =
        Region(Polygon{{{-by, -by}, {by + 8, -by}, {by + 8, by + 5}, {-by, by + 5}}, {}});
    OffsetOptions options = with(Join::kMiter);
    options.tolerance = Rational(1, 10);
    EXPECT_EQ(offset(square, by, options), of_area(expected));
    if (by.sign() < 0) {  // without reflex vertices there are no corners
      for (const Join join : kJoins) EXPECT_EQ(offset(square, by, with(join)), of_area(expected));
      for (const RoundingSide side : kRoundingSides) {
        EXPECT_EQ(offset(square, by, round_to(side, Rational(1, 10))), of_area(expected));
      }
    } else {
      for (const Join join : {Join::kRound, Join::kSquare, Join::kBevel}) {
        const Box box = *bounding_box(offset(square, by, with(join)).region);
        EXPECT_EQ(box.min, (Point{-by, -by}));
        EXPECT_EQ(box.max, (Point{by + 8, by + 5}));
      }
    }
  }
  const Region bevelled =
      Region(Polygon{{{-1, 0}, {0, -1}, {8, -1}, {9, 0}, {9, 5}, {8, 6}, {0, 6}, {-1, 5}}, {}});
  EXPECT_EQ(offset(of_area(rectangle(0, 0, 8, 5)), 1, with(Join::kBevel)), of_area(bevelled));
}

TEST(Offset, HolesAndReflexCorners) {
  const Geometry frame = of_area(
      make_polygon({{0, 0}, {20, 0}, {20, 20}, {0, 20}}, {{{5, 5}, {5, 15}, {15, 15}, {15, 5}}}));
  const auto framed = [](int a, int b) {
    return of_area(
        make_polygon({{-a, -a}, {20 + a, -a}, {20 + a, 20 + a}, {-a, 20 + a}},
                     {{{5 + b, 5 + b}, {5 + b, 15 - b}, {15 - b, 15 - b}, {15 - b, 5 + b}}}));
  };
  EXPECT_EQ(offset(frame, 2, with(Join::kMiter)), framed(2, 2));
  EXPECT_EQ(offset(frame, -2, with(Join::kMiter)), framed(-2, -2));
  EXPECT_EQ(offset(frame, 5, with(Join::kMiter)), of_area(rectangle(-5, -5, 25, 25)));
  EXPECT_TRUE(offset(frame, Rational(-5, 2), with(Join::kMiter)).empty());
  // Shrinking bevels the hole's corners, which are reflex.
  const Region shrunk = offset(frame, -2, with(Join::kBevel)).region;
  EXPECT_EQ(of_area(shrunk),
            resolve(of_area(make_polygon(
                {{2, 2}, {18, 2}, {18, 18}, {2, 18}},
                {{{5, 3}, {3, 5}, {3, 15}, {5, 17}, {15, 17}, {17, 15}, {17, 5}, {15, 3}}}))));
}

TEST(Offset, MiterLimitIsExact) {
  // The corner turns by θ with cos θ/2 = 3/5, so its miter reaches 5/3 of the distance.
  const Geometry wedge = of_area(make_polygon({{0, 0}, {100, 0}, {93, 24}}));
  const auto farthest = [&](const Rational& limit) {
    OffsetOptions options = with(Join::kMiter);
    options.miter_limit = limit;
    return bounding_box(offset(wedge, 3, options).region)->max.x;
  };
  const Rational tip = Rational(100) + Rational(3) * Rational(4, 3);  // 3·tan θ/2 farther
  EXPECT_EQ(farthest(Rational(5, 3)), tip);
  EXPECT_EQ(farthest(Rational(7)), tip);
  EXPECT_EQ(farthest(Rational(5, 3) - Rational(1, 1000000000)), Rational(1033, 10));
  EXPECT_EQ(offset(wedge, 3, with(Join::kMiter)).region.vertex_count(), 4U);  // the left one is cut
}

TEST(Offset, CapsOfPolylines) {
  const Geometry line = make_lines({{{0, 0}, {10, 0}}});
  const auto capped = [&](Cap cap, Join join = Join::kBevel) {
    return offset(line, 2, with(join, cap));
  };
  EXPECT_EQ(capped(Cap::kButt), of_area(rectangle(0, -2, 10, 2)));
  EXPECT_EQ(capped(Cap::kSquare), of_area(rectangle(-2, -2, 12, 2)));
  const Region round = capped(Cap::kRound).region;
  EXPECT_EQ(bounding_box(round)->min, (Point{-2, -2}));
  EXPECT_NEAR(approximate_area(round), 40 + 4 * std::acos(-1.0), 0.05);
  EXPECT_TRUE(offset(line, -1, with(Join::kMiter)).empty());

  const Geometry bend = make_lines({{{0, 0}, {10, 0}, {10, 10}}});
  EXPECT_EQ(offset(bend, 2, with(Join::kMiter, Cap::kButt)),
            of_area(make_polygon({{0, -2}, {12, -2}, {12, 10}, {8, 10}, {8, 2}, {0, 2}})));
  EXPECT_EQ(offset(bend, 2, with(Join::kBevel, Cap::kButt)),
            of_area(make_polygon({{0, -2}, {10, -2}, {12, 0}, {12, 10}, {8, 10}, {8, 2}, {0, 2}})));
  const Geometry closed = make_lines({{{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0}}});
  for (const Cap cap : kCaps) {
    EXPECT_EQ(offset(closed, 2, with(Join::kMiter, cap)),
              of_area(make_polygon({{-2, -2}, {12, -2}, {12, 12}, {-2, 12}},
                                   {{{2, 2}, {2, 8}, {8, 8}, {8, 2}}})));
  }
  // At a branch, only the ends of the given paths count as ends.
  const Geometry cross = make_lines({{{0, 0}, {10, 0}}, {{5, -5}, {5, 5}}});
  EXPECT_EQ(offset(cross, 1, with(Join::kMiter, Cap::kButt)).region.vertex_count(), 12U);
}

TEST(Offset, Points) {
  const Geometry point = make_lines({}, {{3, 4}});
  EXPECT_EQ(offset(point, 2, with(Join::kMiter, Cap::kSquare)), of_area(rectangle(1, 2, 5, 6)));
  EXPECT_TRUE(offset(point, 2, with(Join::kMiter, Cap::kButt)).empty());
  const Geometry round = of_area(transform(disc(2, Rational(2, 1000)), Affine::translation(3, 4)));
  EXPECT_EQ(offset(point, 2), round);
  EXPECT_EQ(offset(point, 2, with(Join::kBevel)), round);
  EXPECT_TRUE(offset(point, -2).empty());
  // A polyline whose vertices are equal is a point.
  EXPECT_EQ(offset(make_lines({{{3, 4}, {3, 4}}}), 2, with(Join::kBevel)), round);
}

/// The joins are ordered: each contains the one before it.
TEST(Offset, JoinsAreNested) {
  Random random(seed_from_environment(3));
  for (int i = 0; i < count_from_environment(kShapes); ++i) {
    const Geometry a = i % 3 == 0 ? random_thin(random, 20) : of_area(random_region(random));
    const int sign = i % 2 == 0 || a.has_thin_parts() ? 1 : -1;
    const Rational d(random.between(1, 20) * sign, 8);
    const Rational t = Rational(random.between(1, 9), 1000) * (sign > 0 ? d : -d);
    const auto made = [&](Join join, const Rational& by) {
      OffsetOptions options = with(join);
      options.tolerance = t;
      options.miter_limit = 50;
      return offset(a, by, options).region;
    };
    // Shrunk sets are nested the other way; `more` is larger by 3 t in size, whatever the sign.
    const Rational more = d + Rational(sign * 3) * t;
    for (std::size_t k = 0; k + 1 < kJoins.size(); ++k) {
      constexpr std::array order{Join::kBevel, Join::kRound, Join::kSquare, Join::kMiter};
      const Region smaller = made(order[k], d), larger = made(order[k + 1], more);
      EXPECT_TRUE(sign > 0 ? contains(larger, smaller) : contains(smaller, larger))
          << to_string(order[k]) << ' ' << message(a, d);
    }
  }
}

/// A result depends on the set alone, moves with it, and turns with it.
TEST(Offset, MovesAndTurnsWithTheSet) {
  Random random(seed_from_environment(4));
  const Affine move = Affine::translation(Rational(1, 7), Rational(-1000001, 10));
  const Affine turn = Affine::quarter_turns(1);
  for (int i = 0; i < count_from_environment(kShapes); ++i) {
    const bool thin = i % 3 == 0;
    const Geometry a = thin ? random_thin(random, 20) : of_area(random_region(random));
    const Rational d(random.between(1, 20) * (i % 2 == 0 || thin ? 1 : -1), 8);
    for (const Join join : kJoins) {
      const OffsetOptions options = with(join, kCaps[static_cast<std::size_t>(i / 3 % 3)]);
      const Geometry result = offset(a, d, options);
      EXPECT_EQ(resolve(result), result);
      EXPECT_EQ(offset(transform(a, move), d, options), mapped(result, move)) << message(a, d);
      EXPECT_EQ(offset(transform(a, turn), d, options), mapped(result, turn)) << message(a, d);
      if (!thin) {
        EXPECT_EQ(offset(resolve(a), d, options), result) << message(a, d);
        EXPECT_EQ(offset(of_area(scrambled(a.region, random)), d, options), result);
      }
    }
  }
}

/// Edges far shorter than the tolerance, as in simplified outlines, change a result by no more than
/// the tolerance.
TEST(Offset, TinyEdges) {
  Random random(seed_from_environment(5));
  for (int i = 0; i < count_from_environment(kShapes); ++i) {
    const Region rough = random_polygon(random);
    // Each vertex is repeated at a slightly different point.
    Ring ring;
    for (const Point& p : rough.polygon(0).outer) {
      for (int k = 0; k < 3; ++k) {
        ring.push_back({p.x + Rational(random.between(-50, 50), 100000000),
                        p.y + Rational(random.between(-50, 50), 100000000)});
      }
    }
    const Geometry a =
        of_area(resolve(of_area(Region(Polygon{ring, rough.polygon(0).holes}))).region);
    const Rational d(random.between(1, 20) * (i % 2 == 0 ? 1 : -1), 8);
    const Rational t = Rational(1, 100) * (i % 2 == 0 ? d : -d);
    for (const Join join : {Join::kMiter, Join::kSquare, Join::kBevel}) {
      OffsetOptions options = with(join);
      options.tolerance = t;
      options.miter_limit = 3;
      const Region result = offset(a, d, options).region;
      // Bevels are sure to hold only strips beside edges, so the set itself is tested.
      const Rational less = i % 2 == 0 ? d - t - t : d + t + t;
      const Rational most = Rational(3) * d + (i % 2 == 0 ? t : -t);
      const Region large = offset(a, most, round_to(RoundingSide::kNearest, t)).region;
      const Region small =
          offset(a, join == Join::kBevel ? Rational(0) : less, round_to(RoundingSide::kNearest, t))
              .region;
      if (i % 2 == 0) {
        EXPECT_TRUE(contains(large, result)) << message(a, d);
        EXPECT_TRUE(contains(result, small)) << to_string(join) << ' ' << message(a, d);
      } else {
        EXPECT_TRUE(contains(result, large)) << message(a, d);
        EXPECT_TRUE(contains(small, result)) << to_string(join) << ' ' << message(a, d);
      }
    }
  }
}

TEST(Offset, ReadsByFillRule) {
  const Geometry twice = of_area(make_region(
      {{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}}, {{{5, 5}, {15, 5}, {15, 15}, {5, 15}}}}));
  std::vector<Geometry> shapes{twice,
                               of_area(make_region({{{{0, 0}, {0, 10}, {10, 10}, {10, 0}}},
                                                    {{{5, 5}, {5, 15}, {15, 15}, {15, 5}}}}))};
  Random random(3);
  // Joins other than round ones take polylines as they are given.
  for (int i = 0; i < kShapes; ++i) shapes.push_back(of_area(random_mess(random).region));
  for (const FillRule fill :
       {FillRule::kEvenOdd, FillRule::kNonZero, FillRule::kPositive, FillRule::kNegative}) {
    for (const Geometry& shape : shapes) {
      const Geometry read = resolve(shape, {.fill = fill});
      for (const Join join : kJoins) {
        for (const int d : {1, 9, -1, 0}) {
          EXPECT_EQ(offset(shape, d, with(join), {.fill = fill}), offset(read, d, with(join)))
              << to_string(fill) << ' ' << to_string(join) << ' ' << message(shape, d);
        }
      }
    }
  }
  EXPECT_THROW((void)offset(twice, 1, with(Join::kMiter), {.fill = FillRule::kStrict}), Error);
  // A spike is a polyline.
  const Geometry spike =
      of_area(make_polygon({{0, 0}, {10, 0}, {20, 0}, {10, 0}, {10, 10}, {0, 10}}));
  EXPECT_EQ(bounding_box(offset(spike, 1, with(Join::kMiter, Cap::kButt)).region)->max.x,
            Rational(20));
}

TEST(Offset, NothingAndZero) {
  EXPECT_TRUE(offset({}, 1).empty());
  EXPECT_TRUE(offset({}, -1).empty());
  EXPECT_TRUE(offset({}, 1, with(Join::kMiter)).empty());
  const Geometry line = make_lines({{{0, 0}, {1, 1}}});
  EXPECT_EQ(offset(line, 0), line);
  EXPECT_TRUE(offset(of_area(rectangle(0, 0, 2, 9)), -1).empty());
  EXPECT_TRUE(offset(of_area(rectangle(0, 0, 2, 9)), -100, with(Join::kBevel)).empty());
}

TEST(Offset, Refusals) {
  const Geometry square = of_area(rectangle(0, 0, 2, 2));
  const auto code_of = [&](const OffsetOptions& shape, const Options& options = {}) {
    try {
      (void)offset(square, 1, shape, options);
    } catch (const Error& error) {
      return error.code();
    }
    return ErrorCode::kInternal;
  };
  EXPECT_EQ(code_of(round_to(RoundingSide::kNearest, 0)), ErrorCode::kBadInput);
  EXPECT_EQ(code_of(round_to(RoundingSide::kNearest, -1)), ErrorCode::kBadInput);
  EXPECT_EQ(code_of(round_to(RoundingSide::kNearest, *Rational::parse("1e-20"))),
            ErrorCode::kLimitExceeded);
  OffsetOptions options = with(Join::kMiter);
  options.tolerance = *Rational::parse("1e-20");
  EXPECT_EQ(code_of(options), ErrorCode::kLimitExceeded);
  options = with(Join::kMiter);
  options.miter_limit = Rational(99, 100);
  EXPECT_EQ(code_of(options), ErrorCode::kBadInput);
  options = with(Join::kBevel);
  options.side = RoundingSide::kOutside;
  EXPECT_EQ(code_of(options), ErrorCode::kBadInput);
  options = with(Join::kRound, Cap::kButt);
  options.side = RoundingSide::kInside;
  EXPECT_EQ(code_of(options), ErrorCode::kBadInput);
  options = with(Join::kSquare);
  EXPECT_EQ(code_of(options, {.limits = {.max_segments = 3}}), ErrorCode::kLimitExceeded);
}

}  // namespace
}  // namespace minksum
