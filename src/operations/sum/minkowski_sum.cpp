// The public sums, on top of the pipeline.
#include "minksum/minkowski_sum.hpp"

#include <array>
#include <chrono>
#include <new>
#include <type_traits>

#include "minksum/prepared_region.hpp"
#include "operations/sum/fixed_sum.hpp"
#include "operations/sum/geometry_sum.hpp"
#include "second/signed_convolution/signed_convolution.hpp"
#include "sum/pipeline.hpp"
#include "sum/small/small_sum.hpp"
#include "validation/fault.hpp"

namespace minksum {

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

using Clock = std::chrono::steady_clock;

void require_valid(const CallerOperand& p, const CallerOperand& q, const Options& options) {
  for (const int i : {0, 1}) {
    const CallerOperand& given = i == 0 ? p : q;
    if (given.operand == nullptr) minksum::require_valid(given.region, i, options.cancel);
  }
}

void require_method_for_tight(const Options& options) {
  if (options.tight != nullptr && options.method != Method::kReduced) {
    throw Error(ErrorCode::kBadInput, "tight places are found by Method::kReduced only");
  }
}

/// Where the tight places go, as an object of the result's type.
Region* tight_of(const Options& options, const Region&) {
  return options.tight == nullptr ? nullptr : &options.tight->region;
}
Geometry* tight_of(const Options& options, const Geometry&) { return options.tight; }

/// An operand that stays as it is while results are written: it is copied first if it is one.
template <class Set>
class Kept {
 public:
  Kept(const Set& operand, const Options& options, const std::type_identity_t<Set>* result)
      : operand_(&operand) {
    if (&operand != result && &operand != tight_of(options, operand)) return;
    copy_ = operand;
    operand_ = &*copy_;
  }
  [[nodiscard]] const Set& operator*() const { return *operand_; }

 private:
  std::optional<Set> copy_;
  const Set* operand_;
};

template <class Set>
void require_two_results(const Options& options, const Set& result) {
  if (&result != tight_of(options, result)) return;
  throw Error(ErrorCode::kBadInput, "the sum and its tight places cannot be one object");
}

/// Whether nothing is asked for that the stages alone give.
bool may_be_small(const Options& o) {
  return o.method == Method::kReduced && o.arithmetic == Arithmetic::kAutomatic && o.filter &&
         o.cover && o.grid == 0 && !o.check && !o.progress && o.statistics == nullptr &&
         o.trace == nullptr && o.tight == nullptr && allow_small(o.limits);
}

/// Null if it is none.
const SmallOperand* small_of(const CallerOperand& given, SmallOperand& memory) {
  if (given.small != nullptr) return given.small;
  if (given.operand != nullptr) return nullptr;  // it was looked for when that was made
  return read_small(given.region, SmallHoles::kNone, memory) ? &memory : nullptr;
}

bool run_small(const CallerOperand& p, const CallerOperand& q, const Options& options,
               SmallScratch& scratch, Region& result) {
  if (!may_be_small(options)) return false;
  Cancellation(options).look();
  std::array<SmallOperand, 2> memory;
  const SmallOperand* const small_p = small_of(p, memory[0]);
  if (small_p == nullptr) return false;
  const SmallOperand* const small_q = small_of(q, memory[1]);
  return small_q != nullptr && sum_small(*small_p, *small_q, scratch, result);
}

void run(const CallerOperand& p, const CallerOperand& q, const Options& options,
         Workspace::State& state, Region& result) {
  const std::optional<Clock::time_point> begin =
      options.statistics != nullptr ? std::optional(Clock::now()) : std::nullopt;
  if (options.statistics != nullptr) *options.statistics = Statistics{};
  if (options.trace != nullptr) *options.trace = Trace{};
  if (options.tight != nullptr) *options.tight = Geometry{};
  require_method_for_tight(options);
  if (p.region.empty() || q.region.empty()) {
    require_valid(p, q, options);
    result.clear();
  } else if (options.method == Method::kSigned) {
    require_valid(p, q, options);
    Statistics unwanted;
    Statistics& statistics = options.statistics != nullptr ? *options.statistics : unwanted;
    signed_convolution_sum(p.region, q.region, options, statistics, result);
  } else if (!run_small(p, q, options, state.small_scratch, result)) {
    run_pipeline(p, q, options, state, result);
  }
  if (begin) {
    options.statistics->seconds = std::chrono::duration<double>(Clock::now() - *begin).count();
  }
}

Region run(const CallerOperand& p, const CallerOperand& q, const Options& options) {
  Workspace workspace;
  Region result;
  run(p, q, options, workspace.state(), result);
  return result;
}

/// `work` and what became of it; on failure `clear` is called.
template <class Work, class Clear>
Outcome without_exceptions(Work work, Clear clear) {
  try {
    work();
    return {};
  } catch (const Error& error) {
    clear();
    return {error};
  } catch (const std::bad_alloc&) {
    clear();
    return {Error(ErrorCode::kLimitExceeded, "out of memory", {}, {}, ExceededLimit{"memory"})};
  }
}
Outcome run_without_exceptions(const CallerOperand& p, const CallerOperand& q,
                               const Options& options, Workspace& workspace, Region& result) {
  const auto work = [&] {
    require_two_results(options, result);
    run(p, q, options, workspace.state(), result);
  };
  return without_exceptions(work, [&] { result.clear(); });
}

/// The sums that a sum of geometries is made of.
class Sums final : public PartialSums {
 public:
  Sums(const Options& options, Workspace::State& state)
      : options_(options),
        quiet_(options),
        cancellation_(options),
        state_(state),
        begin_(Clock::now()) {
    quiet_.statistics = nullptr;
    quiet_.trace = nullptr;
    quiet_.tight = nullptr;
    if (options.statistics != nullptr) *options.statistics = Statistics{};
    if (options.trace != nullptr) *options.trace = Trace{};
  }

