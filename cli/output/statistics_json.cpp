#include "output/statistics_json.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "minksum/measure.hpp"
#include "minksum/version.hpp"

namespace minksum::cli {
namespace {

Json size_json(const Geometry& geometry) {
  return {{"vertices", geometry.region.vertex_count()},
          {"holes", geometry.region.hole_count()},
          {"parts", geometry.region.polygon_count()},
          {"polylines", geometry.polylines.size()},
          {"points", geometry.points.size()}};
}

Json operands_json(const std::string (&files)[2], const Geometry (&operands)[2]) {
  Json json = Json::array();
  for (int i = 0; i < 2 && !files[i].empty(); ++i) {
    Json operand = size_json(operands[i]);
    operand["file"] = files[i];
    json.push_back(std::move(operand));
  }
  return json;
}

double length(const std::vector<Polyline>& polylines) {
  double sum = 0;
  for (const Polyline& polyline : polylines) {
    for (std::size_t i = 1; i < polyline.size(); ++i) {
      sum += std::hypot((polyline[i].x - polyline[i - 1].x).to_double(),
                        (polyline[i].y - polyline[i - 1].y).to_double());
    }
  }
  return sum;
}

Json result_json(const SumArguments& arguments, const SumRun& run) {
  Json json = size_json(run.exact);
  json["area"] = approximate_area(run.exact.region);
  // The common denominator of thousands of crossings has hundreds of thousands of digits and takes
  // longer than the sum. Only those who ask for exact numbers get it.
  if (arguments.coordinates.style == io::Coordinates::Style::kExact) {
    json["area_exact"] = area(run.exact.region).to_string();
  }
  if (run.tight) {
    json["tight_points"] = run.tight->points.size();
    json["tight_polylines"] = run.tight->polylines.size();
    json["tight_length"] = length(run.tight->polylines);
  }
  return json;
}

Json rounding_json(RoundingSide side, const RoundingReport& report) {
  return {{"side", minksum::to_string(side)},    {"exact", report.exact},
          {"snapped", report.snapped},           {"topology_kept", report.topology_kept},
          {"largest_move", report.largest_move}, {"bound", report.bound}};
}

Json seconds_json(const Seconds& seconds) {
  Json stages;
  for (int i = 0; i < kSumStages; ++i) {
    stages[minksum::to_string(static_cast<Stage>(i))] = seconds.stages[i];
  }
  return {{"read", seconds.read},
          {"sum", seconds.sum},
          {"round", seconds.round},
          {"write", seconds.write},
          {"stages", stages}};
}

Json counts_json(const Statistics& statistics) {
  return {{"convolution_segments", statistics.convolution_segments},
          {"segments_kept", statistics.segments_kept},
          {"crossings", statistics.crossings},
          {"loops", statistics.loops},
          {"rejected_by_nesting", statistics.rejected_by_nesting},
          {"rejected_by_collision", statistics.rejected_by_collision},
          {"grid_cells", statistics.grid_cells},
          {"covered_cells", statistics.covered_cells}};
}

Json arithmetic_json(const Statistics& statistics) {
  return {{"coordinate_bits", statistics.coordinate_bits},
          {"by_filter", statistics.by_filter},
          {"by_fixed_width", statistics.by_fixed_width},
          {"by_arbitrary", statistics.by_arbitrary},
          {"rung", to_string(statistics.arithmetic)}};
}

}  // namespace

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  if (values.size() % 2 == 1) return values[middle];
  return (values[middle - 1] + values[middle]) / 2;
}

const char* to_string(Method method) {
  constexpr const char* kNames[] = {"reduced", "signed", "full"};
  return kNames[static_cast<std::size_t>(method)];
}

const char* to_string(Arithmetic arithmetic) {
  constexpr const char* kNames[] = {"auto", "narrow", "medium", "wide", "arbitrary"};
  return kNames[static_cast<std::size_t>(arithmetic)];
}

Json statistics_json(const OperandArguments& arguments, const Geometry (&operands)[2],
                     const OperationSeconds& seconds) {
  return {{"operands", operands_json(arguments.operands, operands)},
          {"seconds", {{"read", seconds.read}, {"work", seconds.work}}},
          {"fill", minksum::to_string(arguments.options.fill)},
          {"version", MINKSUM_VERSION}};
}

Json statistics_json(const SumArguments& arguments, const SumRun& run) {
  Json json;
  json["operands"] = operands_json(arguments.operands, run.operands);
  json["result"] = result_json(arguments, run);
  if (run.rounding) json["rounding"] = rounding_json(arguments.rounding, *run.rounding);
  json["seconds"] = seconds_json(run.seconds);
  json["small"] = run.statistics.small;
  json["counts"] = counts_json(run.statistics);
  json["arithmetic"] = arithmetic_json(run.statistics);
  json["method"] = to_string(arguments.options.method);
  json["fill"] = minksum::to_string(arguments.options.fill);
  json["repeat"] = arguments.repeat;
  json["version"] = MINKSUM_VERSION;
  return json;
}

std::string readable_seconds(double seconds) {
  char text[32];
  if (seconds < 1e-3) {
    std::snprintf(text, sizeof text, "%.0f µs", seconds * 1e6);
  } else if (seconds < 1) {
    std::snprintf(text, sizeof text, "%.1f ms", seconds * 1e3);
  } else {
    std::snprintf(text, sizeof text, "%.2f s", seconds);
  }
  return text;
}

}  // namespace minksum::cli
