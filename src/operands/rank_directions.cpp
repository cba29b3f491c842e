// Directions of edges as integers: after this, angular questions cost no arithmetic.
#include <algorithm>

#include "operands/directions.hpp"
#include "operands/operands.hpp"

namespace minksum {
namespace {

bool keys_tell(const PreparedOperand& p, const PreparedOperand& q) {
  return p.keys_tell && q.keys_tell;
}

/// Both operands' edges in one order, parallel ones by id, and their ranks.
class Ranker {
 public:
  Ranker(const PreparedOperand& p, const PreparedOperand& q, Operands& operands)
      : p_(p), q_(q), o_(operands), predicates_(operands.sites, *operands.kernel, operands.bounds),
        keys_tell_(keys_tell(p, q)), of_rank_(operands.scratch.of_rank) {}

  void run() {
    o_.by_direction.clear();
    of_rank_.clear();
    o_.rank.resize(o_.size());
    const auto& a = p_.by_direction;
    const auto& b = q_.by_direction;
    const auto& renumbered = o_.scratch.renumbered;
    std::size_t i = 0;
    std::size_t j = 0;
    const auto next = [&](const std::vector<KeyedEdge>& from, std::size_t& at, std::size_t shift) {
      for (; at < from.size(); ++at) {
        const SiteId edge = renumbered.empty() ? from[at].edge + static_cast<SiteId>(shift)
                                               : renumbered[from[at].edge + shift];
        if (edge != kNoSite) return KeyedEdge{from[at].key, edge};
      }
      return KeyedEdge{0, kNoSite};
    };
    const std::size_t shift = p_.size();
    KeyedEdge x = next(a, i, 0);
    KeyedEdge y = next(b, j, shift);
    while (x.edge != kNoSite || y.edge != kNoSite) {
      const bool first = y.edge == kNoSite ||
                         (x.edge != kNoSite &&
                          compare_directions(predicates_, keys_tell_, x, y) != kPositive);
      append(first ? x : y);
      if (first) {
        x = next(a, ++i, 0);
      } else {
        y = next(b, ++j, shift);
      }
    }
    o_.rank_count = static_cast<DirectionRank>(of_rank_.size());
  }

 private:
  void append(const KeyedEdge& edge) {
    if (of_rank_.empty() ||
        compare_directions(predicates_, keys_tell_, last_, edge) != kZero) {
      of_rank_.push_back(edge);
    }
    last_ = edge;
    o_.by_direction.push_back(edge.edge);
    o_.rank[edge.edge] = static_cast<DirectionRank>(of_rank_.size() - 1);
  }

  const PreparedOperand& p_;
  const PreparedOperand& q_;
  Operands& o_;
  Predicates predicates_;
  bool keys_tell_;
  std::vector<KeyedEdge>& of_rank_;
  KeyedEdge last_{};
};

/// For each rank, where its reverse stands among the ranks: 2r = exactly at rank r, 2r + 1 = between
/// r and the next. One sweep with two pointers.
void find_reverses(bool keys_tell, Operands& operands) {
  Predicates predicates(operands.sites, *operands.kernel, operands.bounds);
  const auto& of_rank = operands.scratch.of_rank;
  const std::size_t n = of_rank.size();
  operands.reverse_place.resize(n);
  // Positive if the other direction is less than half a circle ahead. Keys of reverses differ by 2.
  const auto turn = [&](std::size_t r, std::size_t other) {
    const KeyedEdge& a = of_rank[r];
    const KeyedEdge& b = of_rank[other < n ? other : other - n];
    const double ahead = b.key - a.key + (other < n ? 0.0 : 4.0);
    if (keys_tell && ahead > 4 * kKeyError && ahead < 4 - 4 * kKeyError) {
      if (ahead < 2 - 4 * kKeyError) return kPositive;
      if (ahead > 2 + 4 * kKeyError) return kNegative;
    }
    return predicates.cross(a.edge, b.edge);
  };
  std::size_t ahead = 1;  // first rank after r, not wrapped, that is at or beyond the reversed r
  for (std::size_t r = 0; r < n; ++r) {
    ahead = std::max(ahead, r + 1);
    Sign at = turn(r, ahead);
    while (at == kPositive) at = turn(r, ++ahead);
    const std::size_t place = 2 * (ahead < n ? ahead : ahead - n);
    const std::size_t before = place == 0 ? 2 * n - 1 : place - 1;
    operands.reverse_place[r] = static_cast<std::uint32_t>(at == kZero ? place : before);
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
  std::size_t r = first;
  for (std::size_t rank = 0; rank < n; ++rank) {
    operands.place[rank] = next_place;
    const auto take = [&](std::size_t coarse) {
      if (taken == n || reverse[r] != coarse) return false;
      reverse[r] = next_place;
      ++taken;
      r = r + 1 == n ? 0 : r + 1;
      return true;
    };
    take(2 * rank);
    ++next_place;
    while (take(2 * rank + 1)) ++next_place;
  }
  operands.place_count = next_place;
}

}  // namespace

void rank_directions(const PreparedOperand& p, const PreparedOperand& q, Operands& operands) {
  Ranker(p, q, operands).run();
  find_reverses(keys_tell(p, q), operands);
  number_places(operands);
}

}  // namespace minksum
