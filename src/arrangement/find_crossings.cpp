// All meetings of kept segments, cell by cell.
#include <algorithm>
#include <cmath>

#include "arrangement/arrangement.hpp"

namespace minksum {
namespace {

/// A part of a cell. Parts tile the plane half-open: each point is in exactly one of them.
struct Part {
  double x0 = -HUGE_VAL;
  double y0 = -HUGE_VAL;
  double x1 = HUGE_VAL;
  double y1 = HUGE_VAL;
  [[nodiscard]] bool contains(const Vec<double>& p) const {
    return p.x >= x0 && p.x < x1 && p.y >= y0 && p.y < y1;
  }
};

struct Orientations {
  Sign start;
  Sign end;
  double start_value;  ///< approximate cross products,
  double end_value;
  double bound;        ///< and a bound on the error of each; infinite if the kernel was asked
};

class CrossingFinder {
 public:
  CrossingFinder(const Operands& o, const Cover& cover, const Options& options,
                 const std::function<void()>& stop, Predicates& predicates,
                 ArrangementScratch& scratch, Arrangement& arrangement)
      : o_(o), grid_(cover.grid), options_(options), stop_(stop), predicates_(predicates),
        scratch_(scratch), kept_(arrangement.kept),
        trust_(!std::isinf(predicates.bounds().direction)),
        slack_(cover.grid.cell * 0x1p-10) {}

  void run() {
    scratch_.crossings.clear();
    scratch_.events.clear();
    scratch_.parent.resize(2 * kept_.size());
    for (std::uint32_t i = 0; i < scratch_.parent.size(); ++i) scratch_.parent[i] = i;
    const auto& begin = scratch_.cell_begin;
    for (std::size_t cell = 0; cell + 1 < begin.size(); ++cell) {
      const std::uint32_t count = begin[cell + 1] - begin[cell];
      if (count < 2) continue;
      row_ = static_cast<std::int32_t>(cell / static_cast<std::size_t>(grid_.columns));
      column_ = static_cast<std::int32_t>(cell % static_cast<std::size_t>(grid_.columns));
      solve(scratch_.in_cells.data() + begin[cell], count, Part{}, 0);
      if ((++solved_ & 0xFF) == 0) stop_();
    }
  }

 private:
  static constexpr std::uint32_t kFew = 24;
  static constexpr int kMaxDepth = 7;  // below that a part's side nears the slack

  // -- Cells --------------------------------------------------------------------------------
  void solve(const KeptId* items, std::uint32_t count, const Part& part, int depth) {
    if (count <= kFew || depth == kMaxDepth || !divide(items, count, part, depth)) {
      part_ = part;
      if (count > kFew && trust_) return sweep(items, count);
      for (std::uint32_t i = 1; i < count; ++i) {
        for (std::uint32_t j = 0; j < i; ++j) meet(items[j], items[i]);
      }
    }
  }

  /// All pairs whose x ranges overlap, from left to right: for parts that dividing did not thin out.
  void sweep(const KeptId* items, std::uint32_t count) {
    auto& order = scratch_.sweep_order;
    order.assign(items, items + count);
    const auto left = [&](KeptId s) { return std::min(kept_[s].a.x, kept_[s].b.x); };
    std::sort(order.begin(), order.end(), [&](KeptId a, KeptId b) { return left(a) < left(b); });
    for (std::size_t i = 0; i < order.size(); ++i) {
      const KeptSegment& s = kept_[order[i]];
      const double reach = std::max(s.a.x, s.b.x) + predicates_.bounds().difference;
      for (std::size_t j = i + 1; j < order.size() && left(order[j]) <= reach; ++j) {
        meet(std::min(order[i], order[j]), std::max(order[i], order[j]));
      }
      if ((i & 0xFFF) == 0xFFF) stop_();
    }
  }

