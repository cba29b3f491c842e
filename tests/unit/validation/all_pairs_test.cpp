// Compares validation with a test of all pairs of edges and of rings, on small grids, where nearly
// everything coincides.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "minksum/validity.hpp"
#include "support/random.hpp"
#include "support/shapes.hpp"

namespace minksum {
namespace {

using test::Outline;
using test::Vertex;
using Polygons = std::vector<std::vector<Outline>>;
using TextSet = std::set<std::string>;

std::int64_t turn(const Vertex& a, const Vertex& b, const Vertex& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}
int sign(std::int64_t value) { return (value > 0 ? 1 : 0) - (value < 0 ? 1 : 0); }
/// Tells whether v lies on the closed segment.
bool on(const Vertex& a, const Vertex& b, const Vertex& v) {
  return turn(a, b, v) == 0 && std::min(a.x, b.x) <= v.x && v.x <= std::max(a.x, b.x) &&
         std::min(a.y, b.y) <= v.y && v.y <= std::max(a.y, b.y);
}

/// Drops repeated and straight vertices. Returns false if the ring is no ring by itself.
bool clean(Outline& ring) {
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  Outline kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vertex& a = ring[(i + ring.size() - 1) % ring.size()];
    const Vertex& b = ring[i];
    const Vertex& c = ring[(i + 1) % ring.size()];
    if (turn(a, b, c) != 0) {
      kept.push_back(b);
    } else if ((b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y) <= 0) {
      return false;
    }
  }
  ring = kept;
  return ring.size() >= 3;
}

/// A vertex of a cleaned ring, with its neighbours; its edge leads to `after`.
struct Corner {
  Vertex before, at, after;
  std::size_t polygon, ring, index, ring_size, ring_id;

  [[nodiscard]] bool is_next_to(const Corner& other) const {
    const std::size_t apart = index > other.index ? index - other.index : other.index - index;
    return ring_id == other.ring_id && (apart == 1 || apart + 1 == ring_size);
  }
};
std::vector<Corner> corners_of(const Polygons& polygons) {
  std::vector<Corner> corners;
  std::size_t id = 0;
  for (std::size_t p = 0; p < polygons.size(); ++p) {
    for (std::size_t r = 0; r < polygons[p].size(); ++r, ++id) {
      const Outline& ring = polygons[p][r];
      const std::size_t n = ring.size();
      for (std::size_t i = 0; i < n; ++i) {
        corners.push_back({ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n], p, r, i, n, id});
      }
    }
  }
  return corners;
}

std::string text(const char* what, const Point& at) { return to_string(Fault{what, {}, {}, at}); }
Point point(const Vertex& v) { return {v.x, v.y}; }
Point crossing(const Corner& e, const Corner& f) {
  const std::int64_t over = turn(e.at, e.after, f.at);
  const std::int64_t under = over - turn(e.at, e.after, f.after);
  const Rational part(over, under);
  return {Rational(f.at.x) + part * Rational(f.after.x - f.at.x),
          Rational(f.at.y) + part * Rational(f.after.y - f.at.y)};
}

/// Tells whether a direction from the corner points strictly into the sector on the left.
bool into_left(const Corner& c, const Vertex& far) {
  const bool left_of_out = turn(c.at, c.after, far) > 0;
  const bool left_of_in = turn(c.before, c.at, far) > 0;
  return turn(c.before, c.at, c.after) > 0 ? left_of_out && left_of_in : left_of_out || left_of_in;
}

/// Lists what is wrong with pairs of edges and vertices. `overlaps` tells whether edges overlap, so
/// that it is not defined where rings change sides.
TextSet faults_of_pairs(const std::vector<Corner>& corners, bool& overlaps) {
  TextSet faults;
  for (const Corner& e : corners) {
    for (const Corner& f : corners) {
      if (&e == &f || e.is_next_to(f)) continue;
      const int f0 = sign(turn(e.at, e.after, f.at));
      const int f1 = sign(turn(e.at, e.after, f.after));
      const int e0 = sign(turn(f.at, f.after, e.at));
      const int e1 = sign(turn(f.at, f.after, e.after));
      if (f0 * f1 < 0 && e0 * e1 < 0) faults.insert(text("edges cross", crossing(e, f)));
      if (f0 == 0 && f1 == 0) {
        const auto before = [](const Vertex& a, const Vertex& b) {
          return a.x != b.x ? a.x < b.x : a.y < b.y;
        };
        const Vertex low =
            std::max(std::min(e.at, e.after, before), std::min(f.at, f.after, before), before);
        const Vertex high =
            std::min(std::max(e.at, e.after, before), std::max(f.at, f.after, before), before);
        if (before(low, high)) {
          overlaps = true;
          faults.insert(text("edges overlap", point(low)));
        }
      }
    }
    for (const Corner& v : corners) {
      if (&e == &v || !on(e.at, e.after, v.at)) continue;
      if (e.ring_id == v.ring_id) {
        if (e.after == v.at && e.is_next_to(v)) continue;
        faults.insert(text("ring touches itself", point(v.at)));
      } else if (e.at == v.at) {
        if (into_left(e, v.after) != into_left(e, v.before)) {
          faults.insert(text("rings cross", point(v.at)));
        }
      } else if (!(e.after == v.at)) {
        if (turn(e.at, e.after, v.before) * turn(e.at, e.after, v.after) < 0) {
          faults.insert(text("rings cross", point(v.at)));
        }
      }
    }
  }
  return faults;
}

