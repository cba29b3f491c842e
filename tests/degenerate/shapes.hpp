// The shapes of data/degenerate.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "minksum/geometry.hpp"
#include "minksum/minkowski_sum.hpp"

namespace minksum::test {

/// The folder; nothing if there is none.
[[nodiscard]] std::optional<std::filesystem::path> degenerate_path();
/// The names of all shapes, sorted, without ".wkt".
[[nodiscard]] std::vector<std::string> degenerate_names();
/// A shape as it is written: rings of any kind. Numbers are read exactly.
[[nodiscard]] Geometry read_shape(const std::string& name);

/// P ⊕ Q by the reduced method, whose checkers run.
[[nodiscard]] Geometry reduced_sum(const Geometry& p, const Geometry& q);
[[nodiscard]] Geometry signed_sum_of(const Geometry& p, const Geometry& q);

}  // namespace minksum::test
