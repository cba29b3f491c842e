// Links the boundary's pieces into simple rings, and rings into polygons, in canonical order.
#include <algorithm>
#include <tuple>

#include "machine/make_room.hpp"
#include "overlay/subdivision.hpp"
#include "overlay/write_node.hpp"

namespace minksum::overlay {
namespace {

/// A piece, directed so that the area is on its left.
struct Step {
  PieceId piece = kNone;
  NodeId from = kNone;
};

struct AreaRing {
  std::vector<NodeId> corners;  ///< from the smallest node on
  bool outer = false;
  std::uint32_t walk = 0;
  std::uint32_t polygon = kNone;
};

class AreaExtractor {
 public:
  AreaExtractor(const Segments& segments, const Subdivision& subdivision)
      : segments_(segments), cancellation_(segments.cancellation()), s_(subdivision) {}

  void run(Region& area) {
    assign_in_pieces(walk_of_, s_.pieces.size(), kNone, cancellation_);
    assign_in_pieces(place_in_path_, s_.nodes.size(), kNone, cancellation_);
    for (PieceId p = 0; p < s_.pieces.size(); ++p) {
      cancellation_.check();
      if (s_.pieces[p].is_boundary() && walk_of_[p] == kNone) follow(p);
    }
    assign_polygons();
    write(area);
  }

 private:
  /// A closed walk along the boundary of a connected part of the area's inside.
  struct Walk {
    NodeId leftmost = kNone;
    std::uint32_t outer = kNone;  ///< its only outer ring, if it has one
  };

  [[nodiscard]] Step step_along(PieceId p) const {
    const Piece& piece = s_.pieces[p];
    return {p, piece.inside_above ? piece.low : piece.high};
  }
  [[nodiscard]] NodeId end_of(const Step& step) const {
    const Piece& piece = s_.pieces[step.piece];
    return step.from == piece.low ? piece.high : piece.low;
  }

  /// Returns the next step. Clockwise of the way back is area, up to the first boundary piece.
  [[nodiscard]] Step after(const Step& step) const {
    const NodeId node = end_of(step);
    const std::uint32_t begin = s_.first_around[node];
    const std::uint32_t end = s_.first_around[node + 1];
    const Piece& piece = s_.pieces[step.piece];
    const std::uint32_t back = node == piece.low ? piece.place_at_low : piece.place_at_high;
    for (std::uint32_t at = back;;) {
      cancellation_.check();
      at = (at == begin ? end : at) - 1;
      if (at == back) broken("the area's boundary ends at a node");
      const PieceId next = s_.around[at];
      if (!s_.pieces[next].is_boundary()) continue;
      const Step result = step_along(next);
      if (result.from != node) broken("the area's boundary is not directed");
      return result;
    }
  }

  /// Follows a walk. Whenever it comes back to a node, the steps since then are a ring of their
  /// own.
  void follow(PieceId first) {
    const auto walk = static_cast<std::uint32_t>(walks_.size());
    walks_.emplace_back();
    Step step = step_along(first);
    do {
      if (walk_of_[step.piece] != kNone) broken("two walks share a piece");
      walk_of_[step.piece] = walk;
      place_in_path_[step.from] = static_cast<std::uint32_t>(path_.size());
      path_.push_back(step);
      const std::uint32_t visited = place_in_path_[end_of(step)];
      if (visited != kNone) cut_off(visited, walk);
      step = after(step);
    } while (step.piece != first);
    if (!path_.empty()) broken("a walk along the area's boundary does not close");
  }

