#include "operations/no_fit/table_part.hpp"

#include <utility>

#include "minksum/transform.hpp"
#include "overlay/resolve_area.hpp"
#include "validation/fault.hpp"

namespace minksum {
TablePart::TablePart(const Geometry& given, std::size_t index, int turns, const Options& options)
    : given_(&given),
      index_(index),
      options_(&options),
      directions_(turns == 1 ? 2 : static_cast<std::size_t>(turns)),
      prepared_(std::make_unique<Prepared>()) {
  if (!read_small_part()) static_cast<void>(prepared(0));
}

int TablePart::quarters(std::size_t direction) const {
  return static_cast<int>(direction * 4 / directions_);
}

bool TablePart::read_small_part() {
  SmallOperand read;
  if (!is_by_role(options_->fill) || !read_small(given_->region, read)) return false;
  if (read.is_long()) return false;  // these tables keep offsets in Int128
  read.offset = {read.offset.x - read.first.x, read.offset.y - read.first.y};
  small_.resize(directions_);
  for (std::size_t i = 0; i < directions_; ++i) turn(read, quarters(i), small_[i]);
  return true;
}

Region TablePart::covered() const {
  // Resolving takes as long as some sums, so valid regions skip it.
  const bool valid = !small_.empty() || is_plain(Geometry(given_->region), *options_);
  const int index = static_cast<int>(index_);
  const Region area = valid ? given_->region : resolve_area(*given_, index, *options_).region;
  if (area.empty() || given_->region.empty()) {
    refuse_operand("a part without area cannot be paired", index);
  }
  const Point reference = given_->region.point(0);
  return transform(area, Affine::translation(-reference.x, -reference.y), *options_);
}

const PreparedRegion& TablePart::prepared(std::size_t direction) const {
  std::call_once(prepared_->once, [&] {
    const Region area = covered();
    for (std::size_t i = 0; i < directions_; ++i) {
      prepared_->directions.emplace_back(
          transform(area, Affine::quarter_turns(quarters(i)), *options_), *options_);
    }
  });
  return prepared_->directions[direction];
}

}  // namespace minksum
