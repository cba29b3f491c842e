#include "predicate/exact_kernel.hpp"

#include "predicate/kernel_of.hpp"

namespace minksum {
namespace {

template <std::size_t N>
void set_limbs(const WideInt<N>& magnitude, std::vector<std::uint64_t>& out) {
  std::size_t count = N;
  while (count > 0 && magnitude.limb(count - 1) == 0) --count;
  out.clear();
  for (std::size_t i = 0; i < count; ++i) out.push_back(magnitude.limb(i));
}

void set_limbs(const BigInteger& magnitude, std::vector<std::uint64_t>& out) {
  out.clear();
  if (magnitude == 0) return;
  boost::multiprecision::export_bits(magnitude, std::back_inserter(out), 64, false);
}

/// Integer coordinates on a common grid.
template <class Rung>
class GridKernel final : public KernelOf<Rung> {
  using Base = KernelOf<Rung>;
  using typename Base::Coord;
  using typename Base::Lexicographic;

 public:
  void load(const GridCoordinates& grid) {
    this->sites_.clear();
    for (const auto& site : grid.sites) {
      this->sites_.push_back({static_cast<Coord>(site.x), static_cast<Coord>(site.y)});
    }
    this->next_.clear();
    offset_ = grid.offset;
    exp2_ = grid.exp2;
    exp10_ = grid.exp10;
  }

  Arithmetic rung() const override {
    if constexpr (std::is_same_v<Rung, NarrowRung>) return Arithmetic::kNarrow;
    if constexpr (std::is_same_v<Rung, MediumRung>) return Arithmetic::kMedium;
    return Arithmetic::kWide;
  }
  void coordinate(const NodePoint& node, Axis axis, ExactCoordinate& out) const override {
    const auto h = this->homogeneous(node, axis);
    const Lexicographic moved =
        h.numerator + Lexicographic(Base::along(offset_, axis)) * h.denominator;
    out.negative = moved.negative() != h.denominator.negative() && sign_of(moved) != kZero;
    set_limbs(moved.magnitude(), out.numerator);
    set_limbs(h.denominator.magnitude(), out.denominator);
  }
  int exp2() const override { return exp2_; }
  int exp10() const override { return exp10_; }
  Vec<double> approximate(SiteId site) const override {
    return {to_double(this->sites_[site].x), to_double(this->sites_[site].y)};
  }
  Vec<double> approximate_difference(SiteId from, SiteId to) const override {
    const auto d = this->difference(from, to);
    return {to_double(d.x), to_double(d.y)};
  }

 private:
  Vec<Int128> offset_{};
  int exp2_ = 0;
  int exp10_ = 0;
};

/// Rational coordinates, in the operands' own units.
class RationalKernel final : public KernelOf<ArbitraryRung> {
 public:
  void load(std::vector<Vec<BigRational>> sites, SiteId split, const Vec<BigRational>& first,
            const Vec<BigRational>& second, int exponent) {
    sites_ = std::move(sites);
    next_.clear();
    split_ = split;
    origin_ = {first, second};
    exponent_ = exponent;
  }
  Arithmetic rung() const override { return Arithmetic::kArbitrary; }
  void coordinate(const NodePoint& node, Axis axis, ExactCoordinate& out) const override {
    const auto h = homogeneous(node, axis);
    const BigRational value = h.numerator / h.denominator;
    const BigInteger numerator(boost::multiprecision::numerator(value));
    const BigInteger denominator(boost::multiprecision::denominator(value));
    out.negative = numerator < 0;
    set_limbs(BigInteger(abs(numerator)), out.numerator);
    set_limbs(denominator, out.denominator);
  }
  int exp2() const override { return 0; }
  int exp10() const override { return 0; }
  Vec<double> approximate(SiteId site) const override {
    const auto& origin = origin_[site < split_ ? 0 : 1];
    return scaled(minus(sites_[site], origin));
  }
  Vec<double> approximate_difference(SiteId from, SiteId to) const override {
    return scaled(difference(from, to));
  }
  void arrange(std::span<const SiteId> order, std::span<const SiteId> next) override {
    SiteId split = 0;
    for (const SiteId site : order) split += site < split_ ? 1 : 0;
    KernelOf<ArbitraryRung>::arrange(order, next);
    split_ = split;
  }

 private:
  [[nodiscard]] Vec<double> scaled(const Vec<BigRational>& v) const {
    return {scaled(v.x), scaled(v.y)};
  }
  [[nodiscard]] double scaled(const BigRational& value) const {
    const BigInteger shift = BigInteger(1) << static_cast<unsigned>(std::abs(exponent_));
    return to_double(exponent_ >= 0 ? BigRational(value * BigRational(shift))
                                    : BigRational(value / BigRational(shift)));
  }
  SiteId split_ = 0;
  std::array<Vec<BigRational>, 2> origin_;
  int exponent_ = 0;
};

template <class Kernel>
Kernel& reuse_or_make(std::unique_ptr<ExactKernel>& old) {
  if (dynamic_cast<Kernel*>(old.get()) == nullptr) old = std::make_unique<Kernel>();
  return static_cast<Kernel&>(*old);
}

}  // namespace

void make_grid_kernel(Arithmetic rung, const GridCoordinates& grid,
                      std::unique_ptr<ExactKernel>& old) {
  switch (rung) {
    case Arithmetic::kNarrow:
      return reuse_or_make<GridKernel<NarrowRung>>(old).load(grid);
    case Arithmetic::kMedium:
      return reuse_or_make<GridKernel<MediumRung>>(old).load(grid);
    default:
      return reuse_or_make<GridKernel<WideRung>>(old).load(grid);
  }
}

void make_rational_kernel(std::vector<Vec<BigRational>> sites, SiteId split,
                          const Vec<BigRational>& origin_first,
                          const Vec<BigRational>& origin_second, int exponent,
                          std::unique_ptr<ExactKernel>& old) {
  reuse_or_make<RationalKernel>(old).load(std::move(sites), split, origin_first, origin_second,
                                          exponent);
}

}  // namespace minksum
