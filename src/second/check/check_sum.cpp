// Checks a sum: its validity, points, and the whole by the second method.
#include <algorithm>
#include <optional>
#include <random>
#include <utility>

#include "minksum/check.hpp"
#include "minksum/resolve.hpp"
#include "minksum/testing.hpp"
#include "overlay/boolean.hpp"
#include "region/boxes.hpp"
#include "region/point_arithmetic.hpp"
#include "second/check/placed_operand.hpp"

namespace minksum {
namespace checking {
namespace {

constexpr std::size_t kExamples = 10;
constexpr std::size_t kFaults = 100;
// Points beside the middle of an edge are tested at the edge's length divided by this.
constexpr std::int64_t kBeside = std::int64_t{1} << 20;

/// Returns the square of the points at most `reach` > 0 away from the origin in x and in y.
Geometry square_around_origin(const Rational& reach) {
  return {as_region(widened(Box{}, reach)), {}, {}};
}

/// The second method's settings, for a part of the check.
SumSettings by_second_method(const Options& options) {
  SumSettings second{part_of(options)};
  second.limits = {};
  second.method = Method::kSigned;
  return second;
}

/// The set of points at most `within` away from `geometry` in x and in y. By the second method: the
/// one that is checked must not tell what it may be off.
Geometry widened(const Geometry& geometry, const Rational& within, const Options& options) {
  return minkowski_sum(geometry, square_around_origin(within), by_second_method(options));
}

/// Asks whether result and sum agree at points.
class Witness {
 public:
  Witness(const Geometry& result, const Geometry& p, const Geometry& q, const Rational& within,
          Cancellation& cancellation, SumCheck& check)
      : cancellation_(cancellation),
        result_(result, part_of(cancellation.options())),
        sum_(p, q, cancellation),
        check_(check) {
    if (within.sign() == 0) return;
    near_result_.emplace(result, square_around_origin(within), cancellation);
    near_sum_.emplace(p, widened(q, within, cancellation.options()), cancellation);
  }

  void ask(const Point& x) {
    ++check_.points;
    cancellation_.check(work_of(x));
    const bool in_result = result_.locate(x) != Location::kOutside;
    if (in_result == sum_.in_sum(x)) return;
    if (near_sum_ && (in_result ? near_sum_ : near_result_)->in_sum(x)) return;
    ++check_.disagreements;
    if (check_.examples.size() < kExamples) check_.examples.push_back({x, in_result});
  }

