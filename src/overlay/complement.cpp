#include "overlay/complement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <vector>

#include "machine/cancellation.hpp"
#include "overlay/rounded_vertices.hpp"
#include "spatial/box_pairs.hpp"

namespace minksum {
namespace {

/// Tells whether one box contains another, and lets boxes touch.
bool has(const ErrorBounds& outer, const ErrorBounds& inner) {
  return outer.x0 <= inner.x0 && outer.y0 <= inner.y0 && outer.x1 >= inner.x1 &&
         outer.y1 >= inner.y1;
}

constexpr std::size_t kNone = ~std::size_t{0};

/// A ring of the region, with its position in the region.
struct RingIndex {
  std::size_t polygon;
  bool is_hole;
  IndexRange vertices;
  ErrorBounds bounds{};
  std::size_t first = 0;  ///< its lexicographically smallest vertex
  bool counter_clockwise = true;
  std::size_t around = kNone;  ///< the innermost hole in which an outer ring lies

  [[nodiscard]] std::size_t last() const { return vertices.front() + vertices.size() - 1; }
  [[nodiscard]] std::size_t next(std::size_t v) const {
    return v == last() ? vertices.front() : v + 1;
  }
  [[nodiscard]] std::size_t previous(std::size_t v) const {
    return v == vertices.front() ? last() : v - 1;
  }
};

/// Turns a region's rings into those of its complement in a box.
class InsideOut {
 public:
  InsideOut(const Box& box, const Region& region, const Options& options)
      : cancellation_(options, Stage::kOverlay),
        exact_box_(box),
        region_(region),
        places_(region, cancellation_) {
    box_.add({box.min.x.to_double(), box.min.y.to_double()});
    box_.add({box.max.x.to_double(), box.max.y.to_double()});
  }

