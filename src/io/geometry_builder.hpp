// Builds geometries from what readers read, by the rules that all readers keep.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

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

/// Returns the end of a message about coordinates beyond x and y.
[[nodiscard]] inline std::string more_than_two() {
  return " has more than two coordinates (io::ReadOptions::drop_z keeps x and y)";
}

/// Returns the count in words, such as "3 points" or "1 point".
[[nodiscard]] std::string counted_points(std::size_t count);

/// Builds a geometry vertex by vertex as a reader goes on, keeps the limit on vertices, and keeps
/// what the text says about all of its features.
class GeometryBuilder {
 public:
  GeometryBuilder(const ReadOptions& options, Rules rules)
      : max_vertices_(options.max_vertices),
        options_{.cancel = options.cancel},
        cancellation_(options_),
        rules_(rules) {}

  /// Begins a feature, which is added to what was read before. Errors number its polygons from 1.
  void begin_feature() {
    polygons_before_ = geometry_.region.polygon_count();
    vertices_before_ = vertices_;
  }
  /// Tells whether the feature has no points so far.
  [[nodiscard]] bool feature_is_empty() const { return vertices_ == vertices_before_; }
  /// Makes errors name positions of `cursor`, which belongs to the reader, from now on.
  void follow(const TextCursor& cursor) {
    cursor_ = &cursor;
    counted_to_ = cursor.position();
  }

  [[nodiscard]] Rules rules() const { return rules_; }
  [[nodiscard]] SourceInfo& source() { return source_; }
  /// Returns how many polygons the feature has.
  [[nodiscard]] std::size_t polygon_count() const {
    return geometry_.region.polygon_count() - polygons_before_;
  }

  /// Notes the reference system, whose name stands at `position`. Fails if another one was named.
  void set_srid(std::int32_t srid, std::size_t position);
  void set_crs(std::string_view crs, std::size_t position);

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

  /// Makes a geometry the feature. Vertices were counted while it was made.
  void set_feature(Geometry geometry) {
    vertices_ += std::size_t{geometry.empty() ? 0U : 1U};
    geometry_ = std::move(geometry);
  }
  /// Returns what was read since the last time.
  [[nodiscard]] Geometry take() {
    vertices_ = 0;
    return std::exchange(geometry_, {});
  }

 private:
  void count_vertex();
  [[nodiscard]] std::string ring_name() const;

  const TextCursor* cursor_ = nullptr;
  std::size_t max_vertices_;
  Options options_;  ///< of reading
  Cancellation cancellation_;
  Rules rules_;
  Geometry geometry_;
  SourceInfo source_;
  std::size_t polygons_before_ = 0;  ///< this feature
  std::size_t vertices_before_ = 0;
  std::size_t vertices_ = 0;
  std::size_t counted_to_ = 0;  // position in the text at the last counted vertex
  std::size_t ring_ = 0;
  std::size_t start_ = 0;   // position of the ring or line
  std::size_t points_ = 0;  // points of the ring so far
  Number first_x_, first_y_;
  Number last_x_, last_y_;  // held back: the closing point is not a vertex
};

}  // namespace minksum::io