 private:
  Cancellation& cancellation_;
  PointLocator result_;
  PlacedOperand sum_;
  std::optional<PlacedOperand> near_result_;  ///< tells if x is near the result, if that may be off
  std::optional<PlacedOperand> near_sum_;     ///< tells if x is near the sum, likewise
  SumCheck& check_;
};

// A lost hole, a shifted vertex or a spurious ring shows next to an edge.
void ask_near_edges(const Region& region, std::uint64_t edges, Witness& witness) {
  const std::uint64_t count = region.vertex_count();
  const auto turn = [&](std::uint64_t v) { return v * edges / count; };
  for_each_edge(region, [&](std::size_t v, std::size_t w) {
    if (edges < count && turn(v) == turn(v + 1)) return;
    const Point a = region.point(v);
    const Point b = region.point(w);
    const Rational dx = b.x - a.x;
    const Rational dy = b.y - a.y;
    const Point middle{(a.x + b.x) / Rational(2), (a.y + b.y) / Rational(2)};
    const Rational part(1, kBeside);
    witness.ask({middle.x + dy * part, middle.y - dx * part});
    witness.ask({middle.x - dy * part, middle.y + dx * part});
    witness.ask(a);
  });
}

void ask_thin_parts(const Geometry& geometry, Witness& witness) {
  for (const Polyline& line : geometry.polylines) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      witness.ask(line[i]);
      witness.ask(
          {(line[i].x + line[i + 1].x) / Rational(2), (line[i].y + line[i + 1].y) / Rational(2)});
    }
  }
  for (const Point& point : geometry.points) witness.ask(point);
}

/// Returns a random point of a box, on a grid of 2^53 lines.
Point pick(const Box& box, std::mt19937_64& random) {
  const auto pick_one = [&random](const Rational& low, const Rational& high) {
    const auto at = static_cast<std::int64_t>(random() >> 11);
    return low + (high - low) * Rational(at, std::int64_t{1} << 53);
  };
  Rational at_x = pick_one(box.min.x, box.max.x);
  return {std::move(at_x), pick_one(box.min.y, box.max.y)};
}

// Asks in the box of the sum, made wider by a twentieth on each side.
void ask_at_random(const Geometry& p, const Geometry& q, const CheckOptions& how,
                   Cancellation& cancellation, Witness& witness) {
  if (p.empty() || q.empty()) return;
  std::mt19937_64 random(how.seed);
  const Box of_p = *bounding_box(p, cancellation);
  const Box of_q = *bounding_box(q, cancellation);
  const Box sum{plus(of_p.min, of_q.min), plus(of_p.max, of_q.max)};
  const Point size = minus(sum.max, sum.min);
  const Point more{size.x / Rational(20), size.y / Rational(20)};
  const Box wider{minus(sum.min, more), plus(sum.max, more)};
  for (std::uint64_t i = 0; i < how.samples; ++i) witness.ask(pick(wider, random));
}

constexpr std::size_t kMostRooms = 10'000;
constexpr std::size_t kMostTries = 1'000'000;

/// Adds boxes of placements at which a part of one operand is within the box of a hole of the
/// other. A hole of the sum is in one of these, or surrounded by several parts.
void add_rooms(const Geometry& with_holes, const Geometry& other, Cancellation& cancellation,
               std::vector<Box>& rooms) {
  const auto box_of = [&](const Geometry& part) { return *bounding_box(part, cancellation); };
  std::vector<Box> parts;
  for (const std::size_t polygon : other.region.polygons()) {
    parts.push_back(box_of({Region(Polygon{other.region.polygon(polygon).outer, {}}), {}, {}}));
  }
  for (const Polyline& line : other.polylines) parts.push_back(box_of({{}, {line}, {}}));
  for (const Point& point : other.points) parts.push_back(box_of({{}, {}, {point}}));
  std::size_t tries = 0;
  for (const std::size_t polygon : with_holes.region.polygons()) {
    for (const Ring& hole : with_holes.region.polygon(polygon).holes) {
      const Box space = box_of({Region(Polygon{hole, {}}), {}, {}});
      for (const Box& part : parts) {
        cancellation.check(8 * work_of_product(part.min.x.bits()));
        if (rooms.size() == kMostRooms || ++tries > kMostTries) return;
        const Box room{plus(space.min, part.max), plus(space.max, part.min)};
        if (room.min.x < room.max.x && room.min.y < room.max.y) rooms.push_back(room);
      }
    }
  }
}

// Random points in the sum's box miss a hole that is small beside the sum. So do points near the
// edges of a result that lacks it.
void ask_in_holes(const Geometry& p, const Geometry& q, const CheckOptions& how,
                  Cancellation& cancellation, Witness& witness) {
  std::vector<Box> rooms;
  add_rooms(p, q, cancellation, rooms);
  add_rooms(q, p, cancellation, rooms);
  if (rooms.empty()) return;
  std::mt19937_64 random(how.seed);
  for (std::uint64_t i = 0; i < how.samples; ++i) {
    witness.ask(pick(rooms[i * rooms.size() / how.samples], random));
  }
}

/// Returns a point inside the first ring of a region: the middle of the lowest part of a vertical
/// section.
Point inner_point(const Region& region, Cancellation& cancellation) {
  const IndexRange ring = region.vertices_of(region.rings_of(0).front());
  Rational first = region.exact_x(ring.front());
  for (const std::size_t v : ring) first = std::min(first, region.exact_x(v));
  std::optional<Rational> second;
  for (const std::size_t v : ring) {
    const Rational x = region.exact_x(v);
    cancellation.check(2 * work_of_product(x.bits()));
    if (first < x && (!second || x < *second)) second = x;
  }
  const Rational x = (first + *second) / Rational(2);
  std::vector<Rational> heights;
  for_each_edge(region, [&](std::size_t v, std::size_t w) {
    const Point a = region.point(v);
    const Point b = region.point(w);
    cancellation.check(8 * work_of(a));
    if ((a.x < x) == (b.x < x)) return;
    heights.push_back(a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x));
  });
  std::sort(heights.begin(), heights.end());
  return {x, (heights[0] + heights[1]) / Rational(2)};
}

