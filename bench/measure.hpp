// Measuring one pair of operands: minksum alone, its counts, and minksum and each peer in turn.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "child.hpp"
#include "families.hpp"
#include "minksum/minkowski_sum.hpp"

namespace minksum::bench {

/// One pair and what is to be measured of it.
struct Case {
  std::string set;
  std::string name;
  /// Called in child processes only, so that this one stays small.
  std::function<Operands()> load;
  Json about = Json::object();  ///< further members of the record

  bool listing = true;          ///< time the mere listing of the convolution too
  bool cgal = true;             ///< measure against CGAL's reduced convolution
  bool cgal_full = false;       ///< against its full convolution
  bool clipper = false;         ///< where the operands are small enough for it
  double geos_radius = 0;       ///< Q is a 32-gon of this radius: against GEOS's buffer; 0 = not
  bool count_no_cover = false;  ///< count crossings of the whole reduced convolution
  bool count_full = false;      ///< and of the full one
  double cgal_seconds = 0;      ///< longest time for one sum by CGAL; 0 = the default
  std::size_t cgal_bytes = std::size_t{8} << 30U;  ///< the most memory that CGAL may take
};

struct Effort {
  double peer_seconds = 60;     ///< longest time for one sum by a peer,
  double full_seconds = 20;     ///< by a full convolution
  double least_seconds = 0.3;   ///< minksum is repeated at least this long, or until
  int most_runs = 200;          ///< it ran this often
  double block_seconds = 0.02;  ///< a peer and minksum take turns of at least this long,
  double enough_seconds = 0.5;  ///< until the peer took this long in three runs or more,
  double most_seconds = 3;      ///< or this long; one run will do of what is far behind CGAL's
                                ///< reduced convolution: its full one, and Clipper
  /// Clipper makes a quadrangle for each pair of edges and unites them: not tried beyond so many.
  std::size_t most_quadrangles = 100'000;
};

/// minksum with memory that is reused: timed from outside, without statistics; what its stages take
/// is told by runs of their own, unless a run is so long that statistics do not matter.
class MinksumRuns {
 public:
  explicit MinksumRuns(Options options = {});
  /// One more run, counted. Throws what went wrong.
  double run(const Region& p, const Region& q);
  /// For at least so long.
  void repeat(const Region& p, const Region& q, const Effort& effort);
  [[nodiscard]] const Region& sum() const { return sum_; }
  [[nodiscard]] const Statistics& statistics() const { return statistics_; }
  /// Runs, median, min, max and medians of the stages.
  [[nodiscard]] Json json() const;
  void forget() {
    runs_.clear();
    staged_.clear();
  }

 private:
  double timed(const Region& p, const Region& q, Statistics* statistics);

  Options options_;
  Workspace workspace_;
  Region sum_;
  Statistics statistics_;
  std::vector<double> runs_;
  std::vector<Statistics> staged_;
};

[[nodiscard]] double median(std::vector<double> values);
/// Runs, median, min, max.
[[nodiscard]] Json summary(const std::vector<double>& seconds);

/// The record of one case: docs/benchmarks.md explains its members. Where CGAL can judge the pair,
/// the results are compared first, and nothing is timed if they differ.
[[nodiscard]] Json measure(const Case& one, const Effort& effort);

/// Runs `work` in a child; what it reports goes to the record, and how it failed, if it did: to
/// `failures`, and to `given_up` the seconds that it was given.
void run_part(const char* name, const ChildLimits& limits, Json& record,
              const std::function<void(const Report&)>& work);
/// Adds `equal_to_cgal` to the record, if CGAL is there and takes these operands. Which of the two
/// is wrong if they differ, `make oracle` finds out.
void compare_with_cgal(const Case& one, const Effort& effort, Json& record);
/// Adds the parts of the record that peers give.
void add_peers(const Case& one, const Effort& effort, Json& record);

}  // namespace minksum::bench
