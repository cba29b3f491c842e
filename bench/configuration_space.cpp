// Measures seconds a slice of a configuration space: a robot of 50 vertices among obstacles of
// 1,000.
#include "minksum/configuration_space.hpp"

#include <cstdio>
#include <string>
#include <vector>

#include "minksum/testing.hpp"
#include "peers/stopwatch.hpp"
#include "support/polygon_kinds.hpp"
#include "support/shapes.hpp"

namespace minksum::bench {
namespace {

constexpr int kRobot = 50;
constexpr int kObstacles = 20;
constexpr int kEach = 50;
constexpr std::size_t kAngles = 360;

/// Returns polygons in rows, with room for the robot between some of them.
Region scattered(test::Random& random) {
  Region all;
  for (int i = 0; i < kObstacles; ++i) {
    const Region one = test::random_two_opt(random, kEach, 100);
    const Region moved = test::moved(one, Rational(150 * (i % 5)), Rational(150 * (i / 5)));
    all = test::together(all, moved);
  }
  return all;
}

/// Returns the region with coordinates that are doubles of all 53 bits.
Region as_doubles(const Region& region) {
  return test::transformed(region, [](const Point& p) {
    return Point{Rational(p.x.to_double() * 0.1 + 1.0 / 3),
                 Rational(p.y.to_double() * 0.1 - 1.0 / 7)};
  });
}

template <class Work>
double seconds_of(Work work) {
  const WallStopwatch watch;
  work();
  return watch.seconds();
}

void measure(const char* name, const Region& robot, const Region& obstacles) {
  const std::vector<Turn> turns = full_turn(kAngles);
  const auto all_slices = [&](bool with_free) {
    return seconds_of([&] {
      const ConfigurationSpace space({robot, {}, {}}, {obstacles, {}, {}});
      space.for_each_slice(turns, with_free, {}, [](std::size_t, Slice&) {});
    });
  };
  // Without prepared operands, a user would compute the same sums one by one.
  const auto sums = [&](Arithmetic arithmetic, std::size_t every) {
    SumSettings sum;
    sum.arithmetic = arithmetic;
    return seconds_of([&] {
      for (std::size_t i = 0; i < turns.size(); i += every) {
        const Affine mirrored = Affine::scaling(Rational(-1)).after(turns[i].map());
        (void)minkowski_sum(obstacles, transform(robot, mirrored), sum);
      }
    }) * static_cast<double>(every);
  };
  const auto show = [&](const char* what, double seconds) {
    std::printf("%-8s  %-42s  %8.3f s  %7.3f ms a slice\n", name, what, seconds,
                seconds * 1e3 / static_cast<double>(kAngles));
  };
  show("slices, one thread", all_slices(false));
  show("slices and free space, one thread", all_slices(true));
  show("sums of regions", sums(Arithmetic::kAutomatic, 1));
  show("sums of regions by rationals of any size", sums(Arithmetic::kArbitrary, 18));
  options.threads = 2;
  show("slices, two threads", all_slices(false));
  show("slices and free space, two threads", all_slices(true));
}

}  // namespace
}  // namespace minksum::bench

int main() {
  using namespace minksum;
  test::Random random(1);
  const Region robot = test::random_two_opt(random, bench::kRobot, 60);
  const Region obstacles = bench::scattered(random);
  std::printf("robot %zu vertices, obstacles %zu vertices in %zu polygons, %zu angles\n",
              robot.vertex_count(), obstacles.vertex_count(), obstacles.polygon_count(),
              bench::kAngles);
  bench::measure("integers", robot, obstacles);
  bench::measure("doubles", bench::as_doubles(robot), bench::as_doubles(obstacles));
  return 0;
}
