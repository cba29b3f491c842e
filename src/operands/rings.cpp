// Rings as given to rings as the pipeline wants them.
#include <algorithm>

#include "operands/operands.hpp"
#include "region/region_access.hpp"

namespace minksum {
namespace {

/// One ring on its way: sites as loaded, in the ring's own order.
class RingCleaner {
 public:
  RingCleaner(const Region& region, Predicates& predicates, SiteId first_site,
              OperandsScratch& scratch)
      : region_(region), predicates_(predicates), first_site_(first_site),
        distinct_(scratch.distinct), kept_(scratch.kept) {}

  /// The ring's sites without repeated and straight vertices, oriented; empty after a fault.
  const std::vector<SiteId>& clean(std::size_t ring, Culprit place, std::vector<Fault>& faults) {
    drop_repeated(ring);
    kept_.clear();
    place_ = place;
    ring_begin_ = region_.vertices_of(ring).front();
    if (distinct_.size() < 3) {
      fault("ring has fewer than three distinct vertices", distinct_.empty() ? kNoSite : distinct_[0],
            faults);
      return kept_;
    }
    if (!drop_straight(faults)) return kept_;
    if (kept_.size() < 3) {
      kept_.clear();
      fault("ring has no area", distinct_[0], faults);
      return kept_;
    }
    orient();
    return kept_;
  }
  [[nodiscard]] bool reversed() const { return reversed_; }

 private:
  bool equal(SiteId a, SiteId b) {
    return predicates_.compare(a, b, Axis::kX) == kZero &&
           predicates_.compare(a, b, Axis::kY) == kZero;
  }
  void drop_repeated(std::size_t ring) {
    distinct_.clear();
    for (const std::size_t v : region_.vertices_of(ring)) {
      const SiteId site = first_site_ + static_cast<SiteId>(v);
      // Of a run of equal vertices the last stays: the edge to the next vertex has its index.
      if (!distinct_.empty() && equal(distinct_.back(), site)) {
        distinct_.back() = site;
      } else {
        distinct_.push_back(site);
      }
    }
    while (distinct_.size() > 1 && equal(distinct_.front(), distinct_.back())) distinct_.pop_back();
  }
  bool drop_straight(std::vector<Fault>& faults) {
    const std::size_t n = distinct_.size();
    for (std::size_t i = 0; i < n; ++i) {
      const SiteId before = distinct_[(i + n - 1) % n];
      const SiteId at = distinct_[i];
      const SiteId after = distinct_[(i + 1) % n];
      if (predicates_.orientation(before, at, after) != kZero) {
        kept_.push_back(at);
      } else if (predicates_.kernel().dot(before, at, at, after) != kPositive) {
        kept_.clear();
        fault("ring turns back on itself (a spike)", at, faults);
        return false;
      }
    }
    return true;
  }
  void orient() {
    const std::size_t n = kept_.size();
    std::size_t lowest = 0;
    for (std::size_t i = 1; i < n; ++i) {
      const Sign by_x = predicates_.compare(kept_[i], kept_[lowest], Axis::kX);
      if (by_x == kNegative ||
          (by_x == kZero && predicates_.compare(kept_[i], kept_[lowest], Axis::kY) == kNegative)) {
        lowest = i;
      }
    }
    const Sign turn = predicates_.orientation(kept_[(lowest + n - 1) % n], kept_[lowest],
                                              kept_[(lowest + 1) % n]);
    const bool want_clockwise = place_.ring != 0;
    reversed_ = (turn == kNegative) != want_clockwise;
    if (reversed_) std::reverse(kept_.begin(), kept_.end());
  }
  void fault(const char* message, SiteId site, std::vector<Fault>& faults) {
    Fault fault{message, place_, 0, 0};
    if (site != kNoSite) {
      const std::size_t v = site - first_site_;
      fault.place.vertex = v - ring_begin_;
      fault.x = region_.x(v);
      fault.y = region_.y(v);
    }
    faults.push_back(std::move(fault));
  }

  const Region& region_;
  Predicates& predicates_;
  SiteId first_site_;
  Culprit place_;
  std::size_t ring_begin_ = 0;
  bool reversed_ = false;
  std::vector<SiteId>& distinct_;
  std::vector<SiteId>& kept_;
};

/// The edge that starts at order[i], by the index that it has in its region: of a reversed ring it
/// is the one that started at order[i + 1].
void append_ring(const std::vector<SiteId>& ring, bool reversed, SiteId first_site,
                 std::vector<SiteId>& order, std::vector<std::uint32_t>& edge_source) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    order.push_back(ring[i]);
    edge_source.push_back((reversed ? ring[(i + 1) % n] : ring[i]) - first_site);
  }
}

}  // namespace

