// Turns segments and their contacts into nodes and pieces.
#include <algorithm>
#include <functional>
#include <numeric>

#include "machine/make_room.hpp"
#include "overlay/subdivision.hpp"

namespace minksum::overlay {
namespace {

class Subdivider {
 public:
  Subdivider(const Segments& segments, const Contacts& contacts, Subdivision& result)
      : segments_(segments),
        predicates_(segments.predicates),
        contacts_(contacts),
        cancellation_(segments.cancellation()),
        result_(result) {}

  void run() {
    number_nodes();
    list_stops();
    cut_segments();
    sort_pieces();
  }

 private:
  [[nodiscard]] std::size_t point_count() const { return segments_.sources.size(); }

  /// Numbers the nodes. Points are in order already; crossings are sorted and merged with them.
  void number_nodes() {
    const auto& crossings = contacts_.crossings;
    std::vector<Node> crossed;
    crossed.reserve(crossings.size());
    for (const Crossing& c : crossings) {
      cancellation_.check(4);
      const Ends& s = segments_.list[c.first].ends;
      const Ends& t = segments_.list[c.second].ends;
      crossed.push_back({predicates_.crossing(s, t), ExactLocation::of_crossing(s, t), false});
    }
    std::vector<std::uint32_t> order;
    resize_in_pieces(order, crossed.size(), cancellation_);
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), cancellation_.counting([&](auto a, auto b) {
      return a != b && compare(crossed[a], crossed[b]) == kNegative;
    }));
    resize_in_pieces(node_of_point_, point_count(), cancellation_);
    resize_in_pieces(node_of_crossing_, crossed.size(), cancellation_);
    result_.nodes.reserve(point_count() + crossed.size());
    PointId p = 0;
    for (const std::uint32_t c : order) {
      while (p < point_count() && compare(node_at(p), crossed[c]) != kPositive) add_point(p++);
      auto& nodes = result_.nodes;
      if (nodes.empty() || compare(nodes.back(), crossed[c]) != kZero) nodes.push_back(crossed[c]);
      node_of_crossing_[c] = last_node();
    }
    while (p < point_count()) add_point(p++);
  }
  [[nodiscard]] Sign compare(const Node& a, const Node& b) const {
    return predicates_.compare(a.at, a.place, b.at, b.place);
  }
  [[nodiscard]] Node node_at(PointId p) const {
    return {predicates_.point(p), ExactLocation::of_point(p), segments_.belongs[p] != 0};
  }
  void add_point(PointId p) {
    cancellation_.check();
    result_.nodes.push_back(node_at(p));
    node_of_point_[p] = last_node();
  }
  [[nodiscard]] NodeId last_node() const { return static_cast<NodeId>(result_.nodes.size() - 1); }

  /// Lists the nodes inside each segment, in order.
  void list_stops() {
    list_by_key(segments_.list.size(), cancellation_, first_stop_, stops_,
                [&](auto visit) { for_each_stop(visit); });
  }
  template <class Visit>
  void for_each_stop(Visit visit) const {
    cancellation_.check(contacts_.touches.size());
    for (const Touch& touch : contacts_.touches) visit(touch.segment, node_of_point_[touch.point]);
    for (std::size_t c = 0; c < contacts_.crossings.size(); ++c) {
      cancellation_.check(2);
      visit(contacts_.crossings[c].first, node_of_crossing_[c]);
      visit(contacts_.crossings[c].second, node_of_crossing_[c]);
    }
  }

  void cut_segments() {
    auto& pieces = result_.pieces;
    pieces.reserve(segments_.list.size() + stops_.size());
    for (SegmentId s = 0; s < segments_.list.size(); ++s) {
      const auto begin = stops_.begin() + first_stop_[s];
      const auto end = stops_.begin() + first_stop_[s + 1];
      std::sort(begin, end, cancellation_.counting(std::less<>()));
      const Segment& segment = segments_.list[s];
      NodeId from = node_of_point_[segment.ends.low];
      const auto cut_at = [&](NodeId to) {
        cancellation_.check();
        if (to == from) return;
        Piece& piece = pieces.emplace_back();
        piece.low = from;
        piece.high = to;
        piece.segment = s;
        static_cast<Share&>(piece) = segment;
        from = to;
      };
      std::for_each(begin, end, cut_at);
      cut_at(node_of_point_[segment.ends.high]);
    }
  }

  /// Sorts pieces by low node, merges equal ones, and sorts the pieces at a node by direction.
  void sort_pieces() {
    std::vector<Piece> unsorted;
    unsorted.swap(result_.pieces);
    const std::size_t count = result_.nodes.size();
    std::vector<std::uint32_t> place;
    assign_in_pieces(place, count + 1, 0U, cancellation_);
    visit_in_pieces(unsorted, cancellation_, [&](const Piece& piece) { ++place[piece.low + 1]; });
    std::partial_sum(place.begin(), place.end(), place.begin());
    resize_in_pieces(result_.pieces, unsorted.size(), cancellation_);
    for (const Piece& piece : unsorted) {
      cancellation_.check();
      result_.pieces[place[piece.low]++] = piece;
    }
    // Now place[v] is the end of the pieces of node v.
    result_.first_piece.assign(1, 0);
    std::size_t kept = 0;
    std::size_t begin = 0;
    for (NodeId v = 0; v < count; ++v) {
      cancellation_.check();
      const std::size_t end = place[v];
      kept += sort_at_node(begin, end, kept);
      begin = end;
      append(result_.first_piece, static_cast<std::uint32_t>(kept), cancellation_);
    }
    result_.pieces.resize(kept);
  }
  /// Moves the pieces [begin, end) to `to`, and returns how many are left.
  std::size_t sort_at_node(std::size_t begin, std::size_t end, std::size_t to) {
    const auto at = [&](std::size_t i) {
      return result_.pieces.begin() + static_cast<std::ptrdiff_t>(i);
    };
    if (end - begin > 1) {
      std::sort(at(begin), at(end), cancellation_.counting([](const Piece& a, const Piece& b) {
        return a.high < b.high;
      }));
    }
    const auto same = [](const Piece& a, const Piece& b) { return a.high == b.high; };
    const auto last = std::move(at(begin), merge_equal(at(begin), at(end), same), at(to));
    if (last - at(to) > 1) {
      std::sort(at(to), last, cancellation_.counting([&](const Piece& a, const Piece& b) {
        return a.segment != b.segment &&
               predicates_.cross(segments_.list[a.segment].ends, segments_.list[b.segment].ends) ==
                   kPositive;
      }));
    }
    return static_cast<std::size_t>(last - at(to));
  }

  const Segments& segments_;
  const Predicates& predicates_;
  const Contacts& contacts_;
  Cancellation& cancellation_;
  Subdivision& result_;
  std::vector<NodeId> node_of_point_;
  std::vector<NodeId> node_of_crossing_;
  std::vector<std::uint32_t> first_stop_;
  std::vector<NodeId> stops_;
};

}  // namespace

Subdivision subdivide(const Segments& segments, const Contacts& contacts) {
  Subdivision result;
  Subdivider(segments, contacts, result).run();
  return result;
}

}  // namespace minksum::overlay
