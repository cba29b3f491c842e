// Tests exact numbers: reading, rounding, and exact arithmetic.
#include "minksum/rational.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <string>
#include <utility>

#include "minksum/error.hpp"
#include "support/random.hpp"

namespace minksum {
namespace {

Rational parsed(const std::string& text) {
  const std::optional<Rational> value = Rational::parse(text);
  EXPECT_TRUE(value.has_value()) << text;
  return value.value_or(Rational());
}

// Returns any finite double with equal chance, denormals included.
double any_double(test::Random& random) {
  for (;;) {
    const auto value = std::bit_cast<double>(random.next());
    if (std::isfinite(value)) return value;
  }
}

TEST(Rational, IsInLowestTerms) {
  EXPECT_EQ(Rational(6, -4).to_string(), "-3/2");
  EXPECT_EQ(Rational(0, 7).to_string(), "0");
  EXPECT_EQ(Rational(-8, 4).to_string(), "-2");
  EXPECT_EQ(Rational(Decimal{150, -2}).to_string(), "3/2");
  EXPECT_EQ(Rational(0.1).to_string(), "3602879701896397/36028797018963968");
  constexpr std::int64_t kLowest = std::numeric_limits<std::int64_t>::min();
  EXPECT_EQ(Rational(kLowest, kLowest), Rational(1));
  EXPECT_EQ(Rational(1, kLowest).to_string(), "-1/9223372036854775808");
}

TEST(Rational, ReadsNumbersExactly) {
  EXPECT_EQ(parsed("0.1"), Rational(1, 10));
  EXPECT_EQ(parsed("-12.50"), Rational(-25, 2));
  EXPECT_EQ(parsed("+7"), Rational(7));
  EXPECT_EQ(parsed("1e3"), Rational(1000));
  EXPECT_EQ(parsed("1.5E-2"), Rational(3, 200));
  EXPECT_EQ(parsed("6/8"), Rational(3, 4));
  EXPECT_EQ(parsed("-6/8"), Rational(-3, 4));
  EXPECT_EQ(parsed("010"), Rational(10)) << "a leading zero is no mark of octal";
  EXPECT_EQ(parsed("08/09"), Rational(8, 9));
  EXPECT_EQ(parsed("-0.000"), Rational(0));
  EXPECT_EQ(parsed("123456789012345678901234567890").to_string(), "123456789012345678901234567890");
}

TEST(Rational, RefusesWhatIsNoNumber) {
  for (const char* text : {"",    "+",     "-",   ".",   ".5",  "5.",    "1.e2",  "e5",   "1e",
                           "1e+", "1.2.3", "1/",  "/2",  "1/0", "1/-2",  "1.5/2", "0x10", " 1",
                           "1 ",  "nan",   "inf", "1,5", "--1", "1e5.5", "1/2/3", "1/00"}) {
    EXPECT_FALSE(Rational::parse(text).has_value()) << '"' << text << '"';
  }
}

TEST(Rational, KeepsItsLimits) {
  const std::string digits(4096, '9');
  EXPECT_TRUE(Rational::parse(digits).has_value());
  EXPECT_FALSE(Rational::parse(digits + '9').has_value());
  EXPECT_TRUE(Rational::parse("1/" + digits).has_value());
  EXPECT_FALSE(Rational::parse("1/" + digits + '9').has_value());
  EXPECT_FALSE(Rational::parse("1." + digits).has_value());
  EXPECT_TRUE(Rational::parse("1e4096").has_value());
  EXPECT_TRUE(Rational::parse("1e-4096").has_value());
  EXPECT_FALSE(Rational::parse("1e4097").has_value());
  EXPECT_FALSE(Rational::parse("1e-99999999999999999999").has_value());
  EXPECT_TRUE(Rational::parse("1e" + std::string(50, '0') + "7").has_value());
}

TEST(Rational, ThrowsForWhatHasNoValue) {
  EXPECT_THROW(Rational(1, 0), Error);
  EXPECT_THROW(static_cast<void>(Rational(std::nan(""))), Error);
  EXPECT_THROW(static_cast<void>(Rational(std::numeric_limits<double>::infinity())), Error);
  EXPECT_THROW(Rational(1) / Rational(), Error);
  EXPECT_THROW(static_cast<void>(Rational(1).to_decimal(-1)), Error);
  EXPECT_THROW(Rational(Decimal{1, 2'000'000'000}), Error);
  EXPECT_EQ(Rational(Decimal{0, 2'000'000'000}), Rational(0));
}

TEST(Rational, EveryDoubleComesBack) {
  test::Random random(1);
  for (int i = 0; i < 20000; ++i) {
    const double value = any_double(random);
    EXPECT_EQ(Rational(value).to_double(), value);
  }
  for (const double value : {5e-324, -5e-324, 2.2250738585072014e-308, 1.7976931348623157e308}) {
    EXPECT_EQ(Rational(value).to_double(), value);
  }
}

TEST(Rational, DecimalsRoundToTheNearestDouble) {
  test::Random random(2);
  for (int i = 0; i < 20000; ++i) {
    const std::string text = std::to_string(static_cast<std::int64_t>(random.next())) + 'e' +
                             std::to_string(random.between(-360, 320));
    EXPECT_EQ(parsed(text).to_double(), std::strtod(text.c_str(), nullptr)) << text;
  }
}

TEST(Rational, TiesGoToTheEvenDouble) {
  const auto two_to = [](int exponent) { return Rational(std::ldexp(1.0, exponent)); };
  EXPECT_EQ((two_to(53) + Rational(1)).to_double(), std::ldexp(1.0, 53));
  EXPECT_EQ((two_to(53) + Rational(3)).to_double(), std::ldexp(1.0, 53) + 4);
  EXPECT_EQ((two_to(53) + Rational(1) + two_to(-900)).to_double(), std::ldexp(1.0, 53) + 2);
  const Rational denormal(5e-324);
  EXPECT_EQ((denormal / Rational(2)).to_double(), 0);
  EXPECT_EQ((denormal / Rational(2) + two_to(-1074) * two_to(-1000)).to_double(), 5e-324);
  EXPECT_EQ((denormal * Rational(3, 2)).to_double(), 1e-323);
  const Rational largest(std::numeric_limits<double>::max());
  EXPECT_EQ((largest + two_to(970)).to_double(), std::numeric_limits<double>::infinity());
  EXPECT_EQ((largest + two_to(970) - Rational(1)).to_double(), std::numeric_limits<double>::max());
  EXPECT_EQ((-largest * largest).to_double(), -std::numeric_limits<double>::infinity());
  EXPECT_FALSE(std::signbit((-denormal * denormal).to_double()));
}

TEST(Rational, WritesDecimals) {
  EXPECT_EQ(Rational(1, 3).to_decimal(4), "0.3333");
  EXPECT_EQ(Rational(-2, 3).to_decimal(2), "-0.67");
  EXPECT_EQ(Rational(1, 8).to_decimal(2), "0.12");
  EXPECT_EQ(Rational(3, 8).to_decimal(2), "0.38");
  EXPECT_EQ(Rational(5, 2).to_decimal(0), "2");
  EXPECT_EQ(Rational(7, 2).to_decimal(0), "4");
  EXPECT_EQ(Rational(-1, 1000).to_decimal(2), "0.00");
  EXPECT_EQ(Rational(999, 1000).to_decimal(2), "1.00");
  EXPECT_EQ(Rational(12).to_decimal(3), "12.000");
}

TEST(Rational, ObeysTheLawsOfAField) {
  test::Random random(3);
  const auto any = [&random] {
    const int digits = random.below(60);
    const auto limbs = std::array{random.next() >> digits, random.next() >> random.below(64)};
    const auto below = std::array{(random.next() >> random.below(63)) | 1U, std::uint64_t{1}};
    return Rational::from_limbs(random.one_in(2), limbs.data(), 1U + random.next() % 2,
                                below.data(), random.one_in(2) ? 2 : 1);
  };
  for (int i = 0; i < 500; ++i) {
    const Rational a = any();
    const Rational b = any();
    const Rational c = any();
    EXPECT_EQ(a + b, b + a);
    EXPECT_EQ((a + b) * c, a * c + b * c);
    EXPECT_EQ(a - a, Rational());
    if (b.sign() != 0) {
      EXPECT_EQ(a / b * b, a);
    }
    EXPECT_EQ((a <=> b) < 0, (a - b).sign() < 0);
    EXPECT_EQ((a <=> b) == 0, a == b);
    EXPECT_EQ(parsed(a.to_string()), a);
    EXPECT_EQ(a.numerator() / a.denominator(), a);
  }
}

TEST(Rational, FromLimbsTakesLeadingZerosAndCommonFactors) {
  const std::array<std::uint64_t, 3> numerator = {0, 6, 0};
  const std::array<std::uint64_t, 2> denominator = {0, 4};
  EXPECT_EQ(Rational::from_limbs(true, numerator.data(), 3, denominator.data(), 2),
            Rational(-3, 2));
  EXPECT_EQ(Rational::from_limbs(true, numerator.data(), 0, denominator.data(), 2), Rational(0));
  EXPECT_THROW(Rational::from_limbs(false, numerator.data(), 3, denominator.data(), 1), Error);
}

TEST(Rational, LimbsAreWhatFromLimbsTakes) {
  const auto back = [](const Rational& value) {
    const Rational::Limbs limbs = value.limbs();
    return Rational::from_limbs(limbs.negative, limbs.numerator.data(), limbs.numerator.size(),
                                limbs.denominator.data(), limbs.denominator.size());
  };
  for (const char* text : {"0", "1", "-1", "-7/3", "18446744073709551616", "-1e40", "1e-40"}) {
    EXPECT_EQ(back(parsed(text)), parsed(text)) << text;
  }
  EXPECT_EQ(back(Rational(1) / parsed("-1e50")), Rational(1) / parsed("-1e50"));
  EXPECT_TRUE(Rational(0).limbs().numerator.empty());
  EXPECT_EQ(Rational(-3, 2).limbs().denominator, std::vector<std::uint64_t>{2});
}

TEST(Rational, TellsItsSize) {
  EXPECT_EQ(Rational(0).bits(), 1U);
  EXPECT_EQ(Rational(-8).bits(), 4U);
  EXPECT_EQ(Rational(1, 1024).bits(), 11U);
  EXPECT_TRUE(Rational(4, 2).is_integer());
  EXPECT_FALSE(Rational(1, 2).is_integer());
  std::ostringstream out;
  out << Rational(-1, 2);
  EXPECT_EQ(out.str(), "-1/2");
}

// A number that was moved from is zero.
TEST(Rational, Moves) {
  Rational from(2, 3);
  Rational to = std::move(from);
  EXPECT_EQ(to, Rational(2, 3));
  EXPECT_EQ(from, 0);  // NOLINT(bugprone-use-after-move)
  from = std::move(to);
  EXPECT_EQ(from, Rational(2, 3));
  EXPECT_EQ(to, 0);  // NOLINT(bugprone-use-after-move)
}

}  // namespace
}  // namespace minksum
