// A forest of points, of which each tree is a set of equal ones. Threads may unite trees at once.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <vector>

namespace minksum {

/// Returns the root of a point's tree.
inline std::uint32_t find_root(std::vector<std::uint32_t>& parent, std::uint32_t point) {
  while (parent[point] != point) {
    parent[point] = parent[parent[point]];
    point = parent[point];
  }
  return point;
}
inline void unite(std::vector<std::uint32_t>& parent, std::uint32_t a, std::uint32_t b) {
  a = find_root(parent, a);
  b = find_root(parent, b);
  if (a < b) parent[b] = a;
  if (b < a) parent[a] = b;
}
/// Does what `find_root` does, while other threads do it and unite trees.
inline std::uint32_t find_shared_root(std::vector<std::uint32_t>& parent, std::uint32_t point) {
  constexpr auto kRelaxed = std::memory_order_relaxed;  // only links are read before all tasks end
  const auto link = [&](std::uint32_t at) { return std::atomic_ref(parent[at]); };
  while (true) {
    const std::uint32_t up = link(point).load(kRelaxed);
    if (up == point) return point;
    const std::uint32_t further = link(up).load(kRelaxed);
    if (further != up) link(point).store(further, kRelaxed);
    point = further;
  }
}
/// Does what `unite` does, while other threads do it, too. The roots depend on what is united, not
/// on when: a link always leads from a root to a smaller point.
inline void unite_shared(std::vector<std::uint32_t>& parent, std::uint32_t a, std::uint32_t b) {
  while ((a = find_shared_root(parent, a)) != (b = find_shared_root(parent, b))) {
    std::uint32_t expected = std::max(a, b);
    const std::atomic_ref link(parent[expected]);
    if (link.compare_exchange_strong(expected, std::min(a, b), std::memory_order_relaxed)) return;
  }
}

}  // namespace minksum
