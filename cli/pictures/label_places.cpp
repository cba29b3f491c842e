#include "pictures/label_places.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace minksum::cli {
namespace {

constexpr double kCell = 32;  // some labels fit into a cell, and a label into a few cells

// Calls visit(cell) for each cell that the box touches.
void for_each_cell(const LabelBox& box, auto visit) {
  const auto cell = [](double at) { return static_cast<long long>(std::floor(at / kCell)); };
  for (long long row = cell(box.top); row <= cell(box.bottom); ++row) {
    for (long long column = cell(box.left); column <= cell(box.right); ++column) {
      constexpr long long kColumns = 1LL << 20;  // pictures have fewer
      visit(row * kColumns + column);
    }
  }
}

}  // namespace

void LabelPlaces::take(const LabelBox& box) {
  for_each_cell(box, [&](long long cell) { cells_[cell].push_back(box); });
}

void LabelPlaces::take_line(PicturePoint from, PicturePoint to) {
  constexpr double kStep = 3;  // a line becomes boxes that are as wide as a thick line
  const double x = to.x - from.x;
  const double y = to.y - from.y;
  // A zoom leaves most of a line outside, which takes no place. No picture is as high as this.
  constexpr double kHigh = 4;
  double begin = 0;
  double end = 1;
  const auto clip = [&](double at, double along, double most) {
    if (along == 0) {
      if (at < 0 || at > most) end = -1;
      return;
    }
    const double first = -at / along;
    const double second = (most - at) / along;
    begin = std::max(begin, std::min(first, second));
    end = std::min(end, std::max(first, second));
  };
  clip(from.x, x, width_);
  clip(from.y, y, kHigh * width_);
  const double length = std::hypot(x, y);
  for (double at = begin * length; at <= end * length; at += kStep) {
    const double share = length > 0 ? at / length : 0;
    const PicturePoint middle{from.x + share * x, from.y + share * y};
    take({middle.x - kStep / 2, middle.y - kStep / 2, middle.x + kStep / 2, middle.y + kStep / 2});
  }
}

double LabelPlaces::area_taken(const LabelBox& box) const {
  double area = 0;
  for_each_cell(box, [&](long long cell) {
    const auto found = cells_.find(cell);
    if (found == cells_.end()) return;
    for (const LabelBox& taken : found->second) {
      const double wide = std::min(box.right, taken.right) - std::max(box.left, taken.left);
      const double high = std::min(box.bottom, taken.bottom) - std::max(box.top, taken.top);
      if (wide > 0 && high > 0) area += wide * high;
    }
  });
  const double beyond = std::max(0.0, -box.left) + std::max(0.0, box.right - width_);
  return area + beyond * (box.bottom - box.top) * 4;  // what is cut off is worse than hidden
}

PicturePoint LabelPlaces::place(PicturePoint anchor, PicturePoint direction, double distance,
                                double width, double height) {
  // In eighths of a turn, the nearest to the wished direction first.
  constexpr int kTurns[] = {0, 1, -1, 2, -2, 3, -3, 4};
  constexpr int kRings = 3;  // farther away nobody sees what a label belongs to
  const double wished = std::atan2(direction.y, direction.x);
  PicturePoint best{};
  double least = -1;
  for (int ring = 0; ring < kRings && least != 0; ++ring) {
    for (const int turn : kTurns) {
      const double angle = wished + turn * std::numbers::pi / 4;
      const double x = std::cos(angle);
      const double y = std::sin(angle);
      // A wide label has its middle farther to the side.
      const double away = distance + height * ring;
      const PicturePoint middle{anchor.x + x * (away + std::max(0.0, width - height) / 2),
                                anchor.y + y * away};
      const double taken = area_taken({middle.x - width / 2, middle.y - height / 2,
                                       middle.x + width / 2, middle.y + height / 2});
      if (least >= 0 && taken >= least) continue;
      best = middle;
      least = taken;
      if (taken == 0) break;
    }
  }
  take({best.x - width / 2, best.y - height / 2, best.x + width / 2, best.y + height / 2});
  return best;
}

}  // namespace minksum::cli
