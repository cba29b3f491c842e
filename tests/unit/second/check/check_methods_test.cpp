// Tests that check_sum asks for no sum by the method that it checks. The linker makes every sum of
// geometries pass through `recorded_sum`.
#include <gtest/gtest.h>

#include "minksum/check.hpp"
#include "minksum/testing.hpp"
#include "support/shapes.hpp"

namespace {

using namespace minksum;

std::vector<Method> asked;

}  // namespace

Geometry real_sum(const Geometry& p, const Geometry& q, const Options& options) asm(
    "__real__ZN7minksum13minkowski_sumERKNS_8GeometryES2_RKNS_7OptionsE");
Geometry recorded_sum(const Geometry& p, const Geometry& q, const Options& options) asm(
    "__wrap__ZN7minksum13minkowski_sumERKNS_8GeometryES2_RKNS_7OptionsE");
Geometry recorded_sum(const Geometry& p, const Geometry& q, const Options& options) {
  asked.push_back(Method::kReduced);
  return real_sum(p, q, options);
}
Geometry real_sum(const Geometry& p, const Geometry& q, const SumSettings& settings) asm(
    "__real__ZN7minksum13minkowski_sumERKNS_8GeometryES2_RKNS_11SumSettingsE");
Geometry recorded_sum(const Geometry& p, const Geometry& q, const SumSettings& settings) asm(
    "__wrap__ZN7minksum13minkowski_sumERKNS_8GeometryES2_RKNS_11SumSettingsE");
Geometry recorded_sum(const Geometry& p, const Geometry& q, const SumSettings& settings) {
  asked.push_back(settings.method);
  return real_sum(p, q, settings);
}

namespace {

TEST(CheckMethods, NoSumIsByTheMethodThatIsChecked) {
  const Geometry p{test::rectangle(0, 0, 4, 3), {{{6, 0}, {9, 2}}}, {}};
  const Geometry q{test::make_polygon({{0, 0}, {2, 0}, {1, 3}}), {}, {}};
  const Geometry sum = minkowski_sum(p, q);
  ASSERT_EQ(asked, std::vector<Method>{Method::kReduced}) << "sums are not recorded";
  for (const Rational& within : {Rational(0), Rational(1, 100)}) {
    asked.clear();
    CheckOptions options;
    options.within = within;
    EXPECT_TRUE(check_sum(sum, p, q, options).ok());
    EXPECT_FALSE(asked.empty());
    for (const Method method : asked) EXPECT_EQ(method, Method::kSigned);
  }
}

}  // namespace
