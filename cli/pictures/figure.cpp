#include "pictures/figure.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "output/faults.hpp"
#include "pictures/axes.hpp"
#include "pictures/figure_labels.hpp"
#include "pictures/picture_key.hpp"
#include "pictures/text_layout.hpp"

namespace minksum::cli {
namespace {

constexpr double kMargin = 20;
constexpr double kPadding = 16;      // between the frame and its content
constexpr double kTitleHeight = 28;  // height of a title of one line
constexpr double kTitleRow = 20;     // height of each further line
constexpr double kLegendRow = 22;
constexpr double kLegendLine = 17;  // distance between the lines of a caption
constexpr double kTickLength = 5;
constexpr double kTickLabels = 24;  // room below the frame
constexpr double kFaultRow = 18;
constexpr double kFaultIndent = 26;  // indent of the text behind a fault's number
constexpr double kMinHeight = 120;   // least height of the frame, for a mere point
constexpr double kPointScale = 48;   // scale of a mere point: some numbers fit beside it
constexpr std::size_t kMaxFaultsListed = 20;

// As kCharacterWidth, in larger and smaller letters.
constexpr double kTitleCharacter = 9.4;
constexpr double kLabelCharacter = 6.6;

double text_width(std::string_view words, double character = kCharacterWidth) {
  return character * static_cast<double>(character_count(words));
}
std::vector<std::string> lines_of(std::string_view words, double width,
                                  double character = kCharacterWidth) {
  return wrapped(words, static_cast<std::size_t>(std::max(1.0, width / character)));
}
double label_width(const std::vector<Tick>& ticks) {
  double width = 0;
  for (const Tick& tick : ticks) width = std::max(width, text_width(tick.label, kLabelCharacter));
  return width;
}

// Positions of a figure's parts, from the top to the bottom.
struct Layout {
  Extent extent;  // box of what is drawn
  double scale = 1;
  double left = 0;  // this and the next three: the frame
  double top = 0;
  double width = 0;
  double height = 0;
  double bottom = 0;  // bottom of the frame with the labels below it
  std::vector<Tick> x_ticks;
  std::vector<Tick> y_ticks;