  /// Solves the four quarters of a part; false (and nothing done) if that would not separate much.
  bool divide(const KeptId* items, std::uint32_t count, const Part& part, int depth) {
    const double side = std::ldexp(grid_.cell, -depth - 1);
    const Vec<double> low{part.x0 > -HUGE_VAL ? part.x0 : column_ * grid_.cell,
                          part.y0 > -HUGE_VAL ? part.y0 : row_ * grid_.cell};
    const Vec<double> mid{low.x + side, low.y + side};
    const std::size_t level = static_cast<std::size_t>(depth) * 4;
    if (scratch_.stack.size() < level + 4) scratch_.stack.resize(level + 4);
    std::size_t total = 0;
    for (std::size_t quarter = 0; quarter < 4; ++quarter) {
      const bool right = (quarter & 1) != 0;
      const bool upper = (quarter & 2) != 0;
      auto& inside = scratch_.stack[level + quarter];
      inside.clear();
      const Vec<double> centre{mid.x + (right ? side : -side) / 2, mid.y + (upper ? side : -side) / 2};
      for (std::uint32_t i = 0; i < count; ++i) {
        if (near_box(kept_[items[i]], centre, side / 2 + slack_)) inside.push_back(items[i]);
      }
      total += inside.size();
    }
    // Crowds that no division parts are left to the sweep.
    if (total >= std::size_t{3} * count) return false;
    for (std::size_t quarter = 0; quarter < 4; ++quarter) {
      const bool right = (quarter & 1) != 0;
      const bool upper = (quarter & 2) != 0;
      const Part child{right ? mid.x : part.x0, upper ? mid.y : part.y0,
                       right ? part.x1 : mid.x, upper ? part.y1 : mid.y};
      // The recursion may move the vector of vectors, not the lists themselves.
      const KeptId* list = scratch_.stack[level + quarter].data();
      const auto size = static_cast<std::uint32_t>(scratch_.stack[level + quarter].size());
      if (size >= 2) solve(list, size, child, depth + 1);
    }
    return true;
  }

  /// Whether the segment may touch the box of this centre and half side; errs on the side of yes.
  [[nodiscard]] static bool near_box(const KeptSegment& s, const Vec<double>& centre,
                                     double half) {
    if (std::max(s.a.x, s.b.x) < centre.x - half || std::min(s.a.x, s.b.x) > centre.x + half ||
        std::max(s.a.y, s.b.y) < centre.y - half || std::min(s.a.y, s.b.y) > centre.y + half) {
      return false;
    }
    const Vec<double> v{centre.x - s.a.x, centre.y - s.a.y};
    const double reach = (std::abs(s.d.x) + std::abs(s.d.y)) * half;
    return std::abs(cross(s.d, v)) <= reach * (1 + 0x1p-20);
  }

  // -- Pairs --------------------------------------------------------------------------------
  [[nodiscard]] SumVertex start(KeptId s) const {
    return Predicates::start_vertex(kept_[s].segment);
  }
  [[nodiscard]] SumVertex end(KeptId s) const { return predicates_.end_vertex(kept_[s].segment); }

  [[nodiscard]] bool apart(const KeptSegment& s, const KeptSegment& t) const {
    const double doubt = predicates_.bounds().difference;
    return std::max(s.a.x, s.b.x) + doubt < std::min(t.a.x, t.b.x) ||
           std::max(t.a.x, t.b.x) + doubt < std::min(s.a.x, s.b.x) ||
           std::max(s.a.y, s.b.y) + doubt < std::min(t.a.y, t.b.y) ||
           std::max(t.a.y, t.b.y) + doubt < std::min(s.a.y, s.b.y);
  }

  void meet(KeptId s, KeptId t) {
    const KeptSegment& ks = kept_[s];
    const KeptSegment& kt = kept_[t];
    if (trust_ && apart(ks, kt)) return;
    const DirectionRank rs = o_.rank[ks.segment.edge];
    const DirectionRank rt = o_.rank[kt.segment.edge];
    if (rs == rt || o_.reverse_place[rs] == o_.place[rt]) return meet_parallel(s, t);
    const Orientations of_t = orientations(s, t);  // of t's ends to s
    if (of_t.start == of_t.end && of_t.start != kZero) return;
    const Orientations of_s = orientations(t, s);
    if (of_s.start == of_s.end && of_s.start != kZero) return;
    if (of_t.start == kZero) return touch(s, of_s, 2 * t, start(t));
    if (of_t.end == kZero) return touch(s, of_s, 2 * t + 1, end(t));
    if (of_s.start == kZero) return touch(t, of_t, 2 * s, start(s));
    if (of_s.end == kZero) return touch(t, of_t, 2 * s + 1, end(s));
    cross_at(s, of_s, t, of_t);
  }