void clean_rings(const Region& p, const Region& q, Operands& operands,
                 std::array<std::vector<Fault>, 2>& faults) {
  Predicates predicates(operands.sites, *operands.kernel, operands.bounds);
  OperandsScratch& scratch = operands.scratch;
  scratch.order.clear();
  scratch.edge_source.clear();
  scratch.rings.clear();
  operands.edge_source.clear();
  std::size_t first_rings = 0;
  for (const int operand : {0, 1}) {
    const Region& region = operand == 0 ? p : q;
    const SiteId first_site = operand == 0 ? 0 : operands.split;
    RingCleaner cleaner(region, predicates, first_site, scratch);
    for (const std::size_t polygon : region.polygons()) {
      std::uint32_t ring_in_polygon = 0;
      for (const std::size_t ring : region.rings_of(polygon)) {
        const Culprit place{-1, polygon, ring_in_polygon, Culprit::kNone};
        const auto& cleaned =
            cleaner.clean(ring, place, faults[static_cast<std::size_t>(operand)]);
        if (!cleaned.empty()) {
          const auto begin = static_cast<SiteId>(scratch.order.size());
          append_ring(cleaned, cleaner.reversed(), first_site, scratch.order, scratch.edge_source);
          scratch.rings.push_back({begin, static_cast<SiteId>(scratch.order.size()),
                                   static_cast<std::uint32_t>(polygon), ring_in_polygon});
        }
        ++ring_in_polygon;
      }
    }
    if (operand == 0) first_rings = scratch.rings.size();
  }
  operands.vertex_source.resize(operands.sites.x.size());
  for (std::size_t i = 0; i < operands.vertex_source.size(); ++i) {
    operands.vertex_source[i] =
        static_cast<std::uint32_t>(i < operands.split ? i : i - operands.split);
  }
  select_sites(first_rings, operands);
  std::swap(operands.edge_source, scratch.edge_source);
}

void select_sites(std::size_t first_rings, Operands& operands) {
  const std::vector<SiteId>& order = operands.scratch.order;
  const auto pick = [&](auto& values, auto& picked) {
    if (values.empty()) return;
    picked.clear();
    for (const SiteId site : order) picked.push_back(values[site]);
    std::swap(values, picked);
  };
  SiteId split = 0;
  for (const SiteId site : order) split += site < operands.split ? 1 : 0;
  pick(operands.sites.x, operands.scratch.picked_coordinates);
  pick(operands.sites.y, operands.scratch.picked_coordinates);
  pick(operands.vertex_source, operands.scratch.picked_indices);
  pick(operands.edge_source, operands.scratch.picked_indices);
  operands.split = split;
  std::swap(operands.rings, operands.scratch.rings);
  operands.first_rings = first_rings;
  const std::size_t n = order.size();
  operands.sites.next.resize(n);
  operands.previous.resize(n);
  operands.on_hole.resize(n);
  for (const OperandRing& ring : operands.rings) {
    for (SiteId i = ring.begin; i < ring.end; ++i) {
      operands.sites.next[i] = i + 1 == ring.end ? ring.begin : i + 1;
      operands.previous[i] = i == ring.begin ? ring.end - 1 : i - 1;
      operands.on_hole[i] = ring.is_hole() ? 1 : 0;
    }
  }
  operands.kernel->arrange(order, operands.sites.next);
  operands.sites.dx.resize(n);
  operands.sites.dy.resize(n);
  for (SiteId i = 0; i < n; ++i) {
    const Vec<double> d = operands.kernel->approximate_difference(i, operands.sites.next[i]);
    operands.sites.dx[i] = d.x;
    operands.sites.dy[i] = d.y;
  }
}

void fill_holes(Operands& operands) {
  // For each operand the boxes of its polygons, as widths and heights.
  auto& sizes = operands.scratch.sizes;
  for (auto& of_operand : sizes) of_operand.clear();
  const auto size_of = [&](const OperandRing& ring) {
    const auto& x = operands.sites.x;
    const auto& y = operands.sites.y;
    const auto [x0, x1] = std::minmax_element(x.begin() + ring.begin, x.begin() + ring.end);
    const auto [y0, y1] = std::minmax_element(y.begin() + ring.begin, y.begin() + ring.end);
    return Vec<double>{*x1 - *x0, *y1 - *y0};
  };
  bool any_hole = false;
  for (std::size_t i = 0; i < operands.rings.size(); ++i) {
    any_hole |= operands.rings[i].is_hole();
    if (!operands.rings[i].is_hole()) {
      sizes[i < operands.first_rings ? 0 : 1].push_back(size_of(operands.rings[i]));
    }
  }
  if (!any_hole) return;
  // A hole is open and the other operand closed: equal width does not fit. Where rounding leaves a
  // doubt the hole stays, which costs time and nothing else.
  const double doubt = operands.bounds.difference;
  auto& order = operands.scratch.order;
  auto& rings = operands.scratch.rings;
  order.clear();
  rings.clear();
  std::size_t first_rings = 0;
  for (std::size_t i = 0; i < operands.rings.size(); ++i) {
    const bool first = i < operands.first_rings;
    OperandRing ring = operands.rings[i];
    if (ring.is_hole()) {
      const Vec<double> hole = size_of(ring);
      const auto& others = sizes[first ? 1 : 0];
      const bool fits = std::any_of(others.begin(), others.end(), [&](const Vec<double>& other) {
        return !(other.x >= hole.x + doubt || other.y >= hole.y + doubt);
      });
      if (!fits) continue;
    }
    const auto begin = static_cast<SiteId>(order.size());
    for (SiteId site = ring.begin; site < ring.end; ++site) order.push_back(site);
    ring.begin = begin;
    ring.end = static_cast<SiteId>(order.size());
    rings.push_back(ring);
    if (first) first_rings = rings.size();
  }
  if (rings.size() == operands.rings.size()) return;
  select_sites(first_rings, operands);
}

}  // namespace minksum
