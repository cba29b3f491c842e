// Declares what a geometry keeps for sums with several others.
#pragma once

#include <atomic>
#include <minksum/minksum.hpp>

namespace minksum::python {

/// Keeps the prepared form of a geometry from its second sum on. Any number of threads may ask at
/// the same time. A copy begins anew.
class PreparedSlot {
 public:
  PreparedSlot() = default;
  PreparedSlot(const PreparedSlot& /*other*/) noexcept {}
  PreparedSlot(PreparedSlot&& other) noexcept : kept_(other.kept_.exchange(nullptr)) {}
  PreparedSlot& operator=(const PreparedSlot& /*other*/) noexcept { return *this; }
  PreparedSlot& operator=(PreparedSlot&& /*other*/) noexcept { return *this; }
  ~PreparedSlot();

  /// Returns the prepared form of the geometry that has the slot; null the first time, while
  /// another call prepares it, and for a geometry with thin parts or rings that cross. Throws
  /// Error: kLimitExceeded, kCancelled.
  [[nodiscard]] const PreparedRegion* get(const Geometry& geometry, const Options& options) const;
  /// Prepares now, so that the next `get` has it, unless another call is about it.
  void fill(const Geometry& geometry, const Options& options) const;

 private:
  struct Kept;
  [[nodiscard]] Kept& kept() const;

  mutable std::atomic<Kept*> kept_{nullptr};
};

}  // namespace minksum::python
