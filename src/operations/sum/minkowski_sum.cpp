// Implements the public sums on top of the pipeline.
#include "minksum/minkowski_sum.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <type_traits>

#include "minksum/prepared_region.hpp"
#include "minksum/testing.hpp"
#include "operations/sum/fixed_sum.hpp"
#include "operations/sum/geometry_sum.hpp"
#include "region/map_points.hpp"
#include "second/signed_convolution/signed_convolution.hpp"
#include "sum/pipeline.hpp"
#include "sum/small/small_sum.hpp"
#include "validation/fault.hpp"

namespace minksum {

const char* to_string(Stage stage) {
  static constexpr std::array kNames{"operands", "convolution", "cover",  "arrangement",
                                     "loops",    "filters",     "output", "overlay",
                                     "rounding", "checking",    "search"};
  return name_of(stage, kNames);
}

namespace {

using Clock = std::chrono::steady_clock;

void require_valid(const CallerOperand& p, const CallerOperand& q, const SumRequest& options) {
  for (const int i : {0, 1}) {
    const CallerOperand& given = i == 0 ? p : q;
    if (given.operand == nullptr) minksum::require_valid(given.region, i, options);
  }
}

void require_method_for_tight(const SumRequest& request) {
  if (request.tight_places != nullptr && request.method != Method::kReduced) {
    refuse_input("tight places are found by Method::kReduced only");
  }
}

/// Keeps an operand as it is while the result is written. An operand that is the result is copied.
template <class Operand>
class Kept {
 public:
  template <class Set>
  Kept(const Operand& operand, const Set& result) : operand_(&operand) {
    if constexpr (std::is_same_v<Operand, Set>) {
      if (&operand == &result) operand_ = &copy_.emplace(operand);
    }
  }
  [[nodiscard]] const Operand& operator*() const { return *operand_; }

 private:
  std::optional<Operand> copy_;
  const Operand* operand_;
};

/// Tells whether nothing is asked for that only the stages can give.
bool may_be_small(const SumRequest& r) {
  return r.small && r.method == Method::kReduced && r.arithmetic == Arithmetic::kAutomatic &&
         r.filter && r.cover && r.grid == 0 && !r.check && r.trace == nullptr &&
         r.tight_places == nullptr && allow_small(r.limits);
}

/// Validates operands that are not known to be valid, by preparing them: their rings may touch.
void validate_others(std::array<CallerOperand, 2>& given,
                     const std::array<const SmallOperand*, 2>& small, const SumRequest& options,
                     Workspace::State& state) {
  if (given[0].small != nullptr && given[1].small != nullptr) return;
  StageMemory& w = state.stages();
  StageRunner runner(options);
  runner.run(Stage::kOperands, [&] {
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
      CallerOperand& o = given[i];
      if (o.small == nullptr) o.operand = &prepare(o, i, options, runner.cancellation(), w);
      o.small = small[i];
    }
  });
}

/// Computes the sum if it is small. Otherwise tells which operands are known to be valid, so that
/// these need not be validated again.
bool run_small(std::array<CallerOperand, 2>& given, const SumRequest& options,
               Workspace::State& state, Region& result) {
  if (!may_be_small(options)) return false;
  const auto has_several = [](const CallerOperand& o) { return o.region.polygon_count() > 1; };
  if (std::ranges::all_of(given, has_several)) return false;
  // A prepared operand that is not small has been looked at before.
  const auto fits = [](const CallerOperand& o) {
    return o.small != nullptr || (o.operand == nullptr && has_small_size(o.region));
  };
  if (!std::ranges::all_of(given, fits)) return false;
  Cancellation(options).look();
  SmallScratch& scratch = state.small_scratch;
  std::array<SmallOperand, 2>& memory = scratch.operands();
  std::array<const SmallOperand*, 2> small{given[0].small, given[1].small};
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    if (small[i] != nullptr) continue;
    if (!load_small(given[i].region, memory[i])) return false;
    small[i] = &memory[i];
  }
  // On its own grid, an operand has shorter numbers.
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    CallerOperand& o = given[i];
    if (o.small != nullptr) continue;
    if (is_clearly_valid(memory[i], scratch.blocks())) o.small = small[i];
  }
  const SmallPlan plan = plan_sum(*small[0], *small[1]);
  if (plan.numbers == SmallNumberType::kNone) return false;
  validate_others(given, small, options, state);
  bring_to_one_grid(plan, small, memory);
  if (!sum_small(plan, *small[0], *small[1], scratch, result)) return false;
  if (options.statistics != nullptr) {
    options.statistics->small = true;
    options.statistics->convolution_segments = scratch.segments();
    options.statistics->segments_kept = scratch.segments_kept();
  }
  return true;
}

