// Joins the polylines of a resolved geometry into paths, of which a sum has less to do.
#pragma once

#include <vector>

#include "machine/cancellation.hpp"
#include "minksum/geometry.hpp"

namespace minksum {

/// Returns paths that together are the same set as polylines of a resolved geometry. These end
/// wherever they meet. Two that go straight on become one path without a vertex there, and other
/// ends at one point are joined two by two. So paths may cross one another and themselves. For n
/// ends of polylines it takes O(n log n), and the time to copy the vertices.
[[nodiscard]] std::vector<Polyline> join_paths(const std::vector<Polyline>& polylines,
                                               Cancellation& cancellation);

}  // namespace minksum
