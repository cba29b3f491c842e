// Decides whether a region is a valid operand, and where it is not.
#include "validation/prepared_operand.hpp"

namespace minksum {
namespace {

constexpr std::size_t kMaxVertices = std::size_t{1} << 30;

}  // namespace

void load_and_validate(const Region& region, const SumSettings& options, std::size_t max_faults,
                       Cancellation& cancellation, OperandScratch& scratch,
                       PreparedOperand& operand, std::vector<Fault>& faults) {
  if (region.vertex_count() > kMaxVertices) {
    throw Error(ErrorCode::kLimitExceeded, "an operand has more than 2^30 vertices");
  }
  load_sites(region, options, cancellation, operand);
  clean_rings(options, cancellation, scratch, operand, faults);
  if (faults.size() < max_faults) find_faults(max_faults, cancellation, scratch, operand, faults);
}

std::vector<Fault> validate(const Region& region, std::size_t max_faults, const Options& options) {
  Cancellation cancellation(options);
  std::vector<Fault> faults;
  if (region.ring_count() == 0) return faults;
  cancellation.look();
  OperandScratch scratch;
  PreparedOperand operand;
  load_and_validate(region, SumSettings{}, max_faults, cancellation, scratch, operand, faults);
  if (faults.size() > max_faults) faults.resize(max_faults);
  return faults;
}

}  // namespace minksum
