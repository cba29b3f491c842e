#include "operations/sum/geometry_sum.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "machine/exceeded.hpp"
#include "machine/make_room.hpp"
#include "overlay/boolean.hpp"
#include "overlay/resolve_area.hpp"
#include "region/map_points.hpp"
#include "region/point_arithmetic.hpp"
#include "region/region_access.hpp"
#include "sum/operands/operands.hpp"

namespace minksum {
namespace {

/// Returns the moved geometry. A resolved one stays resolved, as all orders stay the same.
Geometry moved(const Geometry& geometry, const Point& by, Cancellation& cancellation) {
  const auto move = [&](const Point& at) {
    cancellation.check(work_of(at));
    return plus(at, by);
  };
  return mapped(geometry, mapped(geometry.region, move), move);
}

/// An operand as it was given, or resolved.
class Reader {
 public:
  Reader(int operand, const Geometry& given, const SumRequest& options, PartialSums& partial)
      : operand_(operand), given_(given), geometry_(&given), options_(options), partial_(partial) {}

  [[nodiscard]] const Geometry& geometry() const { return *geometry_; }
  [[nodiscard]] bool is_as_given() const { return as_given_; }

  /// Uses valid polygons without thin parts as they are given, unless a rule says what they mean.
  void read() {
    if (is_by_role(options_.fill) && !geometry_->has_thin_parts() &&
        partial_.take(operand_, geometry_->region)) {
      return;
    }
    resolve();
  }
  void resolve() {
    if (!as_given_) return;
    as_given_ = false;
    resolved_ = minksum::resolve(*geometry_, options_, operand_);
    geometry_ = &resolved_;
    if (!partial_.take(operand_, resolved_.region)) {
      throw Error(ErrorCode::kInternal, "a resolved operand is not valid", {}, "operands");
    }
  }

 private:
  int operand_;
  const Geometry& given_;
  const Geometry* geometry_;
  const SumRequest& options_;
  PartialSums& partial_;
  bool as_given_ = true;
  Geometry resolved_;
};

/// Makes all sums of parts except that of both regions.
class ThinSums {
 public:
  ThinSums(const Geometry& p, const Geometry& q, const SumRequest& options, PartialSums& partial,
           std::vector<Geometry>& sums)
      : operands_{&p, &q}, options_(options), partial_(partial), sums_(sums) {}

  void run() {
    // Where polylines cross, each point has a denominator of its own, and all sums would have the
    // product of these.
    const std::array<std::vector<Polyline>, 2> paths{
        join_paths(of(0).polylines, partial_.cancellation()),
        join_paths(of(1).polylines, partial_.cancellation())};
    for (const int operand : {0, 1}) {
      const auto& other = paths[static_cast<std::size_t>(1 - operand)];
      if (!of(operand).region.empty() && !other.empty()) {
        partial_.sweep(operand, other, sums_.emplace_back().region);
      }
    }
    if (!paths[0].empty() && !paths[1].empty()) {
      Geometry loose;
      partial_.add_polylines(paths[0], paths[1], loose);
      sums_.push_back(resolve(loose, part_of(options_)));
    }
    // Sums of two points are made once: they are left out in the second call.
    move({of(0).region, of(0).polylines, of(0).points}, of(1).points);
    move({of(1).region, of(1).polylines, {}}, of(0).points);
  }

 private:
  [[nodiscard]] const Geometry& of(int operand) const {
    return *operands_[static_cast<std::size_t>(operand)];
  }
  void move(const Geometry& geometry, const std::vector<Point>& points) {
    if (geometry.empty() || points.empty()) return;
    std::uint64_t size = geometry.region.vertex_count() + geometry.points.size();
    for (const Polyline& polyline : geometry.polylines) size += polyline.size();
    const std::uint64_t most = options_.limits.max_segments;
    if (size > most / points.size()) {
      throw exceeded("Limits::max_segments", most,
                     "an operand moved by the points of the other has", "vertices");
    }
    for (const Point& by : points) {
      sums_.push_back(moved(geometry, by, partial_.cancellation()));
    }
  }

  std::array<const Geometry*, 2> operands_;
  const SumRequest& options_;
  PartialSums& partial_;
  std::vector<Geometry>& sums_;
};

/// Removes tight places that the sums of thin operands cover.
void uncover(const Geometry& sum, const Options& options, Geometry& tight) {
  if (!tight.has_thin_parts()) return;
  const std::array<Geometry, 2> both{Geometry{sum.region, {}, {}}, std::exchange(tight, {})};
  Geometry left = overlay::unite(both, options);
  // Paths were cut where the sum's thin part met them. They are joined now.
  tight = resolve({{}, std::move(left.polylines), std::move(left.points)}, part_of(options));
}

}  // namespace

void forget_origins(Region& region) {
  if (region.has_origins()) RegionAccess::clear_origins(region);
}

void sum_geometries(const Geometry& p, const Geometry& q, const SumRequest& options,
                    PartialSums& partial, Geometry& result) {
  result.region.clear();
  result.polylines.clear();
  result.points.clear();
  if (options.tight_places != nullptr) *options.tight_places = {};
  Reader first(0, p, options, partial);
  Reader second(1, q, options, partial);
  first.read();
  second.read();
  // A region that is moved by a point is a result, so it must be in canonical form.
  if (!second.geometry().points.empty()) first.resolve();
  if (!first.geometry().points.empty()) second.resolve();
  const Geometry& a = first.geometry();
  const Geometry& b = second.geometry();
  if (a.empty() || b.empty()) return;

  if (!a.region.empty() && !b.region.empty()) partial.add_regions(result.region);
  if (!first.is_as_given() || !second.is_as_given()) forget_origins(result.region);
  if (!a.has_thin_parts() && !b.has_thin_parts()) return;
  std::vector<Geometry> sums;
  ThinSums(a, b, options, partial, sums).run();
  if (options.tight_places != nullptr) {
    const Geometry thin = overlay::unite(sums, options);
    uncover(thin, options, *options.tight_places);
    sums.assign(1, thin);
  }
  if (!result.region.empty()) sums.push_back({std::move(result.region), {}, {}});
  partial.cancellation().look();
  result = sums.size() == 1 ? std::move(sums[0]) : overlay::unite(sums, options);
  forget_origins(result.region);
}

}  // namespace minksum
