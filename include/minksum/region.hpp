// Regions: what goes into a Minkowski sum, and what comes out.
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <type_traits>
#include <vector>

#include "minksum/detail/shared_arrays.hpp"
#include "minksum/error.hpp"
#include "minksum/export.h"
#include "minksum/rational.hpp"

namespace minksum {

/// A point with exact coordinates.
struct Point {
  Rational x;  ///< the first coordinate
  Rational y;  ///< the second coordinate
  /// Whether both coordinates are the same numbers.
  friend bool operator==(const Point&, const Point&) = default;
};

/// A closed ring; the first vertex is not repeated at the end. Its orientation has no meaning.
using Ring = std::vector<Point>;

/// A polygon: the closed area inside `outer` less the open areas inside `holes`.
struct Polygon {
  Ring outer;                    ///< what bounds it from outside
  std::vector<Ring> holes = {};  ///< in any order
  /// Whether all vertices are equal, in the same order; not whether both are the same set.
  friend bool operator==(const Polygon&, const Polygon&) = default;
};

/// What made an edge of a sum: edge `edge` of one operand, moved by vertex `vertex` of the other.
///
/// Both are vertex indices of the operands as they were given (`Region::vertices_of`); an edge has
/// the index of its first vertex. Where an operand has several edges in one straight line, the
/// first of them (in the ring's order) is named.
struct EdgeOrigin {
  Operand edge_operand = Operand::kFirst;  ///< whose edge it is; the vertex is the other's
  std::uint32_t edge = 0;                  ///< index of the edge's first vertex
  std::uint32_t vertex = 0;                ///< index of the vertex that moved the edge
  /// Whether both name the same edge and the same vertex.
  friend bool operator==(const EdgeOrigin&, const EdgeOrigin&) = default;
};

/// A half-open range of indices, to loop over.
class IndexRange {
 public:
  /// A forward iterator that gives the indices one by one.
  class Iterator {
   public:
    using value_type = std::size_t;          ///< an index
    using difference_type = std::ptrdiff_t;  ///< as the standard library asks for
    Iterator() = default;
    /// At this index.
    explicit Iterator(std::size_t index) : index_(index) {}
    /// The index that it is at.
    std::size_t operator*() const { return index_; }
    /// Goes on to the next index.
    Iterator& operator++() {
      ++index_;
      return *this;
    }
    /// Goes on to the next index, and gives the iterator as it was.
    Iterator operator++(int) {
      const Iterator before = *this;
      ++index_;
      return before;
    }
    /// Whether both are at the same index.
    bool operator==(const Iterator&) const = default;

   private:
    std::size_t index_ = 0;
  };
  /// From `first` to `last`, which excluded.
  IndexRange(std::size_t first, std::size_t last) : first_(first), last_(last) {}
  /// At the first index.
  [[nodiscard]] Iterator begin() const { return Iterator(first_); }
  /// Behind the last index.
  [[nodiscard]] Iterator end() const { return Iterator(last_); }
  /// The first index, even if the range is empty.
  [[nodiscard]] std::size_t front() const { return first_; }
  /// How many indices there are.
  [[nodiscard]] std::size_t size() const { return last_ - first_; }
  /// Whether there are none.
  [[nodiscard]] bool empty() const { return first_ == last_; }

 private:
  std::size_t first_;
  std::size_t last_;
};

/// A point whose coordinates are the doubles nearest to the exact ones.
struct ApproximatePoint {
  double x = 0;  ///< nearest to the first coordinate
  double y = 0;  ///< nearest to the second coordinate
  /// Whether the doubles are equal. The exact points may differ.
  friend bool operator==(const ApproximatePoint&, const ApproximatePoint&) = default;
};

namespace detail {
/// What `make` gives for each index of a half-open range, to loop over.
template <class Make>
class MadeRange {
 public:
  class Iterator {
   public:
    using value_type = std::invoke_result_t<const Make&, std::size_t>;
    using difference_type = std::ptrdiff_t;
    Iterator() = default;
    Iterator(const Make& make, std::size_t index) : make_(make), index_(index) {}
    value_type operator*() const { return make_(index_); }
    Iterator& operator++() {
      ++index_;
      return *this;
    }
    Iterator operator++(int) {
      const Iterator before = *this;
      ++index_;
      return before;
    }
    bool operator==(const Iterator& other) const { return index_ == other.index_; }

   private:
    Make make_{};
    std::size_t index_ = 0;
  };
  MadeRange(const Make& make, std::size_t first, std::size_t last)
      : make_(make), first_(first), last_(last) {}
  [[nodiscard]] Iterator begin() const { return {make_, first_}; }
  [[nodiscard]] Iterator end() const { return {make_, last_}; }
  [[nodiscard]] std::size_t size() const { return last_ - first_; }
  [[nodiscard]] bool empty() const { return first_ == last_; }
  /// `i` must be below the size.
  [[nodiscard]] auto operator[](std::size_t i) const { return make_(first_ + i); }

