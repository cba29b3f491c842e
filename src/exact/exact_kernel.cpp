#include "exact/exact_kernel.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "exact/kernel_of.hpp"
#include "exact/near_kernel.hpp"

namespace minksum {
namespace {

template <std::size_t N>
void set_limbs(const WideInt<N>& magnitude, std::vector<std::uint64_t>& out) {
  out.assign(magnitude.limbs().begin(), magnitude.limbs().end());
  while (!out.empty() && out.back() == 0) out.pop_back();
}

void set_limbs(const BigInteger& value, std::vector<std::uint64_t>& out) {
  out.clear();
  append_limbs(value, out);
}

/// Decides with integer coordinates on a common grid.
template <class Rung>
class GridKernel final : public KernelOf<Rung> {
  using Base = KernelOf<Rung>;
  using typename Base::Coord;
  using typename Base::Lexicographic;

 public:
  void load(std::span<const GridPart> parts, const GridUnit& unit) {
    this->sites_.clear();
    offset_ = {0, 0};
    for (const GridPart& part : parts) {
      if (part.grid->small) {
        append(part.grid->small_sites, part);
      } else {
        append(part.grid->large_sites, part);
      }
      offset_ = {offset_.x + part.grid->offset.x * part.factor,
                 offset_.y + part.grid->offset.y * part.factor};
    }
    this->next_.clear();
    unit_ = unit;
  }

  Arithmetic rung() const override {
    if constexpr (std::is_same_v<Rung, NarrowRung>) return Arithmetic::kNarrow;
    if constexpr (std::is_same_v<Rung, MediumRung>) return Arithmetic::kMedium;
    return Arithmetic::kWide;
  }
  std::uint64_t work() const override { return 8; }
  void coordinates(const NodePoint& node, Vec<ExactCoordinate>& out) const override {
    if (!node.is_crossing) {
      const auto at = this->position(node.vertex);
      set(at.x + offset_.x, out.x);
      set(at.y + offset_.y, out.y);
      return;
    }
    const auto t = this->crossing_of(node.first, node.second);
    const auto at = this->start(node.first);
    const auto d = this->direction(node.first.edge);
    const auto coordinate = [&](const Int128& from, const Coord& along) {
      return product<Lexicographic>(from, t.denominator) +
             product<Lexicographic>(along, t.numerator);
    };
    set(coordinate(at.x + offset_.x, d.x), as_limbs(t.denominator), out.x);
    set(coordinate(at.y + offset_.y, d.y), as_limbs(t.denominator), out.y);
  }
  bool integer_coordinates(const SumVertex& v, Vec<std::int64_t>& out) const override {
    const auto at = this->position(v);
    const Int128 x = at.x + offset_.x;
    const Int128 y = at.y + offset_.y;
    out = {static_cast<std::int64_t>(x), static_cast<std::int64_t>(y)};
    return unit_.divisor == 1 && out.x == x && out.y == y &&
           out.x != std::numeric_limits<std::int64_t>::min() &&
           out.y != std::numeric_limits<std::int64_t>::min();
  }
  int exp2() const override { return unit_.exp2; }
  int exp10() const override { return unit_.exp10; }
  Vec<double> between(const SumVertex& a, const SumVertex& b) const override {
    const auto difference = this->minus(this->position(b), this->position(a));
    return {to_double(difference.x), to_double(difference.y)};
  }
  void approximate_sites(std::span<double> x, std::span<double> y,
                         Cancellation& cancellation) const override {
    cancellation.check(x.size() / 4);
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] = to_double(this->sites_[i].x);
      y[i] = to_double(this->sites_[i].y);
    }
  }
  void approximate_edges(std::span<double> dx, std::span<double> dy,
                         Cancellation& cancellation) const override {
    cancellation.check(dx.size() / 4);
    for (std::size_t i = 0; i < dx.size(); ++i) {
      const auto d = this->direction(static_cast<SiteId>(i));
      dx[i] = to_double(d.x);
      dy[i] = to_double(d.y);
    }
  }

 private:
  template <class Number>
  void append(const std::vector<Vec<Number>>& sites, const GridPart& part) {
    const auto factor = static_cast<Coord>(part.factor);
    const std::size_t size = this->sites_.size();
    this->sites_.resize(size + part.sites.size());
    auto to = this->sites_.begin() + static_cast<std::ptrdiff_t>(size);
    for (const SiteId site : part.sites) {
      *to++ = {static_cast<Coord>(static_cast<Coord>(sites[site].x) * factor),
               static_cast<Coord>(static_cast<Coord>(sites[site].y) * factor)};
    }
  }

  template <std::size_t N>
  void set(const Lexicographic& numerator, const WideInt<N>& denominator,
           ExactCoordinate& out) const {
    out.negative = numerator.negative() != denominator.negative() && sign_of(numerator) != kZero;
    set_limbs(numerator.magnitude(), out.numerator);
    if (unit_.divisor == 1) return set_limbs(denominator.magnitude(), out.denominator);
    set_limbs(product<Lexicographic>(denominator, unit_.divisor).magnitude(), out.denominator);
  }

  /// Sets a value in lowest terms, but for the powers in the unit.
  void set(const Int128& value, ExactCoordinate& out) const {
    const std::int64_t common =
        unit_.divisor == 1
            ? 1
            : std::gcd(static_cast<std::int64_t>(value % unit_.divisor), unit_.divisor);
    const WideInt<2> wide(common == 1 ? value : value / common);
    out.negative = wide.negative();
    set_limbs(wide.magnitude(), out.numerator);
    out.denominator.assign(1, static_cast<std::uint64_t>(unit_.divisor / common));
  }

  Vec<Int128> offset_{};
  GridUnit unit_;
};

