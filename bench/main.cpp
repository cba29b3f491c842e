// minksum_bench measures minksum and its peers on the same input in the same run, and writes JSON.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>
#include <functional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "machine.hpp"
#include "peers/stopwatch.hpp"
#include "sets.hpp"
#include "support/data.hpp"

namespace {

using namespace minksum::bench;

constexpr const char* kUsage =
    "usage: minksum_bench [--set NAME[,NAME...]]... [--only TEXT] [--out FILE] [--quick]\n"
    "                     [--budget SECONDS] [--seed N] [--pairs N] [--no-cgal]\n"
    "  --set     what to measure (default: all): paper kin named figures spiky nesting\n"
    "            tables gis outlines doubles families regret mixed threads\n"
    "  --only    only pairs, families, or instances, with this in their names\n"
    "  --out     where the JSON goes (default: bench.json); report.py takes several of them\n"
    "  --quick   a few pairs of each set, small members of the families\n"
    "  --budget  longest time for one sum by a peer, or it is given up (default: 60; quick: 4)\n"
    "  --seed    of the random pairs of `mixed` and `threads` (default: 1)\n"
    "  --pairs   how many random pairs (default: 200; quick: 20)\n"
    "  --no-cgal leaves CGAL out of `mixed`\n"
    "The folder with the shapes is $MINKSUM_DATA, or ../shared/data beside the sources.\n";

struct Arguments {
  std::set<std::string> sets;
  std::string only;
  std::string out = "bench.json";
  bool quick = false;
  double budget = 0;
  UnseenPairs unseen;
};

void add_sets(const std::string& text, std::set<std::string>& sets) {
  const std::vector<std::string> known = set_names();
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string name = text.substr(begin, end - begin);
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      throw std::runtime_error("no set named '" + name + "'\n" + kUsage);
    }
    sets.insert(name);
    begin = end + 1;
  }
}

Arguments parse(const std::vector<std::string>& words) {
  Arguments arguments;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto value = [&] {
      if (i + 1 == words.size()) throw std::runtime_error(words[i] + " needs a value\n" + kUsage);
      return words[++i];
    };
    if (words[i] == "--quick") {
      arguments.quick = true;
    } else if (words[i] == "--set") {
      add_sets(value(), arguments.sets);
    } else if (words[i] == "--only") {
      arguments.only = value();
    } else if (words[i] == "--out") {
      arguments.out = value();
    } else if (words[i] == "--budget") {
      arguments.budget = std::stod(value());
    } else if (words[i] == "--seed") {
      arguments.unseen.seed = std::stoull(value());
    } else if (words[i] == "--pairs") {
      arguments.unseen.count = std::stoul(value());
    } else if (words[i] == "--no-cgal") {
      arguments.unseen.cgal = false;
    } else {
      throw std::runtime_error(kUsage);
    }
  }
  if (arguments.unseen.count == 0) arguments.unseen.count = arguments.quick ? 20 : 200;
  return arguments;
}

double member(const Json& record, const char* who, const char* what) {
  return record.contains(who) && record[who].contains(what) ? static_cast<double>(record[who][what])
                                                            : 0;
}

double member_of(const Json& record, const char* what) { return record[what]; }

// Prints one line for people who watch.
void print(const Json& record) {
  const std::string name = record["name"];
  std::printf("  %-44s", name.c_str());
  if (record.contains("minksum_alone")) {
    std::printf(" %10.3f ms", member(record, "minksum_alone", "median") * 1e3);
  }
  if (record.contains("regret")) {
    std::printf(" %10.3f ms  regret %.2f (%s)", member_of(record, "seconds") * 1e3,
                member_of(record, "regret"), record["best"].get<std::string>().c_str());
  }
  for (const char* figure : {"ratio_prepared", "ratio_as_read"}) {
    const double ratio = member(record, "cgal", figure);
    if (ratio > 0) std::printf("  cgal %.1f x", ratio);
  }
  for (const char* of : {"regrets", "ratios_prepared", "ratios_as_read"}) {
    if (record.contains(of)) std::printf("\n  %s: %s", of, record[of].dump().c_str());
  }
  for (const char* of : {"times_prepared", "times_as_read"}) {
    if (!record.contains(of)) continue;
    const Json& times = record[of];
    const std::string all = times.dump();
    std::printf("  %s: %s", of, times.is_number() ? all.substr(0, 4).c_str() : all.c_str());
  }
  for (const char* peer : {"cgal", "cgal_full", "clipper", "geos"}) {
    const double ratio = member(record, peer, "ratio");
    if (ratio > 0) std::printf("  %s %.1f x", peer, ratio);
  }
  if (record.contains("doubles")) {
    std::printf(" doubles / decimals %.2f", static_cast<double>(record["ratio"]));
  }
  if (record.contains("sums_per_second")) {
    std::printf(" %.0f sums a second", static_cast<double>(record["sums_per_second"]));
  }
  if (record.contains("table")) {
    const double table = member(record["table"], "one_thread", "median");
    const double sums = record["sums"];
    std::printf(" %.0f sums in %.1f ms", sums, table * 1e3);
    if (record.contains("cgal")) {
      std::printf("  cgal %.1f x", member(record, "cgal", "mean") * sums / table);
    }
  }
  if (record.contains("equal_to_cgal") && record["equal_to_cgal"] == false) {
    std::printf("  NOT EQUAL to CGAL's result, not timed");
  }
  if (record.contains("failures")) {
    for (const auto& [who, why] : record["failures"].items()) {
      std::printf("  %s: %s", who.c_str(), why.get<std::string>().c_str());
    }
  }
  std::printf("\n");
  std::fflush(stdout);
}

