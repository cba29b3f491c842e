// Declares the kernel, which answers every question of the pipeline about the operands' geometry.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "exact/big_integer.hpp"
#include "exact/formulas.hpp"
#include "exact/fraction.hpp"
#include "exact/sign.hpp"
#include "exact/sum_geometry.hpp"
#include "exact/wide_int.hpp"
#include "machine/cancellation.hpp"
#include "minksum/minkowski_sum.hpp"

namespace minksum {

/// A coordinate of a node, which is numerator / denominator · 2^exp2 · 10^exp10, in little-endian
/// limbs.
struct ExactCoordinate {
  bool negative = false;
  std::vector<std::uint64_t> numerator;    ///< magnitude, without leading zero limbs
  std::vector<std::uint64_t> denominator;  ///< magnitude, without leading zero limbs
};

/// Holds the exact coordinates of both operands' sites and decides by them.
///
/// Each formula is implemented once (kernel_of.hpp). Each rung of the ladder has one instance: 30,
/// 61 and 125 bits of coordinate in fixed-width integers, and rationals of any size. `Predicates`
/// asks the kernel where the floating-point filter cannot tell.
///
/// Orientation is antisymmetric in direction and cyclic in its three points. Comparisons are total
/// orders. Tests hold these laws on every permutation.
class ExactKernel {
 public:
  virtual ~ExactKernel() = default;
  [[nodiscard]] virtual Arithmetic rung() const = 0;
  /// Returns the units of work (see Cancellation) of a decision.
  [[nodiscard]] virtual std::uint64_t work() const = 0;

  // -- One operand's sites ------------------------------------------------------------------
  /// Returns kPositive if c lies to the left of the line from a to b. All three belong to one
  /// operand.
  [[nodiscard]] virtual Sign orientation(SiteId a, SiteId b, SiteId c) const = 0;
  /// Returns the sign of (b − a) · (d − c). Each difference is within one operand.
  [[nodiscard]] virtual Sign dot(SiteId a, SiteId b, SiteId c, SiteId d) const = 0;
  /// Returns the sign of a − b along an axis.
  [[nodiscard]] virtual Sign compare(SiteId a, SiteId b, Axis axis) const = 0;

  // -- Edges (once connected) ---------------------------------------------------------------
  [[nodiscard]] virtual Sign cross(SiteId edge, SiteId other_edge) const = 0;
  [[nodiscard]] virtual Sign dot(SiteId edge, SiteId other_edge) const = 0;

  // -- Sum vertices and segments ------------------------------------------------------------
  /// Returns kPositive if v lies to the left of s.
  [[nodiscard]] virtual Sign orientation(const Segment& s, const SumVertex& v) const = 0;
  [[nodiscard]] virtual Sign compare(const SumVertex& a, const SumVertex& b, Axis axis) const = 0;
  /// Returns the vector from a to b. Each component is rounded once, in the unit of
  /// `approximate_sites`.
  [[nodiscard]] virtual Vec<double> between(const SumVertex& a, const SumVertex& b) const = 0;
  /// Returns the order of two points along s.
  [[nodiscard]] virtual Sign compare_along(const Segment& s, const PointOnSegment& a,
                                           const PointOnSegment& b) const = 0;
  /// Returns the point's position along s, from 0 at the start to 1 at the end. The relative error
  /// is at most 2^-48.
  [[nodiscard]] virtual double parameter(const Segment& s, const PointOnSegment& point) const = 0;

  // -- Nodes of the arrangement -------------------------------------------------------------
  [[nodiscard]] virtual Sign compare(const NodePoint& a, const NodePoint& b, Axis axis) const = 0;
  [[nodiscard]] virtual Sign orientation(const Segment& s, const NodePoint& node) const = 0;

  // -- Probes: the point on the segment itself; `Predicates` breaks ties symbolically ---------
  /// Returns kPositive if the probe lies to the left of the line through v in the direction of
  /// `edge`.
  [[nodiscard]] virtual Sign probe_orientation(SiteId edge, const SumVertex& v,
                                               const Probe& probe) const = 0;
  /// Returns the sign of probe − v along an axis.
  [[nodiscard]] virtual Sign probe_compare(const Probe& probe, const SumVertex& v,
                                           Axis axis) const = 0;

