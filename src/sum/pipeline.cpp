#include "sum/pipeline.hpp"

#include <algorithm>
#include <memory>

#include "sum/trace/fill_trace.hpp"
#include "validation/fault.hpp"

namespace minksum {

StageMemory::StageMemory() = default;
StageMemory::~StageMemory() = default;

Workspace::Workspace() = default;
Workspace::~Workspace() = default;
Workspace::Workspace(Workspace&&) noexcept = default;
Workspace& Workspace::operator=(Workspace&&) noexcept = default;
Workspace::State& Workspace::state() {
  if (!state_) state_ = std::make_unique<State>();
  return *state_;
}

namespace {

/// Whether reflex vertices take part. They have no segments in the sum of two thin operands.
bool is_full(const StageMemory& w, const SumSettings& options) {
  return options.method == Method::kFull && !w.operands.both_thin();
}

void count(const StageMemory& w, const Predicates& predicates, Statistics& statistics) {
  statistics.convolution_segments = w.convolution.size;
  statistics.segments_kept = w.arrangement.kept.size();
  statistics.crossings = w.arrangement.crossings;
  statistics.loops = w.loops.size();
  statistics.rejected_by_nesting = w.filtered.rejected_by_nesting;
  statistics.rejected_by_collision = w.filtered.rejected_by_collision;
  if (w.cover.active) {
    statistics.grid_cells = static_cast<std::uint64_t>(w.cover.grid.size());
    statistics.covered_cells = w.cover.covered_count();
  }
  statistics.coordinate_bits = w.operands.bits;
  statistics.arithmetic = w.operands.kernel->rung();
  const LadderCounts& counts = predicates.counts();
  statistics.by_filter = counts.by_filter;
  (statistics.arithmetic == Arithmetic::kArbitrary ? statistics.by_arbitrary
                                                   : statistics.by_fixed_width) = counts.by_kernel;
}

void report_tight_places(const SumRequest& options, Predicates& predicates, StageMemory& w) {
  find_tight_places(w.operands, w.arrangement, w.loops, w.filtered, predicates, w.trees,
                    w.tight_scratch, w.tight);
  write_tight_places(w.operands, w.arrangement, w.tight, predicates.cancellation(),
                     *options.tight_places);
}

}  // namespace

const PreparedOperand& prepare(const CallerOperand& given, std::size_t operand,
                               const SumRequest& options, Cancellation& cancellation,
                               StageMemory& w) {
  if (given.operand != nullptr) return *given.operand;
  const std::size_t faults_wanted = given.small == nullptr ? 1 : 0;
  std::vector<Fault> faults;
  prepare_operand(given.region, options, faults_wanted, cancellation, w.operand_scratch,
                  w.prepared[operand], faults);
  if (!faults.empty()) reject(faults[0], static_cast<int>(operand));
  return w.prepared[operand];
}

void convolve(StageMemory& w, const SumSettings& options, Cancellation& cancellation) {
  const Operands& o = w.operands;
  if (is_full(w, options)) {
    return full_convolution(o, options.limits, cancellation, w.convolution_scratch, w.convolution);
  }
  // Up to this many segments, listing and testing each is cheaper than building trees of runs.
  const std::uint64_t sites = o.size();
  const std::uint64_t many =
      std::max(8 * sites, std::clamp<std::uint64_t>(32 * sites, 100'000, 200'000));
  const bool may_hide = options.cover && !o.both_convex && !o.both_thin();
  reduced_convolution_or_sample(o, options.limits, may_hide ? many : ~std::uint64_t{0},
                                cancellation, w.convolution_scratch, w.convolution);
}

void prepare_valid(const PreparedOperand& p, const Region& valid, NarrowHoles narrow,
                   const SumRequest& options, Cancellation& cancellation, StageMemory& w) {
  std::vector<Fault> faults;
  prepare_operand(valid, options, 0, cancellation, w.operand_scratch, w.prepared[1], faults);
  if (!faults.empty()) reject(faults[0], 1);
  combine_operands(p, w.prepared[1], options, narrow, cancellation, w.operands);
}

void run_stages(const SumRequest& options, const SharedRaster* shared, StageRunner& runner,
                StageMemory& w, Region& result) {
  Cancellation& cancellation = runner.cancellation();
  if (options.check) runner.require(check(w.operands));
  if (w.operands.all_parallel()) return result.clear();
  Predicates predicates(w.operands.sites, *w.operands.kernel, w.operands.bounds, cancellation);

  const bool merged = w.operands.both_convex && options.method == Method::kReduced;
  // Merging needs neither the convolution nor the cover; only checks and traces look at them.
  const bool skipped = merged && !options.check && options.trace == nullptr &&
                       w.operands.size() <= options.limits.max_segments;
  runner.run(Stage::kConvolution, [&] {
    if (!skipped) return convolve(w, options, cancellation);
    w.convolution.segments.clear();
    w.convolution.size = w.operands.size();
    w.convolution.step = 1;
  });
  if (options.check) {
    runner.require(check(w.convolution, w.operands, is_full(w, options)));
  }
  runner.run(Stage::kCover, [&] {
    if (skipped) {
      w.cover.active = false;
    } else if (shared != nullptr) {
      cover_interior(w.operands, *shared, options, cancellation, w.cover_scratch, w.convolution,
                     w.cover);
    } else {
      cover_interior(w.operands, options, cancellation, w.cover_scratch, w.convolution, w.cover);
    }
  });
  if (options.check) runner.require(check(w.cover, w.operands));
  runner.run(Stage::kArrangement, [&] {
    if (merged) {
      arrange_convex(w.operands, cancellation, w.arrangement);
    } else {
      arrange(w.operands, w.convolution, w.cover, options, predicates, w.arrangement_scratch,
              w.arrangement);
    }
  });
  if (options.check) runner.require(check(w.arrangement, w.operands));
  runner.run(Stage::kLoops,
             [&] { find_loops(w.operands, w.arrangement, cancellation, w.loop_scratch, w.loops); });
  if (options.check) runner.require(check(w.loops, w.arrangement));
  runner.run(Stage::kFilters, [&] {
    filter_loops(w.operands, w.arrangement, w.loops, predicates, w.trees, w.filtered);
  });
  if (options.check) runner.require(check(w.filtered, w.loops, w.arrangement, w.operands));
  runner.run(Stage::kOutput, [&] {
    extract_rings(w.operands, w.arrangement, w.loops, w.filtered, predicates, w.output_scratch,
                  w.boundary);
    write_region(w.operands, w.arrangement, w.boundary, cancellation, w.output_scratch, result);
  });
  if (options.check) runner.require(check(w.boundary, w.arrangement, w.operands));
  if (options.tight_places != nullptr) {
    runner.run(Stage::kOutput, [&] { report_tight_places(options, predicates, w); });
    if (options.check) {
      runner.require(check(w.tight, w.arrangement, w.loops, w.filtered, w.operands));
    }
  }
  if (options.statistics != nullptr) count(w, predicates, *options.statistics);
  if (options.trace != nullptr) {
    if (!w.convolution.listed()) {
      reduced_convolution(w.operands, options.limits, cancellation, w.convolution_scratch,
                          w.convolution);
    }
    fill_trace(w.operands, w.convolution, w.cover, w.arrangement, w.loops, w.filtered, cancellation,
               *options.trace);
  }
}

void run_pipeline(const CallerOperand& p, const CallerOperand& q, const SumRequest& options,
                  StageMemory& w, Region& result) {
  StageRunner runner(options);
  runner.run(Stage::kOperands, [&] {
    Cancellation& cancellation = runner.cancellation();
    const PreparedOperand& first = prepare(p, 0, options, cancellation, w);
    const PreparedOperand& second = prepare(q, 1, options, cancellation, w);
    combine_operands(first, second, options, NarrowHoles::kFill, cancellation, w.operands);
  });
  run_stages(options, nullptr, runner, w, result);
}

}  // namespace minksum
