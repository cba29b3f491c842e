// Declares regions: what goes into a Minkowski sum, and what comes out.
#pragma once

#include <array>
#include <cmath>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <type_traits>
#include <vector>

#include "minksum/detail/index_steps.hpp"
#include "minksum/detail/shared_arrays.hpp"
#include "minksum/error.hpp"
#include "minksum/export.h"
#include "minksum/rational.hpp"

namespace minksum {

/// A point with exact coordinates.
struct Point {
  Rational x = {};  ///< the first coordinate
  Rational y = {};  ///< the second coordinate
  /// Tells whether both points have the same coordinates.
  friend bool operator==(const Point&, const Point&) = default;
  /// Compares lexicographically: by x, then by y.
  friend std::strong_ordering operator<=>(const Point&, const Point&) = default;
};

/// A closed ring. Its last vertex does not repeat the first, and its orientation has no meaning.
using Ring = std::vector<Point>;

/// A polygon: the closed area inside `outer` less the open areas inside `holes`.
struct Polygon {
  Ring outer;                    ///< the ring that bounds the polygon from outside
  std::vector<Ring> holes = {};  ///< the rings that bound it from inside, in any order
  /// Tells whether all vertices are equal and in the same order, not whether both are the same set.
  friend bool operator==(const Polygon&, const Polygon&) = default;
};

/// Names what made an edge of a sum: an edge of one operand, moved by a vertex of the other.
///
/// Both are given by vertex indices of the operands as they were given (see Region::vertices_of).
/// The index of an edge is that of its first vertex. Where several edges of an operand lie in one
/// straight line, the first of them in the ring's order is named.
struct EdgeOrigin {
  Operand edge_operand = Operand::kFirst;  ///< the operand with the edge; the other has the vertex
  std::uint32_t edge = 0;                  ///< index of the edge's first vertex
  std::uint32_t vertex = 0;                ///< index of the vertex that moved the edge
  /// Tells whether both name the same edge and the same vertex.
  friend bool operator==(const EdgeOrigin&, const EdgeOrigin&) = default;
};

/// A half-open range of indices to loop over. It is a view with random access.
class IndexRange {
 public:
  /// A random-access iterator over the indices.
  class Iterator : public detail::IndexSteps<Iterator> {
   public:
    using value_type = std::size_t;  ///< the type of an index
    Iterator() = default;
    /// Makes an iterator at this index.
    explicit Iterator(std::size_t index) : IndexSteps(index) {}
    /// Returns the index at which the iterator is.
    std::size_t operator*() const { return index_; }
  };
  /// Makes the range from `first` to `last`, without `last`.
  IndexRange(std::size_t first, std::size_t last) : first_(first), last_(last) {}
  /// Returns an iterator at the first index.
  [[nodiscard]] Iterator begin() const { return Iterator(first_); }
  /// Returns an iterator behind the last index.
  [[nodiscard]] Iterator end() const { return Iterator(last_); }
  /// Returns the first index. An empty range has one, too.
  [[nodiscard]] std::size_t front() const { return first_; }
  /// Returns the last index. The range must not be empty.
  [[nodiscard]] std::size_t back() const { return last_ - 1; }
  /// Returns index `i` of the range, which must be below the size.
  [[nodiscard]] std::size_t operator[](std::size_t i) const { return first_ + i; }
  /// Returns the number of indices.
  [[nodiscard]] std::size_t size() const { return last_ - first_; }
  /// Tells whether there are no indices.
  [[nodiscard]] bool empty() const { return first_ == last_; }

