// Directions of edges as integers: after this, angular questions cost no arithmetic.
#include <algorithm>
#include <cmath>

#include "operands/operands.hpp"

namespace minksum {
namespace {

/// 0 for directions in [0, π), 1 for [π, 2π).
int half(Predicates& predicates, SiteId edge) {
  const Sign dy = predicates.component(edge, Axis::kY);
  if (dy != kZero) return dy == kPositive ? 0 : 1;
  return predicates.component(edge, Axis::kX) == kPositive ? 0 : 1;
}

/// Exact counter-clockwise order from the positive x axis.
bool before(Predicates& predicates, SiteId a, SiteId b) {
  const int half_a = half(predicates, a);
  const int half_b = half(predicates, b);
  return half_a != half_b ? half_a < half_b : predicates.cross(a, b) == kPositive;
}

bool same_direction(Predicates& predicates, SiteId a, SiteId b) {
  return predicates.cross(a, b) == kZero && predicates.dot(a, b) == kPositive;
}

/// Monotone in the angle, in [0, 4). Both components are off by at most 2^-53 of themselves, so it
/// is off by less than kKeyError.
constexpr double kKeyError = 0x1p-48;
double angle_key(double dx, double dy) {
  const double t = dx / (std::abs(dx) + std::abs(dy));
  return dy >= 0 ? 1 - t : 3 + t;
}

struct KeyedEdge {
  double key;
  SiteId edge;
};

/// Sorts by rounded keys, then mends exactly whatever the keys cannot tell apart.
void sort_by_keys(Operands& operands, Predicates& predicates) {
  std::vector<KeyedEdge> keyed(operands.size());
  for (SiteId e = 0; e < operands.size(); ++e) {
    keyed[e] = {angle_key(operands.sites.dx[e], operands.sites.dy[e]), e};
  }
  std::sort(keyed.begin(), keyed.end(), [](const KeyedEdge& a, const KeyedEdge& b) {
    return a.key != b.key ? a.key < b.key : a.edge < b.edge;
  });
  for (std::size_t i = 1; i < keyed.size(); ++i) {
    const KeyedEdge moving = keyed[i];
    std::size_t j = i;
    while (j > 0 && moving.key - keyed[j - 1].key <= 2 * kKeyError &&
           before(predicates, moving.edge, keyed[j - 1].edge)) {
      keyed[j] = keyed[j - 1];
      --j;
    }
    keyed[j] = moving;
  }
  for (std::size_t i = 0; i < keyed.size(); ++i) operands.by_direction[i] = keyed[i].edge;
}

/// Whether keys are good: no edge vector lost digits to underflow, and the filter may be trusted.
/// A direction near the positive x axis may have its key at either end of the range.
bool keys_are_safe(const Operands& operands) {
  if (std::isinf(operands.bounds.direction)) return false;
  for (SiteId e = 0; e < operands.size(); ++e) {
    const double dx = std::abs(operands.sites.dx[e]);
    const double dy = std::abs(operands.sites.dy[e]);
    if (std::max(dx, dy) < 0x1p-900 || (dy != 0 && dy < 0x1p-900)) return false;
  }
  return true;
}

void assign_ranks(Operands& operands, Predicates& predicates, std::vector<SiteId>& of_rank) {
  of_rank.clear();
  for (const SiteId edge : operands.by_direction) {
    if (of_rank.empty() || !same_direction(predicates, of_rank.back(), edge)) {
      of_rank.push_back(edge);
    }
    operands.rank[edge] = static_cast<DirectionRank>(of_rank.size() - 1);
  }
  operands.rank_count = static_cast<DirectionRank>(of_rank.size());
}

/// For each rank the place of the reversed direction, by one sweep with two pointers.
void find_opposites(Operands& operands, Predicates& predicates,
                    const std::vector<SiteId>& of_rank) {
  const std::size_t n = of_rank.size();
  operands.opposite.resize(n);
  std::size_t ahead = 1;  // first rank after r, not wrapped, that is at or beyond the reversed r
  for (std::size_t r = 0; r < n; ++r) {
    ahead = std::max(ahead, r + 1);
    while (predicates.cross(of_rank[r], of_rank[ahead % n]) == kPositive) ++ahead;
    const bool exact = predicates.cross(of_rank[r], of_rank[ahead % n]) == kZero;
    const auto place = 2 * (ahead % n);
    operands.opposite[r] =
        static_cast<std::uint32_t>(exact ? place : (place + 2 * n - 1) % (2 * n));
  }
}

}  // namespace

void rank_directions(Operands& operands) {
  Predicates predicates(operands.sites, *operands.kernel, operands.bounds);
  const SiteId n = operands.size();
  operands.by_direction.resize(n);
  operands.rank.resize(n);
  operands.convex.resize(n);
  if (keys_are_safe(operands)) {
    sort_by_keys(operands, predicates);
  } else {
    for (SiteId e = 0; e < n; ++e) operands.by_direction[e] = e;
    std::sort(operands.by_direction.begin(), operands.by_direction.end(), [&](SiteId a, SiteId b) {
      return before(predicates, a, b) || (!before(predicates, b, a) && a < b);
    });
  }
  std::vector<SiteId> of_rank;
  assign_ranks(operands, predicates, of_rank);
  find_opposites(operands, predicates, of_rank);
  for (SiteId v = 0; v < n; ++v) {
    operands.convex[v] = predicates.cross(operands.previous[v], v) == kPositive ? 1 : 0;
  }
}

}  // namespace minksum
