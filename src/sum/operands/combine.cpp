// Combines two prepared operands in one set of arrays.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <numeric>

#include "sum/operands/operands.hpp"
#include "validation/rational_sites.hpp"

namespace minksum {
namespace {

/// Returns a power of ten that is off by less than 2^-43 of itself. std::pow brings tables, which
/// take 3 KB of the module for browsers.
double ten_to(int exponent) {
  double result = 1;
  double square = 10;
  for (int left = std::abs(exponent); left != 0; left /= 2, square *= square) {
    if (left % 2 != 0) result *= square;
  }
  return exponent < 0 ? 1 / result : result;
}

/// The grid that both operands share, and the factors that bring their coordinates to it.
struct CommonGrid {
  bool fits = false;  ///< whether fixed-width arithmetic holds the coordinates
  GridUnit unit;      ///< 1 if there is no common grid
  std::array<Int128, 2> factor{1, 1};
  int bits = 0;
};

CommonGrid common_grid(const PreparedOperand& p, const PreparedOperand& q,
                       const SumSettings& options) {
  CommonGrid common;
  if (p.rational || q.rational) return common;
  const std::int64_t common_part = std::gcd(p.grid.unit.divisor, q.grid.unit.divisor);
  const Int128 divisor = Int128{p.grid.unit.divisor} * (q.grid.unit.divisor / common_part);
  if (bit_width(divisor) > GridUnit::kDivisorBits) return common;
  common.unit = {std::min(p.grid.unit.exp2, q.grid.unit.exp2),
                 std::min(p.grid.unit.exp10, q.grid.unit.exp10),
                 static_cast<std::int64_t>(divisor)};
  if (options.arithmetic == Arithmetic::kArbitrary) return common;
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    const GridCoordinates& grid = i == 0 ? p.grid : q.grid;
    const int up2 = grid.unit.exp2 - common.unit.exp2;
    const int up10 = grid.unit.exp10 - common.unit.exp10;
    const std::int64_t times = common.unit.divisor / grid.unit.divisor;
    const int factor_bits =
        up2 + bits_of_ten_to(up10) + (times == 1 ? 0 : bit_width(Int128{times}));
    const int offset_bits = std::max(bit_width(grid.offset.x), bit_width(grid.offset.y));
    if (factor_bits + std::max(grid.bits, offset_bits) > kMaxGridBits) return common;
    common.factor[i] = scaled(Int128{times}, up2, up10);
    common.bits = std::max({common.bits, bit_width(grid.extent.x * common.factor[i]),
                            bit_width(grid.extent.y * common.factor[i])});
  }
  common.fits = true;
  return common;
}

void join_on_grid(const PreparedOperand& p, const PreparedOperand& q, const CommonGrid& common,
                  const SumSettings& options, Operands& o) {
  const GridPart parts[2] = {{&p.grid, common.factor[0], o.scratch.kept[0]},
                             {&q.grid, common.factor[1], o.scratch.kept[1]}};
  make_grid_kernel(rung_for(common.bits, options.arithmetic), parts, common.unit, o.kernel);
  o.bits = static_cast<std::uint64_t>(common.bits);
  o.bounds = RoundingBounds::of(std::ldexp(1.0, common.bits), common.bits <= kExactSumBits,
                                common.bits <= kExactProductBits);
  const auto extent = [](const GridCoordinates& grid, Int128 factor) {
    return Vec<double>{static_cast<double>(grid.extent.x * factor),
                       static_cast<double>(grid.extent.y * factor)};
  };
  o.extent = {extent(p.grid, common.factor[0]), extent(q.grid, common.factor[1])};
  o.trace_unit = std::ldexp(1.0, common.unit.exp2) / static_cast<double>(common.unit.divisor);
  if (common.unit.exp10 != 0) o.trace_unit *= ten_to(common.unit.exp10);
  const auto origin = [&](Int128 first, Int128 second) {
    return static_cast<double>(first * common.factor[0] + second * common.factor[1]) * o.trace_unit;
  };
  o.trace_origin = {origin(p.grid.offset.x, q.grid.offset.x),
                    origin(p.grid.offset.y, q.grid.offset.y)};
}

void join_rationals(const PreparedOperand& p, const PreparedOperand& q, const GridUnit& unit,
                    Cancellation& cancellation, Operands& o) {
  RationalCoordinates first = rationals_of(p, o.scratch.kept[0], unit, cancellation);
  RationalCoordinates second = rationals_of(q, o.scratch.kept[1], unit, cancellation);
  const Vec<Fraction> extents[2] = {first.extent, second.extent};
  const int exponent = rational_exponent(extents);
  std::move(second.sites.begin(), second.sites.end(), std::back_inserter(first.sites));
  o.bits = std::max(first.bits, second.bits);
  make_rational_kernel(std::move(first.sites), o.split, {first.low, second.low}, unit, o.bits,
                       exponent, cancellation, o.kernel);
  o.bounds = RoundingBounds::of_rationals(std::ldexp(1.0, kRationalExtentBits + 2));
  BigInteger step = 1;
  BigInteger divisor = unit.divisor;
  scale(step, divisor, unit.exp2, unit.exp10);
  const Fraction in_own_units(std::move(step), std::move(divisor));
  o.trace_unit = to_double(in_own_units, -exponent);
  o.trace_origin = {to_double((first.low.x + second.low.x) * in_own_units),
                    to_double((first.low.y + second.low.y) * in_own_units)};
}

void measure_extent(Operands& o) {
  o.extent = {};
  for (SiteId i = 0; i < o.sites.x.size(); ++i) {
    Vec<double>& extent = o.extent[static_cast<std::size_t>(o.operand_of(i))];
    extent = {std::max(extent.x, o.sites.x[i]), std::max(extent.y, o.sites.y[i])};
  }
}

/// Appends the values of the kept sites.
template <class Value>
void append_kept(const std::vector<Value>& from, std::span<const SiteId> kept,
                 std::vector<Value>& to) {
  if (kept.size() == from.size()) {
    to.insert(to.end(), from.begin(), from.end());
    return;
  }
  for (const SiteId site : kept) to.push_back(from[site]);
}

Vec<double> size_of(const PreparedOperand& operand, const OperandRing& ring) {
  const BoxOf<double> box = box_of(operand.sites, ring);
  return {box.x1 - box.x0, box.y1 - box.y0};
}

/// Decides which holes of one operand are filled: those into which no polygon of the other fits.
class HoleFiller {
 public:
  HoleFiller(const PreparedOperand& operand, const PreparedOperand& other, bool tight_wanted,
             std::vector<Vec<double>>& sizes)
      : operand_(operand), sizes_(sizes), tight_wanted_(tight_wanted) {
    const double unit = std::ldexp(1.0, other.unit.exp2 - operand.unit.exp2) *
                        ten_to(other.unit.exp10 - operand.unit.exp10) *
                        static_cast<double>(operand.unit.divisor) /
                        static_cast<double>(other.unit.divisor);
    // A hole is open and the other operand is closed, so a polygon as wide as the hole does not
    // fit. Where rounding leaves a doubt the hole stays, which costs nothing but time.
    const bool exact = operand.unit == other.unit && operand.bounds.difference == 0 &&
                       other.bounds.difference == 0;
    larger_ = exact ? 1 : 1 + 0x1p-40;
    doubt_ = exact ? 0 : 2 * (operand.bounds.difference + other.bounds.difference * unit);
    sizes_.clear();
    tells_ = unit > 0x1p-900 && unit < 0x1p900 &&
             !(tight_wanted && (operand.region->polygon_count() > 1 || has_holes(other.rings)));
    if (!tells_) return;
    for (const OperandRing& ring : other.rings) {
      if (ring.is_hole()) continue;
      const Vec<double> size = size_of(other, ring);
      sizes_.push_back({size.x * unit, size.y * unit});
    }
  }
  /// Returns the units of work of `fills`.
  [[nodiscard]] std::uint64_t work(const OperandRing& ring) const {
    return ring.is_hole() ? sizes_.size() : 0;
  }
  [[nodiscard]] bool fills(const OperandRing& ring) const {
    if (!ring.is_hole() || !tells_) return false;
    const Vec<double> hole = size_of(operand_, ring);
    return std::all_of(sizes_.begin(), sizes_.end(), [&](const Vec<double>& other) {
      return wider(other.x, hole.x) || wider(other.y, hole.y);
    });
  }