 private:
  std::size_t first_;
  std::size_t last_;
};

/// A point whose coordinates are the doubles nearest to the exact ones.
struct ApproximatePoint {
  double x = 0;  ///< the double nearest to the first coordinate
  double y = 0;  ///< the double nearest to the second coordinate
  /// Tells whether the doubles are equal. The exact points may differ.
  friend bool operator==(const ApproximatePoint&, const ApproximatePoint&) = default;
};

class RingView;

/// A region as flat arrays, as other libraries and file formats have them (GeoArrow, Shapely).
///
/// Ring r has the points from `ring_offsets[r]` up to, but without, `ring_offsets[r + 1]`. In the
/// same way polygon p has the rings from `polygon_offsets[p]` on, the outer ring first. Both arrays
/// begin with 0.
struct FlatRegion {
  std::vector<double> coordinates;               ///< x and y of each point in turn
  std::vector<std::int64_t> ring_offsets{0};     ///< indices of points, one more than rings
  std::vector<std::int64_t> polygon_offsets{0};  ///< indices of rings, one more than polygons
  /// Tells whether all numbers are equal.
  friend bool operator==(const FlatRegion&, const FlatRegion&) = default;
};

/// One coordinate as a region stores it: an exact number in compact form.
///
/// Its value is N / D · 2^exp2 · 10^exp10. Without denominator limbs, N is `payload` and D is 1.
/// Otherwise `payload` is the offset of N's limbs in the region's pool, and D's limbs follow.
struct StoredCoordinate {
  std::int64_t payload = 0;             ///< the integer N, or the offset of its limbs
  std::int16_t exp2 = 0;                ///< the power of two
  std::int16_t exp10 = 0;               ///< the power of ten
  std::uint16_t numerator_limbs = 0;    ///< top bit: negative; 0 limbs with a denominator = zero
  std::uint16_t denominator_limbs = 0;  ///< 0 = N is `payload` itself
};

/// A set of polygons with holes and exact coordinates: operand and result of most operations.
///
/// The vertices lie ring after ring, and the rings polygon after polygon, the outer ring first. A
/// Region as such promises nothing about validity (see `validate`). Results of operations are valid
/// and in canonical form, which means:
/// - Outer rings run counter-clockwise, and holes clockwise.
/// - Each ring starts at its lexicographically smallest vertex.
/// - No vertex lies in the middle of a straight edge.
/// - Rings and polygons are ordered by their first vertices.
///
/// Equal sets in this form therefore compare equal. Copying takes O(1): copies share their memory
/// until one of them is changed. Indices that functions take must be in range, which is not
/// checked.
class MINKSUM_API Region {
 public:
  Region() = default;
  // Not inline, to keep the code of callers small.
  Region(const Region& other) noexcept;             ///< copies in O(1)
  Region(Region&& other) noexcept;                  ///< leaves `other` empty
  Region& operator=(const Region& other) noexcept;  ///< copies in O(1)
  Region& operator=(Region&& other) noexcept;       ///< leaves `other` empty
  ~Region();
  /// Makes the region of one polygon, vertex by vertex. O(n). Throws as `add_vertex` does.
  Region(const Polygon& polygon);  // NOLINT(google-explicit-constructor): the same set
  /// Makes the region of these polygons, in this order. O(n). Throws as `add_vertex` does.
  explicit Region(std::span<const Polygon> polygons);

  /// Returns the region of one polygon without holes, from x and y of each vertex. The first vertex
  /// is not repeated. O(n). Throws as `add_vertex` does.
  [[nodiscard]] static Region from_points(std::span<const std::array<double, 2>> outer);
  /// Returns the same from integers.
  [[nodiscard]] static Region from_points(std::span<const std::array<std::int64_t, 2>> outer);
  /// Returns the region of polygons with holes from the arrays of a FlatRegion. O(n). Throws as
  /// `add_vertex` does. Throws Error(kBadInput) for an odd number of coordinates. Throws the same
  /// for offsets that do not begin with 0, that decrease, or that do not end with the number of
  /// points or rings.
  [[nodiscard]] static Region from_flat(std::span<const double> coordinates,
                                        std::span<const std::int64_t> ring_offsets,
                                        std::span<const std::int64_t> polygon_offsets);
  /// Returns the same from the arrays that `flat` returns.
  [[nodiscard]] static Region from_flat(const FlatRegion& flat) {
    return from_flat(flat.coordinates, flat.ring_offsets, flat.polygon_offsets);
  }

