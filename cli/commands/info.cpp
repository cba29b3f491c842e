// minksum info: tells what a file holds, whether its polygons are valid, and what they mean.
#include <algorithm>
#include <optional>
#include <ostream>
#include <sstream>
#include <utility>
#include <vector>

#include "commands/commands.hpp"
#include "commands/subcommands.hpp"
#include "minksum/measure.hpp"
#include "minksum/resolve.hpp"
#include "minksum/validity.hpp"
#include "options/limits.hpp"
#include "options/sum_options.hpp"
#include "output/faults.hpp"
#include "output/json.hpp"
#include "output/numbers.hpp"
#include "output/output_file.hpp"
#include "pictures/sum_picture.hpp"
#include "process/failure.hpp"

namespace minksum::cli {
namespace {

constexpr std::size_t kMaxFaults = 100;
// The exact area of a set whose vertices are so many crossings takes some two seconds. It is a
// fraction with a factor in its denominator for each of them, so its time grows with their square.
constexpr std::uint64_t kMaxCrossings = 50'000;

// What the polygons mean by the fill rule.
struct ResolvedOperand {
  Geometry geometry;
  Rational area;
};

struct OperandReport {
  const Geometry& geometry;
  std::optional<Box> box;
  Rational area;
  std::size_t bits = 0;
  std::vector<Fault> faults;
  std::optional<ResolvedOperand> meaning;  ///< none if the rule is strict and faults exist
  bool crosses_too_often = false;          ///< the meaning was not computed
};

// Returns a region with all vertices of the geometry, polylines and points included. It serves for
// measures that accept any rings.
Region all_vertices(const Geometry& geometry) {
  Region all = geometry.region;
  const auto add = [&all](const std::vector<Point>& points) {
    if (points.empty()) return;
    all.begin_polygon();
    all.begin_ring();
    for (const Point& point : points) all.add_vertex(point.x, point.y);
  };
  for (const Polyline& polyline : geometry.polylines) add(polyline);
  add(geometry.points);
  return all;
}

OperandReport examine(const Geometry& geometry, const Options& reading) {
  const Region all = geometry.has_thin_parts() ? all_vertices(geometry) : Region();
  const Region& vertices = geometry.has_thin_parts() ? all : geometry.region;
  OperandReport findings{geometry,
                         bounding_box(vertices),
                         area(geometry.region),
                         coordinate_bits(vertices),
                         validate(geometry.region, kMaxFaults),
                         {}};
  if (reading.fill == FillRule::kStrict && !findings.faults.empty()) return findings;
  try {
    Geometry resolved = resolve(geometry, reading);
    const Rational size = area(resolved.region);
    findings.meaning = {std::move(resolved), size};
  } catch (const Error& error) {
    if (!error.limit() || error.limit()->name != "Limits::max_crossings") throw;
    findings.crosses_too_often = true;
  }
  return findings;
}

void write_text(std::ostream& out, const InfoArguments& arguments, const OperandReport& findings) {
  const Options& reading = arguments.options;
  const auto shown = arguments.exact ? readable : in_decimals;
  const Geometry& geometry = findings.geometry;
  out << "parts     " << geometry.region.polygon_count() << "\nholes     "
      << geometry.region.hole_count() << "\nvertices  " << geometry.region.vertex_count() << '\n';
  if (geometry.has_thin_parts()) {
    out << "polylines " << geometry.polylines.size() << "\npoints    " << geometry.points.size()
        << '\n';
  }
  if (findings.box) {
    const Box& box = *findings.box;
    out << "x         from " << shown(box.min.x) << " to " << shown(box.max.x)
        << "\ny         from " << shown(box.min.y) << " to " << shown(box.max.y) << '\n';
  } else {
    out << "box       none: there is nothing\n";
  }
  out << "area      " << shown(findings.area) << "\nbits      " << findings.bits << '\n';
  out << "valid     " << (findings.faults.empty() ? "yes" : "no") << '\n';
  for (const Fault& fault : findings.faults) out << "fault     " << described(fault) << '\n';
  if (findings.faults.size() == kMaxFaults) {
    out << "          (the first " << kMaxFaults << " faults; there may be more)\n";
  }
  out << "meaning   ";
  if (findings.meaning) {
    out << summary(findings.meaning->geometry) << "; area " << shown(findings.meaning->area);
  } else if (findings.crosses_too_often) {
    out << "not computed: more than " << arguments.max_crossings << " crossings (--max-crossings)";
  } else {
    out << "none";
  }
  out << " (fill rule " << to_string(reading.fill) << ")\n";
}

Json point_json(const Point& point) { return {point.x.to_string(), point.y.to_string()}; }

void add_sizes(Json& json, const Geometry& geometry) {
  json["parts"] = geometry.region.polygon_count();
  json["holes"] = geometry.region.hole_count();
  json["vertices"] = geometry.region.vertex_count();
  json["polylines"] = geometry.polylines.size();
  json["points"] = geometry.points.size();
}

void add_area(Json& json, const Rational& area) {
  json["area"] = area.to_double();
  json["area_exact"] = area.to_string();
}

Json info_json(const InfoArguments& arguments, const std::string& file,
               const OperandReport& findings) {
  Json json;
  json["file"] = file;
  add_sizes(json, findings.geometry);
  json["box"] = nullptr;
  if (const auto& box = findings.box) {
    json["box"] = {{"min", point_json(box->min)}, {"max", point_json(box->max)}};
  }
  add_area(json, findings.area);
  json["coordinate_bits"] = findings.bits;
  json["valid"] = findings.faults.empty();
  json["faults"] = Json::array();
  for (const Fault& fault : findings.faults) json["faults"].push_back(fault_json(fault));
  json["fill"] = to_string(arguments.options.fill);
  json["meaning"] = nullptr;
  if (findings.meaning) {
    Json meaning;
    add_sizes(meaning, findings.meaning->geometry);
    add_area(meaning, findings.meaning->area);
    json["meaning"] = meaning;
  }
  if (findings.crosses_too_often) json["crosses_more_than"] = arguments.max_crossings;
  return json;
}

Command describe_info(CommandLine& line, InfoArguments& arguments, ProcessLimits& limits) {
  const Command info =
      line.add_command("info", "What a geometry is: parts, holes, box, exact area, validity, bits");
  info.footer(
      "\nFaults of polygons that are not valid are listed; with --strict the exit code is 2.\n");
  info.add_option("FILE", arguments.files, "Geometries; one of them may be - for standard input")
      .required()
      .type_name("FILE");
  info.add_flag("--json", arguments.json, "As JSON: an object, or an array for several files");
  info.add_flag("--exact", arguments.exact, "Fractions, where decimals are not exact");
  add_fill_option(info, arguments.options.fill);
  add_regularize_option(info, arguments.options.regularize);
  arguments.max_crossings = kMaxCrossings;
  add_max_crossings(info, arguments.max_crossings,
                    "Crossings up to which the meaning is computed (default 50K)");
  add_limit_options(info, limits, false);
  return info;
}

// Adds the report of a file as text or JSON, and sets `failure` to the first one that --strict asks
// for.
void examine_file(const InfoArguments& arguments, const std::string& file, std::string& text,
                  std::vector<Json>& reports, std::optional<Failure>& failure) {
  const Geometry geometry = read_operand(file, arguments.limits).geometry;
  Options reading = arguments.options;
  reading.limits.max_crossings = arguments.max_crossings;
  const OperandReport findings = examine(geometry, reading);
  if (arguments.json) {
    reports.push_back(info_json(arguments, file, findings));
  } else {
    std::ostringstream out;
    if (arguments.files.size() > 1) {
      out << (text.empty() ? "" : "\n") << "file      " << shown_name(file) << '\n';
    }
    write_text(out, arguments, findings);
    text += std::move(out).str();
  }
  if (arguments.options.fill != FillRule::kStrict || findings.faults.empty() || failure) return;
  const std::string several = findings.faults.size() == 1 ? "" : ", the first of several faults";
  failure = failure_of(Error(ErrorCode::kBadInput,
                             "not valid" + several + ": " + described(findings.faults.front())),
                       file);
}

int run_info(const InfoArguments& arguments) {
  if (std::ranges::count(arguments.files, "-") > 1) {
    throw Failure(kWrongUsage, "several files cannot all be standard input");
  }
  std::string text;
  std::vector<Json> reports;
  std::optional<Failure> failure;
  for (const std::string& file : arguments.files) {
    examine_file(arguments, file, text, reports, failure);
  }
  write_standard_output([&](std::ostream& out) {
    out << text;
    if (!arguments.json) return;
    Json list = Json::array();
    for (const Json& report : reports) list.push_back(report);
    out << (reports.size() == 1 ? reports.front() : list).dump(2) << '\n';
  });
  if (failure) throw Failure(*failure);
  return kFine;
}

}  // namespace

void add_info(Program& program) { program.add(describe_info, run_info); }

}  // namespace minksum::cli
