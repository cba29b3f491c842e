// The sum of geometries, put together from sums of their parts.
#pragma once

#include <span>

#include "machine/cancellation.hpp"
#include "minksum/geometry.hpp"
#include "sum/sum_request.hpp"

namespace minksum {

/// What a sum of geometries is made of; each by the method that the options name.
class PartialSums {
 public:
  virtual ~PartialSums() = default;

  /// Makes a region ready to be an operand (0 or 1) of the sums below; false if it is no valid one.
  /// It must live as long as these sums are asked for.
  virtual bool take(int operand, const Region& region) = 0;
  /// The sum of both regions. The statistics are its.
  virtual void add_regions(Region& sum) = 0;
  /// The sum of the region taken as this operand and the union of polylines: a region.
  virtual void sweep(int operand, std::span<const Polyline> polylines, Region& sum) = 0;
  /// The sum of two unions of polylines: the region that edges of different directions sweep, and
  /// the sums of parallel edges, one segment for each pair, which may overlap.
  virtual void add_polylines(std::span<const Polyline> p, std::span<const Polyline> q,
                             Geometry& sum) = 0;
  /// Of the whole sum.
  virtual Cancellation& cancellation() = 0;
};

/// P ⊕ Q for P = A ∪ L, Q = B ∪ M with areas A, B and thin parts L, M, after reading them by
/// `options.fill`: A⊕B ∪ A⊕M ∪ L⊕B ∪ L⊕M. What is moved by a point is moved exactly.
/// Throws Error, see minkowski_sum.
void sum_geometries(const Geometry& p, const Geometry& q, const SumRequest& options,
                    PartialSums& partial, Geometry& result);

/// Drops what made the edges: where operands were not used as given it would mislead.
void forget_origins(Region& region);

}  // namespace minksum
