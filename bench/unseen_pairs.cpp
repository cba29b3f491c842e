// Measures pairs that nobody tuned for: regret, the ratio to CGAL, and what threads gain.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iterator>

#include "minksum/io.hpp"
#include "minksum/prepared_region.hpp"
#include "minksum/transform.hpp"
#include "peers/peers.hpp"
#include "peers/stopwatch.hpp"
#include "sets.hpp"
#include "support/data.hpp"
#include "support/random.hpp"

namespace minksum::bench {
namespace {

using std::filesystem::path;

// The first settings are what users get. Regret compares them with each of the others.
std::vector<std::pair<std::string, SumSettings>> all_settings() {
  std::vector<std::pair<std::string, SumSettings>> all{{"automatic", {}}, {"no cover", {}}};
  all.back().second.cover = false;
  for (int grid = 32; grid <= 2048; grid *= 2) {
    all.emplace_back("grid " + std::to_string(grid), SumSettings{}).second.grid = grid;
  }
  return all;
}

// Returns the least seconds of some sums, or infinity if one takes longer than `most`.
template <class Sum>
double least_seconds_of(double most, Sum sum) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(most);
  const auto stop = CancelToken::polling([end] { return Clock::now() > end; });
  return least_seconds([&](std::size_t times) {
    const Stopwatch watch;
    for (std::size_t i = 0; i < times; ++i) {
      const Outcome outcome = sum(stop);
      if (outcome.ok()) continue;
      if (outcome.error->code() == ErrorCode::kCancelled) return HUGE_VAL;
      throw Error(*outcome.error);
    }
    return watch.seconds();
  });
}

// Times the sum by all settings in turn. Settings that are far behind are left out soon.
void measure_settings(const Operands& operands, const Effort& effort, const Report& report) {
  constexpr double kFarBehind = 3;
  const auto& [p, q] = operands;
  auto all = all_settings();
  std::vector<double> seconds(all.size(), HUGE_VAL);
  std::vector<bool> left_out(all.size());
  Workspace workspace;
  Region sum;
  const Stopwatch watch;
  for (int round = 0; round < 3 || (round < 20 && watch.seconds() < effort.enough_seconds);
       ++round) {
    const double best = *std::min_element(seconds.begin(), seconds.end());
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (left_out[i]) continue;
      const double most = i == 0 ? effort.peer_seconds : 0.05 + 2 * kFarBehind * seconds[0];
      seconds[i] = std::min(seconds[i], least_seconds_of(most, [&](const CancelToken& stop) {
                              all[i].second.cancel = stop;
                              return minkowski_sum(p, q, all[i].second, workspace, sum);
                            }));
      left_out[i] = i != 0 && seconds[i] > kFarBehind * std::min(best, seconds[0]);
    }
  }
  const auto best =
      static_cast<std::size_t>(std::min_element(seconds.begin(), seconds.end()) - seconds.begin());
  const Statistics counts = detailed_sum(p, q, SumSettings{}).statistics;
  report({{"seconds", seconds[0]},
          {"best", all[best].first},
          {"best_seconds", seconds[best]},
          {"regret", seconds[0] / seconds[best]},
          {"small", counts.small},
          {"segments", counts.convolution_segments},
          {"crossings", counts.crossings},
          {"decisions", counts.by_filter + counts.by_fixed_width + counts.by_arbitrary},
          {"p", {{"vertices", p.vertex_count()}, {"parts", p.polygon_count()}}},
          {"q", {{"vertices", q.vertex_count()}, {"parts", q.polygon_count()}}}});
}

// Times CGAL and both ways to call minksum in turn. The first report holds if CGAL does not end.
void measure_beside_cgal(const Operands& operands, const Effort& effort, const Report& report) {
  const auto& [p, q] = operands;
  const PreparedRegion prepared_p(p);
  const PreparedRegion prepared_q(q);
  Workspace workspace;
  Region sum;
  std::array<std::vector<double>, 3> seconds;
  const auto run_own = [&] {
    seconds[1].push_back(least_seconds_of(effort.peer_seconds, [&](const CancelToken&) {
      return minkowski_sum(prepared_p, prepared_q, Options{}, workspace, sum);
    }));
    seconds[2].push_back(least_seconds_of(effort.peer_seconds, [&](const CancelToken&) {
      return minkowski_sum(p, q, Options{}, workspace, sum);
    }));
  };
  const auto members = [&](double cgal) {
    return Json{{"cgal",
                 {{"median", cgal},
                  {"ratio_prepared", cgal / median(seconds[1])},
                  {"ratio_as_read", cgal / median(seconds[2])}}}};
  };
  for (int i = 0; i < 3; ++i) run_own();
  report(members(effort.peer_seconds));
  const std::unique_ptr<Peer> cgal = make_cgal_reduced(p, q);
  if (cgal == nullptr) throw std::runtime_error("there is no CGAL");
  double total = 0;
  while (seconds[0].size() < 11 && total < effort.enough_seconds) {
    seconds[0].push_back(least_seconds([&](std::size_t times) { return cgal->run(times); }));
    total += seconds[0].back();
    run_own();
  }
  report(members(median(seconds[0])));
}

