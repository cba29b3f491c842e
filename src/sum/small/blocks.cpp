#include "sum/small/blocks.hpp"

#include "machine/vectors.hpp"

namespace minksum {

void SmallBlocks::set(const double* x, const double* y, const double* dx, const double* dy,
                      std::size_t count, double reach) {
  blocks_.make(filled_up(count) / kLanes);
  const auto set_boxes = [&]() __attribute__((always_inline)) {
    for (std::size_t b = 0; b < size(); ++b) {
      using Row = std::array<double, kLanes>;
      alignas(64) Row x0;
      alignas(64) Row y0;
      alignas(64) Row x1;
      alignas(64) Row y1;
      for (std::size_t t = 0; t < kLanes; ++t) {
        const std::size_t i = b * kLanes + t;
        const Box box = box_of_segment(x[i], y[i], dx[i], dy[i]);
        x0[t] = box.x0;
        y0[t] = box.y0;
        x1[t] = box.x1;
        y1[t] = box.y1;
      }
      // By halves: vectors are compared, not one number after the other.
      for (std::size_t half = kLanes / 2; half > 0; half /= 2) {
        for (std::size_t t = 0; t < half; ++t) {
          x0[t] = std::min(x0[t], x0[t + half]);
          y0[t] = std::min(y0[t], y0[t + half]);
          x1[t] = std::max(x1[t], x1[t + half]);
          y1[t] = std::max(y1[t], y1[t + half]);
        }
      }
      const Box box{x0[0] - reach, y0[0] - reach, x1[0] + reach, y1[0] + reach};
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
