#include "measure.hpp"

#include <algorithm>
#include <cmath>

#include "list_convolution.hpp"
#include "minksum/measure.hpp"
#include "minksum/testing.hpp"
#include "peers/stopwatch.hpp"

namespace minksum::bench {
namespace {

const char* rung_name(Arithmetic arithmetic) {
  constexpr const char* kNames[] = {"automatic", "narrow", "medium", "wide", "arbitrary"};
  return kNames[static_cast<int>(arithmetic)];
}

Json size_json(const Region& region) {
  return {{"vertices", region.vertex_count()},
          {"holes", region.hole_count()},
          {"parts", region.polygon_count()}};
}

Json counts_json(const Statistics& statistics) {
  return {{"convolution_segments", statistics.convolution_segments},
          {"segments_kept", statistics.segments_kept},
          {"crossings", statistics.crossings},
          {"loops", statistics.loops},
          {"grid_cells", statistics.grid_cells},
          {"covered_cells", statistics.covered_cells}};
}

Json sizes_json(const Region& p, const Region& q) {
  return {{"p", size_json(p)}, {"q", size_json(q)}};
}

// Returns the seconds that the library itself takes to list every segment, from the same operands
// as a whole sum. These are the stages operands and convolution, without a cover and later stages.
double own_listing(const Region& p, const Region& q) {
  SumSettings settings;
  settings.cover = false;
  Stopwatch watch;
  double listed = 0;
  settings.progress = [&](const Progress& progress) {
    listed = watch.seconds();
    return progress.stage == Stage::kOperands || progress.stage == Stage::kConvolution;
  };
  Workspace workspace;
  Region nothing;
  std::vector<double> seconds;
  double total = 0;
  while (seconds.size() < 7 || (seconds.size() < 101 && total < 0.05)) {
    watch = Stopwatch();
    (void)minkowski_sum(p, q, settings, workspace, nothing);  // ends where the cover would begin
    seconds.push_back(listed);
    total += listed;
  }
  return median(seconds);
}

// The first run in a fresh process tells how much memory a sum takes.
void measure_alone(const Case& one, const Effort& effort, const Report& report) {
  const auto [p, q] = one.load();
  MinksumRuns minksum;
  const std::size_t before = restart_peak_memory();
  minksum.run(p, q);
  const std::size_t peak = peak_memory();
  const Statistics first = minksum.statistics();
  report(sizes_json(p, q));
  report({{"result", size_json(minksum.sum())},
          {"bits", first.coordinate_bits},
          {"rung", rung_name(first.arithmetic)},
          {"counts", counts_json(first)},
          {"first_seconds", first.seconds},
          {"peak_bytes", peak},
          {"peak_growth_bytes", peak - std::min(peak, before)}});
  minksum.forget();
  minksum.repeat(p, q, effort);
  report({{"minksum_alone", minksum.json()}, {"result_area", approximate_area(minksum.sum())}});
  if (one.listing) {
    const Listing listing = list_convolution(p, q);
    report({{"listing",
             {{"segments", listing.segments},
              {"median", listing.seconds},
              {"exact", listing.exact},
              {"by_library", own_listing(p, q)}}}});
  }
}

void measure_counts(const Case& one, bool full, const Report& report) {
  const auto [p, q] = one.load();
  SumSettings options;
  options.cover = false;
  if (full) options.method = Method::kFull;
  MinksumRuns minksum(options);
  minksum.run(p, q);
  Json counts = counts_json(minksum.statistics());
  counts["seconds"] = minksum.statistics().seconds;
  report({{full ? "counts_full" : "counts_no_cover", counts}});
}

}  // namespace

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

Json summary(const std::vector<double>& seconds) {
  return {{"runs", seconds.size()},
          {"median", median(seconds)},
          {"min", *std::min_element(seconds.begin(), seconds.end())},
          {"max", *std::max_element(seconds.begin(), seconds.end())}};
}

MinksumRuns::MinksumRuns(SumSettings options) : options_(std::move(options)) {}

double MinksumRuns::timed(const Region& p, const Region& q) {
  const Stopwatch watch;
  const Outcome outcome = minkowski_sum(p, q, options_, workspace_, sum_);
  const double seconds = watch.seconds();
  if (!outcome.ok()) throw Error(*outcome.error);
  return seconds;
}

double MinksumRuns::timed_by_stages(const Region& p, const Region& q) {
  SumSettings by_stages = options_;
  by_stages.small = false;
  by_stages.memory = &workspace_;
  const Stopwatch watch;
  DetailedSum found = detailed_sum(p, q, by_stages);
  const double seconds = watch.seconds();
  sum_ = std::move(found.sum.region);
  statistics_ = found.statistics;
  return seconds;
}

double MinksumRuns::run(const Region& p, const Region& q) {
  // Small operands take a shorter way than the stages. In a long run statistics cost nothing.
  constexpr double kLong = 0.01;
  constexpr std::size_t kStaged = 9;
  const bool is_long = !runs_.empty() && runs_.back() > kLong;
  if (is_long || staged_.size() < kStaged) {
    const double seconds = timed_by_stages(p, q);
    staged_.push_back(statistics_);
    if (seconds > kLong) {
      runs_.push_back(seconds);
      return seconds;
    }
  }
  runs_.push_back(timed(p, q));
  return runs_.back();
}

void MinksumRuns::repeat(const Region& p, const Region& q, const Effort& effort) {
  double total = 0;
  for (int i = 0; i < effort.most_runs; ++i) {
    if (i >= 3 && total >= effort.least_seconds) break;
    total += run(p, q);
  }
}

Json MinksumRuns::json() const {
  Json json = summary(runs_);
  for (int stage = 0; stage < kSumStages; ++stage) {
    std::vector<double> parts;
    for (const Statistics& run : staged_) parts.push_back(run.stage_seconds[stage]);
    json["stages"][to_string(static_cast<Stage>(stage))] = median(parts);
  }
  return json;
}

void run_part(const char* name, const ChildLimits& limits, Json& record,
              const std::function<void(const Report&)>& work) {
  const ChildEnd end = run_in_child(limits, work);
  record.update(end.members);
  if (end.status == "ok") return;
  record["failures"][name] = end.status;
  if (end.status == "over time") record["given_up"][name] = limits.seconds_between_reports;
}

Json measure(const Case& one, const Effort& effort) {
  Json record{{"set", one.set}, {"name", one.name}};
  record.update(one.about);
  ChildLimits limits;
  run_part("load", limits, record, [&](const Report& report) {
    const auto [p, q] = one.load();
    report(sizes_json(p, q));
  });
  if (!record.contains("p") || record["p"]["vertices"] == 0) return record;
  compare_with_cgal(one, effort, record);
  if (record.contains("equal_to_cgal") && record["equal_to_cgal"] == false) return record;
  run_part("minksum", limits, record,
           [&](const Report& report) { measure_alone(one, effort, report); });
  if (!record.contains("minksum_alone")) return record;
  if (one.count_no_cover) {
    run_part("counts_no_cover", limits, record,
             [&](const Report& report) { measure_counts(one, false, report); });
  }
  if (one.count_full) {
    limits.seconds_between_reports = effort.full_seconds;
    run_part("counts_full", limits, record,
             [&](const Report& report) { measure_counts(one, true, report); });
  }
  add_peers(one, effort, record);
  return record;
}

}  // namespace minksum::bench