  // -- Building. Numbers are taken exactly. --------------------------------------------------
  /// Removes all polygons.
  void clear();
  /// Starts a polygon. The next ring is its outer ring, and further rings are its holes.
  void begin_polygon();
  /// Starts a ring of the last polygon. Throws Error(kBadInput) if there is no polygon.
  void begin_ring();
  /// Adds a vertex to the last ring of the last polygon, in O(1) on average. This and the other
  /// functions of this name throw Error(kBadInput) if that polygon has no ring yet. Throws
  /// Error(kLimitExceeded) for a coordinate whose numerator or denominator has more than 2 million
  /// bits.
  void add_vertex(const Rational& x, const Rational& y);
  /// Adds the same from a point.
  void add_vertex(const Point& point) { add_vertex(point.x, point.y); }
  /// Adds the same from decimals. Throws Error(kLimitExceeded) for an exponent beyond ±500,000,
  /// unless the mantissa is 0.
  void add_vertex(Decimal x, Decimal y);
  /// Adds the same from doubles, which mean exactly themselves. For NaN and infinity, throws
  /// Error(kBadInput) whose culprit is the new vertex with its polygon and ring.
  void add_vertex(double x, double y);
  /// Adds the same from integers.
  void add_vertex(std::int64_t x, std::int64_t y);
  /// Adds the same from any other two numbers, of one type or of two: integers of up to 64 bits,
  /// floats and doubles.
  template <detail::Plain X, detail::Plain Y>
  void add_vertex(X x, Y y) {
    if constexpr (std::signed_integral<X> && std::signed_integral<Y>) {
      add_vertex(static_cast<std::int64_t>(x), static_cast<std::int64_t>(y));
    } else if constexpr (detail::Floating<X> && detail::Floating<Y>) {
      add_vertex(static_cast<double>(x), static_cast<double>(y));
    } else {
      const auto near_x = static_cast<double>(x);
      const auto near_y = static_cast<double>(y);
      // For numbers that are not finite, this throws an error that names the vertex.
      if (!std::isfinite(near_x) || !std::isfinite(near_y)) return add_vertex(near_x, near_y);
      add_vertex(Rational(x), Rational(y));
    }
  }

  // -- Structure ----------------------------------------------------------------------------
  /// Tells whether there is no vertex.
  [[nodiscard]] bool empty() const { return vertex_count() == 0; }
  /// Returns the number of polygons.
  [[nodiscard]] std::size_t polygon_count() const { return arrays_.size<kPolygonStarts>(); }
  /// Returns the number of rings, outer ones and holes.
  [[nodiscard]] std::size_t ring_count() const { return arrays_.size<kRingStarts>(); }
  /// Returns the number of holes.
  [[nodiscard]] std::size_t hole_count() const { return ring_count() - polygon_count_with_rings(); }
  /// Returns the number of vertices of all rings.
  [[nodiscard]] std::size_t vertex_count() const { return arrays_.size<kVertices>(); }
  /// Returns the indices of all polygons.
  [[nodiscard]] IndexRange polygons() const { return {0, polygon_count()}; }
  /// Returns the indices of a polygon's rings: the outer one first, then its holes. Rings count
  /// from 0 through the whole region.
  [[nodiscard]] IndexRange rings_of(std::size_t polygon) const;
  /// Returns the indices of a ring's vertices. Vertices count from 0 through the whole region.
  [[nodiscard]] IndexRange vertices_of(std::size_t ring) const;
  /// Returns all rings to loop over: `for (const RingView ring : region.rings())`. The range is
  /// valid while the region lives and is not changed.
  [[nodiscard]] auto rings() const&;
  /// Refuses a region that ends with the expression: give it a name first.
  void rings() const&& = delete;

  // -- Coordinates --------------------------------------------------------------------------
  /// Returns the double nearest to the exact x, ties to even; an infinity beyond their range.
  [[nodiscard]] double x(std::size_t vertex) const { return nearest(vertices()[vertex].x); }
  /// Returns the double nearest to the exact y, ties to even; an infinity beyond their range.
  [[nodiscard]] double y(std::size_t vertex) const { return nearest(vertices()[vertex].y); }
  /// Returns the exact x of a vertex.
  [[nodiscard]] Rational exact_x(std::size_t vertex) const { return exact(vertices()[vertex].x); }
  /// Returns the exact y of a vertex.
  [[nodiscard]] Rational exact_y(std::size_t vertex) const { return exact(vertices()[vertex].y); }
  /// Returns a vertex with its exact coordinates.
  [[nodiscard]] Point point(std::size_t vertex) const { return {exact_x(vertex), exact_y(vertex)}; }
  /// Returns a polygon with exact coordinates. O(n).
  [[nodiscard]] Polygon polygon(std::size_t index) const;
  /// Returns the region as flat arrays, with the nearest doubles. O(n).
  [[nodiscard]] FlatRegion flat() const;

  // -- Provenance ---------------------------------------------------------------------------
  /// Tells whether the region has vertices, and an origin for each edge, as sums of regions have.
  [[nodiscard]] bool has_origins() const {
    return !empty() && arrays_.size<kOrigins>() == vertex_count();
  }
  /// Returns what made the edge that starts at this vertex. The region must have origins.
  [[nodiscard]] const EdgeOrigin& origin(std::size_t vertex) const {
    return arrays_.at<kOrigins>(vertex);
  }

