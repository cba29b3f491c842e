// Draws figures: geometries on top of each other in one frame, to one scale, with a legend.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "minksum/geometry.hpp"
#include "minksum/validity.hpp"
#include "pictures/svg_picture.hpp"

namespace minksum::cli {

/// One geometry of a figure.
struct Layer {
  Geometry geometry;            ///< the geometry to be drawn
  std::string style = "first";  ///< a class of SvgPicture
  std::string caption;
  std::vector<Fault> faults = {};  ///< faults to be marked and listed
  /// The geometry as it was read, if its vertices are to be numbered. Numbers start from 1 in each
  /// ring, each polyline and the set of points.
  const Geometry* numbered = nullptr;
  bool arrow = false;  ///< polylines end in arrowheads
};

struct FigureLook {
  std::string title;   ///< empty = none
  double width = 960;  ///< in pixels; the height follows
  Theme theme = Theme::kAuto;
  bool axes = true;
  bool legend = true;
  std::optional<Extent> view;  ///< what the frame shows; none = everything
};

struct Figure : FigureLook {
  std::vector<Layer> layers;  ///< the first one is lowest
};

/// Returns the figure as SVG. Throws Error(kLimitExceeded) if doubles cannot hold it.
[[nodiscard]] std::string figure_picture(const Figure& figure);

}  // namespace minksum::cli
