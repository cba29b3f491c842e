#include "rounding/thin_sides.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "machine/cancellation.hpp"
#include "minksum/resolve.hpp"
#include "region/map_points.hpp"
#include "rounding/cells.hpp"
#include "rounding/round_region.hpp"

namespace minksum {
namespace {

Geometry resolved(const Geometry& geometry, const RoundRequest& request) {
  return resolve(geometry, part_of(request.options));
}

void add_ring(Region& region, const Ring& ring) {
  region.begin_polygon();
  region.begin_ring();
  for (const Point& p : ring) region.add_vertex(p.x, p.y);
}

// -- Outside -------------------------------------------------------------------------------------

class OutsideRounder {
 public:
  OutsideRounder(const Geometry& exact, const Target& target, const RoundRequest& request)
      : exact_(exact),
        target_(target),
        request_(request),
        cancellation_(request.options, Stage::kRounding) {
    swollen_.region = canonical(exact.region, request);
    for (const Polyline& line : exact.polylines) {
      for (std::size_t i = 0; i + 1 < line.size(); ++i) replace(line[i], line[i + 1]);
    }
    for (const Point& p : exact.points) replace(p, p);
  }

  Geometry run(RoundingReport& report) {
    constexpr int kMaxAttempts = 4;
    for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
      Geometry result = kept_;
      result.region = rounded_area(report);
      if (result.has_thin_parts()) result = resolved(result, request_);
      if (is_on_target(result, target_, request_.options)) return result;
      swell_pieces_off_target(result);
    }
    report = RoundingReport{};
    return round_by_snapping(exact_, target_, request_, report);
  }

 private:
  /// Replaces a segment, or a point if both ends are the same.
  void replace(const Point& a, const Point& b) {
    cancellation_.check(64 * (work_of(a) + work_of(b)));
    const Cell cell_a = cell_around(a, target_);
    const Cell cell_b = cell_around(b, target_);
    const Ring hull = hull_of(cell_a, cell_b);
    const double far = std::max(farthest_corner(cell_a, a), farthest_corner(cell_b, b));
    if (hull.size() > 2) {
      swell(a, b, hull, far);
      return;
    }
    if (hull.size() == 2) {
      kept_.polylines.push_back(hull);
    } else {
      kept_.points.push_back(hull[0]);
    }
    longest_extension_ = std::max(longest_extension_, far);
  }

  void swell(const Point& a, const Point& b, const Ring& hull, double far) {
    if (a == b) {
      swollen_.points.push_back(a);
    } else {
      swollen_.polylines.push_back({a, b});
    }
    add_ring(hulls_, hull);
    farthest_ = std::max(farthest_, far);
  }

  /// Replaces parts of kept segments that are left outside the rounded region, if an end or a bend
  /// is not in the target.
  void swell_pieces_off_target(const Geometry& result) {
    for (const Polyline& line : result.polylines) {
      for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Point& a = line[i];
        const Point& b = line[i + 1];
        cancellation_.check(64 * (work_of(a) + work_of(b)));
        if (is_on_target(a, target_) && is_on_target(b, target_)) continue;
        const Cell cell_a = thick_cell(a);
        const Cell cell_b = thick_cell(b);
        swell(a, b, hull_of(cell_a, cell_b),
              std::max(farthest_corner(cell_a, a), farthest_corner(cell_b, b)));
      }
    }
  }
  /// Returns the cell of an end. An end in the target needs nothing around it.
  [[nodiscard]] Cell thick_cell(const Point& p) const {
    if (is_on_target(p, target_)) return {p, p};
    return thickened(cell_around(p, target_), target_);
  }

  /// Returns the region, united with all that swells, rounded.
  Region rounded_area(RoundingReport& report) const {
    const bool swollen = swollen_.has_thin_parts();
    report = RoundingReport{};
    Region result;
    double far = longest_extension_;
    const Region area = swollen ? united() : swollen_.region;
    if (area.empty()) {
      report.exact = true;
    } else if (auto rounded = round_by_vertices(area, target_, request_, report)) {
      result = std::move(*rounded);
      if (swollen) far = rounded_up(far + farthest_);
    } else {
      result = round_by_snapping(swollen_, target_, request_, report).region;
    }
    if (swollen) report.exact = false;
    if (far != 0) {
      report.exact = false;
      report.largest_move = rounded_up(report.largest_move + far);
      report.bound = rounded_up(report.bound + cell_bound(exact_, target_, request_.options));
    }
    return result;
  }

