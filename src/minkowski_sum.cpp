// The driver: operands → convolution → cover → arrangement → loops → filters → output.
#include "minksum/minkowski_sum.hpp"

#include <array>
#include <chrono>
#include <new>

#include "output/output.hpp"
#include "signed_convolution/signed_convolution.hpp"
#include "trace/fill_trace.hpp"

namespace minksum {

/// Every stage's result and scratch memory.
struct Workspace::State {
  Operands operands;
  ConvolutionScratch convolution_scratch;
  Convolution convolution;
  CoverScratch cover_scratch;
  Cover cover;
  ArrangementScratch arrangement_scratch;
  Arrangement arrangement;
  LoopScratch loop_scratch;
  Loops loops;
  BoxTrees trees;
  FilteredLoops filtered;
  OutputScratch output_scratch;
  Boundary boundary;
};

Workspace::Workspace() : state_(std::make_unique<State>()) {}
Workspace::~Workspace() = default;
Workspace::Workspace(Workspace&&) noexcept = default;
Workspace& Workspace::operator=(Workspace&&) noexcept = default;

const char* to_string(Stage stage) {
  constexpr std::array<const char*, kStageCount> kNames{
      "operands", "convolution", "cover", "arrangement", "loops", "filters", "output"};
  return kNames[static_cast<std::size_t>(stage)];
}

namespace {

/// Times stages, asks whether to go on, and runs checkers if that is wanted.
class StageRunner {
 public:
  StageRunner(const Options& options, Statistics& statistics)
      : options_(options), statistics_(statistics) {}

  template <class Work>
  void run(Stage stage, Work work) {
    stage_ = stage;
    stop_if_asked();
    const auto begin = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    statistics_.stage_seconds[static_cast<int>(stage)] += seconds.count();
  }
  void stop_if_asked() const {
    if ((options_.cancel && options_.cancel->cancelled()) ||
        (options_.progress && !options_.progress(stage_))) {
      throw Error(ErrorCode::kCancelled, "cancelled", {}, to_string(stage_));
    }
  }
  void require(const std::optional<std::string>& fault) const {
    if (fault) throw Error(ErrorCode::kInternal, *fault, {}, to_string(stage_));
  }

 private:
  const Options& options_;
  Statistics& statistics_;
  Stage stage_ = Stage::kOperands;
};

void convolve(Workspace::State& w, const Options& options) {
  const bool full = options.method == Method::kFull;
  (full ? full_convolution : reduced_convolution)(w.operands, options.limits,
                                                  w.convolution_scratch, w.convolution);
}

void count(const Workspace::State& w, const Predicates& predicates, Statistics& statistics) {
  statistics.convolution_segments = w.convolution.segments.size();
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

void run_pipeline(const Region& p, const Region& q, const Options& options,
                  Workspace::State& w, Statistics& statistics, Region& result) {
  StageRunner runner(options, statistics);
  const std::function<void()> stop = [&] { runner.stop_if_asked(); };

  runner.run(Stage::kOperands, [&] { prepare_operands(p, q, options, w.operands); });
  if (options.check) runner.require(check(w.operands));
  Predicates predicates(w.operands.sites, *w.operands.kernel, w.operands.bounds);

  runner.run(Stage::kConvolution, [&] { convolve(w, options); });
  if (options.check) {
    runner.require(check(w.convolution, w.operands, options.method == Method::kFull));
  }
  runner.run(Stage::kCover, [&] {
    cover_interior(w.operands, w.convolution, options, w.cover_scratch, w.cover);
  });
  if (options.check) runner.require(check(w.cover, w.operands));
  runner.run(Stage::kArrangement, [&] {
    arrange(w.operands, w.convolution, w.cover, options, stop, predicates, w.arrangement_scratch,
            w.arrangement);
  });
  if (options.check) runner.require(check(w.arrangement, w.operands));
  runner.run(Stage::kLoops,
             [&] { find_loops(w.operands, w.arrangement, w.loop_scratch, w.loops); });
  if (options.check) runner.require(check(w.loops, w.arrangement));
  runner.run(Stage::kFilters, [&] {
    filter_loops(w.operands, w.arrangement, w.loops, stop, predicates, w.trees, w.filtered);
  });
  if (options.check) runner.require(check(w.filtered, w.loops, w.arrangement, w.operands));
  runner.run(Stage::kOutput, [&] {
    extract_rings(w.operands, w.arrangement, w.loops, w.filtered, predicates, w.output_scratch,
                  w.boundary);
    write_region(w.operands, w.arrangement, w.boundary, w.output_scratch, result);
  });
  if (options.check) runner.require(check(w.boundary, w.arrangement, w.operands));
  count(w, predicates, statistics);
  if (options.trace != nullptr) {
    fill_trace(w.operands, w.convolution, w.cover, w.arrangement, w.loops, w.filtered,
               *options.trace);
  }
}

void require_legal(const Region& p, const Region& q) {
  for (const int operand : {0, 1}) {
    const auto faults = validate(operand == 0 ? p : q, 1);
    if (faults.empty()) continue;
    Culprit culprit = faults[0].place;
    culprit.operand = operand;
    throw Error(ErrorCode::kBadInput, faults[0].message, culprit);
  }
}

void run(const Region& p, const Region& q, const Options& options, Workspace::State& state,
         Region& result) {
  Statistics own;
  Statistics& statistics = options.statistics != nullptr ? *options.statistics : own;
  statistics = Statistics{};
  if (options.trace != nullptr) *options.trace = Trace{};
  const auto begin = std::chrono::steady_clock::now();
  if (p.empty() || q.empty()) {
    require_legal(p, q);
    result.clear();
  } else if (options.method == Method::kSigned) {
    require_legal(p, q);
    signed_convolution_sum(p, q, options, statistics, result);
  } else {
    run_pipeline(p, q, options, state, statistics, result);
  }
  statistics.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

Region minkowski_sum(const Region& p, const Region& q, const Options& options) {
  Workspace workspace;
  Region result;
  run(p, q, options, workspace.state(), result);
  return result;
}

Outcome minkowski_sum(const Region& p, const Region& q, const Options& options,
                      Workspace& workspace, Region& result) {
  try {
    run(p, q, options, workspace.state(), result);
    return {};
  } catch (const Error& error) {
    result.clear();
    return {error};
  } catch (const std::bad_alloc&) {
    result.clear();
    return {Error(ErrorCode::kLimitExceeded, "out of memory")};
  }
}

}  // namespace minksum
