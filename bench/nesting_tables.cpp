// What nesting starts from: the no-fit polygons of all ordered pairs of an instance's parts, the
// second one turned by each quarter.
#include <algorithm>
#include <atomic>
#include <map>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "minksum/io.hpp"
#include "minksum/prepared_region.hpp"
#include "minksum/transform.hpp"
#include "peers/peers.hpp"
#include "peers/stopwatch.hpp"
#include "sets.hpp"
#include "support/data.hpp"
#include "support/random.hpp"
#ifdef MINKSUM_BENCH_CGAL
#include "oracle/cgal_oracle.hpp"
#endif

namespace minksum::bench {
namespace {

constexpr int kTurns = 4;
constexpr std::size_t kSample = 40;  // sums by CGAL, for each instance

struct Parts {
  std::vector<Region> fixed;
  std::vector<Region> moving;  ///< −part, its first vertex at the origin, by part and quarter turn
  [[nodiscard]] std::size_t sums() const { return fixed.size() * moving.size(); }
};

// −(turned part), moved so that fixed ⊕ it is the no-fit polygon itself.
Region moving_part(const Region& part, int turns) {
  const Region turned = transform(part, Affine::quarter_turns(turns));
  const Point reference = turned.point(0);
  return transform(reflect(turned), Affine::translation(reference.x, reference.y));
}

Parts load(const std::filesystem::path& data, const std::vector<std::string>& files) {
  Parts parts;
  for (const std::string& file : files) {
    parts.fixed.push_back(io::read_file((data / file).string()));
    for (int turns = 0; turns < kTurns; ++turns) {
      parts.moving.push_back(moving_part(parts.fixed.back(), turns));
    }
  }
  return parts;
}

// All sums of one row after the other, by so many threads. Preparing the parts is counted.
double table_seconds(const Parts& parts, unsigned threads) {
  const Stopwatch watch;
  const std::vector<PreparedRegion> fixed(parts.fixed.begin(), parts.fixed.end());
  const std::vector<PreparedRegion> moving(parts.moving.begin(), parts.moving.end());
  std::atomic<std::size_t> next_row{0};
  std::atomic<bool> failed{false};
  const auto work = [&] {
    Workspace workspace;
    std::vector<Region> row(moving.size());
    for (std::size_t i = next_row++; i < fixed.size(); i = next_row++) {
      for (std::size_t j = 0; j < moving.size(); ++j) {
        if (!minkowski_sum(fixed[i], moving[j], {}, workspace, row[j]).ok()) failed = true;
      }
    }
  };
  std::vector<std::thread> others;
  for (unsigned t = 1; t < threads; ++t) others.emplace_back(work);
  work();
  for (std::thread& other : others) other.join();
  if (failed) throw std::runtime_error("a sum failed");
  return watch.seconds();
}

Json measure_minksum(const Parts& parts, double seconds) {
  const unsigned threads = std::max(1U, std::thread::hardware_concurrency());
  std::vector<double> one;
  std::vector<double> all;
  for (const Stopwatch watch; watch.seconds() < seconds || one.size() < 3;) {
    one.push_back(table_seconds(parts, 1));
    all.push_back(table_seconds(parts, threads));
  }
  return {{"one_thread", summary(one)}, {"all_threads", summary(all)}, {"threads", threads}};
}

// A sample of the table by CGAL, each sum compared exactly first.
void measure_cgal([[maybe_unused]] const Parts& parts, [[maybe_unused]] const Report& report) {
#ifdef MINKSUM_BENCH_CGAL
  test::Random random(2011);
  std::vector<double> seconds;
  std::size_t equal = 0;
  for (std::size_t k = 0; k < std::min(kSample, parts.sums()); ++k) {
    const Region& p = parts.fixed[random.next() % parts.fixed.size()];
    const Region& q = parts.moving[random.next() % parts.moving.size()];
    equal += oracle::cgal_sum(p, q).sum == minkowski_sum(p, q) ? 1U : 0U;
    const std::unique_ptr<Peer> peer = make_cgal_reduced(p, q);
    seconds.push_back(median({peer->run(), peer->run(), peer->run()}));
    double total = 0;
    for (const double each : seconds) total += each;
    report({{"cgal",
             {{"sums", seconds.size()},
              {"equal", equal},
              {"mean", total / static_cast<double>(seconds.size())}}}});
  }
#endif
}

// Files of valid single parts, with holes or without, by the name of their instance.
std::map<std::string, std::vector<std::string>> instances(const std::filesystem::path& data) {
  std::map<std::string, std::vector<std::string>> found;
  constexpr std::string_view kFolder = "nesting/";
  for (const test::DataFile& file : test::read_manifest(data)) {
    const std::string& name = file.name;
    if (!name.starts_with(kFolder) || !file.is_valid || file.parts != 1) continue;
    found[name.substr(kFolder.size(), name.rfind('_') - kFolder.size())].push_back(name);
  }
  return found;
}

}  // namespace

void measure_nesting_tables(const std::filesystem::path& data, const Effort& effort, bool quick,
                            const std::function<void(const Json&)>& take) {
  std::size_t count = 0;
  for (const auto& [name, files] : instances(data)) {
    if (quick && ++count > 2) break;
    const Parts parts = load(data, files);
    Json record{{"set", "tables"},
                {"name", name},
                {"parts", files.size()},
                {"rotations", kTurns},
                {"sums", parts.sums()}};
    run_part("minksum", {}, record, [&](const Report& report) {
      report({{"table", measure_minksum(parts, effort.least_seconds)}});
    });
    if (!cgal_name().empty()) {
      ChildLimits limits;
      limits.seconds_between_reports = effort.peer_seconds;
      run_part("cgal", limits, record,
               [&](const Report& report) { measure_cgal(parts, report); });
    }
    take(record);
  }
}

}  // namespace minksum::bench
