#include "oracle/pairs.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "support/data.hpp"
#include "support/random.hpp"

namespace minksum::oracle {
namespace {

std::vector<std::string> usable(const std::filesystem::path& data, const std::string& folder,
                                std::size_t max_vertices) {
  std::vector<std::string> names;
  for (const auto& file : test::read_manifest(data)) {
    if (file.name.starts_with(folder + "/") && file.is_valid && file.parts == 1 &&
        file.vertices <= max_vertices) {
      names.push_back(file.name);
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

std::vector<PairName> paper_pairs(const std::filesystem::path& data, std::size_t max_vertices) {
  const std::vector<std::string> names = usable(data, "paper", max_vertices);
  std::vector<PairName> pairs;
  for (std::size_t i = 0; i < names.size(); ++i) {
    for (std::size_t j = i; j < names.size(); ++j) pairs.push_back({"paper", names[i], names[j]});
  }
  return pairs;
}

std::vector<PairName> cgal_pairs(const std::filesystem::path& data) {
  std::vector<PairName> pairs;
  for (auto& row : test::read_table(data / "cgal" / "pairs.tsv")) {
    if (row["available"] == "yes") {
      pairs.push_back({"cgal", "cgal/" + row["A"], "cgal/" + row["B"]});
    }
  }
  return pairs;
}

std::vector<PairName> nesting_pairs(const std::filesystem::path& data, std::size_t count) {
  const std::vector<std::string> names = usable(data, "nesting", static_cast<std::size_t>(-1));
  const std::size_t possible = names.size() * (names.size() + 1) / 2;
  const auto size = static_cast<int>(names.size());
  test::Random random(2012);
  std::set<std::pair<int, int>> chosen;
  std::vector<PairName> pairs;
  while (pairs.size() < std::min(count, possible)) {
    const int i = random.below(size);
    const int j = random.below(size);
    if (!chosen.insert(std::minmax(i, j)).second) continue;
    pairs.push_back(
        {"nesting", names[static_cast<std::size_t>(i)], names[static_cast<std::size_t>(j)]});
  }
  return pairs;
}

}  // namespace minksum::oracle
