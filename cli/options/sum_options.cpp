#include "options/sum_options.hpp"

#include <map>

#include "output/picture_file.hpp"
#include "process/failure.hpp"

namespace minksum::cli {
namespace {

constexpr int kMostCells = 4096;  // along a side; the cover accepts no more

constexpr const char* kSumFooter = R"(
P and Q are files, or one of them "-" for standard input: WKT, GeoJSON, WKB, .poly,
.dat, SVG or DXF, told by content: areas, polylines, points, alone or together. They may
also be typed: 'POLYGON ((0 0, 1 0, 0 1, 0 0))', disc:R, box:WxH or ngon:N:R around the
origin. Numbers are read exactly: 0.1 is one tenth, 1/3 a third.
)";

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

Failure usage(const std::string& what) { return Failure(kWrongUsage, what); }

void add_operand_options(const Command& sum, Options& options) {
  const char* const group = "What operands mean";
  add_fill_option(sum, options.fill).group(group);
  add_regularize_option(sum, options.regularize).group(group);
}

void add_output_options(const Command& sum, SumArguments& arguments) {
  add_result_options(sum, arguments, "sum");
  sum.add_flag("--keep-properties", arguments.keep_properties,
               "GeoJSON: a Feature with the properties of P, which is one");
  sum.add_option("--tight", arguments.tight, "Write placements without any play").type_name("FILE");
  sum.add_option("--stats", arguments.stats, "Write sizes, times and counts as JSON")
      .type_name("FILE");
  sum.add_option("--svg", arguments.picture, "Draw operands and sum").type_name("FILE");
  sum.add_option("--trace", arguments.trace, "Draw and write every stage into this folder")
      .type_name("DIR");
}

void add_test_options(const Command& sum, SumSettings& settings) {
  const char* const group = "For tests (the result is the same)";
  sum.add_flag(
         "--no-cover", [&settings] { settings.cover = false; },
         "No cover, no clipping: build the whole arrangement")
      .group(group);
  sum.add_option("--grid", settings.grid, "Cells along the side of the cover's grid that has more")
      .in_range(0, kMostCells)
      .group(group);
  add_choice(sum, "--arithmetic", kArithmetics, settings.arithmetic,
             "Force a number type: auto, narrow, medium, wide, arbitrary")
      .type_name("RUNG")
      .group(group);
  sum.add_flag(
         "--no-filter", [&settings] { settings.filter = false; },
         "Decide everything by exact arithmetic")
      .group(group);
  sum.add_flag("--check", settings.check, "Check each stage's result (slow)").group(group);
}

void convert_output(SumArguments& arguments) {
  convert_result(arguments);
  if (arguments.keep_properties && arguments.format != io::Format::kGeoJson) {
    throw usage("--keep-properties needs --format geojson");
  }
  if (arguments.keep_properties && arguments.each) {
    throw usage("--each keeps properties without --keep-properties");
  }
}

void convert_tight(SumArguments& arguments) {
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

Option add_regularize_option(const Command& command, bool& regularize) {
  return command.add_flag("--regularize,--regularise", regularize,
                          "Drop operands' polylines, points and spikes");
}

Option add_fill_option(const Command& command, FillRule& fill) {
  const Option rule =
      add_choice(command, "--fill", kFillRules, fill,
                 "automatic (outer rings less their holes, as OGC says; the default), evenodd, "
                 "nonzero, positive, negative, strict (valid polygons alone)")
          .type_name("RULE");
  command
      .add_flag(
          "--strict", [&fill] { fill = FillRule::kStrict; },
          "Refuse polygons that are not valid, as --fill strict")
      .excludes("--fill");
  return rule;
}

Command describe_sum(CommandLine& line, SumArguments& arguments, ProcessLimits& limits) {
  const Command sum = line.add_command("sum", "The Minkowski sum of two geometries");
  sum.footer(kSumFooter);
  add_operand(sum, "P", arguments.operands[0], "The first operand");
  add_operand(sum, "Q", arguments.operands[1], "The second operand");
  add_output_options(sum, arguments);
  add_choice(sum, "--method", kMethods, arguments.options.method,
             "reduced (the default), signed, full: the same sum by three methods")
      .type_name("M");
  sum.add_option("--repeat", arguments.repeat, "Compute N times and report median times")
      .in_range(1, 1'000'000)
      .type_name("N");
  sum.add_flag("-v,--verbose", arguments.verbose, "Say sizes and time on standard error");
  add_operand_options(sum, arguments.options);
  add_each_options(sum, arguments, {"--tight", "--svg", "--trace", "--repeat"});
  add_limit_options(sum, limits, true);
  add_test_options(sum, arguments.options);
  return sum;
}

void convert(SumArguments& arguments) {
  if (arguments.operands[0] == "-" && arguments.operands[1] == "-") {
    throw usage("P and Q cannot both be standard input");
  }
  convert_output(arguments);
  if (!arguments.tight.empty()) convert_tight(arguments);
  if (arguments.stats == "-" && arguments.output.empty()) {
    throw usage("--stats - needs -o FILE: standard output already takes the sum");
  }
  if (arguments.stats == "-" && arguments.tight == "-") {
    throw usage("--stats and --tight cannot both be standard output");
  }
  require_picture("--svg", arguments.picture);
  if (!arguments.trace.empty() && arguments.options.method == Method::kSigned) {
    throw usage("--trace shows the stages of the reduced and full methods, not of signed");
  }
}

}  // namespace minksum::cli
