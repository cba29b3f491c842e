// Failures in one line: which file, where in it, what.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

#include "commands/commands.hpp"
#include "minksum/error.hpp"
#include "minksum/resolve.hpp"

namespace minksum::cli {

/// A failure that is ready to be told: the line and the exit code.
class Failure : public std::runtime_error {
 public:
  Failure(ExitCode code, const std::string& line) : std::runtime_error(line), code_(code) {}
  [[nodiscard]] ExitCode code() const noexcept { return code_; }

 private:
  ExitCode code_;
};

/// "polygon 1, ring 2, vertex 3", as far as it is known; all count from 1, ring 1 is the outer one.
[[nodiscard]] std::string describe(const Culprit& place);

/// "standard input" for "-".
[[nodiscard]] std::string shown_name(const std::string& file);

/// Tells on standard error, in one line, what is no failure.
void tell(const std::string& message);

/// Handles `error`, the exception being handled, of what is made for an output: throws a Failure
/// that names the output if numbers are beyond the range of doubles, else the exception itself.
[[noreturn]] void fail_about_output(const Error& error, const std::string& output);

/// The failure that `error` is, if it came about while reading or using `file`.
[[nodiscard]] Failure failure_of(const Error& error, const std::string& file);

/// Throws what `error`, raised by an operation on two operands, is: a Failure that names the file
/// of the operand that it is about, or std::bad_alloc.
[[noreturn]] void fail_about(const Error& error, const std::string (&operands)[2]);

/// What `make` returns, which is made for an output (empty or "-": standard output): if that has no
/// room for the numbers, a Failure that names it is thrown.
template <class Make>
auto made_for(const std::string& output, Make make) {
  try {
    return make();
  } catch (const Error& error) {
    fail_about_output(error, output);
  }
}

/// An operand as a file gives it.
struct ReadOperand {
  Geometry geometry;
  std::optional<std::string> properties;  ///< see io::feature_properties
};
/// Reads an operand; what goes wrong is thrown as a Failure that names the file.
[[nodiscard]] ReadOperand read_operand(const std::string& file, const io::ReadLimits& limits);
/// The same for an operand that is going to be read by this rule. Tells on standard error if its
/// polygons are not valid, and how they are read then.
[[nodiscard]] ReadOperand read_operand(const std::string& file, const io::ReadLimits& limits,
                                       FillRule fill);

/// Why polygons are not valid and how they are read by this rule; nothing if they are valid, or if
/// the rule refuses them.
[[nodiscard]] std::optional<std::string> reading_of_faults(
    const Region& region, FillRule fill, const std::optional<CancelToken>& cancel = {});

/// Tells the exception being handled on standard error, in one line; returns the exit code.
/// Needs no memory to say that there is none; `memory_limit` in bytes, if there is one.
int report_failure(std::optional<std::uint64_t> memory_limit) noexcept;

}  // namespace minksum::cli
