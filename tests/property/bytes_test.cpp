// Tests that equal sets have equal bytes with every compiler, at every level of optimisation and on
// every machine.
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <string>

#include "minksum/minkowski_sum.hpp"
#include "support/generators.hpp"
#include "support/shapes.hpp"

namespace minksum {
namespace {

/// Returns the hash by FNV-1a.
std::uint64_t digest(std::uint64_t hash, const std::string& text) {
  for (const char c : text) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001b3U;
  }
  return hash;
}

std::string coordinates(const Region& region) {
  std::string text;
  for (std::size_t v = 0; v < region.vertex_count(); ++v) {
    const std::uint64_t x = std::bit_cast<std::uint64_t>(region.x(v));
    const std::uint64_t y = std::bit_cast<std::uint64_t>(region.y(v));
    text += std::to_string(x) + ' ' + std::to_string(y) + ' ';
  }
  return text;
}

// The numbers were found once, by g++ 12 at -O2, and every build of the tests must find the same.
// They may change only with a reason: if the generators or the canonical form change.
TEST(Bytes, SumsAreTheSameEverywhere) {
  test::Random random(2024);
  std::uint64_t exact = 0xcbf29ce484222325U;
  std::uint64_t doubles = 0xcbf29ce484222325U;
  for (int i = 0; i < 1000; ++i) {
    const test::Pair pair = test::random_pair(random);
    // The operand is scaled by a third, so that coordinates are rounded to doubles.
    const Region sum = minkowski_sum(test::scaled(pair.p, Rational(1, 3)), pair.q);
    exact = digest(exact, test::to_text(sum));
    doubles = digest(doubles, coordinates(sum));
  }
  EXPECT_EQ(exact, 15662952700488544771U);
  EXPECT_EQ(doubles, 8133056851705793381U);
}

}  // namespace
}  // namespace minksum
