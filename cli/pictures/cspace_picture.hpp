// Draws slices of a configuration space: each in its own picture, or some of them side by side.
#pragma once

#include <string>

#include "minksum/configuration_space.hpp"
#include "pictures/svg_picture.hpp"

namespace minksum::cli {

/// Draws slices with what all their pictures share. Any number of threads may use one object.
class CspacePicture {
 public:
  CspacePicture(const ConfigurationSpace& space, const Geometry& obstacles,
                const ConfigurationOptions& setting, const Options& options, bool free);

  /// Returns the height of a slice's drawing of that width.
  [[nodiscard]] double height_for(double width) const;
  void draw(SvgPicture& picture, const Slice& slice, double left, double top, double width) const;

  /// Returns a picture of this slice alone.
  [[nodiscard]] std::string one(const Slice& slice) const;

 private:
  bool free_;  ///< free space is shown, not the obstacles
  Box boundary_;
  Extent extent_;
  Geometry obstacles_;
  Region workspace_;
  Region robot_;
  Point corner_;  ///< the point at which the robot is drawn
};

/// Draws some of many slices, evenly chosen, in rows.
class Overview {
 public:
  Overview(const CspacePicture& slices, std::size_t count, bool free);
  /// Draws the slice if it is one of the chosen. Must be called for each slice, in order.
  void offer(std::size_t index, const Slice& slice);
  [[nodiscard]] std::string finish() &&;

 private:
  [[nodiscard]] double left(std::size_t shown) const;
  [[nodiscard]] double top(std::size_t shown) const;

  const CspacePicture& slices_;
  std::size_t count_;
  std::size_t shown_;
  std::size_t drawn_ = 0;
  SvgPicture picture_;
};

}  // namespace minksum::cli