Difference difference_of(const Region& part, Cancellation& cancellation) {
  Difference result;
  double largest = -1;
  for (const std::size_t polygon : part.polygons()) {
    const Region one(part.polygon(polygon));
    const double its_area = approximate_area(one, cancellation.options());
    cancellation.check(64);
    result.area += its_area;
    if (its_area <= largest) continue;
    largest = its_area;
    result.at = inner_point(one, cancellation);
  }
  return result;
}

bool same_thin_parts(const Geometry& a, const Geometry& b) {
  return a.polylines == b.polylines && a.points == b.points;
}

void prove(const Geometry& result, const Geometry& p, const Geometry& q, const CheckOptions& how,
           Cancellation& cancellation, SumCheck& check) {
  const Options& options = cancellation.options();
  SumSettings second = by_second_method(options);
  second.limits = how.proof;
  Geometry sum;
  try {
    sum = minkowski_sum(p, q, second);
  } catch (const Error& error) {
    if (error.code() == ErrorCode::kLimitExceeded) return;
    throw;
  }
  check.sum_area = approximate_area(sum.region, options);
  check.missing =
      difference_of(overlay::subtract(sum.region, result.region, options), cancellation);
  check.surplus =
      difference_of(overlay::subtract(result.region, sum.region, options), cancellation);
  if (how.within.sign() == 0) {
    check.thin_parts_differ = !same_thin_parts(sum, result);
    const bool equal = sum.region == result.region && !check.thin_parts_differ;
    check.proof = equal ? Proof::kHolds : Proof::kRefuted;
    return;
  }
  // Thin parts grow to areas as well, so areas decide for them, too.
  const Geometry wide_sum = widened(sum, how.within, options);
  const Geometry wide_result = widened(result, how.within, options);
  const Geometry both_sums[] = {wide_sum, result};
  const Geometry both_results[] = {wide_result, sum};
  const bool near = overlay::unite(both_sums, options) == wide_sum &&
                    overlay::unite(both_results, options) == wide_result;
  check.proof = near ? Proof::kHolds : Proof::kRefuted;
}

}  // namespace
}  // namespace checking

SumCheck check_sum(const Geometry& result, const Geometry& p, const Geometry& q,
                   const CheckOptions& how, const Options& options) {
  using namespace checking;
  if (how.within.sign() < 0) {
    refuse_input("how far a result may be off must not be negative");
  }
  const auto operand = [&options](const Geometry& geometry, int index) {
    return resolve(geometry, options, index);
  };
  const Geometry first = operand(p, 0);
  const Geometry second = operand(q, 1);

  SumCheck check;
  Cancellation cancellation(options, Stage::kChecking);
  check.faults = validate(result.region, kFaults, options);
  const Geometry found = resolve(result, part_of(options));
  if (check.faults.empty() && found.region.polygon_count() != result.region.polygon_count()) {
    check.faults.push_back({"rings that touch cut the inside of a polygon in pieces", {}, {}, {}});
  }
  check.result_area = approximate_area(found.region, options);
  {
    Witness witness(found, first, second, how.within, cancellation, check);
    ask_near_edges(found.region, how.edges, witness);
    ask_thin_parts(found, witness);
    ask_at_random(first, second, how, cancellation, witness);
    ask_in_holes(first, second, how, cancellation, witness);
  }
  prove(found, first, second, how, cancellation, check);
  return check;
}

}  // namespace minksum
