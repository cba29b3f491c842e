// Cross products in lanes of doubles, whose signs are exact.
#pragma once

#include <cmath>
#include <type_traits>
#include <utility>

#include "exact/sign.hpp"
#include "sum/small/lanes.hpp"
#include "sum/small/small_vectors.hpp"

namespace minksum {

/// On which sides of each other's line two segments r and t have their ends.
struct Sides {
  double start;  ///< positive if t starts on the left of r
  double end;    ///< positive if t ends on the left of r
  double along;  ///< positive if r starts on the left of t
  double left;   ///< negative if r ends on the left of t
};
/// Which of these are known to be zero, because ends are the same.
struct ZeroSides {
  bool start = false;
  bool end = false;
  bool along = false;
  bool left = false;
};

/// Cross products of vectors whose products doubles hold, and their sums.
struct ExactLanes {
  static constexpr bool kHoldsSums = true;
  static constexpr bool kRoundsPoints = false;
  template <class Row>
  [[nodiscard, gnu::always_inline]] Vec<double> get(const Row& row, std::size_t i) const {
    return row[i];
  }
  /// Positive if a point, seen from the start of an edge, is on its left. The point is a difference
  /// of two points of the sum, or that moved by an edge. `is_zero` says that the caller knows the
  /// result to be zero.
  [[nodiscard, gnu::always_inline]] double side(const Vec<double>& edge, const Vec<double>& point,
                                                bool /*is_zero*/ = false) const {
    return cross(edge, point);
  }
  /// Positive if an edge turns left into another one.
  [[nodiscard, gnu::always_inline]] double turn(const Vec<double>& in,
                                                const Vec<double>& out) const {
    return cross(in, out);
  }
};

/// Cross products of integers up to 2^49 in doubles that round them. Rounding keeps the order of
/// two products, so the sign of a value that is not zero is exact. Zero is sure if the products are
/// zero. It is also sure if x of both vectors is the same but for the sign, as where one segment
/// starts at the end of the other: a product that changes with y changes by x at least, and
/// rounding changes it by less than x / 8. A value that is unsure is below 2^48.
struct RoundedLanes {
  static constexpr bool kHoldsSums = false;
  static constexpr bool kRoundsPoints = false;
  bool& unsure;
  template <class Row>
  [[nodiscard, gnu::always_inline]] Vec<double> get(const Row& row, std::size_t i) const {
    return row[i];
  }
  [[nodiscard, gnu::always_inline]] double side(const Vec<double>& edge, const Vec<double>& point,
                                                bool /*is_zero*/ = false) const {
    const double above = edge.x * point.y;
    const double value = above - edge.y * point.x;
    unsure |= (value == 0) & (above != 0) & (std::abs(edge.x) != std::abs(point.x));
    return value;
  }
  [[nodiscard, gnu::always_inline]] double turn(const Vec<double>& in,
                                                const Vec<double>& out) const {
    return side(in, out);
  }
};

/// Cross products of rounded vectors. Edges of length zero are not rounded, so zero is sure for
/// these.
struct BoundedLanes {
  static constexpr bool kHoldsSums = false;
  static constexpr bool kRoundsPoints = true;
  bool& unsure;
  double reach;
  template <class Row>
  [[nodiscard, gnu::always_inline]] Vec<double> get(const Row& row, std::size_t i) const {
    return row[i];
  }
  [[nodiscard, gnu::always_inline]] double side(const Vec<double>& edge, const Vec<double>& point,
                                                bool is_zero = false) const {
    return decide(cross(edge, point), error_of(edge), is_zero);
  }
  /// If one segment surely lies on one side of the other's line, the segments do not meet. Then the
  /// other two values need not be sure.
  [[nodiscard, gnu::always_inline]] Sides sides(const Vec<double>& r, const Vec<double>& a,
                                                const Vec<double>& t,
                                                const ZeroSides& zeros) const {
    bool unsure_of_r = false;
    bool unsure_of_t = false;
    const BoundedLanes of_r{unsure_of_r, reach};
    const BoundedLanes of_t{unsure_of_t, reach};
    const double turn = cross(r, t);
    const double start = of_r.decide(cross(r, a), error_of(r), zeros.start);
    const double end = of_r.decide(cross(r, a) + turn, error_of(r), zeros.end);
    const double along = of_t.decide(cross(a, t), error_of(t), zeros.along);
    const double left = of_t.decide(turn - cross(a, t), error_of(t), zeros.left);
    unsure |= (unsure_of_r & unsure_of_t) | (unsure_of_r & !(along * left < 0)) |
              (unsure_of_t & !(start * end > 0));
    return {start, end, along, left};
  }
  [[nodiscard, gnu::always_inline]] double turn(const Vec<double>& in,
                                                const Vec<double>& out) const {
    const double above = in.x * out.y;
    const double other = in.y * out.x;
    // Each edge is off by up to four times 2^-53, and their product and the difference are rounded.
    return decide(above - other, 0x1p-49 * (std::abs(above) + std::abs(other)), false);
  }

