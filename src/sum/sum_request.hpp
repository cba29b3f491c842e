// What the driver of a sum is asked for.
#pragma once

#include "minksum/testing.hpp"

namespace minksum {

/// The settings of a sum, and where to put what is wanted beside the sum itself; null = not wanted.
struct SumRequest : SumSettings {
  SumRequest() = default;
  explicit SumRequest(const Options& options) : SumSettings{options} {}
  explicit SumRequest(const SumSettings& settings) : SumSettings(settings) {}

  Statistics* statistics = nullptr;
  Trace* trace = nullptr;
  Geometry* tight_places = nullptr;
};

}  // namespace minksum
