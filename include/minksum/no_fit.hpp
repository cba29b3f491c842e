// No-fit and inner-fit polygons: where parts can be placed.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>

#include "minksum/export.h"
#include "minksum/locate.hpp"
#include "minksum/minkowski_sum.hpp"

namespace minksum {

/// The no-fit polygon of `moving` around `fixed`: placements t of the reference point. In the
/// inside of its area the parts overlap; on its boundary, and on its polylines and points (tight
/// places), they touch; elsewhere they are apart. It is (fixed ⊕ −moving) + reference; thin parts
/// of both shapes are dropped. Orientation of rings has no meaning.
///
/// `reference` is the point of the moving part that says where the part is; without it, the part's
/// first vertex, as given. Throws as minkowski_sum does, and Error(kBadInput) if `moving` has no
/// vertex to be the reference point.
[[nodiscard]] MINKSUM_API Geometry no_fit_polygon(const Geometry& fixed, const Geometry& moving,
                                                  const std::optional<Point>& reference = {},
                                                  const Options& options = {});

/// The inner-fit polygon of `part` in `bin`: the placements t of the reference point that put the
/// part into the bin (touching is allowed). It is (bin ⊖ part) + reference, with the placements
/// that leave no play as polylines and points. Empty if the part does not fit. `reference` and
/// errors as above.
[[nodiscard]] MINKSUM_API Geometry inner_fit_polygon(const Geometry& bin, const Geometry& part,
                                                     const std::optional<Point>& reference = {},
                                                     const Options& options = {});

/// How a placed part relates to a fixed one.
enum class Contact {
  kFree,         ///< they are apart
  kTouching,     ///< their boundaries meet, their insides do not
  kOverlapping,  ///< their insides meet
};

/// A no-fit polygon to be asked many times. Copies share it; any number of threads may ask.
class MINKSUM_API NoFitPolygon {
 public:
  /// Computes the polygon as `no_fit_polygon` does, and throws as that does.
  NoFitPolygon(const Geometry& fixed, const Geometry& moving,
               const std::optional<Point>& reference = {}, const Options& options = {});

  /// The polygon itself.
  [[nodiscard]] const Geometry& geometry() const { return geometry_; }
  /// The relation at placement t of the reference point, exactly; O(log² n).
  [[nodiscard]] Contact contact(const Point& t) const;

 private:
  Geometry geometry_;
  PointLocator locator_;
  PointLocator tight_;
};

/// A part of a table, turned counter-clockwise about its reference point by `turn` times 360
/// degrees / NoFitTable::turns().
struct TurnedPart {
  std::size_t part = 0;  ///< its index among the parts that the table was made of
  int turn = 0;          ///< its direction
};

/// The no-fit polygons of all pairs of some parts, in all their directions: what
/// nesting starts from.
///
/// A part's reference point is its first vertex, as given. Of n parts in t directions, the n² t²
/// no-fit polygons are images of n² t / 2 sums, nearly: if both parts are turned, so is the
/// polygon, and that of (b, a) is the point mirror of that of (a, b). Only these sums are made, and
/// kept; the others are turned when they are asked for. Copies share one state; any number of
/// threads may ask.
class MINKSUM_API NoFitTable {
 public:
  /// Makes all sums, on up to options.threads threads. Parts are laid in `turns` directions: 1, 2
  /// (turned by 180 degrees) or 4 (by 90). Throws as minkowski_sum does, with the index of the part
  /// for the operand where one is to blame; Error(kBadInput) for a part without area, and for turns
  /// other than 1, 2 and 4.
  explicit NoFitTable(std::span<const Geometry> parts, int turns = 4, const Options& options = {});

  [[nodiscard]] std::size_t size() const;  ///< parts
  [[nodiscard]] int turns() const;         ///< directions in which parts are laid
  /// The placements of the reference point of `moving` where it meets `fixed`, whose reference
  /// point is at the origin: as no_fit_polygon gives them for the parts turned and moved so. In
  /// canonical form, always; its origins speak of the parts as given where they are valid, else of
  /// their resolved areas. O(size of the result), without arithmetic but for tight places. Throws
  /// Error(kBadInput) for a part or a turn that is none of the table's; Error(kCancelled).
  [[nodiscard]] Geometry at(TurnedPart fixed, TurnedPart moving, const Options& options = {}) const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

}  // namespace minksum
