// Turns the events along segments into nodes and pieces.
#include <algorithm>
#include <cmath>

#include "exact/share_decisions.hpp"
#include "machine/make_room.hpp"
#include "sum/arrangement/order_events.hpp"

namespace minksum {
namespace {

constexpr NodeId kNoNode = 0xFFFFFFFFU;

class Splitter {
 public:
  Splitter(const Operands& operands, const Cover& cover, bool tight_wanted, Predicates& predicates,
           ArrangementScratch& scratch, Arrangement& arrangement)
      : operands_(operands),
        cover_(cover),
        tight_wanted_(tight_wanted),
        predicates_(predicates),
        cancellation_(predicates.cancellation()),
        scratch_(scratch),
        result_(arrangement),
        points_(predicates, scratch, arrangement),
        ends_(points_.ends()),
        may_coincide_(scratch.covered || cover.clips || scratch.lines_shared ||
                      !scratch.hidden.empty()) {}

  void run() {
    order_events(predicates_, scratch_, result_);
    mark_hidden();
    scratch_.root_of_node.clear();
    result_.pieces.clear();
    if (may_coincide_) {
      assign_in_pieces(scratch_.first_piece, scratch_.parent.size(), kNoPiece, cancellation_);
    }
    scratch_.next_piece.clear();
    // With room for the most that may come, lists seldom move. Unused memory costs nothing.
    const std::size_t most = scratch_.line_count + scratch_.sorted_events.size();
    make_room(scratch_.root_of_node, most, cancellation_);
    make_room(result_.pieces, most, cancellation_);
    if (may_coincide_) make_room(scratch_.next_piece, most, cancellation_);
    assign_in_pieces(scratch_.node_of_point, scratch_.parent.size(), kNoNode, cancellation_);
    cut_all();
    result_.slits.clear();
    result_.crowded.clear();
    if (tight_wanted_) {
      list_slits();
      list_crowded();
    }
    make_nodes();
    drop_cancelled();
  }

 private:
  [[nodiscard]] std::span<const Event> events_of(KeptId s) const { return scratch_.events_of(s); }

  NodeId node_of(std::uint32_t root) {
    NodeId& id = scratch_.node_of_point[root];
    if (id == kNoNode) {
      id = static_cast<NodeId>(scratch_.root_of_node.size());
      append(scratch_.root_of_node, root, cancellation_);
    }
    return id;
  }
  void make_nodes() {
    constexpr std::uint64_t kUnitsOfNode = 8;  // what it is made from may not be in the cache
    const auto& roots = scratch_.root_of_node;
    resize_in_pieces(result_.nodes, roots.size(), cancellation_);
    share_each(roots.size(), kUnitsOfNode, cancellation_,
               [&](std::size_t i, Cancellation&) { make_node(roots[i], result_.nodes[i]); });
  }
  /// Writes a node in its place. To write it elsewhere and copy it would stall the processor.
  void make_node(std::uint32_t root, Node& node) const {
    node.point.is_crossing = root >= ends_;
    if (root < ends_) {
      const KeptSegment& s = result_.kept[root / 2];
      node.point.vertex = points_.end(root);
      node.at = root % 2 == 0 ? s.a : s.b;
      node.error = predicates_.bounds().difference;
      return;
    }
    const Crossing& c = scratch_.crossings[root - ends_];
    const KeptSegment& s = result_.kept[c.first];
    const double reach = std::max(std::abs(s.d.x), std::abs(s.d.y));
    node.point.first = s.segment;
    node.point.second = result_.kept[c.second].segment;
    node.at = {s.a.x + c.lambda * s.d.x, s.a.y + c.lambda * s.d.y};
    // An infinite error stays infinite, even where the segment's vector is 0 in doubles.
    node.error = std::isinf(c.error) ? c.error : c.error * reach + predicates_.bounds().position;
  }

