#include "sum/trace/fill_trace.hpp"

#include <unordered_set>

namespace minksum {
namespace {

/// Fills a trace, turning the pipeline's moved and scaled doubles into the operands' own units.
class Tracer {
 public:
  Tracer(const Operands& operands, Cancellation& cancellation, Trace& trace)
      : o_(operands), cancellation_(cancellation), trace_(trace) {}

  [[nodiscard]] Trace::Vertex vertex(const Vec<double>& at) const {
    cancellation_.check(4);
    return {at.x * o_.trace_unit + o_.trace_origin.x, at.y * o_.trace_unit + o_.trace_origin.y};
  }
  [[nodiscard]] Trace::Vertex sum(SiteId a, SiteId b) const {
    return vertex({o_.sites.x[a] + o_.sites.x[b], o_.sites.y[a] + o_.sites.y[b]});
  }
  [[nodiscard]] bool edge_of_first(const Segment& s) const { return o_.operand_of(s.edge) == 0; }

  void convolution(const Convolution& convolution, const Arrangement& arrangement) {
    std::unordered_set<std::uint64_t> kept;
    const auto key = [](const Segment& s) { return (std::uint64_t{s.edge} << 32) | s.vertex; };
    for (const KeptSegment& k : arrangement.kept) kept.insert(key(k.segment));
    for (const Segment& s : convolution.segments) {
      trace_.convolution.push_back({sum(s.edge, s.vertex), sum(o_.sites.next[s.edge], s.vertex),
                                    edge_of_first(s), kept.contains(key(s))});
    }
  }
  void cover(const Cover& cover) {
    if (!cover.active) return;
    const UniformGrid& grid = cover.grid;
    const Trace::Vertex origin = vertex({0, 0});
    trace_.cover = {origin.x,
                    origin.y,
                    grid.cell.x * o_.trace_unit,
                    grid.cell.y * o_.trace_unit,
                    static_cast<std::uint32_t>(grid.columns),
                    static_cast<std::uint32_t>(grid.rows),
                    {}};
    for (std::int32_t j = 0; j < grid.rows; ++j) {
      cancellation_.check(static_cast<std::uint64_t>(grid.columns));
      for (std::int32_t i = 0; i < grid.columns; ++i) {
        trace_.cover.covered.push_back(cover.is_covered(i, j));
      }
    }
  }
  void arrangement(const Arrangement& arrangement) {
    for (const Node& node : arrangement.nodes) trace_.nodes.push_back(vertex(node.at));
    for (const Piece& piece : arrangement.pieces) {
      trace_.pieces.push_back({vertex(arrangement.nodes[piece.from].at),
                               vertex(arrangement.nodes[piece.to].at),
                               edge_of_first(arrangement.kept[piece.segment].segment), true});
    }
  }
  void loops(const Loops& loops, const FilteredLoops& filtered, const Arrangement& arrangement) {
    for (std::size_t i = 0; i < loops.size(); ++i) {
      Trace::Loop loop;
      loop.positive = loops.positive[i] != 0;
      loop.state = filtered.state[i];
      for (const PieceId p : loops.loop(i)) {
        loop.vertices.push_back(vertex(arrangement.nodes[arrangement.pieces[p].from].at));
      }
      trace_.loops.push_back(std::move(loop));
    }
  }

 private:
  const Operands& o_;
  Cancellation& cancellation_;
  Trace& trace_;
};

}  // namespace

void fill_trace(const Operands& operands, const Convolution& convolution, const Cover& cover,
                const Arrangement& arrangement, const Loops& loops, const FilteredLoops& filtered,
                Cancellation& cancellation, Trace& trace) {
  Tracer tracer(operands, cancellation, trace);
  tracer.convolution(convolution, arrangement);
  tracer.cover(cover);
  tracer.arrangement(arrangement);
  tracer.loops(loops, filtered, arrangement);
}

}  // namespace minksum
