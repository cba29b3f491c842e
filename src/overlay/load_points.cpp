#include "overlay/load_points.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <limits>

#include "overlay/exact_points_of.hpp"
#include "region/region_access.hpp"

namespace minksum::overlay {
namespace {

template <class Visit>
void for_each_coordinate(std::span<const Source> sources, Cancellation& cancellation, Visit visit) {
  for (const Source& source : sources) {
    cancellation.check();
    visit(RegionAccess::x(*source.region, source.vertex));
    visit(RegionAccess::y(*source.region, source.vertex));
  }
}

/// Finds the smallest powers of two and ten in use. Returns false if the integers on that grid have
/// so many bits that their differences do not fit the widest rung.
bool find_grid(std::span<const Source> sources, Cancellation& cancellation, Frame& frame) {
  constexpr int kHigh = std::numeric_limits<int>::max();
  frame.exp2 = frame.exp10 = kHigh;
  bool quotients = false;
  for_each_coordinate(sources, cancellation, [&](const StoredCoordinate& c) {
    quotients |= c.denominator_limbs != 0;
    if (c.payload == 0) return;
    frame.exp2 = std::min<int>(frame.exp2, c.exp2);
    frame.exp10 = std::min<int>(frame.exp10, c.exp10);
  });
  if (quotients) return false;
  if (frame.exp2 == kHigh) frame.exp2 = frame.exp10 = 0;  // all are zero
  int bits = 0;
  for_each_coordinate(sources, cancellation, [&](const StoredCoordinate& c) {
    if (c.payload == 0) return;
    bits = std::max(bits, bit_width(Int128{c.payload}) + (c.exp2 - frame.exp2) +
                              bits_of_ten_to(c.exp10 - frame.exp10));
  });
  return bits < WideRung::kBits;  // a difference has one bit more
}

Int128 on_grid(const StoredCoordinate& c, const Frame& frame) {
  if (c.payload == 0) return 0;
  Int128 value = c.payload;
  for (int i = frame.exp10; i < c.exp10; ++i) value *= 10;
  return value * (Int128{1} << (c.exp2 - frame.exp2));
}

struct GridPoint {
  Int128 x;
  Int128 y;
};

template <class Rung>
std::unique_ptr<ExactPoints> make(std::span<const GridPoint> points, Frame frame) {
  std::vector<typename ExactPointsOf<Rung>::Own> own;
  own.reserve(points.size());
  using Length = typename Rung::Length;
  for (const GridPoint& p : points) {
    own.push_back({static_cast<Length>(p.x), static_cast<Length>(p.y)});
  }
  return std::make_unique<ExactPointsOf<Rung>>(std::move(own), std::vector<Length>{},
                                               std::move(frame));
}

std::unique_ptr<ExactPoints> load_grid(std::span<const Source> sources, Cancellation& cancellation,
                                       Frame frame) {
  std::vector<GridPoint> points;
  points.reserve(sources.size());
  for (const Source& s : sources) {
    cancellation.check(4);
    points.push_back({on_grid(RegionAccess::x(*s.region, s.vertex), frame),
                      on_grid(RegionAccess::y(*s.region, s.vertex), frame)});
  }
  GridPoint low = points.empty() ? GridPoint{0, 0} : points[0];
  GridPoint high = low;
  for (const GridPoint& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  for (GridPoint& p : points) p = {p.x - low.x, p.y - low.y};
  frame.offset_x = low.x;
  frame.offset_y = low.y;
  const int bits = std::max(bit_width(high.x - low.x), bit_width(high.y - low.y));
  if (bits <= NarrowRung::kBits) return make<NarrowRung>(points, std::move(frame));
  if (bits <= MediumRung::kBits) return make<MediumRung>(points, std::move(frame));
  return make<WideRung>(points, std::move(frame));
}

LoadedPoints load_homogeneous(std::span<const Source> sources, Cancellation& cancellation) {
  std::vector<ExactPointsOf<ArbitraryRung>::Own> points;
  std::vector<BigInteger> weights;
  points.reserve(sources.size());
  weights.reserve(sources.size());
  int log2_largest = std::numeric_limits<int>::min();
  std::size_t bits = 0;
  const auto measure = [&](const Rational& value) {
    if (value.sign() == 0) return;
    const auto above = static_cast<int>(bit_length(RationalAccess::numerator(value)));
    const auto below = static_cast<int>(bit_length(RationalAccess::denominator(value)));
    log2_largest = std::max(log2_largest, above - below + 1);
  };
  for (const Source& s : sources) {
    const Point p = s.region->point(s.vertex);
    cancellation.check(work_of(p));
    measure(p.x);
    measure(p.y);
    const BigInteger& dx = RationalAccess::denominator(p.x);
    const BigInteger& dy = RationalAccess::denominator(p.y);
    BigInteger w = least_common_multiple(dx, dy);
    points.push_back(
        {RationalAccess::numerator(p.x) * (w / dx), RationalAccess::numerator(p.y) * (w / dy)});
    bits = std::max({bits, bit_length(w), p.x.bits(), p.y.bits()});
    weights.push_back(std::move(w));
  }
  // The largest coordinate is about 2^100. So a product of three is far from overflow.
  Frame frame;
  frame.approximate_exp2 = log2_largest == std::numeric_limits<int>::min() ? 0 : 100 - log2_largest;
  return {std::make_unique<ExactPointsOf<ArbitraryRung>>(std::move(points), std::move(weights),
                                                         std::move(frame)),
          work_of_decision(bits)};
}

}  // namespace

LoadedPoints load_points(std::span<const Source> sources, Cancellation& cancellation) {
  constexpr std::uint64_t kWorkOnGrid = 8;
  Frame frame;
  if (find_grid(sources, cancellation, frame)) {
    return {load_grid(sources, cancellation, frame), kWorkOnGrid};
  }
  return load_homogeneous(sources, cancellation);
}

}  // namespace minksum::overlay