// Times one thread and all cores in turn, by the wall clock, if one thread takes long.
void measure_threads(const Operands& operands, const Effort& effort, const Report& report) {
  constexpr double kLong = 0.05;
  const auto& [p, q] = operands;
  const PreparedRegion prepared_p(p);
  const PreparedRegion prepared_q(q);
  Workspace workspace;
  Region sum;
  const auto seconds = [&](const auto& a, const auto& b, int threads) {
    Options options;
    options.threads = threads;
    const WallStopwatch watch;
    const Outcome outcome = minkowski_sum(a, b, options, workspace, sum);
    if (!outcome.ok()) throw Error(*outcome.error);
    return watch.seconds();
  };
  seconds(prepared_p, prepared_q, 1);  // memory is new in the first run
  if (seconds(prepared_p, prepared_q, 1) < kLong) return report({{"short", true}});
  constexpr int kAll = 0;
  double least[2][2] = {{HUGE_VAL, HUGE_VAL}, {HUGE_VAL, HUGE_VAL}};
  const WallStopwatch watch;
  for (int round = 0; round < 3 || (round < 20 && watch.seconds() < effort.enough_seconds);
       ++round) {
    for (const int threads : {1, kAll}) {
      auto& [prepared, as_read] = least[threads == 1 ? 0 : 1];
      prepared = std::min(prepared, seconds(prepared_p, prepared_q, threads));
      as_read = std::min(as_read, seconds(p, q, threads));
    }
  }
  report({{"seconds", least[0][0]},
          {"times_prepared", least[0][0] / least[1][0]},
          {"times_as_read", least[0][1] / least[1][1]}});
}

std::string stem(const std::string& file) { return path(file).stem().string(); }

// Returns pairs of any two files, of which the second is scaled by 10^U(-2, 2). The factor has
// three digits, and scaling is exact: rounding could make a valid region invalid.
std::vector<Case> random_pairs(const path& data, std::uint64_t seed, std::size_t count) {
  std::vector<std::string> files;
  for (const auto& file : test::read_manifest(data)) {
    if (file.is_valid) files.push_back((data / file.name).string());
  }
  std::sort(files.begin(), files.end());
  test::Random random(seed);
  std::vector<Case> pairs;
  while (pairs.size() < count) {
    const std::string& p = files[random.next() % files.size()];
    const std::string& q = files[random.next() % files.size()];
    const double exponent = 4 * static_cast<double>(random.next() >> 11U) * 0x1p-53 - 2;
    const double digits = std::floor(exponent);
    const Rational factor(std::llround(100 * std::pow(10, exponent - digits)), std::int64_t{100});
    const Rational scale = digits < 0 ? factor / Rational(std::llround(std::pow(10, -digits)))
                                      : factor * Rational(std::llround(std::pow(10, digits)));
    Case& one = pairs.emplace_back();
    one.set = "mixed";
    one.name = stem(p) + " + " + scale.to_string() + " " + stem(q);
    one.about = {{"number", pairs.size() - 1}, {"seed", seed}};
    one.load = [=] {
      return Operands{io::read_file(p), transform(io::read_file(q), Affine::scaling(scale))};
    };
  }
  return pairs;
}

std::vector<Case> listed_pairs(const path& data) {
  std::vector<Case> pairs;
  std::ifstream in(data / "regret.tsv");
  for (std::string line; std::getline(in, line);) {
    const std::size_t tab = line.find('\t');
    if (line.starts_with('#') || tab == std::string::npos) continue;
    const std::string p = (data / line.substr(0, tab)).string();
    const std::string q = (data / line.substr(tab + 1)).string();
    Case& one = pairs.emplace_back();
    one.set = "regret";
    one.name = stem(p) + " + " + stem(q);
    one.load = [=] { return Operands{io::read_file(p), io::read_file(q)}; };
  }
  return pairs;
}