/// Tells whether a ring that crosses no other lies inside of `outer`.
bool lies_in(const Outline& inner, const Outline& outer) {
  // Of the points that cut an edge into 97 parts, some lie on no edge of a small grid.
  constexpr std::int64_t kParts = 97;
  Outline fine = outer;
  for (Vertex& v : fine) v = {v.x * kParts, v.y * kParts};
  for (std::int64_t k = 1; k < kParts; ++k) {
    const Vertex at{inner[0].x * (kParts - k) + inner[1].x * k,
                    inner[0].y * (kParts - k) + inner[1].y * k};
    bool inside = false;
    bool touches = false;
    for (std::size_t i = 0; i < fine.size(); ++i) {
      const Vertex& a = fine[i];
      const Vertex& b = fine[(i + 1) % fine.size()];
      touches |= on(a, b, at);
      if ((a.y > at.y) != (b.y > at.y)) inside ^= (turn(a, b, at) > 0) == (b.y > a.y);
    }
    if (!touches) return inside;
  }
  ADD_FAILURE() << "all points of an edge lie on a ring";
  return false;
}
TextSet faults_of_places(const Polygons& polygons) {
  TextSet faults;
  for (std::size_t p = 0; p < polygons.size(); ++p) {
    for (std::size_t r = 0; r < polygons[p].size(); ++r) {
      const Outline& ring = polygons[p][r];
      if (r > 0 && !lies_in(ring, polygons[p][0]))
        faults.insert("hole lies outside its outer ring");
      for (std::size_t q = 0; q < polygons.size(); ++q) {
        bool in_hole = false;
        for (std::size_t h = 1; h < polygons[q].size(); ++h) {
          if (p != q || r != h) in_hole |= lies_in(ring, polygons[q][h]);
        }
        if (r > 0 && p == q && in_hole) faults.insert("hole lies inside another hole");
        if (r == 0 && p != q && lies_in(ring, polygons[q][0]) && !in_hole) {
          faults.insert("polygons overlap");
        }
      }
    }
  }
  return faults;
}

Polygons random_polygons(test::Random& random) {
  const int side = random.between(3, 8);
  // Rings in the same few places touch, and far ones keep a region valid.
  const auto ring = [&] {
    Outline points;
    const std::int64_t x = random.below(3) == 0 ? random.between(0, 4) * 10 : 0;
    if (random.below(3) == 0) {
      const int size = random.between(1, 4);
      const Vertex low{x + random.below(side), random.below(side)};
      return Outline{
          low, {low.x + size, low.y}, {low.x + size, low.y + size}, {low.x, low.y + size}};
    }
    for (int i = random.below(2) == 0 ? 3 : random.between(3, 9); i > 0; --i) {
      points.push_back({x + random.between(0, side), random.between(0, side)});
    }
    return points;
  };
  Polygons polygons(static_cast<std::size_t>(random.between(1, random.below(4) == 0 ? 12 : 3)));
  for (auto& polygon : polygons) {
    for (int i = random.below(2) == 0 ? 1 : random.between(1, 4); i > 0; --i) {
      polygon.push_back(ring());
    }
  }
  return polygons;
}

TEST(AllPairs, AgreeWithTheSweep) {
  int valid = 0;
  int misplaced = 0;
  int touching = 0;
  for (std::uint64_t seed = 1; seed <= 10000; ++seed) {
    test::Random random(seed);
    Polygons polygons = random_polygons(random);
    const Region region = test::make_region(polygons);
    bool rings_are_good = true;
    for (auto& polygon : polygons) {
      for (Outline& ring : polygon) rings_are_good &= clean(ring);
    }
    if (!rings_are_good) continue;
    bool overlaps = false;
    TextSet expected = faults_of_pairs(corners_of(polygons), overlaps);
    touching += expected.size() == 1 ? 1 : 0;
    const bool only_places = expected.empty();
    if (only_places) expected = faults_of_places(polygons);
    TextSet found;
    for (const Fault& fault : validate(region, 100'000)) {
      found.insert(only_places ? fault.message : to_string(fault));
    }
    if (overlaps) {
      const auto depends = [](const std::string& t) { return !t.starts_with("edges"); };
      std::erase_if(expected, depends);
      std::erase_if(found, depends);
    }
    ASSERT_EQ(found, expected) << "seed " << seed << ": " << test::to_text(region);
    valid += expected.empty() ? 1 : 0;
    misplaced += only_places && !expected.empty() ? 1 : 0;
  }
  EXPECT_GT(valid, 500);
  EXPECT_GT(misplaced, 50);
  EXPECT_GT(touching, 100);
}

}  // namespace
}  // namespace minksum