  /// Where the ends of t lie relative to s.
  Orientations orientations(KeptId s, KeptId t) {
    const KeptSegment& ks = kept_[s];
    const KeptSegment& kt = kept_[t];
    Orientations result{kZero, kZero, 0, 0, 0};
    const auto side = [&](const Vec<double>& p, double& value, auto vertex) {
      const Vec<double> v{p.x - ks.a.x, p.y - ks.a.y};
      const double left = ks.d.x * v.y;
      const double right = ks.d.y * v.x;
      value = left - right;
      const double bound =
          predicates_.cross_bound(ks.d, v, left, right, predicates_.bounds().difference);
      result.bound = std::max(result.bound, bound);
      if (value > bound || value < -bound || bound == 0) {
        predicates_.count_filtered(1);
        return sign_of(value);
      }
      result.bound = HUGE_VAL;
      const SumVertex v_exact = vertex();
      if (coincide(p, v_exact, ks.a, start(s)) || coincide(p, v_exact, ks.b, end(s))) return kZero;
      predicates_.count_kernel(1);
      return predicates_.kernel().orientation(ks.segment, v_exact);
    };
    result.start = side(kt.a, result.start_value, [&] { return start(t); });
    result.end = side(kt.b, result.end_value, [&] { return end(t); });
    return result;
  }

  /// Whether two sum vertices are certainly equal: the common case of neighbours in the convolution.
  [[nodiscard]] bool coincide(const Vec<double>& p, const SumVertex& v, const Vec<double>& q,
                              const SumVertex& w) const {
    const bool exact_doubles = predicates_.bounds().difference == 0;
    return v == w || (exact_doubles && p.x == q.x && p.y == q.y);
  }

  /// An end of another segment lies on the line of s; `of_s` are the ends of s to that segment, so
  /// it lies on s unless both are strictly on one side.
  void touch(KeptId s, const Orientations& of_s, std::uint32_t point, const SumVertex& vertex) {
    if (of_s.start == kZero) return unite(scratch_.parent, point, 2 * s);
    if (of_s.end == kZero) return unite(scratch_.parent, point, 2 * s + 1);
    add_vertex_event(s, point, vertex);
  }

  void meet_parallel(KeptId s, KeptId t) {
    if (predicates_.orientation(kept_[s].segment, start(t)) != kZero) return;
    const std::pair<std::uint32_t, SumVertex> ends_s[2] = {{2 * s, start(s)}, {2 * s + 1, end(s)}};
    const std::pair<std::uint32_t, SumVertex> ends_t[2] = {{2 * t, start(t)}, {2 * t + 1, end(t)}};
    for (const auto& [point_s, vertex_s] : ends_s) {
      for (const auto& [point_t, vertex_t] : ends_t) {
        if (equal(vertex_s, vertex_t)) unite(scratch_.parent, point_s, point_t);
      }
    }
    for (const auto& [point, vertex] : ends_t) {
      if (strictly_between(ends_s[0].second, ends_s[1].second, vertex)) {
        add_vertex_event(s, point, vertex);
      }
    }
    for (const auto& [point, vertex] : ends_s) {
      if (strictly_between(ends_t[0].second, ends_t[1].second, vertex)) {
        add_vertex_event(t, point, vertex);
      }
    }
  }
  bool equal(const SumVertex& a, const SumVertex& b) {
    return a == b || (predicates_.compare(a, b, Axis::kX) == kZero &&
                      predicates_.compare(a, b, Axis::kY) == kZero);
  }
  /// For three points of one line.
  bool strictly_between(const SumVertex& a, const SumVertex& b, const SumVertex& v) {
    const Axis axis = predicates_.compare(a, b, Axis::kX) != kZero ? Axis::kX : Axis::kY;
    return predicates_.compare(a, v, axis) * predicates_.compare(v, b, axis) == kPositive;
  }

  // -- What is found ------------------------------------------------------------------------
  /// Pairs may share several parts of several cells; each point is taken in its own part. A point
  /// that is only roughly known (beyond the slack that segments were binned with) is taken in each,
  /// which costs repeated events and nothing else.
  [[nodiscard]] bool mine(const Vec<double>& p, double error) const {
    if (!(error < slack_ / 2)) return true;
    return grid_.column(p.x) == column_ && grid_.row(p.y) == row_ && part_.contains(p);
  }
  [[nodiscard]] static double reach(const KeptSegment& s) {
    return std::max(std::abs(s.d.x), std::abs(s.d.y));
  }
  [[nodiscard]] static Vec<double> along(const KeptSegment& s, double lambda) {
    return {s.a.x + lambda * s.d.x, s.a.y + lambda * s.d.y};
  }

