#include "sum_options.hpp"

#include <filesystem>
#include <map>
#include <vector>

#include "failure.hpp"

namespace minksum::cli {
namespace {

constexpr const char* kSumFooter = R"(
P and Q are files, or one of them "-" for standard input: WKT, GeoJSON, .poly
or .dat, told by content: areas, polylines, points, alone or together. Numbers are
read exactly: 0.1 is one tenth, 1/3 a third.
)";

constexpr int kMaxDecimals = 1000;

const std::map<std::string, io::Format> kFormats = {{"wkt", io::Format::kWkt},
                                                    {"geojson", io::Format::kGeoJson},
                                                    {"svg", io::Format::kSvg},
                                                    {"poly", io::Format::kPoly}};
const std::map<std::string, Method> kMethods = {
    {"reduced", Method::kReduced}, {"signed", Method::kSigned}, {"full", Method::kFull}};
const std::map<std::string, Arithmetic> kArithmetics = {{"auto", Arithmetic::kAutomatic},
                                                        {"narrow", Arithmetic::kNarrow},
                                                        {"medium", Arithmetic::kMedium},
                                                        {"wide", Arithmetic::kWide},
                                                        {"arbitrary", Arithmetic::kArbitrary}};

const std::map<std::string, FillRule> kFillRules = {
    {"automatic", FillRule::kAutomatic}, {"evenodd", FillRule::kEvenOdd},
    {"nonzero", FillRule::kNonZero},     {"positive", FillRule::kPositive},
    {"negative", FillRule::kNegative},   {"strict", FillRule::kStrict}};
const std::map<std::string, RoundingSide> kSides = {{"nearest", RoundingSide::kNearest},
                                                    {"outside", RoundingSide::kOutside},
                                                    {"inside", RoundingSide::kInside}};

Failure usage(const std::string& what) { return Failure(kWrongUsage, what); }

io::Coordinates parse_coordinates(const std::string& text) {
  using Style = io::Coordinates::Style;
  if (text == "double") return {Style::kDouble};
  if (text == "exact") return {Style::kExact};
  const std::string prefix = "decimal:";
  const std::string digits = text.starts_with(prefix) ? text.substr(prefix.size()) : "";
  const bool number = !digits.empty() && digits.size() <= 4 &&
                      digits.find_first_not_of("0123456789") == std::string::npos;
  if (!number || std::stoi(digits) > kMaxDecimals) {
    throw usage("--coords takes double, exact or decimal:N with N from 0 to " +
                std::to_string(kMaxDecimals) + ", not '" + text + "'");
  }
  return {Style::kDecimal, std::stoi(digits)};
}

// The format that was asked for, or the one that the output's name ends in, or WKT.
io::Format choose_format(const std::string& typed, const std::string& output) {
  if (!typed.empty()) return kFormats.at(typed);
  std::string ending = std::filesystem::path(output).extension().string();
  if (!ending.empty()) ending.erase(0, 1);
  if (ending == "json") return io::Format::kGeoJson;
  const auto found = kFormats.find(ending);
  return found == kFormats.end() ? io::Format::kWkt : found->second;
}

std::vector<std::string> names_of(const auto& map) {
  std::vector<std::string> names;
  for (const auto& entry : map) names.push_back(entry.first);
  return names;
}

void add_operand_options(CLI::App& sum, Options& options) {
  const char* const group = "What operands mean";
  add_fill_option(sum, options.fill)->group(group);
  sum.add_flag("--regularize", options.regularize, "Drop operands' polylines, points and spikes")
      ->group(group);
}

void add_output_options(CLI::App& sum, SumArguments& arguments, TypedSum& typed) {
  sum.add_option("-o,--output", arguments.output, "Write the sum here, not to standard output")
      ->type_name("FILE");
  sum.add_option("--format", typed.format,
                 "wkt, geojson, svg or poly; without it as the output's name ends, else wkt")
      ->check(CLI::IsMember(names_of(kFormats)))
      ->type_name("F");
  sum.add_option("--coords", typed.coordinates,
                 "double (nearest, shortest form; the default), exact (integers or p/q), decimal:N")
      ->type_name("C");
  sum.add_option("--round", typed.round,
                 "nearest (the default), outside (contains the exact sum), inside (within it)")
      ->check(CLI::IsMember(names_of(kSides)))
      ->type_name("SIDE");
  sum.add_flag("--keep-properties", arguments.keep_properties,
               "GeoJSON: a Feature with the properties of P, which is one");
  sum.add_option("--tight", arguments.tight, "Write placements without any play")
      ->type_name("FILE");
  sum.add_option("--stats", arguments.stats, "Write sizes, times and counts as JSON")
      ->type_name("FILE");
  sum.add_option("--svg", arguments.picture, "Draw operands and sum")->type_name("FILE");
  sum.add_option("--trace", arguments.trace, "Draw and write every stage into this folder")
      ->type_name("DIR");
}

void add_test_options(CLI::App& sum, SumArguments& arguments, TypedSum& typed) {
  const char* const group = "For tests (the result is the same)";
  sum.add_flag("--no-cover", typed.no_cover, "No cover: build the whole arrangement")->group(group);
  sum.add_option("--grid", arguments.options.grid,
                 "Cells along the longer side of the cover's grid")
      ->check(CLI::Range(0, 1 << 14))
      ->group(group);
  sum.add_option_function<std::string>(
         "--arithmetic",
         [&arguments](const std::string& name) {
           arguments.options.arithmetic = kArithmetics.at(name);
         },
         "Force a number type: auto, narrow, medium, wide, arbitrary")
      ->check(CLI::IsMember(names_of(kArithmetics)))
      ->type_name("RUNG")
      ->group(group);
  sum.add_flag("--no-filter", typed.no_filter, "Decide everything by exact arithmetic")
      ->group(group);
  sum.add_flag("--check", arguments.options.check, "Check each stage's result (slow)")
      ->group(group);
}

void settle_output(SumArguments& arguments, const TypedSum& typed) {
  arguments.coordinates = parse_coordinates(typed.coordinates);
  if (!typed.round.empty()) {
    if (arguments.coordinates.style == io::Coordinates::Style::kExact) {
      throw usage("--round has nothing to do with --coords exact, which never rounds");
    }
    arguments.rounding = kSides.at(typed.round);
  }
  arguments.format = choose_format(typed.format, arguments.output);
  if (arguments.keep_properties && arguments.format != io::Format::kGeoJson) {
    throw usage("--keep-properties needs --format geojson");
  }
}

void settle_tight(SumArguments& arguments) {
  if (arguments.tight == "-" && arguments.output.empty()) {
    throw usage("--tight - needs -o FILE: standard output already takes the sum");
  }
  if (arguments.options.method != Method::kReduced) {
    throw usage("--tight needs the reduced method");
  }
  arguments.tight_format = choose_format("", arguments.tight);
  if (arguments.tight_format == io::Format::kPoly) {
    throw usage("--tight gives points and polylines, which have no form in .poly");
  }
}

}  // namespace

