// Turns edge directions into integers: after this, angular questions cost no arithmetic.
#include <algorithm>
#include <cmath>

#include "sum/operands/directions.hpp"
#include "sum/operands/operands.hpp"

namespace minksum {
namespace {

/// Puts both operands' edges in one order, parallel ones by id, and numbers their ranks and places.
/// A processor cannot predict which of two merged lists goes on, so merges do not branch on it.
class Ranker {
 public:
  Ranker(const PreparedOperand& p, const PreparedOperand& q, Cancellation& cancellation,
         Operands& operands)
      : o_(operands),
        predicates_(operands.sites, *operands.kernel, operands.bounds, cancellation),
        keys_tell_(p.keys_tell && q.keys_tell),
        of_rank_(operands.scratch.of_rank) {}

  void rank(std::span<const KeyedEdge> a, std::span<const KeyedEdge> b) {
    o_.by_direction.resize(o_.size());
    o_.rank.resize(o_.size());
    of_rank_.resize(o_.size());
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < a.size() && j < b.size()) {
      const double ahead = b[j].key - a[i].key;
      const bool first = keys_tell_ && std::abs(ahead) > 2 * kKeyError
                             ? ahead > 0
                             : compare_directions(predicates_, a[i].edge, b[j].edge) != kPositive;
      append(*(first ? &a[i] : &b[j]));
      i += first ? 1U : 0U;
      j += first ? 0U : 1U;
    }
    for (; i < a.size(); ++i) append(a[i]);
    for (; j < b.size(); ++j) append(b[j]);
    of_rank_.resize(ranks_);
    o_.rank_count = static_cast<DirectionRank>(ranks_);
  }

  /// Merges the directions with their reverses. Both lists start at the positive x axis.
  void number_places() {
    const std::size_t n = of_rank_.size();
    o_.place.resize(n);
    o_.reverse_place.resize(n);
    const auto lower = std::partition_point(
        of_rank_.begin(), of_rank_.end(),
        [&](const KeyedEdge& e) { return half_circle(predicates_, e.edge) == 0; });
    const auto first = static_cast<std::size_t>(lower - of_rank_.begin());
    const auto rank_of = [&](std::size_t reverse) {
      const std::size_t r = first + reverse;
      return r < n ? r : r - n;
    };
    std::uint32_t place = 0;
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < n && j < n) {
      const std::size_t r = rank_of(j);
      const double ahead = of_rank_[r].key + (r < first ? 2.0 : -2.0) - of_rank_[i].key;
      Sign order = ahead > 0 ? kNegative : kPositive;
      if (!keys_tell_ || std::abs(ahead) <= 4 * kKeyError) {
        order = compare_with_reverse(i, r, r < first);
      }
      // The entry that does not advance gets its final place in a later step.
      o_.place[i] = place;
      o_.reverse_place[r] = place;
      i += order != kPositive ? 1U : 0U;
      j += order != kNegative ? 1U : 0U;
      ++place;
    }
    for (; i < n; ++i) o_.place[i] = place++;
    for (; j < n; ++j) o_.reverse_place[rank_of(j)] = place++;
    o_.place_count = place;
  }

 private:
  void append(const KeyedEdge& edge) {
    const bool follows =
        count_ > 0 && (!keys_tell_ || edge.key - last_.key <= 2 * kKeyError) &&
        compare_directions(predicates_, last_.edge, edge.edge) == kZero;
    if (!follows) of_rank_[ranks_++] = edge;
    last_ = edge;
    o_.by_direction[count_++] = edge.edge;
    o_.rank[edge.edge] = static_cast<DirectionRank>(ranks_ - 1);
  }
  /// Compares the direction of rank i with the reverse of the direction of rank r. `upper` tells
  /// whether the direction of rank r is in the upper half of the circle.
  Sign compare_with_reverse(std::size_t i, std::size_t r, bool upper) {
    const SiteId edge = of_rank_[i].edge;
    const int half = half_circle(predicates_, edge);
    if (half != (upper ? 1 : 0)) return half == 0 ? kNegative : kPositive;
    return predicates_.cross(edge, of_rank_[r].edge);
  }

  Operands& o_;
  Predicates predicates_;
  bool keys_tell_;
  std::vector<KeyedEdge>& of_rank_;
  std::size_t ranks_ = 0;
  std::size_t count_ = 0;
  KeyedEdge last_{};
};

/// Returns an operand's sorted edges that stay, numbered as sites of both operands.
std::span<const KeyedEdge> stay(const PreparedOperand& operand, std::size_t shift,
                                std::span<const SiteId> renumbered, std::vector<KeyedEdge>& kept) {
  kept.clear();
  kept.reserve(operand.by_direction.size());
  for (const KeyedEdge& e : operand.by_direction) {
    const SiteId edge = e.edge + static_cast<SiteId>(shift);
    const SiteId id = renumbered.empty() ? edge : renumbered[edge];
    if (id != kNoSite) kept.push_back({e.key, id});
  }
  return kept;
}

}  // namespace

void rank_directions(const PreparedOperand& p, const PreparedOperand& q, Cancellation& cancellation,
                     Operands& operands) {
  const auto& renumbered = operands.scratch.renumbered;
  auto& kept = operands.scratch.sorted;
  cancellation.check(p.size() + q.size());
  Ranker ranker(p, q, cancellation, operands);
  ranker.rank(renumbered.empty() ? p.by_direction : stay(p, 0, renumbered, kept[0]),
              stay(q, p.size(), renumbered, kept[1]));
  ranker.number_places();
}

}  // namespace minksum