class Book {
 public:
  Book(const Arguments& arguments, const Effort& effort) : file_(arguments.out) {
    json_["run"] = describe_run();
    json_["run"]["peer_seconds"] = effort.peer_seconds;
    json_["run"]["full_seconds"] = effort.full_seconds;
    json_["run"]["quick"] = arguments.quick;
    json_["records"] = Json::array();
  }
  // Saves after each record, so that records survive an early end.
  void take(const Json& record) {
    print(record);
    json_["records"].push_back(record);
    json_["run"]["seconds"] = watch_.seconds();
    std::ofstream out(file_);
    out << json_.dump(1) << "\n";
    if (!out.flush()) throw std::runtime_error("cannot write " + file_);
  }

 private:
  std::string file_;
  WallStopwatch watch_;
  Json json_;
};

Effort effort_for(const Arguments& arguments) {
  Effort effort;
  if (arguments.quick) {
    effort.peer_seconds = 4;
    effort.full_seconds = 4;
    effort.most_quadrangles = 20'000;
    effort.least_seconds = 0.05;
    effort.enough_seconds = 0.1;
    effort.most_seconds = 0.5;
  }
  if (arguments.budget > 0) effort.peer_seconds = effort.full_seconds = arguments.budget;
  return effort;
}

void run_set(const std::string& set, const Arguments& arguments, const Effort& effort,
             const std::function<void(const Json&)>& take) {
  const auto data = minksum::test::data_path();
  if (set == "families") {
    measure_families(effort, arguments.quick ? 0.03 : 1.0, arguments.only, take);
  } else if (!data) {
    std::printf("  no folder of shapes: left out\n");
  } else if (set == "regret" || set == "mixed") {
    measure_unseen_pairs(set, *data, effort, arguments.unseen, arguments.only, take);
  } else if (set == "threads") {
    measure_threads(*data, effort, arguments.unseen, arguments.only, take);
  } else if (set == "doubles") {
    measure_doubles(*data, effort, arguments.quick, take);
  } else if (set == "outlines") {
    measure_outline_offsets(*data, effort, arguments.quick, arguments.only, take);
  } else if (set == "tables") {
    measure_nesting_tables(*data, effort, arguments.quick, arguments.only, take);
  } else {
    for (const Case& one : cases_of(set, *data, arguments.quick)) {
      if (one.name.find(arguments.only) != std::string::npos) take(measure(one, effort));
    }
    if (set == "nesting" && arguments.only.empty())
      take(measure_throughput(*data, arguments.quick ? 0.2 : 2));
  }
}

// A failure of a set becomes a record like any other.
void run(const Arguments& arguments) {
  const Effort effort = effort_for(arguments);
  Book book(arguments, effort);
  for (const std::string& set : set_names()) {
    if (!arguments.sets.empty() && !arguments.sets.contains(set)) continue;
    std::printf("%s\n", set.c_str());
    try {
      run_set(set, arguments, effort, [&](const Json& record) { book.take(record); });
    } catch (const std::exception& error) {
      book.take({{"set", set}, {"name", "the set"}, {"failures", {{"set", error.what()}}}});
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    run(parse({argv + 1, argv + argc}));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "minksum_bench: %s\n", error.what());
    return 1;
  }
}
