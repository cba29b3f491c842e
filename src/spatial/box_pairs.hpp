// Finds pairs of boxes that overlap, by a sweep from left to right in vector code.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

#include "machine/team.hpp"

namespace minksum {

/// Memory for BoxPairs, kept from call to call.
struct BoxPairScratch {
  /// A box, rounded outwards to 15 bits.
  struct Box {
    std::int16_t left;
    std::int16_t bottom;
    std::int16_t right;
    std::int16_t top;
  };
  std::vector<Box> boxes;
  std::vector<std::uint32_t> column_end;  ///< by column of left sides: the end of its boxes in
                                          ///< `order`
  std::vector<std::uint32_t> order;       ///< boxes, column by column
  std::vector<Box> in_order;
  std::vector<std::int16_t> bottoms;  ///< bottoms and tops of `in_order`, each in its own list
  std::vector<std::int16_t> tops;
};

/// Takes boxes in [0, width] × [0, height], rounds each outwards, and finds all pairs that overlap.
///
/// The boxes are put into up to 4,096 columns by their left sides. A box is compared with those
/// that stand after it, up to the column of its right side: their heights first, eight at a time.
/// The time is O(n + p) for p pairs that share columns. For boxes that are small beside the whole,
/// that is far less than what any search structure costs.
class BoxPairs {
 public:
  /// The coordinates of boxes may be off by up to `doubt`.
  BoxPairs(double width, double height, double doubt, BoxPairScratch& scratch)
      : scale_x_(kUnits / std::max(width, least_extent(width, height, doubt))),
        scale_y_(kUnits / std::max(height, least_extent(width, height, doubt))),
        scratch_(scratch) {
    scratch.boxes.clear();
  }

  /// Adds a box. Boxes are numbered from 0 in the order in which they are added.
  void add(double x0, double y0, double x1, double y1) {
    scratch_.boxes.push_back({units(x0 * scale_x_ - 0.5), units(y0 * scale_y_ - 0.5),
                              units(x1 * scale_x_ + 1.5), units(y1 * scale_y_ + 1.5)});
  }

  /// The most pairs for each box that may be visited.
  struct Most {
    double in_x = HUGE_VAL;      ///< pairs that overlap in x
    double overlaps = HUGE_VAL;  ///< pairs that overlap, as far as a sample tells
  };

  /// Prepares visits, once all boxes are added. Returns false if there are too many pairs. Then
  /// none may be visited.
  [[nodiscard]] bool sort(Cancellation& cancellation, const Most& most) {
    if (are_few()) return true;
    sort_by_columns();
    pairs_in_columns_ = count_in_columns();
    cancellation.check(4 * scratch_.boxes.size());
    return !are_too_many(most);
  }
  /// Returns about how many units of work all visits take (see Cancellation).
  [[nodiscard]] std::size_t units_of_visits() const {
    return scratch_.boxes.size() + pairs_in_columns_ / 2;
  }
  /// Calls visit(a, b) once for each pair of boxes that overlap, and for some that nearly do. With
  /// `neighbours_touch`, a pair of boxes that were added one right after the other may be left out.
  /// Of so many tasks, which may run at the same time, this one visits only its own pairs.
  template <class Visit>
  void for_each(Visit visit, Cancellation& cancellation, bool neighbours_touch,
                std::size_t task = 0, std::size_t tasks = 1) const {
    if (are_few()) {
      if (task == 0) for_each_of_few(visit, neighbours_touch ? 2 : 1);
      return;
    }
    const auto visit_pairs_of = [&](std::size_t i) {
      const BoxPairScratch::Box box = scratch_.in_order[i];
      const std::size_t end = scratch_.column_end[column(box.right)];
      std::size_t j = i + 1;
      for (; j < end; j += kLanes) {
        const Lanes apart =
            (lanes(&scratch_.bottoms[j]) > box.top) | (lanes(&scratch_.tops[j]) < box.bottom);
        for_each_clear(apart, [&](std::size_t lane) {
          const std::size_t k = j + lane;
          const BoxPairScratch::Box& other = scratch_.in_order[k];
          if (k < end && other.left <= box.right && box.left <= other.right) {
            visit(scratch_.order[i], scratch_.order[k]);
          }
        });
      }
      return j - i;
    };
    const std::size_t last = begin_of(task + 1, tasks, scratch_.boxes.size());
    for (std::size_t i = begin_of(task, tasks, scratch_.boxes.size()); i < last;) {
      const std::size_t end = std::min(i + kCountedAtOnce, last);
      std::size_t passed = 0;
      for (; i < end; ++i) passed += visit_pairs_of(i);
      // Some of the boxes that are passed overlap, and visiting them takes longer.
      cancellation.check(kCountedAtOnce + passed / 2);
    }
  }

 private:
  static constexpr double kUnits = 0x1p15 - 4;
  static constexpr std::size_t kLanes = 8;
  static constexpr std::size_t kCountedAtOnce = 16;  ///< boxes between two looks at the token
  static constexpr std::size_t kFew = 48;  ///< up to this count, comparing all costs less than
                                           ///< sorting
  /// Lanes are compared one by one, and -1 means true. The compilers that know 128-bit integers
  /// know these types, too.
  using Lanes [[gnu::vector_size(2 * kLanes)]] = std::int16_t;
  using Halves [[gnu::vector_size(2 * kLanes)]] = std::uint64_t;

