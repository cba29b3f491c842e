// Chooses the pairs that are measured.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "measure.hpp"

namespace minksum::bench {

/// Returns the names for the command line, such as "paper" and "figures", in the order in which the
/// sets run.
[[nodiscard]] std::vector<std::string> set_names();
/// Returns the pairs of a set of files of the data folder, or only a few with `quick`. Throws
/// std::runtime_error for an unknown set.
[[nodiscard]] std::vector<Case> cases_of(const std::string& set, const std::filesystem::path& data,
                                         bool quick);

/// Which random pairs are measured.
struct UnseenPairs {
  std::uint64_t seed = 1;
  std::size_t count = 0;  ///< 0 = 200, or 20 in a quick run
  bool cgal = true;       ///< whether CGAL is measured beside minksum
};
/// Measures regret: the time of the automatic settings, divided by the least time of any settings.
/// The set "regret" is a list of pairs in the data folder. The set "mixed" has random pairs of all
/// valid files, and measures CGAL beside them. A record for all pairs comes last.
void measure_unseen_pairs(const std::string& set, const std::filesystem::path& data,
                          const Effort& effort, const UnseenPairs& asked, const std::string& only,
                          const std::function<void(const Json&)>& take);
/// Measures how many times as fast all cores are as one thread, by the wall clock. It takes those
/// pairs of the sets "regret" and "mixed" whose sums take 50 ms or more on one thread, with
/// operands prepared. A record for all pairs comes last.
void measure_threads(const std::filesystem::path& data, const Effort& effort,
                     const UnseenPairs& asked, const std::string& only,
                     const std::function<void(const Json&)>& take);
/// Measures the families with `only` in their names, and doubles sizes until a sum takes
/// `longest_seconds`. Each record goes to `take` at once.
void measure_families(const Effort& effort, double longest_seconds, const std::string& only,
                      const std::function<void(const Json&)>& take);
/// Measures doubles against decimals of six digits on nearly the same shapes, in turn in one
/// process.
void measure_doubles(const std::filesystem::path& data, const Effort& effort, bool quick,
                     const std::function<void(const Json&)>& take);
/// Measures the table of no-fit polygons of each nesting instance with `only` in its name, and a
/// sample of the table by CGAL.
void measure_nesting_tables(const std::filesystem::path& data, const Effort& effort, bool quick,
                            const std::string& only, const std::function<void(const Json&)>& take);
/// Measures offsets of outlines with `only` in their names, in turn with GEOS's buffer.
void measure_outline_offsets(const std::filesystem::path& data, const Effort& effort, bool quick,
                             const std::string& only, const std::function<void(const Json&)>& take);
/// Returns files of nesting parts without holes and of so many vertices, sorted by name.
[[nodiscard]] std::vector<std::string> nesting_parts(const std::filesystem::path& data,
                                                     std::size_t least, std::size_t most);
/// Measures sums a second of pairs of nesting parts of about 30 vertices, by the wall clock.
[[nodiscard]] Json measure_throughput(const std::filesystem::path& data, double seconds);

}  // namespace minksum::bench