 private:
  [[nodiscard]] bool wider(double other, double hole) const {
    const double bound = hole * larger_ + doubt_;
    return tight_wanted_ ? other > bound : other >= bound;
  }

  const PreparedOperand& operand_;
  std::vector<Vec<double>>& sizes_;
  bool tight_wanted_;
  double larger_ = 1;
  double doubt_ = 0;
  bool tells_ = true;
};

}  // namespace

void fill_holes(const PreparedOperand& p, const PreparedOperand& q, NarrowHoles narrow,
                bool tight_wanted, Cancellation& cancellation, Operands& o) {
  auto& renumbered = o.scratch.renumbered;
  o.rings.clear();
  renumbered.clear();
  bool all_stay = true;
  SiteId count = 0;
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    const PreparedOperand& operand = i == 0 ? p : q;
    auto& kept = o.scratch.kept[i];
    kept.clear();
    std::optional<HoleFiller> filler;
    if (narrow == NarrowHoles::kFill && has_holes(operand.rings)) {
      filler.emplace(operand, i == 0 ? q : p, tight_wanted, o.scratch.sizes[i]);
    }
    for (const OperandRing& ring : operand.rings) {
      cancellation.check(ring.end - ring.begin);
      if (filler) cancellation.check(filler->work(ring));
      if (filler && filler->fills(ring)) {
        all_stay = false;
        continue;
      }
      const SiteId size = ring.end - ring.begin;
      o.rings.push_back({count, count + size, ring.polygon, ring.ring});
      kept.resize(kept.size() + size);
      std::iota(kept.end() - size, kept.end(), ring.begin);
      count += size;
    }
    if (i == 0) {
      o.split = count;
      o.first_rings = o.rings.size();
    }
  }
  o.holes_filled = !all_stay;
  if (all_stay) return;
  renumbered.assign(p.size() + q.size(), kNoSite);
  SiteId id = 0;
  for (const SiteId site : o.scratch.kept[0]) renumbered[site] = id++;
  for (const SiteId site : o.scratch.kept[1]) renumbered[site + p.size()] = id++;
}

