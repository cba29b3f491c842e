// A sum, stage by stage, as pictures (SVG) and data (GeoJSON).
#pragma once

#include <string>

#include "minksum/trace.hpp"
#include "sum_picture.hpp"

namespace minksum::cli {

/// Writes 1-operands, 2-convolution, 3-cover, 4-arrangement, 5-loops, 6-rejected and 7-result into
/// `folder`, each as .svg and .geojson (the cover: .json). Throws Error or Failure.
void write_trace(const std::string& folder, const Drawing& drawing, const Trace& trace);

}  // namespace minksum::cli
