// Declares no-fit and inner-fit polygons: where parts can be placed.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>

#include "minksum/export.h"
#include "minksum/locate.hpp"
#include "minksum/minkowski_sum.hpp"

namespace minksum {

/// Returns the no-fit polygon of `moving` around `fixed`: the placements t of the reference point
/// at which the parts touch or overlap. They overlap if t is inside its area. They touch on its
/// boundary, and on its polylines and points, which are tight places. Elsewhere they are apart. It
/// is (fixed ⊕ −moving) + reference.
///
/// Both shapes are read by `options.fill`, and their thin parts are dropped. `reference` is the
/// point of the moving part that says where the part is. By default it is the part's first vertex,
/// as given. Complexity and errors are those of minkowski_sum. Throws Error(kBadInput) with culprit
/// operand 1 if `moving` has no vertex to be the reference point.
[[nodiscard]] MINKSUM_API Geometry no_fit_polygon(const Geometry& fixed, const Geometry& moving,
                                                  const std::optional<Point>& reference = {},
                                                  const Options& options = {});

/// Returns the inner-fit polygon of `part` in `bin`: the placements t of the reference point at
/// which the part lies inside the bin. They may touch. It is (bin ⊖ part) + reference, and
/// placements without play are polylines and points. It is empty if the part does not fit.
/// Operands, `reference` and errors are as above, and a part without area is an error, too.
[[nodiscard]] MINKSUM_API Geometry inner_fit_polygon(const Geometry& bin, const Geometry& part,
                                                     const std::optional<Point>& reference = {},
                                                     const Options& options = {});

/// Says how a placed part relates to a fixed one.
enum class Contact {
  kFree,         ///< they are apart
  kTouching,     ///< their boundaries meet, and their interiors do not
  kOverlapping,  ///< their interiors meet
};

/// A no-fit polygon that is asked many times. Copies share it, and any number of threads may ask.
class MINKSUM_API NoFitPolygon {
 public:
  /// Computes the polygon as `no_fit_polygon` does, and throws as that does. It then takes O(n log
  /// n) to prepare n vertices.
  NoFitPolygon(const Geometry& fixed, const Geometry& moving,
               const std::optional<Point>& reference = {}, const Options& options = {});
  /// Copies share what is prepared, and what was moved from is as good as a copy.
  NoFitPolygon(const NoFitPolygon&) = default;
  NoFitPolygon& operator=(const NoFitPolygon&) = default;
  ~NoFitPolygon() = default;

  /// Returns the polygon itself.
  [[nodiscard]] const Geometry& geometry() const& { return geometry_; }
  /// Returns the polygon of an object that ends with the expression.
  [[nodiscard]] Geometry geometry() && { return geometry_; }
  /// Returns how the parts relate if the reference point is placed at t, exactly. O(log² n).
  [[nodiscard]] Contact contact(const Point& t) const;

 private:
  Geometry geometry_;
  PointLocator locator_;
  PointLocator tight_;
};

/// A part of a table, turned counter-clockwise about its reference point by `turn` · 360 /
/// NoFitTable::turns() degrees.
struct TurnedPart {
  std::size_t part = 0;  ///< its index among the parts of which the table was made
  int turn = 0;          ///< its direction, from 0 to NoFitTable::turns() − 1
};

/// The no-fit polygons of all pairs of some parts, in all their directions, from which nesting
/// starts.
///
/// A part's reference point is its first vertex, as given. For n parts in t directions, there are
/// n² t² no-fit polygons, but only about n² t / 2 sums: if both parts are turned, so is the
/// polygon, and that of (b, a) is the point mirror of that of (a, b). The table makes and keeps
/// only these sums. It turns them when it is asked for the others. Copies share one state, and any
/// number of threads may ask.
class MINKSUM_API NoFitTable {
 public:
  /// Makes all sums on up to options.threads threads. Parts are laid in `turns` directions: 1, 2
  /// (turned by 180 degrees) or 4 (by 90). They are read by `options.fill`, and their thin parts
  /// are dropped. Throws Error(kBadInput) for another number of turns. Throws it, with the part's
  /// index as the operand, for a part without area, and by kStrict for one that is not valid.
  /// Otherwise throws as minkowski_sum does.
  explicit NoFitTable(std::span<const Geometry> parts, int turns = 4, const Options& options = {});
  /// Copies share the state, and so does an object with what was moved from it.
  NoFitTable(const NoFitTable&) = default;
  NoFitTable& operator=(const NoFitTable&) = default;
  ~NoFitTable() = default;

  [[nodiscard]] std::size_t size() const;  ///< the number of parts
  [[nodiscard]] int turns() const;         ///< the number of directions in which parts are laid
  /// Returns the no-fit polygon of `moving` around `fixed`, turned as told, with the reference
  /// point of `fixed` at the origin. It is in canonical form. Its origins name vertices of the
  /// parts as given if these are valid, else of their resolved areas. O(size of the result),
  /// without arithmetic except for tight places. Throws Error: kBadInput for a part or a turn that
  /// the table does not have; kCancelled.
  [[nodiscard]] Geometry at(TurnedPart fixed, TurnedPart moving, const Options& options = {}) const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

}  // namespace minksum