  /// Returns the exact position of a node along a segment that contains the node.
  [[nodiscard]] virtual Fraction exact_parameter(const Segment& s, const NodePoint& node) const = 0;

  // -- Coordinates --------------------------------------------------------------------------
  /// Sets `out` to the exact coordinates of a node, in the operands' own units.
  virtual void coordinates(const NodePoint& node, Vec<ExactCoordinate>& out) const = 0;
  /// Sets `out` to the exact coordinates of a sum vertex, in the same units, if they are integers
  /// of 63 bits. Returns false otherwise.
  virtual bool integer_coordinates(const SumVertex& v, Vec<std::int64_t>& out) const = 0;
  /// The exponents of all coordinates (see ExactCoordinate).
  [[nodiscard]] virtual int exp2() const = 0;
  [[nodiscard]] virtual int exp10() const = 0;
  /// Sets x and y to the doubles nearest to all sites. The sites are moved and, on the arbitrary
  /// rung, scaled.
  virtual void approximate_sites(std::span<double> x, std::span<double> y,
                                 Cancellation& cancellation) const = 0;
  /// Does the same for all edge vectors; the sites must be connected. No component that is not 0
  /// becomes 0.
  virtual void approximate_edges(std::span<double> dx, std::span<double> dy,
                                 Cancellation& cancellation) const = 0;

  /// Sets the edges: the edge that starts at site i ends at site next[i].
  virtual void connect(std::span<const SiteId> next) = 0;
};

/// One step of an integer grid: 2^exp2 · 10^exp10 / divisor of a region's units. A turn by a
/// rational rotation makes coordinates with a common denominator, and these are integers on such a
/// grid.
struct GridUnit {
  static constexpr int kDivisorBits = 62;
  int exp2 = 0;
  int exp10 = 0;
  std::int64_t divisor = 1;  ///< positive, of up to kDivisorBits bits
  friend bool operator==(const GridUnit&, const GridUnit&) = default;
};

/// Coordinates on an integer grid. A value is (integer + offset) · unit; the integers are in [0,
/// 2^bits).
struct GridCoordinates {
  static constexpr int kSmallBits = 62;
  bool small = true;                           ///< whether `small_sites` holds the sites
  std::vector<Vec<std::int64_t>> small_sites;  ///< up to kSmallBits bits
  std::vector<Vec<Int128>> large_sites;
  Vec<Int128> extent{};  ///< the largest integer along each axis
  Vec<Int128> offset{};
  GridUnit unit;
  int bits = 0;
};

/// Any rational coordinates, in the operand's own units.
struct RationalCoordinates {
  std::vector<Vec<Fraction>> sites;  ///< in lowest terms
  Vec<Fraction> low{};               ///< the box's lower left corner
  Vec<Fraction> extent{};
  std::size_t bits = 0;  ///< of the longest numerator or denominator
};

/// Some of an operand's sites, in their order, to be multiplied by a factor.
struct GridPart {
  const GridCoordinates* grid;
  Int128 factor;
  std::span<const SiteId> sites;
};

/// Makes a kernel for the integer coordinates of the parts, one part after the other. The
/// coordinates must fit the rung (kNarrow, kMedium or kWide), and the sum of the scaled offsets
/// must fit 127 bits. `unit` is that of the common grid. `old` is used again if it has the same
/// rung.
void make_grid_kernel(Arithmetic rung, std::span<const GridPart> parts, const GridUnit& unit,
                      std::unique_ptr<ExactKernel>& old);
/// Makes a kernel for any rational coordinates in a unit, none longer than `bits`. The other
/// arguments say how coordinates are approximated: as (coordinate − origin of its operand) ·
/// 2^exponent. Sites below `split` belong to the first operand.
void make_rational_kernel(std::vector<Vec<Fraction>> sites, SiteId split,
                          const std::array<Vec<Fraction>, 2>& origins, const GridUnit& unit,
                          std::size_t bits, int exponent, Cancellation& cancellation,
                          std::unique_ptr<ExactKernel>& old);

}  // namespace minksum