  void cut_off(std::uint32_t begin, std::uint32_t walk) {
    const std::span<Step> steps = std::span(path_).subspan(begin);
    cancellation_.check(4 * steps.size());
    for (const Step& step : steps) place_in_path_[step.from] = kNone;
    const auto smallest = std::min_element(
        steps.begin(), steps.end(), [](const Step& a, const Step& b) { return a.from < b.from; });
    std::rotate(steps.begin(), smallest, steps.end());
    AreaRing& ring = rings_.emplace_back();
    ring.walk = walk;
    Step before = steps.back();
    for (const Step& step : steps) {
      if (turns(before, step)) ring.corners.push_back(step.from);
      before = step;
    }
    if (ring.corners.size() < 3) broken("a ring of the area has no inside");
    // Both pieces at the smallest node go to the right. A ring around its inside leaves the node by
    // the lower one.
    ring.outer =
        s_.pieces[steps.front().piece].place_at_low < s_.pieces[steps.back().piece].place_at_low;
    Walk& whole = walks_[walk];
    whole.leftmost = std::min(whole.leftmost, steps.front().from);
    if (ring.outer) {
      if (whole.outer != kNone) broken("a connected part of the area has two outer rings");
      whole.outer = static_cast<std::uint32_t>(rings_.size() - 1);
    }
    path_.resize(begin);
  }
  [[nodiscard]] bool turns(const Step& a, const Step& b) const {
    const Piece& p = s_.pieces[a.piece];
    const Piece& q = s_.pieces[b.piece];
    return overlay::turns(segments_, p, q, (a.from == p.low) == (b.from == q.low));
  }

  /// Gives each walk its outer ring. A walk without one is a hole of the part of the area straight
  /// below its leftmost node. That part starts further left, so its outer ring is known by then.
  void assign_polygons() {
    std::vector<std::uint32_t> order(walks_.size());
    for (std::uint32_t w = 0; w < order.size(); ++w) order[w] = w;
    std::sort(order.begin(), order.end(), cancellation_.counting([&](auto a, auto b) {
      const bool a_hole = walks_[a].outer == kNone;
      const bool b_hole = walks_[b].outer == kNone;
      return std::tuple(a_hole, walks_[a].leftmost) < std::tuple(b_hole, walks_[b].leftmost);
    }));
    for (const std::uint32_t w : order) {
      if (walks_[w].outer != kNone) continue;
      const PieceId ground = s_.ground_left[walks_[w].leftmost];
      if (ground == kNone) broken("a hole of the area is in no outer ring");
      walks_[w].outer = walks_[walk_of_[ground]].outer;
      if (walks_[w].outer == kNone) broken("a hole of the area is in no outer ring");
    }
    for (AreaRing& ring : rings_) ring.polygon = walks_[ring.walk].outer;
  }

  void write(Region& area) const {
    std::vector<std::uint32_t> order(rings_.size());
    for (std::uint32_t r = 0; r < order.size(); ++r) order[r] = r;
    // Two rings differ in their first corners or in the next ones.
    const auto key = [&](std::uint32_t r) {
      const AreaRing& ring = rings_[r];
      const AreaRing& outer = rings_[ring.polygon];
      return std::tuple(outer.corners[0], outer.corners[1], !ring.outer, ring.corners[0],
                        ring.corners[1]);
    };
    std::sort(order.begin(), order.end(),
              cancellation_.counting([&](auto a, auto b) { return key(a) < key(b); }));
    for (const std::uint32_t r : order) {
      if (rings_[r].outer) area.begin_polygon();
      area.begin_ring();
      for (const NodeId node : rings_[r].corners) {
        cancellation_.check(2);
        add_vertex(segments_, s_.nodes[node], area);
      }
    }
  }

  const Segments& segments_;
  Cancellation& cancellation_;
  const Subdivision& s_;
  std::vector<std::uint32_t> walk_of_;        // by piece
  std::vector<std::uint32_t> place_in_path_;  // by node
  std::vector<Step> path_;
  std::vector<Walk> walks_;
  std::vector<AreaRing> rings_;
};

}  // namespace

void extract_area(const Segments& segments, const Subdivision& subdivision, Region& area) {
  AreaExtractor(segments, subdivision).run(area);
}

}  // namespace minksum::overlay