CLI::Option* add_fill_option(CLI::App& command, FillRule& fill) {
  return command
      .add_option_function<std::string>(
          "--fill", [&fill](const std::string& name) { fill = kFillRules.at(name); },
          "automatic (legal polygons as OGC says, others nonzero; the default), evenodd, nonzero, "
          "positive, negative, strict (legal polygons alone)")
      ->check(CLI::IsMember(names_of(kFillRules)))
      ->type_name("RULE");
}

CLI::App* add_sum(CLI::App& app, SumArguments& arguments, TypedSum& typed, ProcessLimits& limits) {
  CLI::App* sum = app.add_subcommand("sum", "The Minkowski sum of two geometries");
  sum->footer(kSumFooter);
  sum->add_option("P", arguments.operands[0], "The first operand")->required()->type_name("FILE");
  sum->add_option("Q", arguments.operands[1], "The second operand")->required()->type_name("FILE");
  add_output_options(*sum, arguments, typed);
  sum->add_option_function<std::string>(
         "--method",
         [&arguments](const std::string& name) { arguments.options.method = kMethods.at(name); },
         "reduced (the default), signed, full: the same sum by three methods")
      ->check(CLI::IsMember(names_of(kMethods)))
      ->type_name("M");
  sum->add_option("--repeat", arguments.repeat, "Compute N times and report median times")
      ->check(CLI::Range(1, 1'000'000))
      ->type_name("N");
  sum->add_flag("-v,--verbose", arguments.verbose, "Say sizes and time on standard error");
  add_operand_options(*sum, arguments.options);
  add_limit_options(*sum, limits, true);
  add_test_options(*sum, arguments, typed);
  return sum;
}

void settle(SumArguments& arguments, const TypedSum& typed) {
  if (arguments.operands[0] == "-" && arguments.operands[1] == "-") {
    throw usage("P and Q cannot both be standard input");
  }
  if (arguments.output == "-") arguments.output.clear();
  settle_output(arguments, typed);
  if (!arguments.tight.empty()) settle_tight(arguments);
  if (arguments.stats == "-" && arguments.output.empty()) {
    throw usage("--stats - needs -o FILE: standard output already takes the sum");
  }
  if (arguments.stats == "-" && arguments.tight == "-") {
    throw usage("--stats and --tight cannot both be standard output");
  }
  if (arguments.picture == "-") {
    throw usage("--svg needs a file (--format svg draws the sum alone)");
  }
  if (!arguments.trace.empty() && arguments.options.method == Method::kSigned) {
    throw usage("--trace shows the stages of the reduced and full methods, not of signed");
  }
  arguments.options.cover = !typed.no_cover;
  arguments.options.filter = !typed.no_filter;
}

}  // namespace minksum::cli
