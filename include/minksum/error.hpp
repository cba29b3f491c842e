// Declares the errors of the library. Each has a code and names what caused it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "minksum/export.h"

namespace minksum {

/// Says which kind of failure an Error reports. Each code has an exit code of the program.
enum class ErrorCode {
  /// An operand is not a valid region, a number is not finite, or an option is an integer that was
  /// cast to its type and is none of its enumerators.
  kBadInput,
  kLimitExceeded,  ///< a limit (see ExceededLimit) would be exceeded, or memory ran out
  kCancelled,      ///< the caller's cancel token or progress callback asked to stop
  kInternal,       ///< an invariant of the library broke; Error::stage names the place
};

/// Names one operand of an operation that has two.
enum class Operand : unsigned char {
  kFirst = 0,   ///< P of a sum P ⊕ Q, A of A ⊖ B
  kSecond = 1,  ///< Q of a sum P ⊕ Q, B of A ⊖ B
};

/// The place in an operand that an error is about. Indices count from 0, and `kNone` means that an
/// index is not known.
struct Culprit {
  /// The value of an index that is not known.
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  /// The operand: 0 = first, 1 = second, -1 = the error is about no operand. Where shapes are given
  /// as a list, it is the index in the list. Functions of more than two shapes say what 2, 3, ...
  /// mean.
  int operand = -1;
  std::size_t polygon = kNone;  ///< index of the polygon in its region
  std::size_t ring = kNone;     ///< index of the ring in its polygon: 0 = outer, 1.. = holes
  std::size_t vertex = kNone;   ///< index of the vertex in its ring
  /// Tells whether both name the same place.
  friend bool operator==(const Culprit&, const Culprit&) = default;
};

/// The limit that was exceeded, where the caller can do something about it.
struct ExceededLimit {
  /// Its name in this interface, such as "Limits::max_segments", or "memory". It is "doubles" if a
  /// coordinate is beyond the range of doubles but has to be one. In adaptors there are also
  /// "floats" and "integers". "pictures" stands for a coordinate that is too large to be drawn.
  std::string_view name;
  std::uint64_t value = 0;  ///< what was allowed; 0 if the limit is not a count
};

/// The exception that every function of the library throws, besides std::bad_alloc where memory
/// runs out. io::ReadError is derived from it.
class MINKSUM_API Error : public std::runtime_error {
 public:
  /// Makes an error from its message and from what the functions below return.
  Error(ErrorCode code, const std::string& message, Culprit culprit = {}, std::string stage = {},
        const std::optional<ExceededLimit>& limit = {})
      : std::runtime_error(message),
        code_(code),
        culprit_(culprit),
        stage_(std::move(stage)),
        limit_(limit) {}

  /// Returns the kind of failure.
  [[nodiscard]] ErrorCode code() const noexcept { return code_; }
  /// Returns the place in an operand that caused the error. What is unknown is Culprit::kNone or
  /// -1.
  [[nodiscard]] const Culprit& culprit() const noexcept { return culprit_; }
  /// Returns the limit of a kLimitExceeded, or nothing if the caller can do nothing about it.
  [[nodiscard]] const std::optional<ExceededLimit>& limit() const noexcept { return limit_; }
  /// Returns where in the library a kInternal arose, such as "operands", and the stage that was
  /// stopped for a kCancelled; empty otherwise.
  [[nodiscard]] const std::string& stage() const noexcept { return stage_; }

 private:
  ErrorCode code_;
  Culprit culprit_;
  std::string stage_;
  std::optional<ExceededLimit> limit_;
};

/// Tells how a call that does not throw ended. It has an error unless the call succeeded.
struct [[nodiscard]] Outcome {
  std::optional<Error> error;  ///< the error that the throwing form of the call throws
  /// Tells whether the call succeeded.
  [[nodiscard]] bool ok() const { return !error.has_value(); }
};

namespace detail {
/// Returns the Outcome for std::bad_alloc. This takes no memory: there may be none.
[[nodiscard]] MINKSUM_API Outcome out_of_memory() noexcept;
}  // namespace detail

#ifdef __cpp_exceptions
/// Runs `operation` and returns its Outcome instead of throwing. An Error is returned as it was
/// thrown, and std::bad_alloc becomes kLimitExceeded with the limit "memory". Other exceptions
/// pass. An Outcome that `operation` returns is passed on. Code that is compiled without exceptions
/// does not have this function. Every operation of the library can be called so:
///
///     Geometry grown;
///     const Outcome outcome = attempt([&] { grown = offset(plate, 1); });
template <class Operation>
Outcome attempt(Operation&& operation) {
  try {
    if constexpr (std::is_same_v<std::remove_cvref_t<std::invoke_result_t<Operation>>, Outcome>) {
      return std::forward<Operation>(operation)();
    } else {
      std::forward<Operation>(operation)();
      return {};
    }
  } catch (const Error& error) {
    return {error};
  } catch (const std::bad_alloc&) {
    return detail::out_of_memory();
  }
}
#endif

}  // namespace minksum
