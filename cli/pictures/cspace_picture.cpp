#include "pictures/cspace_picture.hpp"

#include <algorithm>
#include <cstdio>

#include "minksum/boolean.hpp"
#include "minksum/resolve.hpp"
#include "pictures/picture_key.hpp"

namespace minksum::cli {
namespace {

constexpr double kSliceGap = 22;
constexpr double kLabel = 22;
constexpr double kSpaceCaption = 48;
constexpr std::size_t kSliceColumns = 4;
constexpr std::size_t kMostShown = 12;
constexpr double kOneWidth = 720;

Region as_region(const Box& box) {
  return Region(Polygon{{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}, {}});
}

std::string label_of(const Turn& turn) {
  char text[64];
  std::snprintf(text, sizeof text, "%.6g°", turn.asked.to_double());
  return text;
}

std::vector<KeyEntry> key_of(bool free) {
  return {free ? KeyEntry{"sum", "Free: where the robot's dot can be"}
               : KeyEntry{"blocked", "Blocked: where the robot's dot cannot be"},
          {"first", "Obstacles"},
          {"second", "The robot as it is turned"}};
}

double column_width() {
  return (kPageWidth - 2 * kPageMargin - (kSliceColumns - 1) * kSliceGap) / kSliceColumns;
}

std::size_t rows_of(std::size_t shown) { return (shown + kSliceColumns - 1) / kSliceColumns; }

}  // namespace

CspacePicture::CspacePicture(const ConfigurationSpace& space, const Geometry& obstacles,
                             const ConfigurationOptions& setting, const Options& options, bool free)
    : free_(free),
      boundary_(space.boundary()),
      obstacles_(resolve(obstacles, {.fill = options.fill})),
      robot_(space.robot()),
      corner_{boundary_.max.x + space.radius(), boundary_.max.y - space.radius()} {
  if (setting.workspace) {
    const Options reading{.fill = options.fill, .regularize = true};
    workspace_ = resolve(*setting.workspace, reading).region;
  }
  extent_.include({as_region(boundary_), {}, {}});
  // The robot stands beside the plane, where nobody takes it for a part of the free space.
  extent_.include({{}, {}, {{corner_.x + space.radius(), corner_.y}}});
}

double CspacePicture::height_for(double width) const {
  return extent_.height() * fitting_scale(extent_, width, width) + kLabel;
}

void CspacePicture::draw(SvgPicture& picture, const Slice& slice, double left, double top,
                         double width) const {
  const PictureTransform placement(extent_, left, top + kLabel,
                                   fitting_scale(extent_, width, width));
  picture.text(left, top + kLabel - 8, "title", label_of(slice.turn));
  const Region ground = as_region(boundary_);
  picture.region(ground, placement, "pale");
  if (free_) {
    picture.region(slice.free.region, placement, "sum");
    picture.thin_parts(slice.free, placement, "tight");
  } else {
    picture.region(
        workspace_.empty() ? slice.obstacles.region : intersect(slice.obstacles.region, ground),
        placement, "blocked");
  }
  if (!workspace_.empty()) picture.region(workspace_, placement, "grid");
  picture.geometry(obstacles_, placement, "first");
  const Affine to_corner = Affine::translation(corner_.x, corner_.y);
  picture.region(transform(robot_, to_corner.after(slice.turn.map())), placement, "second");
  picture.thin_parts({{}, {}, {corner_}}, placement, "mark");
}

std::string CspacePicture::one(const Slice& slice) const {
  const double key = kKeyRow * key_rows(key_of(free_), kOneWidth);
  SvgPicture picture(kOneWidth + 2 * kPageMargin, height_for(kOneWidth) + key + 2 * kPageMargin,
                     "Slice at " + label_of(slice.turn));
  draw_key(picture, key_of(free_), kPageMargin, kPageMargin, kOneWidth);
  draw(picture, slice, kPageMargin, kPageMargin + key, kOneWidth);
  return std::move(picture).finish();
}

Overview::Overview(const CspacePicture& slices, std::size_t count, bool free)
    : slices_(slices),
      count_(count),
      shown_(std::min(count, kMostShown)),
      picture_(kPageWidth, top(rows_of(shown_) * kSliceColumns) - kSliceGap + kPageMargin,
               "Configuration space") {
  picture_.text(kPageMargin, kPageMargin + 14, "title",
                free ? "Free space" : "Configuration-space obstacles");
  draw_key(picture_, key_of(free), kPageMargin, kPageMargin + 22, kPageWidth - 2 * kPageMargin);
}

double Overview::left(std::size_t shown) const {
  return kPageMargin + static_cast<double>(shown % kSliceColumns) * (column_width() + kSliceGap);
}

double Overview::top(std::size_t shown) const {
  return kPageMargin + kSpaceCaption +
         static_cast<double>(shown / kSliceColumns) *
             (slices_.height_for(column_width()) + kSliceGap);
}

void Overview::offer(std::size_t index, const Slice& slice) {
  // The slices to be drawn are those at the beginnings of `shown_` even steps.
  if (drawn_ == shown_ || index != drawn_ * count_ / shown_) return;
  slices_.draw(picture_, slice, left(drawn_), top(drawn_), column_width());
  ++drawn_;
}

std::string Overview::finish() && { return std::move(picture_).finish(); }

}  // namespace minksum::cli
