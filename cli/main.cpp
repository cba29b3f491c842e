// The program: arguments in, exit code out. Each subcommand has a file of its own.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <map>

#include "commands.hpp"
#include "failure.hpp"
#include "minksum/version.hpp"

namespace minksum::cli {
namespace {

constexpr const char* kFooter = R"(
Exit codes: 0 fine, 1 wrong usage, 2 bad input or unwritable output,
3 a stated limit exceeded, 4 internal error (with the stage's name).
Errors are one line on standard error: "minksum: FILE:LINE:COLUMN: what", or
"minksum: FILE: polygon K, ring R, vertex V: what"; all of these count from 1,
and ring 1 is the outer one.)";

constexpr const char* kSumFooter = R"(
P and Q are files, or one of them "-" for standard input: WKT, GeoJSON, .poly
or .dat, told by content. Numbers are read exactly: 0.1 is one tenth, 1/3 a third.
)";

constexpr int kMaxDecimals = 1000;

// Options as they are typed; turned into SumArguments when all of them are known.
struct TypedSum {
  std::string format;
  std::string coordinates = "double";
  bool no_cover = false;
  bool no_filter = false;
};

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

CLI::App* add_sum(CLI::App& app, SumArguments& arguments, TypedSum& typed) {
  CLI::App* sum = app.add_subcommand("sum", "The Minkowski sum of two regions");
  sum->footer(std::string(kSumFooter) + kFooter);
  sum->add_option("P", arguments.operands[0], "The first region")->required()->type_name("FILE");
  sum->add_option("Q", arguments.operands[1], "The second region")->required()->type_name("FILE");
  sum->add_option("-o,--output", arguments.output, "Write the sum here, not to standard output")
      ->type_name("FILE");
  sum->add_option("--format", typed.format,
                  "wkt, geojson, svg or poly; without it as the output's name ends, else wkt")
      ->check(CLI::IsMember(names_of(kFormats)))
      ->type_name("F");
  sum->add_option(
         "--coords", typed.coordinates,
         "double (nearest, shortest form; the default), exact (integers or p/q), decimal:N")
      ->type_name("C");
  sum->add_option_function<std::string>(
         "--method",
         [&arguments](const std::string& name) { arguments.options.method = kMethods.at(name); },
         "reduced (the default), signed, full: the same sum by three methods")
      ->check(CLI::IsMember(names_of(kMethods)))
      ->type_name("M");
  sum->add_option("--stats", arguments.stats, "Write sizes, times and counts as JSON")
      ->type_name("FILE");
  sum->add_option("--svg", arguments.picture, "Draw operands and sum")->type_name("FILE");
  sum->add_option("--trace", arguments.trace, "Draw and write every stage into this folder")
      ->type_name("DIR");
  sum->add_option("--repeat", arguments.repeat, "Compute N times and report median times")
      ->check(CLI::Range(1, 1'000'000))
      ->type_name("N");
  sum->add_flag("-v,--verbose", arguments.verbose, "Say sizes and time on standard error");
  add_test_options(*sum, arguments, typed);
  return sum;
}

CLI::App* add_info(CLI::App& app, InfoArguments& arguments) {
  CLI::App* info =
      app.add_subcommand("info", "What a region is: parts, holes, box, exact area, validity, bits");
  info->footer(std::string("\nExit code 2 if the region is not valid; all faults are listed.\n") +
               kFooter);
  info->add_option("FILE", arguments.file, "The region, or - for standard input")
      ->required()
      ->type_name("FILE");
  info->add_flag("--json", arguments.json, "As JSON");
  return info;
}

// What no option can see by itself.
void settle(SumArguments& arguments, const TypedSum& typed) {
  if (arguments.operands[0] == "-" && arguments.operands[1] == "-") {
    throw usage("P and Q cannot both be standard input");
  }
  if (arguments.output == "-") arguments.output.clear();
  if (arguments.stats == "-" && arguments.output.empty()) {
    throw usage("--stats - needs -o FILE: standard output already takes the sum");
  }
  if (arguments.picture == "-")
    throw usage("--svg needs a file (--format svg draws the sum alone)");
  if (!arguments.trace.empty() && arguments.options.method == Method::kSigned) {
    throw usage("--trace shows the stages of the reduced and full methods, not of signed");
  }
  arguments.coordinates = parse_coordinates(typed.coordinates);
  arguments.format = choose_format(typed.format, arguments.output);
  arguments.options.cover = !typed.no_cover;
  arguments.options.filter = !typed.no_filter;
}

int run(int argc, char** argv) {
  CLI::App app("Exact Minkowski sums of planar regions", "minksum");
  app.set_version_flag("--version", "minksum " MINKSUM_VERSION);
  app.footer(kFooter);
  app.require_subcommand(1);

  SumArguments sum_arguments;
  TypedSum typed;
  InfoArguments info_arguments;
  const CLI::App* const sum = add_sum(app, sum_arguments, typed);
  add_info(app, info_arguments);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {  // --help and --version
    const int code = app.exit(success);
    std::cout.flush();
    return code;
  } catch (const CLI::ParseError& error) {
    throw usage(std::string(error.what()) + " (minksum --help)");
  }
  if (!sum->parsed()) return run_info(info_arguments);
  settle(sum_arguments, typed);
  return run_sum(sum_arguments);
}

}  // namespace
}  // namespace minksum::cli

int main(int argc, char** argv) {
  try {
    return minksum::cli::run(argc, argv);
  } catch (...) {
    return minksum::cli::report_failure();
  }
}
