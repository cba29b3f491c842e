// Declares how DXF's entities become outlines.
#pragma once

#include "io/drawing/chains.hpp"
#include "io/drawing/dxf_tags.hpp"

namespace minksum::io {

/// Adds the shapes of entities to chains, each with the map that is set.
class DxfShapes {
 public:
  DxfShapes(DxfTags& tags, Outlines& outlines, bool drop_z)
      : tags_(tags), outlines_(outlines), drop_z_(drop_z) {}

  /// Adds an entity's shape. Reads the vertices that follow a POLYLINE. Returns false if entities
  /// of this type are not read.
  [[nodiscard]] bool add(const DxfEntity& entity, const NearAffine& map);

  /// Fails if an entity has a height other than 0, unless heights are dropped.
  void check_flat(const DxfEntity& entity) const;

  std::vector<Chain> open;
  std::vector<Chain> closed;

 private:
  struct Vertex {
    Point point;
    Rational bulge;
  };
  /// An angle, and the quarter turns that it exactly is, or -1.
  struct Angle {
    Interval radians;
    int quarters = -1;
  };
  struct Ellipse {
    Point centre, u, v;
  };
  /// A B-spline whose control points all take part.
  struct Spline {
    std::size_t degree;
    std::vector<Point> controls;
    std::vector<Rational> knots;
    std::vector<Rational> weights;
  };

  /// Returns the map of an entity in its own coordinates, by the normal of its plane.
  [[nodiscard]] NearAffine own(const DxfValues& values, const DxfEntity& entity) const;
  [[nodiscard]] bool is_mirrored(const DxfValues& values, const DxfEntity& entity) const;
  void line(const DxfValues& values);
  void arc(const DxfValues& values, const DxfEntity& entity, bool whole);
  void ellipse(const DxfValues& values, const DxfEntity& entity);
  void solid(const DxfValues& values);
  void light_polyline(const DxfValues& values, const DxfEntity& entity);
  void polyline(const DxfValues& values, bool is_flat);
  [[nodiscard]] Spline take_spline(const DxfValues& values, const DxfEntity& entity) const;
  void spline(const DxfValues& values, const DxfEntity& entity, const NearAffine& map);
  void add_polyline(const std::vector<Vertex>& vertices, bool is_closed);
  void add_arcs(const Ellipse& ellipse, const Angle& from, const Angle& to, bool is_closed);
  [[nodiscard]] Point placed(const Ellipse& ellipse, const Angle& angle);
  void end(bool is_closed);

  DxfTags& tags_;
  Outlines& outlines_;
  bool drop_z_;
};

}  // namespace minksum::io