 private:
  [[nodiscard, gnu::always_inline]] double error_of(const Vec<double>& edge) const {
    return reach * (std::abs(edge.x) + std::abs(edge.y));
  }
  [[nodiscard, gnu::always_inline]] double decide(double value, double error, bool is_zero) const {
    const double scale = is_zero ? 0.0 : 1.0;  // keeps the loop over lanes free of branches
    unsure |= std::abs(scale * value) < scale * error;
    return scale * value;
  }
};

template <class Number>
[[nodiscard, gnu::always_inline]] inline auto filter_lanes(
    [[maybe_unused]] const SmallNumbers<Number>& numbers, bool& unsure) {
  if constexpr (std::is_same_v<Number, std::uint64_t>) {
    return RoundedLanes{unsure};
  } else {
    return BoundedLanes{unsure, numbers.reach};
  }
}

/// Cross products whose signs are exact. Int128 may be used if `fit_int128`.
template <class Number>
struct SureLanes {
  static constexpr bool kHoldsSums = false;
  static constexpr bool kRoundsPoints = false;
  SmallNumbers<Number> numbers;
  template <class Row>
  [[nodiscard, gnu::always_inline]] SureVec<Number> get(const Row& row, std::size_t i) const {
    if constexpr (std::is_same_v<Number, std::uint64_t>) {
      return of_whole(row[i]);
    } else {
      return {row[i], row.template exact<Number>(i)};
    }
  }
  /// Returns a vector of integers that doubles hold.
  [[nodiscard, gnu::always_inline]] static SureVec<Number> of_whole(const Vec<double>& v) {
    const auto whole = [](double value) {
      return static_cast<Number>(static_cast<std::int64_t>(value));
    };
    return {v, {whole(v.x), whole(v.y)}};
  }
  [[nodiscard, gnu::always_inline]] double side(const SureVec<Number>& edge,
                                                const SureVec<Number>& point,
                                                bool is_zero = false) const {
    bool unsure = false;
    const double value = filter_lanes(numbers, unsure).side(edge.near, point.near, is_zero);
    return unsure ? sign_of_cross(edge.exact, point.exact) : value;
  }
  [[nodiscard, gnu::always_inline]] double turn(const SureVec<Number>& in,
                                                const SureVec<Number>& out) const {
    bool unsure = false;
    const double value = filter_lanes(numbers, unsure).turn(in.near, out.near);
    return unsure ? sign_of_cross(in.exact, out.exact) : value;
  }

