// Derives how many bits each decision needs, and gives each rung number types that hold them.
#pragma once

#include "exact/fraction.hpp"
#include "exact/wide_int.hpp"

namespace minksum {

// Coordinates are in [0, 2^B). So differences within one operand, and with them edge vectors d, are
// below 2^B in magnitude. Sums of two coordinates are in [0, 2^(B+1)). Differences v of two such
// sums are below 2^(B+1). One bit more holds the sign.
//   cross(d, v)                  < 2 · 2^B · 2^(B+1)               = 2^(2B+2)
//   denominator cross(d, d')     < 2^(2B+1)
//   order along a segment        N1·D2 − N2·D1 < 2 · 2^(2B+2) · 2^(2B+1)   = 2^(4B+4)
//   node against a segment       D·cross(d, v) + N·cross(d, d')            < 2^(4B+4)
//   coordinate of a crossing     a·D + N·d < 2^(B+1+2B+1) + 2^(2B+2+B)     = 2^(3B+3)
//   order of two crossings       X1·D2 − X2·D1 < 2 · 2^(3B+3) · 2^(2B+1)   = 2^(5B+5)
//   with the offset (|o| < 2^127): X + o·D < 2^(3B+3) + 2^(2B+128); D times a grid's divisor of up
//   to 62 bits is less than that
//   probe at k/2^r, r ≤ 60       cross(d, 2^r·v + k·d') < 2^(2B+3+60)
constexpr int cross_bits(int b) { return 2 * b + 3; }
constexpr int along_bits(int b) { return 4 * b + 5; }
constexpr int lexicographic_bits(int b) { return 5 * b + 6; }
constexpr int offset_bits(int b) { return (3 * b + 3 > 2 * b + 128 ? 3 * b + 3 : 2 * b + 128) + 2; }
constexpr int probe_bits(int b) { return 2 * b + 64; }

template <class Number>
struct Bits;
template <>
struct Bits<std::int64_t> {
  static constexpr int value = 64;
};
template <>
struct Bits<Int128> {
  static constexpr int value = 128;
};
template <std::size_t N>
struct Bits<WideInt<N>> {
  static constexpr int value = WideInt<N>::kBits;
};

template <int B, class CoordType, class CrossType, class AlongType, class LexType, class ProbeType>
struct FixedRung {
  static constexpr int kCoordinateBits = B;
  using Coord = CoordType;
  using Cross = CrossType;
  using Along = AlongType;
  using Lexicographic = LexType;
  using ProbeNumber = ProbeType;
  static_assert(B + 3 <= Bits<Coord>::value);
  static_assert(cross_bits(B) <= Bits<Cross>::value);
  static_assert(along_bits(B) <= Bits<Along>::value);
  static_assert(lexicographic_bits(B) <= Bits<Lexicographic>::value);
  static_assert(offset_bits(B) <= Bits<Lexicographic>::value);
  static_assert(probe_bits(B) <= Bits<ProbeNumber>::value);
};

using NarrowRung = FixedRung<30, std::int64_t, std::int64_t, Int128, WideInt<3>, Int128>;
using MediumRung = FixedRung<61, std::int64_t, Int128, WideInt<4>, WideInt<5>, WideInt<3>>;
using WideRung = FixedRung<125, Int128, WideInt<4>, WideInt<8>, WideInt<10>, WideInt<5>>;

struct ArbitraryRung {
  using Coord = Fraction;
  using Cross = Fraction;
  using Along = Fraction;
  using Lexicographic = Fraction;
  using ProbeNumber = Fraction;
};

/// Up to these many bits, the floating-point filter decides without any rounding.
inline constexpr int kExactSumBits = 52;      ///< sums and differences of sums are exact doubles
inline constexpr int kExactProductBits = 25;  ///< cross products are exact doubles, too
static_assert(kExactSumBits + 1 <= 53 && cross_bits(kExactProductBits) <= 53);

}  // namespace minksum
