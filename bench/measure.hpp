// Measures one pair of operands: minksum alone, its counts, and minksum in turn with each peer.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "child.hpp"
#include "families.hpp"
#include "minksum/minkowski_sum.hpp"
#include "minksum/testing.hpp"

namespace minksum::bench {

/// One pair, with what is to be measured of it.
struct Case {
  std::string set;
  std::string name;
  /// Loads the operands. Only child processes call this, so that this process stays small.
  std::function<Operands()> load;
  Json about = Json::object();  ///< further members of the record

  bool listing = true;          ///< time the mere listing of the convolution too
  bool cgal = true;             ///< measure against CGAL's reduced convolution
  bool cgal_full = false;       ///< measure against CGAL's full convolution
  bool clipper = false;         ///< measure Clipper, if the operands are small enough
  double geos_radius = 0;       ///< radius of the 32-gon Q, for GEOS's buffer; 0 = no GEOS
  bool count_no_cover = false;  ///< count crossings of the whole reduced convolution
  bool count_full = false;      ///< count crossings of the full convolution
  double cgal_seconds = 0;      ///< longest time for one sum by CGAL; 0 = the default
  std::size_t cgal_bytes = std::size_t{8} << 30U;  ///< the most memory that CGAL may take
};

struct Effort {
  double peer_seconds = 60;     ///< longest time for one sum by a peer
  double full_seconds = 20;     ///< longest time for one sum by a full convolution
  double least_seconds = 0.3;   ///< minksum is repeated for this long at least,
  int most_runs = 200;          ///< but not more often than this
  double block_seconds = 0.02;  ///< a peer and minksum take turns of at least this long,
  double enough_seconds = 0.5;  ///< until the peer took this long in three runs or more,
  double most_seconds = 3;      ///< or this long; Clipper and CGAL's full convolution, which are
                                ///< far behind the reduced one, need one run only
  /// Clipper unites a quadrangle for each pair of edges, and is not tried beyond so many.
  std::size_t most_quadrangles = 100'000;
};

/// Runs minksum with memory that is reused, and times it from outside, without statistics. Separate
/// runs time its stages, unless a run is so long that statistics do not matter.
class MinksumRuns {
 public:
  explicit MinksumRuns(SumSettings options = {});
  /// Does one more run, which counts, and returns its seconds. Throws what the sum throws.
  double run(const Region& p, const Region& q);
  /// Repeats runs for at least the time that `effort` asks for.
  void repeat(const Region& p, const Region& q, const Effort& effort);
  [[nodiscard]] const Region& sum() const { return sum_; }
  [[nodiscard]] const Statistics& statistics() const { return statistics_; }
  /// Returns the number of runs, median, min, max, and the medians of the stages.
  [[nodiscard]] Json json() const;
  void forget() {
    runs_.clear();
    staged_.clear();
  }

 private:
  double timed(const Region& p, const Region& q);
  double timed_by_stages(const Region& p, const Region& q);

  SumSettings options_;
  Workspace workspace_;
  Region sum_;
  Statistics statistics_;
  std::vector<double> runs_;
  std::vector<Statistics> staged_;
};

[[nodiscard]] double median(std::vector<double> values);
/// Returns the number of runs, median, min and max.
[[nodiscard]] Json summary(const std::vector<double>& seconds);

/// Returns the record of one case, whose members docs/benchmarks.md explains. If CGAL can judge the
/// pair, the results are compared first, and nothing is timed if they differ.
[[nodiscard]] Json measure(const Case& one, const Effort& effort);

/// Runs `work` in a child, whose reports go to the record. If the child fails, `failures` gets the
/// reason, and `given_up` gets the seconds that the child had.
void run_part(const char* name, const ChildLimits& limits, Json& record,
              const std::function<void(const Report&)>& work);
/// Adds `equal_to_cgal` to the record if CGAL is available and takes these operands. If the two
/// differ, `make oracle` finds out which is wrong.
void compare_with_cgal(const Case& one, const Effort& effort, Json& record);
/// Adds the measures of peers to the record.
void add_peers(const Case& one, const Effort& effort, Json& record);

}  // namespace minksum::bench