  /// Returns nothing if it is not certain that the rings can be copied.
  std::optional<Region> run() {
    if (region_.empty() || !places_.usable()) return std::nullopt;
    if (!list_rings() || !place_rings() || touches_itself() || !find_holes_around() ||
        !turns_everywhere()) {
      return std::nullopt;
    }
    write();
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool list_rings() {
    for (const std::size_t polygon : region_.polygons()) {
      bool is_hole = false;
      for (const std::size_t ring : region_.rings_of(polygon)) {
        if (region_.vertices_of(ring).size() < 3) return false;
        rings_.push_back({polygon, is_hole, region_.vertices_of(ring)});
        measure(rings_.back());
        is_hole = true;
      }
    }
    return nearly_straight_.size() <= region_.vertex_count() / kExactTurnsOf + 1;
  }
  void measure(RingIndex& ring) {
    ring.first = ring.vertices.front();
    for (const std::size_t v : ring.vertices) {
      cancellation_.check(4);
      ring.bounds.add(places_[v]);
      if (places_.is_before(v, ring.first)) ring.first = v;
      const Sign turn = places_.side(places_[ring.previous(v)], places_[v], places_[ring.next(v)]);
      if (turn == kZero) nearly_straight_.push_back({ring.previous(v), v, ring.next(v)});
    }
    const std::size_t u = ring.previous(ring.first);
    const std::size_t w = ring.next(ring.first);
    Sign turn = places_.side(places_[u], places_[ring.first], places_[w]);
    if (turn == kZero) turn = exact_turn({u, ring.first, w});
    ring.counter_clockwise = turn == kPositive;
  }

  /// Three consecutive vertices of a ring.
  using Corner = std::array<std::size_t, 3>;

  /// Tells whether every vertex turns, as in canonical rings.
  [[nodiscard]] bool turns_everywhere() const {
    return std::ranges::all_of(nearly_straight_,
                               [this](const Corner& at) { return exact_turn(at) != kZero; });
  }
  [[nodiscard]] Sign exact_turn(const Corner& corner) const {
    const Point a = region_.point(corner[0]);
    cancellation_.check(work_of(a));
    const Point b = region_.point(corner[1]);
    const Point c = region_.point(corner[2]);
    const Rational turn = (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
    return sign_of(turn.sign());
  }

  /// Tells whether all rings are strictly inside the box, but for one that may go around it.
  [[nodiscard]] bool place_rings() {
    const double margin = 4 * std::max(places_.error(), largest_of_box() * 0x1p-52);
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      const ErrorBounds& b = rings_[r].bounds;
      if (b.x0 > box_.x0 + margin && b.y0 > box_.y0 + margin && b.x1 < box_.x1 - margin &&
          b.y1 < box_.y1 - margin) {
        continue;
      }
      if (frame_ != kNone || rings_[r].is_hole || !is_around_box(rings_[r], margin)) return false;
      frame_ = r;
    }
    return true;
  }
  [[nodiscard]] double largest_of_box() const {
    return std::max({std::abs(box_.x0), std::abs(box_.y0), std::abs(box_.x1), std::abs(box_.y1)});
  }
  /// Tells whether a ring certainly goes around the box. The box must be inside the ring. Each edge
  /// must lie beyond one side of the box, or have the box on the ring's inner side.
  [[nodiscard]] bool is_around_box(const RingIndex& ring, double margin) const {
    const std::array<Vec<double>, 4> corners{
        {{box_.x0, box_.y0}, {box_.x1, box_.y0}, {box_.x1, box_.y1}, {box_.x0, box_.y1}}};
    if (!(ring.bounds.x0 < box_.x0 - margin && ring.bounds.y0 < box_.y0 - margin &&
          ring.bounds.x1 > box_.x1 + margin && ring.bounds.y1 > box_.y1 + margin)) {
      return false;
    }
    // The box lies in one face of the ring. A ray to the left from its lower left corner tells
    // which. If the box is inside, the ray meets the ring an odd number of times.
    bool inside = false;
    std::size_t from = ring.last();
    const Sign inner_side = ring.counter_clockwise ? kPositive : kNegative;
    for (const std::size_t to : ring.vertices) {
      cancellation_.check(2);
      const Vec<double>& a = places_[from];
      const Vec<double>& b = places_[to];
      const bool beyond = (a.x < box_.x0 - margin && b.x < box_.x0 - margin) ||
                          (a.y < box_.y0 - margin && b.y < box_.y0 - margin) ||
                          (a.x > box_.x1 + margin && b.x > box_.x1 + margin) ||
                          (a.y > box_.y1 + margin && b.y > box_.y1 + margin);
      const auto is_inner = [&](const Vec<double>& corner) {
        return places_.side(a, b, corner) == inner_side;
      };
      if (!beyond && !std::ranges::all_of(corners, is_inner)) return false;
      if (std::abs(a.y - box_.y0) <= margin || std::abs(b.y - box_.y0) <= margin) return false;
      if ((a.y > box_.y0) != (b.y > box_.y0)) {
        const Sign side = places_.side(a, b, corners[0]);
        if (side == kZero) return false;
        if ((side == kPositive) == (b.y < a.y)) inside = !inside;
      }
      from = to;
    }
    return inside;
  }

  /// Tells whether the average edge has so many others over it that comparing edges takes long.
  [[nodiscard]] bool lie_over_each_other() const {
    constexpr double kMostInColumn = 400;
    double across = 0;
    for (const RingIndex& ring : rings_) {
      for (const std::size_t v : ring.vertices) {
        across += std::abs(places_[ring.next(v)].x - places_[v].x);
      }
    }
    return across > kMostInColumn * (places_.bounds().x1 - places_.bounds().x0);
  }
  /// Tells whether edges may touch that are not neighbours, or telling it would take long.
  [[nodiscard]] bool touches_itself() {
    if (lie_over_each_other()) return true;
    std::vector<std::size_t> next(region_.vertex_count());
    const ErrorBounds& all = places_.bounds();
    BoxPairScratch scratch;
    BoxPairs pairs(all.x1 - all.x0, all.y1 - all.y0, 4 * places_.error(), scratch);
    for (const RingIndex& ring : rings_) {
      for (const std::size_t v : ring.vertices) {
        next[v] = ring.next(v);
        const Vec<double>& a = places_[v];
        const Vec<double>& b = places_[next[v]];
        pairs.add(std::min(a.x, b.x) - all.x0, std::min(a.y, b.y) - all.y0,
                  std::max(a.x, b.x) - all.x0, std::max(a.y, b.y) - all.y0);
      }
    }
    bool touches = false;
    pairs.for_each(
        [&](std::size_t e, std::size_t f) {
          cancellation_.check(2);
          if (touches || next[e] == f || next[f] == e) return;
          touches = !places_.apart(e, next[e], f, next[f]);
        },
        cancellation_);
    return touches;
  }

  /// Finds the innermost hole around each outer ring. Returns false if that takes long or is not
  /// certain.
  [[nodiscard]] bool find_holes_around() {
    // An overlay takes longer than this many steps.
    constexpr std::size_t kStepsPerVertex = 32;
    const std::size_t most = kStepsPerVertex * region_.vertex_count();
    std::size_t steps = 0;
    std::vector<std::size_t> holes;
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      if (rings_[r].is_hole) holes.push_back(r);
    }
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      RingIndex& ring = rings_[r];
      if (ring.is_hole || r == frame_) continue;
      steps += holes.size();
      cancellation_.check(holes.size());
      for (const std::size_t h : holes) {
        const RingIndex& hole = rings_[h];
        if (hole.polygon == ring.polygon || !has(hole.bounds, ring.bounds)) continue;
        // If two holes go around one ring, one hole lies in the other.
        if (ring.around != kNone && has(hole.bounds, rings_[ring.around].bounds)) {
          if (has(rings_[ring.around].bounds, hole.bounds)) return false;
          continue;
        }
        steps += hole.vertices.size();
        if (steps > most) return false;
        const std::optional<bool> inside = is_inside(ring, hole);
        if (!inside) return false;
        if (*inside) ring.around = h;
      }
      if (steps > most) return false;
      if (frame_ != kNone && ring.around == kNone) return false;
    }
    return true;
  }
  [[nodiscard]] std::optional<bool> is_inside(const RingIndex& ring, const RingIndex& hole) const {
    constexpr std::size_t kTries = 8;
    for (std::size_t k = 0; k < std::min(kTries, ring.vertices.size()); ++k) {
      if (const auto inside = places_.is_inside(ring.vertices.front() + k, hole.vertices)) {
        return inside;
      }
    }
    return std::nullopt;
  }

