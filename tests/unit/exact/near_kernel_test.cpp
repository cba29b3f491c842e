// Tests the kernel of doubles against exact formulas, on operands of very different sizes.
#include "exact/near_kernel.hpp"

#include <gtest/gtest.h>

#include "exact/kernel_of.hpp"
#include "support/random.hpp"

namespace {

using namespace minksum;
using minksum::test::Random;

/// The formulas over fractions alone.
class Formulas final : public KernelOf<ArbitraryRung> {
 public:
  Formulas(std::vector<Vec<Fraction>> sites, std::span<const SiteId> next) {
    sites_ = std::move(sites);
    connect(next);
  }
  Arithmetic rung() const override { return Arithmetic::kArbitrary; }
  std::uint64_t work() const override { return 1; }
  void coordinates(const NodePoint&, Vec<ExactCoordinate>&) const override {}
  bool integer_coordinates(const SumVertex&, Vec<std::int64_t>&) const override { return false; }
  int exp2() const override { return 0; }
  int exp10() const override { return 0; }
  Vec<double> between(const SumVertex&, const SumVertex&) const override { return {}; }
  void approximate_sites(std::span<double>, std::span<double>, Cancellation&) const override {}
  void approximate_edges(std::span<double>, std::span<double>, Cancellation&) const override {}
  using KernelOf::sites_;
};

constexpr SiteId kSites = 5;  // of each operand

Fraction number(Random& random, int exponent) {
  Fraction value(BigInteger(random.between(-9, 9)), BigInteger(random.between(1, 7)));
  // Doubles do not hold the last digit.
  if (random.one_in(2)) value = value + Fraction(1, BigInteger(1) << 60);
  const Fraction power(BigInteger(1) << std::abs(exponent));
  return exponent < 0 ? value / power : value * power;
}

struct Tally {
  int decided = 0;
  int undecided = 0;

