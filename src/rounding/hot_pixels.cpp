#include "rounding/hot_pixels.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "exact/sign.hpp"
#include "machine/make_room.hpp"

namespace minksum {
namespace {

BigInteger floor_of(const Rational& value) {
  auto [quotient, rest] =
      divided(RationalAccess::numerator(value), RationalAccess::denominator(value));
  return rest.sign() < 0 ? quotient - 1 : quotient;
}

bool before(const Vec<BigInteger>& a, const Vec<BigInteger>& b) {
  return std::tie(a.x, a.y) < std::tie(b.x, b.y);
}

/// Tells exactly whether the segment from a to b meets the pixel [-1/2, 1/2)² around the origin.
///
/// This is the closed square from −1/2 to 1/2 − ε, for an ε smaller than any distance. The segment
/// misses it if both ends are beside it along an axis, or if all corners are on one side of it.
bool meets_exactly(const Vec<Rational>& a, const Vec<Rational>& b) {
  const Rational half(1, 2);
  const auto is_beside = [&](const Rational& p, const Rational& q) {
    return (p < -half && q < -half) || (p >= half && q >= half);
  };
  if (is_beside(a.x, b.x) || is_beside(a.y, b.y)) return false;
  const Vec<Rational> d{b.x - a.x, b.y - a.y};
  bool left = false;
  bool right = false;
  for (const auto& [x, y] : {std::pair{0, 0}, {0, 1}, {1, 0}, {1, 1}}) {
    int side = cross(d, {Rational(x) - half - a.x, Rational(y) - half - a.y}).sign();
    if (side == 0) side = (d.y * Rational(x) - d.x * Rational(y)).sign();  // by ε
    left |= side >= 0;
    right |= side <= 0;
  }
  return left && right;
}

/// Returns the answer in doubles, or nothing if they cannot tell.
///
/// Let m ≥ 1 bound the ends' coordinates relative to the pixel's centre. The coordinates are known
/// within m·2^-51, and so their difference within m·2^-49. The cross product of the two is off by
/// less than m²·2^-47, and so is half the difference's size in both axes. The segment misses the
/// pixel if it is beside it along an axis or along its own normal. The segment meets the pixel if
/// neither is true. Borders count neither way.
std::optional<bool> meets_by_doubles(const Vec<double>& a, const Vec<double>& b) {
  const double m = std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y), 1.0});
  const double doubt = m * 0x1p-50;
  const double low_x = std::min(a.x, b.x);
  const double high_x = std::max(a.x, b.x);
  const double low_y = std::min(a.y, b.y);
  const double high_y = std::max(a.y, b.y);
  const double far = 0.5 + doubt;
  if (low_x > far || high_x < -far || low_y > far || high_y < -far) return false;
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double distance = std::abs(a.x * dy - a.y * dx);
  const double reach = 0.5 * (std::abs(dx) + std::abs(dy));
  const double error = m * m * 0x1p-45;
  if (distance > reach + error) return false;
  const double close = 0.5 - doubt;
  if (low_x < close && high_x > -close && low_y < close && high_y > -close &&
      distance < reach - error) {
    return true;
  }
  return std::nullopt;
}

}  // namespace

SnapPoint snap_point(const Rational& x, const Rational& y) {
  const Rational half(1, 2);
  SnapPoint point;
  point.centre = {floor_of(x + half), floor_of(y + half)};
  point.offset = {x - RationalAccess::make(point.centre.x, 1),
                  y - RationalAccess::make(point.centre.y, 1)};
  point.near_offset = {point.offset.x.to_double(), point.offset.y.to_double()};
  return point;
}

bool meets_pixel(const SnapPoint& a, const SnapPoint& b, const Vec<BigInteger>& centre) {
  const Vec<BigInteger> to_a{a.centre.x - centre.x, a.centre.y - centre.y};
  const Vec<BigInteger> to_b{b.centre.x - centre.x, b.centre.y - centre.y};
  const auto answer =
      meets_by_doubles({to_double(to_a.x) + a.near_offset.x, to_double(to_a.y) + a.near_offset.y},
                       {to_double(to_b.x) + b.near_offset.x, to_double(to_b.y) + b.near_offset.y});
  if (answer) return *answer;
  const auto exact = [](const BigInteger& centre_coordinate, const Rational& offset) {
    return RationalAccess::make(centre_coordinate, 1) + offset;
  };
  return meets_exactly({exact(to_a.x, a.offset.x), exact(to_a.y, a.offset.y)},
                       {exact(to_b.x, b.offset.x), exact(to_b.y, b.offset.y)});
}

