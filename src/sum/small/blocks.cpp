#include "sum/small/blocks.hpp"

#include "machine/vectors.hpp"

namespace minksum {

void SmallBlocks::set(const double* x, const double* y, const double* dx, const double* dy,
                      std::size_t count, double reach) {
  blocks_.make(filled_up(count) / kLanes);
  const auto set_boxes = [&]() __attribute__((always_inline)) {
    for (std::size_t b = 0; b < size(); ++b) {
      Box box = box_of_segment(x[b * kLanes], y[b * kLanes], dx[b * kLanes], dy[b * kLanes]);
      for (std::size_t i = b * kLanes + 1; i < std::min((b + 1) * kLanes, count); ++i) {
        box.add(box_of_segment(x[i], y[i], dx[i], dy[i]));
      }
      box = {box.x0 - reach, box.y0 - reach, box.x1 + reach, box.y1 + reach};
      blocks_.set(b, box);
      b == 0 ? static_cast<void>(all_ = box) : all_.add(box);
    }
  };
  with_vectors(widest_vectors(), set_boxes);
  words_.clear();
  for (std::size_t b = 0; size() > 64 && b < size(); ++b) {
    if (b % 64 == 0) words_.push_back(blocks_[b]);
    words_.back().add(blocks_[b]);
  }
}

}  // namespace minksum
