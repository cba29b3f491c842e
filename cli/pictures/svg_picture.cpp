#include "pictures/svg_picture.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "minksum/error.hpp"

namespace minksum::cli {
namespace {

// The colours are from Okabe and Ito; the colour-blind can tell them apart. The second set is for
// dark surroundings. CSS variables are avoided, because several renderers do not know them. Areas
// of geometries are opaque, so that each has the colour that the legend shows, whatever lies below
// it.
constexpr std::string_view kStyle = R"(
text{font:13px system-ui,"Segoe UI","DejaVu Sans",Helvetica,Arial,sans-serif;fill:#555}
.title{font-size:15px;font-weight:600;fill:#222}
.ground{fill:#fffdf8}
path,circle{vector-effect:non-scaling-stroke;stroke-linejoin:round;stroke-linecap:round;fill:none}
.region{fill-rule:evenodd;stroke-width:.9}
.first{color:#0072b2;fill:#c7dee9;stroke:currentColor}
.second{color:#d55e00;fill:#f6dac1;stroke:currentColor}
.sum{color:#00694d;fill:#c2e6d8;stroke:currentColor}
.blocked{color:#a06a00;fill:#f6dca1;stroke:currentColor}
.tight{color:#a3346f;fill:#ebd1da;stroke:currentColor}
.mark{color:#222;fill:#222;stroke:currentColor}
path.edge{fill:none;stroke-width:.9}
path.thin{fill:none;stroke-width:2.2}
circle.dot,circle.mark{fill:currentColor}
.pale{fill:#777;fill-opacity:.1;stroke:none}
.edge-first{stroke:#0072b2;stroke-width:.8}
.edge-second{stroke:#d55e00;stroke-width:.8}
.dropped{stroke:#999;stroke-width:.3;stroke-opacity:.6}
.covered{fill:#009e73;fill-opacity:.2}
.grid{stroke:#999;stroke-width:.3;stroke-dasharray:2 3}
.node{fill:#222;stroke:none}
.accepted{fill:#009e73;fill-opacity:.2;stroke:#00694d;stroke-width:1.1}
.nesting{fill:#cc79a7;fill-opacity:.35;stroke:#a3346f;stroke-width:1}
.collision{fill:#e69f00;fill-opacity:.35;stroke:#a06a00;stroke-width:1}
)";
constexpr std::string_view kIfDark = "@media (prefers-color-scheme:dark){\n";
constexpr std::string_view kDarkStyle = R"(text{fill:#b5b5b5}.title{fill:#eee}.ground{fill:#16181c}
.first{color:#56b4e9;fill:#243a49}.second{color:#ff9950;fill:#493427}
.sum{color:#2fd6a5;fill:#1c463d}.blocked{color:#f3bd45;fill:#63522a}
.tight{color:#e79cc5;fill:#443541}.pale{fill:#aaa}
.edge-first{stroke:#56b4e9}.edge-second{stroke:#ff9950}
.dropped,.grid{stroke:#777}.covered{fill:#2fd6a5}.node{fill:#eee}.mark{color:#eee;fill:#eee}
.accepted{fill:#2fd6a5;stroke:#2fd6a5}
.nesting{fill:#e79cc5;stroke:#e79cc5}.collision{fill:#f3bd45;stroke:#f3bd45}
)";
// Classes that only figures use.
constexpr std::string_view kFigureStyle = R"(.outline{color:#444;fill:none;stroke:currentColor}
.region.outline{stroke-width:1.2}
.fault{stroke:#222;stroke-width:1.6}
.axis{stroke:#999;stroke-width:.8}
.label{font-size:11px}
.number{font-size:11px;font-weight:600;fill:#222}
.middle{text-anchor:middle}
.end{text-anchor:end}
)";
constexpr std::string_view kDarkFigureStyle = R"(.outline{color:#ccc}
.fault{stroke:#eee}.number{fill:#eee}.axis{stroke:#777}
)";

constexpr std::string_view kGround = "<rect class=\"ground\" width=\"100%\" height=\"100%\"/>\n";

constexpr double kNormalLength = 4;

std::string escaped(std::string_view words) {
  constexpr std::string_view kMarks = "&<>\"";
  constexpr const char* kEscapes[] = {"&amp;", "&lt;", "&gt;", "&quot;"};
  std::string text;
  for (const char c : words) {
    const std::size_t mark = kMarks.find(c);
    text += mark == std::string_view::npos ? std::string(1, c) : kEscapes[mark];
  }
  return text;
}

}  // namespace

void Extent::include(double x, double y) {
  min_x = empty ? x : std::min(min_x, x);
  min_y = empty ? y : std::min(min_y, y);
  max_x = empty ? x : std::max(max_x, x);
  max_y = empty ? y : std::max(max_y, y);
  empty = false;
}

void Extent::include(const Geometry& geometry) {
  const Region& region = geometry.region;
  for (std::size_t v = 0; v < region.vertex_count(); ++v) include(region.x(v), region.y(v));
  for (const Polyline& polyline : geometry.polylines) {
    for (const Point& point : polyline) include(point.x.to_double(), point.y.to_double());
  }
  for (const Point& point : geometry.points) include(point.x.to_double(), point.y.to_double());
}

Extent extent_of(const Geometry& geometry) {
  Extent extent;
  extent.include(geometry);
  return extent;
}

PictureTransform::PictureTransform(const Extent& extent, double left, double top, double scale)
    : min_x_(extent.min_x), max_y_(extent.max_y), left_(left), top_(top), scale_(scale) {
  const bool drawable = std::isfinite(scale) && std::isfinite(extent.width() * scale) &&
                        std::isfinite(extent.height() * scale);
  if (!drawable) {
    throw Error(ErrorCode::kLimitExceeded,
                "no picture: the coordinates or their extent are beyond the range of doubles", {},
                {}, ExceededLimit{"pictures"});
  }
}

double fitting_scale(const Extent& extent, double width, double height) {
  double scale = std::numeric_limits<double>::infinity();
  if (extent.width() > 0) scale = std::min(scale, width / extent.width());
  if (extent.height() > 0) scale = std::min(scale, height / extent.height());
  // A box without extent in doubles is a dot at any scale.
  return extent.width() > 0 || extent.height() > 0 ? scale : 1;
}

SvgPicture::SvgPicture(double width, double height, std::string_view title,
                       std::optional<Theme> figure) {
  text_ += "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0";
  pair(" ", width, " ", height);
  pair("\" width=\"", width, "\" height=\"", height);
  text_ += "\">\n<title>" + escaped(title) + "</title>\n";
  const Theme theme = figure.value_or(Theme::kAuto);
  text_.append("<style>").append(kStyle).append(figure ? kFigureStyle : "");
  if (theme == Theme::kAuto) text_ += kIfDark;
  if (theme != Theme::kLight) text_.append(kDarkStyle).append(figure ? kDarkFigureStyle : "");
  text_ += theme == Theme::kAuto ? "}\n</style>\n" : "</style>\n";
  text_ += kGround;
}

void SvgPicture::region(const Region& region, const PictureTransform& placement,
                        std::string_view style) {
  begin_path(std::string("region ").append(style));
  add_rings(region, placement);
  end_path();
}

void SvgPicture::outlines(const Region& region, const PictureTransform& placement,
                          std::string_view style) {
  begin_path(std::string("edge ").append(style));
  add_rings(region, placement);
  end_path();
}

void SvgPicture::add_rings(const Region& region, const PictureTransform& placement) {
  for (const std::size_t polygon : region.polygons()) {
    for (const std::size_t ring : region.rings_of(polygon)) {
      const char* command = "M";
      for (const std::size_t v : region.vertices_of(ring)) {
        pair(std::exchange(command, "L"), placement.x(region.x(v)), " ", placement.y(region.y(v)));
      }
      if (*command == 'L') text_ += 'Z';
    }
  }
}

void SvgPicture::thin_parts(const Geometry& geometry, const PictureTransform& placement,
                            std::string_view style) {
  if (!geometry.polylines.empty()) {
    begin_path(std::string("thin ").append(style));
    for (const Polyline& polyline : geometry.polylines) {
      const char* command = "M";
      for (const Point& point : polyline) {
        pair(std::exchange(command, "L"), placement.x(point.x.to_double()), " ",
             placement.y(point.y.to_double()));
      }
    }
    end_path();
  }
  if (geometry.points.empty()) return;
  std::vector<Trace::Vertex> points;
  for (const Point& point : geometry.points) {
    points.push_back({point.x.to_double(), point.y.to_double()});
  }
  constexpr double kRadius = 3;
  dots(points, placement, kRadius, std::string("dot ").append(style));
}

void SvgPicture::ring(std::span<const Trace::Vertex> vertices, const PictureTransform& placement,
                      std::string_view style) {
  if (vertices.empty()) return;
  begin_path(style);
  move_to(placement.x(vertices[0].x), placement.y(vertices[0].y));
  for (const Trace::Vertex& v : vertices.subspan(1)) line_to(placement.x(v.x), placement.y(v.y));
  text_ += 'Z';
  end_path();
}

void SvgPicture::add_segment(const Trace::Segment& segment, const PictureTransform& placement) {
  move_to(placement.x(segment.from.x), placement.y(segment.from.y));
  line_to(placement.x(segment.to.x), placement.y(segment.to.y));
}

void SvgPicture::add_tick(const Trace::Segment& segment, const PictureTransform& placement) {
  const double x0 = placement.x(segment.from.x);
  const double y0 = placement.y(segment.from.y);
  const double dx = placement.x(segment.to.x) - x0;
  const double dy = placement.y(segment.to.y) - y0;
  const double length = std::hypot(dx, dy);
  if (!(length > 0)) return;
  const double x = x0 + dx / 2;
  const double y = y0 + dy / 2;
  // The y axis of the picture points down, so the right-hand normal of (dx, dy) is (-dy, dx).
  move_to(x, y);
  line_to(x - dy / length * kNormalLength, y + dx / length * kNormalLength);
}

void SvgPicture::dots(std::span<const Trace::Vertex> points, const PictureTransform& placement,
                      double radius, std::string_view style) {
  text_.append("<g class=\"").append(style).append("\">\n");
  for (const Trace::Vertex& point : points) {
    text_.append("<circle class=\"").append(style);
    pair("\" cx=\"", placement.x(point.x), "\" cy=\"", placement.y(point.y));
    text_ += "\" r=\"";
    number(radius);
    text_ += "\"/>\n";
  }
  text_ += "</g>\n";
}

void SvgPicture::cells(const Trace::Grid& grid, const PictureTransform& placement,
                       std::string_view style) {
  begin_path(style);
  for (std::uint32_t row = 0; row < grid.rows; ++row) {
    const std::size_t base = std::size_t{row} * grid.columns;
    for (std::uint32_t column = 0; column < grid.columns;) {
      std::uint32_t end = column;
      while (end < grid.columns && grid.covered[base + end]) ++end;
      if (end == column) {
        ++column;
        continue;
      }
      const double x0 = placement.x(grid.min_x + grid.cell_width * column);
      const double x1 = placement.x(grid.min_x + grid.cell_width * end);
      const double y0 = placement.y(grid.min_y + grid.cell_height * row);
      const double y1 = placement.y(grid.min_y + grid.cell_height * (row + 1.0));
      move_to(x0, y0);
      line_to(x1, y0);
      line_to(x1, y1);
      line_to(x0, y1);
      text_ += 'Z';
      column = end;
    }
  }
  end_path();
}

void SvgPicture::text(double x, double y, std::string_view style, std::string_view words) {
  text_.append("<text class=\"").append(style);
  pair("\" x=\"", x, "\" y=\"", y);
  text_ += "\">" + escaped(words) + "</text>\n";
}

void SvgPicture::lines(std::span<const PictureLine> lines, std::string_view style) {
  begin_path(style);
  for (const PictureLine& line : lines) {
    move_to(line.x0, line.y0);
    line_to(line.x1, line.y1);
  }
  end_path();
}

void SvgPicture::begin_clip(double left, double top, double width, double height) {
  text_ += "<clipPath id=\"frame\">";
  box(left, top, width, height, "frame");
  text_ += "</clipPath>\n<g clip-path=\"url(#frame)\">\n";
}

void SvgPicture::box(double left, double top, double width, double height, std::string_view style) {
  text_.append("<rect class=\"").append(style);
  pair("\" x=\"", left, "\" y=\"", top);
  pair("\" width=\"", width, "\" height=\"", height);
  text_ += "\"/>\n";
}

std::string SvgPicture::finish() && {
  text_ += "</svg>\n";
  return std::move(text_);
}

void SvgPicture::begin_path(std::string_view style) {
  text_.append("<path class=\"").append(style).append("\" d=\"");
}

void SvgPicture::end_path() { text_ += "\"/>\n"; }

void SvgPicture::move_to(double x, double y) { pair("M", x, " ", y); }

void SvgPicture::line_to(double x, double y) { pair("L", x, " ", y); }

void SvgPicture::pair(std::string_view before, double x, std::string_view between, double y) {
  text_ += before;
  number(x);
  text_ += between;
  number(y);
}

// A thousandth of a pixel is finer than anybody zooms.
void SvgPicture::number(double value) {
  char buffer[64];
  const double rounded = std::nearbyint(value * 1000) / 1000;
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, rounded == 0 ? 0 : rounded);
  text_.append(buffer, result.ptr);
}

}  // namespace minksum::cli
