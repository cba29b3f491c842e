// Tests the writing of doubles for standard libraries that cannot do it.
#include "exact/shortest_double.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

namespace minksum {
namespace {

std::string by_search(double value) {
  char text[kDoubleCharacters];
  return {text, write_shortest_by_search(text, value)};
}

TEST(ShortestDouble, WritesWhatPeopleExpect) {
  EXPECT_EQ(by_search(0), "0");
  EXPECT_EQ(by_search(-0.0), "-0");
  EXPECT_EQ(by_search(-std::numeric_limits<double>::infinity()), "-inf");
  EXPECT_EQ(by_search(0.1), "0.1");
  EXPECT_EQ(by_search(-1234.5), "-1234.5");
  EXPECT_EQ(by_search(1e5), "1e+05");
  EXPECT_EQ(by_search(0.0001), "1e-04");
  EXPECT_EQ(by_search(100), "100");
  EXPECT_EQ(by_search(0x1p-44), "5.684341886080802e-14");  // the nearest 16 digits are too low
  EXPECT_EQ(by_search(0x1p-1074), "5e-324");
  EXPECT_EQ(by_search(123456789012345680000.0), "123456789012345683968");
  EXPECT_EQ(by_search(std::numeric_limits<double>::max()), "1.7976931348623157e+308");
}

#if defined(__cpp_lib_to_chars)
void expect_same(double value) {
  char text[kDoubleCharacters];
  const std::string expected(text, std::to_chars(text, text + sizeof text, value).ptr);
  ASSERT_EQ(by_search(value), expected) << std::hexfloat << value;
}

TEST(ShortestDouble, IsWhatTheStandardLibraryWrites) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 50000; ++i) {
    const double any = std::bit_cast<double>(random());
    if (std::isfinite(any)) expect_same(any);
    expect_same(std::bit_cast<double>(random() >> 12));  // these are denormal
    expect_same(static_cast<double>(random()) / 1000);
    expect_same(static_cast<double>(random() >> (i % 64)) * std::ldexp(1.0, i % 30));
    expect_same(static_cast<double>(random() % 100000) / std::pow(10, i % 12));
  }
  for (int exponent = -1074; exponent < 1024; ++exponent) {
    const double power = std::ldexp(1.0, exponent);
    for (const double value : {power, std::nextafter(power, 0), std::nextafter(power, 1e308)}) {
      expect_same(value);
    }
  }
}
#endif

}  // namespace
}  // namespace minksum