/// Decides with rational coordinates.
class RationalKernel final : public KernelOf<ArbitraryRung> {
 public:
  void load(std::vector<Vec<Fraction>> sites, SiteId split,
            const std::array<Vec<Fraction>, 2>& origins, const GridUnit& unit, std::size_t bits,
            int exponent, Cancellation& cancellation) {
    sites_ = std::move(sites);
    next_.clear();
    unit_ = unit;
    integers_ = std::all_of(sites_.begin(), sites_.end(), [](const Vec<Fraction>& site) {
      return site.x.is_integer() && site.y.is_integer();
    });
    work_ = work_of_decision(bits);
    exponent_ = exponent;
    near_.load(sites_, split, origins, work_, cancellation);
  }
  void connect(std::span<const SiteId> next) override {
    KernelOf::connect(next);
    near_.connect(next);
  }

  using KernelOf::compare;
  using KernelOf::orientation;
  Sign orientation(const Segment& s, const SumVertex& v) const override {
    return or_exactly(near_.orientation(s, v), [&] { return KernelOf::orientation(s, v); });
  }
  Sign orientation(const Segment& s, const NodePoint& node) const override {
    return or_exactly(near_.orientation(s, node), [&] { return KernelOf::orientation(s, node); });
  }
  Sign compare(const SumVertex& a, const SumVertex& b, Axis axis) const override {
    return or_exactly(near_.compare(a, b, axis), [&] { return KernelOf::compare(a, b, axis); });
  }
  Sign compare(const NodePoint& a, const NodePoint& b, Axis axis) const override {
    return or_exactly(near_.compare(a, b, axis), [&] { return KernelOf::compare(a, b, axis); });
  }
  Sign compare_along(const Segment& s, const PointOnSegment& a,
                     const PointOnSegment& b) const override {
    return or_exactly(near_.compare_along(s, a, b),
                      [&] { return KernelOf::compare_along(s, a, b); });
  }
  double parameter(const Segment& s, const PointOnSegment& point) const override {
    return or_exactly(near_.parameter(s, point), [&] { return KernelOf::parameter(s, point); });
  }

  Arithmetic rung() const override { return Arithmetic::kArbitrary; }
  std::uint64_t work() const override { return work_; }
  void coordinates(const NodePoint& node, Vec<ExactCoordinate>& out) const override {
    const Vec<Fraction> at = exact_point(node);
    set(at.x, out.x);
    set(at.y, out.y);
  }
  bool integer_coordinates(const SumVertex&, Vec<std::int64_t>&) const override { return false; }
  int exp2() const override { return unit_.exp2; }
  int exp10() const override { return unit_.exp10; }
  Vec<double> between(const SumVertex& a, const SumVertex& b) const override {
    const Vec<Fraction> difference = minus(position(b), position(a));
    return {to_double(difference.x, exponent_), to_double(difference.y, exponent_)};
  }
  void approximate_sites(std::span<double> x, std::span<double> y,
                         Cancellation& cancellation) const override {
    cancellation.check(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Vec<double> at = near_.position(static_cast<SiteId>(i), exponent_);
      x[i] = at.x;
      y[i] = at.y;
    }
  }
  void approximate_edges(std::span<double> dx, std::span<double> dy,
                         Cancellation& cancellation) const override {
    for (std::size_t i = 0; i < dx.size(); ++i) {
      cancellation.check(work_);
      const Vec<Fraction> d = direction(static_cast<SiteId>(i));
      dx[i] = scaled(d.x);
      dy[i] = scaled(d.y);
    }
  }

 private:
  template <class Answer, class Exact>
  static Answer or_exactly(const std::optional<Answer>& near, Exact exact) {
    return near ? *near : exact();
  }
  void set(const Fraction& at, ExactCoordinate& out) const {
    Fraction value = unit_.divisor == 1 ? at : at / Fraction(BigInteger(unit_.divisor));
    if (!integers_) value = value.reduced();
    out.negative = value.numerator().sign() < 0;
    set_limbs(value.numerator(), out.numerator);
    set_limbs(value.denominator(), out.denominator);
  }
  [[nodiscard]] double scaled(const Fraction& value) const {
    const double nearest = to_double(value, exponent_);
    if (nearest != 0) return nearest;
    return static_cast<double>(sign_of(value)) * std::numeric_limits<double>::denorm_min();
  }
  GridUnit unit_;
  bool integers_ = false;  ///< whether all sites are integers
  std::uint64_t work_ = 0;
  int exponent_ = 0;
  NearKernel near_;
};

template <class Kernel>
Kernel& reuse_or_make(std::unique_ptr<ExactKernel>& old) {
  if (dynamic_cast<Kernel*>(old.get()) == nullptr) old = std::make_unique<Kernel>();
  return static_cast<Kernel&>(*old);
}

}  // namespace

void make_grid_kernel(Arithmetic rung, std::span<const GridPart> parts, const GridUnit& unit,
                      std::unique_ptr<ExactKernel>& old) {
  switch (rung) {
    case Arithmetic::kNarrow:
      return reuse_or_make<GridKernel<NarrowRung>>(old).load(parts, unit);
    case Arithmetic::kMedium:
      return reuse_or_make<GridKernel<MediumRung>>(old).load(parts, unit);
    default:
      return reuse_or_make<GridKernel<WideRung>>(old).load(parts, unit);
  }
}

void make_rational_kernel(std::vector<Vec<Fraction>> sites, SiteId split,
                          const std::array<Vec<Fraction>, 2>& origins, const GridUnit& unit,
                          std::size_t bits, int exponent, Cancellation& cancellation,
                          std::unique_ptr<ExactKernel>& old) {
  reuse_or_make<RationalKernel>(old).load(std::move(sites), split, origins, unit, bits, exponent,
                                          cancellation);
}

}  // namespace minksum
