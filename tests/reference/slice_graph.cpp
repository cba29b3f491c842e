#include "reference/slice_graph.hpp"

#include <algorithm>
#include <queue>
#include <stdexcept>

namespace minksum::reference {

SliceGraph::SliceGraph(const std::vector<Slice>& slices) {
  for (std::size_t s = 0; s < slices.size(); ++s) {
    turns_.push_back(slices[s].turn);
    for (const Loops& loops : to_loops(slices[s].free.region)) {
      nodes_.push_back({s, OpenPolygon(loops)});
    }
  }
}

std::size_t SliceGraph::slice_of(const Turn& turn) const {
  for (std::size_t s = 0; s < turns_.size(); ++s) {
    if (turns_[s].same_as(turn)) return s;
  }
  throw std::logic_error("a turn without a slice");
}

std::vector<std::size_t> SliceGraph::nodes_at(const Waypoint& waypoint) const {
  const std::size_t slice = slice_of(waypoint.turn);
  const Spot spot(to_pt(waypoint.at));
  std::vector<std::size_t> found;
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    if (nodes_[n].slice == slice && nodes_[n].part.locate(spot) != Side::kOutside) {
      found.push_back(n);
    }
  }
  return found;
}

bool SliceGraph::are_neighbours(std::size_t a, std::size_t b) const {
  return a != b && ((a + 1) % turns_.size() == b || (b + 1) % turns_.size() == a);
}

bool SliceGraph::joined(std::size_t a, std::size_t b) {
  if (a > b) std::swap(a, b);
  const auto known = joined_.find({a, b});
  if (known != joined_.end()) return known->second;
  return joined_[{a, b}] = insides_meet(nodes_[a].part, nodes_[b].part);
}

bool SliceGraph::connects(const Waypoint& from, const Waypoint& to) {
  std::vector<bool> seen(nodes_.size(), false);
  std::queue<std::size_t> open;
  const auto visit = [&](std::size_t node) {
    if (seen[node]) return;
    seen[node] = true;
    open.push(node);
  };
  for (const std::size_t node : nodes_at(from)) visit(node);
  for (; !open.empty(); open.pop()) {
    const std::size_t here = open.front();
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      if (!seen[n] && are_neighbours(nodes_[here].slice, nodes_[n].slice) && joined(here, n)) {
        visit(n);
      }
    }
  }
  const std::vector<std::size_t> goals = nodes_at(to);
  return std::any_of(goals.begin(), goals.end(), [&](std::size_t node) { return seen[node]; });
}

bool SliceGraph::has(std::span<const Waypoint> path) {
  std::vector<std::size_t> here = nodes_at(path.front());
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Waypoint& a = path[i - 1];
    const Waypoint& b = path[i];
    if (a.turn.same_as(b.turn)) {
      const Span move{Spot(to_pt(a.at)), Spot(to_pt(b.at))};
      if (a.at == b.at) return false;
      std::erase_if(here, [&](std::size_t node) { return !nodes_[node].part.holds(move); });
      continue;
    }
    if (!(a.at == b.at) || !are_neighbours(slice_of(a.turn), slice_of(b.turn))) return false;
    std::vector<std::size_t> next = nodes_at(b);
    std::erase_if(next, [&](std::size_t node) {
      return std::none_of(here.begin(), here.end(),
                          [&](std::size_t before) { return joined(before, node); });
    });
    here = std::move(next);
  }
  return !here.empty();
}

}  // namespace minksum::reference