// Returns how a figure is distributed.
Json distribution(std::vector<double> values) {
  if (values.empty()) return {{"pairs", 0}};
  std::sort(values.begin(), values.end());
  double sum = 0;
  double logarithms = 0;
  for (const double value : values) {
    sum += value;
    logarithms += std::log(value);
  }
  const auto count = static_cast<double>(values.size());
  const auto quantile = [&](double share) {
    return values[static_cast<std::size_t>(share * (count - 1))];
  };
  return {{"pairs", values.size()},
          {"mean", sum / count},
          {"geometric_mean", std::exp(logarithms / count)},
          {"least", values.front()},
          {"quantile_5", quantile(0.05)},
          {"median", quantile(0.5)},
          {"quantile_95", quantile(0.95)},
          {"greatest", values.back()}};
}

}  // namespace

void measure_threads(const path& data, const Effort& effort, const UnseenPairs& asked,
                     const std::string& only, const std::function<void(const Json&)>& take) {
  std::vector<Case> cases = listed_pairs(data);
  std::ranges::move(random_pairs(data, asked.seed, asked.count), std::back_inserter(cases));
  std::vector<double> prepared;
  std::vector<double> as_read;
  for (Case& one : cases) {
    if (one.name.find(only) == std::string::npos) continue;
    Json record{{"set", "threads"}, {"name", one.name}};
    record.update(one.about);
    ChildLimits limits;
    limits.seconds_between_reports = 10 * effort.peer_seconds;
    run_part("minksum", limits, record,
             [&](const Report& report) { measure_threads(one.load(), effort, report); });
    if (record.contains("short")) continue;
    if (record.contains("seconds")) {
      prepared.push_back(record["times_prepared"]);
      as_read.push_back(record["times_as_read"]);
    }
    take(record);
  }
  take({{"set", "threads"},
        {"name", "all pairs"},
        {"seed", asked.seed},
        {"times_prepared", distribution(prepared)},
        {"times_as_read", distribution(as_read)}});
}

void measure_unseen_pairs(const std::string& set, const path& data, const Effort& effort,
                          const UnseenPairs& asked, const std::string& only,
                          const std::function<void(const Json&)>& take) {
  const bool listed = set == "regret";
  std::vector<double> regrets;
  std::vector<double> prepared;
  std::vector<double> as_read;
  std::size_t over_time = 0;
  std::size_t different = 0;
  for (Case& one : listed ? listed_pairs(data) : random_pairs(data, asked.seed, asked.count)) {
    if (one.name.find(only) == std::string::npos) continue;
    Json record{{"set", set}, {"name", one.name}};
    record.update(one.about);
    ChildLimits limits;
    limits.seconds_between_reports = 10 * effort.peer_seconds;
    run_part("minksum", limits, record,
             [&](const Report& report) { measure_settings(one.load(), effort, report); });
    if (record.contains("regret")) regrets.push_back(record["regret"]);
    const bool single =
        record.contains("p") && record["p"]["parts"] == 1 && record["q"]["parts"] == 1;
    if (!listed && asked.cgal && single) {
      limits.seconds_between_reports = effort.peer_seconds;
      run_part("cgal", limits, record,
               [&](const Report& report) { measure_beside_cgal(one.load(), effort, report); });
      if (record.contains("given_up")) {
        ++over_time;
      } else {
        compare_with_cgal(one, effort, record);
      }
      const bool equal = !record.contains("equal_to_cgal") || record["equal_to_cgal"] == true;
      if (!equal) ++different;
      if (record.contains("cgal") && equal) {
        prepared.push_back(record["cgal"]["ratio_prepared"]);
        as_read.push_back(record["cgal"]["ratio_as_read"]);
      }
    }
    take(record);
  }
  Json all{{"set", set}, {"name", "all pairs"}, {"regrets", distribution(regrets)}};
  if (!listed) {
    all["seed"] = asked.seed;
    all["ratios_prepared"] = distribution(prepared);
    all["ratios_as_read"] = distribution(as_read);
    all["cgal_over_time"] = over_time;
    all["different"] = different;
  }
  take(all);
}

}  // namespace minksum::bench
