// Finds places for labels in a picture, so that none hides another one or lies on a line.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

namespace minksum::cli {

/// A box of the picture, in its units.
struct LabelBox {
  double left;
  double top;
  double right;
  double bottom;
};

/// A point of the picture, or a direction in it.
struct PicturePoint {
  double x;
  double y;
};

/// Keeps the boxes that are taken. The time of each call does not grow with their number, unless
/// they lie on each other.
class LabelPlaces {
 public:
  /// Labels stay between x = 0 and this one.
  explicit LabelPlaces(double width) : width_(width) {}

  /// Keeps labels away from this box.
  void take(const LabelBox& box);
  /// Keeps labels off this line.
  void take_line(PicturePoint from, PicturePoint to);
  /// Takes a place near `anchor` for a label of this size, and returns the middle of that place.
  /// Places at `distance` from the anchor are tried first, then places farther away. At each
  /// distance, those nearest to `direction` are tried first. The first free place is taken. If none
  /// is free, the label goes where it covers the least area that is taken.
  PicturePoint place(PicturePoint anchor, PicturePoint direction, double distance, double width,
                     double height);

 private:
  [[nodiscard]] double area_taken(const LabelBox& box) const;

  double width_;
  std::unordered_map<long long, std::vector<LabelBox>> cells_;
};

}  // namespace minksum::cli
