#include "second/signed_convolution/signed_convolution.hpp"

#include <chrono>

#include "region/point_arithmetic.hpp"
#include "second/signed_convolution/arrangement.hpp"
#include "second/signed_convolution/broken.hpp"
#include "second/signed_convolution/rings.hpp"
#include "second/signed_convolution/segments.hpp"
#include "second/signed_convolution/winding.hpp"

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

struct Input {
  const IntegerOperands& operands;
  std::span<const Layer> layers;
  std::span<const SignedSegment> segments;
};

template <class N>
void solve(const Input& input, const SumSettings& options, Cancellation& cancellation,
           Statistics& statistics, StageTimer& timer, Region& result) {
  cancellation.enter(Stage::kArrangement);
  Geometry<N> geometry(input.operands.bits, cancellation);
  const Arrangement arrangement =
      ArrangementBuilder<N>(geometry, options, statistics).run(input.layers, input.segments);
  if (options.check && !is_balanced(arrangement)) {
    broken("the pieces of the arrangement do not form cycles");
  }
  timer.charge(Stage::kArrangement);
  // All pieces of polylines along one direction cancel.
  if (arrangement.pieces.empty()) return;
  cancellation.enter(Stage::kLoops);
  const InsideFlags inside = WindingTrace<N>(geometry, arrangement, input.layers).run();
  const BoundaryRings boundary = RingBuilder<N>(geometry, arrangement, inside).run();
  const auto polygons = PolygonBuilder<N>(geometry, arrangement, boundary).run();
  statistics.loops = boundary.rings.size();
  timer.charge(Stage::kLoops);
  cancellation.enter(Stage::kOutput);
  write_region(geometry, arrangement, boundary, polygons, input.operands, result);
  timer.charge(Stage::kOutput);
}

// Returns the narrowest set of numbers that holds the sum, or a wider one on request.
Arithmetic pick(unsigned bits, Arithmetic least) {
  const bool wider = least == Arithmetic::kWide || least == Arithmetic::kArbitrary;
  if (wider || bits > MediumNumbers::kBits) return Arithmetic::kArbitrary;
  if (least == Arithmetic::kMedium || bits > NarrowNumbers::kBits) return Arithmetic::kMedium;
  return Arithmetic::kNarrow;
}

void compute(const CallerOperand& p, const CallerOperand& q, const SumSettings& options,
             Statistics& statistics, Region& result) {
  StageTimer timer(statistics);
  Cancellation cancellation(options);
  cancellation.enter(Stage::kOperands);
  const IntegerOperands operands = make_operands(p, q, cancellation);
  if (options.check) check(operands);
  statistics.coordinate_bits = operands.operand_bits;
  timer.charge(Stage::kOperands);
  cancellation.enter(Stage::kConvolution);
  const std::vector<Layer> layers = make_layers(operands, cancellation);
  const std::vector<SignedSegment> segments =
      signed_segments(operands, layers, options, cancellation);
  // This is always checked, because it costs little, and all later steps depend on it.
  if (!is_closed(layers, segments, cancellation)) broken("the signed convolution is not closed");
  statistics.convolution_segments = segments.size();
  statistics.segments_kept = segments.size();
  timer.charge(Stage::kConvolution);
  const Input input{operands, layers, segments};
  statistics.arithmetic = pick(operands.bits, options.arithmetic);
  switch (statistics.arithmetic) {
    case Arithmetic::kNarrow:
      return solve<NarrowNumbers>(input, options, cancellation, statistics, timer, result);
    case Arithmetic::kMedium:
      return solve<MediumNumbers>(input, options, cancellation, statistics, timer, result);
    default:
      return solve<ArbitraryNumbers>(input, options, cancellation, statistics, timer, result);
  }
}

bool are_parallel(const Point& a, const Point& b, const Point& c, const Point& d) {
  return cross(minus(b, a), minus(d, c)).sign() == 0;
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
      if (!are_parallel(a, b, c, d)) continue;
      const bool same_way = (b.x - a.x) * (d.x - c.x) + (b.y - a.y) * (d.y - c.y) > Rational(0);
      sums.push_back({plus(a, same_way ? c : d), plus(b, same_way ? d : c)});
    }
  }
}

}  // namespace
}  // namespace signed_sum

void signed_convolution_sum(const signed_sum::CallerOperand& p, const signed_sum::CallerOperand& q,
                            const SumSettings& options, Statistics& statistics, Region& result) {
  result.clear();
  if (p.empty() || q.empty()) return;
  try {
    signed_sum::compute(p, q, options, statistics, result);
  } catch (...) {
    result.clear();
    throw;
  }
}

void signed_convolution_sum(std::span<const Polyline> p, std::span<const Polyline> q,
                            const SumSettings& options, Geometry& result) {
  result = {};
  Statistics unasked;
  signed_convolution_sum(p, q, options, unasked, result.region);
  Cancellation cancellation(options);
  for (const Polyline& a : p) {
    for (const Polyline& b : q) {
      signed_sum::add_parallel_sums(a, b, cancellation, result.polylines);
    }
  }
}

}  // namespace minksum
