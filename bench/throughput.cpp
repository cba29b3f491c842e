// Measures the sums a second of many pairs of shapes.
#include <stdexcept>
#include <string>
#include <vector>

#include "minksum/io.hpp"
#include "minksum/prepared_region.hpp"
#include "minksum/testing.hpp"
#include "peers/stopwatch.hpp"
#include "sets.hpp"

namespace minksum::bench {
namespace {

template <class Shape>
struct Shapes {
  std::vector<Shape> ps;
  std::vector<Shape> qs;
};

// Sums every P with every -Q once. The wall clock runs over the whole loop.
template <class Shape>
double round_of_sums(const Shapes<Shape>& shapes, Workspace& workspace, Region& sum) {
  const Options options;
  const WallStopwatch watch;
  for (const Shape& p : shapes.ps) {
    for (const Shape& q : shapes.qs) {
      const Outcome outcome = minkowski_sum(p, q, options, workspace, sum);
      if (!outcome.ok()) throw Error(*outcome.error);
    }
  }
  return watch.seconds();
}

// Shape is Region, or PreparedRegion, which is made before the clock starts.
template <class Shape>
double sums_per_second(const std::vector<Region>& parts, double seconds) {
  Shapes<Shape> shapes;
  for (const Region& part : parts) {
    shapes.ps.emplace_back(part);
    shapes.qs.emplace_back(negated(part));
  }
  Workspace workspace;
  Region sum;
  round_of_sums(shapes, workspace, sum);
  const auto pairs = static_cast<double>(shapes.ps.size() * shapes.qs.size());
  std::vector<double> rates;
  for (double total = 0; total < seconds;) {
    const double round = round_of_sums(shapes, workspace, sum);
    total += round;
    rates.push_back(pairs / round);
  }
  return median(rates);
}

}  // namespace

Json measure_throughput(const std::filesystem::path& data, double seconds) {
  const std::vector<std::string> files = nesting_parts(data, 27, 33);
  Json record{{"set", "throughput"}, {"name", "pairs of nesting parts of about 30 vertices"}};
  run_part("minksum", {}, record, [&](const Report& report) {
    if (files.empty()) throw std::runtime_error("no parts");
    std::vector<Region> parts;
    for (const std::string& file : files) parts.push_back(io::read_file((data / file).string()));
    report({{"parts", parts.size()},
            {"sums_per_second_unprepared", sums_per_second<Region>(parts, seconds)},
            {"sums_per_second", sums_per_second<PreparedRegion>(parts, seconds)}});
  });
  return record;
}

}  // namespace minksum::bench
