#include "overlay/complement.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "machine/make_room.hpp"
#include "region/point_arithmetic.hpp"
#include "region/region_access.hpp"
#include "spatial/segment_sweep.hpp"

namespace minksum {
namespace {

using Vertex = std::uint32_t;
using RingId = std::uint32_t;
constexpr std::uint32_t kNone = 0xFFFFFFFFU;

/// Decides about the vertices of a region: by their nearest doubles, and exactly where these cannot
/// tell.
class ApproximateVertices {
 public:
  ApproximateVertices(const Region& region, Cancellation& cancellation)
      : region_(region), cancellation_(cancellation) {
    at_.resize(region.vertex_count());
    for (Vertex v = 0; v < at_.size(); ++v) {
      cancellation.check(work_of_product(RegionAccess::bits(region, v)));
      at_[v] = {region.x(v), region.y(v)};
      largest_ = std::max({largest_, std::abs(at_[v].x), std::abs(at_[v].y)});
    }
    // Let M be the largest magnitude. Differences are off by M·2^-51 at most, and so two products
    // of differences by less than M²·2^-47. Their roundings are less than that, too.
    doubt_ = largest_ * largest_ * 0x1p-46;
  }
  /// Tells whether products of two differences neither overflow nor vanish.
  [[nodiscard]] bool usable() const { return largest_ > 0x1p-400 && largest_ < 0x1p400; }

  /// Returns the side of the line from a to b on which p lies.
  [[nodiscard]] Sign side(Vertex a, Vertex b, Vertex p) const {
    const Vec<double> d{at_[b].x - at_[a].x, at_[b].y - at_[a].y};
    const Vec<double> q{at_[p].x - at_[a].x, at_[p].y - at_[a].y};
    const double value = cross(d, q);
    if (value > doubt_) return kPositive;
    if (value < -doubt_) return kNegative;
    const Point from = region_.point(a);
    cancellation_.check(work_of(from));
    return sign_of(cross(minus(region_.point(b), from), minus(region_.point(p), from)).sign());
  }
  /// Tells whether v comes before w by x, then by y. Nearest doubles that differ have the order of
  /// the numbers.
  [[nodiscard]] bool is_before(Vertex v, Vertex w) const {
    if (at_[v].x != at_[w].x) return at_[v].x < at_[w].x;
    cancellation_.check(work_of_product(RegionAccess::bits(region_, v)));
    const auto by_x =
        RegionAccess::compare(region_, RegionAccess::x(region_, v), RegionAccess::x(region_, w));
    if (by_x != 0) return by_x < 0;
    if (at_[v].y != at_[w].y) return at_[v].y < at_[w].y;
    return RegionAccess::compare(region_, RegionAccess::y(region_, v),
                                 RegionAccess::y(region_, w)) < 0;
  }

 private:
  const Region& region_;
  Cancellation& cancellation_;
  std::vector<Vec<double>> at_;
  double largest_ = 0;  ///< magnitude of a coordinate
  double doubt_ = 0;    ///< bound on the error of a cross product
};

/// Turns a region's rings into those of its complement in a box.
class InsideOut {
 public:
  InsideOut(const Box& box, const Region& region, const Options& options)
      : cancellation_(options, Stage::kOverlay),
        region_(with_box(region, box)),
        vertices_(region_, cancellation_),
        sweep_(*this, cancellation_, scratch_) {}

  std::optional<Region> run() {
    if (!vertices_.usable() || !connect()) return std::nullopt;
    sort_vertices();
    sweep_.start(order_.size());
    for (std::size_t i = 0; i < order_.size(); ++i) {
      if (i > 0 && !vertices_.is_before(order_[i - 1], order_[i])) return std::nullopt;
      if (!pass(order_[i]) || any_crossing_) return std::nullopt;
    }
    return write();
  }

  // What SegmentSweep asks for. An edge has the number of the vertex where it starts.
  [[nodiscard]] Vertex low_end(Vertex e) const { return runs_right(e) ? e : next_[e]; }
  [[nodiscard]] Vertex high_end(Vertex e) const { return runs_right(e) ? next_[e] : e; }
  [[nodiscard]] std::uint32_t place(Vertex v) const { return place_[v]; }
  [[nodiscard]] Sign side(Vertex e, Vertex v) const {
    return vertices_.side(low_end(e), high_end(e), v);
  }
  void suspect(Vertex) { any_crossing_ = true; }
  [[nodiscard]] static bool is_suspect(Vertex) { return false; }
  void started(Vertex e, SlotId below) {
    RingNesting& ring = rings_[ring_of_[e]];
    if (ring.first != kNone) return;
    // The sweep comes to a ring by its smallest vertex. Rings around it have been met before.
    ring.first = low_end(e);
    ring.counter_clockwise =
        vertices_.side(previous_[ring.first], ring.first, next_[ring.first]) == kPositive;
    nest(ring_of_[e], below == SweepStatus::kGround ? kNone : sweep_.status().segment(below));
  }

 private:
  struct RingNesting {
    Vertex first = kNone;  ///< the smallest one
    bool counter_clockwise = false;
    RingId around = kNone;    ///< the smallest ring around this one
    bool in_box = false;      ///< whether this is the box, or a ring inside the box
    bool covered = false;     ///< whether the region is right outside the ring
    std::size_t polygon = 0;  ///< of the complement: the one right inside the ring
  };

