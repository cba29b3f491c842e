#include "overlay/load_points.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "overlay/exact_points_of.hpp"
#include "region/grid_scale.hpp"

namespace minksum::overlay {
namespace {

template <class Numbers>
std::unique_ptr<ExactPoints> make(const GridCoordinates& grid) {
  std::vector<typename ExactPointsOf<Numbers>::Own> own;
  own.reserve(grid.large_sites.size());
  using Length = typename Numbers::Length;
  for (const Vec<Int128>& p : grid.large_sites) {
    own.push_back({static_cast<Length>(p.x), static_cast<Length>(p.y)});
  }
  Frame frame{grid.offset.x, grid.offset.y, grid.unit.exp2, grid.unit.exp10};
  return std::make_unique<ExactPointsOf<Numbers>>(std::move(own), std::vector<Length>{},
                                                  std::move(frame));
}

std::unique_ptr<ExactPoints> load_on_grid(std::span<const Source> sources, const Scale& scale,
                                          Cancellation& cancellation) {
  GridCoordinates grid;
  const auto at = [&](std::size_t i) {
    const auto on = [&](const StoredCoordinate& c) {
      return on_grid<Int128>(c.payload, c.exp2, c.exp10, scale);
    };
    const auto& [region, v] = sources[i];
    return Vec<Int128>{on(RegionAccess::x(*region, v)), on(RegionAccess::y(*region, v))};
  };
  load_grid(sources.size(), scale, at, cancellation, grid.large_sites, grid);
  if (grid.bits <= NarrowNumbers::kBits) return make<NarrowNumbers>(grid);
  if (grid.bits <= MediumNumbers::kBits) return make<MediumNumbers>(grid);
  return make<WideNumbers>(grid);
}

LoadedPoints load_homogeneous(std::span<const Source> sources, Cancellation& cancellation) {
  std::vector<ExactPointsOf<ArbitraryNumbers>::Own> points;
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
  return {std::make_unique<ExactPointsOf<ArbitraryNumbers>>(std::move(points), std::move(weights),
                                                            std::move(frame)),
          work_of_decision(bits)};
}

}  // namespace

LoadedPoints load_points(std::span<const Source> sources, Cancellation& cancellation) {
  constexpr std::uint64_t kWorkOnGrid = 8;
  const std::optional<Scale> scale = scale_of_stored([&](auto visit) {
    visit_in_pieces(sources, cancellation, [&](const Source& s) {
      visit(RegionAccess::x(*s.region, s.vertex));
      visit(RegionAccess::y(*s.region, s.vertex));
    });
  });
  // A difference has one bit more.
  if (scale && scale->bits < WideNumbers::kBits) {
    return {load_on_grid(sources, *scale, cancellation), kWorkOnGrid};
  }
  return load_homogeneous(sources, cancellation);
}

}  // namespace minksum::overlay
