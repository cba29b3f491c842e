#include "sum/convolution/convolution.hpp"

#include <algorithm>
#include <bit>
#include <span>

#include "machine/exceeded.hpp"
#include "machine/make_room.hpp"
#include "machine/scramble.hpp"

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

enum class Vertices { kConvex, kAll };

/// Returns [in, out) for vertices of the first operand, and (in, out] for those of the second. For
/// two thin operands it returns [in, out], but (in, out) at ends. `in_range` has the same rule for
/// one edge.
RankRange range_at(const Operands& o, SiteId v) {
  const DirectionRank in = o.rank[o.previous[v]];
  const DirectionRank out = o.rank[v];
  const bool first = o.operand_of(v) == 0;
  const bool thin = o.both_thin();
  const bool with_in = thin ? !o.turns_back(v) : first;
  const bool with_out = thin ? with_in : !first;
  const DirectionRank from = with_in ? in : in + 1;
  const DirectionRank to = (with_out ? out + 1 : out) + (in < out ? 0 : o.rank_count);
  return {from < o.rank_count ? from : 0, to - from};
}

/// Calls visit(edges, v) for each vertex v of one operand and each run of compatible edges of the
/// other one.
template <class Visit>
void visit_runs(const Operands& o, Vertices which, int vertex_operand, ConvolutionScratch& scratch,
                Visit visit) {
  const bool first = vertex_operand == 0;
  const bool holes = has_holes(o.rings);
  list_by_rank(o, first ? 1 : 0, true, scratch.all);
  if (holes) list_by_rank(o, first ? 1 : 0, false, scratch.outer);
  const SiteId begin = first ? 0 : o.split;
  const SiteId end = first ? o.split : o.size();
  for (SiteId v = begin; v < end; ++v) {
    if (which == Vertices::kConvex && o.convex[v] == 0) continue;
    const EdgesByRank& by_rank = holes && o.on_hole[v] != 0 ? scratch.outer : scratch.all;
    const auto visit_ranks = [&](DirectionRank from, DirectionRank to) {
      const std::uint32_t run = by_rank.first[from];
      visit(std::span(by_rank.edges).subspan(run, by_rank.first[to] - run), v);
    };
    const auto [from, length] = range_at(o, v);
    const DirectionRank to = from + length;
    visit_ranks(from, std::min(to, o.rank_count));
    if (to > o.rank_count) visit_ranks(0, to - o.rank_count);
  }
}

/// Appends runs of segments. If there are more than `many`, it keeps one of every two, four, eight
/// and so on.
class Lister {
 public:
  Lister(const Limits& limits, std::uint64_t many, Cancellation& cancellation,
         Convolution& convolution)
      : most_(std::min(limits.max_segments, kMostNumbered)),
        many_(many),
        cancellation_(cancellation),
        c_(convolution) {
    c_.segments.clear();
    c_.size = 0;
    c_.step = 1;
  }
  void append(std::span<const SiteId> edges, SiteId v) {
    if (c_.step == 1 && c_.size + edges.size() > many_) thin_out();
    if (c_.step > 1) return pick(edges, v);
    if (c_.size + edges.size() > most_) {
      throw exceeded("Limits::max_segments", most_, "the convolution has", "segments");
    }
    const std::size_t size = c_.size + edges.size();
    if (size <= c_.segments.capacity() && edges.size() <= kPiece) {
      c_.segments.resize(size);
    } else {
      resize_in_pieces(c_.segments, size, cancellation_);
    }
    for (std::size_t i = 0; i < edges.size(); ++i) c_.segments[c_.size + i] = {edges[i], v};
    c_.size += edges.size();
  }

 private:
  [[nodiscard]] std::uint64_t random(std::uint64_t i) const { return scramble(i ^ c_.step << 32); }
  /// Picks one of the i-th `step` segments. Its position varies with i, because shapes can repeat
  /// themselves with the period of the step.
  [[nodiscard]] std::uint64_t sampled(std::uint64_t i) const {
    return i * c_.step + (random(i) & (c_.step - 1));
  }
  void thin_out() {
    c_.step = std::max<std::uint64_t>(std::bit_floor(c_.size / kSample), 2);
    std::uint64_t kept = 0;
    for (; sampled(kept) < c_.size; ++kept) c_.segments[kept] = c_.segments[sampled(kept)];
    c_.segments.resize(kept);
  }
  void pick(std::span<const SiteId> edges, SiteId v) {
    for (std::uint64_t next = sampled(c_.segments.size()); next < c_.size + edges.size();
         next = sampled(c_.segments.size())) {
      c_.segments.push_back({edges[next - c_.size], v});
      if (c_.segments.size() < 2 * kSample) continue;
      for (std::size_t i = 0; i < kSample; ++i) {
        c_.segments[i] = c_.segments[2 * i + (random(i) & 1)];
      }
      c_.segments.resize(kSample);
      c_.step *= 2;
    }
    c_.size += edges.size();
  }

  std::uint64_t most_;
  std::uint64_t many_;
  Cancellation& cancellation_;
  Convolution& c_;
};

void list(const Operands& o, Vertices which, const Limits& limits, std::uint64_t many,
          Cancellation& cancellation, ConvolutionScratch& scratch, Convolution& convolution) {
  Lister lister(limits, many, cancellation, convolution);
  make_room(convolution.segments, 8 * std::size_t{o.size()}, cancellation);  // seldom more
  cancellation.check(2 * o.size());
  const auto append = [&](std::span<const SiteId> edges, SiteId v) {
    cancellation.check(edges.size());
    lister.append(edges, v);
  };
  for (const int operand : {0, 1}) visit_runs(o, which, operand, scratch, append);
}

constexpr std::uint64_t kAll = ~std::uint64_t{0};

/// Whether the reduced or full convolution has the segment of this edge and this vertex. The rule
/// is that of `range_at`.
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

RankRange reduced_range(const Operands& operands, SiteId vertex) {
  return range_at(operands, vertex);
}

bool is_copy(const Operands& o, const Segment& s) {
  const DirectionRank rank = o.rank[s.edge];
  if (rank == o.rank[s.vertex] || rank == o.rank[o.previous[s.vertex]]) return false;
  return o.operand_of(s.edge) == 0 ? s.vertex - o.split <= s.edge : s.vertex > s.edge - o.split;
}

void reduced_convolution(const Operands& operands, const Limits& limits, Cancellation& cancellation,
                         ConvolutionScratch& scratch, Convolution& convolution) {
  list(operands, Vertices::kConvex, limits, kAll, cancellation, scratch, convolution);
}

void reduced_convolution_or_sample(const Operands& operands, const Limits& limits,
                                   std::uint64_t many, Cancellation& cancellation,
                                   ConvolutionScratch& scratch, Convolution& convolution) {
  list(operands, Vertices::kConvex, limits, many, cancellation, scratch, convolution);
}

void full_convolution(const Operands& operands, const Limits& limits, Cancellation& cancellation,
                      ConvolutionScratch& scratch, Convolution& convolution) {
  list(operands, Vertices::kAll, limits, kAll, cancellation, scratch, convolution);
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
      if (!convolution.listed()) continue;
      if (!std::binary_search(sorted.begin(), sorted.end(), Segment{e, v}, less)) {
        return "a segment is missing";
      }
    }
  }
  if (!convolution.listed()) {
    if (expected != convolution.size) return "the number of segments is wrong";
  } else if (expected != sorted.size()) {
    return "a segment does not belong";
  }
  return std::nullopt;
}

}  // namespace minksum
