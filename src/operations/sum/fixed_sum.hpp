// Sums of prepared regions for who knows more of them: that the other operand is valid, as images
// of a valid one are, or that it takes the stages.
#pragma once

#include "minksum/prepared_region.hpp"
#include "sum/cover/shared_raster.hpp"
#include "sum/sum_request.hpp"

namespace minksum {

/// minkowski_sum(fixed, valid). `shared`, if it is not null, is for sums of `fixed`.
Outcome minkowski_sum(const PreparedRegion& fixed, const Region& valid, const SharedRaster* shared,
                      const SumRequest& options, Workspace& workspace, Region& result);

/// minkowski_sum(p, q) of geometries, with what is asked for beside the sum.
Outcome sum_of_geometries(const Geometry& p, const Geometry& q, const SumRequest& options,
                          Workspace& workspace, Geometry& result);

/// minkowski_sum(p, q) by the stages, for operands whose sum `sum_small` has left to them.
Outcome sum_by_stages(const PreparedRegion& p, const PreparedRegion& q, const SumRequest& options,
                      Workspace& workspace, Region& result);

/// What sums of `fixed` with others like `typical`, which is valid and not empty, can share; see
/// `share_raster`.
[[nodiscard]] std::optional<SharedRaster> share_raster(const PreparedRegion& fixed,
                                                       const Region& typical, double widest,
                                                       const SumRequest& options);

}  // namespace minksum
