#include "options/result_options.hpp"

#include <filesystem>

#include "help/spelling.hpp"
#include "output/output_file.hpp"
#include "process/failure.hpp"

namespace minksum::cli {
namespace {

constexpr const char* kGeoJsonLines = "geojsonl";
const std::map<std::string, io::Format> kFormats = {
    {"wkt", io::Format::kWkt},      {"geojson", io::Format::kGeoJson},
    {"svg", io::Format::kSvg},      {kGeoJsonLines, io::Format::kGeoJson},
    {"poly", io::Format::kPoly},    {"wkb", io::Format::kWkb},
    {"wkbhex", io::Format::kHexWkb}};
// Other endings of names.
const std::map<std::string, std::string> kEndings = {
    {"json", "geojson"}, {"ndjson", kGeoJsonLines}, {"geojsons", kGeoJsonLines}};

// Returns the name of the format, which is typed, or which the ending of the output's name tells.
std::string format_name(const std::string& typed, const std::string& output) {
  if (!typed.empty()) return typed;
  const std::string ending = in_lower_case(std::filesystem::path(output).extension().string());
  if (ending.empty() || is_special(output)) return "wkt";
  const std::string name = ending.substr(1);
  if (const auto found = kEndings.find(name); found != kEndings.end()) return found->second;
  if (kFormats.contains(name)) return name;
  std::string endings;
  for (const auto& [other, format] : kEndings) endings += "." + other + ", ";
  for (const auto& [other, format] : kFormats) endings += "." + other + ", ";
  endings.resize(endings.size() - 2);
  throw Failure(kWrongUsage, output + ": no format ends in " + ending + "; there are " + endings);
}

io::Coordinates parse_coordinates(const std::string& typed) {
  const std::string text = in_lower_case(typed);
  using Style = io::Coordinates::Style;
  if (text == "double") return {Style::kDouble};
  if (text == "exact") return {Style::kExact};
  const std::string prefix = "decimal:";
  const std::string digits = text.starts_with(prefix) ? text.substr(prefix.size()) : "";
  const bool number = !digits.empty() && digits.size() <= 4 &&
                      digits.find_first_not_of("0123456789") == std::string::npos;
  if (!number || std::stoi(digits) > kMaxDecimals) {
    throw Failure(kWrongUsage, "--coords takes double, exact or decimal:N with N from 0 to " +
                                   std::to_string(kMaxDecimals) + ", not '" + typed + "'");
  }
  return {Style::kDecimal, std::stoi(digits)};
}

}  // namespace

const std::map<std::string, RoundingSide>& rounding_sides() {
  static const std::map<std::string, RoundingSide> kSides = {{"nearest", RoundingSide::kNearest},
                                                             {"outside", RoundingSide::kOutside},
                                                             {"inside", RoundingSide::kInside}};
  return kSides;
}

io::Format choose_format(const std::string& typed, const std::string& output) {
  return kFormats.at(format_name(typed, output));
}

Option add_operand(const Command& command, const char* name, std::string& file, const char* what) {
  return command.add_option(name, file, what).required().type_name("FILE");
}

void add_each_options(const Command& command, EachArguments& arguments,
                      const std::vector<const char*>& without) {
  const char* const group = "Feature by feature";
  const Option each =
      command
          .add_flag("--each", arguments.each,
                    "Do this to each feature of the first operand, on all cores; properties, id "
                    "and crs stay")
          .group(group);
  for (const char* const other : without) each.excludes(other);
  command
      .add_flag("--restart", arguments.restart,
                "With --each: start afresh, even if an earlier run left FILE.partial")
      .needs("--each")
      .group(group);
}

void add_result_options(const Command& command, ResultArguments& arguments,
                        const std::string& result) {
  command
      .add_option("-o,--output", arguments.output,
                  "Write the " + result + " here, not to standard output")
      .type_name("FILE");
  command
      .add_option("--format", arguments.typed_format,
                  "wkt, geojson, geojsonl (a text a line), wkb, wkbhex, svg or poly; without it as "
                  "the output's name ends, else wkt")
      .one_of(names_of(kFormats))
      .type_name("F");
  command
      .add_option("--coords", arguments.typed_coordinates,
                  "double (nearest, shortest form; the default), exact (integers or p/q), "
                  "decimal:N")
      .type_name("C");
  command
      .add_option(
          "--round", arguments.typed_rounding,
          "nearest (the default), outside (contains the exact " + result + "), inside (within it)")
      .one_of(names_of(rounding_sides()))
      .type_name("SIDE");
}

void convert_numbers(ResultArguments& arguments) {
  if (arguments.output == "-") arguments.output.clear();
  arguments.coordinates = parse_coordinates(arguments.typed_coordinates);
  if (!arguments.typed_rounding.empty()) {
    if (arguments.coordinates.style == io::Coordinates::Style::kExact) {
      throw Failure(kWrongUsage,
                    "--round has nothing to do with --coords exact, which never rounds");
    }
    arguments.rounding = rounding_sides().at(arguments.typed_rounding);
  }
}

void convert_result(ResultArguments& arguments) {
  convert_numbers(arguments);
  const std::string name = format_name(arguments.typed_format, arguments.output);
  arguments.format = kFormats.at(name);
  arguments.lines = name == kGeoJsonLines;
  const bool binary =
      arguments.format == io::Format::kWkb || arguments.format == io::Format::kHexWkb;
  if (binary && arguments.coordinates.style != io::Coordinates::Style::kDouble) {
    throw Failure(kWrongUsage, "WKB holds doubles: --coords " + arguments.typed_coordinates +
                                   " has no form in it");
  }
}

}  // namespace minksum::cli