  bool take(int operand, const Region& region) override {
    const auto i = static_cast<std::size_t>(operand);
    regions_[i] = &region;
    is_small_[i] = false;
    if (region.empty()) return true;
    cancellation_.look();
    is_small_[i] = may_be_small(quiet_) && read_small(region, SmallHoles::kNone, small_[i]);
    if (is_small_[i]) return true;
    const auto begin = Clock::now();
    std::vector<Fault> faults;
    prepare_operand(region, options_, 1, cancellation_, state_.operand_scratch, state_.prepared[i],
                    faults);
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
    } else {  // what is prepared only now takes the place of this operand, not of the other
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
    list_parallel_sums(state_.operands, state_.walks, options_.limits, cancellation_,
                       sum.polylines);
  }
  Cancellation& cancellation() override { return cancellation_; }
  /// What the statistics lack: the time around the sum of regions.
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
  /// What is small is prepared where it is summed with what is not.
  [[nodiscard]] CallerOperand taken(std::size_t i) const {
    if (is_small_[i]) return {*regions_[i], nullptr, &small_[i]};
    return {*regions_[i], &state_.prepared[i]};
  }
  CallerOperand walk(std::size_t i, std::span<const Polyline> polylines) {
    walk_there_and_back(polylines, cancellation_, state_.walks[i]);
    prepare_thin_operand(state_.walks[i], options_, cancellation_, state_.operand_scratch,
                         state_.thin[i]);
    return {state_.walks[i], &state_.thin[i]};
  }

  const Options& options_;
  Options quiet_;  ///< for the sums that are not to be told of
  Cancellation cancellation_;
  Workspace::State& state_;
  Clock::time_point begin_;
  Clock::duration preparing_{};
  std::array<const Region*, 2> regions_{};
  std::array<bool, 2> is_small_{};
  std::array<SmallOperand, 2> small_;
};

void run(const Geometry& p, const Geometry& q, const Options& options, Workspace::State& state,
         Geometry& result) {
  require_method_for_tight(options);
  const Kept first(p, options, &result);
  const Kept second(q, options, &result);
  Sums sums(options, state);
  sum_geometries(*first, *second, options, sums, result);
  sums.count_time();
}

CallerOperand given(const PreparedRegion& region) {
  return {region.region(), &region.state().operand, region.state().small.get()};
}

}  // namespace

PreparedRegion::PreparedRegion(Region region, const std::optional<CancelToken>& cancel) {
  Cancellation cancellation(cancel);
  auto state = std::make_shared<State>();
  state->region = std::move(region);
  if (!state->region.empty()) {
    OperandScratch scratch;
    std::vector<Fault> faults;
    prepare_operand(state->region, Options{}, 1, cancellation, scratch, state->operand, faults);
    if (!faults.empty()) reject(faults[0], -1);
    auto small = std::make_unique<SmallOperand>();
    if (read_small(state->region, SmallHoles::kSome, *small)) state->small = std::move(small);
  }
  state_ = std::move(state);
}

