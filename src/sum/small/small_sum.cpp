#include "sum/small/small_sum.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "machine/vectors.hpp"
#include "region/region_access.hpp"
#include "sum/small/outer_walk.hpp"

namespace minksum {

/// A vertex of a result.
struct SmallVertex {
  Vec<double> rounded;  ///< its place without the offset
  StoredCoordinate x;
  StoredCoordinate y;
  EdgeOrigin origin;
};

struct SmallScratch::State {
  SmallSegments segments;
  SmallSegments ordered;
  SmallOrder order;
  SmallMeetings meetings;
  RightMeetings turns;
  SmallBoundary boundary;
  SmallOperand turned;
  std::vector<std::vector<SmallVertex>> holes;
};

namespace {

/// Writes corners of the sum as vertices of a region.
class SmallWriter {
 public:
  /// Makes room for `corners` vertices, which may be too many. `between` of them are not at the
  /// start of a segment.
  SmallWriter(const SmallOperand& p, const SmallOperand& q, std::size_t corners,
              std::size_t between, Region& region)
      : p_(p),
        q_(q),
        offset_{p.offset.x + q.offset.x, p.offset.y + q.offset.y},
        exp2_(static_cast<std::int16_t>(p.exp2)),
        exp10_(static_cast<std::int16_t>(p.exp10)),
        region_(region) {
    region.clear();
    constexpr std::size_t kLimbs = 4;  // most numerators and denominators take one limb
    RegionAccess::make_ring(region, {corners, corners, 1, 1, kLimbs * between});
  }
  void add(double x, double y, const SmallSegments::Origin& origin) { set(vertex(x, y, origin)); }
  void add(const SmallSegments& s, const SmallCorner& corner) { set(vertex(s, corner)); }
  [[nodiscard]] SmallVertex vertex(const SmallSegments& s, const SmallCorner& corner) {
    const std::uint32_t i = corner.segment;
    if (corner.along == 0) return vertex(s.x[i], s.y[i], s.origin[i]);
    const double passed = static_cast<double>(corner.along) / static_cast<double>(corner.whole);
    const StoredCoordinate x = store(s.x[i], s.dx[i], corner, offset_.x);
    const StoredCoordinate y = store(s.y[i], s.dy[i], corner, offset_.y);
    const Vec<double> rounded{s.x[i] + s.dx[i] * passed, s.y[i] + s.dy[i] * passed};
    return {rounded, x, y, origin_of(s.origin[i])};
  }
  /// Must be called after the last corner, if there may be fewer than there is room for.
  void finish() { RegionAccess::keep_vertices(region_, size_); }

 private:
  /// Up to here, products of way or offset with a part of a way take at most 128 bits.
  static constexpr std::int64_t kFewBits = std::int64_t{1} << 60;
  [[nodiscard]] StoredCoordinate compact(std::int64_t value) const {
    return value == 0 ? StoredCoordinate{} : StoredCoordinate{value, exp2_, exp10_, 0, 0};
  }
  StoredCoordinate store(double start, double way, const SmallCorner& corner, std::int64_t offset) {
    const std::int64_t base = static_cast<std::int64_t>(start) + offset;
    if (corner.whole <= kFewBits) {
      return store<Int128>(base, way, static_cast<std::int64_t>(corner.along),
                           static_cast<std::int64_t>(corner.whole));
    }
    return store<WideInt<3>>(base, way, corner.along, corner.whole);
  }
  /// Stores base + way · along / whole, where `Wide` holds the products.
  template <class Wide, class Integer>
  StoredCoordinate store(std::int64_t base, double way, Integer along, Integer whole) {
    const auto moved = product<Wide>(static_cast<std::int64_t>(way), along);
    // This is off by less than a half, so it is the quotient if that is an integer.
    const double near = way * (static_cast<double>(along) / static_cast<double>(whole));
    const auto part = static_cast<std::int64_t>(near + (near < 0 ? -0.5 : 0.5));
    if (product<Wide>(part, whole) == moved) return compact(base + part);
    const auto above = as_limbs(moved + product<Wide>(base, whole));
    const auto place = static_cast<std::int64_t>(RegionAccess::limbs(region_).size());
    const auto append = [&](const auto& magnitude) {
      std::size_t count = magnitude.limbs().size();
      while (magnitude.limb(count - 1) == 0) --count;
      RegionAccess::append_limbs(region_, magnitude.limbs().first(count));
      return static_cast<std::uint16_t>(count);
    };
    std::uint16_t count = append(above.magnitude());
    if (above.negative()) count |= kNegativeLimbs;
    return {place, exp2_, exp10_, count, append(as_limbs(whole))};
  }
  [[nodiscard]] SmallVertex vertex(double x, double y, const SmallSegments::Origin& origin) const {
    return {{x, y},
            compact(static_cast<std::int64_t>(x) + offset_.x),
            compact(static_cast<std::int64_t>(y) + offset_.y),
            origin_of(origin)};
  }
  [[nodiscard]] EdgeOrigin origin_of(const SmallSegments::Origin& origin) const {
    const SmallOperand& edges = origin.of_first ? p_ : q_;
    const SmallOperand& vertices = origin.of_first ? q_ : p_;
    return {origin.of_first ? Operand::kFirst : Operand::kSecond,
            edges.source(SmallOperand::kEdgeSource, origin.edge),
            vertices.source(SmallOperand::kVertexSource, origin.vertex)};
  }
  void set(const SmallVertex& vertex) {
    RegionAccess::set_vertex(region_, size_, vertex.x, vertex.y);
    RegionAccess::set_origin(region_, size_++, vertex.origin);
  }

