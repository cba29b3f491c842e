// Tests that the version in the header is that of the package.
#include "minksum/version.hpp"

#include <gtest/gtest.h>

#include <string>

namespace {

TEST(Version, IsTheSameEverywhere) {
  EXPECT_STREQ(MINKSUM_VERSION, MINKSUM_CMAKE_VERSION);
  const std::string from_parts = std::to_string(MINKSUM_VERSION_MAJOR) + "." +
                                 std::to_string(MINKSUM_VERSION_MINOR) + "." +
                                 std::to_string(MINKSUM_VERSION_PATCH);
  EXPECT_EQ(from_parts, MINKSUM_VERSION);
}

}  // namespace
