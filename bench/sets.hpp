// Which pairs are measured.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "measure.hpp"

namespace minksum::bench {

/// "paper", "figures", ...: what can be named on the command line, in the order they run.
[[nodiscard]] std::vector<std::string> set_names();
/// The pairs of a set of files of the data folder; a few of them with `quick`. Throws
/// std::runtime_error for an unknown set.
[[nodiscard]] std::vector<Case> cases_of(const std::string& set, const std::filesystem::path& data,
                                         bool quick);

/// The families with `only` in their names, doubling until a sum takes `longest_seconds`; each
/// record goes to `take` at once.
void measure_families(const Effort& effort, double longest_seconds, const std::string& only,
                      const std::function<void(const Json&)>& take);
/// Doubles against decimals of six digits, nearly the same shapes, in turn in one process.
void measure_doubles(const std::filesystem::path& data, const Effort& effort, bool quick,
                     const std::function<void(const Json&)>& take);
/// For each nesting instance with `only` in its name the whole table of its no-fit polygons, and a
/// sample of it by CGAL.
void measure_nesting_tables(const std::filesystem::path& data, const Effort& effort, bool quick,
                            const std::string& only, const std::function<void(const Json&)>& take);
/// Files of nesting parts without holes, of so many vertices, sorted by name.
[[nodiscard]] std::vector<std::string> nesting_parts(const std::filesystem::path& data,
                                                     std::size_t least, std::size_t most);
/// How many sums a second of pairs of nesting parts of about 30 vertices, by the wall clock.
[[nodiscard]] Json measure_throughput(const std::filesystem::path& data, double seconds);

}  // namespace minksum::bench
