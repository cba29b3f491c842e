// Writes each stage of a sum as a picture (SVG) and as data (GeoJSON).
#pragma once

#include <string>

#include "minksum/trace.hpp"
#include "output/output_file.hpp"
#include "pictures/sum_picture.hpp"

namespace minksum::cli {

/// The names of all files: picture and data of each stage.
inline constexpr const char* kTraceFiles[] = {
    "1-operands.svg", "1-operands.geojson", "2-convolution.svg", "2-convolution.geojson",
    "3-cover.svg",    "3-cover.json",       "4-arrangement.svg", "4-arrangement.geojson",
    "5-loops.svg",    "5-loops.geojson",    "6-rejected.svg",    "6-rejected.geojson",
    "7-result.svg",   "7-result.geojson"};

/// Writes these files into `folder`, which must exist. Throws Error or Failure.
void write_trace(OutputFiles& files, const std::string& folder, const Drawing& drawing,
                 const Trace& trace);

}  // namespace minksum::cli