  const SmallOperand& p_;
  const SmallOperand& q_;
  Vec<std::int64_t> offset_;
  std::int16_t exp2_;
  std::int16_t exp10_;
  Region& region_;
  std::size_t size_ = 0;
};

/// Whether the other operand may fit into a hole, because its box does. A hole is open, so a box of
/// equal width is too wide. The factors bring both to one grid.
bool may_fit(const SmallOperand& operand, double factor, const SmallOperand& other,
             double other_factor) {
  const Vec<double> box{other.extent.x * other_factor, other.extent.y * other_factor};
  return std::ranges::any_of(operand.holes, [&](const Vec<double>& hole) {
    return box.x < hole.x * factor && box.y < hole.y * factor;
  });
}

bool on_one_grid(const SmallOperand& p, const SmallOperand& q) {
  return p.exp2 == q.exp2 && p.exp10 == q.exp10;
}

/// Returns the sum of the smallest points of both operands, which is the sum's smallest point.
Vec<double> smallest_point(const SmallOperand& p, const SmallOperand& q) {
  return {p[SmallOperand::kX][p.smallest] + q[SmallOperand::kX][q.smallest],
          p[SmallOperand::kY][p.smallest] + q[SmallOperand::kY][q.smallest]};
}

/// Returns the larger extent of the sum.
double width_of(const SmallOperand& p, const SmallOperand& q) {
  return std::max(p.extent.x + q.extent.x, p.extent.y + q.extent.y);
}

/// Merges both operands' edges in order of direction. These are all of the sum's boundary.
template <class Number>
void merge_convex(const SmallOperand& p, const SmallOperand& q, Region& result) {
  /// Goes round a ring from its smallest vertex.
  struct Round : SmallRows {
    std::uint32_t size;
    std::uint32_t at;
    std::uint32_t left;
    explicit Round(const SmallOperand& o)
        : SmallRows(o), size(o.size), at(o.smallest), left(o.size) {}
    [[nodiscard]] Vec<Number> way() const { return whole_numbers<Number>({dx[at], dy[at]}); }
    void go_on() {
      at = at + 1 == size ? 0 : at + 1;
      --left;
    }
  };
  using Origin = SmallSegments::Origin;
  SmallWriter writer(p, q, p.size + q.size, 0, result);
  Round a(p);
  Round b(q);
  while (a.left + b.left > 0) {
    // Neither edge is half a circle behind the other, because convex rings turn by less.
    const Number turn = a.left == 0 ? -1 : b.left == 0 ? 1 : cross(a.way(), b.way());
    const auto i = static_cast<std::uint16_t>(a.at);
    const auto j = static_cast<std::uint16_t>(b.at);
    writer.add(a.x[a.at] + b.x[b.at], a.y[a.at] + b.y[b.at],
               turn >= 0 ? Origin{i, j, true} : Origin{j, i, false});
    if (turn >= 0) a.go_on();
    if (turn <= 0) b.go_on();
  }
  writer.finish();
}

/// Appends the holes in canonical order. Each ring starts at its smallest vertex.
void add_holes(const SmallSegments& segments, const SmallBoundary& boundary, double width,
               SmallWriter& writer, std::vector<std::vector<SmallVertex>>& holes, Region& region) {
  const auto compare = [&](double a, double b, const StoredCoordinate& x,
                           const StoredCoordinate& y) {
    // Rounded places are off by less than 2^-50 of the sum's width.
    if (std::abs(a - b) > 0x1p-48 * width) return a < b ? -1 : 1;
    const auto order = RegionAccess::compare(region, x, y);
    return order < 0 ? -1 : order > 0 ? 1 : 0;
  };
  const auto less = [&](const SmallVertex& a, const SmallVertex& b) {
    const int by_x = compare(a.rounded.x, b.rounded.x, a.x, b.x);
    return by_x != 0 ? by_x < 0 : compare(a.rounded.y, b.rounded.y, a.y, b.y) < 0;
  };
  holes.resize(boundary.rings - 1);
  for (std::uint32_t ring = 1; ring < boundary.rings; ++ring) {
    std::vector<SmallVertex>& hole = holes[ring - 1];
    hole.clear();
    for (std::uint32_t k = boundary.end_of[ring - 1]; k < boundary.end_of[ring]; ++k) {
      hole.push_back(writer.vertex(segments, boundary.corners[k]));
    }
    std::rotate(hole.begin(), std::min_element(hole.begin(), hole.end(), less), hole.end());
  }
  // Holes that start at the same vertex differ in the second one. They are few, so each is put
  // among those before it.
  const auto is_before = [&](const auto& a, const auto& b) {
    return less(a[0], b[0]) || (!less(b[0], a[0]) && less(a[1], b[1]));
  };
  for (auto hole = holes.begin(); hole != holes.end(); ++hole) {
    std::rotate(std::upper_bound(holes.begin(), hole, *hole, is_before), hole, hole + 1);
  }
  for (const std::vector<SmallVertex>& hole : holes) {
    region.begin_ring();
    for (const SmallVertex& v : hole) RegionAccess::add_vertex(region, v.x, v.y, v.origin);
  }
}

template <class Number>
bool walk(const SmallOperand& p, const SmallOperand& q, const SmallPlan& plan,
          const SmallSegments& segments, SmallScratch::State& scratch, Region& result) {
  if (!find_meetings_by<Number>(widest_vectors(), segments, scratch.meetings)) return false;
  const Vec<double> start = smallest_point(p, q);
  SmallBoundary& boundary = scratch.boundary;
  SmallPlacement placement(p, q, plan.with_holes, scratch.turned);
  OuterWalk<Number> walk(segments, scratch.meetings, placement, scratch.turns, boundary);
  if (!walk.run(start.x, start.y)) return false;
  SmallWriter writer(p, q, boundary.end_of[0], boundary.between, result);
  for (std::uint32_t k = 0; k < boundary.end_of[0]; ++k) {
    writer.add(segments, boundary.corners[k]);
  }
  if (boundary.rings == 1) return true;
  add_holes(segments, boundary, width_of(p, q), writer, scratch.holes, result);
  return true;
}

template <class Number>
bool walk(const SmallOperand& p, const SmallOperand& q, const SmallPlan& plan,
          SmallScratch::State& scratch, Region& result) {
  SmallSegments& segments = scratch.segments;
  bool out_of_order = false;
  const auto list = [&]() __attribute__((always_inline)) {
    const bool done = list_segments<Number>(p, q, plan.with_holes, segments);
    out_of_order = done && segments.is_out_of_order();
    return done;
  };
  if (!with_vectors(widest_vectors(), list)) return false;
  if (!out_of_order) return walk<Number>(p, q, plan, segments, scratch, result);
  const double width = width_of(p, q);
  const auto order = [&]() __attribute__((always_inline)) {
    scratch.order.apply(segments, width, scratch.ordered);
  };
  with_vectors(widest_vectors(), order);
  return walk<Number>(p, q, plan, scratch.ordered, scratch, result);
}

}  // namespace

SmallScratch::SmallScratch() = default;
SmallScratch::~SmallScratch() = default;
SmallScratch::SmallScratch(SmallScratch&&) noexcept = default;
SmallScratch& SmallScratch::operator=(SmallScratch&&) noexcept = default;

SmallScratch::State& SmallScratch::state() {
  if (!state_) state_ = std::make_unique_for_overwrite<State>();
  return *state_;
}

bool allow_small(const Limits& limits) {
  constexpr std::uint64_t kMost = SmallSegments::kMax;
  return limits.max_segments >= std::max<std::uint64_t>(kMost, 2 * SmallOperand::kMaxVertices) &&
         limits.max_crossings >= kMost * kMost;
}

bool bring_to_one_grid(const SmallPlan& plan, std::array<const SmallOperand*, 2>& operands,
                       std::array<SmallOperand, 2>& memory) {
  const auto& [p, q] = operands;
  if (on_one_grid(*p, *q)) return true;
  const int exp2 = std::min(p->exp2, q->exp2);
  const int exp10 = std::min(p->exp10, q->exp10);
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    if (operands[i]->exp2 == exp2 && operands[i]->exp10 == exp10) continue;
    const std::uint32_t entries = plan.with_holes[i] ? operands[i]->entries : operands[i]->size;
    if (!refine(exp2, exp10, entries, *operands[i], memory[i])) return false;
    operands[i] = &memory[i];
  }
  return true;
}