  /// Returns an extent at which `doubt`, and the rounding of products, is far below half a unit.
  static double least_extent(double width, double height, double doubt) {
    return std::max({width * 0x1p-24, height * 0x1p-24, doubt * 0x1p18, 0x1p-900});
  }
  [[nodiscard]] bool are_few() const { return scratch_.boxes.size() <= kFew; }
  static std::int16_t units(double value) {
    return static_cast<std::int16_t>(
        std::clamp(static_cast<std::int32_t>(value), 0, static_cast<std::int32_t>(kUnits) + 2));
  }
  template <class Visit>
  void for_each_of_few(Visit visit, std::size_t first_step) const {
    const auto& boxes = scratch_.boxes;
    const std::size_t count = boxes.size();
    std::array<std::array<std::int16_t, kFew + kLanes>, 4> sides;
    auto& [lefts, bottoms, rights, tops] = sides;
    for (std::size_t i = 0; i < count; ++i) {
      lefts[i] = boxes[i].left;
      bottoms[i] = boxes[i].bottom;
      rights[i] = boxes[i].right;
      tops[i] = boxes[i].top;
    }
    for (std::size_t i = count; i < count + kLanes; ++i) {
      lefts[i] = std::numeric_limits<std::int16_t>::max();  // overlaps no box
      bottoms[i] = rights[i] = tops[i] = 0;
    }
    for (std::size_t i = 0; i < count; ++i) {
      const BoxPairScratch::Box box = boxes[i];
      for (std::size_t j = i + first_step; j < count; j += kLanes) {
        const Lanes apart = (lanes(&bottoms[j]) > box.top) | (lanes(&tops[j]) < box.bottom) |
                            (lanes(&lefts[j]) > box.right) | (lanes(&rights[j]) < box.left);
        for_each_clear(apart, [&](std::size_t k) {
          visit(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j + k));
        });
      }
    }
  }
  static Lanes lanes(const std::int16_t* from) {
    Lanes lanes;
    std::memcpy(&lanes, from, sizeof lanes);
    return lanes;
  }
  template <class Visit>
  static void for_each_clear(Lanes lanes, Visit visit) {
    static_assert(std::endian::native == std::endian::little, "lanes begin at a word's low end");
    const auto halves = std::bit_cast<Halves>(lanes);
    const std::array<std::uint64_t, 2> words{halves[0], halves[1]};
    if ((words[0] & words[1]) == ~std::uint64_t{0}) return;
    for (const std::size_t half : {std::size_t{0}, std::size_t{1}}) {
      constexpr std::uint64_t kOnes = 0x0001000100010001;
      for (std::uint64_t bits = ~words[half] & kOnes; bits != 0; bits &= bits - 1) {
        visit(half * (kLanes / 2) + static_cast<std::size_t>(std::countr_zero(bits)) / 16);
      }
    }
  }
  [[nodiscard]] std::size_t column(std::int16_t x) const {
    return static_cast<std::size_t>(x) >> shift_;
  }

  /// Counts the pairs of boxes that share a column.
  [[nodiscard]] std::size_t count_in_columns() const {
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < scratch_.in_order.size(); ++i) {
      pairs += scratch_.column_end[column(scratch_.in_order[i].right)] - i - 1;
    }
    return pairs;
  }

  [[nodiscard]] bool are_too_many(const Most& most) const {
    const double in_x =
        static_cast<double>(pairs_in_columns_) / static_cast<double>(scratch_.boxes.size());
    return in_x > most.in_x || (in_x > most.overlaps && estimate_overlaps() > most.overlaps);
  }
  /// Estimates from a sample with how many boxes after it a box overlaps, on average.
  [[nodiscard]] double estimate_overlaps() const {
    constexpr std::size_t kFewest = 32;  // a sample of 64 took up to 7 % of small sums
    const std::size_t count = scratch_.in_order.size();
    // Where some boxes overlap far more others than most do, few of many boxes do not tell.
    const std::size_t sampled = std::max(kFewest, count / 128);
    std::size_t overlaps = 0;
    for (std::size_t s = 0; s < sampled; ++s) {
      const std::size_t i = s * count / sampled;
      const BoxPairScratch::Box& box = scratch_.in_order[i];
      const std::size_t end = scratch_.column_end[column(box.right)];
      for (std::size_t k = i + 1; k < end; ++k) {
        const BoxPairScratch::Box& other = scratch_.in_order[k];
        overlaps += static_cast<std::size_t>((other.left <= box.right) & (box.left <= other.right) &
                                             (other.bottom <= box.top) & (box.bottom <= other.top));
      }
    }
    return static_cast<double>(overlaps) / static_cast<double>(sampled);
  }

  void sort_by_columns() {
    const auto& boxes = scratch_.boxes;
    const std::size_t count = boxes.size();
    const std::size_t columns = std::clamp<std::size_t>(std::bit_ceil(count), 16, 4096);
    shift_ = 15 - std::countr_zero(columns);
    auto& end = scratch_.column_end;
    end.assign(columns, 0);
    for (const auto& box : boxes) ++end[column(box.left)];
    std::uint32_t begin = 0;
    for (std::uint32_t& entry : end) begin += std::exchange(entry, begin);
    scratch_.order.resize(count);
    scratch_.in_order.resize(count);
    scratch_.bottoms.resize(count + kLanes);
    scratch_.tops.resize(count + kLanes);
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t place = end[column(boxes[i].left)]++;
      scratch_.order[place] = static_cast<std::uint32_t>(i);
      scratch_.in_order[place] = boxes[i];
      scratch_.bottoms[place] = boxes[i].bottom;
      scratch_.tops[place] = boxes[i].top;
    }
    // Lanes past the last box are read but not used.
  }

  double scale_x_;
  double scale_y_;
  BoxPairScratch& scratch_;
  int shift_ = 0;
  std::size_t pairs_in_columns_ = 0;
};

}  // namespace minksum