  /// A possible piece: where it begins, and where it ends.
  struct Stretch {
    std::size_t event = 0;  ///< the number of `to` among the segment's events
    Event from{};
    Event to{};
    std::uint32_t from_root = 0;
    std::uint32_t to_root = 0;
    Vec<double> from_at{};
    Vec<double> to_at{};
  };
  /// Calls visit(stretch) for each stretch of a segment between points that differ. `root` returns
  /// the root of a point.
  template <class Root, class Visit>
  void visit_stretches(KeptId s, Root root, Visit visit) const {
    const KeptSegment& k = result_.kept[s];
    Stretch at;
    at.from = {0, 0, s, 2 * s};
    at.from_root = root(at.from.point);
    at.from_at = k.a;
    const auto go_to = [&](const Event& event, const Vec<double>& place) {
      at.to_root = root(event.point);
      if (at.to_root != at.from_root) {
        at.to = event;
        at.to_at = place;
        visit(at);
        at.from = event;
        at.from_root = at.to_root;
        at.from_at = place;
      }
      ++at.event;
    };
    for (const Event& event : events_of(s)) {
      go_to(event, {k.a.x + event.lambda * k.d.x, k.a.y + event.lambda * k.d.y});
    }
    go_to({1, 0, s, 2 * s + 1}, k.b);
  }
  [[nodiscard]] bool is_whole(KeptId s) const {
    const KeptSegment& k = result_.kept[s];
    return !k.meets_cover && k.clip.is_whole() && k.joined == 0 && events_of(s).empty() &&
           !is_hidden(s, 0);
  }
  [[nodiscard]] bool is_left_out(KeptId s, const Stretch& at, Cancellation& cancellation) const {
    return is_inside(s, at.from.point, at.to.point) || is_clipped(result_.kept[s].clip, at) ||
           is_hidden(s, at.event) ||
           (result_.kept[s].meets_cover && is_covered(at.from_at, at.to_at, cancellation));
  }
  /// Whether the stretch before an event of s, or after the last one, has a hidden part.
  [[nodiscard]] bool is_hidden(KeptId s, std::size_t event) const {
    return !scratch_.hides.empty() && scratch_.hides[scratch_.event_begin[s] + s + event] != 0;
  }
  /// Hidden parts reach a slack beyond what they hide, and positions are far less off.
  void mark_hidden() {
    auto& hides = scratch_.hides;
    hides.clear();
    if (scratch_.hidden.empty()) return;
    const std::size_t stretches = scratch_.sorted_events.size() + result_.kept.size();
    assign_in_pieces(hides, stretches, std::uint8_t{0}, cancellation_);
    visit_in_pieces(scratch_.hidden, cancellation_, [&](const HiddenPart& part) {
      const auto events = events_of(part.segment);
      std::uint8_t* const mark = &hides[scratch_.event_begin[part.segment] + part.segment];
      const auto first = std::partition_point(events.begin(), events.end(),
                                              [&](const Event& e) { return e.lambda < part.from; });
      auto event = static_cast<std::size_t>(first - events.begin());
      mark[event] = 1;
      for (; event < events.size() && events[event].lambda <= part.to; ++event) mark[event + 1] = 1;
    });
  }
  /// Whether a piece reaches into what was clipped off.
  [[nodiscard]] static bool is_clipped(const Clip& clip, const Stretch& at) {
    return at.from.lambda + at.from.error < clip.from || at.to.lambda - at.to.error > clip.to;
  }
  /// Cuts all segments. Tasks list pieces, and the calling thread numbers them.
  void cut_all() {
    constexpr std::uint64_t kUnitsOfPiece = 16;  // a walk along some cells
    const std::size_t lines = scratch_.line_count;
    const std::size_t tasks =
        tasks_for(kUnitsOfPiece * (scratch_.sorted_events.size() + lines), cancellation_);
    if (tasks == 1) {
      const auto root = [&](std::uint32_t point) { return find_root(scratch_.parent, point); };
      const auto add = [&](const FoundPiece& piece) { add_piece(piece); };
      for (KeptId s = 0; s < lines; ++s) cut(s, predicates_, root, add);
      return;
    }
    auto& found = scratch_.found_pieces;
    found.resize(std::max(found.size(), tasks));
    share_decisions(tasks, predicates_, [&](std::size_t task, std::size_t, Predicates& decide) {
      auto& pieces = found[task].pieces;
      pieces.clear();
      const auto root = [&](std::uint32_t point) {
        return find_shared_root(scratch_.parent, point);
      };
      const auto add = [&](const FoundPiece& piece) {
        append(pieces, piece, decide.cancellation());
      };
      const std::size_t end = begin_of(task + 1, tasks, lines);
      for (std::size_t s = begin_of(task, tasks, lines); s < end; ++s) {
        cut(static_cast<KeptId>(s), decide, root, add);
      }
    });
    for (std::size_t task = 0; task < tasks; ++task) {
      visit_in_pieces(found[task].pieces, cancellation_,
                      [&](const FoundPiece& piece) { add_piece(piece); });
    }
  }

