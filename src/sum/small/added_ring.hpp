// The entries of one ring of a small operand, which follow from the places of its vertices.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <type_traits>
#include <utility>

#include "sum/small/small_grid.hpp"
#include "sum/small/small_operand.hpp"

namespace minksum {

/// Returns in which eighth of the circle a vector lies, counter-clockwise. Of the eighths' borders,
/// those of the axes and diagonals, each belongs to one of them.
[[nodiscard]] inline int eighth_of(const Vec<double>& d) {
  static constexpr std::array<int, 8> kEighths{0, 1, 7, 6, 3, 2, 4, 5};
  const std::uint64_t left = std::bit_cast<std::uint64_t>(d.x) >> 63U << 2U;
  const std::uint64_t down = std::bit_cast<std::uint64_t>(d.y) >> 63U << 1U;
  const std::uint64_t steep = std::abs(d.y) >= std::abs(d.x) ? 1 : 0;
  return kEighths[left | down | steep];
}

/// Returns all ones if a cross product is positive, and zero otherwise.
[[nodiscard]] inline std::uint64_t turns_left(double cross) {
  return static_cast<std::uint64_t>(std::bit_cast<std::int64_t>(0.0 - cross) >> 63U);
}

/// Returns the lexicographically smallest of the entries from `begin` to before `end`, of which
/// `left` is the smallest x.
[[nodiscard]] inline std::uint32_t smallest_of(const SmallOperand& s, std::uint32_t begin,
                                               std::uint32_t end, double left) {
  const double* const x = s[SmallOperand::kX];
  const double* const y = s[SmallOperand::kY];
  std::uint32_t smallest = end;
  for (std::uint32_t i = begin; i < end; ++i) {
    // Rounding keeps the order of numbers that it does not make equal.
    if (x[i] != left) continue;
    const auto is_less = [&](std::uint32_t j) {
      if (!s.is_wide()) return y[i] < y[j];
      const auto is_before = [](const auto& a, const auto& b) {
        return a.x != b.x ? a.x < b.x : a.y < b.y;
      };
      if (s.is_long()) return is_before(s.whole<WideNumber>()[i], s.whole<WideNumber>()[j]);
      return is_before(s.whole()[i], s.whole()[j]);
    };
    if (smallest == end || is_less(smallest)) smallest = i;
  }
  return smallest;
}

/// A ring that is added to an operand. The caller sets its vertices' places and indices. `Number`
/// holds coordinates: double, or the integers of a wide operand.
template <class Number>
class AddedRing {
  static constexpr bool kWide = !std::is_same_v<Number, double>;
  using Integer = std::conditional_t<kWide, Number, Int128>;

 public:
  explicit AddedRing(SmallOperand& s)
      : s_(s), begin_(static_cast<std::uint32_t>(filled_up(s.entries))) {}

  [[nodiscard]] double* row(SmallOperand::Row at) const { return s_[at] + begin_; }
  /// The exact places. There are none if the operand is not wide.
  [[nodiscard]] Vec<Integer>* whole() const {
    return kWide ? s_.whole<Integer>().data() + begin_ : nullptr;
  }
  /// Adds the ring of `size` vertices. `left` is the smallest x of these. Turns it so that the
  /// region is on its left, and drops vertices in the middle of straight edges. Returns false if it
  /// has a spike or less than three vertices.
  [[nodiscard]] bool finish(bool is_outer, std::uint32_t size, double left) {
    size_ = size;
    if (size < 3 || !orient(is_outer, left)) return false;
    Bends bends = set_bends();
    if (!bends.turn_all) {
      if (!drop_straight()) return false;
      bends = set_bends();
    }
    set_edge_sources();
    fill_up();
    s_.entries = begin_ + size_;
    s_.ends.push_back(s_.entries);
    s_.longest = std::max(s_.longest, bends.longest);
    if (is_outer) {
      s_.size = s_.entries;
      s_.smallest = begin_ + smallest_;
      s_.convex = bends.convex && s_.outer_rings == 0;
      s_.turning += bends.turning;
      ++s_.outer_rings;
    } else {
      s_.turning_of_holes += bends.turning;
    }
    return true;
  }

 private:
  using Vector = std::conditional_t<kWide, SureVec<Integer>, Vec<double>>;

  /// Returns the way between two of the ring's vertices.
  [[nodiscard]] Vector way(std::uint32_t from, std::uint32_t to) const {
    if constexpr (kWide) {
      const Vec<Integer> way = minus(whole()[to], whole()[from]);
      return {rounded(way), way};
    } else {
      const double* const x = row(SmallOperand::kX);
      const double* const y = row(SmallOperand::kY);
      return {x[to] - x[from], y[to] - y[from]};
    }
  }
  [[nodiscard]] Vec<double> near_way(std::uint32_t from, std::uint32_t to) const {
    return near_of(way(from, to));
  }
  [[nodiscard]] std::uint32_t before(std::uint32_t i) const { return (i == 0 ? size_ : i) - 1; }
  [[nodiscard]] std::uint32_t after(std::uint32_t i) const { return i + 1 == size_ ? 0 : i + 1; }
  /// Positive if the ring turns left from one edge to the next one.
  [[nodiscard, gnu::always_inline]] double turn(const Vector& in, const Vector& out) const {
    if constexpr (kWide) {
      return SureLanes<Integer>{{reach_of(std::max(s_.extent.x, s_.extent.y))}}.turn(in, out);
    } else {
      const double turn = cross(in, out);  // its sign is exact, unless it is zero
      using Lanes = SureLanes<std::uint64_t>;
      return turn == 0 ? Lanes{}.turn(Lanes::of_whole(in), Lanes::of_whole(out)) : turn;
    }
  }

