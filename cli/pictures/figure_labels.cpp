#include "pictures/figure_labels.hpp"

#include <algorithm>
#include <cmath>

#include "pictures/text_layout.hpp"

namespace minksum::cli {
namespace {

constexpr double kDigitWidth = 7;  // about the width of a digit in the widest usual font
constexpr double kHeight = 12;
constexpr double kBaseline = 4;  // from the middle of a text down to its baseline
constexpr double kMark = 7;      // radius of a fault's mark

class Labeller {
 public:
  Labeller(SvgPicture& picture, const PictureTransform& placement, double width,
           const std::optional<Extent>& view)
      : picture_(picture), placement_(placement), view_(view), places_(width) {}

  [[nodiscard]] PicturePoint at(const Point& point) const {
    return {placement_.x(point.x.to_double()), placement_.y(point.y.to_double())};
  }
  [[nodiscard]] bool sees(const Point& point) const {
    return !view_ || view_->has(point.x.to_double(), point.y.to_double());
  }
  void keep_free(PicturePoint mark) {
    places_.take({mark.x - kMark, mark.y - kMark, mark.x + kMark, mark.y + kMark});
  }
  void keep_off_lines(const Geometry& geometry);
  void write(PicturePoint anchor, PicturePoint direction, double distance, const char* style,
             const std::string& text) {
    const double width = kDigitWidth * static_cast<double>(character_count(text)) + 2;
    const PicturePoint middle = places_.place(anchor, direction, distance, width, kHeight);
    picture_.text(middle.x, middle.y + kBaseline, style, text);
  }
  void number(const Geometry& geometry);

 private:
  void number(const std::vector<PicturePoint>& vertices, bool closed);
  [[nodiscard]] bool in_view(PicturePoint at) const {
    return !view_ || (at.x >= placement_.x(view_->min_x) && at.x <= placement_.x(view_->max_x) &&
                      at.y >= placement_.y(view_->max_y) && at.y <= placement_.y(view_->min_y));
  }

  SvgPicture& picture_;
  const PictureTransform& placement_;
  const std::optional<Extent>& view_;
  LabelPlaces places_;
};

void Labeller::keep_off_lines(const Geometry& geometry) {
  const Region& region = geometry.region;
  std::vector<PicturePoint> vertices;
  for (const std::size_t polygon : region.polygons()) {
    for (const std::size_t ring : region.rings_of(polygon)) {
      vertices.clear();
      for (const std::size_t v : region.vertices_of(ring)) {
        vertices.push_back({placement_.x(region.x(v)), placement_.y(region.y(v))});
      }
      for (std::size_t i = 0; i < vertices.size(); ++i) {
        places_.take_line(vertices[i], vertices[(i + 1) % vertices.size()]);
      }
    }
  }
  for (const Polyline& polyline : geometry.polylines) {
    for (std::size_t i = 1; i < polyline.size(); ++i) {
      places_.take_line(at(polyline[i - 1]), at(polyline[i]));
    }
  }
}

// Writes a number at each vertex, on the side of its larger angle, because there is more room.
void Labeller::number(const std::vector<PicturePoint>& vertices, bool closed) {
  const std::size_t n = vertices.size();
  for (std::size_t i = 0; i < n; ++i) {
    const PicturePoint& vertex = vertices[i];
    if (!in_view(vertex)) continue;
    PicturePoint before{};
    PicturePoint after{};
    if (closed || i > 0) before = direction_between(vertex, vertices[(i + n - 1) % n]);
    if (closed || i + 1 < n) after = direction_between(vertex, vertices[(i + 1) % n]);
    PicturePoint away{-before.x - after.x, -before.y - after.y};
    if (std::hypot(away.x, away.y) < 1e-3) {  // straight: to the right; a lone point: below
      away = after.x == 0 && after.y == 0 ? PicturePoint{0, 1} : PicturePoint{-after.y, after.x};
    }
    constexpr double kDistance = 11;
    write(vertex, away, kDistance, "label middle", std::to_string(i + 1));
  }
}

void Labeller::number(const Geometry& geometry) {
  const Region& region = geometry.region;
  std::vector<PicturePoint> vertices;
  for (const std::size_t polygon : region.polygons()) {
    for (const std::size_t ring : region.rings_of(polygon)) {
      vertices.clear();
      for (const std::size_t v : region.vertices_of(ring)) {
        vertices.push_back({placement_.x(region.x(v)), placement_.y(region.y(v))});
      }
      number(vertices, true);
    }
  }
  for (const Polyline& polyline : geometry.polylines) {
    vertices.clear();
    for (const Point& point : polyline) vertices.push_back(at(point));
    number(vertices, false);
  }
  for (std::size_t i = 0; i < geometry.points.size(); ++i) {
    if (!sees(geometry.points[i])) continue;
    write(at(geometry.points[i]), {0, 1}, 11, "label middle", std::to_string(i + 1));
  }
}

// Numbers of faults whose marks lie at the same place, or nearly so.
struct FaultLabel {
  PicturePoint at;  // position of the mark
  std::string numbers;
  std::size_t last;
  bool is_run;  // a run of numbers up to `last` is not yet written

  void end_run() {
    if (is_run) numbers += "–" + std::to_string(last);
    is_run = false;
  }
};

void add_number(std::vector<FaultLabel>& labels, PicturePoint at, std::size_t number) {
  constexpr double kNear = 13;
  const auto found = std::ranges::find_if(labels, [at](const FaultLabel& label) {
    return std::fabs(label.at.x - at.x) < kNear && std::fabs(label.at.y - at.y) < kNear;
  });
  if (found == labels.end()) {
    labels.push_back({at, std::to_string(number), number, false});
    return;
  }
  if (number == found->last + 1) {
    found->is_run = true;
  } else {
    found->end_run();
    found->numbers += ", " + std::to_string(number);
  }
  found->last = number;
}

// Draws marks with numbers, which the list below the frame explains.
void mark_faults(Labeller& labels, SvgPicture& picture, const Figure& figure,
                 const PictureTransform& placement) {
  std::size_t number = 0;
  std::vector<FaultLabel> numbers;
  for (const Layer& layer : figure.layers) {
    std::vector<Trace::Vertex> places;
    for (const Fault& fault : layer.faults) {
      ++number;
      if (!fault.at || !labels.sees(*fault.at)) continue;
      places.push_back({fault.at->x.to_double(), fault.at->y.to_double()});
      const PicturePoint at = labels.at(*fault.at);
      labels.keep_free(at);
      add_number(numbers, at, number);
    }
    if (!places.empty()) picture.dots(places, placement, kMark, "fault");
  }
  for (FaultLabel& label : numbers) {
    label.end_run();
    labels.write(label.at, {1, -1}, kMark + kHeight / 2 + 1, "number middle", label.numbers);
  }
}

}  // namespace

PicturePoint direction_between(PicturePoint from, PicturePoint to) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  if (!(length > 0)) return {0, 0};
  return {(to.x - from.x) / length, (to.y - from.y) / length};
}

void label_figure(SvgPicture& picture, const Figure& figure, const PictureTransform& placement) {
  Labeller labels(picture, placement, figure.width, figure.view);
  const bool any = std::ranges::any_of(figure.layers, [](const Layer& layer) {
    return layer.numbered != nullptr || !layer.faults.empty();
  });
  if (!any) return;
  for (const Layer& layer : figure.layers) labels.keep_off_lines(layer.geometry);
  mark_faults(labels, picture, figure, placement);
  for (const Layer& layer : figure.layers) {
    if (layer.numbered != nullptr) labels.number(*layer.numbered);
  }
}

}  // namespace minksum::cli
