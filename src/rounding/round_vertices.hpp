// Coordinates as they are rounded: to a double, or to an integer number of decimal steps.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "machine/cancellation.hpp"
#include "minksum/error.hpp"
#include "minksum/region.hpp"
#include "region/rational_access.hpp"

namespace minksum {

/// What coordinates are rounded to: doubles, or multiples of 10^-decimals.
struct Target {
  std::optional<int> decimals;

  [[nodiscard]] bool is_decimal() const { return decimals.has_value(); }
  /// The unit of `RoundedCoordinate` and of `RoundedVertex::off`: 1, or one decimal step.
  [[nodiscard]] Rational unit() const;
};

/// A coordinate of the target, in its unit.
struct RoundedCoordinate {
  double value = 0;  ///< itself; of a decimal, the double nearest to `integer`
  BigInt integer;    ///< of a decimal only
};

/// A vertex, where it goes, and how far that is.
struct RoundedVertex {
  RoundedCoordinate x;
  RoundedCoordinate y;
  /// Exact less rounded, in the target's unit: the nearest double, but 0 only if there is no
  /// difference.
  double off_x = 0;
  double off_y = 0;
  [[nodiscard]] bool moved() const { return off_x != 0 || off_y != 0; }
};

/// One for each vertex of a region.
using RoundedVertices = std::vector<RoundedVertex>;

/// Throws the error that a coordinate, or what it is rounded to, is no double (kLimitExceeded).
[[noreturn]] void fail_beyond_doubles(const Culprit& place = {});

/// Every coordinate to the nearest of the target, ties to even. O(n). Throws as above, naming the
/// vertex, if doubles are the target.
[[nodiscard]] RoundedVertices round_vertices(const Region& region, const Target& target,
                                             Cancellation& cancellation);

/// The same for one coordinate; infinite if it is beyond the doubles.
[[nodiscard]] RoundedCoordinate nearest_place(const Rational& value, const Target& target);

/// The number that a place means.
[[nodiscard]] Rational value_of(const RoundedCoordinate& place, const Target& target);
/// The place next to this one, up or down. Beyond the largest double comes infinity.
[[nodiscard]] RoundedCoordinate next_place(const RoundedCoordinate& place, bool up,
                                           const Target& target);

/// A place some steps away; a step of doubles is `step` there, if that is a place.
[[nodiscard]] RoundedCoordinate shifted_place(const RoundedCoordinate& place, double steps,
                                              double step, const Target& target);

/// Appends a vertex.
void add_vertex(Region& region, const RoundedCoordinate& x, const RoundedCoordinate& y,
                const Target& target);
/// A region of the same rings with the rounded vertices.
[[nodiscard]] Region with_vertices(const Region& region, const RoundedVertices& vertices,
                                   const Target& target, Cancellation& cancellation);

/// How far any vertex is from its place, in the target's unit, rounded up.
[[nodiscard]] double largest_move(const RoundedVertices& vertices);
/// √(x² + y²) with a relative error below 2^-50, the same on every machine.
[[nodiscard]] double length_of(double x, double y);
/// A double that is no less than a length computed in doubles with a relative error below 2^-50.
[[nodiscard]] double rounded_up(double length);
/// A double that is no less than the number.
[[nodiscard]] double rounded_up(const Rational& value);

}  // namespace minksum
