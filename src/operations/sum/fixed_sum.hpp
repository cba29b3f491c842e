// Declares sums of prepared regions for callers that know more about the operands: that the other
// one is valid, as images of a valid one are, or that the sum takes the stages.
#pragma once

#include "minksum/prepared_region.hpp"
#include "sum/cover/shared_raster.hpp"
#include "sum/sum_request.hpp"

namespace minksum {

/// Computes minkowski_sum(fixed, valid). `shared` is for sums of `fixed`, or null.
void minkowski_sum(const PreparedRegion& fixed, const Region& valid, const SharedRaster* shared,
                   const SumRequest& options, Workspace& workspace, Region& result);

/// Computes minkowski_sum(p, q) of geometries, and what is asked for besides the sum.
void sum_of_geometries(const Geometry& p, const Geometry& q, const SumRequest& options,
                       Workspace& workspace, Geometry& result);

/// Computes minkowski_sum(p, q) by the stages, for operands whose sum `sum_small` has left to them.
void sum_by_stages(const PreparedRegion& p, const PreparedRegion& q, const SumRequest& options,
                   Workspace& workspace, Region& result);

/// Returns what sums of `fixed` with others like `typical` can share, see `share_raster`. `typical`
/// is valid and not empty.
[[nodiscard]] std::optional<SharedRaster> share_raster(const PreparedRegion& fixed,
                                                       const Region& typical, double widest,
                                                       const SumRequest& options);

}  // namespace minksum
