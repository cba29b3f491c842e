// Compares minksum with CGAL on every pair of the oracle: equal exactly, or one is proven wrong.
//
//   oracle_run [--results FILE] [--limit SECONDS] [--jobs N] [--only paper|cgal|nesting]
//
// Appends rows to FILE (default oracle.tsv) as they come. Pairs that the file has already are not
// run again, so a stopped run can resume. Ends with a summary. The exit code is 1 if anything
// speaks against minksum, and 2 if the folder of shapes is missing.
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <deque>
#include <exception>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "oracle/cgal_oracle.hpp"
#include "oracle/compare.hpp"
#include "oracle/pairs.hpp"
#include "support/data.hpp"

namespace {

using namespace minksum;
using namespace minksum::oracle;

constexpr std::size_t kPaperVertices = 2000;
constexpr std::size_t kNestingPairs = 2000;

struct Arguments {
  std::string results = "oracle.tsv";
  int limit = 60;
  std::size_t jobs = 2;
  std::string only;
};

Arguments read_arguments(int count, char** values) {
  Arguments arguments;
  for (int i = 1; i < count; i += 2) {
    const std::string name = values[i];
    if (i + 1 == count) throw std::runtime_error(name + " needs a value");
    const std::string value = values[i + 1];
    if (name == "--results") {
      arguments.results = value;
    } else if (name == "--limit") {
      arguments.limit = std::stoi(value);
    } else if (name == "--jobs") {
      arguments.jobs = static_cast<std::size_t>(std::max(1, std::stoi(value)));
    } else if (name == "--only") {
      arguments.only = value;
    } else {
      throw std::runtime_error("unknown option " + name);
    }
  }
  return arguments;
}

using Key = std::pair<std::string, std::string>;

class Runner {
 public:
  Runner(std::filesystem::path data, Arguments arguments)
      : data_(std::move(data)), arguments_(std::move(arguments)) {
    if (std::filesystem::exists(arguments_.results)) {
      for (auto& row : test::read_table(arguments_.results)) done_.insert({row["A"], row["B"]});
      out_.open(arguments_.results, std::ios::app);
    } else {
      out_.open(arguments_.results);
      out_ << "set\tA\tB\tverdict\tminksum_seconds\tcgal_seconds\tvertices\tholes\tdetail\n";
    }
    if (!out_) throw std::runtime_error("cannot write " + arguments_.results);
  }

  void run(const std::vector<PairName>& pairs) {
    for (const PairName& pair : pairs) {
      if (!done_.insert({pair.a, pair.b}).second) continue;
      if (running_.size() == arguments_.jobs) finish_one();
      out_.flush();
      running_.push_back(
          {pair, std::make_unique<Child>(region(pair.a), region(pair.b), arguments_.limit)});
    }
    while (!running_.empty()) finish_one();
    out_.flush();
  }

 private:
  struct Running {
    PairName pair;
    std::unique_ptr<Child> child;
  };

  const Region& region(const std::string& name) {
    const auto [it, is_new] = regions_.try_emplace(name);
    if (is_new) it->second = test::read_wkt(data_ / name);
    return it->second;
  }

  void finish_one() {
    const Running oldest = std::move(running_.front());
    running_.pop_front();
    const Comparison c = oldest.child->wait();
    out_ << oldest.pair.set << '\t' << oldest.pair.a << '\t' << oldest.pair.b << '\t'
         << to_string(c.verdict) << '\t' << c.minksum_seconds << '\t' << c.cgal_seconds << '\t'
         << c.vertices << '\t' << c.holes << '\t' << c.detail << '\n';
    if (c.verdict != Verdict::kEqual) {
      std::cout << oldest.pair.a << " + " << oldest.pair.b << ": " << to_string(c.verdict) << ". "
                << c.detail << std::endl;
    }
  }

  std::filesystem::path data_;
  Arguments arguments_;
  std::set<Key> done_;
  std::ofstream out_;
  std::map<std::string, Region> regions_;
  std::deque<Running> running_;
};

// Counts all rows of the results by set and verdict. Returns whether none speaks against minksum.
bool summarise(const std::string& results) {
  std::map<Key, std::size_t> counts;
  double ours = 0;
  double theirs = 0;
  bool good = true;
  for (auto& row : test::read_table(results)) {
    ++counts[{row["set"], row["verdict"]}];
    const auto verdict = parse_verdict(row["verdict"]);
    good &= verdict.has_value() && !is_failure(*verdict);
    if (verdict != Verdict::kEqual) continue;
    ours += std::stod(row["minksum_seconds"]);
    theirs += std::stod(row["cgal_seconds"]);
  }
  std::cout << "\n" << cgal_version() << "\n";
  for (const auto& [key, count] : counts) {
    std::cout << key.first << "\t" << key.second << "\t" << count << "\n";
  }
  std::cout << "where equal: minksum " << ours << " s, CGAL " << theirs << " s in all\n"
            << (good ? "nothing" : "SOMETHING") << " speaks against minksum; rows in " << results
            << std::endl;
  return good;
}

int run(int count, char** values) {
  const Arguments arguments = read_arguments(count, values);
  const auto data = test::data_path();
  if (!data) return 2;
  {
    Runner runner(*data, arguments);
    const auto wanted = [&](const char* set) {
      return arguments.only.empty() || arguments.only == set;
    };
    if (wanted("cgal")) runner.run(cgal_pairs(*data));
    if (wanted("nesting")) runner.run(nesting_pairs(*data, kNestingPairs));
    if (wanted("paper")) runner.run(paper_pairs(*data, kPaperVertices));
  }
  return summarise(arguments.results) ? 0 : 1;
}

}  // namespace

int main(int count, char** values) {
  try {
    return run(count, values);
  } catch (const std::exception& error) {
    std::cerr << "oracle_run: " << error.what() << '\n';
    return 1;
  }
}
