// Puts the sum of geometries together from sums of their parts.
#pragma once

#include <span>

#include "machine/cancellation.hpp"
#include "minksum/geometry.hpp"
#include "sum/sum_request.hpp"

namespace minksum {

/// The sums of which a sum of geometries is made. Each uses the method that the options name.
class PartialSums {
 public:
  virtual ~PartialSums() = default;

  /// Prepares a region as an operand (0 or 1) of the sums below. Returns false if it is not valid.
  /// The region must live as long as these sums are asked for.
  virtual bool take(int operand, const Region& region) = 0;
  /// Computes the sum of both regions, to which the statistics belong.
  virtual void add_regions(Region& sum) = 0;
  /// Computes the sum of the region of this operand and the union of polylines, which is a region.
  virtual void sweep(int operand, std::span<const Polyline> polylines, Region& sum) = 0;
  /// Computes the sum of two unions of polylines: the region that edges of different directions
  /// sweep, and the sums of parallel edges outside of it. These are one segment for each pair, and
  /// may overlap.
  virtual void add_polylines(std::span<const Polyline> p, std::span<const Polyline> q,
                             Geometry& sum) = 0;
  /// Returns the cancellation of the whole sum.
  virtual Cancellation& cancellation() = 0;
};

/// Computes P ⊕ Q for P = A ∪ L and Q = B ∪ M with areas A, B and thin parts L, M. Both are read by
/// `options.fill`. The result is A⊕B ∪ A⊕M ∪ L⊕B ∪ L⊕M. Moves by points are exact. Throws Error as
/// minkowski_sum does.
void sum_geometries(const Geometry& p, const Geometry& q, const SumRequest& options,
                    PartialSums& partial, Geometry& result);

/// Drops the origins of edges, which would mislead where operands were not used as given.
void forget_origins(Region& region);

}  // namespace minksum
