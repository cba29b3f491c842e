// One line of a file of jobs: what it asks for, done.
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
  std::uint64_t number = 0;   ///< of the line, from 1
  std::string text;           ///< without its end
  std::uint64_t dropped = 0;  ///< bytes beyond the limit, which are not in `text`
};

/// 64 bits in hexadecimal that tell texts from each other (FNV-1a): not against an adversary.
class Digest {
 public:
  Digest& add(std::string_view text);  ///< with its length
  [[nodiscard]] std::string text() const;

 private:
  std::uint64_t value_ = 0xcbf29ce484222325;
};

/// The settings that results depend on, for digests.
[[nodiscard]] Digest digest_of_settings(const BatchArguments& arguments);

/// How the line of a result begins: `{"job":7,"digest":"..."`.
[[nodiscard]] std::string result_head(std::uint64_t job, const std::string& digest);
/// Whether the line that an earlier run has written is whole and begins so; if it is, `failed` says
/// whether the job has failed.
[[nodiscard]] bool is_result(std::string_view line, const std::string& head, bool& failed);

/// Whether the text begins as the result of any job does, or ends before that can be told. A whole
/// line has its end, '\n'.
[[nodiscard]] bool is_any_result(std::string_view line);
/// Whether it begins as the result with this head does.
[[nodiscard]] bool may_begin(std::string_view line, const std::string& head);

/// `"error":{"code":...,"message":...}` for the exception being handled.
[[nodiscard]] std::string error_json(double seconds);

/// Does jobs; one for all threads.
class JobRunner {
 public:
  explicit JobRunner(const BatchArguments& arguments);
  [[nodiscard]] std::string head(const JobLine& line) const;
  /// The line of its result. Whatever goes wrong is told there.
  [[nodiscard]] Done run(const JobLine& line, Worker& worker);

 private:
  const BatchArguments& arguments_;
  std::string folder_;  ///< paths are relative to it
  Digest settings_;
  Watchdog watchdog_;
};

}  // namespace minksum::cli
