#include "pictures/sum_picture.hpp"

#include <algorithm>
#include <optional>

#include "minksum/resolve.hpp"
#include "output/picture_file.hpp"
#include "pictures/svg_picture.hpp"

namespace minksum::cli {
namespace {

constexpr double kGap = 40;
constexpr double kRegionCaption = 44;  // room for two lines of text above each region

// A caption may be wider than a small region below it.
constexpr double kMinColumn = 190;

struct SumLayout {
  Extent extents[3];  // P, Q, sum
  double scale = 1;
  double left_column = 0;
  bool has_q = true;

  [[nodiscard]] double width(int i) const { return extents[i].width() * scale; }
  [[nodiscard]] double height(int i) const { return extents[i].height() * scale; }
  [[nodiscard]] double total_height() const {
    const double below = has_q ? kGap + kRegionCaption + height(1) : 0;
    return 2 * kPageMargin + kRegionCaption + std::max(height(0) + below, height(2));
  }
};

// Chooses the largest scale at which both columns fit the width, and the higher one the height.
SumLayout lay_out(const Drawing& drawing, const Geometry* sum) {
  SumLayout layout;
  layout.extents[0] = extent_of(drawing.p);
  layout.extents[1] = extent_of(drawing.q);
  layout.has_q = drawing.captions.q != nullptr;
  if (drawing.mark) {
    layout.extents[1].include(drawing.mark->x.to_double(), drawing.mark->y.to_double());
  }
  if (sum != nullptr) layout.extents[2] = extent_of(*sum);
  if (sum != nullptr && drawing.tight != nullptr) layout.extents[2].include(*drawing.tight);
  if (sum != nullptr && drawing.p_below) layout.extents[2].include(drawing.p);
  const Extent* const e = layout.extents;
  const double left = std::max(e[0].width(), e[1].width());
  const double room = kPageWidth - 2 * kPageMargin;
  Extent right = e[2];
  double scale = fitting_scale(right, room - kGap - kMinColumn, kPageHeight - kRegionCaption);
  if (right.empty) scale = std::numeric_limits<double>::infinity();
  if (const double both = left + right.width(); both > 0) {
    scale = std::min(scale, (room - (right.empty ? 0 : kGap)) / both);
  }
  if (const double stacked = e[0].height() + e[1].height(); stacked > 0) {
    scale = std::min(scale, (kPageHeight - 2 * kRegionCaption - kGap) / stacked);
  }
  layout.scale = e[0].empty && e[1].empty && right.empty ? 1 : scale;
  layout.left_column = std::max(kMinColumn, left * layout.scale);
  return layout;
}

// Position, style and caption of one of the three drawings.
struct PictureFrame {
  const Extent& extent;
  double left;
  double top;
  double scale;
  const char* name;
  const char* style;
};

bool contains(const Extent& outer, const Extent& inner) {
  return !outer.empty && outer.min_x <= inner.min_x && outer.min_y <= inner.min_y &&
         outer.max_x >= inner.max_x && outer.max_y >= inner.max_y;
}

void draw(SvgPicture& picture, const Geometry& geometry, const PictureFrame& place,
          const Geometry* tight = nullptr, const Geometry* below = nullptr) {
  picture.text(place.left, place.top + 14, "title", place.name);
  std::string note = summary(geometry);
  if (tight != nullptr) note += "; tight places: " + (tight->empty() ? "none" : summary(*tight));
  picture.text(place.left, place.top + 32, "note", note);
  if (place.extent.empty) return;
  const PictureTransform placement(place.extent, place.left, place.top + kRegionCaption,
                                   place.scale);
  // The smaller one lies on top, because areas hide what is below them.
  const bool covers = below != nullptr && contains(extent_of(geometry), extent_of(*below));
  if (below != nullptr && !covers) picture.geometry(*below, placement, "first");
  picture.geometry(geometry, placement, place.style);
  if (covers) {
    picture.geometry(*below, placement, "first");
    picture.outlines(geometry.region, placement, place.style);
  } else if (below != nullptr) {
    picture.outlines(below->region, placement, "first");
  }
  if (tight != nullptr) picture.thin_parts(*tight, placement, "tight");
}

std::string picture_of(const Drawing& drawing, const Geometry* sum) {
  const Captions& captions = drawing.captions;
  const SumLayout layout = lay_out(drawing, sum);
  SvgPicture picture(kPageWidth, layout.total_height(),
                     sum != nullptr ? captions.title : "P and Q");
  draw(picture, drawing.p,
       {layout.extents[0], kPageMargin, kPageMargin, layout.scale, captions.p, "first"});
  const PictureFrame second{
      layout.extents[1], kPageMargin, kPageMargin + kRegionCaption + layout.height(0) + kGap,
      layout.scale,      captions.q,  "second"};
  if (layout.has_q) draw(picture, drawing.q, second);
  if (drawing.mark) {
    picture.thin_parts(
        {{}, {}, {*drawing.mark}},
        PictureTransform(second.extent, second.left, second.top + kRegionCaption, second.scale),
        "mark");
  }
  if (sum != nullptr) {
    draw(picture, *sum,
         {layout.extents[2], kPageMargin + layout.left_column + kGap, kPageMargin, layout.scale,
          captions.sum, "sum"},
         drawing.tight, drawing.p_below ? &drawing.p : nullptr);
  }
  return std::move(picture).finish();
}

}  // namespace

Drawing drawing_of(const SumRun& run, const Options& options) {
  const Options reading{.fill = options.fill, .regularize = options.regularize};
  return {resolve(run.operands[0], reading),
          resolve(run.operands[1], reading),
          run.exact,
          run.tight ? &*run.tight : nullptr,
          {},
          false,
          {}};
}

std::string sum_picture(const Drawing& drawing) { return picture_of(drawing, &drawing.sum); }

void write_picture(OutputFiles& files, const std::string& file, const Drawing& drawing) {
  write_picture(files, file, [&] { return sum_picture(drawing); });
}

std::string operands_picture(const Drawing& drawing) { return picture_of(drawing, nullptr); }

std::string summary(const Geometry& geometry) {
  std::string text;
  const auto add = [&text](std::size_t number, const char* one, const char* many) {
    text += (text.empty() ? "" : ", ") + grouped(number) + " " + (number == 1 ? one : many);
  };
  const Region& region = geometry.region;
  if (!region.empty()) add(region.vertex_count(), "vertex", "vertices");
  if (region.hole_count() > 0) add(region.hole_count(), "hole", "holes");
  if (region.polygon_count() > 1) add(region.polygon_count(), "part", "parts");
  if (!geometry.polylines.empty()) add(geometry.polylines.size(), "polyline", "polylines");
  if (!geometry.points.empty()) add(geometry.points.size(), "point", "points");
  return text.empty() ? "empty" : text;
}

std::string grouped(std::uint64_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t end = digits.size(); end > 3; end -= 3) digits.insert(end - 3, 1, ',');
  return digits;
}

}  // namespace minksum::cli