  [[nodiscard]] Region united() const {
    Geometry all;
    const Region& region = swollen_.region;
    Cancellation cancellation(request_.options, Stage::kRounding);
    for (const Region* from : {&region, &hulls_}) {
      for (std::size_t ring = 0; ring < from->ring_count(); ++ring) {
        // Each ring may be a polygon of its own, because only winding numbers count.
        all.region.begin_polygon();
        all.region.begin_ring();
        cancellation.check(from->vertices_of(ring).size() * 16);
        for (const std::size_t v : from->vertices_of(ring)) {
          all.region.add_vertex(from->exact_x(v), from->exact_y(v));
        }
      }
    }
    Options resolving = part_of(request_.options);
    resolving.fill = FillRule::kPositive;
    resolving.regularize = true;
    return resolve(all, resolving).region;
  }

  const Geometry& exact_;
  const Target& target_;
  const RoundRequest& request_;
  Cancellation cancellation_;
  Geometry kept_;     ///< thin parts of the target
  Geometry swollen_;  ///< the exact region, and exact thin parts that hulls replace
  Region hulls_;
  double farthest_ = 0;           ///< largest distance of a hull from what it replaces
  double longest_extension_ = 0;  ///< largest extent of kept parts beyond what they replace
};

// -- Inside --------------------------------------------------------------------------------------

class InnerParts {
 public:
  InnerParts(const Target& target, const Options& options)
      : target_(target), cancellation_(options, Stage::kRounding) {}

  /// Adds the parts in the target. Returns whether nothing is lost.
  bool add(const Geometry& exact, Geometry& result) {
    bool all = true;
    for (const Polyline& line : exact.polylines) {
      for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        cancellation_.check(64 * work_of(line[i]));
        all = add_segment(line[i], line[i + 1], result) && all;
      }
    }
    for (const Point& p : exact.points) {
      cancellation_.check(64 * work_of(p));
      all = add_point(p, result) && all;
    }
    return all;
  }

 private:
  bool add_point(const Point& p, Geometry& result) const {
    if (!is_on_target(p, target_)) return false;
    result.points.push_back(p);
    return true;
  }

  bool add_segment(const Point& a, const Point& b, Geometry& result) const {
    if (is_on_target(a, target_) && is_on_target(b, target_)) {
      result.polylines.push_back({a, b});
      return true;
    }
    if (!add_part_along_axis(a, b, result)) {
      add_point(a, result);
      add_point(b, result);
    }
    return false;
  }

  /// Returns false if the segment is not along an axis.
  bool add_part_along_axis(const Point& a, const Point& b, Geometry& result) const {
    if (a.x != b.x && a.y != b.y) return false;
    const bool forward = a.x < b.x || a.y < b.y;
    const Cell first = cell_around(forward ? a : b, target_);
    const Cell last = cell_around(forward ? b : a, target_);
    // The cells have no width across the segment if it lies on a line of the target.
    const Point& from = first.high;
    const Point& to = last.low;
    const bool across = a.y == b.y ? first.low.y == first.high.y : first.low.x == first.high.x;
    if (!across || from.x > to.x || from.y > to.y) return true;
    if (from == to) {
      result.points.push_back(from);
    } else {
      result.polylines.push_back({from, to});
    }
    return true;
  }

  const Target& target_;
  Cancellation cancellation_;
};

}  // namespace

bool is_on_target(const Geometry& geometry, const Target& target, const Options& options) {
  Cancellation cancellation(options, Stage::kRounding);
  const RoundedVertices vertices = round_vertices(geometry.region, target, cancellation);
  bool all = std::none_of(vertices.begin(), vertices.end(),
                          [](const RoundedVertex& v) { return v.moved(); });
  for_each_thin_point(geometry, [&](const Point& p) {
    cancellation.check(16 * work_of(p));
    all = all && is_on_target(p, target);
  });
  return all;
}

double cell_bound(const Geometry& geometry, const Target& target, const Options& options) {
  Cancellation cancellation(options, Stage::kRounding);
  RoundedVertices corners;
  for_each_thin_point(geometry, [&](const Point& p) {
    cancellation.check(64 * work_of(p));
    const Cell cell = cell_around(p, target);
    for (const Point* corner : {&cell.low, &cell.high}) {
      RoundedVertex& place = corners.emplace_back();
      place.x = nearest_place(corner->x, target);
      place.y = nearest_place(corner->y, target);
    }
  });
  return diagonal(2 * half_place(corners, target));
}

Geometry round_outside(const Geometry& geometry, const Target& target, const RoundRequest& request,
                       RoundingReport& report) {
  return OutsideRounder(geometry, target, request).run(report);
}

Geometry round_inside(const Geometry& geometry, const Target& target, const RoundRequest& request,
                      RoundingReport& report) {
  Geometry result;
  result.region = round_region(geometry.region, target, request, report);
  if (!InnerParts(target, request.options).add(geometry, result)) report.exact = false;
  return result.has_thin_parts() ? resolved(result, request) : result;
}

}  // namespace minksum
