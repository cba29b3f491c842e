// Runs one line of a file of jobs.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "batch/in_order.hpp"
#include "commands/batch.hpp"
#include "process/watchdog.hpp"

namespace minksum::cli {

/// A line of a file of jobs.
struct JobLine {
  std::uint64_t number = 0;   ///< number of the line, from 1
  std::string text;           ///< the line without its end
  std::uint64_t dropped = 0;  ///< bytes beyond the limit, missing in `text`
};

/// Computes 64 bits, shown in hexadecimal, that tell texts from each other (FNV-1a). They do not
/// withstand an adversary.
class Digest {
 public:
  Digest& add(std::string_view text);  ///< adds the text and its length
  [[nodiscard]] std::string text() const;

 private:
  std::uint64_t value_ = 0xcbf29ce484222325;
};

/// Returns the digest of the settings that results depend on.
[[nodiscard]] Digest digest_of_settings(const BatchArguments& arguments);

/// Returns how the line of a result begins: `{"job":7,"digest":"..."`.
[[nodiscard]] std::string result_head(std::uint64_t job, const std::string& digest);
/// Returns whether a line of an earlier run is whole and begins with `head`. If so, `failed` tells
/// whether the job failed.
[[nodiscard]] bool is_result(std::string_view line, const std::string& head, bool& failed);

/// Returns whether the text begins like the result of some job, or ends before that can be told.
/// The text of a whole line includes its '\n'.
[[nodiscard]] bool is_any_result(std::string_view line);
/// Returns whether the text may be the beginning of the result with this head.
[[nodiscard]] bool may_begin(std::string_view line, const std::string& head);

/// Returns `"error":{"code":...,"message":...}` for the exception being handled.
[[nodiscard]] std::string error_json(double seconds);

/// Runs jobs; all threads share one.
class JobRunner {
 public:
  explicit JobRunner(const BatchArguments& arguments);
  [[nodiscard]] std::string head(const JobLine& line) const;
  /// Returns the line of the job's result. If the job fails, the line has the error.
  [[nodiscard]] Done run(const JobLine& line, Worker& worker);

 private:
  const BatchArguments& arguments_;
  std::string folder_;  ///< the folder to which paths in jobs are relative
  Digest settings_;
  Watchdog watchdog_;
};

}  // namespace minksum::cli
