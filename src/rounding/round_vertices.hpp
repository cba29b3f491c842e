// Rounds coordinates to doubles, or to an integer number of decimal steps.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "machine/cancellation.hpp"
#include "minksum/error.hpp"
#include "minksum/region.hpp"
#include "region/rational_access.hpp"

namespace minksum {

/// The numbers to which coordinates are rounded: doubles, or multiples of 10^-decimals.
struct Target {
  std::optional<int> decimals;

  [[nodiscard]] bool is_decimal() const { return decimals.has_value(); }
  /// Returns the unit of `RoundedCoordinate` and of `RoundedVertex::off_x`: 1, or one decimal step.
  [[nodiscard]] Rational unit() const;
};

/// A place: a coordinate of the target, in its unit.
struct RoundedCoordinate {
  double value = 0;  ///< the place; for decimals, the double nearest to `integer`
  BigInteger integer;  ///< for decimals only
};

/// A vertex: the place to which it goes, and how far that is.
struct RoundedVertex {
  RoundedCoordinate x;
  RoundedCoordinate y;
  /// Exact minus rounded coordinate, in the target's unit, as the nearest double. An offset is 0
  /// only if there is no difference.
  double off_x = 0;
  double off_y = 0;
  [[nodiscard]] bool moved() const { return off_x != 0 || off_y != 0; }
};

/// The rounded vertices of a region, one for each vertex.
using RoundedVertices = std::vector<RoundedVertex>;

/// Throws the error that a coordinate, or its rounded value, is beyond the doubles
/// (kLimitExceeded).
[[noreturn]] void fail_beyond_doubles(const Culprit& place = {});

/// Rounds every coordinate to the nearest place, ties to even. O(n). If doubles are the target,
/// throws this error, naming the vertex.
[[nodiscard]] RoundedVertices round_vertices(const Region& region, const Target& target,
                                             Cancellation& cancellation);

/// Rounds one coordinate. The result is infinite if it is beyond the doubles.
[[nodiscard]] RoundedCoordinate nearest_place(const Rational& value, const Target& target);

/// Returns the number of a place.
[[nodiscard]] Rational value_of(const RoundedCoordinate& place, const Target& target);
/// Returns the place next to this one, up or down. Infinity follows the largest double.
[[nodiscard]] RoundedCoordinate next_place(const RoundedCoordinate& place, bool up,
                                           const Target& target);

/// Returns the place some steps away. For doubles, a step is `step`; the result must be a double.
[[nodiscard]] RoundedCoordinate shifted_place(const RoundedCoordinate& place, double steps,
                                              double step, const Target& target);

void add_vertex(Region& region, const RoundedCoordinate& x, const RoundedCoordinate& y,
                const Target& target);
/// Returns a region of the same rings with the rounded vertices.
[[nodiscard]] Region with_vertices(const Region& region, const RoundedVertices& vertices,
                                   const Target& target, Cancellation& cancellation);

/// Returns the largest distance of a vertex from its place, in the target's unit, rounded up.
[[nodiscard]] double largest_move(const RoundedVertices& vertices);
/// Returns √(x² + y²) with a relative error below 2^-50, the same on every machine.
[[nodiscard]] double length_of(double x, double y);
/// Returns a double that is no less than a length, which was computed with a relative error below
/// 2^-50.
[[nodiscard]] double rounded_up(double length);
/// Returns a double that is no less than the number.
[[nodiscard]] double rounded_up(const Rational& value);

}  // namespace minksum
