#include "sum/small/small_operand.hpp"

#include <algorithm>
#include <limits>
#include <type_traits>

#include "region/region_access.hpp"
#include "sum/small/load_rings.hpp"

namespace minksum {
namespace {

/// Sets the exponents to the smallest in use. Returns false if all coordinates are zero.
bool find_grid(const Region& region, SmallOperand& s) {
  constexpr int kNone = std::numeric_limits<int>::max();
  int exp2 = kNone;
  int exp10 = kNone;
  const auto add = [&](const StoredCoordinate& c) {
    const bool is_zero = (c.payload == 0) & (c.denominator_limbs == 0);
    exp2 = std::min<int>(exp2, is_zero ? kNone : c.exp2);
    exp10 = std::min<int>(exp10, is_zero ? kNone : c.exp10);
  };
  const std::size_t count = region.vertex_count();
  for (std::size_t v = 0; v < count; ++v) {
    add(RegionAccess::x(region, v));
    add(RegionAccess::y(region, v));
  }
  s.exp2 = exp2;
  s.exp10 = exp10;
  s.steps = 1;
  s.units = 1;
  return exp2 != kNone;
}

}  // namespace

template <class Integer>
Vec<Integer> SmallOperand::exact(int row, std::size_t i) const {
  if (is_long()) return as<Integer>(long_exact(row, i));
  Vec<Int128> value{};
  if (row == kX) {
    value = whole_at(i);
  } else if (is_wide()) {
    const auto [from, to] = ends_of(row == kInX, static_cast<std::uint32_t>(i));
    value = minus(whole_[to], whole_[from]);
  } else {
    value =
        whole_vector({(*this)[static_cast<Row>(row)][i], (*this)[static_cast<Row>(row + 1)][i]});
  }
  if (steps == 1) return {Integer(value.x), Integer(value.y)};
  return {product<Integer>(value.x, steps), product<Integer>(value.y, steps)};
}
template Vec<Int128> SmallOperand::exact(int, std::size_t) const;
template Vec<WideNumber> SmallOperand::exact(int, std::size_t) const;

SmallOperand::Ends SmallOperand::ends_of(bool before, std::uint32_t i) const {
  const std::size_t ring = ring_of(i);
  if (ring == ends.size()) return {i, i};
  const std::uint32_t begin = begin_of(ring);
  const std::uint32_t end = ends[ring];
  if (i < begin) return {i, i};
  if (before) return {(i == begin ? end : i) - 1, i};
  return {i, i + 1 == end ? begin : i + 1};
}

bool SmallOperand::has_ring_of(const SmallOperand& other) const {
  if (size != other.size || outer_rings != 1 || other.outer_rings != 1) return false;
  for (std::size_t i = 0; i < size; ++i) {
    if (exact<WideNumber>(kX, i) != other.exact<WideNumber>(kX, i)) return false;
  }
  return true;
}

void find_smallest(SmallOperand& s) { s.smallest = smallest_of(s, 0, s.size, 0); }

void find_rings(const SmallOperand& s, std::vector<std::uint32_t>& ring_of,
                std::vector<std::uint32_t>& smallest) {
  ring_of.clear();
  smallest.clear();
  const double* const x = s[SmallOperand::kX];
  for (std::uint32_t ring = 0; ring < s.ends.size(); ++ring) {
    const std::uint32_t begin = s.begin_of(ring);
    const std::uint32_t end = s.ends[ring];
    ring_of.resize(filled_up(end), ring);
    if (ring >= s.outer_rings) continue;
    const double left = *std::min_element(x + begin, x + end);
    smallest.push_back(smallest_of(s, begin, end, left));
  }
}

bool has_small_size(const Region& region) {
  const bool has_several = region.polygon_count() > 1;
  const std::size_t most_rings =
      has_several ? SmallOperand::kMaxRings : 1 + SmallOperand::kMaxHoles;
  return (!has_several || SmallOperand::kMayHaveSeveral) && region.ring_count() <= most_rings &&
         region.vertex_count() <= SmallOperand::kMaxVertices;
}

bool load_small(const Region& region, SmallOperand& s) {
  if (!has_small_size(region) || !find_grid(region, s)) return false;
  const bool has_limbs = !RegionAccess::limbs(region).empty();
  return (!has_limbs && load_rings<std::int64_t>(region, s)) || load_rings<Int128>(region, s) ||
         (SmallOperand::kMayBeLong && load_long(region, s));
}

}  // namespace minksum
