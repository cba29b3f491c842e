// Defines how a loop that may be long finds out whether the caller still wants a result.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "machine/bad_input.hpp"
#include "minksum/error.hpp"
#include "minksum/options.hpp"
#include "minksum/region.hpp"

namespace minksum {

class Team;

/// Counts the work of an operation. After every kUnits of it, looks at the caller's token and calls
/// the caller's progress callback. Each thread needs its own.
///
/// A unit of work takes some ten nanoseconds. A unit is a few steps of a loop on numbers in the
/// cache, or one step on numbers that are not. Where nobody can cancel, counting is the only cost.
class Cancellation {
 public:
  /// Units between two looks, which take a third of a millisecond in a loop that counts rightly.
  static constexpr std::int64_t kUnits = std::int64_t{1} << 15;

  /// Makes one that nobody can cancel.
  Cancellation() = default;
  /// `options` must live as long. `stage` is what the progress callback is told of at first.
  /// Throws Error(kCancelled) if the token is cancelled already, and Error(kBadInput) for a fill
  /// rule that does not exist: every operation on options makes one. Not inlined, as that is long.
  [[gnu::noinline]] explicit Cancellation(const Options& options, Stage stage = Stage::kOperands)
      : options_(&options), stage_(stage) {
    require_enumerator(options.fill, FillRule::kStrict, "fill");
    if (is_cancelled()) stop();
  }
  explicit Cancellation(const Options&& options, Stage stage = Stage::kOperands) = delete;
  Cancellation(const Cancellation&) = delete;
  Cancellation& operator=(const Cancellation&) = delete;

  /// Counts work, and looks if enough has been done. Throws Error(kCancelled).
  void check(std::uint64_t units = 1) {
    // It counts down: subtracting in memory and jumping on the sign takes two instructions.
    left_ -= static_cast<std::int64_t>(units);
    if (left_ < 0) [[unlikely]] {
      look();
    }
  }
  /// Looks now. Throws Error(kCancelled). Inlined, this would take registers from loops that count.
  [[gnu::noinline, gnu::cold]] void look() {
    left_ = kUnits;
    if (is_cancelled() || (options_->progress && !options_->progress({stage_}))) stop();
  }
  /// Sets the stage of which the progress callback is told from now on, and looks.
  void enter(Stage stage) {
    stage_ = stage;
    look();
  }
  [[nodiscard]] Stage stage() const { return stage_; }
  /// Makes the operation the work of a team, which must live as long.
  void join(Team& team) { team_ = &team; }
  /// Returns the threads that share the work (see `share`), or null if there is but this one.
  [[nodiscard]] Team* team() const { return team_; }
  /// Returns the options, for an operation that is part of this one.
  [[nodiscard]] const Options& options() const { return *options_; }

  /// Returns a comparison that counts its calls, for sorting lists that may be long.
  template <class Less>
  [[nodiscard]] auto counting(Less less) {
    return [this, less](const auto& a, const auto& b) {
      check();
      return less(a, b);
    };
  }
  /// Calls work(step), which calls step() for each unit, at most so many times. If these are no
  /// more than between two looks, they are counted beforehand, and step() does nothing.
  template <class Work>
  void counted(std::uint64_t units, Work work) {
    if (units <= static_cast<std::uint64_t>(kUnits)) {
      check(units);
      work([] {});
    } else {
      work([this] { check(); });
    }
  }

 private:
  static inline const Options kNobody;

  [[nodiscard]] bool is_cancelled() const {
    return options_->cancel && options_->cancel->cancelled();
  }
  [[noreturn, gnu::noinline, gnu::cold]] void stop() const {
    throw Error(ErrorCode::kCancelled, "cancelled", {}, to_string(stage_));
  }

  std::int64_t left_ = kUnits;  ///< until the next look
  const Options* options_ = &kNobody;
  Stage stage_ = Stage::kOperands;
  Team* team_ = nullptr;
};

/// Returns the options of an operation that is part of another one: its limits, threads, memory,
/// token and progress callback. The options that say how operands are read keep their defaults,
/// because the whole operation has read the operands before.
[[nodiscard]] inline Options part_of(const Options& options) {
  Options part;
  part.limits = options.limits;
  part.cancel = options.cancel;
  part.progress = options.progress;
  part.threads = options.threads;
  part.memory = options.memory;
  return part;
}

/// Returns the units of a product, or a division, of two numbers of so many bits.
[[nodiscard]] constexpr std::uint64_t work_of_product(std::size_t bits) {
  const std::uint64_t words = bits / 64 + 1;
  return 4 + words * words / 4;
}
/// Returns the units of a few sums and products of a point's coordinates, with reduction to lowest
/// terms. A common divisor takes some ten times as long as a product.
[[nodiscard]] inline std::uint64_t work_of(const Point& point) {
  return 16 + 32 * work_of_product(std::max(point.x.bits(), point.y.bits()));
}
/// Returns the units of an exact decision of arbitrary precision about coordinates of so many bits.
/// Such a decision takes some ten products of numbers that are up to five times as long.
[[nodiscard]] constexpr std::uint64_t work_of_decision(std::size_t bits) {
  return 10 * work_of_product(5 * bits);
}

}  // namespace minksum
