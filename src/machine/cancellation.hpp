// Defines how a loop that may be long finds out whether the caller still wants a result.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "minksum/cancel.hpp"
#include "minksum/error.hpp"
#include "minksum/minkowski_sum.hpp"

namespace minksum {

/// Counts the work of an operation. After every kUnits of it, looks at the caller's token and calls
/// the caller's progress callback. Each thread needs its own.
///
/// A unit of work takes some ten nanoseconds. A unit is a few steps of a loop on numbers in the
/// cache, or one step on numbers that are not. Where nobody can cancel, counting is the only cost.
class Cancellation {
 public:
  /// Units between two looks, which take a third of a millisecond in a loop that counts rightly.
  static constexpr std::uint64_t kUnits = std::uint64_t{1} << 15;

  /// Makes one that nobody can cancel.
  Cancellation() = default;
  /// `token` must live as long as this object.
  explicit Cancellation(const std::optional<CancelToken>& token) : token_(&token) {}
  explicit Cancellation(const std::optional<CancelToken>&& token) = delete;
  /// `options` must live as long as this object.
  explicit Cancellation(const Options& options)
      : token_(&options.cancel),
        progress_(options.progress ? &options.progress : nullptr),
        has_stages_(true) {}
  Cancellation(const Cancellation&) = delete;
  Cancellation& operator=(const Cancellation&) = delete;

  /// Counts work, and looks if enough has been done. Throws Error(kCancelled).
  void check(std::uint64_t units = 1) {
    done_ += units;
    if (done_ >= kUnits) look();
  }
  /// Looks now. Throws Error(kCancelled).
  void look() {
    done_ = 0;
    if ((*token_ && (*token_)->cancelled()) || (progress_ != nullptr && !(*progress_)(stage_))) {
      throw Error(ErrorCode::kCancelled, "cancelled", {}, has_stages_ ? to_string(stage_) : "");
    }
  }
  /// Sets the stage of which the progress callback is told from now on, and looks.
  void enter(Stage stage) {
    stage_ = stage;
    look();
  }
  [[nodiscard]] Stage stage() const { return stage_; }
  /// Returns the token, for an operation that is part of this one.
  [[nodiscard]] const std::optional<CancelToken>& token() const { return *token_; }

  /// Returns a comparison that counts its calls, for sorting lists that may be long.
  template <class Less>
  [[nodiscard]] auto counting(Less less) {
    return [this, less](const auto& a, const auto& b) {
      check();
      return less(a, b);
    };
  }

 private:
  static inline const std::optional<CancelToken> kNobody;

  std::uint64_t done_ = 0;
  const std::optional<CancelToken>* token_ = &kNobody;
  const std::function<bool(Stage)>* progress_ = nullptr;
  Stage stage_ = Stage::kOperands;
  bool has_stages_ = false;
};

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
