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
#include "output/picture_file.hpp"
#include "pictures/figure.hpp"
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

Options reading_of(const DepthArguments& arguments) {
  return {.fill = arguments.options.fill, .regularize = arguments.options.regularize};
}

[[noreturn]] void fail_about_empty_operand(const DepthArguments& arguments, const Geometry& a) {
  Culprit culprit;
  culprit.operand = resolve(a, reading_of(arguments)).empty() ? 0 : 1;
  throw Error(ErrorCode::kBadInput, "there is no distance from an empty shape", culprit);
}

// Returns a point of a shape that is not empty.
Point first_point(const Geometry& shape) {
  if (!shape.region.empty()) return shape.region.point(0);
  return shape.polylines.empty() ? shape.points.front() : shape.polylines.front().front();
}

Point sum_of(const Point& p, const Point& q) { return {p.x + q.x, p.y + q.y}; }

// Returns the vertex after this one in its ring.
std::size_t next_vertex(const Region& region, std::size_t vertex) {
  for (const std::size_t polygon : region.polygons()) {
    for (const std::size_t ring : region.rings_of(polygon)) {
      const IndexRange vertices = region.vertices_of(ring);
      const std::size_t end = vertices.front() + vertices.size();
      if (vertex < end) return vertex + 1 < end ? vertex + 1 : vertices.front();
    }
  }
  throw Error(ErrorCode::kInternal, "a contact names a vertex that there is not");
}

// The edge and the vertex that touch once B has moved.
Geometry contact_of(const EdgeOrigin& origin, const Geometry& a, const Geometry& b,
                    const Point& move) {
  const auto at = [&](bool first, std::size_t vertex) {
    return first ? a.region.point(vertex) : sum_of(b.region.point(vertex), move);
  };
  const bool of_first = origin.edge_operand == Operand::kFirst;
  const Region& region = of_first ? a.region : b.region;
  return {{},
          {{at(of_first, origin.edge), at(of_first, next_vertex(region, origin.edge))}},
          {at(!of_first, origin.vertex)}};
}

std::string vector_text(const Point& vector) {
  return "moved by (" + shortest(vector.x.to_double()) + ", " + shortest(vector.y.to_double()) +
         ")";
}

// An arrow shows the way of the point of B that touches A in the end.
void draw(const DepthArguments& arguments, const Geometry& a, const Geometry& b, const Depth& depth,
          OutputFiles& files) {
  const Options reading = reading_of(arguments);
  const Geometry second = resolve(b, reading);
  const Geometry moved = transform(second, Affine::translation(depth.vector.x, depth.vector.y));
  Figure figure;
  figure.layers = {{resolve(a, reading), "first", "A"},
                   {second, "second", "B"},
                   {moved, "sum", "B, " + vector_text(depth.vector)}};
  Point end = sum_of(first_point(second), depth.vector);
  if (depth.contact) {
    Geometry contact = contact_of(*depth.contact, a, b, depth.vector);
    end = contact.points.front();
    const bool of_a = depth.contact->edge_operand == Operand::kFirst;
    const char* const name =
        of_a ? "Contact: edge of A, vertex of B" : "Contact: edge of B, vertex of A";
    figure.layers.push_back({std::move(contact), "tight", name});
  }
  if (depth.squared.sign() != 0) {
    const Point begin{end.x - depth.vector.x, end.y - depth.vector.y};
    figure.layers.push_back({{{}, {{begin, end}}, {}}, "outline", "Shortest move"});
    figure.layers.back().arrow = true;
  }
  write_picture(files, arguments.picture, [&] { return figure_picture(figure); });
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
  if (arguments.each) {
    return run_each(arguments, [](const DepthArguments& mine, const Geometry& a, const Geometry& b,
                                  Worker&) { return depth_json(mine, find_depth(mine, a, b)); });
  }
  run_on_operands(arguments, [&](const DepthArguments&, const Geometry& a, const Geometry& b,
                                 OutputFiles& files) {
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

void add_depth(Program& program) { program.add(describe_depth, run_depth); }

}  // namespace minksum::cli