  /// Cuts one segment into pieces, and calls visit(piece) for each. It leaves out pieces inside the
  /// sum, such as those that run through covered cells, because they are not boundary. `root`
  /// returns the root of a point.
  template <class Root, class Visit>
  void cut(KeptId s, Predicates& decide, Root root, Visit visit) const {
    Cancellation& cancellation = decide.cancellation();
    cancellation.check();
    if (is_whole(s)) {
      const std::uint32_t from = root(2 * s);
      const std::uint32_t to = root(2 * s + 1);
      if (to != from) visit(FoundPiece{from, to, s});
      return;
    }
    const KeptSegment& k = result_.kept[s];
    KeptId maker = k.joined == 0 ? s : scratch_.join.joined[k.joined - 1].first;
    visit_stretches(s, root, [&](const Stretch& at) {
      cancellation.check();
      if (is_left_out(s, at, cancellation)) return;
      if (k.joined != 0) maker = member_after(s, at.from, maker, decide);
      visit(FoundPiece{at.from_root, at.to_root, maker});
    });
  }
  /// Returns the first member of a joined segment, from `member` on, that goes on after a point.
  /// (The member starts at the point or before, because members overlap.)
  [[nodiscard]] KeptId member_after(KeptId s, const Event& from, KeptId member,
                                    Predicates& decide) const {
    const KeptSegment& k = result_.kept[s];
    const KeptId end = scratch_.join.joined[k.joined - 1].end;
    const bool by_x = std::abs(k.d.x) >= std::abs(k.d.y);
    for (; member + 1 < end; ++member) {
      decide.cancellation().check();
      const KeptSegment& m = result_.kept[member];
      const double lambda = by_x ? (m.b.x - k.a.x) / k.d.x : (m.b.y - k.a.y) / k.d.y;
      const PointOnSegment point{false, {}, decide.end_vertex(m.segment)};
      if (decide.compare_along(k.segment, lambda, 0x1p-50, point, from.lambda, from.error,
                               points_.on(s, from.point)) == kPositive) {
        break;
      }
    }
    return member;
  }

  /// Whether a piece of s begins or ends at a crossing, and lies there on the left of the other
  /// segment. The sum's interior is there, all along that segment. (For joined segments it is not
  /// known where their members end.)
  [[nodiscard]] bool is_inside(KeptId s, std::uint32_t begin, std::uint32_t end) const {
    if (tight_wanted_) return false;  // tight places are inside
    const auto is_left_of = [&](KeptId other) { return result_.kept[other].joined == 0; };
    if (begin >= ends_) {
      const Crossing& c = scratch_.crossings[begin - ends_];
      if (c.second == s && is_left_of(c.first)) return true;
    }
    if (end < ends_) return false;
    const Crossing& c = scratch_.crossings[end - ends_];
    return c.first == s && is_left_of(c.second);
  }
  [[nodiscard]] bool is_covered(const Vec<double>& a, const Vec<double>& b,
                                Cancellation& cancellation) const {
    if (!cover_.active) return false;
    // Cells near the piece are within twice kMargin of it, and covered cells have three times that
    // margin inside the sum. So if one is covered, a point of the piece is inside the sum (up to
    // rounding, which is far less).
    const CellsNear near = cells_near(cover_, {a, b}, Until::kCovered);
    cancellation.check(1 + std::uint64_t{near.rows});
    return near.covered;
  }

