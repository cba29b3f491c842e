// Exact answers to every question that the pipeline asks about its operands' geometry.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "exact/big_integer.hpp"
#include "exact/formulas.hpp"
#include "exact/sign.hpp"
#include "exact/sum_geometry.hpp"
#include "exact/wide_int.hpp"
#include "machine/cancellation.hpp"
#include "minksum/minkowski_sum.hpp"

namespace minksum {

/// A coordinate of a node: numerator / denominator · 2^exp2 · 10^exp10, as little-endian limbs.
struct ExactCoordinate {
  bool negative = false;
  std::vector<std::uint64_t> numerator;    ///< magnitude, without leading zero limbs
  std::vector<std::uint64_t> denominator;  ///< the same
};

/// Holds the exact coordinates of both operands' sites and decides by them.
///
/// There is one implementation of each formula (kernel_of.hpp) and one instance of it for each rung
/// of the ladder: 30, 61 and 125 bits of coordinate in fixed-width integers, and rationals of any
/// size. `Predicates` asks it where the floating-point filter cannot tell.
///
/// Laws: orientation is antisymmetric in direction and cyclic in its three points; comparisons are
/// total orders. Tests hold them on every permutation.
class ExactKernel {
 public:
  virtual ~ExactKernel() = default;
  [[nodiscard]] virtual Arithmetic rung() const = 0;
  /// The units of work (see Cancellation) of a decision.
  [[nodiscard]] virtual std::uint64_t work() const = 0;

  // -- One operand's sites ------------------------------------------------------------------
  /// Positive if c lies to the left of the line from a to b; the three are of one operand.
  [[nodiscard]] virtual Sign orientation(SiteId a, SiteId b, SiteId c) const = 0;
  /// Sign of (b − a) · (d − c); each difference within one operand.
  [[nodiscard]] virtual Sign dot(SiteId a, SiteId b, SiteId c, SiteId d) const = 0;
  /// Sign of a − b along an axis.
  [[nodiscard]] virtual Sign compare(SiteId a, SiteId b, Axis axis) const = 0;

  // -- Edges (once connected) ---------------------------------------------------------------
  [[nodiscard]] virtual Sign cross(SiteId edge, SiteId other_edge) const = 0;
  [[nodiscard]] virtual Sign dot(SiteId edge, SiteId other_edge) const = 0;

  // -- Sum vertices and segments ------------------------------------------------------------
  /// Positive if v lies to the left of s.
  [[nodiscard]] virtual Sign orientation(const Segment& s, const SumVertex& v) const = 0;
  [[nodiscard]] virtual Sign compare(const SumVertex& a, const SumVertex& b, Axis axis) const = 0;
  /// Order of two points along s.
  [[nodiscard]] virtual Sign compare_along(const Segment& s, const PointOnSegment& a,
                                           const PointOnSegment& b) const = 0;
  /// The point's position along s, 0 = start, 1 = end, within a relative error of 2^-48.
  [[nodiscard]] virtual double parameter(const Segment& s, const PointOnSegment& point) const = 0;

  // -- Nodes of the arrangement -------------------------------------------------------------
  [[nodiscard]] virtual Sign compare(const NodePoint& a, const NodePoint& b, Axis axis) const = 0;
  [[nodiscard]] virtual Sign orientation(const Segment& s, const NodePoint& node) const = 0;

  // -- Probes: the point on the segment itself; `Predicates` breaks ties symbolically ---------
  /// Positive if the probe lies to the left of the line through v in the direction of `edge`.
  [[nodiscard]] virtual Sign probe_orientation(SiteId edge, const SumVertex& v,
                                               const Probe& probe) const = 0;
  /// Sign of probe − v along an axis.
  [[nodiscard]] virtual Sign probe_compare(const Probe& probe, const SumVertex& v,
                                           Axis axis) const = 0;

  /// The exact position of a node along a segment that it lies on.
  [[nodiscard]] virtual BigRational exact_parameter(const Segment& s,
                                                    const NodePoint& node) const = 0;

  // -- Coordinates --------------------------------------------------------------------------
  /// The exact coordinates of a node, in the operands' own units.
  virtual void coordinates(const NodePoint& node, Vec<ExactCoordinate>& out) const = 0;
  /// The exact coordinates of a sum vertex, if they are integers of 63 bits (as above).
  virtual bool integer_coordinates(const SumVertex& v, Vec<std::int64_t>& out) const = 0;
  /// Exponents that go with them (see ExactCoordinate).
  [[nodiscard]] virtual int exp2() const = 0;
  [[nodiscard]] virtual int exp10() const = 0;
  /// The doubles nearest to all sites (moved and, on the arbitrary rung, scaled) and, once
  /// connected, to all edge vectors.
  virtual void approximate_sites(std::span<double> x, std::span<double> y,
                                 Cancellation& cancellation) const = 0;
  virtual void approximate_edges(std::span<double> dx, std::span<double> dy,
                                 Cancellation& cancellation) const = 0;

  /// The edge that starts at each site ends at the site `next` names.
  virtual void connect(std::span<const SiteId> next) = 0;
};

/// One step of an integer grid: 2^exp2 · 10^exp10 / divisor of a region's units. Coordinates with a
/// common denominator, as a turn by a rational rotation makes them, are integers on such a grid.
struct GridUnit {
  static constexpr int kDivisorBits = 62;
  int exp2 = 0;
  int exp10 = 0;
  std::int64_t divisor = 1;  ///< positive, of up to kDivisorBits bits
  friend bool operator==(const GridUnit&, const GridUnit&) = default;
};

/// Coordinates on an integer grid: value = (integer + offset) · unit, where the integers are in
/// [0, 2^bits).
struct GridCoordinates {
  static constexpr int kSmallBits = 62;
  bool small = true;                           ///< which of the two holds the sites
  std::vector<Vec<std::int64_t>> small_sites;  ///< up to kSmallBits bits
  std::vector<Vec<Int128>> large_sites;
  Vec<Int128> extent{};                        ///< the largest of the integers
  Vec<Int128> offset{};
  GridUnit unit;
  int bits = 0;
};

/// Any rational coordinates, in the operand's own units.
struct RationalCoordinates {
  std::vector<Vec<BigRational>> sites;
  Vec<BigRational> low{};                      ///< the box's lower left corner
  Vec<BigRational> extent{};
  std::size_t bits = 0;                        ///< of the longest numerator or denominator
};

/// Some of an operand's sites, in their order, times a factor.
struct GridPart {
  const GridCoordinates* grid;
  Int128 factor;
  std::span<const SiteId> sites;
};

/// A kernel for integer coordinates: those of the parts, one after the other. They must fit the
/// rung (kNarrow, kMedium or kWide), and the sum of their scaled offsets 127 bits. `unit` is that
/// of the common grid. Reuses `old` if it is of the same rung.
void make_grid_kernel(Arithmetic rung, std::span<const GridPart> parts, const GridUnit& unit,
                      std::unique_ptr<ExactKernel>& old);
/// A kernel for any rational coordinates, none longer than `bits`; `origin_first`, `origin_second`
/// and `exponent` say how they are approximated: (coordinate − origin of its operand) · 2^exponent.
void make_rational_kernel(std::vector<Vec<BigRational>> sites, SiteId split,
                          const Vec<BigRational>& origin_first,
                          const Vec<BigRational>& origin_second, std::size_t bits, int exponent,
                          std::unique_ptr<ExactKernel>& old);

}  // namespace minksum