SmallPlan plan_sum(const SmallOperand& p, const SmallOperand& q) {
  const int exp2 = std::min(p.exp2, q.exp2);
  const int exp10 = std::min(p.exp10, q.exp10);
  const double of_p = refinement(exp2, exp10, p);
  const double of_q = refinement(exp2, exp10, q);
  if (of_p == 0 || of_q == 0) return {};
  SmallPlan plan;
  plan.with_holes = {may_fit(p, of_p, q, of_q), may_fit(q, of_q, p, of_p)};
  const auto lacks = [](const SmallOperand& o, bool with_holes) {
    return with_holes && o.entries == o.size;
  };
  if (lacks(p, plan.with_holes[0]) || lacks(q, plan.with_holes[1])) return {};
  plan.convex = p.convex && q.convex && !plan.with_holes[0] && !plan.with_holes[1];
  const auto size = [](const SmallOperand& o, bool with_holes) {
    return static_cast<double>(with_holes ? o.entries : o.size);
  };
  const auto turning = [](const SmallOperand& o, bool with_holes) {
    return o.turning + (with_holes ? o.turning_of_holes : 0);
  };
  const double width =
      std::max(p.extent.x * of_p + q.extent.x * of_q, p.extent.y * of_p + q.extent.y * of_q);
  plan.numbers = small_numbers(std::max(p.longest * of_p, q.longest * of_q), width);
  if (plan.convex) return plan;
  const double m = size(p, plan.with_holes[0]);
  const double n = size(q, plan.with_holes[1]);
  const double segments = m * turning(q, plan.with_holes[1]) + n * turning(p, plan.with_holes[0]);
  // With more segments, looking at each pair of blocks takes longer than the stages.
  constexpr double kMostSegments = 1400;
  // So does listing the segments, which compares each vertex with each edge, if m · n is larger
  // than this. Rounded numbers take twice as long. With 128 for them, 13 of 764 sums took another
  // way, and 1.08 times as long on the geometric mean. With 32 for both, others took up to 3 times
  // as long by the stages.
  const double most = plan.numbers == SmallNumberType::kDoubles ? 128 : 64;
  return segments <= kMostSegments && m * n <= most * (m + n) ? plan : SmallPlan{};
}

bool sum_small(const SmallOperand& p, const SmallOperand& q, SmallScratch& scratch,
               Region& result) {
  const SmallPlan plan = plan_sum(p, q);
  if (plan.numbers == SmallNumberType::kNone) return false;
  if (!on_one_grid(p, q)) {
    std::array<const SmallOperand*, 2> fine{&p, &q};
    std::array<SmallOperand, 2> memory;
    return bring_to_one_grid(plan, fine, memory) && sum_small(*fine[0], *fine[1], scratch, result);
  }
  if (plan.convex) {
    scratch.count(p.size + q.size);
    with_numbers(plan.numbers, [&]<class Number>() { merge_convex<Number>(p, q, result); });
    return true;
  }
  SmallScratch::State& state = scratch.state();
  const bool done = with_numbers(
      plan.numbers, [&]<class Number>() { return walk<Number>(p, q, plan, state, result); });
  scratch.count(state.segments.size);
  return done;
}

}  // namespace minksum
