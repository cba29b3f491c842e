// minksum against CGAL's reduced convolution on the same polygons, in turn, in one process. Results
// are checked equal, exactly, before anything is timed.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "cgal_peer.hpp"
#include "minksum/io.hpp"
#include "minksum/minksum.hpp"
#include "oracle/cgal_oracle.hpp"
#include "support/data.hpp"

namespace {

using namespace minksum;

struct PairOfModels {
  const char* p;
  const char* q;
};
constexpr PairOfModels kDefaultPairs[] = {
    {"paper/bird.wkt", "paper/bird.wkt"},
    {"paper/nazca_monkey.wkt", "paper/nazca_monkey.wkt"},
    {"paper/mammoth.wkt", "paper/mammoth.wkt"},
    {"paper/wierd2.wkt", "paper/wierd2_n.wkt"},
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void measure(const std::string& p_path, const std::string& q_path) {
  const Region p = io::read_file(p_path);
  const Region q = io::read_file(q_path);
  Workspace workspace;
  Region sum;
  Statistics statistics;
  Options options;
  options.statistics = &statistics;
  (void)minkowski_sum(p, q, options, workspace, sum);
  if (!(sum == oracle::cgal_sum(p, q).sum)) {
    std::printf("%s + %s: results differ, not timed\n", p_path.c_str(), q_path.c_str());
    return;
  }
  bench::CgalPeer cgal(p, q);
  std::vector<double> ours;
  std::vector<double> theirs;
  for (int round = 0; round < 5; ++round) {
    theirs.push_back(cgal.run());
    for (int i = 0; i < 5; ++i) {
      (void)minkowski_sum(p, q, options, workspace, sum);
      ours.push_back(statistics.seconds);
    }
  }
  const double a = median(ours) * 1e3;
  const double b = median(theirs) * 1e3;
  std::printf("%-44s %9.3f ms %10.2f ms %8.0f x\n",
              (p_path.substr(p_path.rfind('/') + 1) + " + " + q_path.substr(q_path.rfind('/') + 1))
                  .c_str(),
              a, b, b / a);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    std::printf("%-44s %12s %13s %10s\n", "medians, one thread, exact, equal results", "minksum",
                oracle::cgal_version(), "ratio");
    if (argc == 3) {
      measure(argv[1], argv[2]);
      return 0;
    }
    const auto data = test::data_path();
    if (!data) {
      std::printf("no data folder: set MINKSUM_DATA, or name two WKT files\n");
      return 0;
    }
    for (const auto& [p, q] : kDefaultPairs) measure(*data / p, *data / q);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "versus_cgal: %s\n", error.what());
    return 1;
  }
}
