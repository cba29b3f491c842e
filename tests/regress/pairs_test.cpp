// Tests pairs that once went wrong. Each file of `pairs` has two operands, one a line. Their sum
// must be the same by every method, at every setting, and by brute force, and so must their tight
// places. README.md says what was wrong with each pair.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "minksum/testing.hpp"
#include "minksum/validity.hpp"
#include "property/sums.hpp"
#include "reference/brute_force.hpp"
#include "reference/tight_places.hpp"
#include "reference/validity.hpp"
#include "support/data.hpp"
#include "support/geometries.hpp"
#include "support/settings.hpp"

namespace {

using namespace minksum;
using namespace minksum::test;

/// Beyond this many pairs of vertices, brute force takes too long.
constexpr std::size_t kBruteForceLimit = 2000;

std::vector<std::string> pair_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(MINKSUM_REGRESS_PAIRS)) {
    if (entry.path().extension() == ".wkt") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

Pair read_pair(const std::string& name) {
  std::ifstream in(std::filesystem::path(MINKSUM_REGRESS_PAIRS) / (name + ".wkt"));
  std::string first;
  std::string second;
  if (!std::getline(in, first) || !std::getline(in, second)) {
    throw std::runtime_error("two lines are expected in " + name);
  }
  return {parse_wkt(first), parse_wkt(second), name};
}

Geometry tight_places(const Pair& pair, SumSettings options) {
  options.tight = true;
  return detailed_sum(pair.p, pair.q, options).tight;
}

class RegressPairs : public ::testing::TestWithParam<std::string> {};

TEST_P(RegressPairs, EveryWayGivesTheSame) {
  const Pair pair = read_pair(GetParam());
  ASSERT_EQ(reference::validity_fault(pair.p), "");
  ASSERT_EQ(reference::validity_fault(pair.q), "");
  EXPECT_TRUE(validate(pair.p).empty());
  EXPECT_TRUE(validate(pair.q).empty());
  const bool small = pair.p.vertex_count() * pair.q.vertex_count() <= kBruteForceLimit;
  const Region expected = small ? reference::brute_force_sum(pair.p, pair.q)
                                : sum_by(Method::kSigned, pair.p, pair.q);
  EXPECT_EQ(reference::canonical_fault(expected), "");
  const Geometry tight = small ? reference::brute_force_tight_places(pair.p, pair.q)
                               : tight_places(pair, SumSettings{});
  for (const Setting& setting : settings()) {
    SCOPED_TRACE(setting.name);
    if (setting.options.method == Method::kReduced) {
      EXPECT_EQ(to_text(tight_places(pair, setting.options)), to_text(tight));
    }
    EXPECT_EQ(to_text(minkowski_sum(pair.p, pair.q, setting.options)), to_text(expected));
    EXPECT_EQ(to_text(minkowski_sum(pair.q, pair.p, setting.options)), to_text(expected));
  }
}

INSTANTIATE_TEST_SUITE_P(Pairs, RegressPairs, ::testing::ValuesIn(pair_names()),
                         [](const auto& param) { return param.param; });

}  // namespace