 private:
  Make make_;
  std::size_t first_;
  std::size_t last_;
};
}  // namespace detail

class RingView;

/// A region as flat arrays, as other libraries and file formats hold them (GeoArrow, Shapely).
///
/// Ring r has the points from `ring_offsets[r]` to `ring_offsets[r + 1]`, which excluded. So
/// polygon p has rings by `polygon_offsets`, the outer one first. Both arrays begin with 0.
struct FlatRegion {
  std::vector<double> coordinates;               ///< x and y of each point in turn
  std::vector<std::int64_t> ring_offsets{0};     ///< in points: one more than there are rings
  std::vector<std::int64_t> polygon_offsets{0};  ///< in rings: one more than there are polygons
};

/// One coordinate as a region stores it: an exact number in compact form.
///
/// Value = N / D · 2^exp2 · 10^exp10. With no denominator limbs, N is `payload` and D is 1;
/// otherwise `payload` is the offset of N's limbs and then D's limbs in the region's pool.
struct StoredCoordinate {
  std::int64_t payload = 0;             ///< the integer N, or where its limbs are
  std::int16_t exp2 = 0;                ///< the power of two
  std::int16_t exp10 = 0;               ///< the power of ten
  std::uint16_t numerator_limbs = 0;    ///< top bit: negative; 0 limbs with a denominator = zero
  std::uint16_t denominator_limbs = 0;  ///< 0: N is `payload` itself
};

/// A set of polygons with holes, with exact coordinates: operand and result of every operation.
///
/// Flat and compact: vertices lie ring after ring, rings polygon after polygon (outer ring first).
/// A Region as such promises nothing about validity: see `validate` (validity.hpp). Results of
/// operations are valid and in canonical form: outer rings counter-clockwise, holes clockwise, each
/// ring starts at its lexicographically smallest vertex, no vertex lies in the middle of a straight
/// edge, rings and polygons are ordered by their first vertices; so equal sets compare equal.
///
/// Copying takes O(1): copies share their memory until one of them is changed.
class MINKSUM_API Region {
 public:
  Region() = default;
  /// The polygon, vertex by vertex. Throws Error(kLimitExceeded) as `add_vertex` does.
  Region(const Polygon& polygon);  // NOLINT(google-explicit-constructor): the same set
  /// These polygons, in this order. Throws Error(kLimitExceeded) as `add_vertex` does.
  explicit Region(std::span<const Polygon> polygons);

  /// One polygon without holes, from x and y of each vertex. O(n). Throws as `add_vertex` does.
  [[nodiscard]] static Region from_points(std::span<const std::array<double, 2>> outer);
  /// The same from integers.
  [[nodiscard]] static Region from_points(std::span<const std::array<std::int64_t, 2>> outer);
  /// Polygons with holes from flat arrays: see FlatRegion. O(n). Throws as `add_vertex` does, and
  /// Error(kBadInput) for an odd number of coordinates, and for offsets that do not begin with 0,
  /// run back, or do not end with the number of what they divide.
  [[nodiscard]] static Region from_flat(std::span<const double> coordinates,
                                        std::span<const std::int64_t> ring_offsets,
                                        std::span<const std::int64_t> polygon_offsets);
  /// The same from the arrays that `flat` gives.
  [[nodiscard]] static Region from_flat(const FlatRegion& flat) {
    return from_flat(flat.coordinates, flat.ring_offsets, flat.polygon_offsets);
  }

  // -- Building. Numbers are taken exactly. --------------------------------------------------
  /// Removes all polygons.
  void clear();
  /// Starts a polygon; the next ring is its outer ring, further ones are holes.
  void begin_polygon();
  /// Starts a ring of the polygon that was started last. Throws Error(kBadInput) if there is none.
  void begin_ring();
  /// Adds a vertex to the ring that was started last. Throws Error(kBadInput) if its polygon has no
  /// ring yet, and so do the others of this name; Error(kLimitExceeded) for a coordinate whose
  /// numerator or denominator has more than 2 million bits.
  void add_vertex(const Rational& x, const Rational& y);
  /// The same from decimals. Throws Error(kLimitExceeded) for an exponent beyond ±500,000, unless
  /// the mantissa is 0.
  void add_vertex(Decimal x, Decimal y);
  /// Doubles mean exactly themselves. Throws Error(kBadInput) naming the vertex for NaN, infinity.
  void add_vertex(double x, double y);
  /// The same from integers.
  void add_vertex(std::int64_t x, std::int64_t y);
  /// Any other two numbers, of one type or of two: integers of up to 64 bits, floats and doubles.
  template <detail::Plain X, detail::Plain Y>
  void add_vertex(X x, Y y) {
    if constexpr (std::signed_integral<X> && std::signed_integral<Y>) {
      add_vertex(static_cast<std::int64_t>(x), static_cast<std::int64_t>(y));
    } else if constexpr (detail::Floating<X> && detail::Floating<Y>) {
      add_vertex(static_cast<double>(x), static_cast<double>(y));
    } else {
      const auto near_x = static_cast<double>(x);
      const auto near_y = static_cast<double>(y);
      // What is not finite is an error that names the vertex.
      if (!std::isfinite(near_x) || !std::isfinite(near_y)) return add_vertex(near_x, near_y);
      add_vertex(Rational(x), Rational(y));
    }
  }

