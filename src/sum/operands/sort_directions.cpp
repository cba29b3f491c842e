// Sorts edges by direction: by rounded keys, and exactly where keys cannot tell.
#include <algorithm>
#include <bit>
#include <cmath>

#include "sum/operands/directions.hpp"

namespace minksum {
namespace {

/// Returns a key in [0, 4) that grows with the angle. Both components are off by at most 2^-53 of
/// themselves, so the key is off by less than kKeyError.
double angle_key(double dx, double dy) {
  const double t = dx / (std::abs(dx) + std::abs(dy));
  return dy >= 0 ? 1 - t : 3 + t;
}

/// Whether keys may be trusted. They may not if an edge vector lost digits to underflow, or if the
/// filter is off. A direction near the positive x axis may have its key at either end of the range.
bool keys_are_safe(const PreparedOperand& o) {
  if (std::isinf(o.bounds.direction)) return false;
  if (o.bounds.direction == 0) return true;  // integers
  for (SiteId e = 0; e < o.size(); ++e) {
    const double dx = std::abs(o.sites.dx[e]);
    const double dy = std::abs(o.sites.dy[e]);
    if (std::max(dx, dy) < 0x1p-900 || (dy != 0 && dy < 0x1p-900)) return false;
  }
  return true;
}

bool by_key(const KeyedEdge& a, const KeyedEdge& b) {
  return a.key != b.key ? a.key < b.key : a.edge < b.edge;
}

/// Sorts edges by key, and edges of equal keys by id: roughly by ranges of keys, as many as there
/// are edges, and then range by range.
void sort_by_key(std::vector<KeyedEdge>& edges, OperandScratch& scratch) {
  constexpr std::size_t kMostRanges = 1 << 16;  // more would not fit the cache
  const std::size_t ranges = std::clamp<std::size_t>(std::bit_ceil(edges.size()), 8, kMostRanges);
  const auto range = [scale = static_cast<double>(ranges) / 4](const KeyedEdge& e) {
    return static_cast<std::size_t>(static_cast<std::int32_t>(e.key * scale));
  };
  auto& place = scratch.counts;
  place.assign(ranges + 2, 0);  // a key may be 4 after rounding
  for (const KeyedEdge& e : edges) ++place[range(e) + 1];
  for (std::size_t i = 1; i < place.size(); ++i) place[i] += place[i - 1];
  auto& sorted = scratch.keyed;
  sorted.resize(edges.size());
  for (const KeyedEdge& e : edges) sorted[place[range(e)]++] = e;
  std::swap(edges, sorted);
  auto begin = edges.begin();
  for (std::size_t i = 0; i <= ranges; ++i) {
    const auto end = edges.begin() + place[i];
    if (end - begin > 1 && !std::is_sorted(begin, end, by_key)) std::sort(begin, end, by_key);
    begin = end;
  }
}

/// Sorts exactly within each chain of keys that are too close to tell.
void mend(std::vector<KeyedEdge>& edges, bool keys_tell, Predicates& predicates) {
  const auto before = [&](const KeyedEdge& a, const KeyedEdge& b) {
    const Sign order = compare_directions(predicates, keys_tell, a, b);
    return order == kNegative || (order == kZero && a.edge < b.edge);
  };
  for (std::size_t i = 0, j = 0; i < edges.size(); i = j) {
    for (j = i + 1; j < edges.size() && edges[j].key - edges[j - 1].key <= 2 * kKeyError; ++j) {
    }
    const auto chain = std::span(edges).subspan(i, j - i);
    if (chain.size() > 1 && !std::is_sorted(chain.begin(), chain.end(), before)) {
      std::sort(chain.begin(), chain.end(), before);
    }
  }
}

}  // namespace

void sort_directions(Cancellation& cancellation, OperandScratch& scratch,
                     PreparedOperand& operand) {
  cancellation.check(4 * operand.size());
  Predicates predicates(operand.sites, *operand.kernel, operand.bounds, cancellation);
  auto& edges = operand.by_direction;
  operand.keys_tell = keys_are_safe(operand);
  edges.resize(operand.size());
  for (SiteId e = 0; e < operand.size(); ++e) {
    // With equal keys, `mend` compares all edges exactly.
    const double key =
        operand.keys_tell ? angle_key(operand.sites.dx[e], operand.sites.dy[e]) : 0;
    edges[e] = {key, e};
  }
  sort_by_key(edges, scratch);
  mend(edges, operand.keys_tell, predicates);
}

}  // namespace minksum
