#include "minksum/offset.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "machine/cancellation.hpp"
#include "machine/exceeded.hpp"
#include "minksum/error.hpp"
#include "minksum/morphology.hpp"
#include "minksum/resolve.hpp"
#include "operations/offset/make_disc.hpp"
#include "operations/offset/outline.hpp"
#include "overlay/boolean.hpp"

namespace minksum {
namespace {

bool all_round(const OffsetOptions& shape) {
  return shape.join == Join::kRound && shape.cap == Cap::kRound;
}

void require_sense(const OffsetOptions& shape) {
  require_enumerator(shape.join, Join::kBevel, "join");
  require_enumerator(shape.cap, Cap::kSquare, "cap");
  require_enumerator(shape.side, RoundingSide::kInside, "side");
  if (shape.tolerance && shape.tolerance->sign() <= 0) refuse_input("a tolerance must be positive");
  if (shape.miter_limit < Rational(1)) refuse_input("a miter limit must be at least 1");
  if (shape.side != RoundingSide::kNearest && !all_round(shape)) {
    refuse_input("a side can be chosen for round joins and caps only");
  }
}

/// Returns the side of the disc for a set that shrinks: a larger disc leaves less of the set.
RoundingSide swapped(RoundingSide side) {
  if (side == RoundingSide::kNearest) return side;
  return side == RoundingSide::kOutside ? RoundingSide::kInside : RoundingSide::kOutside;
}

/// Computes one offset, by `radius` outwards or inwards.
class Offset {
 public:
  Offset(const Rational& distance, const OffsetOptions& shape, const Options& options)
      : shape_(shape),
        options_(options),
        inwards_(distance.sign() < 0),
        radius_(inwards_ ? -distance : distance),
        tolerance_(shape.tolerance ? std::min(*shape.tolerance, radius_ / Rational(2))
                                   : radius_ / Rational(1000)) {}

  [[nodiscard]] Geometry run(const Geometry& a) const {
    Options reading = part_of(options_);
    reading.fill = options_.fill;
    reading.regularize = inwards_ || options_.regularize;
    if (all_round(shape_)) {
      // The disc is read by the same rule as A, and its ring is counter-clockwise.
      const bool reads_disc = options_.fill != FillRule::kNegative;
      return reads_disc ? round(a, options_.fill)
                        : round(resolve(a, reading, 0), FillRule::kAutomatic);
    }
    Geometry set = resolve({a.region, {}, {}}, reading, 0);
    const Corners corners(radius_, tolerance_, shape_);
    Cancellation cancellation(options_);
    Region outlines;
    if (shape_.join != Join::kRound) add_boundary(set.region, corners, cancellation, outlines);
    if (!reading.regularize) {
      for (const auto& lines : {set.polylines, a.polylines}) {
        for (const Polyline& line : lines) add_polyline(line, corners, cancellation, outlines);
      }
      for (const auto& points : {set.points, a.points}) {
        for (const Point& point : points) add_point(point, cancellation, outlines);
      }
    }
    require_few(outlines);
    const FillRule rule = inwards_ ? FillRule::kNegative : FillRule::kPositive;
    Options winding = part_of(options_);
    winding.fill = rule;
    winding.regularize = true;
    Geometry result = resolve({std::move(outlines), {}, {}}, winding);
    if (shape_.join != Join::kRound) return result;
    const std::array<Geometry, 2> both{round({std::move(set.region), {}, {}}, FillRule::kAutomatic),
                                       std::move(result)};
    return both[1].empty() ? both[0] : overlay::unite(both, options_);
  }

 private:
  [[nodiscard]] Geometry round(const Geometry& a, FillRule fill) const {
    const RoundingSide side = inwards_ ? swapped(shape_.side) : shape_.side;
    Cancellation cancellation(options_);
    const Geometry element{make_disc(radius_, tolerance_, side, cancellation), {}, {}};
    Options options = part_of(options_);
    options.fill = fill;
    options.regularize = options_.regularize;
    return inwards_ ? erode(a, element, options) : dilate(a, element, options);
  }

  void add_boundary(const Region& region, const Corners& corners, Cancellation& cancellation,
                    Region& outlines) const {
    for (std::size_t ring = 0; ring < region.ring_count(); ++ring) {
      std::vector<Point> path;
      for (const std::size_t v : region.vertices_of(ring)) path.push_back(region.point(v));
      if (inwards_) std::reverse(path.begin(), path.end());
      add_outline(path, {}, corners, cancellation, outlines);
    }
  }

  void add_polyline(const Polyline& line, const Corners& corners, Cancellation& cancellation,
                    Region& outlines) const {
    std::vector<Point> path;
    for (const Point& point : line) {
      if (path.empty() || !(path.back() == point)) path.push_back(point);
    }
    if (path.empty()) return;
    if (path.size() == 1) return add_point(path[0], cancellation, outlines);
    std::vector<Point> back(path.rbegin(), path.rend());
    // A closed polyline has one path there and one back. An open one has one path there and back.
    if (path.front() == path.back()) {
      for (std::vector<Point>* const way : {&path, &back}) {
        way->pop_back();
        add_outline(*way, {}, corners, cancellation, outlines);
      }
      return;
    }
    const std::array<std::size_t, 2> ends{0, path.size() - 1};
    path.insert(path.end(), back.begin() + 1, back.end() - 1);
    add_outline(path, ends, corners, cancellation, outlines);
  }

  void add_point(const Point& point, Cancellation& cancellation, Region& outlines) const {
    if (shape_.cap == Cap::kButt) return;
    const Rational& r = radius_;
    Ring ring{{-r, -r}, {r, -r}, {r, r}, {-r, r}};
    if (shape_.cap == Cap::kRound) ring = disc(r, tolerance_).polygon(0).outer;
    cancellation.check(ring.size() * work_of(point));
    outlines.begin_polygon();
    outlines.begin_ring();
    for (const Point& vector : ring) outlines.add_vertex(point.x + vector.x, point.y + vector.y);
  }

  void require_few(const Region& outlines) const {
    const std::uint64_t most = options_.limits.max_segments;
    if (outlines.vertex_count() <= most) return;
    throw exceeded("Limits::max_segments", most, "the offset's outlines have", "segments");
  }

  const OffsetOptions& shape_;
  const Options& options_;
  bool inwards_;
  Rational radius_;
  Rational tolerance_;
};

}  // namespace

const char* to_string(Join join) {
  static constexpr std::array kNames{"round", "miter", "square", "bevel"};
  return name_of(join, kNames);
}

const char* to_string(Cap cap) {
  static constexpr std::array kNames{"round", "butt", "square"};
  return name_of(cap, kNames);
}

Geometry offset(const Geometry& a, const Rational& distance, const OffsetOptions& shape,
                const Options& options) {
  require_sense(shape);
  if (distance.sign() == 0) return resolve(a, options, 0);
  return Offset(distance, shape, options).run(a);
}

}  // namespace minksum