  void write() {
    result_ = {};
    const auto limbs = RegionAccess::limbs(region_);
    RegionAccess::reserve(result_, {region_.vertex_count() + 4, 0, rings_.size() + 1,
                                    rings_.size() + 1, limbs.size()});
    RegionAccess::append_limbs(result_, limbs);
    std::vector<std::size_t> order(rings_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    // Rings that do not touch have no common vertex.
    std::ranges::sort(order, cancellation_.counting([&](std::size_t r, std::size_t s) {
      return places_.is_before(rings_[r].first, rings_[s].first);
    }));
    std::vector<std::vector<std::size_t>> inner(rings_.size());
    std::vector<std::size_t> outermost;
    for (const std::size_t r : order) {
      if (rings_[r].is_hole || r == frame_) continue;
      (rings_[r].around == kNone ? outermost : inner[rings_[r].around]).push_back(r);
    }
    if (frame_ == kNone) {
      // The box is the first ring, because no vertex lies further left.
      result_.begin_polygon();
      result_.begin_ring();
      result_.add_vertex(exact_box_.min.x, exact_box_.min.y);
      result_.add_vertex(exact_box_.max.x, exact_box_.min.y);
      result_.add_vertex(exact_box_.max.x, exact_box_.max.y);
      result_.add_vertex(exact_box_.min.x, exact_box_.max.y);
      for (const std::size_t r : outermost) write(rings_[r], false);
    }
    for (const std::size_t r : order) {
      if (!rings_[r].is_hole) continue;
      result_.begin_polygon();
      write(rings_[r], true);
      for (const std::size_t s : inner[r]) write(rings_[s], false);
    }
  }
  void write(const RingIndex& ring, bool counter_clockwise) {
    result_.begin_ring();
    std::size_t v = ring.first;
    do {
      cancellation_.check();
      RegionAccess::add_vertex(result_, RegionAccess::x(region_, v), RegionAccess::y(region_, v));
      v = ring.counter_clockwise == counter_clockwise ? ring.next(v) : ring.previous(v);
    } while (v != ring.first);
  }

  /// If more than one vertex in so many needs an exact decision, an overlay is as good.
  static constexpr std::size_t kExactTurnsOf = 16;

  mutable Cancellation cancellation_;  ///< mutable, because questions are counted, too
  const Box& exact_box_;
  const Region& region_;
  ErrorBounds box_;
  ApproximatePoints places_;
  std::vector<RingIndex> rings_;
  std::vector<Corner> nearly_straight_;
  std::size_t frame_ = kNone;  ///< the ring around the box
  Region result_;
};

}  // namespace

std::optional<Region> complement_in(const Box& box, const Region& region, const Options& options) {
  return InsideOut(box, region, options).run();
}

}  // namespace minksum
