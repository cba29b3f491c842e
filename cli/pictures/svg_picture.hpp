// Drawings as SVG: quiet, thin, legible on light and dark ground and to the colour-blind.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "minksum/geometry.hpp"
#include "minksum/trace.hpp"

namespace minksum::cli {

/// A box of the plane in doubles; grows around what it is given.
struct Extent {
  double min_x = 0;
  double min_y = 0;
  double max_x = 0;
  double max_y = 0;
  bool empty = true;

  void include(double x, double y);
  void include(const Geometry& geometry);
  [[nodiscard]] double width() const { return max_x - min_x; }
  [[nodiscard]] double height() const { return max_y - min_y; }
};

[[nodiscard]] Extent extent_of(const Geometry& geometry);

/// Which surroundings a picture is for; `kAuto` leaves that to whatever shows it.
enum class Theme { kAuto, kLight, kDark };

/// A straight line in units of the picture.
struct PictureLine {
  double x0;
  double y0;
  double x1;
  double y1;
};

/// Where the plane lies in the picture: x right, y up, the same scale both ways.
class PictureTransform {
 public:
  /// The extent's upper left corner comes to (left, top), `scale` picture units to one of its own.
  /// Throws Error(kLimitExceeded) if doubles cannot hold that.
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

/// The scale by which `extent` fills at most width × height.
[[nodiscard]] double fitting_scale(const Extent& extent, double width, double height);

/// A picture under construction. `style` is one of the classes in svg_picture.cpp:
/// first, second, sum, tight, mark, pale, edge-first, edge-second, dropped, covered, grid, node,
/// accepted, nesting, collision.
class SvgPicture {
 public:
  SvgPicture(double width, double height, std::string_view title);
  /// For figures (figure.hpp): with the further classes outline, fault, axis, label, number,
  /// middle, end.
  SvgPicture(double width, double height, std::string_view title, Theme theme);

  void region(const Region& region, const PictureTransform& placement, std::string_view style);
  /// Polylines as strokes and points as dots, thicker than outlines, in the colour of the style.
  void thin_parts(const Geometry& geometry, const PictureTransform& placement,
                  std::string_view style);
  void geometry(const Geometry& geometry, const PictureTransform& placement,
                std::string_view style) {
    if (!geometry.region.empty()) region(geometry.region, placement, style);
    thin_parts(geometry, placement, style);
  }
  void ring(std::span<const Trace::Vertex> vertices, const PictureTransform& placement,
            std::string_view style);
  /// All segments that `chosen` accepts, as one path.
  template <typename Chosen>
  void segments(std::span<const Trace::Segment> segments, const PictureTransform& placement,
                std::string_view style, Chosen chosen) {
    begin_path(style);
    for (const Trace::Segment& segment : segments) {
      if (chosen(segment)) add_segment(segment, placement);
    }
    end_path();
  }
  /// A tick to the right of each segment's middle: its outer side.
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
  /// Runs of marked cells of a grid, merged row by row.
  void cells(const Trace::Grid& grid, const PictureTransform& placement, std::string_view style);
  void text(double x, double y, std::string_view style, std::string_view words);
  void lines(std::span<const PictureLine> lines, std::string_view style);
  void box(double left, double top, double width, double height, std::string_view style);

  /// The picture, complete.
  [[nodiscard]] std::string finish() &&;

 private:
  void begin_picture(double width, double height, std::string_view title);
  void begin_path(std::string_view style);
  void end_path();
  void move_to(double x, double y);
  void line_to(double x, double y);
  void add_segment(const Trace::Segment& segment, const PictureTransform& placement);
  void add_tick(const Trace::Segment& segment, const PictureTransform& placement);
  void number(double value);

  std::string text_;
};

}  // namespace minksum::cli
