// minksum depth: tells how two shapes stand to each other.
#include <ostream>

#include "commands/commands.hpp"
#include "commands/operations.hpp"
#include "commands/subcommands.hpp"
#include "minksum/resolve.hpp"
#include "minksum/transform.hpp"
#include "options/operation_options.hpp"
#include "output/faults.hpp"
#include "output/json.hpp"
#include "output/numbers.hpp"
#include "output/output_file.hpp"
#include "pictures/sum_picture.hpp"
#include "process/failure.hpp"

namespace minksum::cli {
namespace {

Feature feature(const char* operand, const Region& region, std::size_t vertex) {
  Feature result{operand, {}};
  for (const std::size_t polygon : region.polygons()) {
    const IndexRange rings = region.rings_of(polygon);
    for (const std::size_t ring : rings) {
      const IndexRange vertices = region.vertices_of(ring);
      if (vertices.front() + vertices.size() <= vertex) continue;
      result.place.polygon = polygon;
      result.place.ring = ring - rings.front();
      result.place.vertex = vertex - vertices.front();
      return result;
    }
  }
  throw Error(ErrorCode::kInternal, "a contact names a vertex that there is not");
}

ContactList contacts_of(const EdgeOrigin& origin, const Geometry& a, const Geometry& b) {
  const bool of_first = origin.edge_operand == Operand::kFirst;
  const auto of = [&](bool first, std::size_t vertex) {
    return feature(first ? "A" : "B", first ? a.region : b.region, vertex);
  };
  return {of(of_first, origin.edge), of(!of_first, origin.vertex)};
}

const char* relation_of(const Depth& depth) {
  if (depth.overlapping) return "overlapping";
  return depth.squared.sign() == 0 ? "touching" : "apart";
}

void write_text(std::ostream& out, const DepthArguments& arguments, const DepthReport& findings) {
  const Depth& depth = findings.depth;
  out << "relation  " << relation_of(depth) << "\nx         " << readable(depth.vector.x)
      << "\ny         " << readable(depth.vector.y) << "\nsquared   " << readable(depth.squared)
      << "\ndistance  " << shortest(depth.distance) << '\n';
  if (findings.contacts) {
    const auto& [edge, vertex] = *findings.contacts;
    out << "contact   edge of " << edge.operand << " from " << describe(edge.place)
        << "\n          vertex of " << vertex.operand << ": " << describe(vertex.place) << '\n';
  } else {
    out << "contact   not known\n";
  }
  if (!arguments.along) return;
  out << "impact    " << (findings.impact ? readable(*findings.impact) : "never") << '\n';
}

Json feature_json(const Feature& feature) {
  return {{"of", feature.operand},
          {"polygon", feature.place.polygon + 1},
          {"ring", feature.place.ring + 1},
          {"vertex", feature.place.vertex + 1}};
}

[[noreturn]] void fail_about_empty_operand(const DepthArguments& arguments, const Geometry& a) {
  const Options reading{.fill = arguments.options.fill, .regularize = true};
  Culprit culprit;
  culprit.operand = resolve(a, reading).empty() ? 0 : 1;
  throw Error(ErrorCode::kBadInput, "there is no distance from a shape without area", culprit);
}

void draw(const DepthArguments& arguments, const Geometry& a, const Geometry& b, const Depth& depth,
          OutputFiles& files) {
  const Options reading{.fill = arguments.options.fill, .regularize = true};
  Geometry second = resolve(b, reading);
  const Geometry moved = transform(second, Affine::translation(depth.vector.x, depth.vector.y));
  const char* const title = depth.overlapping ? "B, separated" : "B, in contact";
  write_picture(
      files, arguments.picture,
      {resolve(a, reading), std::move(second), moved, nullptr, {title, "A", "B", title}, true});
}

}  // namespace

DepthReport find_depth(const DepthArguments& arguments, const Geometry& a, const Geometry& b) {
  std::optional<Depth> depth = penetration_depth(a, b, arguments.options);
  if (!depth) fail_about_empty_operand(arguments, a);
  DepthReport findings{std::move(*depth), {}, {}};
  if (findings.depth.contact) {
    findings.contacts.emplace(contacts_of(*findings.depth.contact, a, b));
  }
  if (arguments.along) {
    findings.impact = time_of_impact(a, b, *arguments.along, arguments.options);
  }
  return findings;
}

Json depth_json(const DepthArguments& arguments, const DepthReport& findings) {
  const Depth& depth = findings.depth;
  Json json{{"relation", relation_of(depth)},
            {"vector", {depth.vector.x.to_double(), depth.vector.y.to_double()}},
            {"vector_exact", {depth.vector.x.to_string(), depth.vector.y.to_string()}},
            {"distance", depth.distance},
            {"squared_exact", depth.squared.to_string()},
            {"contact", nullptr}};
  if (findings.contacts) {
    json["contact"] = {{"edge", feature_json(findings.contacts->edge)},
                       {"vertex", feature_json(findings.contacts->vertex)}};
  }
  if (arguments.along) {
    const auto& impact = findings.impact;
    json["impact"] = impact ? Json(impact->to_double()) : Json(nullptr);
    json["impact_exact"] = impact ? Json(impact->to_string()) : Json(nullptr);
  }
  return json;
}

namespace {

int run_depth(const DepthArguments& arguments) {
  run_on_operands(arguments, "", [&](const Geometry& a, const Geometry& b, OutputFiles& files) {
    const DepthReport findings = find_depth(arguments, a, b);
    if (!arguments.picture.empty()) draw(arguments, a, b, findings.depth, files);
    write_standard_output([&](std::ostream& out) {
      if (arguments.json) {
        out << depth_json(arguments, findings).dump(2) << '\n';
      } else {
        write_text(out, arguments, findings);
      }
    });
  });
  return kFine;
}

}  // namespace

void add_depth(Program& program) { program.add(add_depth, run_depth); }

}  // namespace minksum::cli