void run(const CallerOperand& p, const CallerOperand& q, const SumRequest& options,
         Workspace::State& state, Region& result) {
  const auto begin = options.statistics != nullptr ? Clock::now() : Clock::time_point{};
  if (options.statistics != nullptr) *options.statistics = Statistics{};
  if (options.trace != nullptr) *options.trace = Trace{};
  if (options.tight_places != nullptr) *options.tight_places = Geometry{};
  require_method_for_tight(options);
  if (p.region.empty() || q.region.empty()) {
    Cancellation{options};
    require_valid(p, q, options);
    result.clear();
  } else if (options.method == Method::kSigned) {
    require_valid(p, q, options);
    Statistics unwanted;
    Statistics& statistics = options.statistics != nullptr ? *options.statistics : unwanted;
    signed_convolution_sum(p.region, q.region, options, statistics, result);
  } else {
    std::array<CallerOperand, 2> given{p, q};
    if (!run_small(given, options, state, result)) {
      run_pipeline(given[0], given[1], options, state.stages(), result);
    }
  }
  if (options.statistics != nullptr) {
    options.statistics->seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  }
}

/// The caller's memory, or memory for one call.
class Memory {
 public:
  explicit Memory(const Options& options)
      : workspace_(options.memory != nullptr ? options.memory : &own_.emplace()) {}
  Memory(const Memory&) = delete;
  Memory& operator=(const Memory&) = delete;
  [[nodiscard]] Workspace::State& state() { return workspace_->state(); }

 private:
  std::optional<Workspace> own_;
  Workspace* workspace_;
};

/// Computes the sums of which a sum of geometries is made.
class Sums final : public PartialSums {
 public:
  Sums(const SumRequest& options, Workspace::State& state)
      : options_(options),
        quiet_(options),
        cancellation_(options),
        state_(state),
        begin_(Clock::now()) {
    quiet_.statistics = nullptr;
    quiet_.trace = nullptr;
    quiet_.tight_places = nullptr;
    quiet_.tight = false;
    if (options.statistics != nullptr) *options.statistics = Statistics{};
    if (options.trace != nullptr) *options.trace = Trace{};
  }

  bool take(int operand, const Region& region) override {
    const auto i = static_cast<std::size_t>(operand);
    regions_[i] = &region;
    is_small_[i] = is_prepared_[i] = false;
    if (region.empty()) return true;
    cancellation_.look();
    SmallOperand& small = state_.small_areas[i];
    is_small_[i] = may_be_small(quiet_) && load_small(region, small);
    if (is_small_[i] && is_clearly_valid(small, state_.small_scratch.blocks())) return true;
    is_prepared_[i] = true;
    const auto begin = Clock::now();
    std::vector<Fault> faults;
    StageMemory& w = state_.stages();
    prepare_operand(region, options_, 1, cancellation_, w.operand_scratch, w.prepared[i], faults);
    preparing_ += Clock::now() - begin;
    return faults.empty();
  }
  void add_regions(Region& sum) override { run(taken(0), taken(1), options_, state_, sum); }
  void sweep(int operand, std::span<const Polyline> polylines, Region& sum) override {
    const CallerOperand area = taken(static_cast<std::size_t>(operand));
    if (options_.method == Method::kSigned) {
      signed_convolution_sum(area.region, polylines, quiet_, sum);
    } else if (operand == 0) {
      run(area, walk(0, polylines), quiet_, state_, sum);
    } else {  // what is prepared now takes this operand's memory, not the other's
      run(walk(0, polylines), area, quiet_, state_, sum);
    }
    forget_origins(sum);
  }
  void add_polylines(std::span<const Polyline> p, std::span<const Polyline> q,
                     Geometry& sum) override {
    if (options_.method == Method::kSigned) {
      signed_convolution_sum(p, q, quiet_, sum);
      return;
    }
    run(walk(0, p), walk(1, q), quiet_, state_, sum.region);
    forget_origins(sum.region);
    const StageMemory& w = state_.stages();
    list_parallel_sums(w.operands, w.walks, options_.limits, cancellation_, sum.polylines);
  }
  Cancellation& cancellation() override { return cancellation_; }
  /// Adds what the statistics lack: the time outside of the sum of regions.
  void count_time() const {
    if (options_.statistics == nullptr) return;
    Statistics& statistics = *options_.statistics;
    statistics.stage_seconds[static_cast<int>(Stage::kOperands)] += seconds(preparing_);
    statistics.seconds = seconds(Clock::now() - begin_);
  }