  /// Tells whether both have the same rings in the same order, with exactly equal vertices. O(n).
  friend MINKSUM_API bool operator==(const Region& a, const Region& b);

 private:
  friend class RegionAccess;
  struct StoredPoint {
    StoredCoordinate x;
    StoredCoordinate y;
  };
  using Arrays =
      detail::SharedArrays<StoredPoint, EdgeOrigin, std::size_t, std::size_t, std::uint64_t>;
  enum Array : std::size_t {
    kVertices,
    kOrigins,
    kRingStarts,     ///< by ring: the index of its first vertex
    kPolygonStarts,  ///< by polygon: the index of its first ring
    kLimbs,
  };
  [[nodiscard]] std::size_t polygon_count_with_rings() const;
  void require_open_ring() const;
  [[nodiscard]] std::span<const StoredPoint> vertices() const { return arrays_.get<kVertices>(); }
  [[nodiscard]] double nearest(const StoredCoordinate& coordinate) const;
  [[nodiscard]] Rational exact(const StoredCoordinate& coordinate) const;
  StoredCoordinate store(const Rational& value);
  StoredCoordinate store(double value);

  Arrays arrays_;
};

/// A ring of a region. It is valid while the region lives and is not changed.
class MINKSUM_API RingView {
 public:
  RingView() = default;
  /// Makes a view of the ring with this index. The region must outlive the view.
  RingView(const Region& region, std::size_t index) : region_(&region), index_(index) {}
  RingView(const Region&& region, std::size_t index) = delete;

  /// Returns the ring's index, which Region::vertices_of takes.
  [[nodiscard]] std::size_t index() const { return index_; }
  /// Returns the index of the polygon to which the ring belongs. O(log n).
  [[nodiscard]] std::size_t polygon() const;
  /// Tells whether the ring is a hole, and so not the first ring of its polygon. O(log n).
  [[nodiscard]] bool is_hole() const;
  /// Returns the number of vertices.
  [[nodiscard]] std::size_t size() const { return region_->vertices_of(index_).size(); }
  /// Returns the vertices as the nearest doubles: `for (const auto& [x, y] : ring.points())`.
  [[nodiscard]] auto points() const { return made<ApproximatePointOf>(); }
  /// Returns the vertices with exact coordinates.
  [[nodiscard]] auto exact_points() const { return made<ExactPointOf>(); }

 private:
  struct ApproximatePointOf {
    const Region* region = nullptr;
    ApproximatePoint operator()(std::size_t v) const { return {region->x(v), region->y(v)}; }
  };
  struct ExactPointOf {
    const Region* region = nullptr;
    Point operator()(std::size_t v) const { return region->point(v); }
  };
  template <class Make>
  [[nodiscard]] detail::MadeRange<Make> made() const {
    const IndexRange vertices = region_->vertices_of(index_);
    return {Make{region_}, vertices.front(), vertices.front() + vertices.size()};
  }

  const Region* region_ = nullptr;
  std::size_t index_ = 0;
};

namespace detail {
struct RingOf {
  const Region* region = nullptr;
  RingView operator()(std::size_t ring) const { return {*region, ring}; }
};
}  // namespace detail

inline auto Region::rings() const& {
  return detail::MadeRange<detail::RingOf>({this}, 0, ring_count());
}

}  // namespace minksum

/// @cond Doxygen does not know these names of std
// The ranges are views, and their iterators may outlive them.
template <>
inline constexpr bool std::ranges::enable_view<minksum::IndexRange> = true;
template <>
inline constexpr bool std::ranges::enable_borrowed_range<minksum::IndexRange> = true;
template <class Make>
inline constexpr bool std::ranges::enable_view<minksum::detail::MadeRange<Make>> = true;
template <class Make>
inline constexpr bool std::ranges::enable_borrowed_range<minksum::detail::MadeRange<Make>> = true;

/// Hashes a point by its nearest doubles.
template <>
struct std::hash<minksum::Point> {
  /// Returns the hash.
  std::size_t operator()(const minksum::Point& point) const {
    const std::hash<minksum::Rational> of;
    return of(point.x) * 31 + of(point.y);
  }
};
/// @endcond
