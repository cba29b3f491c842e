// Measures tables for nesting: the no-fit polygons of all ordered pairs of an instance's parts, the
// second one turned by each quarter.
#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "minksum/io.hpp"
#include "minksum/no_fit.hpp"
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
  std::vector<Geometry> parts;
  [[nodiscard]] std::size_t sums() const { return parts.size() * parts.size() * kTurns; }
};

// An entry of the table is the sum of two shapes. One is a part whose first vertex is the origin.
// The other is a part placed in the same way, turned, and multiplied by −1.
Region fixed_part(const Geometry& part) {
  const Point reference = part.region.point(0);
  return transform(part.region, Affine::translation(-reference.x, -reference.y));
}
Region moving_part(const Geometry& part, int turn) {
  return transform(fixed_part(part), Affine::quarter_turns(turn + 2));
}

NoFitTable make_table(const Parts& parts, int threads) {
  Options options;
  options.tight = false;  // CGAL does not find tight places
  options.threads = threads;
  return NoFitTable(parts.parts, kTurns, options);
}

// Returns the seconds for all entries. Reading and preparing the parts is counted.
double run_table(const Parts& parts, int threads) {
  const WallStopwatch watch;
  const NoFitTable table = make_table(parts, threads);
  std::vector<Geometry> entries;
  entries.reserve(parts.sums());
  for (std::size_t i = 0; i < table.size(); ++i) {
    for (std::size_t j = 0; j < table.size(); ++j) {
      for (int turn = 0; turn < kTurns; ++turn) entries.push_back(table.at({i, 0}, {j, turn}));
    }
  }
  return watch.seconds();
}

// Times the table again and again, on one thread and on all.
class TableTimes {
 public:
  explicit TableTimes(const Parts& parts) : parts_(parts) {}

  void measure() {
    one_.push_back(run_table(parts_, 1));
    all_.push_back(run_table(parts_, threads_));
    seconds_ += one_.back() + all_.back();
  }
  [[nodiscard]] double seconds() const { return seconds_; }
  [[nodiscard]] std::size_t size() const { return one_.size(); }
  [[nodiscard]] Json json() const {
    return {{"one_thread", summary(one_)}, {"all_threads", summary(all_)}, {"threads", threads_}};
  }

 private:
  const Parts& parts_;
  int threads_ = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  std::vector<double> one_;
  std::vector<double> all_;
  double seconds_ = 0;
};

void measure_minksum(const Parts& parts, double seconds, const Report& report) {
  TableTimes times(parts);
  while (times.seconds() < seconds || times.size() < 3) times.measure();
  report({{"table", times.json()}});
}

// Measures a sample of the table by CGAL, in turn with the table. Each sum is compared exactly
// first.
void measure_cgal([[maybe_unused]] const Parts& parts, [[maybe_unused]] double table_seconds,
                  [[maybe_unused]] const Report& report) {
#ifdef MINKSUM_BENCH_CGAL
  test::Random random(2011);
  const NoFitTable table = make_table(parts, 1);
  TableTimes times(parts);
  std::vector<double> seconds;
  std::size_t equal = 0;
  for (std::size_t k = 0; k < std::min(kSample, parts.sums()); ++k) {
    const std::size_t i = random.next() % table.size();
    const std::size_t j = random.next() % table.size();
    const auto turn = static_cast<int>(random.next() % kTurns);
    const Region p = fixed_part(parts.parts[i]);
    const Region q = moving_part(parts.parts[j], turn);
    equal += oracle::cgal_sum(p, q).sum == table.at({i, 0}, {j, turn}).region ? 1U : 0U;
    const std::unique_ptr<Peer> peer = make_cgal_reduced(p, q);
    seconds.push_back(median({peer->run(1), peer->run(1), peer->run(1)}));
    const double share = table_seconds * static_cast<double>(k + 1) / kSample;
    while (times.size() == 0 || times.seconds() < share) times.measure();
    double total = 0;
    for (const double each : seconds) total += each;
    report({{"table", times.json()},
            {"cgal",
             {{"sums", seconds.size()},
              {"equal", equal},
              {"mean", total / static_cast<double>(seconds.size())}}}});
  }
#endif
}

// Returns files of valid single parts, with holes or without, by the name of their instance.
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
                            const std::string& only, const std::function<void(const Json&)>& take) {
  std::size_t count = 0;
  for (const auto& [name, files] : instances(data)) {
    if (name.find(only) == std::string::npos) continue;
    if (quick && ++count > 2) break;
    Parts parts;
    for (const std::string& file : files) {
      parts.parts.push_back(io::read_geometry_file((data / file).string()));
    }
    Json record{{"set", "tables"},
                {"name", name},
                {"parts", files.size()},
                {"rotations", kTurns},
                {"sums", parts.sums()}};
    const double seconds = 8 * effort.least_seconds;
    // This figure stays if CGAL is missing or ends without a sum; else the one in turn replaces it.
    run_part("minksum", {}, record,
             [&](const Report& report) { measure_minksum(parts, seconds / 4, report); });
    if (!cgal_name().empty()) {
      ChildLimits limits;
      limits.seconds_between_reports = effort.peer_seconds;
      run_part("cgal", limits, record,
               [&](const Report& report) { measure_cgal(parts, seconds, report); });
    }
    take(record);
  }
}

}  // namespace minksum::bench
