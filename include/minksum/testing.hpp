// Declares settings of how a sum is computed, for tests and comparisons. No result depends on them.
#pragma once

#include "minksum/export.h"
#include "minksum/minkowski_sum.hpp"
#include "minksum/prepared_region.hpp"

namespace minksum {

/// Says by which method a sum is computed. All three give the same region.
enum class Method {
  /// Reduced convolution, cover and orientable loops (Behar and Lien, IROS 2011), which is fast.
  kReduced,
  /// Signed convolution and winding numbers (Guibas, Ramshaw, Stolfi 1983). It shares nothing with
  /// the other two but what boolean operations use, so it is an independent check. It is meant for
  /// operands of small and middle size. No setting below concerns it.
  kSigned,
  /// The full convolution of Wein (ESA 2006), with reflex vertices and without a cover. It is slow,
  /// and serves the comparisons of the paper.
  kFull,
};

/// The options of a sum, and settings that users do not need. Where this header is included, `{}`
/// for the options of a sum is ambiguous: write `Options{}`.
struct SumSettings : Options {
  Method method = Method::kReduced;                ///< the method that computes the sum
  /// the narrowest number type that may decide; a wider one is used where operands need it
  Arithmetic arithmetic = Arithmetic::kAutomatic;
  bool filter = true;  ///< false = exact arithmetic takes every decision
  /// false = the whole arrangement is built, without a cover, and no segment is clipped
  bool cover = true;
  /// cells along the side of the cover's grid that has more, of which 4096 are the most; 0 = the
  /// library chooses
  int grid = 0;
  bool check = false;  ///< true = each stage's checker tests its result, which is slow
  bool small = true;   ///< false = small operands take the stages, too
  bool share_all = false;  ///< true = threads share even work that is too little to gain
};

/// Returns the sum of two valid regions, computed as the settings say. Complexity and errors are
/// those of minkowski_sum in minkowski_sum.hpp. Only the pairs of operands that are listed here
/// have forms with settings: all others see the Options alone.
[[nodiscard]] MINKSUM_API Region minkowski_sum(const Region& p, const Region& q,
                                               const SumSettings& settings);
/// Returns the same for geometries.
[[nodiscard]] MINKSUM_API Geometry minkowski_sum(const Geometry& p, const Geometry& q,
                                                 const SumSettings& settings);
/// Returns the same for prepared operands.
[[nodiscard]] MINKSUM_API Region minkowski_sum(const PreparedRegion& p, const PreparedRegion& q,
                                               const SumSettings& settings);
/// Computes the same for regions with memory that is reused, and returns errors. On failure
/// `result` is empty.
MINKSUM_API Outcome minkowski_sum(const Region& p, const Region& q, const SumSettings& settings,
                                  Workspace& workspace, Region& result);
/// Computes the same for geometries.
MINKSUM_API Outcome minkowski_sum(const Geometry& p, const Geometry& q, const SumSettings& settings,
                                  Workspace& workspace, Geometry& result);
/// Computes the same for prepared operands.
MINKSUM_API Outcome minkowski_sum(const PreparedRegion& p, const PreparedRegion& q,
                                  const SumSettings& settings, Workspace& workspace,
                                  Region& result);
/// Returns the same for regions with statistics, tight places and trace. Only Method::kReduced
/// finds tight places: asking for them with another method is an Error(kBadInput).
[[nodiscard]] MINKSUM_API DetailedSum detailed_sum(const Region& p, const Region& q,
                                                   const SumSettings& settings,
                                                   Detail detail = Detail::kStatistics);
/// Returns the same for geometries.
[[nodiscard]] MINKSUM_API DetailedSum detailed_sum(const Geometry& p, const Geometry& q,
                                                   const SumSettings& settings,
                                                   Detail detail = Detail::kStatistics);
/// Returns the same for prepared operands.
[[nodiscard]] MINKSUM_API DetailedSum detailed_sum(const PreparedRegion& p, const PreparedRegion& q,
                                                   const SumSettings& settings,
                                                   Detail detail = Detail::kStatistics);

}  // namespace minksum
