// Tests laws of any two geometries and their sum by independent methods, for the fuzz target and
// the random tests. Each function returns the law that is broken, or an empty text.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "minksum/minkowski_sum.hpp"
#include "minksum/round.hpp"
#include "minksum/testing.hpp"

namespace minksum::test {

/// Two operands, with the setting by which they are read (`setting.fill`, `setting.regularize`) and
/// summed.
struct SumCase {
  Geometry p;
  Geometry q;
  SumSettings setting;
};

/// Returns enough of a case to run it again.
[[nodiscard]] std::string note(const SumCase& sum_case);

/// Returns about how long brute force takes: the number of pairs of pieces of the resolved
/// operands.
[[nodiscard]] std::size_t brute_force_work(const SumCase& sum_case);

/// Law: resolving agrees with brute force, and resolving again changes nothing. The next two laws
/// rely on this.
[[nodiscard]] std::string broken_resolve(const Geometry& geometry, FillRule fill, bool regularize);
/// Law: the sum agrees with brute force, with the setting, with exchanged operands, and by the
/// signed method.
[[nodiscard]] std::string broken_sum(const SumCase& sum_case);
/// Law: tight places agree with brute force.
[[nodiscard]] std::string broken_tight(const SumCase& sum_case);
/// Law: a map that scales and moves operands along the axes, and changes no order, scales and moves
/// the sum and its tight places alike.
[[nodiscard]] std::string broken_scaling(const SumCase& sum_case,
                                         const std::function<Point(const Point&)>& map);
/// Law: a result is resolved by the definition. Large results are not tested.
[[nodiscard]] std::string broken_form(const Geometry& result);
/// Law: a rounded geometry is on the target, valid, resolved, and on its side. It is rounded to
/// doubles, 3 decimals and integers, on each side.
[[nodiscard]] std::string broken_rounding(const Geometry& exact);
/// Tests the same law for one rounded geometry.
[[nodiscard]] std::string broken_rounding(const Geometry& exact, const RoundOptions& options,
                                          const RoundingReport& report, const Geometry& rounded);
/// Law: `check_sum` accepts the sum, and rejects it without one of its parts.
[[nodiscard]] std::string broken_check(const SumCase& sum_case, const Geometry& sum);

}  // namespace minksum::test
