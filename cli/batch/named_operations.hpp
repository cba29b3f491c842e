// Makes the operations that `minksum batch` runs, from their names and those of their options.
#pragma once

#include <atomic>
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

/// An option with the words that one would type: "coords", {"--coords=exact"}, or "tight",
/// {"--tight"}.
struct OptionText {
  std::string name;
  std::vector<std::string> words;
  bool is_off = false;  ///< set for `"tight": false`, which has no words
  /// Whether a job takes it, for an option that holds for all jobs.
  std::shared_ptr<std::atomic<bool>> is_taken = {};
};

/// An operation with its options, ready for any operands and any thread.
struct ReadyOperation {
  int operands = 2;  ///< if 1, `run` ignores b
  /// Returns the members of a result as JSON: `"result":...`. Throws Error.
  std::function<std::string(const Geometry& a, const Geometry& b,
                            const std::optional<CancelToken>& cancel, Worker& worker)>
      run;
  FillRule fill = FillRule::kAutomatic;  ///< the rule by which operands are read
  std::string note;  ///< says how the operation differs from what was asked for; may be empty
  io::ReadOptions limits;
  double seconds = 0;  ///< 0 = no limit
};

/// Returns the operation of this name. It takes the options of the subcommand of that name, except
/// those that name files. Options of `defaults` apply where the operation has them and `typed` does
/// not set them. Throws a Failure for wrong usage.
[[nodiscard]] ReadyOperation ready_operation(const std::string& name,
                                             const std::vector<OptionText>& typed,
                                             const std::vector<OptionText>& defaults,
                                             const ProcessLimits& limits);

/// Returns a geometry as JSON: {"wkt":"..."}, or GeoJSON. The geometry must be rounded already.
[[nodiscard]] std::string geometry_json(const Geometry& geometry, io::Format format,
                                        const io::Coordinates& coordinates);

}  // namespace minksum::cli
