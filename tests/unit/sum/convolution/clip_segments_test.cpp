// Tests that what is clipped off segments is inside the sum by the definition of a sum.
#include <gtest/gtest.h>

#include "reference/membership.hpp"
#include "sum/convolution/convolution.hpp"
#include "support/polygon_kinds.hpp"
#include "unit/sum/prepare_operands.hpp"

namespace minksum {
namespace {

using reference::Number;
using test::Random;

struct Clipped {
  Operands operands;
  Convolution convolution;

  Clipped(const Region& p, const Region& q) {
    const SumSettings settings;
    Cancellation never;
    ConvolutionScratch scratch;
    test::prepare_operands(p, q, settings, operands);
    reduced_convolution(operands, settings.limits, never, scratch, convolution);
  }
  /// Returns the exact point of a segment at a share of its length, moved to the right by a share
  /// of that. The operands have integers.
  [[nodiscard]] reference::Pt point(const Segment& s, const Number& at, const Number& right) const {
    const auto& [x, y, dx, dy, next] = operands.sites;
    const Number unit(operands.trace_unit);
    const Number px = Number(x[s.edge] + x[s.vertex]) + at * dx[s.edge] + right * dy[s.edge];
    const Number py = Number(y[s.edge] + y[s.vertex]) + at * dy[s.edge] - right * dx[s.edge];
    return {px * unit + Number(operands.trace_origin.x),
            py * unit + Number(operands.trace_origin.y)};
  }
};

/// Tests what is clipped off at its ends and in its middle. Each point, and one on its right that
/// is next to it, must be in the sum. Returns how many segments have lost a part.
std::size_t expect_inside(const Region& p, const Region& q, const std::string& what) {
  const Clipped c(p, q);
  const SegmentClipper clipper(c.operands);
  const std::size_t step = c.convolution.segments.size() / 300 + 1;
  std::size_t count = 0;
  for (std::size_t i = 0; i < c.convolution.segments.size(); i += step) {
    const Segment& s = c.convolution.segments[i];
    const Clip clip = clipper.clip(s);
    if (clip.is_whole()) continue;
    ++count;
    const double from = clip.is_empty() ? 1 : clip.from;
    const double to = clip.is_empty() ? 0 : clip.to;
    for (const double at : {0.0, from / 2, from, to, (to + 1) / 2, 1.0}) {
      if (from < at && at < to) continue;
      if ((at == 0 && from == 0) || (at == 1 && to == 1)) continue;
      for (const double right : {0.0, 0x1p-40}) {
        EXPECT_TRUE(reference::contains_sum(p, q, c.point(s, Number(at), Number(right))))
            << what << ": edge " << s.edge << ", vertex " << s.vertex << " at " << at;
      }
    }
  }
  return count;
}

TEST(ClipSegments, WhatIsClippedOffIsInside) {
  Random random(1);
  const auto star = [&](int spikes, int size) { return test::spiky_star(random, spikes, size); };
  const Region box = test::make_polygon({{0, 0}, {5000, 100}, {5100, 4000}, {-300, 3700}});
  EXPECT_GT(expect_inside(star(40, 300), box, "small star"), 50U);
  EXPECT_GT(expect_inside(box, star(40, 300), "small star, second"), 50U);
  EXPECT_GT(expect_inside(star(24, 1000), star(30, 400), "stars"), 50U);
  EXPECT_GT(expect_inside(test::comb(12, 3, 100), test::scaled(test::comb(9, 4, 90), Rational(7)),
                          "combs"),
            10U);
  EXPECT_GT(expect_inside(test::random_two_opt(random, 60, 300),
                          test::random_two_opt(random, 30, 3000), "polygons"),
            50U);
  EXPECT_GT(expect_inside(test::spiral(9), test::scaled(test::spiral(5), Rational(9)), "spirals"),
            10U);
}

TEST(ClipSegments, ConvexOperandsClipNothing) {
  const Region box = test::make_polygon({{0, 0}, {40, 3}, {35, 30}, {2, 28}});
  const Region large = test::scaled(box, Rational(100));
  const Clipped c(box, large);
  const SegmentClipper clipper(c.operands);
  for (const Segment& s : c.convolution.segments) EXPECT_TRUE(clipper.clip(s).is_whole());
}

}  // namespace
}  // namespace minksum
