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
  /// Takes the place for a label of this size that is free and nearest to `anchor`, `direction`
  /// before all others. Returns its middle. If no place nearby is free, it is the one with the
  /// least below it. The nearest places are at `distance` from the anchor.
  PicturePoint place(PicturePoint anchor, PicturePoint direction, double distance, double width,
                     double height);

 private:
  [[nodiscard]] double area_taken(const LabelBox& box) const;

  double width_;
  std::unordered_map<long long, std::vector<LabelBox>> cells_;
};

}  // namespace minksum::cli
