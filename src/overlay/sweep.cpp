// Finds the winding numbers on both sides of every piece.
#include <algorithm>

#include "machine/make_room.hpp"
#include "overlay/subdivision.hpp"
#include "spatial/sweep_status.hpp"

namespace minksum::overlay {
namespace {

class Sweep {
 public:
  Sweep(const Segments& segments, const Rule& rule, Subdivision& s)
      : segments_(segments), rule_(rule), cancellation_(segments.cancellation()), s_(s) {}

  void run() {
    resize_in_pieces(slot_of_, s_.pieces.size(), cancellation_);
    resize_in_pieces(above_, s_.pieces.size(), cancellation_);
    s_.around.reserve(2 * s_.pieces.size());
    s_.first_around.reserve(s_.nodes.size() + 1);
    s_.inside_left.reserve(s_.nodes.size());
    s_.ground_left.reserve(s_.nodes.size());
    find_ending();
    for (NodeId v = 0; v < s_.nodes.size(); ++v) {
      cancellation_.check(4 + s_.first_piece[v + 1] - s_.first_piece[v]);
      pass(v);
    }
    s_.first_around.push_back(static_cast<std::uint32_t>(s_.around.size()));
  }

 private:
  /// Finds, for each node, some piece that ends there.
  void find_ending() {
    assign_in_pieces(ending_, s_.nodes.size(), kNone, cancellation_);
    PieceId p = 0;
    visit_in_pieces(s_.pieces, cancellation_,
                    [&](const Piece& piece) { ending_[piece.high] = p++; });
  }

  void pass(NodeId v) {
    list_ended(v);
    const bool met =
        !ended_.empty() || s_.nodes[v].belongs || s_.first_piece[v] != s_.first_piece[v + 1];
    const SlotId under = !ended_.empty() ? status_.below(ended_.front())
                         : met           ? search(v)
                                         : SweepStatus::kGround;
    Winding winding = winding_above(under);
    PieceId ground = ground_above(under);
    s_.inside_left.push_back(rule_.inside(winding) ? 1 : 0);
    s_.ground_left.push_back(ground);
    s_.first_around.push_back(static_cast<std::uint32_t>(s_.around.size()));
    for (PieceId p = s_.first_piece[v]; p < s_.first_piece[v + 1]; ++p) {
      start(p, winding, ground);
    }
    for (std::size_t i = ended_.size(); i-- > 0;) {
      const PieceId p = status_.segment(ended_[i]);
      s_.pieces[p].place_at_high = static_cast<std::uint32_t>(s_.around.size());
      s_.around.push_back(p);
    }
    if (s_.nodes[v].belongs) s_.nodes[v].belongs = is_kept(v, under);
    exchange(v, under);
  }

  /// Tells whether the rule keeps a point in one of the faces around this node.
  [[nodiscard]] bool is_kept(NodeId v, SlotId under) const {
    const auto keeps_in = [&](const Winding& face) { return rule_.keeps({face, face, true, 0}); };
    const auto keeps_above = [&](PieceId p) { return keeps_in(above_[p]); };
    const auto ends_kept = [&](SlotId slot) { return keeps_above(status_.segment(slot)); };
    if (keeps_in(winding_above(under))) return true;
    if (std::any_of(ended_.begin(), ended_.end(), ends_kept)) return true;
    for (PieceId p = s_.first_piece[v]; p < s_.first_piece[v + 1]; ++p) {
      if (keeps_above(p)) return true;
    }
    return false;
  }

  /// Lists the slots whose pieces end here, from bottom to top. These slots are neighbours.
  void list_ended(NodeId v) {
    ended_.clear();
    if (ending_[v] == kNone) return;
    const auto ends_here = [&](SlotId slot) {
      return slot != SweepStatus::kGround && slot != kNone &&
             s_.pieces[status_.segment(slot)].high == v;
    };
    SlotId slot = slot_of_[ending_[v]];
    while (ends_here(status_.below(slot))) slot = status_.below(slot);
    for (; ends_here(slot); slot = status_.above(slot)) ended_.push_back(slot);
  }

  [[nodiscard]] SlotId search(NodeId v) const {
    const Node& node = s_.nodes[v];
    return status_.search([&](PieceId p) {
      cancellation_.check(4);
      const Ends& line = segments_.list[s_.pieces[p].segment].ends;
      const Sign side = segments_.predicates.orientation(line, node.at, node.place);
      if (side == kZero) broken("a node lies inside a piece");
      return side == kPositive;
    });
  }

  [[nodiscard]] Winding winding_above(SlotId slot) const {
    return slot == SweepStatus::kGround ? Winding{} : above_[status_.segment(slot)];
  }
  [[nodiscard]] PieceId ground_above(SlotId slot) const {
    return slot == SweepStatus::kGround ? kNone : ground_above_piece(status_.segment(slot));
  }
  [[nodiscard]] PieceId ground_above_piece(PieceId p) const {
    const Piece& piece = s_.pieces[p];
    if (!piece.inside_above) return kNone;
    return piece.is_boundary() ? p : piece.ground;
  }

  /// Adds the next piece counter-clockwise. `winding` and `ground` are those below it at first, and
  /// those above it afterwards.
  void start(PieceId p, Winding& winding, PieceId& ground) {
    Piece& piece = s_.pieces[p];
    const Winding below = winding;
    piece.inside_below = rule_.inside(below);
    piece.ground = piece.inside_below ? ground : kNone;
    winding = winding + piece.change;
    piece.inside_above = rule_.inside(winding);
    piece.thin = !piece.inside_below && !piece.inside_above &&
                 rule_.keeps({winding, below, piece.belongs, piece.spared});
    above_[p] = winding;
    ground = ground_above_piece(p);
    piece.place_at_low = static_cast<std::uint32_t>(s_.around.size());
    s_.around.push_back(p);
  }

  /// Gives the slots of the pieces that end here to those that start here.
  void exchange(NodeId v, SlotId under) {
    std::size_t used = 0;
    SlotId last = under;
    for (PieceId p = s_.first_piece[v]; p < s_.first_piece[v + 1]; ++p) {
      if (used < ended_.size()) {
        last = ended_[used++];
        status_.set_segment(last, p);
      } else {
        last = status_.insert_above(last, p);
      }
      slot_of_[p] = last;
    }
    while (used < ended_.size()) status_.erase(ended_[used++]);
  }

  const Segments& segments_;
  const Rule& rule_;
  Cancellation& cancellation_;
  Subdivision& s_;
  SweepStatus status_;
  std::vector<SlotId> slot_of_;  // by piece
  std::vector<Winding> above_;   // by piece
  std::vector<PieceId> ending_;  // by node
  std::vector<SlotId> ended_;
};

}  // namespace

void sweep(const Segments& segments, const Rule& rule, Subdivision& subdivision) {
  Sweep(segments, rule, subdivision).run();
}

}  // namespace minksum::overlay
