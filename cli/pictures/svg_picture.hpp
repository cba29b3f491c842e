// Writes drawings as SVG, legible on light and dark ground and to the colour-blind.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "minksum/geometry.hpp"
#include "minksum/trace.hpp"

namespace minksum::cli {

/// The size of a page on which several drawings are arranged: it fits on usual screens.
inline constexpr double kPageWidth = 960;
inline constexpr double kPageHeight = 900;
inline constexpr double kPageMargin = 24;

/// A box of the plane in doubles, which grows around given points.
struct Extent {
  double min_x = 0;
  double min_y = 0;
  double max_x = 0;
  double max_y = 0;
  bool empty = true;

  void include(double x, double y);
  void include(const Geometry& geometry);
  [[nodiscard]] bool has(double x, double y) const {
    return !empty && min_x <= x && x <= max_x && min_y <= y && y <= max_y;
  }
  [[nodiscard]] double width() const { return max_x - min_x; }
  [[nodiscard]] double height() const { return max_y - min_y; }
};

[[nodiscard]] Extent extent_of(const Geometry& geometry);

/// The surroundings of a picture; `kAuto` leaves the choice to the program that shows it.
enum class Theme { kAuto, kLight, kDark };

/// A straight line in units of the picture.
struct PictureLine {
  double x0;
  double y0;
  double x1;
  double y1;
};

/// Maps the plane to the picture: x to the right, y up, and the same scale in both directions.
class PictureTransform {
 public:
  /// Maps the upper left corner of the extent to (left, top), and each of its units to `scale`
  /// units of the picture. Throws Error(kLimitExceeded) if doubles cannot hold that.
  PictureTransform(const Extent& extent, double left, double top, double scale);
  [[nodiscard]] double x(double world) const { return left_ + (world - min_x_) * scale_; }
  [[nodiscard]] double y(double world) const { return top_ + (max_y_ - world) * scale_; }

 private:
  double min_x_;
  double max_y_;
  double left_;
  double top_;
  double scale_;
};

/// Returns the largest scale at which `extent` fits into width × height.
[[nodiscard]] double fitting_scale(const Extent& extent, double width, double height);

/// Builds a picture. Each `style` is one of the classes in svg_picture.cpp: first, second, sum,
/// blocked, tight, mark, pale, edge-first, edge-second, dropped, covered, grid, node, accepted,
/// nesting, collision.
class SvgPicture {
 public:
  /// With `figure`, which figure.hpp gives, there are the further classes outline, fault, axis,
  /// label, number, middle and end.
  SvgPicture(double width, double height, std::string_view title, std::optional<Theme> figure = {});

  void region(const Region& region, const PictureTransform& placement, std::string_view style);
  /// Draws the outlines of a region alone.
  void outlines(const Region& region, const PictureTransform& placement, std::string_view style);
  /// Draws polylines as strokes and points as dots, thicker than outlines, in the style's colour.
  void thin_parts(const Geometry& geometry, const PictureTransform& placement,
                  std::string_view style);
  void geometry(const Geometry& geometry, const PictureTransform& placement,
                std::string_view style) {
    if (!geometry.region.empty()) region(geometry.region, placement, style);
    thin_parts(geometry, placement, style);
  }
  void ring(std::span<const Trace::Vertex> vertices, const PictureTransform& placement,
            std::string_view style);
  /// Draws all segments that `chosen` accepts as one path.
  template <typename Chosen>
  void segments(std::span<const Trace::Segment> segments, const PictureTransform& placement,
                std::string_view style, Chosen chosen) {
    begin_path(style);
    for (const Trace::Segment& segment : segments) {
      if (chosen(segment)) add_segment(segment, placement);
    }
    end_path();
  }
  /// Draws a tick at the middle of each segment, on its outer side, which is the right one.
  template <typename Chosen>
  void ticks(std::span<const Trace::Segment> segments, const PictureTransform& placement,
             std::string_view style, Chosen chosen) {
    begin_path(style);
    for (const Trace::Segment& segment : segments) {
      if (chosen(segment)) add_tick(segment, placement);
    }
    end_path();
  }
  void dots(std::span<const Trace::Vertex> points, const PictureTransform& placement, double radius,
            std::string_view style);
  /// Draws the marked cells of a grid, merged to runs row by row.
  void cells(const Trace::Grid& grid, const PictureTransform& placement, std::string_view style);
  void text(double x, double y, std::string_view style, std::string_view words);
  void lines(std::span<const PictureLine> lines, std::string_view style);
  /// What is drawn up to `end_clip` is cut off at this box. There may be one such box.
  void begin_clip(double left, double top, double width, double height);
  void end_clip() { text_ += "</g>\n"; }
  void box(double left, double top, double width, double height, std::string_view style);

  /// Completes the picture and returns it.
  [[nodiscard]] std::string finish() &&;

 private:
  void begin_path(std::string_view style);
  void end_path();
  void add_rings(const Region& region, const PictureTransform& placement);
  void move_to(double x, double y);
  void line_to(double x, double y);
  void add_segment(const Trace::Segment& segment, const PictureTransform& placement);
  void add_tick(const Trace::Segment& segment, const PictureTransform& placement);
  void pair(std::string_view before, double x, std::string_view between, double y);
  void number(double value);

  std::string text_;
};

}  // namespace minksum::cli
