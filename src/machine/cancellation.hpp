// Whether the caller still wants a result: what every loop that may be long asks.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "minksum/cancel.hpp"
#include "minksum/error.hpp"
#include "minksum/minkowski_sum.hpp"

namespace minksum {

/// Counts the work of an operation, and every so much of it looks at the caller's token and calls
/// the caller's progress callback. For one thread.
///
/// A unit of work is some ten nanoseconds: a few steps of a loop on numbers that are in the cache,
/// or one on such that are not. Counting is all that it costs where nobody can cancel.
class Cancellation {
 public:
  /// Between two looks: a third of a millisecond, in a loop that counts rightly.
  static constexpr std::uint64_t kUnits = std::uint64_t{1} << 15;

  /// Nobody can cancel.
  Cancellation() = default;
  /// `token` must live as long.
  explicit Cancellation(const std::optional<CancelToken>& token) : token_(&token) {}
  explicit Cancellation(const std::optional<CancelToken>&& token) = delete;
  /// `options` must live as long.
  explicit Cancellation(const Options& options)
      : token_(&options.cancel),
        progress_(options.progress ? &options.progress : nullptr),
        has_stages_(true) {}
  Cancellation(const Cancellation&) = delete;
  Cancellation& operator=(const Cancellation&) = delete;

  /// Counts work, and looks if it is time. Throws Error(kCancelled).
  void check(std::uint64_t units = 1) {
    done_ += units;
    if (done_ >= kUnits) look();
  }
  /// Looks now.
  void look() {
    done_ = 0;
    if ((*token_ && (*token_)->cancelled()) || (progress_ != nullptr && !(*progress_)(stage_))) {
      throw Error(ErrorCode::kCancelled, "cancelled", {}, has_stages_ ? to_string(stage_) : "");
    }
  }
  /// The stage that the progress callback is told of from now on.
  void enter(Stage stage) {
    stage_ = stage;
    look();
  }
  [[nodiscard]] Stage stage() const { return stage_; }
  /// For an operation that is part of this one.
  [[nodiscard]] const std::optional<CancelToken>& token() const { return *token_; }

  /// A comparison that counts: for sorting what may be long.
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

/// The units of a product, or a division, of two numbers of so many bits.
[[nodiscard]] constexpr std::uint64_t work_of_product(std::size_t bits) {
  const std::uint64_t words = bits / 64 + 1;
  return 4 + words * words / 4;
}
/// The units of a few sums and products of a point's coordinates, brought to lowest terms: a common
/// divisor takes some ten times as long as a product.
[[nodiscard]] inline std::uint64_t work_of(const Point& point) {
  return 16 + 32 * work_of_product(std::max(point.x.bits(), point.y.bits()));
}
/// The units of an exact decision about coordinates of so many bits, of arbitrary precision: some
/// ten products of numbers that are up to five times as long.
[[nodiscard]] constexpr std::uint64_t work_of_decision(std::size_t bits) {
  return 10 * work_of_product(5 * bits);
}

}  // namespace minksum
