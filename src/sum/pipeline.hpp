// The driver of the stages: operands → convolution → cover → arrangement → loops → filters →
// output.
#pragma once

#include <array>
#include <memory>

#include "minksum/prepared_region.hpp"
#include "minksum/testing.hpp"
#include "sum/cover/shared_raster.hpp"
#include "sum/output/output.hpp"
#include "sum/small/small_sum.hpp"
#include "sum/stage_runner.hpp"
#include "sum/tight/tight.hpp"

namespace minksum {

/// The results and scratch memory of all stages.
struct StageMemory {
  StageMemory();
  ~StageMemory();

  OperandScratch operand_scratch;
  std::array<PreparedOperand, 2> prepared;
  std::array<Region, 2> walks;          ///< from `walk_there_and_back`
  std::array<PreparedOperand, 2> thin;  ///< made of `walks`
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

struct Workspace::State {
  SmallScratch small_scratch;
  std::array<SmallOperand, 2> small_areas;  ///< of geometries, which are summed part by part
  /// Made when it is asked for: making it takes as long as a sum of two small polygons.
  [[nodiscard]] StageMemory& stages() {
    if (!stages_) stages_ = std::make_unique<StageMemory>();
    return *stages_;
  }

 private:
  std::unique_ptr<StageMemory> stages_;
};

struct PreparedRegion::State {
  Region region;
  PreparedOperand operand;                    ///< made of `region`, unless that is empty
  std::unique_ptr<const SmallOperand> small;  ///< null if `region` is not small
};

/// One operand as the caller gave it.
struct CallerOperand {
  const Region& region;
  const PreparedOperand* operand = nullptr;  ///< null if `region` is not prepared yet
  const SmallOperand* small = nullptr;  ///< null if `region` is not known to be small and valid
};

/// Computes the sum of two operands that are not empty, by Method::kReduced or kFull.
void run_pipeline(const CallerOperand& p, const CallerOperand& q, const SumRequest& options,
                  StageMemory& w, Region& result);

// -- Parts of it --------------------------------------------------------------------------------
/// Returns the prepared form of an operand, first or second (0 or 1). Prepares it in the workspace
/// if it is not prepared yet. Throws the error for its first fault, unless it is known to be valid.
[[nodiscard]] const PreparedOperand& prepare(const CallerOperand& given, std::size_t operand,
                                             const SumRequest& options, Cancellation& cancellation,
                                             StageMemory& w);
/// Combines a prepared operand with a region that is known to be valid.
void prepare_valid(const PreparedOperand& p, const Region& valid, NarrowHoles narrow,
                   const SumRequest& options, Cancellation& cancellation, StageMemory& w);
/// Lists the convolution, or only a sample of it if it has very many segments.
void convolve(StageMemory& w, const SumSettings& options, Cancellation& cancellation);
/// Runs the stages after the first. `shared` is a raster for these operands, or null.
void run_stages(const SumRequest& options, const SharedRaster* shared, StageRunner& runner,
                StageMemory& w, Region& result);

}  // namespace minksum
