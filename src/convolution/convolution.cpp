#include "convolution/convolution.hpp"

#include <algorithm>

namespace minksum {
namespace {

void list_by_rank(const Operands& o, int operand, bool with_holes, EdgesByRank& by_rank) {
  by_rank.edges.clear();
  by_rank.first.resize(o.rank_count + 1);
  std::uint32_t count = 0;
  DirectionRank next = 0;
  for (const SiteId edge : o.by_direction) {
    for (; next <= o.rank[edge]; ++next) by_rank.first[next] = count;
    if (o.operand_of(edge) != operand || (!with_holes && o.on_hole[edge] != 0)) continue;
    by_rank.edges.push_back(edge);
    ++count;
  }
  for (; next <= o.rank_count; ++next) by_rank.first[next] = count;
}

bool has_holes(const Operands& o) {
  return std::any_of(o.rings.begin(), o.rings.end(),
                     [](const OperandRing& ring) { return ring.is_hole(); });
}

class Lister {
 public:
  enum class Vertices { kConvex, kAll, kReflexBackwards };
  Lister(const Operands& o, const Limits& limits, Vertices which, ConvolutionScratch& scratch,
         Convolution& convolution)
      : o_(o), limits_(limits), holes_(has_holes(o)), which_(which), scratch_(scratch), segments_(convolution.segments) {
    segments_.clear();
  }

  /// Edges of the other operand at each vertex of this one.
  void list(int vertex_operand) {
    const bool first = vertex_operand == 0;
    list_by_rank(o_, first ? 1 : 0, true, scratch_.all);
    if (holes_) list_by_rank(o_, first ? 1 : 0, false, scratch_.outer);
    const SiteId begin = first ? 0 : o_.split;
    const SiteId end = first ? o_.split : o_.size();
    const bool thin = o_.both_thin();
    for (SiteId v = begin; v < end; ++v) {
      const bool convex = o_.convex[v] != 0;
      if (which_ != Vertices::kAll && convex != (which_ == Vertices::kConvex)) continue;
      DirectionRank in = o_.rank[o_.previous[v]];
      DirectionRank out = o_.rank[v];
      if (which_ == Vertices::kReflexBackwards) std::swap(in, out);
      const EdgesByRank& edges = holes_ && o_.on_hole[v] != 0 ? scratch_.outer : scratch_.all;
      // [in, out) for the first operand, (in, out] for the second; between thin operands [in, out],
      // at ends (in, out).
      const bool with_in = thin ? !o_.turns_back(v) : first;
      const bool with_out = thin ? with_in : !first;
      const DirectionRank from = with_in ? in : in + 1;
      const DirectionRank to = with_out ? out + 1 : out;
      if (in < out) {
        append(edges, from, to, v);
      } else {
        append(edges, from, o_.rank_count, v);
        append(edges, 0, to, v);
      }
    }
  }

 private:
  void append(const EdgesByRank& edges, DirectionRank from, DirectionRank to, SiteId v) {
    const std::uint32_t first = edges.first[from];
    const std::uint32_t last = edges.first[to];
    // Points of segments and crossings are numbered in 32 bits.
    constexpr std::uint64_t kMost = std::uint64_t{1} << 30;
    const std::uint64_t most = std::min(limits_.max_segments, kMost);
    if (segments_.size() + (last - first) > most) {
      throw Error(ErrorCode::kLimitExceeded, "the convolution has more than " +
                                                 std::to_string(most) +
                                                 " segments (Limits::max_segments)");
    }
    const std::size_t size = segments_.size();
    segments_.resize(size + (last - first));
    for (std::uint32_t i = first; i < last; ++i) {
      segments_[size + (i - first)] = {edges.edges[i], v};
    }
  }

  const Operands& o_;
  const Limits& limits_;
  bool holes_;
  Vertices which_;
  ConvolutionScratch& scratch_;
  std::vector<Segment>& segments_;
};

/// Counter-clockwise from `in`, is `d` in [in, out), (in, out], or what else the rule says?
bool in_range(const Operands& o, SiteId v, SiteId edge) {
  const DirectionRank in = o.rank[o.previous[v]];
  const DirectionRank out = o.rank[v];
  const DirectionRank d = o.rank[edge];
  if (o.both_thin() && (d == in || d == out)) return !o.turns_back(v);
  if (o.operand_of(v) == 0 ? d == out : d == in) return false;
  if (o.operand_of(v) == 0 ? d == in : d == out) return true;
  return in < out ? in < d && d < out : d > in || d < out;
}

}  // namespace

void reduced_convolution(const Operands& operands, const Limits& limits,
                         ConvolutionScratch& scratch, Convolution& convolution) {
  Lister lister(operands, limits, Lister::Vertices::kConvex, scratch, convolution);
  lister.list(0);
  lister.list(1);
}

void full_convolution(const Operands& operands, const Limits& limits,
                      ConvolutionScratch& scratch, Convolution& convolution) {
  Lister lister(operands, limits, Lister::Vertices::kAll, scratch, convolution);
  lister.list(0);
  lister.list(1);
}

void reflex_convolution(const Operands& operands, const Limits& limits,
                        ConvolutionScratch& scratch, Convolution& convolution) {
  Lister lister(operands, limits, Lister::Vertices::kReflexBackwards, scratch, convolution);
  lister.list(0);
  lister.list(1);
}

std::optional<std::string> check(const Convolution& convolution, const Operands& o, bool full) {
  std::vector<Segment> sorted = convolution.segments;
  const auto less = [](const Segment& a, const Segment& b) {
    return a.edge != b.edge ? a.edge < b.edge : a.vertex < b.vertex;
  };
  std::sort(sorted.begin(), sorted.end(), less);
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) {
    return "a segment is listed twice";
  }
  std::size_t expected = 0;
  for (SiteId v = 0; v < o.size(); ++v) {
    if (o.convex[v] == 0 && !full) continue;
    for (SiteId e = 0; e < o.size(); ++e) {
      if (o.operand_of(e) == o.operand_of(v) || (o.on_hole[e] != 0 && o.on_hole[v] != 0)) continue;
      if (!in_range(o, v, e)) continue;
      ++expected;
      if (!std::binary_search(sorted.begin(), sorted.end(), Segment{e, v}, less)) {
        return "a segment is missing";
      }
    }
  }
  if (expected != sorted.size()) return "a segment does not belong";
  return std::nullopt;
}

}  // namespace minksum
