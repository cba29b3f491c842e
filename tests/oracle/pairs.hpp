// Chooses the pairs that the oracle sums.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace minksum::oracle {

struct PairName {
  std::string set;  ///< "paper", "cgal", "nesting"
  std::string a;    ///< file below the data folder
  std::string b;
};

/// Returns every unordered pair, with repetition, of the valid single polygons of paper/ that have
/// at most `max_vertices` vertices.
[[nodiscard]] std::vector<PairName> paper_pairs(const std::filesystem::path& data,
                                                std::size_t max_vertices);
/// Returns the pairs of cgal/pairs.tsv whose files exist.
[[nodiscard]] std::vector<PairName> cgal_pairs(const std::filesystem::path& data);
/// Returns `count` different pairs of valid parts of nesting/, the same ones each time.
[[nodiscard]] std::vector<PairName> nesting_pairs(const std::filesystem::path& data,
                                                  std::size_t count);

}  // namespace minksum::oracle