void join_sites(const PreparedOperand& p, const PreparedOperand& q, const SumSettings& options,
                Cancellation& cancellation, Operands& o) {
  const CommonGrid common = common_grid(p, q, options);
  if (common.fits) {
    join_on_grid(p, q, common, options, o);
  } else {
    join_rationals(p, q, common.unit, cancellation, o);
  }
  if (!options.filter) o.bounds = RoundingBounds::distrustful(o.bounds.magnitude);
  const std::size_t n = o.scratch.kept[0].size() + o.scratch.kept[1].size();
  o.sites.x.resize(n);
  o.sites.y.resize(n);
  o.kernel->approximate_sites(o.sites.x, o.sites.y, cancellation);
  if (!common.fits) measure_extent(o);
  o.on_hole.assign(n, 0);
  for (const OperandRing& ring : o.rings) {
    if (ring.is_hole()) std::fill_n(o.on_hole.begin() + ring.begin, ring.end - ring.begin, 1);
  }
  connect_rings(o.rings, *o.kernel, cancellation, o.sites, o.previous);
}

void combine_operands(const PreparedOperand& p, const PreparedOperand& q,
                      const SumSettings& options, NarrowHoles narrow, Cancellation& cancellation,
                      Operands& o) {
  fill_holes(p, q, narrow, options.tight.value_or(false), cancellation, o);
  join_sites(p, q, options, cancellation, o);
  o.convex.clear();
  o.vertex_source.clear();
  o.edge_source.clear();
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    const PreparedOperand& operand = i == 0 ? p : q;
    const auto& kept = o.scratch.kept[i];
    append_kept(operand.convex, kept, o.convex);
    append_kept(operand.vertex_source, kept, o.vertex_source);
    append_kept(operand.edge_source, kept, o.edge_source);
  }
  rank_directions(p, q, cancellation, o);
  o.thin = {p.thin, q.thin};
  // The region of a sum of polylines may be in several parts, connected by segments without area.
  o.connected = p.region->polygon_count() == 1 && q.region->polygon_count() == 1 && !o.both_thin();
  o.equal = !p.rational && !q.rational && p.rings == q.rings &&
            o.scratch.kept[0] == o.scratch.kept[1] && p.grid.unit == q.grid.unit &&
            p.grid.small_sites == q.grid.small_sites && p.grid.large_sites == q.grid.large_sites;
  o.both_convex =
      o.rings.size() == 2 && std::find(o.convex.begin(), o.convex.end(), 0) == o.convex.end();
}

}  // namespace minksum
