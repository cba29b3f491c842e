#include "sum/small/small_segments.hpp"

#include <algorithm>
#include <cmath>

#include "machine/vectors.hpp"

namespace minksum {
namespace {

// -- Hilbert's curve through squares ----------------------------------------------------------
constexpr int kSideBits = 4;
constexpr std::uint32_t kSide = 1U << kSideBits;
/// A square's place on the curve, and how the curve goes through its parts.
struct Step {
  std::uint8_t place;
  std::uint8_t turned;  ///< 1: x and y are swapped; 2: both run backwards
};
/// By how the curve goes through the whole, and by row and column.
constexpr auto kCurve = [] {
  std::array<std::array<Step, kSide * kSide>, 4> curve{};
  for (std::uint32_t square = 0; square < 4 * kSide * kSide; ++square) {
    std::uint32_t turned = square / (kSide * kSide);
    const std::uint32_t x = square % kSide;
    const std::uint32_t y = square / kSide % kSide;
    std::uint32_t place = 0;
    for (std::uint32_t half = kSide / 2; half > 0; half /= 2) {
      std::uint32_t right = (x & half) != 0 ? 1 : 0;
      std::uint32_t upper = (y & half) != 0 ? 1 : 0;
      if ((turned & 2) != 0) {
        right ^= 1;
        upper ^= 1;
      }
      if ((turned & 1) != 0) std::swap(right, upper);
      place = 4 * place + (right != 0 ? 3 - upper : upper);
      // The curve enters each quarter turned its own way.
      if (upper == 0) turned ^= right != 0 ? 3 : 1;
    }
    curve[square / (kSide * kSide)][square % (kSide * kSide)] = {static_cast<std::uint8_t>(place),
                                                                 static_cast<std::uint8_t>(turned)};
  }
  return curve;
}();

/// Leaves out the segments whose lines are not wanted.
template <class IsWanted>
void keep_if(SmallSegments& s, IsWanted is_wanted) {
  std::uint32_t kept = 0;
  for (std::uint32_t i = 0; i < s.size; ++i) {
    const Vec<double> start{s.x[i], s.y[i]};
    if (is_wanted(Line{start, plus(start, s.way()[i])})) s.copy(s, i, kept++);
  }
  s.left_out += s.size - kept;
  s.size = kept;
}

}  // namespace

void SmallSegments::finish(double reach) {
  const auto fill_up = [this](SegmentRows& rows) {
    for (std::size_t i = size; i < filled_up(size); ++i) {
      rows.x[i] = rows.x[size - 1];
      rows.y[i] = rows.y[size - 1];
      rows.dx[i] = rows.dy[i] = 0;
    }
  };
  fill_up(*this);
  if (in_part) fill_up(part);
  for (std::size_t i = size; wide && i < filled_up(size); ++i) start[i] = end[i] = -1;
  const SegmentRows& rows = boxes();
  blocks.set(rows.x.data(), rows.y.data(), rows.dx.data(), rows.dy.data(), size, reach);
}

bool SmallSegments::is_out_of_order() const {
  const std::size_t many = 3 * blocks.size() + 10;
  if (blocks.size() * (blocks.size() + 1) / 2 <= many) return false;
  std::size_t pairs = 0;
  const auto count = [&](std::size_t, LaneBits near) __attribute__((always_inline)) {
    pairs += static_cast<std::size_t>(std::popcount(near));
    return pairs <= many;
  };
  const auto count_all = [&]() __attribute__((always_inline)) {
    for (std::size_t i = 0; i < blocks.size() && pairs <= many; ++i) {
      blocks.for_each_near(blocks.box_of(i), i, count);
    }
  };
  with_vectors(widest_vectors(), count_all);
  return pairs > many;
}

void drop_copies(const SmallOperand& p, double width, SmallSegments& s) {
  const SmallNumbers<WideNumber> numbers{reach_of(width)};
  std::uint32_t kept = 0;
  for (std::uint32_t i = 0; i < s.size; ++i) {
    const SegmentOrigin o = s.origin[i];
    // An edge at its own ends is parallel to an edge there, too.
    const bool stays = o.of_first != 0 ? o.edge <= o.vertex : o.vertex <= o.edge + 1;
    const auto turn = [&](const auto& lanes) __attribute__((always_inline)) {
      const auto edge = lanes.get(p.way(), o.edge);
      return o.of_first != 0 ? lanes.turn(edge, lanes.get(p.out(), o.vertex))
                             : lanes.turn(lanes.get(p.in(), o.vertex), edge);
    };
    if (stays || decide(numbers, turn) <= 0) s.copy(s, i, kept++);
  }
  s.left_out += s.size - kept;
  s.size = kept;
}

void drop_hidden(const Cover& cover, UncoveredRows& uncovered, SmallSegments& s) {
  Cancellation never;
  uncovered.unite(cover, never);
  keep_if(s, [&](const Line& line) { return !is_hidden(cover, uncovered, line); });
}

SmallSample take_sample(const Cover& cover, const SmallSegments& from, SmallSegments& to) {
  // Of meetings, the square of the share is left: 16 for two meetings of each segment.
  const auto share_of = [](double segments) { return std::min(std::sqrt(8 / segments), 1.0); };
  // Returns the share that was taken of all segments.
  const auto take = [&](double share) {
    to.clear_as(from);
    // Each pair must be as likely as any other: of those far apart in the list, fewer meet.
    const auto below = static_cast<std::uint64_t>(share * 0x1p32);
    std::uint32_t random = 1;
    for (std::uint32_t i = 0; i < from.size; ++i) {
      random = 1664525 * random + 1013904223;
      if (random < below) to.copy(from, i, to.size++);
    }
    const double taken = std::max(to.size, 1U) / static_cast<double>(from.size);
    if (cover.active) {
      keep_if(to, [&](const Line& line) {
        return cells_near(cover, line, Until::kUncovered).uncovered;
      });
    }
    return taken;
  };
  double share = take(share_of(from.size));
  const double whole = std::max(to.size / share, 1.0);
  // If half of them or more are hidden, those that are left tell too little.
  if (to.size <= to.left_out) share = take(share_of(whole));
  return {share, static_cast<std::uint32_t>(whole)};
}

void SmallOrder::apply(const SmallSegments& from, const Vec<double>& extent, double reach,
                       SmallSegments& to) {
  // By operand.
  std::array<double, 2> edges{};
  std::array<double, 2> run{};
  std::array<double, 2> rise{};
  for (std::uint32_t i = 0; i < from.size; ++i) {
    const std::uint32_t operand = from.origin[i].of_first;
    edges[operand] += 1;
    run[operand] += std::abs(from.dx[i]);
    rise[operand] += std::abs(from.dy[i]);
  }
  CellShape shape;
  for (std::size_t i = 0; i < 2; ++i) shape.add(edges[i], run[i], rise[i]);
  const double stretch = shape.stretch();
  const double width = std::max(extent.x, extent.y * stretch);
  // A rounded place may lie beyond the sum's box.
  const auto scale_of = [](double size) { return kSide * kSide / (size * (1 + 0x1p-40) + 1); };
  const Vec<double> scale{scale_of(width), scale_of(width / stretch)};
  const auto cells = static_cast<int>(std::bit_width(from.size * 4));
  const int shift = std::max(4 * kSideBits - cells, 0);
  place_.assign((std::size_t{kSide} * kSide * kSide * kSide >> shift) + 1, 0);
  cell_.resize(from.size);
  for (std::uint32_t i = 0; i < from.size; ++i) {
    const Vec<double> middle = from.middle_of(i);
    const auto column = static_cast<std::uint32_t>(middle.x * scale.x);
    const auto row = static_cast<std::uint32_t>(middle.y * scale.y);
    const Step& whole = kCurve[0][row / kSide * kSide + column / kSide];
    const Step& part = kCurve[whole.turned][row % kSide * kSide + column % kSide];
    cell_[i] = (whole.place * kSide * kSide + std::uint32_t{part.place}) >> shift;
    ++place_[cell_[i] + std::size_t{1}];
  }
  for (std::size_t k = 1; k < place_.size(); ++k) place_[k] += place_[k - 1];
  to.clear_as(from);
  to.size = from.size;
  to.left_out = from.left_out;
  for (std::uint32_t i = 0; i < from.size; ++i) {
    to.copy(from, i, place_[cell_[i]]++);
  }
  to.finish(reach);
}

}  // namespace minksum
