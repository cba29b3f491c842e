#include "exact/gcd.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>

#include "support/random.hpp"

namespace minksum {
namespace {

BigInteger random_number(test::Random& random, int bits) {
  BigInteger value = 1;
  for (int i = 0; i < bits; i += 16) value = (value << 16) + random.between(0, 0xFFFF);
  return value >> (random.below(16));
}

boost::multiprecision::cpp_int as_boost(const BigInteger& value) {
  return boost::multiprecision::cpp_int(value.to_string());
}

/// Compares with Boost's, in both orders, for all signs.
void expect_divisor(const BigInteger& a, const BigInteger& b) {
  const auto expected = boost::multiprecision::gcd(as_boost(a), as_boost(b));
  const auto expect = [&](const BigInteger& x, const BigInteger& y) {
    EXPECT_TRUE(as_boost(greatest_common_divisor(x, y)) == expected)
        << a.to_string() << ' ' << b.to_string();
  };
  expect(a, b);
  expect(b, a);
  expect(-a, b);
  expect(a, -b);
}

TEST(Gcd, OfRandomNumbersWithACommonFactor) {
  test::Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const BigInteger common = random_number(random, 16 * random.below(20));
    expect_divisor(common * random_number(random, 16 * random.below(40)),
                   common * random_number(random, 16 * random.below(40)));
  }
}

TEST(Gcd, OfNumbersOfVeryDifferentLength) {
  test::Random random(2);
  for (int i = 0; i < 200; ++i) {
    const BigInteger common = random_number(random, 200);
    expect_divisor(common * random_number(random, 3000), common * random_number(random, 64));
  }
}

// Every quotient is 1: the most steps there can be.
TEST(Gcd, OfFibonacciNumbers) {
  BigInteger a = 1;
  BigInteger b = 1;
  for (int i = 0; i < 3000; ++i) {
    a = std::exchange(b, a + b);
    if (i % 97 == 0) expect_divisor(b, a);
    if (i % 97 == 1) expect_divisor(b * 6, a * 9);
  }
}

TEST(Gcd, OfEqualNumbersPowersAndMultiples) {
  const BigInteger large = (BigInteger(1) << 4000) - 1;
  expect_divisor(large, large);
  expect_divisor(large, large + 1);
  expect_divisor(large, large * large);
  expect_divisor(BigInteger(1) << 4000, BigInteger(1) << 3999);
  expect_divisor((BigInteger(1) << 4000) + 1, BigInteger(1) << 2000);
  expect_divisor((BigInteger(1) << 128) - 1, (BigInteger(1) << 64) - 1);
  expect_divisor((BigInteger(1) << 128) - 1, (BigInteger(1) << 128) - 1);
  expect_divisor(BigInteger(1) << 127, BigInteger(1) << 127);
  expect_divisor(0, large);
  expect_divisor(1, large);
  expect_divisor(0, 0);
}

}  // namespace
}  // namespace minksum
