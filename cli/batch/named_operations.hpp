// Operations by name, with options by name: what `minksum batch` runs.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "batch/in_order.hpp"
#include "minksum/cancel.hpp"
#include "minksum/geometry.hpp"
#include "minksum/resolve.hpp"
#include "options/limits.hpp"

namespace minksum::cli {

/// An option and how it is typed: "coords", {"--coords=exact"}; "tight", {"--tight"}.
struct OptionText {
  std::string name;
  std::vector<std::string> words;
  bool is_off = false;  ///< "tight": false; there are no words
};

/// An operation with its options, for any operands and any thread.
struct ReadyOperation {
  int operands = 2;  ///< of one, `run` does not look at b
  /// The members of a result, as JSON: `"result":...`. Throws Error.
  std::function<std::string(const Geometry& a, const Geometry& b,
                            const std::optional<CancelToken>& cancel, Worker& worker)>
      run;
  FillRule fill = FillRule::kAutomatic;  ///< how it reads operands
  io::ReadLimits limits;
  double seconds = 0;  ///< 0 = no limit
};

/// The operation by this name. Options are those of the subcommand of that name, but for those that
/// name files. `defaults` are options for operations that know them, unless `typed` says else.
/// Throws a Failure for wrong usage.
[[nodiscard]] ReadyOperation ready_operation(const std::string& name,
                                             const std::vector<OptionText>& typed,
                                             const std::vector<OptionText>& defaults,
                                             const ProcessLimits& limits);

/// The geometry, rounded already, as JSON: {"wkt":"..."}, or as GeoJSON.
[[nodiscard]] std::string geometry_json(const Geometry& geometry, io::Format format,
                                        const io::Coordinates& coordinates);

}  // namespace minksum::cli
