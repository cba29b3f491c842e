#include "prepared.hpp"

#include <optional>

namespace minksum::python {

struct PreparedSlot::Kept {
  enum State { kNew, kAsked, kBusy, kDone };
  std::atomic<State> state{kNew};
  std::optional<PreparedRegion> region;  ///< nothing if there are thin parts or rings that cross
};

PreparedSlot::~PreparedSlot() { delete kept_.load(); }

PreparedSlot::Kept& PreparedSlot::kept() const {
  Kept* found = kept_.load();
  if (found == nullptr) {
    auto* made = new Kept();
    if (kept_.compare_exchange_strong(found, made)) return *made;
    delete made;  // another thread was faster
  }
  return *found;
}

// Whoever prepares may need the interpreter's lock, or call back a function that asks for the same
// geometry. So nobody waits for it: meanwhile, sums do without.
const PreparedRegion* PreparedSlot::get(const Geometry& geometry, const Options& options) const {
  Kept& kept = this->kept();
  Kept::State state = Kept::kNew;
  if (kept.state.compare_exchange_strong(state, Kept::kAsked)) return nullptr;
  if (state == Kept::kAsked && kept.state.compare_exchange_strong(state, Kept::kBusy)) {
    try {
      // Not resolved: origins count the vertices of the rings as they are.
      if (!geometry.has_thin_parts()) kept.region.emplace(geometry.region, options);
    } catch (const Error& error) {
      if (error.code() != ErrorCode::kBadInput) {
        kept.state = Kept::kAsked;
        throw;
      }
    } catch (...) {
      kept.state = Kept::kAsked;
      throw;
    }
    kept.state = state = Kept::kDone;
  }
  return state == Kept::kDone && kept.region ? &*kept.region : nullptr;
}

void PreparedSlot::fill(const Geometry& geometry, const Options& options) const {
  Kept::State state = Kept::kNew;
  kept().state.compare_exchange_strong(state, Kept::kAsked);
  (void)get(geometry, options);
}

}  // namespace minksum::python
