// minksum nfp and ifp: tell where a part can be placed.
#include <array>
#include <memory>
#include <mutex>
#include <ostream>
#include <utility>

#include "commands/commands.hpp"
#include "commands/operations.hpp"
#include "commands/subcommands.hpp"
#include "minksum/measure.hpp"
#include "minksum/resolve.hpp"
#include "options/operation_options.hpp"
#include "output/numbers.hpp"
#include "output/output_file.hpp"
#include "output/result_file.hpp"
#include "pictures/sum_picture.hpp"
#include "process/failure.hpp"
#include "process/telling.hpp"

namespace minksum::cli {
namespace {

const char* to_string(Contact contact) {
  constexpr const char* kNames[] = {"free", "touching", "overlapping"};
  return kNames[static_cast<std::size_t>(contact)];
}

Geometry without_thin_parts(const Geometry& geometry) { return {geometry.region, {}, {}}; }

Geometry thin_parts_of(const Geometry& geometry) {
  return {{}, geometry.polylines, geometry.points};
}

void draw(const NoFitArguments& arguments, const Geometry& fixed, const Geometry& moving,
          const Geometry& polygon, OutputFiles& files) {
  const Options reading{.fill = arguments.options.fill, .regularize = true};
  const Geometry area = without_thin_parts(polygon);
  const Geometry tight = thin_parts_of(polygon);
  const Captions captions = arguments.inner_fit
                                ? Captions{"Inner-fit polygon", "Bin", "Part", "Inner-fit polygon"}
                                : Captions{"No-fit polygon", "Fixed", "Moving", "No-fit polygon"};
  // A part without a reference point has failed before this point.
  const Point mark = *reference_of(arguments, moving);
  write_picture(
      files, arguments.picture,
      {resolve(fixed, reading), resolve(moving, reading), area, &tight, captions, true, mark});
}

void write_contacts(const NoFitArguments& arguments, const Geometry& fixed,
                    const Geometry& moving) {
  const std::vector<const char*> answers = contacts(arguments, fixed, moving);
  write_standard_output([&](std::ostream& out) {
    for (const char* const answer : answers) out << answer << '\n';
  });
}

// No area is left of a shape of polylines and points, so its no-fit polygon is empty. That would
// say that such a part may lie anywhere.
void require_areas(const NoFitArguments& arguments, const Geometry& fixed, const Geometry& moving) {
  Options reading = arguments.options;
  reading.regularize = true;
  const Geometry* const shapes[] = {&fixed, &moving};
  for (int i = 0; i < 2; ++i) {
    if (shapes[i]->empty() || !resolve(*shapes[i], reading, i).region.empty()) continue;
    throw Error(ErrorCode::kBadInput,
                "a part without area has no no-fit polygon; give its lines and points a width "
                "first (minksum offset)",
                {.operand = i});
  }
}

void note_thin_parts(const std::string& file) {
  note(shown_name(file) + ": polylines and points are left out; areas alone count");
}

// Returns the point at which a plate of this shape balances.
Point centroid(const Region& region) {
  Rational doubled;
  Rational x;
  Rational y;
  for (const std::size_t polygon : region.polygons()) {
    for (const std::size_t ring : region.rings_of(polygon)) {
      const IndexRange vertices = region.vertices_of(ring);
      Point from = region.point(vertices.front() + vertices.size() - 1);
      for (const std::size_t vertex : vertices) {
        Point to = region.point(vertex);
        const Rational cross = from.x * to.y - to.x * from.y;
        doubled = doubled + cross;
        x = x + cross * (from.x + to.x);
        y = y + cross * (from.y + to.y);
        from = std::move(to);
      }
    }
  }
  const Rational thrice = doubled * Rational(3);
  return {x / thrice, y / thrice};
}

// Says which point of the part results are about.
std::string described_reference(const NoFitArguments& arguments, const Geometry& moving) {
  constexpr const char* kNames[] = {"first vertex", "lower left corner", "centroid", "point"};
  const auto reference = reference_of(arguments, moving);
  if (!reference) return "the part has no vertex, and so no reference point";
  return std::string("placements are those of the ") +
         (arguments.inner_fit ? "part" : "moving part") + "'s " +
         kNames[static_cast<std::size_t>(arguments.named)] + ", (" + in_decimals(reference->x) +
         ", " + in_decimals(reference->y) + ") (--reference)";
}

}  // namespace

std::optional<Point> reference_of(const NoFitArguments& arguments, const Geometry& moving) {
  using enum NoFitArguments::Reference;
  if (arguments.named == kPoint) return arguments.reference;
  if (arguments.named == kFirst) {
    return moving.region.empty() ? std::nullopt : std::optional(moving.region.point(0));
  }
  Options reading = arguments.options;
  reading.regularize = true;
  const Region part = resolve(moving, reading, 1).region;
  if (part.empty()) {
    throw Error(ErrorCode::kBadInput,
                "a part without area has no lower left corner and no centroid (--reference)",
                {.operand = 1});
  }
  return arguments.named == kLowerLeft ? bounding_box(part)->min : centroid(part);
}

Geometry fit_polygon(const NoFitArguments& arguments, const Geometry& fixed,
                     const Geometry& moving) {
  const auto reference = reference_of(arguments, moving);
  if (arguments.inner_fit) return inner_fit_polygon(fixed, moving, reference, arguments.options);
  Geometry polygon = no_fit_polygon(fixed, moving, reference, arguments.options);
  if (polygon.empty()) require_areas(arguments, fixed, moving);
  return polygon;
}

Json contacts_json(const std::vector<const char*>& answers, const std::optional<Point>& reference) {
  Json list = Json::array();
  for (const char* const answer : answers) list.push_back(answer);
  Json json{{"contacts", list}};
  if (reference) json["reference"] = {reference->x.to_string(), reference->y.to_string()};
  return json;
}

std::vector<const char*> contacts(const NoFitArguments& arguments, const Geometry& fixed,
                                  const Geometry& moving) {
  const NoFitPolygon polygon(fixed, moving, reference_of(arguments, moving), arguments.options);
  if (polygon.geometry().empty()) require_areas(arguments, fixed, moving);
  std::vector<const char*> answers;
  for (const Point& placement : arguments.placements) {
    answers.push_back(to_string(polygon.contact(placement)));
  }
  return answers;
}

namespace {

int run_each_no_fit(const NoFitArguments& arguments) {
  if (arguments.placements.empty()) {
    const auto told = std::make_shared<std::once_flag>();
    return run_each(arguments, [told](const NoFitArguments& mine, const Geometry& fixed,
                                      const Geometry& moving, Worker& worker) {
      std::call_once(*told, [&] { note(described_reference(mine, moving)); });
      return rounded(fit_polygon(mine, fixed, moving), mine, worker.notes);
    });
  }
  return run_each(arguments, [](const NoFitArguments& mine, const Geometry& fixed,
                                const Geometry& moving, Worker&) {
    return contacts_json(contacts(mine, fixed, moving), reference_of(mine, moving));
  });
}

int run_no_fit(const NoFitArguments& arguments) {
  if (arguments.each) return run_each_no_fit(arguments);
  bool fits = true;
  std::string reference;
  std::array<bool, 2> thin{};
  run_on_operands(arguments, [&](const NoFitArguments& mine, const Geometry& fixed,
                                 const Geometry& moving, OutputFiles& files) {
    reference = described_reference(mine, moving);
    thin = {fixed.has_thin_parts(), moving.has_thin_parts()};
    if (!mine.placements.empty()) return write_contacts(mine, fixed, moving);
    const Geometry polygon = fit_polygon(mine, fixed, moving);
    const Geometry written = made_for(mine.output, [&] { return rounded(polygon, mine); });
    note_lost_parts(polygon, written, mine.rounding);
    write_geometry(files, mine, written);
    if (!mine.picture.empty()) draw(mine, fixed, moving, polygon, files);
    fits = !polygon.empty();
  });
  note(reference);
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    if (thin[i]) note_thin_parts(arguments.operands[i]);
  }
  if (arguments.inner_fit && !fits) {
    note("the part (" + shown_name(arguments.operands[1]) + ") does not fit into the bin (" +
         shown_name(arguments.operands[0]) + ")");
  }
  return kFine;
}

}  // namespace

void add_no_fit(Program& program) {
  for (const bool inner_fit : {false, true}) {
    NoFitArguments arguments;
    arguments.inner_fit = inner_fit;
    program.add(describe_no_fit, run_no_fit, arguments);
  }
}

}  // namespace minksum::cli
