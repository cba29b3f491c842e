// A part of a table of no-fit polygons, ready to be summed in each of its directions.
#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "minksum/no_fit.hpp"
#include "minksum/prepared_region.hpp"
#include "sum/small/small_operand.hpp"

namespace minksum {

/// A part in each direction, its reference point at the origin. Any number of threads may ask.
class TablePart {
 public:
  /// `given` and `options` must live as long. Throws Error(kBadInput) with the part's index if it
  /// has no area or is no valid operand.
  TablePart(const Geometry& given, std::size_t index, int turns, const Options& options);

  /// As many as the table's turns; of one turn, there is the point mirror as well.
  [[nodiscard]] std::size_t directions() const { return directions_; }
  /// Null if the part is not small.
  [[nodiscard]] const SmallOperand* small(std::size_t direction) const {
    return small_.empty() ? nullptr : &small_[direction];
  }
  /// A small part is prepared when it is asked for: hardly ever.
  [[nodiscard]] const PreparedRegion& prepared(std::size_t direction) const;

 private:
  struct Direction {
    std::once_flag once;
    std::optional<PreparedRegion> region;
  };
  /// What is made when it is asked for.
  struct Prepared {
    std::once_flag once;
    Region covered;
    std::array<Direction, 4> directions;
  };
  [[nodiscard]] int quarters(std::size_t direction) const;
  [[nodiscard]] bool read_small_part();
  /// What the part covers, its reference point at the origin.
  [[nodiscard]] Region covered() const;

  const Geometry* given_;
  std::size_t index_;
  const Options* options_;
  std::vector<SmallOperand> small_;
  std::size_t directions_;
  std::unique_ptr<Prepared> prepared_;
};

}  // namespace minksum
