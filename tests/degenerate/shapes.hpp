// Reads the shapes of data/degenerate, and sums them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "minksum/geometry.hpp"
#include "minksum/minkowski_sum.hpp"

namespace minksum::test {

/// Returns the folder, or nothing if it does not exist.
[[nodiscard]] std::optional<std::filesystem::path> degenerate_path();
/// Returns the names of all shapes, sorted, without ".wkt".
[[nodiscard]] std::vector<std::string> degenerate_names();
/// Returns a shape as it is written, with rings of any kind. Numbers are read exactly.
[[nodiscard]] Geometry read_shape(const std::string& name);

/// Returns P ⊕ Q by the reduced method, whose checkers run.
[[nodiscard]] Geometry reduced_sum(const Geometry& p, const Geometry& q);
[[nodiscard]] Geometry signed_sum_of(const Geometry& p, const Geometry& q);

}  // namespace minksum::test
