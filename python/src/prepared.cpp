#include "prepared.hpp"

#include <mutex>
#include <optional>

namespace minksum::python {

struct PreparedSlot::Kept {
  std::atomic<bool> again{false};
  std::once_flag once;
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

const PreparedRegion* PreparedSlot::get(const Geometry& geometry, const Options& options) const {
  Kept& kept = this->kept();
  if (!kept.again.exchange(true)) return nullptr;
  std::call_once(kept.once, [&] {
    if (geometry.has_thin_parts()) return;
    try {
      // Not resolved: origins count the vertices of the rings as they are.
      kept.region.emplace(geometry.region, options);
    } catch (const Error& error) {
      if (error.code() != ErrorCode::kBadInput) throw;
    }
  });
  return kept.region ? &*kept.region : nullptr;
}

void PreparedSlot::fill(const Geometry& geometry) const {
  kept().again = true;
  (void)get(geometry, {});
}

}  // namespace minksum::python