 private:
  /// Returns the sign of a cross product that doubles do not tell. A short one is computed in line.
  /// The call took some 70 ns where the caller is compiled for AVX-512: a sum with many edges on
  /// common lines took 7.4 times as long.
  [[nodiscard, gnu::always_inline]] double sign_of_cross(const Vec<Number>& a,
                                                         const Vec<Number>& b) const {
    if constexpr (std::is_same_v<Number, std::uint64_t>) {
      return sign_of(static_cast<std::int64_t>(cross(a, b)));
    } else {
      return sign_of_long_cross(a, b);
    }
  }
  [[nodiscard, gnu::noinline]] double sign_of_long_cross(const Vec<Number>& a,
                                                         const Vec<Number>& b) const {
    if constexpr (std::is_same_v<Number, Int128>) {
      // Up to a width of 2^84, it is less than 2^125.
      if (numbers.reach <= 0x1p36) {
        const auto wrapped = [](Int128 p, Int128 q) {
          return static_cast<Uint128>(p) * static_cast<Uint128>(q);
        };
        return sign_of(static_cast<Int128>(wrapped(a.x, b.y) - wrapped(a.y, b.x)));
      }
    }
    return sign_of(exact_cross<ProductOf<Number>>(a, b));
  }
};

template <class Number>
[[nodiscard, gnu::always_inline]] inline auto sure_lanes(
    [[maybe_unused]] const SmallNumbers<Number>& numbers) {
  if constexpr (std::is_same_v<Number, double>) {
    return ExactLanes{};
  } else {
    return SureLanes<Number>{numbers};
  }
}
/// Returns compute(lanes), by the shortest integers that hold all coordinates.
template <class Number, class Compute>
[[nodiscard, gnu::always_inline]] inline auto compute_surely(const SmallNumbers<Number>& numbers,
                                                             const Compute& compute) {
  if constexpr (std::is_same_v<Number, WideNumber>) {
    if (numbers.fit_int128()) return compute(SureLanes<Int128>{{numbers.reach}});
  }
  return compute(sure_lanes(numbers));
}

/// The same out of line, where it is rare.
template <class Number, class Compute>
[[nodiscard, gnu::noinline]] double decide_exactly(const SmallNumbers<Number>& numbers,
                                                   const Compute& compute) {
  return compute_surely(numbers, compute);
}
/// Returns compute(lanes), whose sign is right, where `lanes` reads vectors and computes cross
/// products.
template <class Number, class Compute>
[[nodiscard, gnu::always_inline]] inline double decide(const SmallNumbers<Number>& numbers,
                                                       const Compute& compute) {
  if constexpr (std::is_same_v<Number, double>) {
    return compute(ExactLanes{});
  } else {
    bool unsure = false;
    const double value = compute(filter_lanes(numbers, unsure));
    return unsure ? decide_exactly(numbers, compute) : value;
  }
}

/// Returns the bits of those t from 0 to count - 1 for which test(lanes, t) is true: it returns
/// kBitOf[t] or 0. `lanes` reads vectors and computes cross products. What it does not tell for
/// sure is tested again. Only the bits of `wanted` lanes must be right.
template <class Number, class Test>
[[gnu::always_inline]] inline LaneBits test_lanes(const SmallNumbers<Number>& numbers,
                                                  std::size_t count,
                                                  [[maybe_unused]] LaneBits wanted, Test test) {
  LaneBits bits = 0;
  if constexpr (std::is_same_v<Number, double>) {
    for (std::size_t t = 0; t < count; ++t) bits |= test(ExactLanes{}, t);
    return bits;
  } else {
    LaneBits unsure = 0;
    for (std::size_t t = 0; t < count; ++t) {
      bool is_unsure = false;
      bits |= test(filter_lanes(numbers, is_unsure), t);
      unsure |= is_unsure ? kBitOf[t] : 0;
    }
    LaneBits sure = bits;  // apart, so that `bits` stays in a register
    for_each_bit(unsure & wanted, [&](std::uint32_t t) {
      const auto test_again = [&](const auto& lanes) __attribute__((always_inline)) {
        return test(lanes, t);
      };
      sure = (sure & ~kBitOf[t]) | compute_surely(numbers, test_again);
    });
    return sure;
  }
}

/// Which pairs of a row and a lane are of each kind. Bit 8 t + r stands for row r and lane t.
template <std::size_t kKinds>
struct PairBits {
  std::array<LaneBits, kKinds> kinds;
  std::size_t exact = 0;  ///< how many pairs doubles did not decide
};
/// Tests eight lanes for each of `rows`, as far as `pairs` are wanted: bit 8 r + t. By
/// test(lanes, r, t), bit 8 k tells whether a pair is of kind k. `lanes` reads vectors and computes
/// cross products. What it does not tell for sure is tested again.
template <std::size_t kKinds, class Number, class Test>
[[gnu::always_inline]] inline PairBits<kKinds> test_rows(const SmallNumbers<Number>& numbers,
                                                         LaneBits rows, LaneBits pairs, Test test) {
  // A lane has a byte for each kind, and one for what is not sure, with a bit for each row. So
  // lanes are united once for all rows. Uniting them takes as long as testing a row.
  alignas(64) std::array<LaneBits, kLanes> found{};
  for_each_bit(
      rows, [&](std::uint32_t row) __attribute__((always_inline)) {
        for (std::size_t t = 0; t < kLanes; ++t) {
          if constexpr (std::is_same_v<Number, double>) {
            found[t] |= test(ExactLanes{}, row, t) << row;
          } else {
            bool is_unsure = false;
            const LaneBits bits = test(filter_lanes(numbers, is_unsure), row, t);
            found[t] |= (bits | (is_unsure ? LaneBits{1} << (kKinds * kLanes) : 0)) << row;
          }
        }
      });
  std::array<LaneBits, kKinds + 1> united{};
  const auto unite = [&]<std::size_t... k>(std::index_sequence<k...>)
      __attribute__((always_inline)) {
#pragma GCC unroll 1  // unrolled, it would be no vector code
    for (std::size_t t = 0; t < kLanes; ++t) {
      ((united[k] |= (found[t] >> (k * kLanes) & 0xFF) << kByteOf[t]), ...);
    }
  };
  unite(std::make_index_sequence<kKinds + 1>{});
  pairs = transposed(pairs);
  PairBits<kKinds> result;
  for (std::size_t k = 0; k < kKinds; ++k) result.kinds[k] = united[k] & pairs;
  if constexpr (!std::is_same_v<Number, double>) {
    for_each_bit(united[kKinds] & pairs, [&](std::uint32_t bit) {
      const LaneBits sure = compute_surely(
          numbers, [&](const auto& lanes) __attribute__((always_inline)) {
            return test(lanes, bit % kLanes, bit / kLanes);
          });
      for (std::size_t k = 0; k < kKinds; ++k) {
        result.kinds[k] = (result.kinds[k] & ~kBitOf[bit]) | (sure >> (k * kLanes) & 1) << bit;
      }
      ++result.exact;
    });
  }
  return result;
}

/// Whether the boxes of two edges meet, or are at most half of `slack` apart. The first edge has
/// this way, and sees the start of the other one, t, at `a`.
template <class Number>
[[nodiscard, gnu::always_inline]] inline bool do_boxes_meet(const Vec<Number>& way,
                                                            const Vec<Number>& a,
                                                            const Vec<Number>& t,
                                                            const Number& slack = Number(0)) {
  const auto meet = [&](const Number& w, const Number& to, const Number& u)
      __attribute__((always_inline)) {
    const auto size = [](const Number& value) { return value < Number(0) ? -value : value; };
    return size(to + to + u - w) <= size(w) + size(u) + slack;
  };
  return meet(way.x, a.x, t.x) & meet(way.y, a.y, t.y);
}

/// Segment t starts at `a`, seen from the start of r.
template <class Lanes, class Vector>
[[gnu::always_inline]] inline Sides sides(const Lanes& lanes, const Vector& r, const Vector& a,
                                          const Vector& t, const ZeroSides& zeros = {}) {
  if constexpr (Lanes::kRoundsPoints) return lanes.sides(r, a, t, zeros);
  const double start = lanes.side(r, a, zeros.start);
  const double along = -lanes.side(t, a, zeros.along);
  if constexpr (Lanes::kHoldsSums) {
    const double turn = lanes.turn(r, t);
    return {start, start + turn, along, turn - along};
  } else {
    return {start, lanes.side(r, plus(a, t), zeros.end), along,
            -lanes.side(t, minus(r, a), zeros.left)};
  }
}

}  // namespace minksum
