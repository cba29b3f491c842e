#include "support/generators.hpp"

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "reference/validity.hpp"
#include "support/polygon_kinds.hpp"
#include "support/shapes.hpp"

namespace minksum::test {
namespace {

int random_size(Random& random) {
  static constexpr int kSizes[] = {2, 3, 4, 5, 6, 8, 12, 24};
  return kSizes[random.below(8)];
}

Region star_of(Random& random) {
  Region star = spiky_star(random, random.between(3, 6), 24);
  return reference::validity_fault(star).empty() ? star : random_triangle(random, 8);
}

struct Kind {
  const char* name;
  Region (*make)(Random&);
};

// The grid has at least 3 by 3 lines, so that it has enough points.
int count_for(Random& random, int size) { return random.between(4, std::min(10, size * size + 2)); }

constexpr Kind kSinglePart[] = {
    {"triangle", [](Random& r) { return random_triangle(r, random_size(r)); }},
    {"star-shaped",
     [](Random& r) {
       const int size = random_size(r);
       return random_star_shaped(r, count_for(r, size), size);
     }},
    {"2-opt",
     [](Random& r) {
       const int size = random_size(r);
       return random_two_opt(r, count_for(r, size), size);
     }},
    {"convex",
     [](Random& r) {
       const int size = random_size(r);
       return random_convex(r, count_for(r, size), size);
     }},
    {"cells", [](Random& r) { return random_cells(r, 3, r.between(2, 3), false, true); }},
    {"half cells", [](Random& r) { return random_cells(r, r.between(2, 3), 2, true, true); }},
    {"comb",
     [](Random& r) {
       const int height = r.between(1, 6);
       const int width = r.between(1, 2);
       return comb(r.between(2, 3), width, height);
     }},
    {"spiral", [](Random&) { return spiral(1); }},
    {"spiky star", star_of},
    {"with holes",
     [](Random& r) {
       const int holes = r.between(1, 3);
       return random_with_holes(r, r.between(4, 16), holes);
     }},
};
// Returns two parts as close together as possible, perhaps one in a hole of the other.
Region two_parts(Random& random) {
  const Region a = random_polygon(random);
  const Region b = random_polygon(random);
  for (int attempt = 0; attempt < 10; ++attempt) {
    const int dx = random.between(-8, 20);
    Region both = together(a, moved(b, dx, random.between(-8, 20)));
    if (reference::validity_fault(both).empty()) return both;
  }
  return together(a, moved(b, 60, 0));
}

constexpr Kind kMoreParts[] = {
    {"loose cells", [](Random& r) { return random_cells(r, 3, r.between(2, 3), false, false); }},
    {"loose half cells", [](Random& r) { return random_cells(r, 3, 2, true, false); }},
    {"two parts", two_parts},
};
constexpr int kSingleCount = static_cast<int>(std::size(kSinglePart));
constexpr int kMoreCount = static_cast<int>(std::size(kMoreParts));

Region make(const Kind& kind, Random& random, std::string* name) {
  if (name != nullptr) *name = kind.name;
  return kind.make(random);
}

// Returns a frame whose hole is the outline of -q or its box, perhaps wider or narrower by a unit.
Region frame_for(const Region& q, Random& random) {
  Outline hole;
  for (const std::size_t v : q.vertices_of(0)) {
    hole.push_back({-static_cast<std::int64_t>(q.x(v)), -static_cast<std::int64_t>(q.y(v))});
  }
  if (random.one_in(2)) return frame({hole}, random.between(1, 3));
  Vertex low = hole[0];
  Vertex high = hole[0];
  for (const Vertex& v : hole) {
    low = {std::min(low.x, v.x), std::min(low.y, v.y)};
    high = {std::max(high.x, v.x), std::max(high.y, v.y)};
  }
  high.x = std::max(low.x + 1, high.x + random.between(-1, 3));
  high.y = std::max(low.y + 1, high.y + random.between(-1, 3));
  return frame({{low, {high.x, low.y}, high, {low.x, high.y}}}, random.between(1, 3));
}

std::uint64_t number_from_environment(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

}  // namespace

Region random_polygon(Random& random, std::string* kind) {
  return make(kSinglePart[random.below(kSingleCount)], random, kind);
}

Region random_region(Random& random, std::string* kind) {
  const int choice = random.below(kSingleCount + kMoreCount);
  if (choice < kSingleCount) return make(kSinglePart[choice], random, kind);
  return make(kMoreParts[choice - kSingleCount], random, kind);
}

Pair random_pair(Random& random) {
  Pair pair;
  std::string other;
  pair.p = random_region(random, &pair.kind);
  switch (random.below(8)) {
    case 0:
      pair.q = random.one_in(2) ? pair.p : scaled(pair.p, -1);
      other = "itself";
      break;
    case 1:
    case 2:
      pair.q = pair.p;
      pair.p = frame_for(pair.q, random);
      other = "a frame for it";
      break;
    case 3: {
      const Rational scale(1, random.between(2, 16));
      pair.q = scaled(random_region(random, &other), scale);
      other += ", tiny";
      break;
    }
    default:
      pair.q = random_region(random, &other);
  }
  pair.kind += " and " + other;
  const int dy = random.between(-5, 5);
  pair.p = moved(pair.p, random.between(-5, 5), dy);
  if (random.one_in(4)) pair.p = scrambled(scaled(pair.p, 4), random);
  if (random.one_in(4)) pair.q = scrambled(pair.q, random);
  if (random.one_in(2)) std::swap(pair.p, pair.q);
  return pair;
}

std::uint64_t seed_from_environment(std::uint64_t default_seed) {
  return number_from_environment("MINKSUM_SEED", default_seed);
}

int count_from_environment(int default_count) {
  return static_cast<int>(
      number_from_environment("MINKSUM_PAIRS", static_cast<std::uint64_t>(default_count)));
}

}  // namespace minksum::test
