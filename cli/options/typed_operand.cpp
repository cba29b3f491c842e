#include "options/typed_operand.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "help/spelling.hpp"
#include "minksum/configuration_space.hpp"
#include "minksum/offset.hpp"
#include "options/typed_numbers.hpp"
#include "options/unused_options.hpp"
#include "output/numbers.hpp"
#include "process/failure.hpp"
#include "process/telling.hpp"

namespace minksum::cli {
namespace {

constexpr int kMostCorners = 100'000;

Rational positive(const std::string& name, const std::string& text) {
  Rational number = parse_number(name, text);
  if (number.sign() > 0) return number;
  throw Failure(kWrongUsage, name + " takes numbers above 0, not '" + text + "'");
}

// What stands for a round shape may be off by so much if nothing else is asked for.
Rational tolerance_of(const io::DrawingOptions& drawing, const Rational& radius) {
  constexpr int kParts = 1000;
  return drawing.tolerance ? *drawing.tolerance : radius / Rational(kParts);
}

Geometry disc_of(const std::string& operand, const std::string& text,
                 const io::DrawingOptions& drawing) {
  const Rational radius = positive("disc:R", text);
  const Rational tolerance = tolerance_of(drawing, radius);
  Geometry made = disc(radius, tolerance, drawing.side);
  constexpr const char* kWhere[] = {"within ", "around the disc, by at most ",
                                    "inside the disc, by at most "};
  const auto side = static_cast<std::size_t>(drawing.side);
  note(operand + ": a polygon of " + std::to_string(made.region.vertex_count()) + " vertices, " +
       kWhere[side] + shortest(tolerance.to_double()) + (side == 0 ? " of the disc" : "") +
       " (--tolerance, --side)");
  return made;
}

Geometry box_of(const std::string& text) {
  const std::string lower = in_lower_case(text);
  const std::size_t between = lower.find('x');
  if (between == std::string::npos) {
    throw Failure(kWrongUsage, "box:WxH takes two numbers as box:3x1.5, not 'box:" + text + "'");
  }
  const Rational half(Decimal{5, -1});
  const Rational x = positive("box:WxH", lower.substr(0, between)) * half;
  const Rational y = positive("box:WxH", lower.substr(between + 1)) * half;
  return Region(Polygon{{{-x, -y}, {x, -y}, {x, y}, {-x, y}}, {}});
}

// Returns the corners of the regular polygon that has one on the positive x axis. They lie on the
// circle exactly, but only for four corners are the angles between them those of the polygon, too.
Geometry ngon_of(const std::string& operand, const std::string& text,
                 const io::DrawingOptions& drawing) {
  const std::size_t between = text.find(':');
  int corners = 0;
  const char* const end = text.data() + std::min(between, text.size());
  const auto [stop, error] = std::from_chars(text.data(), end, corners);
  if (between == std::string::npos || error != std::errc() || stop != end || corners < 3 ||
      corners > kMostCorners) {
    throw Failure(kWrongUsage, "ngon:N:R takes from 3 to " + std::to_string(kMostCorners) +
                                   " corners and a radius as ngon:6:1.5, not '" + operand + "'");
  }
  const Rational radius = positive("ngon:N:R", text.substr(between + 1));
  const bool exact = corners == 4;
  if (!exact && drawing.side != RoundingSide::kNearest) {
    throw Failure(kWrongUsage, operand +
                                   " has irrational corners, which are only taken to the "
                                   "nearest; --side is for discs and drawings");
  }
  // An arc of a degree is shorter than a fiftieth of the radius.
  constexpr int kDegreesPerRadius = 50;
  constexpr double kFinest = 1e-10;
  const Rational tolerance = tolerance_of(drawing, radius);
  const Rational degrees = tolerance / radius * Rational(kDegreesPerRadius);
  const double between_corners = 360.0 / corners;
  if (!exact && degrees < Rational(kFinest)) {
    throw Failure(kWrongUsage,
                  operand + " takes a --tolerance from " +
                      shortest((radius * Rational(kFinest)).to_double() / kDegreesPerRadius) +
                      " on");
  }
  Polygon polygon;
  for (int k = 0; k < corners; ++k) {
    const Rational angle(360 * k, corners);
    const Turn turn =
        nearest_turn(angle, std::min({1.0, between_corners / 4, degrees.to_double()}));
    const Point direction = turn.direction();
    polygon.outer.push_back({direction.x * radius, direction.y * radius});
  }
  if (!exact) {
    note(operand + ": corners on the circle, within " + shortest(tolerance.to_double()) +
         " of the regular polygon's (--tolerance)");
  }
  return Region(polygon);
}

// A copy of a file may be called `polygon (1).wkt`, or lie in a folder `Points (old)`. Nobody types
// WKT that ends as the names of files do, or that is the name of a file.
bool is_name_of_file(const std::string& operand) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const std::string ending = std::filesystem::path(operand).extension().string();
  if (ending.size() > 1 && is_letter(ending[1]) &&
      std::all_of(ending.begin() + 1, ending.end(),
                  [&](char c) { return is_letter(c) || (c >= '0' && c <= '9'); })) {
    return true;
  }
  std::error_code ignored;
  return std::filesystem::exists(operand, ignored);
}

}  // namespace

bool is_typed_wkt(const std::string& operand) {
  constexpr std::array<std::string_view, 9> kWords = {
      "point",        "linestring",         "polygon",    "multipoint", "multilinestring",
      "multipolygon", "geometrycollection", "linearring", "srid="};
  const std::size_t begin = operand.find_first_not_of(" \t\r\n");
  if (begin == std::string::npos) return false;
  const std::string text = in_lower_case(std::string_view(operand).substr(begin));
  return std::ranges::any_of(kWords, [&](auto word) { return text.starts_with(word); }) &&
         (text.find('(') != std::string::npos || text.find(" empty") != std::string::npos) &&
         !is_name_of_file(operand);
}

std::optional<Geometry> named_shape(const std::string& operand, const io::DrawingOptions& drawing) {
  const std::size_t colon = operand.find(':');
  if (colon == std::string::npos) return {};
  const std::string name = in_lower_case(operand.substr(0, colon));
  const std::string rest = operand.substr(colon + 1);
  if (name != "disc" && name != "disk" && name != "box" && name != "ngon") return {};
  std::error_code ignored;
  if (std::filesystem::exists(operand, ignored)) {
    note(operand + " is taken as a shape; the file of that name is ./" + operand);
  }
  if (name == "box") return box_of(rest);
  mark_taken(ReadingOption::kTolerance);
  mark_taken(ReadingOption::kSide);
  if (name == "ngon") return ngon_of(operand, rest, drawing);
  return disc_of(operand, rest, drawing);
}

}  // namespace minksum::cli
