// minksum transform, reflect and convert: move a set, mirror it, or write it in another format.
#include "minksum/transform.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "commands/operations.hpp"
#include "commands/subcommands.hpp"
#include "minksum/configuration_space.hpp"
#include "minksum/resolve.hpp"
#include "options/operation_options.hpp"
#include "options/result_options.hpp"
#include "options/sum_options.hpp"
#include "options/typed_numbers.hpp"
#include "output/numbers.hpp"
#include "pictures/sum_picture.hpp"
#include "process/failure.hpp"
#include "process/telling.hpp"

namespace minksum::cli {
namespace {

struct Words {
  const char* name;
  const char* what;
  const char* title;
};

/// By Operation.
constexpr Words kWords[] = {{"transform", "A set moved, scaled, turned or mapped exactly", "Image"},
                            {"reflect", "The point mirror: all points p become -p", "-A"},
                            {"convert", "The same set in another format", "A"}};

const Words& words_of(const TransformArguments& arguments) {
  return kWords[static_cast<std::size_t>(arguments.operation)];
}

// Numbers beyond the range of doubles stay, and are refused when they are written.
Point nearest_doubles(const Point& point) {
  const double x = point.x.to_double();
  const double y = point.y.to_double();
  return std::isfinite(x) && std::isfinite(y) ? Point{Rational(x), Rational(y)} : point;
}

// Rounds each coordinate by itself if what comes of it is valid, so that 0.1 stays 0.1. Beside thin
// parts, rounding as a whole moves to a coarser grid.
Geometry rounded_singly(Geometry set, const TransformArguments& arguments, const Options& part) {
  const bool to_doubles = arguments.coordinates.style == io::Coordinates::Style::kDouble &&
                          arguments.rounding == RoundingSide::kNearest;
  if (!to_doubles || !set.has_thin_parts() || set.region.empty()) return set;
  Geometry near;
  for (const std::size_t polygon : set.region.polygons()) {
    near.region.begin_polygon();
    for (const std::size_t ring : set.region.rings_of(polygon)) {
      near.region.begin_ring();
      for (const std::size_t vertex : set.region.vertices_of(ring)) {
        const Point moved = nearest_doubles(set.region.point(vertex));
        near.region.add_vertex(moved.x, moved.y);
      }
    }
  }
  near.polylines = set.polylines;
  near.points = set.points;
  const auto move = [](Point& point) { point = nearest_doubles(point); };
  for (Polyline& polyline : near.polylines) std::ranges::for_each(polyline, move);
  std::ranges::for_each(near.points, move);
  return resolve_with_tight_places(near, part) == near ? near : set;
}

// Keeps the tight places of a no-fit polygon. Errors are about the first operand.
Geometry meant_by(const Geometry& given, const Options& options) {
  Geometry set = resolve(given, options, 0);
  const bool may_be_tight = given.has_thin_parts() && !set.has_thin_parts();
  return may_be_tight ? resolve_with_tight_places(given, options) : set;
}

void draw_image(const TransformArguments& arguments, const Geometry& a, const Geometry&,
                const Geometry& result, OutputFiles& files) {
  const char* const title = words_of(arguments).title;
  const Captions captions{title, "A", nullptr, title};
  write_picture(
      files, arguments.picture,
      {resolve(a, {.fill = arguments.options.fill}), {}, result, nullptr, captions, true});
}

Point parse_scale(const std::string& text) {
  if (text.find(',') != std::string::npos) return parse_point("--scale", text);
  const Rational factor = parse_number("--scale", text);
  return {factor, factor};
}

void add_map_options(const Command& command, TransformArguments& arguments) {
  const char* const group = "The map, which does what is given in this order";
  const auto add = [&](const char* name, Command::Take take, const char* what, const char* type) {
    command.add_option(name, take, what).type_name(type).group(group);
  };
  add(
      "--scale", [&arguments](const auto& text) { arguments.scale = parse_scale(text); },
      "Multiply x and y by F, or x by FX and y by FY", "F|FX,FY");
  add(
      "--turn",
      [&arguments](const auto& text) { arguments.degrees = parse_number("--turn", text); },
      "Turn counter-clockwise; exactly for multiples of 90", "DEGREES");
  add(
      "--affine",
      [&arguments](const auto& text) {
        auto n = parse_numbers("--affine", text, 6, ',', "1,0,0,1,2.5,-2/3");
        arguments.affine = Affine{n[0], n[1], n[4], n[2], n[3], n[5]};
      },
      "Map (x, y) to (XX x + XY y + DX, YX x + YY y + DY)", "XX,XY,YX,YY,DX,DY");
  add(
      "--move", [&arguments](const auto& text) { arguments.move = parse_point("--move", text); },
      "Move", "DX,DY");
  add(
      "--about", [&arguments](const auto& text) { arguments.about = parse_point("--about", text); },
      "The point that --scale and --turn leave where it is (default: the origin)", "X,Y");
  command
      .add_option("--angle-tolerance", arguments.tolerance,
                  "How many degrees a turn may be off to be a rational one (default 0.001)")
      .check(between(1e-10, 1))
      .needs("--turn")
      .type_name("D")
      .group(group);
}

Affine linear(const Point& scale) { return {scale.x, 0, 0, 0, scale.y, 0}; }

void convert_map(TransformArguments& arguments) {
  if (arguments.operation == TransformArguments::Operation::kReflect) {
    arguments.map = Affine::scaling(-1);
  }
  if (arguments.operation != TransformArguments::Operation::kTransform) return;
  if (!arguments.scale && !arguments.degrees && !arguments.affine && !arguments.move) {
    throw Failure(kWrongUsage, "transform needs --scale, --turn, --affine or --move");
  }
  if (arguments.about && !arguments.scale && !arguments.degrees) {
    throw Failure(kWrongUsage, "--about has no meaning without --scale or --turn");
  }
  const Point about = arguments.about.value_or(Point());
  Affine map = Affine::translation(-about.x, -about.y);
  if (arguments.scale) map = linear(*arguments.scale).after(map);
  if (arguments.degrees) {
    const Turn turn = nearest_turn(*arguments.degrees, arguments.tolerance);
    if (turn.off > 0) {
      const Point to = turn.direction();
      arguments.turn_note = "--turn: by " + shortest(turn.degrees) + " degrees, whose cosine " +
                            to.x.to_string() + " and sine " + to.y.to_string() +
                            " are exact (--angle-tolerance)";
    }
    map = turn.map().after(map);
  }
  map = Affine::translation(about.x, about.y).after(map);
  if (arguments.affine) map = arguments.affine->after(map);
  if (arguments.move) map = Affine::translation(arguments.move->x, arguments.move->y).after(map);
  if ((map.xx * map.yy - map.xy * map.yx).sign() == 0) {
    throw Failure(kWrongUsage, "this map makes areas vanish: its determinant is 0");
  }
  arguments.map = std::move(map);
}

int run_transform(const TransformArguments& arguments) {
  if (!arguments.turn_note.empty()) note(arguments.turn_note);
  const auto compute = [](const TransformArguments& mine, const Geometry& a, const Geometry&) {
    return image(mine, a);
  };
  return run_operation(arguments, compute, draw_image);
}

}  // namespace

Geometry image(const TransformArguments& arguments, const Geometry& given) {
  const Geometry set = meant_by(given, arguments.options);
  Options part = arguments.options;
  part.fill = FillRule::kAutomatic;
  if (arguments.operation == TransformArguments::Operation::kConvert) {
    return rounded_singly(set, arguments, part);
  }
  const Geometry moved = resolve_with_tight_places(transform(set, arguments.map, part), part);
  return rounded_singly(moved, arguments, part);
}

Command describe_transform(CommandLine& line, TransformArguments& arguments,
                           ProcessLimits& limits) {
  const Words& words = words_of(arguments);
  const Command command = line.add_command(words.name, words.what);
  command.footer(
      "\nFiles as for `minksum sum`; FILE may be \"-\" for standard input. Numbers as 1.5 or "
      "2/3.\n");
  add_operand(command, "FILE", arguments.operands[0], "The set");
  if (arguments.operation == TransformArguments::Operation::kTransform) {
    add_map_options(command, arguments);
  }
  add_result_options(command, arguments, "result");
  add_fill_option(command, arguments.options.fill);
  add_regularize_option(command, arguments.options.regularize);
  add_picture_option(command, arguments.picture, "Draw A and the result");
  add_stats_option(command, arguments.stats);
  add_each_options(command, arguments, {"--svg"});
  add_limit_options(command, limits, true);
  return command;
}

void convert(TransformArguments& arguments) {
  convert_operation(arguments, arguments);
  convert_map(arguments);
}

void add_transform(Program& program) {
  using enum TransformArguments::Operation;
  for (const auto operation : {kTransform, kReflect, kConvert}) {
    TransformArguments arguments;
    arguments.operation = operation;
    program.add(describe_transform, run_transform, arguments);
  }
}

}  // namespace minksum::cli
