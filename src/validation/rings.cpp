// Turns rings as given into rings as the pipeline needs them.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "region/region_access.hpp"
#include "validation/prepared_operand.hpp"
#include "validation/rational_sites.hpp"

namespace minksum {
namespace {

/// Chooses the sites that stay, ring by ring, from the sites as loaded.
class RingCleaner {
 public:
  RingCleaner(Cancellation& cancellation, OperandScratch& scratch, PreparedOperand& operand,
              std::vector<Fault>& faults)
      : operand_(operand),
        region_(*operand.region),
        predicates_(operand.sites, *operand.kernel, operand.bounds, cancellation),
        distinct_(scratch.distinct),
        order_(scratch.order),
        faults_(faults) {}

  /// Leaves behind the order of sites, their convexity, the edges' sources, and the rings.
  void run() {
    order_.clear();
    operand_.rings.clear();
    operand_.edge_source.clear();
    operand_.convex.clear();
    for (const std::size_t polygon : region_.polygons()) {
      std::uint32_t ring_in_polygon = 0;
      for (const std::size_t ring : region_.rings_of(polygon)) {
        place_ = {-1, polygon, ring_in_polygon, Culprit::kNone};
        clean(ring, static_cast<std::uint32_t>(polygon), ring_in_polygon++);
      }
    }
  }

 private:
  void clean(std::size_t ring, std::uint32_t polygon, std::uint32_t ring_in_polygon) {
    begin_ = order_.size();
    predicates_.cancellation().check(4 * region_.vertices_of(ring).size());
    if (!turns_everywhere(ring)) {
      drop_repeated(ring);
      if (distinct_.size() < 3) {
        return fault("ring has fewer than three distinct vertices",
                     distinct_.empty() ? kNoSite : distinct_[0]);
      }
      if (!drop_straight()) return;
      if (order_.size() - begin_ < 3) return fault("ring has no area", distinct_[0]);
    }
    const bool reversed = orient(ring_in_polygon != 0);
    // Each edge has an index in its region. In a reversed ring, the edge that starts at order[i] is
    // the one that started at order[i + 1].
    auto& sources = operand_.edge_source;
    sources.insert(sources.end(), order_.begin() + static_cast<std::ptrdiff_t>(begin_),
                   order_.end());
    const auto first = sources.end() - static_cast<std::ptrdiff_t>(order_.size() - begin_);
    if (reversed) std::rotate(first, first + 1, sources.end());
    operand_.rings.push_back({static_cast<SiteId>(begin_), static_cast<SiteId>(order_.size()),
                              polygon, ring_in_polygon});
  }

  /// Takes the whole ring if no vertex is repeated or straight, as is usual.
  bool turns_everywhere(std::size_t ring) {
    const auto vertices = region_.vertices_of(ring);
    const auto first = static_cast<SiteId>(vertices.front());
    const auto n = static_cast<SiteId>(vertices.size());
    if (n < 3) return false;
    order_.resize(begin_ + n);
    operand_.convex.resize(begin_ + n);
    std::uint8_t* const convex = operand_.convex.data() + begin_;
    const double* const x = operand_.sites.x.data();
    const double* const y = operand_.sites.y.data();
    const bool exact = predicates_.bounds().difference == 0 && predicates_.bounds().product == 0;
    SiteId before = first + n - 1;
    bool all = true;
    for (SiteId i = 0; i < n; ++i) {
      const SiteId at = first + i;
      const SiteId after = i + 1 == n ? first : at + 1;
      const Sign turn = exact ? sign_of(cross(Vec<double>{x[at] - x[before], y[at] - y[before]},
                                              Vec<double>{x[after] - x[at], y[after] - y[at]}))
                              : predicates_.orientation(before, at, after);
      all &= turn != kZero;
      convex[i] = turn == kPositive ? 1 : 0;
      before = at;
    }
    std::iota(order_.begin() + static_cast<std::ptrdiff_t>(begin_), order_.end(), first);
    if (!all) {
      order_.resize(begin_);
      operand_.convex.resize(begin_);
    }
    return all;
  }
  bool equal(SiteId a, SiteId b) { return predicates_.compare(a, b) == kZero; }
  void drop_repeated(std::size_t ring) {
    distinct_.clear();
    for (const std::size_t v : region_.vertices_of(ring)) {
      const auto site = static_cast<SiteId>(v);
      // The last of equal vertices stays, because the edge to the next vertex has its index.
      if (!distinct_.empty() && equal(distinct_.back(), site)) {
        distinct_.back() = site;
      } else {
        distinct_.push_back(site);
      }
    }
    while (distinct_.size() > 1 && equal(distinct_.front(), distinct_.back())) distinct_.pop_back();
  }
  bool drop_straight() {
    const std::size_t n = distinct_.size();
    SiteId before = distinct_[n - 1];
    for (std::size_t i = 0; i < n; ++i) {
      const SiteId at = distinct_[i];
      const SiteId after = distinct_[i + 1 == n ? 0 : i + 1];
      const Sign turn = predicates_.orientation(before, at, after);
      if (turn != kZero) {
        order_.push_back(at);
        operand_.convex.push_back(turn == kPositive ? 1 : 0);
      } else if (predicates_.kernel().dot(before, at, at, after) != kPositive) {
        fault("ring turns back on itself (a spike)", at);
        return false;
      }
      before = at;
    }
    return true;
  }
  /// Reverses the ring if it runs the wrong way round, and returns whether it did.
  bool orient(bool is_hole) {
    const std::size_t n = order_.size();
    const std::size_t lowest = lexicographically_smallest();
    const bool reversed = (operand_.convex[lowest] == 0) != is_hole;
    if (reversed) {
      const auto begin = static_cast<std::ptrdiff_t>(begin_);
      std::reverse(order_.begin() + begin, order_.end());
      std::reverse(operand_.convex.begin() + begin, operand_.convex.end());
      for (std::size_t i = begin_; i < n; ++i) operand_.convex[i] ^= 1;
    }
    return reversed;
  }
  [[nodiscard]] std::size_t lexicographically_smallest() {
    std::size_t lowest = begin_;
    if (predicates_.bounds().difference == 0) {
      const auto place = [&](std::size_t i) {
        return std::pair(operand_.sites.x[order_[i]], operand_.sites.y[order_[i]]);
      };
      for (std::size_t i = begin_ + 1; i < order_.size(); ++i) {
        if (place(i) < place(lowest)) lowest = i;
      }
      return lowest;
    }
    for (std::size_t i = begin_ + 1; i < order_.size(); ++i) {
      if (predicates_.compare(order_[i], order_[lowest]) == kNegative) lowest = i;
    }
    return lowest;
  }
  /// Reports a fault, and leaves the ring out.
  void fault(const char* message, SiteId site) {
    order_.resize(begin_);
    operand_.convex.resize(begin_);
    Fault fault{message, place_, {}, std::nullopt};
    if (site != kNoSite) {
      fault.place = RegionAccess::culprit(region_, site);
      fault.at = region_.point(site);
    }
    faults_.push_back(std::move(fault));
  }

