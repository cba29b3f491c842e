// Tests fixed-width integers against Boost's, the laws of the predicates, and that rungs agree.
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "exact/kernel_of.hpp"
#include "minksum/minkowski_sum.hpp"
#include "minksum/testing.hpp"
#include "minksum/transform.hpp"
#include "sum/operands/operands.hpp"
#include "support/shapes.hpp"
#include "unit/sum/prepare_operands.hpp"

namespace {

using namespace minksum;
using namespace minksum::test;

TEST(WideInt, AgreesWithBigIntegers) {
  std::mt19937_64 random(7);
  const auto number = [&] {
    // Numbers have all lengths, and runs of ones and zeros, where carries go far.
    Int128 value = static_cast<Int128>(static_cast<std::int64_t>(random())) << 64;
    value += static_cast<Int128>(random());
    value >>= static_cast<int>(random() % 127);
    return random() % 4 == 0 ? static_cast<Int128>((Int128{1} << (random() % 126)) - 1) : value;
  };
  for (int i = 0; i < 20000; ++i) {
    const WideInt<5> a(number());
    const WideInt<5> b(number());
    const WideInt<5> c(number());
    const BigInteger x(a);
    const BigInteger y(b);
    const BigInteger z(c);
    ASSERT_TRUE(BigInteger(a * b - c) == x * y - z);
    ASSERT_TRUE(BigInteger(a + b) == x + y);
    ASSERT_EQ(a < b, x < y);
    ASSERT_EQ(a == b, x == y);
    ASSERT_EQ(sign_of(a * b), sign_of(x * y));
    const double approximate = to_double(a * b);
    const double expected = to_double(x * y);
    ASSERT_LE(std::abs(approximate - expected), std::abs(expected) * 0x1p-50);
  }
}

TEST(WideInt, IsRoundedNearlyAndInOrder) {
  Random random(17);
  const auto size = [](Int128 value) { return value < 0 ? -value : value; };
  for (int k = 0; k < 200'000; ++k) {
    // Next to powers of two, and to halves of limbs, roundings change.
    const int bits = random.between(0, 125);
    Int128 value = Int128{1} << bits;
    if (random.one_in(2)) value += static_cast<Int128>(random.next()) >> random.between(0, 63);
    if (random.one_in(2)) value -= Int128{1} << random.between(0, bits);
    if (random.one_in(2)) value = -value;
    const double near = to_near_double(value);
    EXPECT_LE(size(static_cast<Int128>(near) - value), size(value) >> 52) << k;
    const Int128 next = value + 1 + (static_cast<Int128>(random.next()) >> random.between(0, 63));
    EXPECT_LE(near, to_near_double(next)) << k;
  }
}

TEST(WideInt, MultipliesShorterNumbers) {
  std::mt19937_64 random(2604);
  const auto limb = [&] { return static_cast<std::int64_t>(random() << (random() % 64)); };
  for (int i = 0; i < 2000; ++i) {
    const std::int64_t a = limb();
    const Int128 b = static_cast<Int128>(limb()) * limb();
    const WideInt<3> c = WideInt<3>(b) * WideInt<3>(limb());
    ASSERT_EQ((product<WideInt<4>>(a, b)), WideInt<4>(a) * WideInt<4>(b));
    ASSERT_EQ((product<WideInt<6>>(b, c)), WideInt<6>(b) * WideInt<6>(c));
    ASSERT_EQ((product<WideInt<4>>(c, b)), WideInt<4>(c) * WideInt<4>(b)) << "wraps";
    ASSERT_EQ((product<WideInt<2>>(c, c)).limb(0), (c * c).limb(0)) << "wraps";
    ASSERT_EQ((product<Int128>(a, std::int64_t{-3})), Int128{a} * -3);
  }
  constexpr std::int64_t kLeast = std::numeric_limits<std::int64_t>::min();
  EXPECT_EQ((product<WideInt<2>>(kLeast, kLeast)), WideInt<2>(kLeast) * WideInt<2>(kLeast));
  EXPECT_EQ((product<WideInt<2>>(kLeast, std::int64_t{0})), WideInt<2>());
}

/// Returns the same two operands on every rung.
std::vector<std::unique_ptr<Operands>> on_all_rungs(const Region& p, const Region& q) {
  std::vector<std::unique_ptr<Operands>> all;
  for (const Arithmetic rung : {Arithmetic::kNarrow, Arithmetic::kMedium, Arithmetic::kWide,
                                Arithmetic::kArbitrary}) {
    SumSettings options;
    options.arithmetic = rung;
    all.push_back(std::make_unique<Operands>());
    prepare_operands(p, q, options, *all.back());
    EXPECT_EQ(all.back()->kernel->rung(), rung);
  }
  return all;
}

class Rungs : public ::testing::Test {
 protected:
  // All coordinates are integers up to 6, which makes many coincidences.
  Region p_ = make_polygon({{0, 0}, {6, 0}, {6, 6}, {4, 2}, {2, 6}, {1, 2}, {0, 4}});
  Region q_ = make_polygon({{0, 0}, {2, 0}, {4, 2}, {2, 1}, {0, 3}});
};

TEST_F(Rungs, AgreeOnEveryQuestionAndKeepTheLaws) {
  const auto all = on_all_rungs(p_, q_);
  const Operands& first = *all[0];
  const SiteId n = first.size();
  std::vector<Segment> segments;
  for (SiteId e = 0; e < n; ++e) {
    for (SiteId v = 0; v < n; ++v) {
      if (first.operand_of(e) != first.operand_of(v)) segments.push_back({e, v});
    }
  }
  for (const auto& o : all) {
    const ExactKernel& kernel = *o->kernel;
    Cancellation never;
    Predicates ladder(o->sites, kernel, o->bounds, never);
    Predicates distrustful(o->sites, kernel, RoundingBounds::distrustful(o->bounds.magnitude),
                           never);
    for (SiteId e = 0; e < n; ++e) {
      for (SiteId f = 0; f < n; ++f) {
        ASSERT_EQ(kernel.cross(e, f), first.kernel->cross(e, f));
        ASSERT_EQ(kernel.cross(e, f), -kernel.cross(f, e));
        ASSERT_EQ(kernel.dot(e, f), kernel.dot(f, e));
        ASSERT_EQ(ladder.cross(e, f), kernel.cross(e, f));
        ASSERT_EQ(ladder.dot(e, f), kernel.dot(e, f));
        ASSERT_EQ(distrustful.cross(e, f), kernel.cross(e, f));
      }
    }
    for (const Segment& s : segments) {
      for (const Segment& t : segments) {
        const SumVertex v = sum_vertex(t.edge, t.vertex);
        const Sign sign = first.kernel->orientation(s, v);
        ASSERT_EQ(kernel.orientation(s, v), sign);
        ASSERT_EQ(ladder.orientation(s, v), sign);
        ASSERT_EQ(distrustful.orientation(s, v), sign);
      }
    }
  }
}

TEST_F(Rungs, OrientationIsCyclicAndAntisymmetric) {
  for (const auto& o : on_all_rungs(p_, q_)) {
    const ExactKernel& kernel = *o->kernel;
    for (SiteId a = 0; a < o->split; ++a) {
      for (SiteId b = 0; b < o->split; ++b) {
        for (SiteId c = 0; c < o->split; ++c) {
          const Sign sign = kernel.orientation(a, b, c);
          ASSERT_EQ(kernel.orientation(b, c, a), sign);
          ASSERT_EQ(kernel.orientation(b, a, c), -sign);
        }
      }
    }
  }
}

TEST_F(Rungs, OrderCrossingsAlikeAndTotally) {
  const auto all = on_all_rungs(p_, q_);
  const Operands& first = *all[0];
  const Segment s{0, first.split};
  std::vector<PointOnSegment> points;
  for (SiteId e = 1; e < first.split; ++e) {
    for (SiteId v = first.split; v < first.size(); ++v) {
      if (first.kernel->cross(0, e) != kZero) points.push_back({true, {e, v}, {}});
    }
  }
  points.push_back({false, {}, sum_vertex(0, first.split)});
  ASSERT_GT(points.size(), 10U);
  for (const auto& o : all) {
    for (const auto& a : points) {
      for (const auto& b : points) {
        const Sign order = o->kernel->compare_along(s, a, b);
        ASSERT_EQ(order, first.kernel->compare_along(s, a, b));
        ASSERT_EQ(order, -o->kernel->compare_along(s, b, a));
        const double difference = o->kernel->parameter(s, a) - o->kernel->parameter(s, b);
        if (std::abs(difference) > 0x1p-40) { ASSERT_EQ(order, sign_of(difference)); }
      }
    }
  }
}

TEST_F(Rungs, NodesCompareAlikeOnBothAxes) {
  const auto all = on_all_rungs(p_, q_);
  const Operands& first = *all[0];
  std::vector<NodePoint> nodes;
  for (SiteId e = 0; e < first.split; ++e) {
    for (SiteId f = first.split; f < first.size(); ++f) {
      nodes.push_back({false, {}, {}, sum_vertex(e, f)});
      if (first.kernel->cross(e, f) != kZero) {
        nodes.push_back({true, {e, first.split}, {f, 1}, {}});
      }
    }
  }
  for (const auto& o : all) {
    for (const auto& a : nodes) {
      for (const auto& b : nodes) {
        for (const Axis axis : {Axis::kX, Axis::kY}) {
          const Sign order = o->kernel->compare(a, b, axis);
          ASSERT_EQ(order, first.kernel->compare(a, b, axis));
          ASSERT_EQ(order, -o->kernel->compare(b, a, axis));
        }
      }
      // A node lies on the segments that make it.
      if (a.is_crossing) {
        ASSERT_EQ(o->kernel->orientation(a.first, a), kZero);
        ASSERT_EQ(o->kernel->orientation(a.second, a), kZero);
      }
    }
  }
}

TEST_F(Rungs, ProbesAreInGeneralPosition) {
  for (const auto& o : on_all_rungs(p_, q_)) {
    Cancellation never;
    Predicates ladder(o->sites, *o->kernel, o->bounds, never);
    const Fraction half(1, 2);
    const Probe probe{{0, o->split}, 1, 1};
    const Probe same{{0, o->split}, 0, 0, &half};
    const Vec<double> at = ladder.position(probe);
    for (SiteId e = 0; e < o->size(); ++e) {
      for (SiteId v = 0; v < o->size(); ++v) {
        if (o->operand_of(e) == o->operand_of(v)) continue;
        const SumVertex sum = sum_vertex(e, v);
        ASSERT_NE(ladder.orientation(e, sum, probe, at), kZero);
        ASSERT_NE(ladder.compare_y(probe, at, sum), kZero);
        ASSERT_EQ(o->kernel->probe_orientation(e, sum, probe),
                  o->kernel->probe_orientation(e, sum, same));
      }
    }
    // The probe is on the right of its own segment.
    ASSERT_EQ(ladder.orientation(0, sum_vertex(0, o->split), probe, at), kNegative);
  }
}

/// Expects that the filter tells the sign of each component, and whether two edges lead along one
/// axis, and that the ladder agrees with the kernel on the rest.
void expect_exact_zeros(const Region& p, const Region& q, Arithmetic rung) {
  Operands o;
  prepare_operands(p, q, {}, o);
  ASSERT_EQ(o.kernel->rung(), rung);
  Cancellation never;
  Predicates ladder(o.sites, *o.kernel, o.bounds, never);
  for (SiteId e = 0; e < o.size(); ++e) {
    for (const Axis axis : {Axis::kX, Axis::kY}) {
      ASSERT_EQ(ladder.component(e, axis), o.kernel->compare(o.sites.next[e], e, axis));
      for (SiteId f = 0; f < o.size(); ++f) {
        const std::uint64_t before = ladder.counts().by_kernel;
        ASSERT_EQ(ladder.cross(e, f), o.kernel->cross(e, f));
        const bool along_one =
            ladder.component(e, axis) == kZero && ladder.component(f, axis) == kZero;
        if (along_one) { ASSERT_EQ(ladder.counts().by_kernel, before); }
        ASSERT_EQ(ladder.dot(e, f), o.kernel->dot(e, f));
      }
    }
  }
}

TEST_F(Rungs, ZerosOfEdgeVectorsAreExact) {
  const auto scaled = [](const Region& region, const char* by) {
    return transform(region, Affine::scaling(*Rational::parse(by)));
  };
  const Region wide = scaled(p_, "1180591620717411303425");  // 2^70 + 1, which no double holds
  expect_exact_zeros(wide, q_, Arithmetic::kWide);
  expect_exact_zeros(wide, rectangle(0, 0, 3, 4), Arithmetic::kWide);
  // Products of two of the smaller operand's edges underflow. At 10^-330 the edges do themselves.
  for (const char* const by : {"1e-290", "1e-330"}) {
    expect_exact_zeros(scaled(wide, "1e10"), scaled(q_, by), Arithmetic::kArbitrary);
    expect_exact_zeros(wide, scaled(rectangle(0, 0, 3, 4), by), Arithmetic::kArbitrary);
  }
}

TEST(Ladder, TellsWhichRungAnswered) {
  const Region square = rectangle(0, 0, 10, 10);
  SumSettings options;
  options.small = false;
  Statistics statistics = detailed_sum(square, square, options).statistics;
  EXPECT_EQ(statistics.arithmetic, Arithmetic::kNarrow);
  EXPECT_GT(statistics.by_filter, 0U);
  EXPECT_EQ(statistics.by_fixed_width, 0U) << "few bits: doubles are exact";
  EXPECT_EQ(statistics.by_arbitrary, 0U);

  options.filter = false;
  statistics = detailed_sum(square, square, options).statistics;
  EXPECT_GT(statistics.by_fixed_width, 0U);
  EXPECT_EQ(statistics.by_filter, 0U);

  options.arithmetic = Arithmetic::kArbitrary;
  statistics = detailed_sum(square, square, options).statistics;
  EXPECT_EQ(statistics.arithmetic, Arithmetic::kArbitrary);
  EXPECT_EQ(statistics.by_fixed_width, 0U);
  EXPECT_GT(statistics.by_arbitrary, 0U);
}

TEST(Ladder, SlowRungsAreRareOnOrdinaryInput) {
  // The operands are a ragged 200-gon with eight-digit coordinates and a smaller copy.
  std::mt19937_64 random(11);
  const auto ragged = [&](double radius) {
    Region region;
    region.begin_polygon();
    region.begin_ring();
    for (int i = 0; i < 200; ++i) {
      const double r = radius * (0.7 + 0.3 * static_cast<double>(random() % 1000) / 1000);
      const double angle = 2 * 3.141592653589793 * i / 200;
      region.add_vertex(static_cast<std::int64_t>(r * std::cos(angle)),
                        static_cast<std::int64_t>(r * std::sin(angle)));
    }
    return region;
  };
  SumSettings by_stages;
  by_stages.small = false;
  const Statistics statistics = detailed_sum(ragged(4e7), ragged(1e7), by_stages).statistics;
  EXPECT_EQ(statistics.arithmetic, Arithmetic::kNarrow);
  EXPECT_GT(statistics.by_filter, 1000U);
  EXPECT_LT(statistics.by_fixed_width * 100, statistics.by_filter);
}

}  // namespace
