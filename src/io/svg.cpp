// A picture of a region: one path, y upwards, fitted into a frame of a thousand units.
#include <algorithm>
#include <cmath>
#include <optional>

#include "io/formats.hpp"
#include "io/writer.hpp"
#include "minksum/measure.hpp"

namespace minksum::io {

namespace {

constexpr double kFrame = 1000;
constexpr double kMargin = 30;

// From the region's coordinates to the picture's. Works on halves so that the box of two huge
// doubles does not overflow.
struct View {
  double min_x = 0;
  double max_y = 0;
  double scale = 1;
  double width = kFrame;
  double height = kFrame;

  explicit View(const Region& region) {
    const std::optional<Box> box = bounding_box(region);
    if (!box) return;
    min_x = box->min.x.to_double() / 2;
    max_y = box->max.y.to_double() / 2;
    const double wide = box->max.x.to_double() / 2 - min_x;
    const double high = max_y - box->min.y.to_double() / 2;
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

// A hundredth of a unit is more than a screen shows.
double rounded(double value) {
  const double result = std::round(value * 100) / 100;
  return std::isfinite(result) ? result : 0;
}

}  // namespace

void write_svg(std::ostream& out, const Region& region) {
  const View view(region);
  Writer writer(out, {});
  const auto pair = [&writer](double x, double y) {
    writer.real(rounded(x));
    writer.text(' ');
    writer.real(rounded(y));
  };
  writer.text(R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 )");
  pair(view.width, view.height);
  writer.text("\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n");
  // Blue of the Okabe-Ito palette: told apart by all common kinds of colour vision.
  writer.text(R"(<path fill="#0072B2" fill-opacity="0.3" fill-rule="evenodd" stroke="#0072B2" )"
              R"(stroke-width="1.5" stroke-linejoin="round" d=")");
  for (std::size_t ring = 0; ring < region.ring_count(); ++ring) {
    bool first = true;
    for (const std::size_t vertex : region.vertices_of(ring)) {
      writer.text(first ? 'M' : 'L');
      first = false;
      pair(view.x(region.x(vertex)), view.y(region.y(vertex)));
    }
    if (!first) writer.text("Z\n");
  }
  writer.text("\"/>\n</svg>\n");
  writer.flush();
}

}  // namespace minksum::io