  [[nodiscard]] double drawing_left() const { return left + (width - extent.width() * scale) / 2; }
  [[nodiscard]] double drawing_top() const { return top + (height - extent.height() * scale) / 2; }
  [[nodiscard]] PictureTransform placement() const {
    return {extent, drawing_left(), drawing_top(), scale};
  }
};

// Fits the drawing into a frame that starts at `left`.
void fit(const Figure& figure, double left, Layout& layout) {
  const Extent& extent = layout.extent;
  layout.left = left;
  layout.width = figure.width - left - kMargin;
  const double max_height = std::max(kMinHeight, layout.width * 0.9);
  layout.scale = fitting_scale(extent, layout.width - 2 * kPadding, max_height - 2 * kPadding);
  if (extent.width() == 0 && extent.height() == 0) layout.scale = kPointScale;
  layout.height = std::max(kMinHeight, extent.height() * layout.scale + 2 * kPadding);
}

void choose_ticks(Layout& layout) {
  const Extent& extent = layout.extent;
  const double unit = 1 / layout.scale;
  const double beside = (layout.drawing_left() - layout.left) * unit;
  const double above = (layout.drawing_top() - layout.top) * unit;
  constexpr double kApart = 48;
  layout.y_ticks = ticks_between(extent.min_y - above, extent.max_y + above, kApart * unit);
  const auto along_x = [&](double pixels) {
    return ticks_between(extent.min_x - beside, extent.max_x + beside, pixels * unit);
  };
  layout.x_ticks = along_x(kApart);
  layout.x_ticks = along_x(std::max(kApart, label_width(layout.x_ticks) + 24));
}

Layout lay_out(const Figure& figure, double top) {
  Layout layout;
  for (const Layer& layer : figure.layers) {
    layout.extent.include(layer.geometry);
    if (layer.numbered != nullptr) layout.extent.include(*layer.numbered);
  }
  if (figure.view && !layout.extent.empty) {
    const Extent all = layout.extent;
    layout.extent = *figure.view;
    fit(figure, kMargin, layout);
    static_cast<void>(PictureTransform(all, 0, 0, layout.scale));  // as below, for what is cut off
  }
  layout.top = top;
  fit(figure, kMargin, layout);
  if (figure.axes && !layout.extent.empty) {
    static_cast<void>(layout.placement());  // throws if doubles cannot hold the figure
    choose_ticks(layout);
    // The labels of the y axis take room, which changes the scale. One more pass nearly ends that.
    fit(figure, kMargin + label_width(layout.y_ticks) + kTickLength + 4, layout);
    choose_ticks(layout);
  }
  layout.bottom = layout.top + layout.height + (layout.x_ticks.empty() ? 0 : kTickLabels);
  return layout;
}

std::string legend_text(const Layer& layer) {
  if (layer.geometry.empty()) return layer.caption + " (empty)";
  if (layer.faults.empty()) return layer.caption;
  const std::size_t count = layer.faults.size();
  return layer.caption + " (" + std::to_string(count) + (count == 1 ? " fault)" : " faults)");
}

struct LegendEntry {
  const Layer* layer;
  std::vector<std::string> lines;
  double left;
  double top;
};

// Arranges entries in rows, as words in a text. `top` moves to their end.
std::vector<LegendEntry> lay_out_legend(const Figure& figure, double& top) {
  std::vector<LegendEntry> entries;
  constexpr double kWordsFrom = kSwatch + 8;
  double left = kMargin;
  double height = 0;  // height of the row
  for (const Layer& layer : figure.layers) {
    const std::string text = legend_text(layer);
    const double width = kWordsFrom + text_width(text) + 20;
    if (left > kMargin && left + width > figure.width - kMargin) {
      left = kMargin;
      top += height;
      height = 0;
    }
    auto lines = lines_of(text, figure.width - 2 * kMargin - kWordsFrom);
    height = std::max(height, kLegendRow + kLegendLine * static_cast<double>(lines.size() - 1));
    entries.push_back({&layer, std::move(lines), left, top});
    left += width;
  }
  top += height + 6;
  return entries;
}

void draw_entry(SvgPicture& picture, const LegendEntry& entry) {
  const Geometry& geometry = entry.layer->geometry;
  const std::string& style = entry.layer->style;
  const double middle = entry.top + 8;
  if (!geometry.has_thin_parts() || !geometry.region.empty()) {
    picture.box(entry.left, entry.top + 2, kSwatch, 12, "region " + style);
  } else if (!geometry.polylines.empty()) {
    const PictureLine line{entry.left, middle, entry.left + kSwatch, middle};
    picture.lines({&line, 1}, "thin " + style);
  } else {
    const Trace::Vertex dot{entry.left + kSwatch / 2, -middle};
    picture.dots({&dot, 1}, PictureTransform({}, 0, 0, 1), 3, "dot " + style);
  }
  double baseline = entry.top + 13;
  for (const std::string& line : entry.lines) {
    picture.text(entry.left + kSwatch + 8, baseline, "caption", line);
    baseline += kLegendLine;
  }
}

void draw_axes(SvgPicture& picture, const Layout& layout) {
  const double bottom = layout.top + layout.height;
  const double right = layout.left + layout.width;
  std::vector<PictureLine> lines{{layout.left, layout.top, layout.left, bottom},
                                 {layout.left, bottom, right, bottom}};
  if (!layout.extent.empty) {
    const PictureTransform placement = layout.placement();
    for (const Tick& tick : layout.x_ticks) {
      const double x = placement.x(tick.value);
      lines.push_back({x, bottom, x, bottom + kTickLength});
      picture.text(x, bottom + kTickLength + 13, "label middle", tick.label);
    }
    for (const Tick& tick : layout.y_ticks) {
      const double y = placement.y(tick.value);
      lines.push_back({layout.left - kTickLength, y, layout.left, y});
      picture.text(layout.left - kTickLength - 4, y + 4, "label end", tick.label);
    }
  }
  picture.lines(lines, "axis");
}

void draw_arrowheads(SvgPicture& picture, const Layer& layer, const PictureTransform& placement) {
  constexpr double kLength = 9;
  constexpr double kHalfWidth = 4;
  std::vector<PictureLine> lines;
  for (const Polyline& polyline : layer.geometry.polylines) {
    if (polyline.size() < 2) continue;
    const auto at = [&](const Point& point) {
      return PicturePoint{placement.x(point.x.to_double()), placement.y(point.y.to_double())};
    };
    const PicturePoint tip = at(polyline.back());
    const PicturePoint back = direction_between(tip, at(polyline[polyline.size() - 2]));
    const double x = tip.x + back.x * kLength;
    const double y = tip.y + back.y * kLength;
    for (const double side : {-kHalfWidth, kHalfWidth}) {
      lines.push_back({x - back.y * side, y + back.x * side, tip.x, tip.y});
    }
  }
  picture.lines(lines, "thin " + layer.style);
}

void draw_layers(SvgPicture& picture, const Figure& figure, const PictureTransform& placement) {
  for (const Layer& layer : figure.layers) {
    const Region& region = layer.geometry.region;
    if (!region.empty()) picture.region(region, placement, layer.style);
  }
  // Areas hide what lies below them, so that each has its colour of the legend. Outlines are seen.
  for (const Layer& layer : figure.layers) {
    const Region& region = layer.geometry.region;
    const bool hidden = &layer != &figure.layers.back() && !region.empty();
    if (hidden) picture.outlines(region, placement, layer.style);
  }
  // Thin parts come after all areas, so that no area of a later layer hides them.
  for (const Layer& layer : figure.layers) {
    picture.thin_parts(layer.geometry, placement, layer.style);
    if (layer.arrow) draw_arrowheads(picture, layer, placement);
  }
}

// A line of text below the frame.
struct ListedLine {
  double indent;
  std::string text;
};

std::vector<ListedLine> list_faults(const Figure& figure) {
  std::vector<ListedLine> lines;
  std::size_t number = 0;
  const double width = figure.width - 2 * kMargin - kFaultIndent;
  for (const Layer& layer : figure.layers) {
    const std::string name = figure.layers.size() > 1 ? layer.caption + ": " : "";
    for (const Fault& fault : layer.faults) {
      if (++number > kMaxFaultsListed) continue;
      double indent = 0;
      std::string prefix = std::to_string(number) + "  ";
      for (const std::string& line : lines_of(name + described(fault), width)) {
        lines.push_back({indent, std::exchange(prefix, "") + line});
        indent = kFaultIndent;
      }
    }
  }
  if (number > kMaxFaultsListed) {
    lines.push_back({0, "and " + std::to_string(number - kMaxFaultsListed) + " more"});
  }
  return lines;
}

}  // namespace

std::string figure_picture(const Figure& figure) {
  double top = kMargin;
  std::vector<std::string> title;
  if (!figure.title.empty()) {
    title = lines_of(figure.title, figure.width - 2 * kMargin, kTitleCharacter);
    top += kTitleHeight + kTitleRow * static_cast<double>(title.size() - 1);
  }
  std::vector<LegendEntry> entries;
  if (figure.legend) entries = lay_out_legend(figure, top);
  const Layout layout = lay_out(figure, top);
  const std::vector<ListedLine> faults = list_faults(figure);
  const double faults_height = kFaultRow * static_cast<double>(faults.size());
  SvgPicture picture(figure.width, layout.bottom + faults_height + kMargin,
                     figure.title.empty() ? figure.layers.front().caption : figure.title,
                     figure.theme);
  double baseline = kMargin + 12;
  for (const std::string& line : title) {
    picture.text(kMargin, baseline, "title", line);
    baseline += kTitleRow;
  }
  for (const LegendEntry& entry : entries) draw_entry(picture, entry);
  if (figure.axes) draw_axes(picture, layout);
  if (!layout.extent.empty) {
    const PictureTransform placement = layout.placement();
    if (figure.view) picture.begin_clip(layout.left, layout.top, layout.width, layout.height);
    draw_layers(picture, figure, placement);
    label_figure(picture, figure, placement);
    if (figure.view) picture.end_clip();
  }
  baseline = layout.bottom;
  for (const ListedLine& line : faults) {
    picture.text(kMargin + line.indent, baseline += kFaultRow, "caption", line.text);
  }
  return std::move(picture).finish();
}

}  // namespace minksum::cli
