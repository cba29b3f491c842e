// Measures in a child process, so that a crash, a time limit or a memory limit ends only that.
#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

namespace minksum::bench {

using Json = nlohmann::ordered_json;

struct ChildLimits {
  double seconds_between_reports = 60;  ///< longest silence before the child is ended
  std::size_t address_space_bytes = std::size_t{8} << 30U;
};

/// Reports members of one JSON object while a child works; later ones replace earlier ones.
using Report = std::function<void(const Json& members)>;

/// The end of a child.
struct ChildEnd {
  std::string status;  ///< "ok", "over time", "over memory", "crashed", or an exception's words
  Json members = Json::object();  ///< all that the child reported, however it ended
};

/// Runs `work` in a child process with these limits and waits for its end.
[[nodiscard]] ChildEnd run_in_child(const ChildLimits& limits,
                                    const std::function<void(const Report&)>& work);

/// Sets the highest memory use of this process back to what it uses now, and returns that in bytes.
/// The reset works on Linux only.
std::size_t restart_peak_memory();
/// Returns the highest memory use of this process since then, in bytes.
[[nodiscard]] std::size_t peak_memory();

}  // namespace minksum::bench
