// Builds geometries from what readers read, by the rules that all readers keep.
#pragma once

#include <cstddef>
#include <string>

#include "io/number.hpp"
#include "machine/cancellation.hpp"
#include "minksum/geometry.hpp"
#include "minksum/io.hpp"

namespace minksum::io {

/// Says which kinds of shapes a text may hold.
enum class Rules {
  kRegion,    ///< polygons alone; rings of three vertices or more
  kGeometry,  ///< polylines and points too; rings of one vertex or more, to be read by `resolve`
};

/// Returns how many vertices a ring must have at least.
[[nodiscard]] inline std::size_t fewest_vertices(Rules rules) {
  return rules == Rules::kRegion ? 3 : 1;
}

/// Returns the count in words, such as "3 points" or "1 point".
[[nodiscard]] std::string counted_points(std::size_t count);

/// Builds a geometry vertex by vertex as a reader goes on, and keeps the limit on vertices.
class GeometryBuilder {
 public:
  /// `cursor` belongs to the reader; errors name the position at which it stands.
  GeometryBuilder(const TextCursor& cursor, const ReadLimits& limits, Rules rules)
      : cursor_(cursor),
        max_vertices_(limits.max_vertices),
        options_{.cancel = limits.cancel},
        cancellation_(options_),
        rules_(rules) {}

  [[nodiscard]] Rules rules() const { return rules_; }
  [[nodiscard]] std::size_t polygon_count() const { return geometry_.region.polygon_count(); }
  void begin_polygon();

  /// Begins a ring whose text does not repeat the first vertex.
  void begin_ring() { geometry_.region.begin_ring(); }
  void add_vertex(const Number& x, const Number& y);

  /// Begins a ring whose text repeats the first vertex at its end, as in WKT and GeoJSON. The
  /// cursor must stand where the ring starts, because errors name that position.
  void begin_closed_ring();
  void add_to_closed_ring(Number x, Number y);
  void end_closed_ring();

  void begin_line();
  void add_to_line(const Number& x, const Number& y);
  /// Ends the line, and drops it if it has no vertices.
  void end_line();

  void add_point(const Number& x, const Number& y);

  [[nodiscard]] Geometry take() { return std::move(geometry_); }

 private:
  void count_vertex();
  [[nodiscard]] std::string ring_name() const;

  const TextCursor& cursor_;
  std::size_t max_vertices_;
  Options options_;  ///< of reading
  Cancellation cancellation_;
  Rules rules_;
  Geometry geometry_;
  std::size_t vertices_ = 0;
  std::size_t counted_to_ = 0;  // position in the text at the last counted vertex
  std::size_t ring_ = 0;
  std::size_t start_ = 0;   // position of the ring or line
  std::size_t points_ = 0;  // points of the ring so far
  Number first_x_, first_y_;
  Number last_x_, last_y_;  // held back: the closing point is not a vertex
};

}  // namespace minksum::io
