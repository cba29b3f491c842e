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

/// Sorts by rounded keys, then mends exactly whatever the keys cannot tell apart.
void sort_by_keys(Operands& operands, Predicates& predicates) {
  auto& keyed = operands.scratch.keyed;
  keyed.resize(operands.size());
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
    // A height that vanished in doubles: its sign tells one end of the circle from the other.
    if (dy == 0 && operands.kernel->compare(operands.sites.next[e], e, Axis::kY) != kZero) {
      return false;
    }
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

/// For each rank, where its reverse stands among the ranks: 2r = exactly at rank r, 2r + 1 = between
/// r and the next. One sweep with two pointers.
void find_reverses(Operands& operands, Predicates& predicates,
                   const std::vector<SiteId>& of_rank) {
  const std::size_t n = of_rank.size();
  operands.reverse_place.resize(n);
  std::size_t ahead = 1;  // first rank after r, not wrapped, that is at or beyond the reversed r
  for (std::size_t r = 0; r < n; ++r) {
    ahead = std::max(ahead, r + 1);
    while (predicates.cross(of_rank[r], of_rank[ahead % n]) == kPositive) ++ahead;
    const bool exact = predicates.cross(of_rank[r], of_rank[ahead % n]) == kZero;
    const auto place = 2 * (ahead % n);
    operands.reverse_place[r] =
        static_cast<std::uint32_t>(exact ? place : (place + 2 * n - 1) % (2 * n));
  }
}

/// Reverses between the same two ranks get places of their own, in their order: as r goes round
/// once, so does its reverse.
void number_places(Operands& operands) {
  const std::size_t n = operands.rank_count;
  auto& reverse = operands.reverse_place;
  std::size_t first = 0;  // whose reverse is the first at or after rank 0
  for (std::size_t r = 1; r < n; ++r) {
    if (reverse[r] < reverse[r - 1]) first = r;
  }
  operands.place.resize(n);
  std::uint32_t next_place = 0;
  std::size_t taken = 0;
  for (std::size_t rank = 0; rank < n; ++rank) {
    operands.place[rank] = next_place;
    const auto take = [&](std::size_t coarse) {
      const std::size_t r = (first + taken) % n;
      if (taken == n || reverse[r] != coarse) return false;
      reverse[r] = next_place;
      ++taken;
      return true;
    };
    take(2 * rank);
    ++next_place;
    while (take(2 * rank + 1)) ++next_place;
  }
  operands.place_count = next_place;
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
  std::vector<SiteId>& of_rank = operands.scratch.of_rank;
  assign_ranks(operands, predicates, of_rank);
  find_reverses(operands, predicates, of_rank);
  number_places(operands);
  for (SiteId v = 0; v < n; ++v) {
    operands.convex[v] = predicates.cross(operands.previous[v], v) == kPositive ? 1 : 0;
  }
}

}  // namespace minksum
