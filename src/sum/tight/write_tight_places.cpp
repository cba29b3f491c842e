// Writes slits and nodes as polylines and points with exact coordinates, in canonical order.
#include <algorithm>
#include <functional>

#include "region/point_arithmetic.hpp"
#include "region/rational_access.hpp"
#include "sum/tight/tight.hpp"

namespace minksum {
namespace {

bool polyline_less(const Polyline& a, const Polyline& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), comes_before);
}

class TightWriter {
 public:
  TightWriter(const Operands& operands, const Arrangement& arrangement, const TightPlaces& places,
              Cancellation& cancellation, Geometry& geometry)
      : cancellation_(cancellation),
        kernel_(*operands.kernel),
        arrangement_(arrangement),
        places_(places),
        result_(geometry) {}

  void run() {
    write_polylines();
    for (const NodeId node : places_.nodes) result_.points.push_back(point(node));
    for (const SumVertex& v : places_.pinches) {
      result_.points.push_back(point(NodePoint{false, {}, {}, v}));
    }
    const auto before = [&](const auto& a, const auto& b) { return comes_before(a, b); };
    std::sort(result_.points.begin(), result_.points.end(), cancellation_.counting(before));
    result_.points.erase(std::unique(result_.points.begin(), result_.points.end()),
                         result_.points.end());
  }

 private:
  /// One end of a slit at a node. `end` is 2 · slit, and one more for the slit's second end.
  struct End {
    NodeId node;
    std::uint32_t end;
    friend auto operator<=>(const End&, const End&) = default;
  };

  void write_polylines() {
    for (std::uint32_t i = 0; i < places_.slits.size(); ++i) {
      ends_.push_back({slit(i).from, 2 * i});
      ends_.push_back({slit(i).to, 2 * i + 1});
    }
    std::sort(ends_.begin(), ends_.end(), cancellation_.counting(std::less<>()));
    written_.assign(places_.slits.size(), 0);
    // Paths end where one slit ends, or where three or more meet. Slits that are left then make
    // closed paths.
    for (const End& e : ends_) {
      if (ends_at(e.node).size() != 2 && written_[e.end / 2] == 0) follow(e.end, true);
    }
    for (const End& e : ends_) {
      if (written_[e.end / 2] == 0) follow(e.end, false);
    }
    std::sort(result_.polylines.begin(), result_.polylines.end(),
              cancellation_.counting(polyline_less));
  }

  /// Writes the path from one end of a slit on, as far as exactly one other slit goes on.
  void follow(std::uint32_t first, bool ends_are_fixed) {
    Polyline path{point(node_of(first))};
    std::uint32_t end = first;
    while (true) {
      written_[end / 2] = 1;
      const std::uint32_t other = end ^ 1U;
      const auto at = ends_at(node_of(other));
      const std::uint32_t next = at.size() != 2       ? first
                                 : at[0].end == other ? at[1].end
                                                      : at[0].end;
      const bool closed = written_[next / 2] != 0;
      const bool straight = line(end) == line(next) && at.size() == 2;
      if (closed || !straight) path.push_back(point(node_of(other)));
      if (closed) break;
      end = next;
    }
    if (!ends_are_fixed) start_at_smallest(path, line(end) == line(first));
    if (path.front() == path.back() ? comes_before(path[path.size() - 2], path[1])
                                    : comes_before(path.back(), path.front())) {
      std::reverse(path.begin(), path.end());
    }
    result_.polylines.push_back(std::move(path));
  }
  static void start_at_smallest(Polyline& closed, bool straight_at_start) {
    closed.pop_back();
    if (straight_at_start) closed.erase(closed.begin());
    std::rotate(closed.begin(), std::min_element(closed.begin(), closed.end(), comes_before),
                closed.end());
    closed.push_back(closed.front());
  }

  [[nodiscard]] const Piece& slit(std::uint32_t i) const {
    return arrangement_.slits[places_.slits[i]];
  }
  [[nodiscard]] NodeId node_of(std::uint32_t end) const {
    return end % 2 == 0 ? slit(end / 2).from : slit(end / 2).to;
  }
  [[nodiscard]] std::uint32_t line(std::uint32_t end) const {
    return arrangement_.kept[slit(end / 2).segment].line;
  }
  [[nodiscard]] std::span<const End> ends_at(NodeId node) const {
    const auto begin = std::lower_bound(ends_.begin(), ends_.end(), End{node, 0});
    const auto end = std::lower_bound(begin, ends_.end(), End{node + 1, 0});
    return {begin, end};
  }

  [[nodiscard]] Point point(NodeId node) { return point(arrangement_.nodes[node].point); }
  [[nodiscard]] Point point(const NodePoint& node) {
    cancellation_.check(4 * kernel_.work());
    kernel_.coordinates(node, scratch_);
    return {value(scratch_.x), value(scratch_.y)};
  }
  [[nodiscard]] Rational value(const ExactCoordinate& c) const {
    return RationalAccess::make(BigInteger(c.numerator, c.negative), BigInteger(c.denominator),
                                kernel_.exp2(), kernel_.exp10());
  }

  Cancellation& cancellation_;
  const ExactKernel& kernel_;
  const Arrangement& arrangement_;
  const TightPlaces& places_;
  Geometry& result_;
  std::vector<End> ends_;
  std::vector<std::uint8_t> written_;
  Vec<ExactCoordinate> scratch_;
};

}  // namespace

void write_tight_places(const Operands& operands, const Arrangement& arrangement,
                        const TightPlaces& places, Cancellation& cancellation, Geometry& geometry) {
  geometry = {};
  TightWriter(operands, arrangement, places, cancellation, geometry).run();
}

}  // namespace minksum
