// Tests integers and fractions of any size against Boost's.
#include "exact/big_integer.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <utility>

#include "exact/fraction.hpp"
#include "support/random.hpp"

namespace minksum {
namespace {

using Boost = boost::multiprecision::cpp_int;

BigInteger random_number(test::Random& random) {
  BigInteger value = 0;
  for (int i = random.below(30); i > 0; --i) value = (value << 16) + random.between(0, 0xFFFF);
  return random.below(2) == 0 ? -value : value;
}

Boost to_boost(const BigInteger& value) { return Boost(value.to_string()); }
bool same(const BigInteger& value, const Boost& other) { return to_boost(value) == other; }

TEST(BigInteger, AgreesWithBoost) {
  test::Random random(1);
  for (int i = 0; i < 3000; ++i) {
    const BigInteger a = random_number(random);
    const BigInteger b = random_number(random);
    const Boost x = to_boost(a);
    const Boost y = to_boost(b);
    ASSERT_TRUE(same(a + b, x + y));
    ASSERT_TRUE(same(a - b, x - y));
    ASSERT_TRUE(same(a * b, x * y));
    ASSERT_TRUE(same(-a, -x));
    ASSERT_TRUE(same(abs(a), abs(x)));
    ASSERT_TRUE(same(a << 77, x << 77));
    ASSERT_EQ(a == b, x == y);
    ASSERT_EQ(a < b, x < y);
    ASSERT_EQ(a.sign(), x.sign());
    ASSERT_EQ(bit_length(a), x == 0 ? 0 : msb(abs(x)) + 1);
    BigInteger moved = a;
    moved = std::move(moved) + b;
    ASSERT_TRUE(moved == a + b);
    if (y == 0) continue;
    ASSERT_TRUE(same(a / b, x / y));
    ASSERT_TRUE(same(a % b, x % y));
    ASSERT_EQ(trailing_zeros(b), lsb(abs(y)));
    const Division division = divided_to_nearest(a, abs(b));
    ASSERT_TRUE(division.quotient * abs(b) + division.rest == a);
    ASSERT_TRUE(abs(to_boost(division.rest)) * 2 <= abs(y));
  }
}

TEST(BigInteger, RoundsTiesToEven) {
  EXPECT_TRUE(divided_to_nearest(5, 2).quotient == 2);
  EXPECT_TRUE(divided_to_nearest(7, 2).quotient == 4);
  EXPECT_TRUE(divided_to_nearest(-5, 2).quotient == -2);
  EXPECT_TRUE(divided_to_nearest(-7, 2).quotient == -4);
  EXPECT_TRUE(divided_to_nearest(-2, 3).quotient == -1);
}

TEST(BigInteger, ReadsAndWritesDigitsLimbsAndShortNumbers) {
  EXPECT_EQ(BigInteger("000123").to_string(), "123");
  EXPECT_EQ(BigInteger("000").to_string(), "0");
  EXPECT_EQ(power(10, 30).to_string(), "1000000000000000000000000000000");
  std::vector<std::uint64_t> limbs;
  EXPECT_EQ(append_limbs(0, limbs), 0U);
  EXPECT_EQ(append_limbs(-(BigInteger(7) << 128), limbs), 3U);
  EXPECT_EQ(limbs, (std::vector<std::uint64_t>{0, 0, 7}));
  EXPECT_TRUE(BigInteger(limbs, true) == -(BigInteger(7) << 128));
  EXPECT_TRUE(BigInteger(WideInt<3>(-5)) == -5);
  for (const std::int64_t value : {INT64_MIN, INT64_C(-1), INT64_C(0), INT64_MAX}) {
    EXPECT_EQ(static_cast<std::int64_t>(BigInteger(value)), value);
  }
}

TEST(Fraction, KeepsItsDenominatorPositive) {
  const Fraction quotient = Fraction(1, 2) / Fraction(-3, 4);
  EXPECT_TRUE(quotient.denominator() > 0);
  EXPECT_TRUE(quotient.reduced().numerator() == -2);
  EXPECT_TRUE(quotient.reduced().denominator() == 3);
  EXPECT_EQ(to_double(Fraction(1, 3) - Fraction(1, 3)), 0);
  EXPECT_TRUE(Fraction(1, 3) < Fraction(1, 2));
}

}  // namespace
}  // namespace minksum