HotPixels::HotPixels(std::span<const SnapPoint> points, Cancellation& cancellation) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    cancellation.check(4);
    return before(points[a].centre, points[b].centre);
  });
  pixel_of_.resize(points.size());
  for (const std::size_t i : order) {
    if (centres_.empty() || centres_.back() != points[i].centre) {
      centres_.push_back(points[i].centre);
    }
    pixel_of_[i] = static_cast<PixelId>(centres_.size() - 1);
  }
  stamp_.assign(centres_.size(), 0);
  if (!centres_.empty()) place_in_cells(cancellation);
}

/// Measures cells in units of 2^k steps, with k such that doubles hold all units. So the centre of
/// every pixel is known within one unit, which is a step or far less than a cell.
void HotPixels::place_in_cells(Cancellation& cancellation) {
  constexpr std::size_t kBits = 50;
  Vec<BigInteger> low = centres_[0];
  Vec<BigInteger> high = centres_[0];
  for (const auto& c : centres_) {
    if (c.y < low.y) low.y = c.y;
    if (c.y > high.y) high.y = c.y;
  }
  high.x = centres_.back().x;
  const std::size_t bits = std::max(bit_length(high.x - low.x), bit_length(high.y - low.y));
  const auto unit = static_cast<std::int64_t>(bits > kBits ? bits - kBits : 0);
  Vec<double> extent{};
  for (const auto& c : centres_) {
    cancellation.check(8);
    near_.push_back({to_double((c.x - low.x) >> unit), to_double((c.y - low.y) >> unit)});
    extent = {std::max(extent.x, near_.back().x), std::max(extent.y, near_.back().y)};
  }
  // Along both axes, a pixel that a segment meets is within one step of the line between the
  // centres of its ends' pixels. Centres are off by one unit more.
  constexpr double kReach = 4;
  const int side = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(centres_.size()))), 1,
                              UniformGrid::kMaxSide / 8);
  const double longer = std::max({extent.x, extent.y, 1.0});
  // The quotient is clamped before the cast, because it may be beyond any int.
  const int fine = static_cast<int>(std::clamp(longer / kReach, 1.0, static_cast<double>(side)));
  grid_ = UniformGrid::over({std::max(extent.x, 1.0), std::max(extent.y, 1.0)}, fine);
  margin_ = kReach <= grid_.cell.x * UniformGrid::kMargin ? UniformGrid::kMargin : 1;
  const auto cell_of = [&](PixelId p) {
    return static_cast<std::size_t>(grid_.row(near_[p].y)) *
               static_cast<std::size_t>(grid_.columns) +
           static_cast<std::size_t>(grid_.column(near_[p].x));
  };
  list_by_key(static_cast<std::size_t>(grid_.size()), cancellation, cell_begin_, in_cells_,
              [&](auto visit) {
                cancellation.check(2 * centres_.size());
                for (PixelId p = 0; p < centres_.size(); ++p) visit(cell_of(p), p);
              });
}

void HotPixels::list_met(const SnapPoint& a, std::size_t index_a, const SnapPoint& b,
                         std::size_t index_b, Cancellation& cancellation,
                         std::vector<PixelId>& met) {
  met.clear();
  ++walk_;
  const PixelId from = pixel_of_[index_a];
  const PixelId to = pixel_of_[index_b];
  const std::uint64_t work =
      4 * (work_of({a.offset.x, a.offset.y}) + work_of({b.offset.x, b.offset.y}));
  const auto add = [&](PixelId p) {
    if (stamp_[p] == walk_) return;
    cancellation.check(work);
    stamp_[p] = walk_;
    if (p == from || p == to || meets_pixel(a, b, centres_[p])) met.push_back(p);
  };
  grid_.walk(near_[from], near_[to], margin_, [&](std::int32_t i, std::int32_t j) {
    const std::size_t cell = static_cast<std::size_t>(j) * static_cast<std::size_t>(grid_.columns) +
                             static_cast<std::size_t>(i);
    cancellation.check(1 + cell_begin_[cell + 1] - cell_begin_[cell]);
    for (std::uint32_t k = cell_begin_[cell]; k < cell_begin_[cell + 1]; ++k) add(in_cells_[k]);
    return true;
  });
  // Along a straight line, each coordinate of the pixels only grows or only falls.
  const bool right = !(centres_[to].x < centres_[from].x);
  const bool up = !(centres_[to].y < centres_[from].y);
  std::sort(met.begin(), met.end(), [&](PixelId p, PixelId q) {
    cancellation.check(4);
    const auto by_x = centres_[p].x <=> centres_[q].x;
    if (by_x != 0) return right == (by_x < 0);
    const auto by_y = centres_[p].y <=> centres_[q].y;
    return by_y != 0 && up == (by_y < 0);
  });
}

}  // namespace minksum
