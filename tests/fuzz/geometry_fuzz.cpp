// Fuzzes sums of any geometries. Bytes become a fill rule, a setting, and two geometries on a grid
// of 8 by 8 points, where nearly everything coincides. Resolving, the sum, its tight places, its
// roundings and its check must agree with brute force.
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "fuzz/geometry_reader.hpp"
#include "support/geometry_laws.hpp"
#include "support/messes.hpp"

namespace {

using namespace minksum;

// Beyond this work, brute force takes too long.
constexpr std::size_t kMaxWork = 100;

SumSettings read_setting(int rule, int byte) {
  constexpr std::array kArithmetics = {Arithmetic::kAutomatic, Arithmetic::kMedium,
                                       Arithmetic::kWide, Arithmetic::kArbitrary};
  SumSettings setting;
  setting.fill = fuzz::fill_rule(rule);
  setting.regularize = rule / 5 % 4 == 3;
  setting.arithmetic = kArithmetics[static_cast<std::size_t>(byte % 4)];
  setting.cover = byte / 4 % 4 != 0;
  setting.filter = byte / 16 % 4 != 0;
  setting.check = byte / 64 % 2 != 0;
  setting.grid = rule % 3 * (1 + byte % 16);
  return setting;
}

Geometry scaled(const Geometry& geometry, const Rational& factor) {
  return test::transformed(geometry, [&](const Point& p) -> Point {
    return {p.x * factor, p.y * factor};
  });
}

void require(const std::string& fault, const test::SumCase& sum_case) {
  if (fault.empty()) return;
  std::fprintf(stderr, "violated: %s\n%s\n", fault.c_str(), test::note(sum_case).c_str());
  std::abort();
}

void try_laws(const test::SumCase& sum_case, const Rational& scale) {
  const SumSettings& setting = sum_case.setting;
  for (const Geometry* geometry : {&sum_case.p, &sum_case.q}) {
    require(test::broken_resolve(*geometry, setting.fill, setting.regularize), sum_case);
  }
  if (test::brute_force_work(sum_case) > kMaxWork) return;
  require(test::broken_sum(sum_case), sum_case);
  require(test::broken_tight(sum_case), sum_case);
  const Geometry sum = minkowski_sum(sum_case.p, sum_case.q, setting);
  require(test::broken_form(sum), sum_case);
  require(test::broken_rounding(scaled(sum, scale)), sum_case);
  require(test::broken_check(sum_case, sum), sum_case);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::GeometryReader reader(data, size);
  const int rule = reader.take();
  const SumSettings setting = read_setting(rule, reader.take());
  const int scales = reader.take();
  const Geometry p = reader.read();
  const Geometry q = scaled(reader.read(), Rational(1 + scales % 3, 1 + scales / 3 % 2));
  const test::SumCase sum_case{p, q, setting};
  try {
    try_laws(sum_case, Rational(1 + scales / 8, 1 + 37 * (scales % 8)));
  } catch (const std::exception& error) {
    require(std::string("it can be done: ") + error.what(), sum_case);
  }
  return 0;
}
