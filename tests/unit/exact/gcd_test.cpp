#include "exact/gcd.hpp"

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace minksum {
namespace {

BigInt random_number(test::Random& random, int bits) {
  BigInt value = 1;
  for (int i = 0; i < bits; i += 16) value = (value << 16) + random.between(0, 0xFFFF);
  return value >> (random.below(16));
}

/// Compares with Boost's, in both orders, for all signs, by both types.
void expect_divisor(const BigInt& a, const BigInt& b) {
  const BigInt expected = boost::multiprecision::gcd(a, b);
  EXPECT_EQ(greatest_common_divisor(a, b), expected) << a << ' ' << b;
  EXPECT_EQ(greatest_common_divisor(b, a), expected) << a << ' ' << b;
  EXPECT_EQ(greatest_common_divisor(BigInt(-a), b), expected) << a << ' ' << b;
  EXPECT_EQ(greatest_common_divisor(BigInteger(a), BigInteger(-b)), BigInteger(expected));
}

TEST(Gcd, OfRandomNumbersWithACommonFactor) {
  test::Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const BigInt common = random_number(random, 16 * random.below(20));
    expect_divisor(common * random_number(random, 16 * random.below(40)),
                   common * random_number(random, 16 * random.below(40)));
  }
}

TEST(Gcd, OfNumbersOfVeryDifferentLength) {
  test::Random random(2);
  for (int i = 0; i < 200; ++i) {
    const BigInt common = random_number(random, 200);
    expect_divisor(common * random_number(random, 3000), common * random_number(random, 64));
  }
}

// Every quotient is 1: the most steps there can be.
TEST(Gcd, OfFibonacciNumbers) {
  BigInt a = 1;
  BigInt b = 1;
  for (int i = 0; i < 3000; ++i) {
    a = std::exchange(b, a + b);
    if (i % 97 == 0) expect_divisor(b, a);
    if (i % 97 == 1) expect_divisor(b * 6, a * 9);
  }
}

TEST(Gcd, OfEqualNumbersPowersAndMultiples) {
  const BigInt large = (BigInt(1) << 4000) - 1;
  expect_divisor(large, large);
  expect_divisor(large, large + 1);
  expect_divisor(large, large * large);
  expect_divisor(BigInt(1) << 4000, BigInt(1) << 3999);
  expect_divisor((BigInt(1) << 4000) + 1, BigInt(1) << 2000);
  expect_divisor((BigInt(1) << 128) - 1, (BigInt(1) << 64) - 1);
  expect_divisor(0, large);
  expect_divisor(1, large);
  expect_divisor(0, 0);
}

}  // namespace
}  // namespace minksum
