// Declares sets of points of any dimension: areas, polylines and points together.
#pragma once

#include <utility>
#include <vector>

#include "minksum/region.hpp"

namespace minksum {

/// A path along two or more vertices. It is closed if the last vertex repeats the first.
using Polyline = std::vector<Point>;

/// The union of polygons, polylines and points: the operand and the result of most operations.
///
/// A Geometry as such promises nothing: rings may cross themselves and each other. Results of
/// operations are *resolved*, which means:
/// - `region` is valid and canonical (see Region).
/// - Polylines and points lie outside of `region`. Only ends of polylines may lie on its boundary.
/// - Polylines are simple and meet only at their ends. Two of them are joined unless that makes a
///   branch. No vertex lies in the middle of a straight run.
/// - An open polyline starts at its lexicographically smaller end. A closed one starts at its
///   smallest vertex and goes on to that vertex's smaller neighbour.
/// - Polylines and points are sorted.
///
/// Equal sets that are resolved therefore compare equal.
struct MINKSUM_API Geometry {
  Region region;                    ///< the parts that have area
  std::vector<Polyline> polylines;  ///< the parts that have length, but no area
  std::vector<Point> points;        ///< the parts that have neither

  Geometry() = default;
  /// Makes a geometry from a region and thin parts. A region alone converts implicitly. A polygon
  /// needs to be named as one: `offset(Geometry(polygon), 1)`.
  // NOLINTNEXTLINE(google-explicit-constructor)
  Geometry(Region area, std::vector<Polyline> lines = {}, std::vector<Point> alone = {})
      : region(std::move(area)), polylines(std::move(lines)), points(std::move(alone)) {}
  // Not inline, to keep the code of callers small.
  Geometry(const Geometry& other);                 ///< copies in O(n) for n vertices of thin parts
  Geometry(Geometry&& other) noexcept;             ///< leaves `other` empty
  Geometry& operator=(const Geometry& other);      ///< copies in O(n) as well
  Geometry& operator=(Geometry&& other) noexcept;  ///< leaves `other` empty
  ~Geometry();

  /// Tells whether the geometry is the empty set.
  [[nodiscard]] bool empty() const { return region.empty() && !has_thin_parts(); }
  /// Tells whether there are polylines or points.
  [[nodiscard]] bool has_thin_parts() const { return !polylines.empty() || !points.empty(); }
  /// Tells whether all parts are equal as stored. That holds for equal sets if both are resolved.
  friend bool operator==(const Geometry&, const Geometry&) = default;
};

}  // namespace minksum
