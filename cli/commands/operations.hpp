// What the subcommands for uses of sums compute, apart from files: `minksum batch` does the same.
// All throw Error; its culprit names the operand.
#pragma once

#include <vector>

#include "commands/commands.hpp"
#include "output/json.hpp"

namespace minksum::cli {

/// Dilation, erosion, opening or closing, exactly.
[[nodiscard]] Geometry morphology(const MorphologyArguments& arguments, const Geometry& a,
                                  const Geometry& b);

/// The no-fit or inner-fit polygon with its tight places, exactly.
[[nodiscard]] Geometry fit_polygon(const NoFitArguments& arguments, const Geometry& fixed,
                                   const Geometry& moving);
/// That polygon as it is to be written; tight places are rounded to the nearest.
[[nodiscard]] Geometry rounded_fit_polygon(const NoFitArguments& arguments,
                                           const Geometry& polygon);
/// "free", "touching" or "overlapping" for each of the placements that were asked for.
[[nodiscard]] std::vector<const char*> contacts(const NoFitArguments& arguments,
                                                const Geometry& fixed, const Geometry& moving);

/// Where in its operand a vertex is.
struct Feature {
  const char* operand;
  Culprit place;
};
/// What touches: an edge, by its first vertex, and a vertex.
struct ContactList {
  Feature edge;
  Feature vertex;
};
/// How two shapes stand to each other.
struct DepthReport {
  Depth depth;
  std::optional<ContactList> contacts;
  std::optional<Rational> impact;  ///< if asked for, and if there is one
};
[[nodiscard]] DepthReport find_depth(const DepthArguments& arguments, const Geometry& a,
                                     const Geometry& b);
/// With the keys that docs/operations.md describes.
[[nodiscard]] Json depth_json(const DepthArguments& arguments, const DepthReport& findings);

}  // namespace minksum::cli
