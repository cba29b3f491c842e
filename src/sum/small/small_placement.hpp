// Tells whether a small sum lies on the right of a segment of its convolution, too.
#pragma once

#include <array>
#include <optional>

#include "sum/small/small_rings.hpp"
#include "sum/small/small_segments.hpp"

namespace minksum {

/// Tests points just on the right of a segment. Let x be one. It is in P ⊕ Q if and only if P and
/// x − Q have a point in common.
class SmallPlacement {
 public:
  enum class Result : std::uint8_t { kInside, kOutside, kUnknown };

  struct Memory {
    SmallOperand turned;  ///< Q turned by half a circle
    std::array<SmallBlocks, 2> blocks;
    std::vector<BoxOf<double>> boxes;  ///< of the rings, if an operand has several polygons
  };
  /// Without `with_holes`, an operand's holes are filled.
  SmallPlacement(double width, const SmallOperand& p, const SmallOperand& q,
                 const std::array<bool, 2>& with_holes, Memory& memory)
      : numbers_{reach_of(width)},
        p_(p),
        q_(q),
        with_holes_(with_holes),
        turned_(memory.turned),
        blocks_(memory.blocks),
        boxes_(memory.boxes) {}
  SmallPlacement(const SmallPlacement&) = delete;
  SmallPlacement& operator=(const SmallPlacement&) = delete;

  /// Tests a point between two places on the way of a segment. They are rounded fractions of the
  /// way. Returns kUnknown if they are too close to tell, or if tests have taken too long.
  [[nodiscard]] Result test(const SmallSegments& s, std::uint32_t segment, double from, double to);

 private:
  /// The point, in integers that hold coordinates.
  template <class Integer>
  struct Exact {
    static constexpr std::size_t kLimbs = sizeof(Integer) / sizeof(std::uint64_t);
    using Scaled = WideInt<kLimbs + 1>;  ///< holds a coordinate in steps of 2^-halvings
    using Side = WideInt<2 * kLimbs + 1>;
    Vec<Integer> way;   ///< of the segment
    Vec<Scaled> place;  ///< where the turned Q lies, in such steps
  };
  /// Turns Q, and sets how long tests of a sum of so many segments may take.
  void turn_q(std::size_t segments);
  /// Sets where the turned Q lies.
  template <class Integer>
  void take(const SmallSegments& s, std::uint32_t segment, std::int64_t steps,
            Exact<Integer>& exact);
  /// Tells whether the boundaries of P and x − Q cross. Where they do not, neither of two polygons
  /// holds the other: without the step to the right they touch, from different sides.
  [[nodiscard]] Result test_boundaries();
  /// Tells whether the only polygon of one operand holds one of the other's, or lies inside of one.
  /// Boundaries do not cross.
  [[nodiscard]] Result test_others();
  /// Tells whether an operand's ring, moved by a vector, lies inside of others by the winding
  /// number of a vertex. add_winding(point, winding) computes that, or returns false if it is not
  /// sure.
  template <class AddWinding>
  [[nodiscard]] Result place_ring(const SmallOperand& operand, std::size_t ring,
                                  const Vec<double>& by, const AddWinding& add_winding);
  /// Adds how often rings, a range of edges, go round a point. Returns false if that is not sure.
  [[nodiscard]] bool add_winding(const SmallEdges& edges, std::uint32_t begin, std::uint32_t end,
                                 const Vec<double>& point, int& winding);
  /// Whether two edges cross if that of x − Q makes an infinitely small step to the right of the
  /// way, and a smaller one along it. Then no end is on the other's line.
  [[nodiscard]] bool do_cross(std::uint32_t of_p, std::uint32_t of_q) const;
  template <class Integer>
  [[nodiscard]] bool do_cross_exactly(std::uint32_t of_p, std::uint32_t of_q,
                                      const Exact<Integer>& exact) const;
  /// Returns the cross product of two vectors, or zero if its sign is not sure. The place of x is
  /// added to the second.
  [[nodiscard]] double side_of(const Vec<double>& edge, const Vec<double>& point) const;
  /// Tells for sure whether a point is on the left of an edge, and makes the step if it is on the
  /// line.
  template <class Integer>
  [[nodiscard]] bool is_left_exactly(const Exact<Integer>& exact, const Vec<Integer>& edge,
                                     const Vec<Integer>& point) const;
  template <class Scaled, class Integer>
  [[nodiscard]] Scaled scaled(const Integer& value) const {
    return product<Scaled>(value, std::int64_t{1} << halvings_);
  }

  SmallNumbers<WideNumber> numbers_;
  const SmallOperand& p_;
  const SmallOperand& q_;
  std::array<bool, 2> with_holes_;
  SmallOperand& turned_;
  std::array<SmallBlocks, 2>& blocks_;
  std::vector<BoxOf<double>>& boxes_;
  std::optional<SmallEdges> edges_of_p_;
  std::optional<SmallEdges> edges_of_q_;
  std::size_t pairs_left_ = 0;  ///< of blocks, for all tests
  int halvings_ = 0;
  Vec<double> at_{};  ///< where the turned Q lies
  // The same exactly. Only one of the two is in use.
  Exact<Int128> short_{};
  Exact<WideNumber> long_{};
};

}  // namespace minksum
