// What the driver of a sum is asked for.
#pragma once

#include "machine/bad_input.hpp"
#include "minksum/testing.hpp"

namespace minksum {

/// The settings of a sum, and where to put what the caller wants beside the sum. A null pointer
/// means that it is not wanted. The stages see the settings alone, so `Options::tight` is true
/// exactly if `tight_places` is not null.
struct SumRequest : SumSettings {
  SumRequest() = default;
  explicit SumRequest(const Options& options) : SumSettings{options} { tight = false; }
  /// Throws Error(kBadInput) for a method or an arithmetic that does not exist.
  explicit SumRequest(const SumSettings& settings) : SumSettings(settings) {
    require_enumerator(method, Method::kFull, "method");
    require_enumerator(arithmetic, Arithmetic::kArbitrary, "arithmetic");
    tight = false;
  }
  void want_tight_places(Geometry& places) {
    tight = true;
    tight_places = &places;
  }

  Statistics* statistics = nullptr;
  Trace* trace = nullptr;
  Geometry* tight_places = nullptr;
};

}  // namespace minksum