  /// Adds a piece. One of several equal pieces is kept, and none of opposite ones.
  void add_piece(const FoundPiece& found) {
    const NodeId from = node_of(found.from_root);
    const NodeId to = node_of(found.to_root);
    const KeptId s = found.maker;
    if (!may_coincide_) return append(result_.pieces, {from, to, s}, cancellation_);
    PieceId& list = scratch_.first_piece[std::min(from, to)];
    for (PieceId p = list; p != kNoPiece; p = scratch_.next_piece[p].next) {
      cancellation_.check();
      const Piece& other = result_.pieces[p];
      if (other.from == from && other.to == to) return;
      if (other.from == to && other.to == from) {
        scratch_.next_piece[p].cancelled = true;
        return;
      }
    }
    append(scratch_.next_piece, {list, false}, cancellation_);
    list = static_cast<PieceId>(result_.pieces.size());
    append(result_.pieces, {from, to, s}, cancellation_);
  }
  void drop_cancelled() {
    if (!may_coincide_) return;
    auto& pieces = result_.pieces;
    std::size_t kept = 0;
    in_pieces(pieces.size(), cancellation_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p < end; ++p) {
        if (!scratch_.next_piece[p].cancelled) pieces[kept++] = pieces[p];
      }
    });
    pieces.resize(kept);
  }

  void list_slits() {
    if (!may_coincide_) return;
    for (PieceId p = 0; p < result_.pieces.size(); ++p) {
      cancellation_.check();
      if (scratch_.next_piece[p].cancelled) result_.slits.push_back(result_.pieces[p]);
    }
  }

  void list_crowded() {
    auto& incidents = scratch_.incidents;
    incidents.clear();
    for (KeptId s = 0; s < scratch_.line_count; ++s) {
      const DirectionRank rank = operands_.rank[result_.kept[s].segment.edge];
      const auto add = [&](std::uint32_t point) {
        cancellation_.check();
        append(incidents, {find_root(scratch_.parent, point), rank}, cancellation_);
      };
      add(2 * s);
      add(2 * s + 1);
      for (const Event& event : events_of(s)) add(event.point);
    }
    std::sort(incidents.begin(), incidents.end(),
              cancellation_.counting([](const Incident& a, const Incident& b) {
                return a.point != b.point ? a.point < b.point : a.rank < b.rank;
              }));
    for (std::size_t first = 0, last = 0; first < incidents.size(); first = last) {
      while (last < incidents.size() && incidents[last].point == incidents[first].point) ++last;
      cancellation_.check(last - first);
      const std::uint32_t root = incidents[first].point;
      if (!turns_are_small(std::span(incidents).subspan(first, last - first))) continue;
      Node node;
      make_node(root, node);
      if (!is_covered(node)) result_.crowded.push_back(node_of(root));
    }
  }
  /// Whether each of these sorted directions is followed by another one within half a circle.
  [[nodiscard]] bool turns_are_small(std::span<const Incident> around) const {
    DirectionRank last = around.back().rank;
    if (last == around.front().rank) return false;
    for (const Incident& incident : around) {
      if (incident.rank == last) continue;
      const std::uint32_t from = operands_.place[last];
      if (operands_.turn(from, operands_.place[incident.rank]) >=
          operands_.turn(from, operands_.reverse_place[last])) {
        return false;
      }
      last = incident.rank;
    }
    return true;
  }
  /// Whether a node is certainly in a covered cell (up to a rounding far below the cover's margin).
  [[nodiscard]] bool is_covered(const Node& node) const {
    const UniformGrid& grid = cover_.grid;
    const double cells = node.error * std::max(grid.inverse.x, grid.inverse.y);
    return cover_.active && cells < UniformGrid::kMargin &&
           cover_.is_covered(grid.column(node.at.x), grid.row(node.at.y));
  }

  const Operands& operands_;
  const Cover& cover_;
  bool tight_wanted_;
  Predicates& predicates_;
  Cancellation& cancellation_;
  ArrangementScratch& scratch_;
  Arrangement& result_;
  SharedPoints points_;
  std::uint32_t ends_;  ///< points of lower numbers are ends of segments
  /// Whether two pieces may have the same ends. That happens where segments overlap on one line.
  /// If something is covered, hidden or clipped, not all pairs were met, so this is true to be
  /// safe.
  bool may_coincide_;
};

}  // namespace

void split_segments(const Operands& operands, const Cover& cover, bool tight_wanted,
                    Predicates& predicates, ArrangementScratch& scratch, Arrangement& arrangement) {
  Splitter(operands, cover, tight_wanted, predicates, scratch, arrangement).run();
}

}  // namespace minksum
