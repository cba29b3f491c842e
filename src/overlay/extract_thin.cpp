// Extracts the parts of the result outside of its area: polylines and points.
#include <algorithm>
#include <functional>

#include "machine/make_room.hpp"
#include "overlay/subdivision.hpp"
#include "overlay/write_node.hpp"

namespace minksum::overlay {
namespace {

class ThinExtractor {
 public:
  ThinExtractor(const Segments& segments, const Subdivision& subdivision)
      : segments_(segments), cancellation_(segments.cancellation()), s_(subdivision) {}

  void run(Geometry& geometry) {
    assign_in_pieces(done_, s_.pieces.size(), std::uint8_t{0}, cancellation_);
    describe_nodes();
    for (NodeId v = 0; v < s_.nodes.size(); ++v) {
      if (is_end(v)) follow_from(v);
    }
    // Only closed paths that meet nothing are left. The first node met is the smallest.
    for (NodeId v = 0; v < s_.nodes.size(); ++v) follow_from(v);
    write(geometry);
  }

 private:
  using Path = std::vector<NodeId>;

  void describe_nodes() {
    assign_in_pieces(thin_degree_, s_.nodes.size(), 0U, cancellation_);
    assign_in_pieces(on_area_, s_.nodes.size(), std::uint8_t{0}, cancellation_);
    for (const Piece& piece : s_.pieces) {
      cancellation_.check();
      for (const NodeId v : {piece.low, piece.high}) {
        if (piece.thin) ++thin_degree_[v];
        if (piece.inside_above || piece.inside_below) on_area_[v] = 1;
      }
    }
  }
  /// Tells whether paths end here: at tips, branches and the area.
  [[nodiscard]] bool is_end(NodeId v) const { return thin_degree_[v] != 2 || on_area_[v] != 0; }

  void follow_from(NodeId v) {
    cancellation_.check(1 + s_.first_around[v + 1] - s_.first_around[v]);
    for (std::uint32_t i = s_.first_around[v]; i < s_.first_around[v + 1]; ++i) {
      const PieceId p = s_.around[i];
      if (s_.pieces[p].thin && done_[p] == 0) follow(v, p);
    }
  }

  /// Adds the corners of the path from `start` along `p` to its next end.
  void follow(NodeId start, PieceId p) {
    Path path{start};
    NodeId at = start;
    PieceId before = kNone;
    for (;;) {
      cancellation_.check(2);
      done_[p] = 1;
      const Piece& piece = s_.pieces[p];
      const bool goes_up = piece.low == at;
      if (before != kNone &&
          turns(segments_, s_.pieces[before], piece, (s_.pieces[before].high == at) == goes_up)) {
        path.push_back(at);
      }
      at = goes_up ? piece.high : piece.low;
      if (at == start || is_end(at)) break;
      before = std::exchange(p, other_piece(at, p));
    }
    path.push_back(at);
    const bool closed = path.front() == path.back();
    const bool backwards = closed ? path[path.size() - 2] < path[1] : path.back() < path.front();
    if (backwards) std::reverse(path.begin(), path.end());
    if (paths_.size() == paths_.capacity()) move_to_larger(paths_, 1, cancellation_);
    paths_.push_back(std::move(path));
  }
  [[nodiscard]] PieceId other_piece(NodeId v, PieceId p) const {
    for (std::uint32_t i = s_.first_around[v]; i < s_.first_around[v + 1]; ++i) {
      const PieceId q = s_.around[i];
      if (q != p && s_.pieces[q].thin) return q;
    }
    broken("a path does not go on at a node");
  }

  void write(Geometry& geometry) {
    std::sort(paths_.begin(), paths_.end(), cancellation_.counting(std::less<>()));
    geometry.polylines.reserve(paths_.size());  // a longer list would be moved in one step
    for (const Path& path : paths_) {
      Polyline& line = geometry.polylines.emplace_back();
      for (const NodeId v : path) {
        cancellation_.check(8);
        line.push_back(exact_point(segments_, s_.nodes[v]));
      }
    }
    clear_in_pieces(paths_, cancellation_);
    for (NodeId v = 0; v < s_.nodes.size(); ++v) {
      const Node& node = s_.nodes[v];
      cancellation_.check();
      if (!node.belongs || thin_degree_[v] != 0 || on_area_[v] != 0) continue;
      if (s_.inside_left[v] == 0) geometry.points.push_back(exact_point(segments_, node));
    }
  }

  const Segments& segments_;
  Cancellation& cancellation_;
  const Subdivision& s_;
  std::vector<std::uint8_t> done_;          // by piece
  std::vector<std::uint32_t> thin_degree_;  // by node
  std::vector<std::uint8_t> on_area_;       // by node
  std::vector<Path> paths_;
};

}  // namespace

void extract_thin(const Segments& segments, const Subdivision& subdivision, Geometry& geometry) {
  ThinExtractor(segments, subdivision).run(geometry);
}

}  // namespace minksum::overlay
