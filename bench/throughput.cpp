// One shape against many: sums a second.
#include "minksum/io.hpp"
#include "peers/stopwatch.hpp"
#include "sets.hpp"

namespace minksum::bench {
namespace {

// What one shape needs only once, before it meets many others. This is the one place that decides
// in which form the operands come; the record says so.
using Prepared = Region;
constexpr bool kPrepared = false;
Prepared prepare(const Region& region) { return region; }

struct Shapes {
  std::vector<Prepared> ps;
  std::vector<Prepared> qs;
};

// Every P with every -Q, once. The wall clock runs over the whole loop.
double round_of_sums(const Shapes& shapes, Workspace& workspace, Region& sum) {
  const Options options;
  const Stopwatch watch;
  for (const Prepared& p : shapes.ps) {
    for (const Prepared& q : shapes.qs) {
      const Outcome outcome = minkowski_sum(p, q, options, workspace, sum);
      if (!outcome.ok()) throw Error(*outcome.error);
    }
  }
  return watch.seconds();
}

}  // namespace

Json measure_throughput(const std::filesystem::path& data, double seconds) {
  const std::vector<std::string> files = nesting_parts(data, 27, 33);
  Json record{{"set", "throughput"}, {"name", "pairs of nesting parts of about 30 vertices"}};
  run_part("minksum", {}, record, [&](const Report& report) {
    if (files.empty()) throw std::runtime_error("no parts");
    Shapes shapes;
    for (const std::string& file : files) {
      const Region part = io::read_file((data / file).string());
      shapes.ps.push_back(prepare(part));
      shapes.qs.push_back(prepare(negated(part)));
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
    report({{"parts", files.size()}, {"prepared", kPrepared}, {"sums_per_second", median(rates)}});
  });
  return record;
}

}  // namespace minksum::bench
