// Writes a picture of a geometry: one path for its areas, strokes for polylines, and dots. The y
// axis points up, and the picture fits into a frame of a thousand units.
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "io/formats.hpp"
#include "io/writer.hpp"

namespace minksum::io {

namespace {

constexpr double kFrame = 1000;
constexpr double kMargin = 30;

// Keeps halves of coordinates, so that the width of a box of huge doubles does not overflow.
struct HalfBox {
  double min_x = std::numeric_limits<double>::infinity();
  double min_y = min_x;
  double max_x = -min_x;
  double max_y = -min_x;

  explicit HalfBox(const GeometryView& geometry) {
    for (std::size_t v = 0; v < geometry.region.vertex_count(); ++v) {
      include(geometry.region.x(v), geometry.region.y(v));
    }
    for (const Polyline& polyline : geometry.polylines) include(polyline);
    include(geometry.points);
  }
  [[nodiscard]] bool is_empty() const { return max_x < min_x; }
  [[nodiscard]] bool is_finite() const {
    return std::isfinite(min_x) && std::isfinite(min_y) && std::isfinite(max_x) &&
           std::isfinite(max_y);
  }
  void include(std::span<const Point> points) {
    for (const Point& point : points) include(point.x.to_double(), point.y.to_double());
  }
  void include(double x, double y) {
    min_x = std::min(min_x, x / 2);
    min_y = std::min(min_y, y / 2);
    max_x = std::max(max_x, x / 2);
    max_y = std::max(max_y, y / 2);
  }
};

// Maps the coordinates of the geometry to those of the picture.
struct View {
  double min_x = 0;
  double max_y = 0;
  double scale = 1;
  double width = kFrame;
  double height = kFrame;

  explicit View(const GeometryView& geometry) {
    const HalfBox box(geometry);
    if (box.is_empty()) return;
    if (!box.is_finite()) {
      throw Error(ErrorCode::kLimitExceeded,
                  "no picture: a coordinate is beyond the range of doubles", {}, {},
                  ExceededLimit{"pictures"});
    }
    min_x = box.min_x;
    max_y = box.max_y;
    const double wide = box.max_x - box.min_x;
    const double high = box.max_y - box.min_y;
    const double longer = std::max(wide, high);
    const double inner = kFrame - 2 * kMargin;
    if (longer > 0 && std::isfinite(longer) && std::isfinite(inner / longer)) {
      scale = inner / longer;
      width = wide * scale + 2 * kMargin;
      height = high * scale + 2 * kMargin;
    }
  }
  [[nodiscard]] double x(double value) const { return kMargin + (value / 2 - min_x) * scale; }
  [[nodiscard]] double y(double value) const { return kMargin + (max_y - value / 2) * scale; }
};

// A hundredth of a unit is finer than a screen shows.
double rounded(double value) {
  const double result = std::round(value * 100) / 100;
  return std::isfinite(result) ? result : 0;
}

class SvgWriter {
 public:
  SvgWriter(const Sink& out, const GeometryView& geometry)
      : geometry_(geometry), view_(geometry), writer_(out, {}) {}

  void write() {
    writer_.text(R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 )");
    pair(view_.width, view_.height);
    writer_.text("\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n");
    if (!geometry_.region.empty() || geometry_.kinds() == 0) region();
    if (!geometry_.polylines.empty()) polylines();
    points();
    writer_.text("</svg>\n");
    writer_.flush();
  }

 private:
  // Blue and vermilion are from the Okabe-Ito palette, which the colour-blind can tell apart.
  void region() {
    writer_.text(R"(<path fill="#0072B2" fill-opacity="0.3" fill-rule="evenodd" stroke="#0072B2" )"
                 R"(stroke-width="1.5" stroke-linejoin="round" d=")");
    const Region& region = geometry_.region;
    for (std::size_t ring = 0; ring < region.ring_count(); ++ring) {
      char command = 'M';
      for (const std::size_t vertex : region.vertices_of(ring)) {
        step(command, region.x(vertex), region.y(vertex));
      }
      if (command != 'M') writer_.text("Z\n");
    }
    writer_.text("\"/>\n");
  }

  void polylines() {
    writer_.text(R"(<path fill="none" stroke="#D55E00" stroke-width="2.5" )"
                 R"(stroke-linejoin="round" stroke-linecap="round" d=")");
    for (const Polyline& polyline : geometry_.polylines) {
      char command = 'M';
      for (const Point& point : polyline) step(command, point.x.to_double(), point.y.to_double());
      writer_.text('\n');
    }
    writer_.text("\"/>\n");
  }

  void points() {
    for (const Point& point : geometry_.points) {
      writer_.text(R"(<circle fill="#D55E00" r="4" cx=")");
      writer_.real(rounded(view_.x(point.x.to_double())));
      writer_.text(R"(" cy=")");
      writer_.real(rounded(view_.y(point.y.to_double())));
      writer_.text("\"/>\n");
    }
  }

  // The first vertex of a path takes the command M, and all others take L.
  void step(char& command, double x, double y) {
    writer_.text(command);
    command = 'L';
    pair(view_.x(x), view_.y(y));
  }
  void pair(double x, double y) {
    writer_.real(rounded(x));
    writer_.text(' ');
    writer_.real(rounded(y));
  }

  const GeometryView& geometry_;
  View view_;
  Writer writer_;
};

}  // namespace

void write_svg(const Sink& out, const GeometryView& geometry) { SvgWriter(out, geometry).write(); }

}  // namespace minksum::io
