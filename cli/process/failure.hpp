// Reports failures in one line: the file, the place in it, and the reason. Reads operands, so that
// failures of reading name the file.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "commands/commands.hpp"
#include "minksum/error.hpp"
#include "minksum/io.hpp"
#include "minksum/resolve.hpp"

namespace minksum::cli {

/// A failure as the user sees it: the line and the exit code.
class Failure : public std::runtime_error {
 public:
  Failure(ExitCode code, const std::string& line) : std::runtime_error(line), code_(code) {}
  [[nodiscard]] ExitCode code() const noexcept { return code_; }

 private:
  ExitCode code_;
};

/// Returns a text such as "polygon 1, ring 2, vertex 3", without what is unknown. All numbers count
/// from 1, and ring 1 is the outer ring.
[[nodiscard]] std::string describe(const Culprit& place);

/// Returns the name of a file for messages: "standard input" for "-", else the path.
[[nodiscard]] std::string shown_name(const std::string& file);

/// Writes a message to standard error, in one line.
void tell(const std::string& message);

/// Throws a Failure that names the output if `error` says that numbers exceed the range of doubles.
/// Otherwise rethrows `error`, which must be the exception being handled.
[[noreturn]] void fail_about_output(const Error& error, const std::string& output);

/// Returns `error` as a failure of reading or using `file`.
[[nodiscard]] Failure failure_of(const Error& error, const std::string& file);

/// Throws what `error` of an operation on two operands means: a Failure that names the file of its
/// operand, or `other` if it is about none, or std::bad_alloc.
[[noreturn]] void fail_about(const Error& error, const std::string (&operands)[2],
                             const std::string& other = "");

/// Returns what `make` makes for an output, which is standard output if it is empty or "-". Throws
/// a Failure that names the output if numbers exceed the range of doubles.
template <class Make>
auto made_for(const std::string& output, Make make) {
  try {
    return make();
  } catch (const Error& error) {
    fail_about_output(error, output);
  }
}

/// Reads an operand. Throws a Failure that names the file. Notes on standard error are those of
/// `notes_on`.
[[nodiscard]] io::Document read_operand(const std::string& file, const io::ReadOptions& limits);
/// Does the same for an operand that will be resolved by this rule. If its polygons are not valid,
/// a note on standard error says how they are read.
[[nodiscard]] io::Document read_operand(const std::string& file, const io::ReadOptions& limits,
                                        FillRule fill);

/// Returns what is told about an operand: its unit, what was not read of it, and how many features
/// have no shape.
[[nodiscard]] std::vector<std::string> notes_on(const io::SourceInfo& source);

/// Returns why the polygons are not valid and how this rule reads them. Returns nothing if they are
/// valid or if the rule refuses them.
[[nodiscard]] std::optional<std::string> reading_of_faults(
    const Region& region, FillRule fill, const std::optional<CancelToken>& cancel = {});

/// Returns the exception being handled as a failure. Throws std::bad_alloc for lack of memory.
[[nodiscard]] Failure current_failure();
/// Reports the exception being handled on standard error, in one line; returns the exit code.
/// A report of lack of memory needs no memory; it names `memory_limit`, in bytes, if there is one.
int report_failure(std::optional<std::uint64_t> memory_limit) noexcept;

}  // namespace minksum::cli
