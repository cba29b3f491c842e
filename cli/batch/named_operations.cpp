#include "batch/named_operations.hpp"

#include <algorithm>
#include <sstream>
#include <type_traits>

#include "commands/operations.hpp"
#include "options/operation_options.hpp"
#include "options/sum_options.hpp"
#include "output/result_file.hpp"
#include "process/failure.hpp"

namespace minksum::cli {
namespace {

/// An operation as its maker returns it, with the rule by which it reads operands.
struct Made {
  FillRule fill;
  decltype(ReadyOperation::run) run;
  std::string note;
};
using Cancel = std::optional<CancelToken>;

// Parses one list of options with the subcommand that has them.
class Parser {
 public:
  Parser(const char* name, int operands, const std::vector<OptionText>& options) : name_(name) {
    words_ = {name};
    words_.insert(words_.end(), static_cast<std::size_t>(operands), "FILE");
    for (const OptionText& option : options) {
      words_.insert(words_.end(), option.words.begin(), option.words.end());
    }
  }
  [[nodiscard]] const char* name() const { return name_; }
  CommandLine& line() { return line_; }
  // Parses the options. The subcommand must have been added to the line.
  void parse() { static_cast<void>(line_.parse(words_)); }

 private:
  const char* name_;
  std::vector<std::string> words_;
  CommandLine line_;
};

std::string point_text(const Point& point) {
  return Json({point.x.to_string(), point.y.to_string()}).dump();
}

void require_json_format(const ResultArguments& arguments) {
  if (arguments.format == io::Format::kWkt || arguments.format == io::Format::kGeoJson) return;
  throw Failure(kWrongUsage, "--format takes wkt or geojson here");
}

std::string result_json(const Geometry& geometry, const ResultArguments& arguments,
                        const char* key = "result") {
  io::Coordinates coordinates = arguments.coordinates;
  coordinates.cancel = arguments.cancel;
  return std::string("\"") + key + "\":" + geometry_json(geometry, arguments.format, coordinates);
}

// Returns the arguments of an operation after `describe` has added it to the parser's line.
template <class Arguments>
Arguments parsed(Parser& parser, ProcessLimits& limits, auto describe, Arguments arguments) {
  describe(parser.line(), arguments, limits);
  parser.parse();
  convert(arguments);
  if constexpr (std::is_base_of_v<ResultArguments, Arguments>) require_json_format(arguments);
  arguments.options.limits = limits.sum;
  return arguments;
}

// Rounds the geometry. The worker's notes get what that loses.
std::string rounded_json(const Geometry& geometry, const ResultArguments& arguments, Worker& worker,
                         const char* key = "result") {
  return result_json(rounded(geometry, arguments, worker.notes), arguments, key);
}

// Makes an operation that calls answer(arguments, a, b, worker), where the arguments have the job's
// token.
template <class Arguments>
Made made(const Arguments& arguments, auto answer) {
  return {arguments.options.fill,
          [arguments, answer](const Geometry& a, const Geometry& b, const Cancel& cancel,
                              Worker& worker) {
            Arguments mine = arguments;
            mine.options.cancel = cancel;
            if constexpr (std::is_base_of_v<ResultArguments, Arguments>) {
              mine.cancel = cancel;
              set_system(mine.coordinates, worker.system);
            }
            return answer(mine, a, b, worker);
          },
          {}};
}

Made make_sum(Parser& parser, ProcessLimits& limits) {
  bool tight = false;
  const auto describe = [&tight](CommandLine& line, SumArguments& arguments, ProcessLimits& mine) {
    const Command command = describe_sum(line, arguments, mine);
    command.remove_option("--tight");  // in the subcommand it takes the name of a file
    command.add_flag("--tight", tight);
    arguments.options.threads = 1;  // jobs share the threads
  };
  const SumArguments arguments = parsed(parser, limits, describe, SumArguments());
  if (tight && arguments.options.method != Method::kReduced) {
    throw Failure(kWrongUsage, "--tight needs the reduced method");
  }
  const auto run = [arguments, tight](const Geometry& a, const Geometry& b, const Cancel& cancel,
                                      Worker& worker) {
    ResultArguments rounding = arguments;
    rounding.cancel = cancel;
    set_system(rounding.coordinates, worker.system);
    SumSettings settings = arguments.options;
    settings.cancel = cancel;
    settings.memory = &worker.memory;
    if (!tight) return rounded_json(minkowski_sum(a, b, settings), rounding, worker);
    settings.tight = true;
    const DetailedSum sum = detailed_sum(a, b, settings);
    const std::string json = rounded_json(sum.sum, rounding, worker);
    rounding.rounding = RoundingSide::kNearest;
    return json + "," + rounded_json(sum.tight, rounding, worker, "tight");
  };
  return {arguments.options.fill, run, {}};
}

template <MorphologyArguments::Operation operation>
Made make_morphology(Parser& parser, ProcessLimits& limits) {
  MorphologyArguments arguments;
  arguments.operation = operation;
  return made(parsed(parser, limits, describe_morphology, arguments),
              [](const MorphologyArguments& mine, const Geometry& a, const Geometry& b,
                 Worker& worker) { return rounded_json(morphology(mine, a, b), mine, worker); });
}

template <BooleanArguments::Operation operation>
Made make_boolean(Parser& parser, ProcessLimits& limits) {
  BooleanArguments arguments;
  arguments.operation = operation;
  const auto describe = [](CommandLine& line, BooleanArguments& mine, ProcessLimits& most) {
    describe_boolean(line, mine, most);
  };
  return made(parsed(parser, limits, describe, arguments),
              [](const BooleanArguments& mine, const Geometry& a, const Geometry& b,
                 Worker& worker) { return rounded_json(combined(mine, a, b), mine, worker); });
}

template <TransformArguments::Operation operation>
Made make_transform(Parser& parser, ProcessLimits& limits) {
  TransformArguments arguments;
  arguments.operation = operation;
  const auto describe = [](CommandLine& line, TransformArguments& mine, ProcessLimits& most) {
    describe_transform(line, mine, most);
  };
  arguments = parsed(parser, limits, describe, arguments);
  Made image_of =
      made(arguments, [](const TransformArguments& mine, const Geometry& a, const Geometry&,
                         Worker& worker) { return rounded_json(image(mine, a), mine, worker); });
  image_of.note = arguments.turn_note;
  return image_of;
}

template <bool inner_fit>
Made make_no_fit(Parser& parser, ProcessLimits& limits) {
  NoFitArguments arguments;
  arguments.inner_fit = inner_fit;
  return made(parsed(parser, limits, describe_no_fit, arguments),
              [](const NoFitArguments& mine, const Geometry& a, const Geometry& b, Worker& worker) {
                const auto reference = reference_of(mine, b);
                if (!mine.placements.empty()) {
                  return "\"result\":" + contacts_json(contacts(mine, a, b), reference).dump();
                }
                // This refuses a part without a reference point.
                const std::string polygon = rounded_json(fit_polygon(mine, a, b), mine, worker);
                return polygon + ",\"reference\":" + point_text(*reference);
              });
}

Made make_depth(Parser& parser, ProcessLimits& limits) {
  return made(parsed(parser, limits, describe_depth, DepthArguments()),
              [](const DepthArguments& mine, const Geometry& a, const Geometry& b, Worker&) {
                return "\"result\":" + depth_json(mine, find_depth(mine, a, b)).dump();
              });
}

Made make_offset(Parser& parser, ProcessLimits& limits) {
  return made(parsed(parser, limits, describe_offset, OffsetArguments()),
              [](const OffsetArguments& mine, const Geometry& a, const Geometry&, Worker& worker) {
                const Geometry result = offset(a, mine.distance, mine.shape, mine.options);
                return rounded_json(result, mine, worker);
              });
}

// One operation: its name, its maker, its options beside limits, and its number of operands.
struct Entry {
  const char* name;
  Made (*make)(Parser& parser, ProcessLimits& limits);
  std::vector<std::string> options;
  int operands = 2;
};

const std::vector<Entry>& operations() {
  using enum MorphologyArguments::Operation;
  using enum BooleanArguments::Operation;
  using enum TransformArguments::Operation;
  static const std::vector<std::string> kMorphology{"fill",   "strict", "tight",
                                                    "format", "coords", "round"};
  static const std::vector<std::string> kSets{"fill",   "strict", "regularize", "regularise",
                                              "format", "coords", "round"};
  static const std::vector<Entry> kOperations{
      {"sum",
       make_sum,
       {"fill", "strict", "regularize", "regularise", "method", "tight", "format", "coords",
        "round"}},
      {"dilate", make_morphology<kDilate>, kMorphology},
      {"erode", make_morphology<kErode>, kMorphology},
      {"open", make_morphology<kOpen>, kMorphology},
      {"close", make_morphology<kClose>, kMorphology},
      {"nfp",
       make_no_fit<false>,
       {"fill", "strict", "reference", "at", "format", "coords", "round"}},
      {"ifp", make_no_fit<true>, {"fill", "strict", "reference", "format", "coords", "round"}},
      {"depth", make_depth, {"fill", "strict", "along"}},
      {"offset",
       make_offset,
       {"distance", "join", "cap", "miter-limit", "mitre-limit", "tolerance", "side", "fill",
        "strict", "format", "coords", "round"},
       1},
      {"union", make_boolean<kUnion>, kSets},
      {"intersection", make_boolean<kIntersection>, kSets},
      {"difference", make_boolean<kDifference>, kSets},
      {"symdiff", make_boolean<kSymmetricDifference>, kSets},
      {"transform",
       make_transform<kTransform>,
       {"scale", "turn", "affine", "move", "about", "angle-tolerance", "fill", "strict",
        "regularize", "regularise", "format", "coords", "round"},
       1},
      {"reflect", make_transform<kReflect>, kSets, 1},
      {"convert", make_transform<kConvert>, kSets, 1}};
  return kOperations;
}

// These options take true or false; all others have a value.
constexpr const char* kFlags[] = {"regularize", "regularise", "strict", "tight", "drop-z"};

// These options say how operands are read, and what a job may take.
constexpr const char* kLimitOptions[] = {
    "max-vertices", "max-bytes", "max-segments", "max-crossings", "timeout", "drop-z", "column"};

const Entry& entry_of(const std::string& name) {
  std::string names;
  for (const Entry& entry : operations()) {
    if (entry.name == name) return entry;
    names += (names.empty() ? "" : ", ") + std::string(entry.name);
  }
  throw Failure(kWrongUsage, "there is no operation '" + name + "'; there are " + names);
}

bool has_own_option(const Entry& entry, const std::string& name) {
  return std::ranges::find(entry.options, name) != entry.options.end();
}

// Only listed options pass, because the subcommand would also take options that name files.
void require_known(const Entry& entry, const std::vector<OptionText>& typed) {
  for (const OptionText& option : typed) {
    const bool is_limit = std::ranges::find(kLimitOptions, option.name) != std::end(kLimitOptions);
    if (!is_limit && !has_own_option(entry, option.name)) {
      throw Failure(kWrongUsage,
                    std::string(entry.name) + " has no option '" + option.name + "' in a job");
    }
    const std::string name = "--" + option.name;
    const bool is_boolean = option.is_off || option.words.front() == name;
    const bool is_flag = std::ranges::find(kFlags, option.name) != std::end(kFlags);
    if (is_flag && !is_boolean) throw Failure(kWrongUsage, name + " takes true or false");
    if (!is_flag && is_boolean) throw Failure(kWrongUsage, name + " takes no such value");
  }
}

bool holds(const std::vector<OptionText>& options, const std::string& name) {
  return std::ranges::find(options, name, &OptionText::name) != options.end();
}
bool asks_for(const std::vector<OptionText>& options, const std::string& flag) {
  const auto found = std::ranges::find(options, flag, &OptionText::name);
  return found != options.end() && !found->is_off;
}

}  // namespace

ReadyOperation ready_operation(const std::string& name, const std::vector<OptionText>& typed,
                               const std::vector<OptionText>& defaults,
                               const ProcessLimits& limits) {
  const Entry& entry = entry_of(name);
  require_known(entry, typed);
  std::vector<OptionText> all = typed;
  for (const OptionText& option : defaults) {
    const bool at = option.name == "format" || option.name == "coords" || option.name == "round";
    if (at && holds(typed, "at")) continue;  // the answers of --at are not a geometry
    if (option.name == "fill" && asks_for(typed, "strict")) continue;
    if (!has_own_option(entry, option.name) || holds(typed, option.name)) continue;
    all.push_back(option);
    *option.is_taken = true;
  }
  Parser parser(entry.name, entry.operands, all);
  ProcessLimits mine = limits;
  ReadyOperation operation;
  operation.operands = entry.operands;
  Made made = entry.make(parser, mine);
  operation.fill = made.fill;
  operation.run = std::move(made.run);
  operation.note = std::move(made.note);
  operation.limits = mine.read;
  operation.seconds = mine.seconds;
  return operation;
}

std::string geometry_json(const Geometry& geometry, io::Format format,
                          const io::Coordinates& coordinates) {
  std::ostringstream text;
  text.exceptions(std::ios::badbit);  // without this, a lack of memory just shortens the text
  const bool wkt = format == io::Format::kWkt;
  if (wkt) text << R"({"wkt":")";
  io::write(text, geometry, format, coordinates);
  if (wkt) text << "\"}";
  return std::move(text).str();
}

}  // namespace minksum::cli
