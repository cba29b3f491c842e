// Writes the labels of a figure: numbers of vertices, and marks of faults.
#pragma once

#include "pictures/figure.hpp"
#include "pictures/label_places.hpp"

namespace minksum::cli {

/// Returns the direction from one point to another, of length 1, or (0, 0) if they are the same.
[[nodiscard]] PicturePoint direction_between(PicturePoint from, PicturePoint to);

/// Marks the faults of all layers with numbers from 1, and numbers vertices where layers ask for
/// that. No label hides another one or lies on a line, as far as there is room.
void label_figure(SvgPicture& picture, const Figure& figure, const PictureTransform& placement);

}  // namespace minksum::cli
