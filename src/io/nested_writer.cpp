#include "io/nested_writer.hpp"

#include <span>

namespace minksum::io {

namespace {

class NestedWriter {
 public:
  NestedWriter(Writer& writer, const Notation& notation, std::string_view last)
      : writer_(writer), notation_(notation), last_(last) {}

  void write(const GeometryView& geometry) {
    const bool is_collection = geometry.kinds() > 1;
    depth_ = is_collection ? 2 : 1;
    if (is_collection) {
      writer_.text(notation_.begin[Notation::kCollection]);
      writer_.text(notation_.open);
    }
    if (!geometry.region.empty() || geometry.kinds() == 0) {
      const Region& region = geometry.region;
      const IndexRange polygons = region.empty() ? IndexRange(0, 0) : region.polygons();
      kind(Notation::kPolygon, polygons, [&](std::size_t polygon) {
        list(region.rings_of(polygon), [&](std::size_t r) { ring(region, region.vertices_of(r)); });
      });
    }
    if (!geometry.polylines.empty()) {
      kind(Notation::kLine, geometry.polylines, [&](const Polyline& line) {
        list(line, [&](const Point& at) { point(notation_.bare_points, at); });
      });
    }
    if (!geometry.points.empty()) {
      kind(Notation::kPoint, geometry.points, [&](const Point& at) { point(false, at); });
    }
    if (is_collection) {
      writer_.text(notation_.close);
      depth_ = 1;
      end();
    }
  }

 private:
  /// Writes a single item of a kind as such, and several as a list of the next kind.
  template <class Items, class Write>
  void kind(Notation::Kind one, const Items& items, Write write) {
    writer_.text(before_kind_);
    before_kind_ = ", ";
    writer_.text(notation_.begin[static_cast<std::size_t>(one) + (items.size() > 1 ? 1U : 0U)]);
    if (items.size() == 1) {
      write(*items.begin());
    } else {
      list(items, write);
    }
    end();
  }
  // Ends one kind, or the collection of all.
  void end() {
    if (depth_ == 1) writer_.text(last_);
    writer_.text(notation_.end);
  }
  template <class Items, class Write>
  void list(const Items& items, Write write) {
    if (items.empty()) return writer_.text(notation_.empty);
    writer_.text(notation_.open);
    bool first = true;
    for (const auto& item : items) {
      if (!first) writer_.text(", ");
      first = false;
      write(item);
    }
    writer_.text(notation_.close);
  }
  void ring(const Region& region, IndexRange vertices) {
    if (vertices.empty()) return writer_.text(notation_.empty);
    writer_.text(notation_.open);
    for (const std::size_t vertex : vertices) {
      point(notation_.bare_points, region, vertex);
      writer_.text(", ");
    }
    point(notation_.bare_points, region, vertices.front());
    writer_.text(notation_.close);
  }
  template <class... Vertex>
  void point(bool is_bare, const Vertex&... vertex) {
    if (!is_bare) writer_.text(notation_.open);
    writer_.point(vertex..., notation_.separator);
    if (!is_bare) writer_.text(notation_.close);
  }

  Writer& writer_;
  const Notation& notation_;
  std::string_view last_;  // stands before the last end
  int depth_ = 1;
  std::string_view before_kind_;
};

}  // namespace

void write_nested(Writer& writer, const GeometryView& geometry, const Notation& notation,
                  std::string_view last) {
  NestedWriter(writer, notation, last).write(geometry);
}

}  // namespace minksum::io