  template <class Answer>
  bool count(const std::optional<Answer>& answer) {
    ++(answer ? decided : undecided);
    return answer.has_value();
  }
};

struct NearOperands {
  std::vector<Vec<Fraction>> sites;
  std::vector<SiteId> next;
};

/// Two rings, of which one is 2^exponent times as large.
NearOperands random_operands(Random& random, int exponent) {
  NearOperands o;
  for (SiteId i = 0; i < 2 * kSites; ++i) {
    const int own = i < kSites ? exponent : 0;
    o.sites.push_back({number(random, own), number(random, own)});
    o.next.push_back(i % kSites + 1 < kSites ? i + 1 : i + 1 - kSites);
  }
  return o;
}

void compare(Random& random, int exponent, Tally& tally) {
  const auto [sites, next] = random_operands(random, exponent);
  const Formulas exact(sites, next);
  NearKernel near;
  Cancellation never;
  near.load(sites, kSites, {sites[0], sites[kSites]}, 1, never);
  near.connect(next);
  const auto site = [&](bool first) {
    return static_cast<SiteId>(random.below(kSites)) + (first ? 0 : kSites);
  };
  const auto segment = [&] {
    const bool of_first = random.one_in(2);
    return Segment{site(of_first), site(!of_first)};
  };
  const auto vertex = [&] { return SumVertex{site(true), site(false)}; };
  const auto crosses = [&](const Segment& s, const Segment& t) {
    return exact.cross(s.edge, t.edge) != kZero;
  };
  const Segment s = segment();
  const Segment t = segment();
  const Segment u = segment();
  const SumVertex v = vertex();
  if (const auto sign = near.orientation(s, v); tally.count(sign)) {
    EXPECT_EQ(*sign, exact.orientation(s, v));
  }
  if (!crosses(s, t) || !crosses(s, u)) return;
  const PointOnSegment at_t{true, t, {}};
  const PointOnSegment at_u{true, u, {}};
  if (const auto sign = near.compare_along(s, at_t, at_u); tally.count(sign)) {
    EXPECT_EQ(*sign, exact.compare_along(s, at_t, at_u));
  }
  if (const auto along = near.parameter(s, at_t); tally.count(along)) {
    const Fraction truth = exact.exact_parameter(s, {true, s, t, {}});
    const auto nearest = to_double(truth);
    EXPECT_LE(std::abs(*along - nearest), std::abs(nearest) * 0x1p-48);
  }
  const NodePoint first{true, s, t, {}};
  const NodePoint second =
      random.one_in(2) ? NodePoint{true, u, s, {}} : NodePoint{false, {}, {}, v};
  if (const auto sign = near.orientation(u, first); tally.count(sign)) {
    EXPECT_EQ(*sign, exact.orientation(u, first));
  }
  const SumVertex w = vertex();
  for (const Axis axis : {Axis::kX, Axis::kY}) {
    if (const auto sign = near.compare(first, second, axis); tally.count(sign)) {
      EXPECT_EQ(*sign, exact.compare(first, second, axis));
    }
    if (const auto sign = near.compare(v, w, axis); tally.count(sign)) {
      EXPECT_EQ(*sign, exact.compare(v, w, axis));
    }
  }
}

TEST(NearKernel, DecidesAsTheExactFormulasDo) {
  for (const int exponent : {0, -3, 40, -60, 700, -1100, 3000}) {
    Tally tally;
    for (std::uint64_t seed = 0; seed < 600; ++seed) {
      Random random(seed);
      compare(random, exponent, tally);
      ASSERT_FALSE(HasFailure()) << "seed " << seed << ", exponent " << exponent;
    }
    // What is undecided is mostly 0, since the numbers are few.
    EXPECT_GT(tally.decided, 3 * tally.undecided) << "exponent " << exponent;
  }
}

TEST(NearKernel, KnowsEqualCoordinates) {
  const Fraction third(BigInteger(1), BigInteger(3));
  const Fraction none(BigInteger(0));
  const auto whole = [](int value) { return Fraction(BigInteger(value)); };
  // Two edges are vertical. Doubles do not hold their x.
  const std::vector<Vec<Fraction>> sites{{none, none},  {third, none},    {third, whole(2)},
                                         {third, none}, {none, whole(1)}, {third, whole(1)}};
  const std::vector<SiteId> next{1, 2, 0, 4, 5, 3};
  NearKernel near;
  Cancellation never;
  near.load(sites, 3, {sites[0], Vec<Fraction>{none, none}}, 1, never);
  near.connect(next);
  EXPECT_EQ(near.orientation(Segment{1, 3}, SumVertex{2, 5}), kZero);
  EXPECT_EQ(near.compare(SumVertex{1, 3}, SumVertex{2, 5}, Axis::kX), kZero);
  EXPECT_EQ(near.compare(SumVertex{1, 3}, SumVertex{2, 5}, Axis::kY), kNegative);
}

// Near the far end of a long segment, positions from its start tell nothing apart.
TEST(NearKernel, MeasuresFromTheNearerEnd) {
  const BigInteger far = BigInteger(1) << 900;
  const auto at = [](BigInteger x, BigInteger y) {
    return Vec<Fraction>{Fraction(std::move(x)), Fraction(std::move(y))};
  };
  const std::vector<Vec<Fraction>> sites{at(0, 0), at(far, 0), at(0, far),  // the large operand
                                         at(0, 0), at(5, -1),  at(3, 4)};
  const std::vector<SiteId> next{1, 2, 0, 4, 5, 3};
  NearKernel near;
  Cancellation never;
  near.load(sites, 3, {sites[0], sites[3]}, 1, never);
  near.connect(next);
  const Segment lowest{0, 3};   // the long edge along the x axis
  const Segment falling{3, 1};  // small edges at its far end
  const Segment rising{4, 1};
  const PointOnSegment meets_falling{true, falling, {}};
  const PointOnSegment meets_rising{true, rising, {}};
  EXPECT_EQ(near.compare_along(lowest, meets_falling, meets_rising), kNegative);
  EXPECT_EQ(near.parameter(lowest, meets_rising), 1.0);
  EXPECT_EQ(near.orientation(lowest, SumVertex{1, 4}), kNegative);
  EXPECT_EQ(near.orientation(lowest, SumVertex{1, 5}), kPositive);
}

}  // namespace
