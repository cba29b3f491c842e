#include "listed_rings.hpp"

#include <algorithm>
#include <numeric>
#include <string>

#include "minksum/measure.hpp"

namespace minksum::bench {
namespace {

constexpr std::int64_t kLargest = std::int64_t{1} << 30U;

int turn(const Point& a, const Point& b, const Point& c) {
  return ((b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x)).sign();
}

// Returns the ring without repeated and straight vertices. Removing a vertex can make its
// neighbours straight, so the walk steps back and tests them again.
Ring cleaned(Ring ring) {
  std::size_t i = 0;
  for (std::size_t fine = 0; ring.size() >= 3 && fine < ring.size();) {
    const std::size_t before = (i == 0 ? ring.size() : i) - 1;
    const std::size_t after = i + 1 == ring.size() ? 0 : i + 1;
    if (ring[i] != ring[after] && turn(ring[before], ring[i], ring[after]) != 0) {
      i = after;
      ++fine;
    } else {
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
      i = before < i ? before : before - 1;
      fine = 0;
    }
  }
  return ring;
}

// The turn at the least vertex of a ring tells its direction.
bool counter_clockwise(const Ring& ring) {
  std::size_t least = 0;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    if (ring[i].x < ring[least].x || (ring[i].x == ring[least].x && ring[i].y < ring[least].y)) {
      least = i;
    }
  }
  const std::size_t n = ring.size();
  return turn(ring[(least + n - 1) % n], ring[least], ring[(least + 1) % n]) > 0;
}

Box box_of(const Ring& ring) {
  Box box{ring[0], ring[0]};
  for (const Point& point : ring) {
    box.min = {std::min(box.min.x, point.x), std::min(box.min.y, point.y)};
    box.max = {std::max(box.max.x, point.x), std::max(box.max.y, point.y)};
  }
  return box;
}

// Returns whether some part of the other operand fits into a hole, as far as boxes tell.
bool matters(const Ring& hole, const std::vector<Box>& parts) {
  const Box box = box_of(hole);
  return std::any_of(parts.begin(), parts.end(), [&](const Box& part) {
    return part.max.x - part.min.x < box.max.x - box.min.x &&
           part.max.y - part.min.y < box.max.y - box.min.y;
  });
}

std::vector<Box> boxes_of_parts(const Region& region) {
  std::vector<Box> boxes;
  for (const std::size_t polygon : region.polygons()) {
    boxes.push_back(box_of(region.polygon(polygon).outer));
  }
  return boxes;
}

std::vector<Ring> rings_of(const Region& region, const std::vector<Box>& other) {
  std::vector<Ring> rings;
  const auto add = [&](const Ring& given, bool is_hole) {
    Ring ring = cleaned(given);
    if (counter_clockwise(ring) == is_hole) std::reverse(ring.begin(), ring.end());
    rings.push_back(std::move(ring));
  };
  for (const std::size_t i : region.polygons()) {
    const Polygon polygon = region.polygon(i);
    add(polygon.outer, false);
    for (const Ring& hole : polygon.holes) {
      if (matters(hole, other)) add(hole, true);
    }
  }
  return rings;
}

// Returns the least common denominator, or 0 if it is too large to be useful.
std::int64_t common_denominator(const std::vector<Ring>& rings, std::int64_t so_far) {
  for (const Ring& ring : rings) {
    for (const Point& point : ring) {
      for (const Rational* value : {&point.x, &point.y}) {
        const Rational denominator = value->denominator();
        if (so_far == 0 || denominator.bits() > 31) return 0;
        so_far = std::lcm(so_far, std::stoll(denominator.to_string()));
        if (so_far > kLargest) return 0;
      }
    }
  }
  return so_far;
}

ListedRings on_grid(const std::vector<Ring>& rings, const Point& corner, const Rational& scale) {
  ListedRings result;
  for (const Ring& ring : rings) {
    const auto first = static_cast<std::uint32_t>(result.sites.size());
    const auto size = static_cast<std::uint32_t>(ring.size());
    for (std::uint32_t i = 0; i < size; ++i) {
      const auto number = [&](const Rational& value, const Rational& least) {
        return static_cast<std::int32_t>(std::stoll(((value - least) * scale).to_decimal(0)));
      };
      result.sites.push_back({number(ring[i].x, corner.x), number(ring[i].y, corner.y)});
      result.next.push_back(first + (i + 1) % size);
      result.previous.push_back(first + (i + size - 1) % size);
    }
  }
  return result;
}

}  // namespace

ListedOperands listed_operands(const Region& p, const Region& q) {
  const std::vector<Ring> rings_p = rings_of(p, boxes_of_parts(q));
  const std::vector<Ring> rings_q = rings_of(q, boxes_of_parts(p));
  const Box box_p = *bounding_box(p);
  const Box box_q = *bounding_box(q);
  const Rational extent = std::max(std::max(box_p.max.x - box_p.min.x, box_p.max.y - box_p.min.y),
                                   std::max(box_q.max.x - box_q.min.x, box_q.max.y - box_q.min.y));
  // The corners of boxes are coordinates, so they are on the grid as well.
  const std::int64_t denominator = common_denominator(rings_q, common_denominator(rings_p, 1));
  ListedOperands result;
  result.exact = denominator != 0 && extent * Rational(denominator) <= Rational(kLargest);
  const Rational scale = result.exact ? Rational(denominator) : Rational(kLargest) / extent;
  result.p = on_grid(rings_p, box_p.min, scale);
  result.q = on_grid(rings_q, box_q.min, scale);
  return result;
}

}  // namespace minksum::bench
