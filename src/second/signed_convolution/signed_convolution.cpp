#include "second/signed_convolution/signed_convolution.hpp"

#include <chrono>

#include "overlay/chains.hpp"
#include "region/map_points.hpp"
#include "region/point_arithmetic.hpp"
#include "second/signed_convolution/segments.hpp"

namespace minksum {
namespace signed_sum {
namespace {

// Adds the time since the last call to a stage.
class StageTimer {
 public:
  explicit StageTimer(Statistics& statistics) : statistics_(statistics) {}
  void charge(Stage stage) {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> passed = now - last_;
    statistics_.stage_seconds[static_cast<int>(stage)] += passed.count();
    last_ = now;
  }

 private:
  Statistics& statistics_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Tells whether points are in the sum (see `signed_convolutions`).
bool is_covered(const overlay::Winding& winding) {
  if (winding.first < 0) broken("a winding number is smaller than it can be");
  return winding.first > 0;
}

void compute(const Region& p, const Region& q, const SumSettings& options, Statistics& statistics,
             Region& result) {
  StageTimer timer(statistics);
  Cancellation cancellation(options);
  cancellation.enter(Stage::kOperands);
  const DirectedOperands operands = make_operands(p, q, cancellation);
  timer.charge(Stage::kOperands);
  cancellation.enter(Stage::kConvolution);
  const Region convolutions =
      signed_convolutions(operands, options.limits.max_segments, cancellation);
  statistics.convolution_segments = convolutions.vertex_count();
  statistics.segments_kept = convolutions.vertex_count();
  timer.charge(Stage::kConvolution);
  std::vector<overlay::Chain> chains;
  overlay::add_rings(convolutions, {1, 0}, chains);
  result = overlay::select(chains, {is_covered}, options, &statistics.crossings).region;
  timer.charge(Stage::kArrangement);
}

/// Adds the sums of parallel edges.
void add_parallel_sums(const Polyline& p, const Polyline& q, Cancellation& cancellation,
                       std::vector<Polyline>& sums) {
  for (std::size_t i = 1; i < p.size(); ++i) {
    for (std::size_t j = 1; j < q.size(); ++j) {
      const Point& a = p[i - 1];
      const Point& b = p[i];
      const Point& c = q[j - 1];
      const Point& d = q[j];
      cancellation.check(2 * (work_of(a) + work_of(c)));
      const Point e = minus(b, a);
      const Point f = minus(d, c);
      if (cross(e, f).sign() != 0) continue;
      const bool same_way = dot(e, f).sign() > 0;
      sums.push_back({plus(a, same_way ? c : d), plus(b, same_way ? d : c)});
    }
  }
}

}  // namespace
}  // namespace signed_sum

void signed_convolution_sum(const Region& p, const Region& q, const SumSettings& options,
                            Statistics& statistics, Region& result) {
  result.clear();
  if (p.empty() || q.empty()) return;
  signed_sum::compute(p, q, options, statistics, result);
}

void signed_convolution_sum(const Region& p, std::span<const Polyline> q,
                            const SumSettings& options, Region& result) {
  Cancellation cancellation(options);
  Statistics unasked;
  Region walks;
  walk_there_and_back(q, cancellation, walks);
  signed_convolution_sum(p, walks, options, unasked, result);
}

void signed_convolution_sum(std::span<const Polyline> p, std::span<const Polyline> q,
                            const SumSettings& options, Geometry& result) {
  Cancellation cancellation(options);
  result = {};
  Region walks;
  walk_there_and_back(p, cancellation, walks);
  signed_convolution_sum(walks, q, options, result.region);
  for (const Polyline& a : p) {
    for (const Polyline& b : q) {
      signed_sum::add_parallel_sums(a, b, cancellation, result.polylines);
    }
  }
}

}  // namespace minksum
