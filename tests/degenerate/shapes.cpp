#include "degenerate/shapes.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "minksum/testing.hpp"
#include "support/data.hpp"

namespace minksum::test {

std::optional<std::filesystem::path> degenerate_path() {
  const auto folder = data_path();
  if (!folder || !std::filesystem::is_directory(*folder / "degenerate")) return std::nullopt;
  return *folder / "degenerate";
}

std::vector<std::string> degenerate_names() {
  std::vector<std::string> names;
  const auto folder = degenerate_path();
  if (!folder) return names;
  for (const auto& entry : std::filesystem::directory_iterator(*folder)) {
    if (entry.path().extension() == ".wkt") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

Geometry read_shape(const std::string& name) {
  std::ifstream in(degenerate_path().value() / (name + ".wkt"));
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (text.find("EMPTY") != std::string::npos) return {};
  return {parse_wkt(text), {}, {}};
}

Geometry reduced_sum(const Geometry& p, const Geometry& q) {
  SumSettings options;
  options.check = true;
  return minkowski_sum(p, q, options);
}

Geometry signed_sum_of(const Geometry& p, const Geometry& q) {
  SumSettings options;
  options.method = Method::kSigned;
  return minkowski_sum(p, q, options);
}

}  // namespace minksum::test