 private:
  static double seconds(Clock::duration time) {
    return std::chrono::duration<double>(time).count();
  }
  [[nodiscard]] CallerOperand taken(std::size_t i) const {
    return {*regions_[i], is_prepared_[i] ? &state_.stages().prepared[i] : nullptr,
            is_small_[i] ? &state_.small_areas[i] : nullptr};
  }
  CallerOperand walk(std::size_t i, std::span<const Polyline> polylines) {
    StageMemory& w = state_.stages();
    walk_there_and_back(polylines, cancellation_, w.walks[i]);
    prepare_thin_operand(w.walks[i], options_, cancellation_, w.operand_scratch, w.thin[i]);
    return {w.walks[i], &w.thin[i]};
  }

  const SumRequest& options_;
  SumRequest quiet_;  ///< for the sums without statistics, trace and tight places
  Cancellation cancellation_;
  Workspace::State& state_;
  Clock::time_point begin_;
  Clock::duration preparing_{};
  std::array<const Region*, 2> regions_{};
  std::array<bool, 2> is_small_{};
  std::array<bool, 2> is_prepared_{};  ///< false for one that is small and clearly valid
};

void run(const Geometry& p, const Geometry& q, const SumRequest& options, Workspace::State& state,
         Geometry& result) {
  require_method_for_tight(options);
  const Kept first(p, result);
  const Kept second(q, result);
  Sums sums(options, state);
  sum_geometries(*first, *second, options, sums, result);
  sums.count_time();
}

CallerOperand given(const PreparedRegion& region) {
  return {region.region(), &region.state().operand, region.state().small.get()};
}
CallerOperand given(const Region& region) { return {region}; }

template <class P, class Q>
void run(const P& p, const Q& q, const SumRequest& options, Workspace::State& state,
         Region& result) {
  const Kept first(p, result);
  const Kept second(q, result);
  run(given(*first), given(*second), options, state, result);
}

/// Returns the sum of operands of any kind.
template <class Set, class P, class Q>
Set sum(const P& p, const Q& q, const SumRequest& options) {
  Memory memory(options);
  Set result;
  run(p, q, options, memory.state(), result);
  return result;
}
template <class P, class Q, class Set, class Settings>
Outcome attempt_sum(const P& p, const Q& q, const Settings& settings, Workspace& workspace,
                    Set& result) {
  // No part of a result is left behind, whatever ends the call: callbacks may throw anything.
  std::unique_ptr<Set, void (*)(Set*)> unfinished(&result, [](Set* set) { *set = Set{}; });
  Outcome outcome = attempt([&] { run(p, q, SumRequest(settings), workspace.state(), result); });
  if (outcome.ok()) static_cast<void>(unfinished.release());
  return outcome;
}
template <class Operand, class Settings>
DetailedSum detailed(const Operand& p, const Operand& q, const Settings& settings, Detail detail) {
  require_enumerator(detail, Detail::kTrace, "detail");
  DetailedSum result;
  SumRequest request(settings);
  request.statistics = &result.statistics;
  if (settings.tight.value_or(false)) request.want_tight_places(result.tight);
  if (detail == Detail::kTrace) request.trace = &result.trace;
  if constexpr (std::is_same_v<Operand, Geometry>) {
    result.sum = sum<Geometry>(p, q, request);
  } else {
    result.sum.region = sum<Region>(p, q, request);
  }
  return result;
}

}  // namespace

