// Compiles a loop several times: for every machine, and for machines with wider vectors.
#pragma once

#include <cstdint>

namespace minksum {

/// The vector instructions that a loop may use.
enum class Vectors : std::uint8_t {
  kPlain,  ///< those that the library is built for
  kAvx2,
  kAvx512,  ///< F, BW, DQ and VL
};

#if defined(__x86_64__) && defined(__GNUC__)

/// Returns the widest vectors that this machine has.
[[nodiscard]] inline Vectors widest_vectors() {
  static const Vectors widest = [] {
    const bool has_avx512 =
        __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512bw") != 0 &&
        __builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512vl") != 0;
    if (has_avx512) return Vectors::kAvx512;
    return __builtin_cpu_supports("avx2") != 0 ? Vectors::kAvx2 : Vectors::kPlain;
  }();
  return widest;
}

template <class Work>
[[gnu::target("avx2")]] auto with_avx2(Work work) {
  return work();
}
template <class Work>
[[gnu::target("avx512f,avx512bw,avx512dq,avx512vl")]] auto with_avx512(Work work) {
  return work();
}

/// Calls work(), compiled for such vectors, which the machine must have. The code is the same and
/// no product is fused with a sum, so the result is the same, bit by bit. To gain from this, a
/// lambda and the functions it calls must be inlined: mark them [[gnu::always_inline]].
template <class Work>
auto with_vectors(Vectors vectors, Work work) {
  switch (vectors) {
    case Vectors::kAvx512:
      return with_avx512(work);
    case Vectors::kAvx2:
      return with_avx2(work);
    case Vectors::kPlain:
      break;
  }
  return work();
}

#else

[[nodiscard]] inline Vectors widest_vectors() { return Vectors::kPlain; }

template <class Work>
auto with_vectors(Vectors, Work work) {
  return work();
}

#endif

}  // namespace minksum