  PreparedOperand& operand_;
  const Region& region_;
  Predicates predicates_;
  std::vector<SiteId>& distinct_;
  std::vector<SiteId>& order_;
  std::vector<Fault>& faults_;
  Culprit place_;
  std::size_t begin_ = 0;
};

/// Keeps only the sites in `order`, in this order.
template <class Value>
void pick(std::span<const SiteId> order, std::vector<Value>& values, std::vector<Value>& picked) {
  picked.clear();
  for (const SiteId site : order) picked.push_back(values[site]);
  values.assign(picked.begin(), picked.end());
}
void pick_sites(OperandScratch& scratch, PreparedOperand& operand) {
  if (operand.rational) {
    pick(scratch.order, operand.rationals.sites, scratch.picked_rationals.sites);
  } else if (operand.grid.small) {
    pick(scratch.order, operand.grid.small_sites, scratch.picked_grid.small_sites);
  } else {
    pick(scratch.order, operand.grid.large_sites, scratch.picked_grid.large_sites);
  }
}

bool is_identity(std::span<const SiteId> order, std::size_t size) {
  if (order.size() != size) return false;
  for (std::size_t i = 0; i < size; ++i) {
    if (order[i] != i) return false;
  }
  return true;
}

}  // namespace

void approximate_sites(std::size_t count, const SumSettings& options, Cancellation& cancellation,
                       OperandScratch& scratch, PreparedOperand& operand) {
  auto& ids = scratch.all;
  for (auto i = static_cast<SiteId>(ids.size()); i < count; ++i) ids.push_back(i);
  const std::span<const SiteId> all = std::span(ids).first(count);
  if (operand.rational) {
    const RationalCoordinates& r = operand.rationals;
    const int exponent = rational_exponent({&r.extent, 1});
    make_rational_kernel(r.sites, static_cast<SiteId>(r.sites.size()), {r.low, r.low}, {}, r.bits,
                         exponent, cancellation, operand.kernel);
    operand.unit = {-exponent, 0, 1};
    operand.bounds = RoundingBounds::of_rationals(std::ldexp(1.0, kRationalExtentBits + 2));
  } else {
    const GridCoordinates& grid = operand.grid;
    const GridPart part{&grid, 1, all};
    make_grid_kernel(rung_for(grid.bits, options.arithmetic), {&part, 1}, grid.unit,
                     operand.kernel);
    operand.unit = grid.unit;
    operand.bounds = RoundingBounds::of(std::ldexp(1.0, grid.bits), grid.bits <= kExactSumBits,
                                        grid.bits <= kExactProductBits);
  }
  if (!options.filter) operand.bounds = RoundingBounds::distrustful(operand.bounds.magnitude);
  operand.sites.x.resize(all.size());
  operand.sites.y.resize(all.size());
  operand.kernel->approximate_sites(operand.sites.x, operand.sites.y, cancellation);
}

void connect_rings(std::span<const OperandRing> rings, ExactKernel& kernel,
                   Cancellation& cancellation, ApproximateSites& sites,
                   std::vector<SiteId>& previous) {
  const std::size_t n = sites.x.size();
  sites.next.resize(n);
  previous.resize(n);
  for (const OperandRing& ring : rings) {
    for (SiteId i = ring.begin; i < ring.end; ++i) {
      sites.next[i] = i + 1;
      previous[i] = i - 1;
    }
    sites.next[ring.end - 1] = ring.begin;
    previous[ring.begin] = ring.end - 1;
  }
  kernel.connect(sites.next);
  sites.dx.resize(n);
  sites.dy.resize(n);
  kernel.approximate_edges(sites.dx, sites.dy, cancellation);
}

void clean_rings(const SumSettings& options, Cancellation& cancellation, OperandScratch& scratch,
                 PreparedOperand& operand, std::vector<Fault>& faults) {
  const std::size_t n = operand.region->vertex_count();
  approximate_sites(n, options, cancellation, scratch, operand);
  RingCleaner(cancellation, scratch, operand, faults).run();
  operand.vertex_source.assign(scratch.order.begin(), scratch.order.end());
  if (!is_identity(scratch.order, n)) {
    pick_sites(scratch, operand);
    approximate_sites(scratch.order.size(), options, cancellation, scratch, operand);
  }
  connect_rings(cancellation, operand);
}

}  // namespace minksum
