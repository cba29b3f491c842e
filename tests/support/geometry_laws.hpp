// What holds for any two geometries and their sum, by independent methods: shared by the fuzz
// target and the random tests. Each function returns what does not hold, or an empty text.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "minksum/minkowski_sum.hpp"
#include "minksum/round.hpp"

namespace minksum::test {

/// Two operands and how they are read (`setting.fill`, `setting.regularize`) and summed.
struct SumCase {
  Geometry p;
  Geometry q;
  Options setting;
};

/// Enough to run it again.
[[nodiscard]] std::string note(const SumCase& sum_case);

/// About how long brute force takes: pairs of pieces of both operands, as they are resolved.
[[nodiscard]] std::size_t brute_force_work(const SumCase& sum_case);

/// Resolving gives what brute force gives, once and for all. The next two rely on this.
[[nodiscard]] std::string broken_resolve(const Geometry& geometry, FillRule fill, bool regularize);
/// With the setting, exchanged, and by the signed method the sum is that of brute force.
[[nodiscard]] std::string broken_sum(const SumCase& sum_case);
/// Tight places are those of brute force.
[[nodiscard]] std::string broken_tight(const SumCase& sum_case);
/// With operands scaled and moved along the axes, by a map that changes no order, the sum and its
/// tight places are scaled and moved.
[[nodiscard]] std::string broken_scaling(const SumCase& sum_case,
                                         const std::function<Point(const Point&)>& map);
/// A result is resolved by its definition; large ones are not asked.
[[nodiscard]] std::string broken_form(const Geometry& result);
/// Rounded to doubles, 3 decimals and integers, on each side: on the target, valid, resolved, and
/// containing or contained.
[[nodiscard]] std::string broken_rounding(const Geometry& exact);
/// What is wrong with one rounded geometry.
[[nodiscard]] std::string broken_rounding(const Geometry& exact, const RoundOptions& options,
                                          const RoundingReport& report, const Geometry& rounded);
/// `check_sum` says that the sum is right, and that it is not with one of its parts gone.
[[nodiscard]] std::string broken_check(const SumCase& sum_case, const Geometry& sum);

}  // namespace minksum::test