PreparedRegion::PreparedRegion(Region region, const Options& options) {
  Cancellation cancellation(options);
  auto state = std::make_shared<State>();
  state->region = std::move(region);
  if (!state->region.empty()) {
    OperandScratch scratch;
    std::vector<Fault> faults;
    prepare_operand(state->region, SumSettings{}, 1, cancellation, scratch, state->operand, faults);
    if (!faults.empty()) reject(faults[0], -1);
    auto small = std::make_unique<SmallOperand>();
    if (load_small(state->region, *small)) state->small = std::move(small);
  }
  state_ = std::move(state);
}

const Region& PreparedRegion::region() const& { return state_->region; }

// Defines the sum of two kinds of operands, and the form that reuses memory.
#define MINKSUM_SUM(Set, P, Q, Settings)                                                        \
  Set minkowski_sum(const P& p, const Q& q, const Settings& settings) {                         \
    return sum<Set>(p, q, SumRequest(settings));                                                \
  }                                                                                             \
  Outcome minkowski_sum(const P& p, const Q& q, const Settings& settings, Workspace& workspace, \
                        Set& result) {                                                          \
    return attempt_sum(p, q, settings, workspace, result);                                      \
  }
#define MINKSUM_DETAILED_SUM(Operand, Settings)                                          \
  DetailedSum detailed_sum(const Operand& p, const Operand& q, const Settings& settings, \
                           Detail detail) {                                              \
    return detailed(p, q, settings, detail);                                             \
  }
#define MINKSUM_SUMS_BY(Settings)                               \
  MINKSUM_SUM(Region, Region, Region, Settings)                 \
  MINKSUM_SUM(Region, PreparedRegion, PreparedRegion, Settings) \
  MINKSUM_SUM(Geometry, Geometry, Geometry, Settings)           \
  MINKSUM_DETAILED_SUM(Region, Settings)                        \
  MINKSUM_DETAILED_SUM(PreparedRegion, Settings)                \
  MINKSUM_DETAILED_SUM(Geometry, Settings)

MINKSUM_SUMS_BY(Options)
MINKSUM_SUMS_BY(SumSettings)
MINKSUM_SUM(Region, Region, PreparedRegion, Options)
MINKSUM_SUM(Region, PreparedRegion, Region, Options)

// -- For callers that know more about the operands -----------------------------------------------
void sum_of_geometries(const Geometry& p, const Geometry& q, const SumRequest& options,
                       Workspace& workspace, Geometry& result) {
  run(p, q, options, workspace.state(), result);
}
void sum_by_stages(const PreparedRegion& p, const PreparedRegion& q, const SumRequest& options,
                   Workspace& workspace, Region& result) {
  const CallerOperand first{p.region(), &p.state().operand};
  const CallerOperand second{q.region(), &q.state().operand};
  run(first, second, options, workspace.state(), result);
}
void minkowski_sum(const PreparedRegion& fixed, const Region& valid, const SharedRaster* shared,
                   const SumRequest& options, Workspace& workspace, Region& result) {
  StageMemory& w = workspace.state().stages();
  if (options.tight_places != nullptr) *options.tight_places = Geometry{};
  if (fixed.region().empty() || valid.empty()) return result.clear();
  StageRunner runner(options);
  runner.run(Stage::kOperands, [&] {
    prepare_valid(fixed.state().operand, valid, NarrowHoles::kFill, options, runner.cancellation(),
                  w);
  });
  run_stages(options, shared, runner, w, result);
}

std::optional<SharedRaster> share_raster(const PreparedRegion& fixed, const Region& typical,
                                         double widest, const SumRequest& options) {
  Workspace workspace;
  StageMemory& w = workspace.state().stages();
  Cancellation cancellation(options);
  try {
    prepare_valid(fixed.state().operand, typical, NarrowHoles::kKeep, options, cancellation, w);
    convolve(w, options, cancellation);
    return share_raster(w.operands, widest, options, cancellation, w.cover_scratch, w.convolution);
  } catch (const Error& error) {
    // Narrow holes may lead beyond the limits. Then each sum tells for itself.
    if (error.code() != ErrorCode::kLimitExceeded) throw;
    return std::nullopt;
  }
}

}  // namespace minksum
