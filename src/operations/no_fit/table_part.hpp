// Declares a part of a table of no-fit polygons, ready to be summed in each of its directions.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "minksum/no_fit.hpp"
#include "minksum/prepared_region.hpp"
#include "sum/small/small_operand.hpp"

namespace minksum {

/// A part in each direction, with its reference point at the origin. Any number of threads may ask.
class TablePart {
 public:
  /// Reads a part. `given` and `options` must live as long as this object. Throws Error(kBadInput)
  /// with the part's index if it has no area or is not a valid operand.
  TablePart(const Geometry& given, std::size_t index, int turns, const Options& options);

  /// Returns how many directions there are: the table's turns, or 2 for one turn, with the point
  /// mirror.
  [[nodiscard]] std::size_t directions() const { return directions_; }
  /// Returns null if the part is not small.
  [[nodiscard]] const SmallOperand* small(std::size_t direction) const {
    return small_.empty() ? nullptr : &small_[direction];
  }
  /// Returns the prepared part. A small one is prepared only when this is called, which is rare.
  [[nodiscard]] const PreparedRegion& prepared(std::size_t direction) const;

 private:
  /// The part in all directions, made when one is asked for.
  struct Prepared {
    std::once_flag once;
    std::vector<PreparedRegion> directions;
  };
  [[nodiscard]] int quarters(std::size_t direction) const;
  [[nodiscard]] bool read_small_part();
  /// Returns the area of the part, with its reference point at the origin.
  [[nodiscard]] Region covered() const;

  const Geometry* given_;
  std::size_t index_;
  const Options* options_;
  std::vector<SmallOperand> small_;
  std::size_t directions_;
  std::unique_ptr<Prepared> prepared_;
};

}  // namespace minksum
