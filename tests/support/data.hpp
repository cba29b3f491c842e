// Reads the folder of real shapes, which tests use if it exists.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "minksum/region.hpp"

namespace minksum::test {

/// Returns the folder named by the environment variable MINKSUM_DATA, or ../shared/data beside the
/// source tree. Without a folder it returns nothing, and writes a line on stderr once.
[[nodiscard]] std::optional<std::filesystem::path> data_path();

/// A row of the folder's MANIFEST.tsv.
struct DataFile {
  std::string name;  ///< "paper/bird.wkt"
  std::size_t vertices = 0;
  std::size_t holes = 0;
  std::size_t parts = 0;
  bool is_valid = false;
};
[[nodiscard]] std::vector<DataFile> read_manifest(const std::filesystem::path& folder);

/// Returns the rows of a file with tabs, each a map from the heading to the value.
[[nodiscard]] std::vector<std::map<std::string, std::string>> read_table(
    const std::filesystem::path& file);

/// Reads a POLYGON or MULTIPOLYGON with exact numbers, and drops closing vertices. This strict
/// reader is independent of the library's, and throws std::runtime_error.
[[nodiscard]] Region read_wkt(const std::filesystem::path& file);
[[nodiscard]] Region parse_wkt(const std::string& text);

}  // namespace minksum::test
