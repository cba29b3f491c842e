// Errors of the library: typed, and each names what caused it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "minksum/export.h"

namespace minksum {

/// What kind of failure an Error reports. The program's exit codes follow these.
enum class ErrorCode {
  kBadInput,       ///< an operand is not a valid region, or a number is not finite
  kLimitExceeded,  ///< a stated limit (see Limits) would be exceeded
  kCancelled,      ///< the caller's cancel token or progress callback said stop
  kInternal,       ///< an invariant of the library broke; Error::stage names the place
};

/// Which operand of a binary operation.
enum class Operand : unsigned char {
  kFirst = 0,   ///< P of a sum P ⊕ Q
  kSecond = 1,  ///< Q
};

/// The place in an operand that an error is about. Indices count from 0; `kNone` = not known.
struct Culprit {
  /// An index that is not known.
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  /// 0 = first, 1 = second, -1 = not about an operand. Functions of more than two say what 2,
  /// 3, ... are: a workspace, a start, a goal. Where shapes are given as a list, it is
  /// the index there.
  int operand = -1;
  std::size_t polygon = kNone;  ///< index of the polygon in its region
  std::size_t ring = kNone;     ///< index of the ring in its polygon: 0 = outer, 1.. = holes
  std::size_t vertex = kNone;   ///< index of the vertex in its ring
};

/// A limit that was passed and that the caller can do something about.
struct ExceededLimit {
  /// Its name in this interface, such as "Limits::max_segments". Also "memory"; "doubles" for a
  /// coordinate that is to be written as a double and is beyond their range (adaptors: "floats" and
  /// "integers", too); and "pictures" for one that is to be drawn.
  std::string_view name;
  std::uint64_t value = 0;  ///< what was allowed; 0 if that is no count
};

/// What the library throws, but for std::bad_alloc where memory runs out; io::ReadError is one too.
class MINKSUM_API Error : public std::runtime_error {
 public:
  /// What went wrong, in words and as what the functions below give.
  Error(ErrorCode code, const std::string& message, Culprit culprit = {}, std::string stage = {},
        const std::optional<ExceededLimit>& limit = {})
      : std::runtime_error(message),
        code_(code),
        culprit_(culprit),
        stage_(std::move(stage)),
        limit_(limit) {}

  /// What kind of failure it is.
  [[nodiscard]] ErrorCode code() const noexcept { return code_; }
  /// The place in an operand that caused it, as far as one did.
  [[nodiscard]] const Culprit& culprit() const noexcept { return culprit_; }
  /// The limit, for kLimitExceeded; nothing where the caller can do nothing about it.
  [[nodiscard]] const std::optional<ExceededLimit>& limit() const noexcept { return limit_; }
  /// The pipeline stage, for internal errors; empty otherwise.
  [[nodiscard]] const std::string& stage() const noexcept { return stage_; }

 private:
  ErrorCode code_;
  Culprit culprit_;
  std::string stage_;
  std::optional<ExceededLimit> limit_;
};

/// How a call without exceptions ended. `error` is there unless it went well.
struct [[nodiscard]] Outcome {
  std::optional<Error> error;  ///< what an exception would have been
  /// Whether it went well.
  [[nodiscard]] bool ok() const { return !error.has_value(); }
};

/// Runs `operation` and says how it ended, instead of an exception: an Error as it was thrown, and
/// kLimitExceeded where memory ran out. Every operation of the library can be called so:
///
///     Geometry grown;
///     const Outcome outcome = attempt([&] { grown = offset(plate, 1); });
template <class Operation>
Outcome attempt(Operation&& operation) {
  try {
    std::forward<Operation>(operation)();
    return {};
  } catch (const Error& error) {
    return {error};
  } catch (const std::bad_alloc&) {
    return {Error(ErrorCode::kLimitExceeded, "out of memory", {}, {}, ExceededLimit{"memory"})};
  }
}

}  // namespace minksum
