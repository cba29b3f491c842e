// Declares a check of any program's result by independent methods: is it the sum of these two sets?
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "minksum/export.h"
#include "minksum/minkowski_sum.hpp"
#include "minksum/validity.hpp"

namespace minksum {

/// Says how thoroughly a result is checked.
struct CheckOptions {
  /// How far the result may deviate in x and in y, not negative. Each of its points must have a
  /// point of the sum within that distance, and each point of the sum one of the result. If it is
  /// 0, both sets must be equal.
  Rational within = {};
  /// Random points that are tested besides those near the result's edges. As many more are tested
  /// where a hole of one operand has room for a part of the other.
  std::uint64_t samples = 1000;
  /// Edges of the result near which points are tested. If there are more, this many are taken
  /// evenly.
  std::uint64_t edges = 10000;
  std::uint64_t seed = 1;  ///< seed of the random points: the same seed tests the same points
  /// Limits above which the proof is not tried. `Options::limits` have no meaning here.
  Limits proof{std::uint64_t{1} << 20, std::uint64_t{1} << 23};
};

/// A point that is in either the result or the sum, and farther than `within` from the other.
struct Disagreement {
  Point at;                ///< the point
  bool in_result = false;  ///< whether it is in the result; else it is in the sum
};

/// A difference of two sets: its size, and a point of its largest part.
struct Difference {
  double area = 0;          ///< the approximate area; 0 only if there is no difference
  std::optional<Point> at;  ///< a point of the largest part, if there is a difference
};

/// Says what the comparison with the whole sum found.
enum class Proof {
  kHolds,     ///< the result is the sum, up to `within`
  kRefuted,   ///< the result is not the sum
  kNotTried,  ///< the sum is too large for the second method (see `CheckOptions::proof`)
};

/// Tells what a check found.
struct SumCheck {
  std::vector<Fault> faults;  ///< the result's faults; none if it is valid
  std::uint64_t points = 0;   ///< points that were tested
  std::uint64_t disagreements = 0;     ///< points at which result and sum disagree
  std::vector<Disagreement> examples;  ///< the first few of these points
  Proof proof = Proof::kNotTried;      ///< what the second method found
  double result_area = 0;              ///< the result's area, to a few units in the last place
  std::optional<double> sum_area;      ///< the sum's area; nothing if no proof was tried
  std::optional<Difference> missing;   ///< area of the sum that the result lacks, if tried
  std::optional<Difference> surplus;   ///< area of the result beyond the sum, if tried
  bool thin_parts_differ = false;      ///< whether polylines or points differ from the sum's

  /// Tells whether nothing speaks against the result.
  [[nodiscard]] bool ok() const {
    return faults.empty() && disagreements == 0 && proof != Proof::kRefuted;
  }
};

/// Verifies or refutes that `result` is P ⊕ Q, and tells what speaks against it. It does without
/// the method that `minkowski_sum` uses by default:
/// - `validate` tests whether the result is valid.
/// - For many points x, code of its own decides whether P meets x − Q: exactly then x must be in
///   the result. Points are tested close to its edges on both sides, at its vertices and at random.
///   Others are tested where a part of one operand may be inside a hole of the other.
/// - The whole sum by Method::kSigned and its area are compared exactly. This is a proof, and is
///   tried where that method is fast enough.
///
/// The result may come from any program, rounded or not. The operands are read by `options.fill`.
/// O(n + m) and more for each point. Throws Error: kBadInput for a negative `within`, and by
/// kStrict for an operand that is not valid, with operand, polygon, ring and vertex; kLimitExceeded
/// as `resolve` does; kCancelled.
[[nodiscard]] MINKSUM_API SumCheck check_sum(const Geometry& result, const Geometry& p,
                                             const Geometry& q, const CheckOptions& how = {},
                                             const Options& options = {});

}  // namespace minksum
