#include "second/signed_convolution/arrangement.hpp"

namespace minksum::signed_sum {

DeltaRange append_sum(std::span<Delta> contributions, std::vector<Delta>& deltas) {
  std::sort(contributions.begin(), contributions.end(),
            [](const Delta& a, const Delta& b) { return a.layer < b.layer; });
  DeltaRange range;
  range.first = static_cast<std::uint32_t>(deltas.size());
  for (std::size_t i = 0; i < contributions.size();) {
    Delta sum{contributions[i].layer, 0};
    for (; i < contributions.size() && contributions[i].layer == sum.layer; ++i) {
      sum.change += contributions[i].change;
    }
    if (sum.change != 0) deltas.push_back(sum);
  }
  range.last = static_cast<std::uint32_t>(deltas.size());
  return range;
}

bool is_balanced(const Arrangement& arrangement) {
  std::vector<Delta> group;
  std::vector<Delta> sum;
  for (NodeId node = 0; node < arrangement.node_count(); ++node) {
    group.clear();
    sum.clear();
    for (std::uint32_t i = arrangement.node_first[node]; i < arrangement.node_first[node + 1];
         ++i) {
      const HalfEdge h = arrangement.outgoing[i];
      if (arrangement.origin(h) != node) return false;
      arrangement.for_deltas(h, [&](LayerId layer, int change) {
        group.push_back({layer, change});
      });
    }
    const DeltaRange rest = append_sum(group, sum);
    if (rest.first != rest.last) return false;
  }
  return true;
}

}  // namespace minksum::signed_sum