  // -- Structure ----------------------------------------------------------------------------
  /// Whether there is no vertex.
  [[nodiscard]] bool empty() const { return vertex_count() == 0; }
  /// How many polygons there are.
  [[nodiscard]] std::size_t polygon_count() const { return arrays_.size<kPolygonStarts>(); }
  /// How many rings there are, outer ones and holes.
  [[nodiscard]] std::size_t ring_count() const { return arrays_.size<kRingStarts>(); }
  /// How many holes there are.
  [[nodiscard]] std::size_t hole_count() const { return ring_count() - polygon_count_with_rings(); }
  /// How many vertices all rings have.
  [[nodiscard]] std::size_t vertex_count() const { return arrays_.size<kVertices>(); }
  /// The indices of all polygons.
  [[nodiscard]] IndexRange polygons() const { return {0, polygon_count()}; }
  /// The rings of a polygon: the outer one first, then its holes.
  [[nodiscard]] IndexRange rings_of(std::size_t polygon) const;
  /// The vertices of a ring. They count from 0 through the whole region, and so do rings.
  [[nodiscard]] IndexRange vertices_of(std::size_t ring) const;
  /// All rings, to loop over: `for (const RingView ring : region.rings())`. Valid while the region
  /// lives and is not changed.
  [[nodiscard]] auto rings() const&;
  /// Not of a region that ends with the expression: give it a name first.
  void rings() const&& = delete;

  // -- Coordinates --------------------------------------------------------------------------
  /// The double nearest to the exact x (ties to even).
  [[nodiscard]] double x(std::size_t vertex) const { return nearest(vertices()[vertex].x); }
  /// The double nearest to the exact y (ties to even).
  [[nodiscard]] double y(std::size_t vertex) const { return nearest(vertices()[vertex].y); }
  /// The exact x of a vertex.
  [[nodiscard]] Rational exact_x(std::size_t vertex) const { return exact(vertices()[vertex].x); }
  /// The exact y of a vertex.
  [[nodiscard]] Rational exact_y(std::size_t vertex) const { return exact(vertices()[vertex].y); }
  /// A vertex with its exact coordinates.
  [[nodiscard]] Point point(std::size_t vertex) const { return {exact_x(vertex), exact_y(vertex)}; }
  /// A polygon with exact coordinates. O(n).
  [[nodiscard]] Polygon polygon(std::size_t index) const;
  /// As flat arrays, with the nearest doubles. O(n).
  [[nodiscard]] FlatRegion flat() const;

  // -- Provenance ---------------------------------------------------------------------------
  /// Whether every edge knows what made it (true for results of minkowski_sum).
  [[nodiscard]] bool has_origins() const {
    return !empty() && arrays_.size<kOrigins>() == vertex_count();
  }
  /// What made the edge that starts at this vertex.
  [[nodiscard]] const EdgeOrigin& origin(std::size_t vertex) const {
    return arrays_.at<kOrigins>(vertex);
  }

  /// Equal as stored: the same rings in the same order with exactly equal vertices.
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
    kRingStarts,     ///< by ring: its first vertex
    kPolygonStarts,  ///< by polygon: its first ring
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

/// A ring of a region. Valid while the region lives and is not changed.
class MINKSUM_API RingView {
 public:
  RingView() = default;
  /// The ring of this index. The region must outlive it.
  RingView(const Region& region, std::size_t index) : region_(&region), index_(index) {}
  RingView(const Region&& region, std::size_t index) = delete;

  /// As in Region::vertices_of.
  [[nodiscard]] std::size_t index() const { return index_; }
  /// The index of the polygon that it belongs to. O(log n).
  [[nodiscard]] std::size_t polygon() const;
  /// Whether it is not the first ring of its polygon. O(log n).
  [[nodiscard]] bool is_hole() const;
  /// How many vertices it has.
  [[nodiscard]] std::size_t size() const { return region_->vertices_of(index_).size(); }
  /// The nearest doubles: `for (const auto& [x, y] : ring.points())`.
  [[nodiscard]] auto points() const { return made<ApproximatePointOf>(); }
  /// The same with exact coordinates.
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
