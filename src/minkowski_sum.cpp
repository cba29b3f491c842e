// The driver: operands → convolution → cover → arrangement → loops → filters → output.
#include "minksum/minkowski_sum.hpp"
#include "minksum/prepared_region.hpp"

#include <array>
#include <chrono>
#include <new>

#include "output/output.hpp"
#include "signed_convolution/signed_convolution.hpp"
#include "tight/tight.hpp"
#include "trace/fill_trace.hpp"

namespace minksum {

/// Every stage's result and scratch memory.
struct Workspace::State {
  OperandScratch operand_scratch;
  std::array<PreparedOperand, 2> prepared;
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
  TightScratch tight_scratch;
  TightPlaces tight;
};

Workspace::Workspace() : state_(std::make_unique<State>()) {}
Workspace::~Workspace() = default;
Workspace::Workspace(Workspace&&) noexcept = default;
Workspace& Workspace::operator=(Workspace&&) noexcept = default;

struct PreparedRegion::State {
  Region region;
  PreparedOperand operand;  ///< of `region`; nothing if that is empty
};

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

[[noreturn]] void reject(const Fault& fault, int operand) {
  Culprit culprit = fault.place;
  culprit.operand = operand;
  throw Error(ErrorCode::kBadInput, fault.message, culprit);
}

/// One of the two that are to be summed: prepared before, or now.
struct Given {
  const Region& region;
  const PreparedOperand* operand = nullptr;
};

void prepare(const Given& p, const Given& q, const Options& options, Workspace::State& w) {
  std::array<const PreparedOperand*, 2> ready{p.operand, q.operand};
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    if (ready[i] != nullptr) continue;
    std::vector<Fault> faults;
    prepare_operand(i == 0 ? p.region : q.region, options, 1, w.operand_scratch, w.prepared[i],
                    faults);
    if (!faults.empty()) reject(faults[0], static_cast<int>(i));
    ready[i] = &w.prepared[i];
  }
  combine_operands(*ready[0], *ready[1], options, w.operands);
}

void report_tight_places(const Options& options, const std::function<void()>& stop,
                         Predicates& predicates, Workspace::State& w) {
  find_tight_places(w.operands, w.arrangement, w.loops, w.filtered, stop, predicates, w.trees,
                    w.tight_scratch, w.tight);
  write_tight_places(w.operands, w.arrangement, w.tight, *options.tight);
}

void run_pipeline(const Given& p, const Given& q, const Options& options, Workspace::State& w,
                  Statistics& statistics, Region& result) {
  StageRunner runner(options, statistics);
  const std::function<void()> stop = [&] { runner.stop_if_asked(); };

  runner.run(Stage::kOperands, [&] { prepare(p, q, options, w); });
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
    if (w.operands.both_convex && options.method == Method::kReduced) {
      arrange_convex(w.operands, w.arrangement);
    } else {
      arrange(w.operands, w.convolution, w.cover, options, stop, predicates,
              w.arrangement_scratch, w.arrangement);
    }
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
  if (options.tight != nullptr) {
    runner.run(Stage::kOutput, [&] { report_tight_places(options, stop, predicates, w); });
    if (options.check) {
      runner.require(check(w.tight, w.arrangement, w.loops, w.filtered, w.operands));
    }
  }
  count(w, predicates, statistics);
  if (options.trace != nullptr) {
    fill_trace(w.operands, w.convolution, w.cover, w.arrangement, w.loops, w.filtered,
               *options.trace);
  }
}

void require_legal(const Given& p, const Given& q) {
  for (const int i : {0, 1}) {
    const Given& given = i == 0 ? p : q;
    if (given.operand != nullptr) continue;
    const auto faults = validate(given.region, 1);
    if (!faults.empty()) reject(faults[0], i);
  }
}

void run(const Given& p, const Given& q, const Options& options, Workspace::State& state,
         Region& result) {
  Statistics own;
  Statistics& statistics = options.statistics != nullptr ? *options.statistics : own;
  statistics = Statistics{};
  if (options.trace != nullptr) *options.trace = Trace{};
  if (options.tight != nullptr) *options.tight = Geometry{};
  if (options.tight != nullptr && options.method != Method::kReduced) {
    throw Error(ErrorCode::kBadInput, "tight places are found by Method::kReduced only");
  }
  const auto begin = std::chrono::steady_clock::now();
  if (p.region.empty() || q.region.empty()) {
    require_legal(p, q);
    result.clear();
  } else if (options.method == Method::kSigned) {
    require_legal(p, q);
    signed_convolution_sum(p.region, q.region, options, statistics, result);
  } else {
    run_pipeline(p, q, options, state, statistics, result);
  }
  statistics.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

namespace {

Region run(const Given& p, const Given& q, const Options& options) {
  Workspace workspace;
  Region result;
  run(p, q, options, workspace.state(), result);
  return result;
}

Outcome run_without_exceptions(const Given& p, const Given& q, const Options& options,
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

Given given(const PreparedRegion& region) {
  return {region.region(), &region.state().operand};
}

}  // namespace

PreparedRegion::PreparedRegion(Region region) {
  auto state = std::make_shared<State>();
  state->region = std::move(region);
  if (!state->region.empty()) {
    OperandScratch scratch;
    std::vector<Fault> faults;
    prepare_operand(state->region, Options{}, 1, scratch, state->operand, faults);
    if (!faults.empty()) reject(faults[0], -1);
  }
  state_ = std::move(state);
}

const Region& PreparedRegion::region() const { return state_->region; }

Region minkowski_sum(const Region& p, const Region& q, const Options& options) {
  return run(Given{p}, Given{q}, options);
}
Region minkowski_sum(const PreparedRegion& p, const PreparedRegion& q, const Options& options) {
  return run(given(p), given(q), options);
}
Outcome minkowski_sum(const Region& p, const Region& q, const Options& options,
                      Workspace& workspace, Region& result) {
  return run_without_exceptions(Given{p}, Given{q}, options, workspace, result);
}
Outcome minkowski_sum(const PreparedRegion& p, const PreparedRegion& q, const Options& options,
                      Workspace& workspace, Region& result) {
  return run_without_exceptions(given(p), given(q), options, workspace, result);
}

}  // namespace minksum
