// How a sum is computed: for tests, comparisons and pictures. Results never depend on it.
#pragma once

#include "minksum/export.h"
#include "minksum/minkowski_sum.hpp"
#include "minksum/prepared_region.hpp"

namespace minksum {

/// How the sum is computed. All three give the same region.
enum class Method {
  /// Reduced convolution, cover, orientable loops (Behar and Lien, IROS 2011). The fast one.
  kReduced,
  /// Signed convolution and winding numbers (Guibas, Ramshaw, Stolfi 1983), on code of its own:
  /// an independent check. Meant for small and middling operands.
  kSigned,
  /// The full convolution of Wein (ESA 2006), reflex vertices included, no cover. Slow; for the
  /// comparisons of the paper.
  kFull,
};

/// The options of a sum, and settings that users have no need for.
struct SumSettings : Options {
  Method method = Method::kReduced;                ///< how the sum is computed
  Arithmetic arithmetic = Arithmetic::kAutomatic;  ///< kBadInput if the operands do not fit
  bool filter = true;                              ///< false: every decision by exact arithmetic
  bool cover = true;   ///< false: no cover; the whole arrangement is built
  int grid = 0;        ///< cells along the longer side of the cover's grid; 0 = chosen
  bool check = false;  ///< runs each stage's checker on its result; slow
  bool small = true;   ///< false: by the stages even where operands are small
};

/// The sum of minkowski_sum.hpp, computed as the settings say. Throws as that.
[[nodiscard]] MINKSUM_API Region minkowski_sum(const Region& p, const Region& q,
                                               const SumSettings& settings);
/// The same for geometries.
[[nodiscard]] MINKSUM_API Geometry minkowski_sum(const Geometry& p, const Geometry& q,
                                                 const SumSettings& settings);
/// The same for prepared operands.
[[nodiscard]] MINKSUM_API Region minkowski_sum(const PreparedRegion& p, const PreparedRegion& q,
                                               const SumSettings& settings);
/// The same with memory that is reused, and no exception.
MINKSUM_API Outcome minkowski_sum(const Region& p, const Region& q, const SumSettings& settings,
                                  Workspace& workspace, Region& result);
/// The same for geometries.
MINKSUM_API Outcome minkowski_sum(const Geometry& p, const Geometry& q, const SumSettings& settings,
                                  Workspace& workspace, Geometry& result);
/// The same for prepared operands.
MINKSUM_API Outcome minkowski_sum(const PreparedRegion& p, const PreparedRegion& q,
                                  const SumSettings& settings, Workspace& workspace,
                                  Region& result);
/// The same with what is known of the sum. Method::kReduced alone finds tight places: with others
/// they are an Error(kBadInput).
[[nodiscard]] MINKSUM_API DetailedSum detailed_sum(const Region& p, const Region& q,
                                                   const SumSettings& settings,
                                                   Detail detail = Detail::kStatistics);
/// The same for geometries.
[[nodiscard]] MINKSUM_API DetailedSum detailed_sum(const Geometry& p, const Geometry& q,
                                                   const SumSettings& settings,
                                                   Detail detail = Detail::kStatistics);
/// The same for prepared operands.
[[nodiscard]] MINKSUM_API DetailedSum detailed_sum(const PreparedRegion& p, const PreparedRegion& q,
                                                   const SumSettings& settings,
                                                   Detail detail = Detail::kStatistics);

}  // namespace minksum
