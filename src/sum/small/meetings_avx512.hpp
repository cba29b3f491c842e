// The meetings of few segments by vectors of 512 bits, by hand: a comparison gives bits in one step
// there, which compilers make of a loop in many.
#pragma once

#include <type_traits>

#include "sum/small/meeting_sets.hpp"

#if defined(__x86_64__) && defined(__GNUC__)
#define MINKSUM_HAS_AVX512 1
#define MINKSUM_AVX512 [[gnu::target("avx512f,avx512bw,avx512dq,avx512vl")]]

#include <immintrin.h>

namespace minksum {

/// Eight doubles. What is fused is exact, as all else is.
struct DoubleLanes {
  using Lanes = __m512d;
  static constexpr int kBelow = _CMP_LT_OQ;
  static constexpr int kAtMost = _CMP_LE_OQ;
  static constexpr int kZero = _CMP_EQ_OQ;
  static constexpr int kAtLeast = _CMP_GE_OQ;
  MINKSUM_AVX512 static Lanes load(const double* from) { return _mm512_load_pd(from); }
  MINKSUM_AVX512 static Lanes all(double value) { return _mm512_set1_pd(value); }
  MINKSUM_AVX512 static Lanes add(Lanes a, Lanes b) { return _mm512_add_pd(a, b); }
  MINKSUM_AVX512 static Lanes subtract(Lanes a, Lanes b) { return _mm512_sub_pd(a, b); }
  MINKSUM_AVX512 static Lanes cross(Lanes ax, Lanes ay, Lanes bx, Lanes by) {
    return _mm512_fmsub_pd(ax, by, _mm512_mul_pd(ay, bx));
  }
  /// Of some lanes, those that compare so with 0.
  template <int kPredicate>
  MINKSUM_AVX512 static __mmask8 where(__mmask8 among, Lanes a) {
    return _mm512_mask_cmp_pd_mask(among, a, _mm512_setzero_pd(), kPredicate);
  }
};

/// Eight integers of 64 bits.
struct IntegerLanes {
  using Lanes = __m512i;
  static constexpr int kBelow = _MM_CMPINT_LT;
  static constexpr int kAtMost = _MM_CMPINT_LE;
  static constexpr int kZero = _MM_CMPINT_EQ;
  static constexpr int kAtLeast = _MM_CMPINT_NLT;
  MINKSUM_AVX512 static Lanes load(const double* from) {
    return _mm512_cvtpd_epi64(_mm512_load_pd(from));
  }
  MINKSUM_AVX512 static Lanes all(double value) {
    return _mm512_set1_epi64(static_cast<std::int64_t>(value));
  }
  MINKSUM_AVX512 static Lanes add(Lanes a, Lanes b) { return _mm512_add_epi64(a, b); }
  MINKSUM_AVX512 static Lanes subtract(Lanes a, Lanes b) { return _mm512_sub_epi64(a, b); }
  MINKSUM_AVX512 static Lanes cross(Lanes ax, Lanes ay, Lanes bx, Lanes by) {
    return _mm512_sub_epi64(_mm512_mullo_epi64(ax, by), _mm512_mullo_epi64(ay, bx));
  }
  /// Of some lanes, those that compare so with 0.
  template <int kPredicate>
  MINKSUM_AVX512 static __mmask8 where(__mmask8 among, Lanes a) {
    return _mm512_mask_cmp_epi64_mask(among, a, _mm512_setzero_si512(), kPredicate);
  }
};

template <class Number>
using LanesOf = std::conditional_t<std::is_same_v<Number, double>, DoubleLanes, IntegerLanes>;

/// As `find_meetings`.
template <class Number>
MINKSUM_AVX512 bool find_meetings_by_avx512(const SmallSegments& s, SmallMeetingSets& m) {
  using L = LanesOf<Number>;
  using Lanes = typename L::Lanes;
  m.right_count = 0;
  for (std::uint32_t first = 0; first < s.size; first += kLanes) {
    const Lanes x = L::load(s.x.data() + first);
    const Lanes y = L::load(s.y.data() + first);
    const Lanes dx = L::load(s.dx.data() + first);
    const Lanes dy = L::load(s.dy.data() + first);
    __m512i right = _mm512_setzero_si512();
    __m512i at_end = _mm512_setzero_si512();
    for (std::uint32_t t = 0; t < s.size; ++t) {
      const Lanes tx = L::all(s.dx[t]);
      const Lanes ty = L::all(s.dy[t]);
      const Lanes ax = L::subtract(L::all(s.x[t]), x);
      const Lanes ay = L::subtract(L::all(s.y[t]), y);
      const Lanes start = L::cross(dx, dy, ax, ay);
      const Lanes turn = L::cross(dx, dy, tx, ty);
      const Lanes end = L::add(start, turn);
      const Lanes along = L::cross(ax, ay, tx, ty);
      const Lanes left = L::subtract(turn, along);
      const __m512i bit = _mm512_set1_epi64(static_cast<long long>(kBitOf[t]));
      __mmask8 lanes = L::template where<L::kAtLeast>(0xff, start);
      lanes = L::template where<L::kBelow>(lanes, end);
      lanes = L::template where<L::kBelow>(lanes, along);
      lanes = L::template where<L::kAtMost>(lanes, left);
      right = _mm512_mask_or_epi64(right, lanes, right, bit);
      lanes = L::template where<L::kZero>(0xff, left);
      lanes = L::template where<L::kAtMost>(lanes, start);
      lanes = L::template where<L::kAtLeast>(lanes, end);
      at_end = _mm512_mask_or_epi64(at_end, lanes, at_end, bit);
    }
    alignas(64) std::array<LaneBits, kLanes> right_of;
    alignas(64) std::array<LaneBits, kLanes> at_end_of;
    _mm512_store_si512(right_of.data(), right);
    _mm512_store_si512(at_end_of.data(), at_end);
    for (std::uint32_t i = first; i < first + kLanes && i < s.size; ++i) {
      m.of[i] = {right_of[i - first], at_end_of[i - first] & ~kBitOf[i]};
      m.right_count += static_cast<std::uint32_t>(std::popcount(right_of[i - first]));
    }
    if (m.right_count > most_right_meetings(first)) return false;
  }
  return true;
}

}  // namespace minksum

#undef MINKSUM_AVX512
#endif