const Region& PreparedRegion::region() const { return state_->region; }

Region minkowski_sum(const Region& p, const Region& q, const Options& options) {
  const Kept first(p, options, nullptr);
  const Kept second(q, options, nullptr);
  return run(CallerOperand{*first}, CallerOperand{*second}, options);
}
Region minkowski_sum(const PreparedRegion& p, const PreparedRegion& q, const Options& options) {
  return run(given(p), given(q), options);
}
Region minkowski_sum(const Region& p, const PreparedRegion& q, const Options& options) {
  const Kept first(p, options, nullptr);
  return run(CallerOperand{*first}, given(q), options);
}
Region minkowski_sum(const PreparedRegion& p, const Region& q, const Options& options) {
  const Kept second(q, options, nullptr);
  return run(given(p), CallerOperand{*second}, options);
}
Outcome minkowski_sum(const Region& p, const Region& q, const Options& options,
                      Workspace& workspace, Region& result) {
  const Kept first(p, options, &result);
  const Kept second(q, options, &result);
  return run_without_exceptions(CallerOperand{*first}, CallerOperand{*second}, options, workspace,
                                result);
}
Outcome minkowski_sum(const PreparedRegion& p, const PreparedRegion& q, const Options& options,
                      Workspace& workspace, Region& result) {
  return run_without_exceptions(given(p), given(q), options, workspace, result);
}
Outcome minkowski_sum(const Region& p, const PreparedRegion& q, const Options& options,
                      Workspace& workspace, Region& result) {
  const Kept first(p, options, &result);
  return run_without_exceptions(CallerOperand{*first}, given(q), options, workspace, result);
}
Outcome minkowski_sum(const PreparedRegion& p, const Region& q, const Options& options,
                      Workspace& workspace, Region& result) {
  const Kept second(q, options, &result);
  return run_without_exceptions(given(p), CallerOperand{*second}, options, workspace, result);
}
Outcome sum_by_stages(const PreparedRegion& p, const PreparedRegion& q, const Options& options,
                      Workspace& workspace, Region& result) {
  return run_without_exceptions({p.region(), &p.state().operand}, {q.region(), &q.state().operand},
                                options, workspace, result);
}
Outcome minkowski_sum(const PreparedRegion& fixed, const Region& valid, const SharedRaster* shared,
                      const Options& options, Workspace& workspace, Region& result) {
  Workspace::State& w = workspace.state();
  const auto run_all = [&] {
    if (options.statistics != nullptr) *options.statistics = Statistics{};
    if (options.tight != nullptr) *options.tight = Geometry{};
    if (fixed.region().empty() || valid.empty()) return result.clear();
    StageRunner runner(options);
    runner.run(Stage::kOperands, [&] {
      prepare_valid(fixed.state().operand, valid, NarrowHoles::kFill, options,
                    runner.cancellation(), w);
    });
    run_stages(options, shared, runner, w, result);
  };
  return without_exceptions(run_all, [&] { result.clear(); });
}

std::optional<SharedRaster> share_raster(const PreparedRegion& fixed, const Region& typical,
                                         double widest, const Options& options) {
  Workspace workspace;
  Workspace::State& w = workspace.state();
  Cancellation cancellation(options);
  try {
    prepare_valid(fixed.state().operand, typical, NarrowHoles::kKeep, options, cancellation, w);
    convolve(w, options, cancellation);
    return share_raster(w.operands, widest, options, cancellation, w.cover_scratch, w.convolution);
  } catch (const Error& error) {
    // With narrow holes there may be more than the limits allow; each sum tells for itself.
    if (error.code() != ErrorCode::kLimitExceeded) throw;
    return std::nullopt;
  }
}

Geometry minkowski_sum(const Geometry& p, const Geometry& q, const Options& options) {
  Workspace workspace;
  Geometry result;
  run(p, q, options, workspace.state(), result);
  return result;
}
Outcome minkowski_sum(const Geometry& p, const Geometry& q, const Options& options,
                      Workspace& workspace, Geometry& result) {
  const auto work = [&] {
    require_two_results(options, result);
    run(p, q, options, workspace.state(), result);
  };
  return without_exceptions(work, [&] { result = {}; });
}

}  // namespace minksum