  /// The same at a vertex, by its rounded edges. The exact ones are computed where these do not
  /// tell.
  [[nodiscard, gnu::always_inline]] double turn_at(std::uint32_t i, const Vec<double>& in,
                                                   const Vec<double>& out) const {
    if constexpr (kWide) {
      bool unsure = false;
      const double near = BoundedLanes{unsure, 0}.turn(in, out);
      if (!unsure) return near;
      return turn(way(before(i), i), way(i, after(i)));
    } else {
      return turn(in, out);
    }
  }

  /// Turns the ring so that it runs counter-clockwise or clockwise. Returns false if the smallest
  /// vertex is the tip of a spike.
  [[nodiscard]] bool orient(bool counter_clockwise, double left) {
    smallest_ = smallest_of(s_, begin_, begin_ + size_, left) - begin_;
    const double turn_there =
        turn(way(before(smallest_), smallest_), way(smallest_, after(smallest_)));
    reversed_ = (turn_there > 0) != counter_clockwise;
    if (!reversed_) return turn_there != 0;
    const auto reverse = [this](auto* values) { std::reverse(values, values + size_); };
    reverse(row(SmallOperand::kX));
    reverse(row(SmallOperand::kY));
    reverse(row(SmallOperand::kVertexSource));
    if constexpr (kWide) reverse(whole());
    smallest_ = size_ - 1 - smallest_;
    return turn_there != 0;
  }
  void set_edge_sources() {
    const double* const source = row(SmallOperand::kVertexSource);
    // In a reversed ring, the edge that starts here is the one that started at the next vertex.
    std::rotate_copy(source, source + (reversed_ ? 1 : 0), source + size_,
                     row(SmallOperand::kEdgeSource));
  }

  struct Bends {
    bool turn_all;  ///< whether the ring turns at each vertex
    bool convex;
    double turning;
    double longest;
  };
  /// Sets the edges, which follow from the places.
  Bends set_bends() {
    double* const dx = row(SmallOperand::kDx);
    double* const dy = row(SmallOperand::kDy);
    double* const in_x = row(SmallOperand::kInX);
    double* const in_y = row(SmallOperand::kInY);
    double* const out_x = row(SmallOperand::kOutX);
    double* const out_y = row(SmallOperand::kOutY);
    bool turn_all = true;
    std::uint64_t all_convex = ~std::uint64_t{0};
    double longest = 0;
    int meetings = 0;
    Vec<double> in = near_way(size_ - 1, 0);
    int eighth = eighth_of(in);
    for (std::uint32_t i = 0; i < size_; ++i) {
      const Vec<double> out = near_way(i, after(i));
      const double turned = turn_at(i, in, out);
      // All ones or none keep the loop free of branches.
      const std::uint64_t convex = turns_left(turned);
      const auto if_convex = [convex](double value) {
        return std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) & convex);
      };
      const int last = std::exchange(eighth, eighth_of(out));
      meetings += static_cast<int>(static_cast<std::uint64_t>(eighth - last) & convex & 7U);
      turn_all &= turned != 0;
      all_convex &= convex;
      longest = std::max({longest, std::abs(out.x), std::abs(out.y)});
      dx[i] = out.x;
      dy[i] = out.y;
      in_x[i] = if_convex(in.x);
      in_y[i] = if_convex(in.y);
      out_x[i] = if_convex(out.x);
      out_y[i] = if_convex(out.y);
      in = out;
    }
    return {turn_all, all_convex != 0, meetings / 8.0, longest};
  }

  /// Drops vertices in the middle of straight edges. Returns false if a vertex is the tip of a
  /// spike.
  [[nodiscard]] bool drop_straight() {
    std::uint32_t kept = 0;
    Vector in = way(size_ - 1, 0);
    const Vector last = in;
    for (std::uint32_t i = 0; i < size_; ++i) {
      const Vector out = i + 1 == size_ ? last : way(i, i + 1);
      if (i == smallest_) smallest_ = kept;
      if (turn(in, out) != 0) {
        for (const auto at : {SmallOperand::kX, SmallOperand::kY, SmallOperand::kVertexSource}) {
          row(at)[kept] = row(at)[i];
        }
        if constexpr (kWide) whole()[kept] = whole()[i];
        ++kept;
      } else if (dot(near_of(in), near_of(out)) < 0) {
        return false;
      }
      in = out;
    }
    size_ = kept;
    return kept >= 3;
  }

  /// Fills the rows up, so that they can be read eight entries at a time.
  void fill_up() {
    double* const x = row(SmallOperand::kX);
    double* const y = row(SmallOperand::kY);
    const auto end = static_cast<std::uint32_t>(filled_up(size_));
    for (std::uint32_t i = size_; i < end; ++i) {
      x[i] = x[0];
      y[i] = y[0];
      for (const auto at : {SmallOperand::kDx, SmallOperand::kDy, SmallOperand::kInX,
                            SmallOperand::kInY, SmallOperand::kOutX, SmallOperand::kOutY}) {
        row(at)[i] = 0;
      }
      if constexpr (kWide) whole()[i] = whole()[0];
    }
  }

  SmallOperand& s_;
  std::uint32_t begin_;  ///< of the ring's entries
  std::uint32_t size_ = 0;
  std::uint32_t smallest_ = 0;
  bool reversed_ = false;
};

}  // namespace minksum
