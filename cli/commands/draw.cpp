// minksum draw: draws geometries as a picture.
#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <ostream>
#include <utility>

#include "commands/commands.hpp"
#include "commands/subcommands.hpp"
#include "minksum/resolve.hpp"
#include "options/result_options.hpp"
#include "options/sum_options.hpp"
#include "options/typed_numbers.hpp"
#include "output/output_file.hpp"
#include "output/picture_file.hpp"
#include "pictures/figure.hpp"
#include "pictures/text_layout.hpp"
#include "process/failure.hpp"

namespace minksum::cli {
namespace {

/// `minksum draw FILE...`
struct DrawArguments : FigureLook {
  std::vector<std::string> files;   ///< "-" = standard input
  std::string output;               ///< empty = standard output
  std::vector<std::string> styles;  ///< one for each file; empty = chosen by position
  std::vector<std::string> captions;
  bool faults = false;  ///< draw rings as they stand, with their faults
  bool labels = false;  ///< number the vertices
  int zoom = 0;         ///< the number of the file that is shown; 0 = all
  FillRule fill = FillRule::kAutomatic;
  io::ReadOptions limits;
};

constexpr const char* kDrawFooter = R"(
Several files lie on top of each other, the first one lowest, in one frame and to
one scale. Files as for `minksum sum`; one of them may be "-" for standard input.
)";

// The styles of layers, by the names that --as takes.
const std::map<std::string, std::string> kStyles = {{"first", "first"}, {"second", "second"},
                                                    {"result", "sum"},  {"result+tight", "sum"},
                                                    {"tight", "tight"}, {"outline", "outline"}};
constexpr const char* kStylesInTurn[] = {"first", "second", "result", "tight"};

const std::map<std::string, Theme> kThemes = {
    {"auto", Theme::kAuto}, {"light", Theme::kLight}, {"dark", Theme::kDark}};

constexpr double kMinWidth = 200;
constexpr double kMaxWidth = 10'000;

std::string style_of(const DrawArguments& arguments, std::size_t index) {
  if (!arguments.styles.empty()) return kStyles.at(arguments.styles[index]);
  return kStyles.at(index < std::size(kStylesInTurn) ? kStylesInTurn[index] : "outline");
}

std::string caption_of(const DrawArguments& arguments, std::size_t index) {
  if (index < arguments.captions.size()) return arguments.captions[index];
  const std::string& file = arguments.files[index];
  if (file == "-") return shown_name(file);
  // File names may have any bytes, but XML must be UTF-8 without control characters.
  return printable(std::filesystem::path(file).stem().string(),
                   [](std::string_view) { return "\ufffd"; });
}

Layer layer_of(const DrawArguments& arguments, std::size_t index, const Geometry& given) {
  Layer layer;
  if (arguments.faults) {
    layer.geometry = given;
    layer.faults = validate(given.region);
  } else {
    try {
      layer.geometry = resolve({given.region, {}, {}}, {.fill = arguments.fill});
    } catch (const Error& error) {
      throw failure_of(error, arguments.files[index]);
    }
    // Thin parts are drawn unresolved. Resolving would drop those inside the area, such as the
    // tight places of a no-fit polygon.
    std::ranges::copy(given.polylines, std::back_inserter(layer.geometry.polylines));
    std::ranges::copy(given.points, std::back_inserter(layer.geometry.points));
  }
  layer.style = style_of(arguments, index);
  layer.caption = caption_of(arguments, index);
  if (arguments.labels) layer.numbered = &given;
  return layer;
}

// Adds the layers of a file. Tight places look the same in all pictures, so they have their own.
void add_layers(const DrawArguments& arguments, std::size_t index, const Geometry& given,
                std::vector<Layer>& layers) {
  Layer layer = layer_of(arguments, index, given);
  Layer tight;
  if (!arguments.styles.empty() && arguments.styles[index] == "result+tight") {
    tight.geometry = Geometry({}, std::exchange(layer.geometry.polylines, {}),
                              std::exchange(layer.geometry.points, {}));
    tight.style = "tight";
    tight.caption = "Tight places";
  }
  layers.push_back(std::move(layer));
  if (!tight.geometry.empty()) layers.push_back(std::move(tight));
}

// Unlike a file name, a text from the command line is refused rather than mended silently.
void require_printable(const char* option, const std::string& text) {
  if (is_printable(text)) return;
  throw Failure(kWrongUsage,
                std::string(option) + " takes text in UTF-8 without control characters");
}

Extent parse_box(const std::string& text) {
  const auto numbers = parse_numbers("--bbox", text, 4, ',', "0,0,8,5.5");
  Extent box;
  for (int i : {0, 2}) {
    const auto at = static_cast<std::size_t>(i);
    box.include(numbers[at].to_double(), numbers[at + 1].to_double());
  }
  if (numbers[0] < numbers[2] && numbers[1] < numbers[3]) return box;
  throw Failure(kWrongUsage, "--bbox goes from the lower left corner to the upper right one");
}

// The box of a geometry with a tenth of its size around it.
Extent surroundings_of(const Geometry& geometry) {
  Extent box = extent_of(geometry);
  const double around = std::max(box.width(), box.height()) / 10;
  if (box.empty || !(around > 0)) return box;
  box.include(box.min_x - around, box.min_y - around);
  box.include(box.max_x + around, box.max_y + around);
  return box;
}

void add_look_options(const Command& command, DrawArguments& arguments) {
  command.add_option("--title", arguments.title, "A line above the picture").type_name("TEXT");
  add_choice(command, "--theme", kThemes, arguments.theme,
             "auto (as its surroundings; the default), light, dark")
      .type_name("THEME");
  command.add_option("--width", arguments.width, "Width in pixels (default 960)")
      .check(between(kMinWidth, kMaxWidth))
      .type_name("PX");
  command
      .add_option(
          "--bbox", [&arguments](const std::string& text) { arguments.view = parse_box(text); },
          "Show this box alone, and cut off what lies beyond")
      .type_name("X0,Y0,X1,Y1");
  command
      .add_option("--zoom", arguments.zoom,
                  "Show the surroundings of the N-th file alone, so that far parts of other files "
                  "do not shrink it")
      .in_range(1, 1'000'000)
      .type_name("N")
      .excludes("--bbox");
  command.add_flag("!--no-axes", arguments.axes, "Leave out axes and their numbers");
  command.add_flag("!--no-legend", arguments.legend, "Leave out the legend");
  command.add_flag("--labels", arguments.labels,
                   "Number vertices as messages do: from 1 in each ring, as read");
}

Command describe_draw(CommandLine& line, DrawArguments& arguments, ProcessLimits& limits) {
  const Command command = line.add_command("draw", "Geometries as a picture: SVG, PNG or PDF");
  command.footer(kDrawFooter);
  command.add_option("FILE", arguments.files, "What to draw").required().type_name("FILE");
  command
      .add_option("-o,--output", arguments.output,
                  "Write here, not to standard output: SVG, or PNG or PDF as the name ends")
      .type_name("FILE");
  command
      .add_option("--as", arguments.styles,
                  "What each file is, in their order: first, second, result, tight, outline, or "
                  "result+tight: a result whose polylines and points are tight places. Without it: "
                  "first, second, result, tight, then outlines")
      .one_of(names_of(kStyles))
      .delimiter(',')
      .repeats()
      .type_name("LAYER,...");
  command
      .add_option("--caption", arguments.captions,
                  "The legend's words for the first file, again for the next (default: names)")
      .repeats()
      .type_name("TEXT");
  add_look_options(command, arguments);
  add_fill_option(command, arguments.fill);
  command
      .add_flag("--faults", arguments.faults,
                "Draw rings as they stand, even-odd, and mark what makes polygons invalid")
      .excludes("--fill")
      .excludes("--strict");
  add_limit_options(command, limits, false);
  return command;
}

/// Converts and checks what no option can check alone. Throws a Failure for wrong usage.
void convert(DrawArguments& arguments) {
  require_printable("--title", arguments.title);
  for (const std::string& caption : arguments.captions) require_printable("--caption", caption);
  if (arguments.output == "-") arguments.output.clear();
  if (!arguments.output.empty()) require_picture("-o", arguments.output);
  const std::size_t count = arguments.files.size();
  if (std::count(arguments.files.begin(), arguments.files.end(), "-") > 1) {
    throw Failure(kWrongUsage, "only one FILE can be standard input");
  }
  if (!arguments.styles.empty() && arguments.styles.size() != count) {
    throw Failure(kWrongUsage, "--as takes one layer for each file, of which there are " +
                                   std::to_string(count));
  }
  if (arguments.zoom > 0 && static_cast<std::size_t>(arguments.zoom) > count) {
    throw Failure(kWrongUsage,
                  "--zoom takes the number of a file, of which there are " + std::to_string(count));
  }
  if (arguments.captions.size() > count) {
    throw Failure(kWrongUsage, "more captions than files");
  }
}

int run_draw(const DrawArguments& arguments) {
  OutputFiles files;
  files.expect("-o", arguments.output);
  std::vector<Geometry> given;
  for (const std::string& file : arguments.files) {
    // With --faults the picture shows the faults, so standard error need not tell them.
    given.push_back(arguments.faults
                        ? read_operand(file, arguments.limits).geometry
                        : read_operand(file, arguments.limits, arguments.fill).geometry);
  }
  Figure figure{arguments, {}};
  for (std::size_t i = 0; i < given.size(); ++i) {
    add_layers(arguments, i, given[i], figure.layers);
  }
  if (arguments.zoom > 0) {
    figure.view = surroundings_of(given[static_cast<std::size_t>(arguments.zoom) - 1]);
    if (figure.view->empty) figure.view.reset();
  }
  write_picture(files, arguments.output, [&] { return figure_picture(figure); });
  files.finish();
  return kFine;
}

}  // namespace

void add_draw(Program& program) { program.add(describe_draw, run_draw); }

}  // namespace minksum::cli
