// Is this the Minkowski sum of these two? A check of anybody's result, by independent methods.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "minksum/export.h"
#include "minksum/minkowski_sum.hpp"
#include "minksum/validity.hpp"

namespace minksum {

/// How thoroughly a result is checked.
struct CheckOptions {
  /// How far, in x and in y, the result may be off: each of its points has a point of the sum
  /// within that, and each point of the sum has one of the result. 0: they must be
  /// equal. Not negative.
  Rational within;
  /// Random points, beside those near the result's edges; as many again where a hole of one operand
  /// has room for a part of the other.
  std::uint64_t samples = 1000;
  /// Edges of the result near which points are tested; if it has more, that many of them, evenly.
  std::uint64_t edges = 10000;
  std::uint64_t seed = 1;  ///< of the random points: the same seed tests the same points
  /// Above these the proof is not tried; `Options::limits` have no meaning here.
  Limits proof{std::uint64_t{1} << 20, std::uint64_t{1} << 23};
};

/// A point that is in one of result and sum, and further than `within` from the other.
struct Disagreement {
  Point at;                ///< the point
  bool in_result = false;  ///< whether it is in the result; else it is in the sum
};

/// A difference of two sets: how much, and a point of its largest part.
struct Difference {
  double area = 0;          ///< about; 0 only if there is none
  std::optional<Point> at;  ///< a point of the largest part; nothing if there is none
};

/// What the comparison with the whole sum found.
enum class Proof {
  kHolds,     ///< the result is the sum, within what is allowed
  kRefuted,   ///< it is not
  kNotTried,  ///< the sum is too large for the second method (see `CheckOptions::proof`)
};

/// What a check found out.
struct SumCheck {
  std::vector<Fault> faults;  ///< why the result is not valid; none = it is
  std::uint64_t points = 0;   ///< points tested
  std::uint64_t disagreements = 0;     ///< points that are in one of result and sum alone
  std::vector<Disagreement> examples;  ///< the first few of these
  Proof proof = Proof::kNotTried;      ///< what the second method says
  double result_area = 0;              ///< to a few units in the last place; so the next
  std::optional<double> sum_area;      ///< by the second method; nothing if it was not tried
  std::optional<Difference> missing;   ///< of the sum, not in the result (areas only)
  std::optional<Difference> surplus;   ///< of the result, not in the sum
  bool thin_parts_differ = false;      ///< whether polylines or points are not those of the sum

  /// Whether nothing speaks against the result.
  [[nodiscard]] bool ok() const {
    return faults.empty() && disagreements == 0 && proof != Proof::kRefuted;
  }
};

/// Checks whether `result` is P ⊕ Q, without the method that `minkowski_sum` uses by default:
/// - validity of the result (`validate`);
/// - points close to its edges on both sides, its vertices, points at random, and points where a
///   part of one operand may be inside a hole of the other: is x in the result exactly if P meets
///   x − Q, decided by code of its own;
/// - the whole sum and its area by Method::kSigned, compared exactly: a proof, where that method is
///   fast enough.
/// The result may be anybody's, rounded or not. O(n + m) and more for each point.
/// Throws Error: kBadInput for operands and for `within`, kCancelled.
[[nodiscard]] MINKSUM_API SumCheck check_sum(const Geometry& result, const Geometry& p,
                                             const Geometry& q, const CheckOptions& how = {},
                                             const Options& options = {});

}  // namespace minksum