  struct Parameter {
    double lambda;
    double error;
  };
  /// From the ends' cross products with the other segment: they have opposite signs, so their
  /// difference does not cancel.
  Parameter crossing_parameter(KeptId s, const Orientations& of_s, KeptId t) {
    constexpr double kRounding = 0x1p-51;
    const double width = std::abs(of_s.start_value) + std::abs(of_s.end_value);
    const double lambda = std::abs(of_s.start_value) / width;
    const double error = 2 * of_s.bound / width + kRounding;
    if (error * reach(kept_[s]) < slack_ / 4) return {lambda, error};
    const PointOnSegment point{true, kept_[t].segment, {}};
    return from_kernel(s, point);
  }
  Parameter from_kernel(KeptId s, const PointOnSegment& point) {
    constexpr double kKernelError = 0x1p-47;
    predicates_.count_kernel(1);
    return {predicates_.kernel().parameter(kept_[s].segment, point), kKernelError};
  }

  void cross_at(KeptId s, const Orientations& of_s, KeptId t, const Orientations& of_t) {
    const Parameter on_s = crossing_parameter(s, of_s, t);
    const Vec<double> p = along(kept_[s], on_s.lambda);
    if (!mine(p, on_s.error * reach(kept_[s]) + predicates_.bounds().position)) return;
    const Parameter on_t = crossing_parameter(t, of_t, s);
    const auto point = static_cast<std::uint32_t>(scratch_.parent.size());
    constexpr std::uint64_t kMost = std::uint64_t{1} << 30;  // points have 32-bit numbers
    const std::uint64_t most = std::min(options_.limits.max_crossings, kMost);
    if (scratch_.crossings.size() >= most) {
      throw Error(ErrorCode::kLimitExceeded,
                  "more than " + std::to_string(most) + " crossings (Limits::max_crossings)");
    }
    scratch_.parent.push_back(point);
    scratch_.crossings.push_back({s, t, on_s.lambda, doubted(on_s.error)});
    scratch_.events.push_back({on_s.lambda, doubted(on_s.error), s, point});
    scratch_.events.push_back({on_t.lambda, doubted(on_t.error), t, point});
  }
  /// Without trust in doubles every order is decided by the kernel.
  [[nodiscard]] double doubted(double error) const { return trust_ ? error : HUGE_VAL; }

  void add_vertex_event(KeptId s, std::uint32_t point, const SumVertex& vertex) {
    const KeptSegment& ks = kept_[s];
    const Vec<double> p = predicates_.position(vertex);
    if (!mine(p, predicates_.bounds().position)) return;
    const auto& bounds = predicates_.bounds();
    const bool by_x = std::abs(ks.d.x) >= std::abs(ks.d.y);
    const double length = by_x ? ks.d.x : ks.d.y;
    Parameter on_s{(by_x ? p.x - ks.a.x : p.y - ks.a.y) / length, 0};
    on_s.error = (bounds.difference + 2 * bounds.direction) / std::abs(length) + 0x1p-50;
    if (!(on_s.error * reach(ks) < slack_ / 4)) on_s = from_kernel(s, {false, {}, vertex});
    scratch_.events.push_back({on_s.lambda, doubted(on_s.error), s, point});
  }

  const Operands& o_;
  const UniformGrid& grid_;
  const Options& options_;
  const std::function<void()>& stop_;
  Predicates& predicates_;
  ArrangementScratch& scratch_;
  const std::vector<KeptSegment>& kept_;
  bool trust_;
  double slack_;  ///< segments are binned into every part within this distance
  std::int32_t column_ = 0;
  std::int32_t row_ = 0;
  Part part_;
  std::uint64_t solved_ = 0;
};

}  // namespace

void find_crossings(const Operands& operands, const Cover& cover, const Options& options,
                    const std::function<void()>& stop, Predicates& predicates,
                    ArrangementScratch& scratch, Arrangement& arrangement) {
  CrossingFinder(operands, cover, options, stop, predicates, scratch, arrangement).run();
  arrangement.crossings = scratch.crossings.size();
}

}  // namespace minksum