  static Region with_box(Region region, const Box& box) {
    region.begin_polygon();
    region.begin_ring();
    region.add_vertex(box.min.x, box.min.y);
    region.add_vertex(box.max.x, box.min.y);
    region.add_vertex(box.max.x, box.max.y);
    region.add_vertex(box.min.x, box.max.y);
    return region;
  }
  /// Returns false if a ring is too short.
  [[nodiscard]] bool connect() {
    const std::size_t n = region_.vertex_count();
    next_.resize(n);
    previous_.resize(n);
    ring_of_.resize(n);
    rings_.resize(region_.ring_count());
    for_each_edge(region_, [&](std::size_t v, std::size_t w) {
      cancellation_.check();
      next_[v] = static_cast<Vertex>(w);
      previous_[w] = static_cast<Vertex>(v);
    });
    for (RingId r = 0; r < rings_.size(); ++r) {
      const IndexRange vertices = region_.vertices_of(r);
      if (vertices.size() < 3) return false;
      for (const std::size_t v : vertices) ring_of_[v] = r;
    }
    return true;
  }
  void sort_vertices() {
    order_.resize(next_.size());
    std::iota(order_.begin(), order_.end(), 0U);
    std::sort(order_.begin(), order_.end(), cancellation_.counting([&](Vertex v, Vertex w) {
      return vertices_.is_before(v, w);
    }));
    place_.resize(order_.size());
    for (std::uint32_t i = 0; i < order_.size(); ++i) place_[order_[i]] = i;
  }
  [[nodiscard]] bool runs_right(Vertex e) const { return place_[e] < place_[next_[e]]; }

  /// Passes a vertex. Returns false if it lies on another edge, or if its ring does not turn there.
  [[nodiscard]] bool pass(Vertex v) {
    const Vertex in = previous_[v];
    const Sign turn = vertices_.side(in, v, next_[v]);
    if (turn == kZero) return false;
    const bool in_ends = runs_right(in);
    const bool out_ends = !runs_right(v);
    if (in_ends != out_ends) return sweep_.go_on(v, in_ends ? in : v, in_ends ? v : in);
    if (sweep_.arrive(v, in_ends ? in : kNone) != kNone) return false;
    sweep_.leave(kNone, [&](auto visit) {
      if (in_ends) return;
      visit(turn == kPositive ? v : in, kNone);
      visit(turn == kPositive ? in : v, kNone);
    });
    return true;
  }

  /// Finds a new ring's place among the others. Rings come in canonical order.
  void nest(RingId r, Vertex edge_below) {
    RingNesting& ring = rings_[r];
    if (edge_below != kNone) {
      const RingId below = ring_of_[edge_below];
      const bool is_inside = runs_right(edge_below) == rings_[below].counter_clockwise;
      ring.around = is_inside ? below : rings_[below].around;
    }
    const bool is_box = r + 1 == rings_.size();
    if (ring.around != kNone) {
      const RingNesting& around = rings_[ring.around];
      ring.in_box = around.in_box;
      ring.covered = around.covered != (ring.around + 1 != rings_.size());
      ring.polygon = around.polygon;
    }
    ring.in_box |= is_box;
    if (!ring.in_box) return;
    if (ring.covered != is_box) {
      ring.polygon = polygons_.size();
      polygons_.push_back({r});
    } else if (!is_box) {
      polygons_[ring.polygon].push_back(r);
    }
  }

  [[nodiscard]] Region write() {
    Region result;
    const auto limbs = RegionAccess::limbs(region_);
    RegionAccess::reserve(result,
                          {order_.size(), 0, rings_.size(), polygons_.size(), limbs.size()});
    RegionAccess::append_limbs(result, limbs);
    for (const std::vector<RingId>& polygon : polygons_) {
      result.begin_polygon();
      for (const RingId r : polygon) {
        result.begin_ring();
        const RingNesting& ring = rings_[r];
        const bool is_outer = r == polygon.front();
        const auto& next = ring.counter_clockwise == is_outer ? next_ : previous_;
        Vertex v = ring.first;
        do {
          cancellation_.check();
          RegionAccess::add_vertex(result, RegionAccess::x(region_, v),
                                   RegionAccess::y(region_, v));
          v = next[v];
        } while (v != ring.first);
      }
    }
    return result;
  }

  Cancellation cancellation_;
  Region region_;  ///< the box is its last ring
  ApproximateVertices vertices_;
  std::vector<Vertex> next_;
  std::vector<Vertex> previous_;
  std::vector<RingId> ring_of_;
  std::vector<RingNesting> rings_;
  std::vector<Vertex> order_;         ///< by x, then by y
  std::vector<std::uint32_t> place_;  ///< by vertex: in `order_`
  SegmentSweepScratch scratch_;
  SegmentSweep<InsideOut> sweep_;
  bool any_crossing_ = false;
  std::vector<std::vector<RingId>> polygons_;  ///< of the complement; outer rings come first
};

}  // namespace

std::optional<Region> complement_in(const Box& box, const Region& region, const Options& options) {
  constexpr std::size_t kMostVertices = std::size_t{1} << 30;  // an overlay refuses more
  if (region.empty() || region.vertex_count() > kMostVertices) return std::nullopt;
  return InsideOut(box, region, options).run();
}

}  // namespace minksum
