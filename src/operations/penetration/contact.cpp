#include "operations/penetration/contact.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace minksum {
namespace {

/// The moved vertices of a region, sorted by the parallel lines on which they lie.
class Lines {
 public:
  Lines(const Region& region, const Point& shift, const Point& along, Cancellation& cancellation)
      : along_(along) {
    points_.reserve(region.vertex_count());
    for (std::size_t v = 0; v < region.vertex_count(); ++v) {
      const Point at = region.point(v);
      points_.push_back({at.x + shift.x, at.y + shift.y});
      cancellation.check(4 * work_of(points_.back()));
      const Rational line = line_of(points_.back());
      lines_.push_back({line.to_double(), v, line});
    }
    std::sort(lines_.begin(), lines_.end(), cancellation.counting(before));
  }

  [[nodiscard]] const Point& point(std::size_t vertex) const { return points_[vertex]; }
  [[nodiscard]] Rational line_of(const Point& at) const {
    return along_.x * at.y - along_.y * at.x;
  }
  [[nodiscard]] Rational place_of(const Point& at) const {
    return along_.x * at.x + along_.y * at.y;
  }

  /// Returns the first vertex on an edge that is parallel to the lines.
  [[nodiscard]] std::optional<std::size_t> first_on(const Point& from, const Point& to,
                                                    Cancellation& cancellation) const {
    const Rational line = line_of(from);
    const auto [low, high] = std::minmax({place_of(from), place_of(to)});
    const Entry key{line.to_double(), 0, {}};
    auto at = std::lower_bound(lines_.begin(), lines_.end(), key, before);
    for (; at != lines_.end() && at->about == key.about; ++at) {
      cancellation.check(4 * work_of(points_[at->vertex]));
      if (at->line != line) continue;
      const Rational place = place_of(points_[at->vertex]);
      if (low <= place && place <= high) return at->vertex;
    }
    return std::nullopt;
  }

 private:
  struct Entry {
    double about;  ///< the line as the nearest double; equal lines have equal ones
    std::size_t vertex;
    Rational line;
  };
  static bool before(const Entry& a, const Entry& b) {
    return a.about != b.about ? a.about < b.about : a.vertex < b.vertex;
  }

  Point along_;
  std::vector<Point> points_;
  std::vector<Entry> lines_;
};

std::optional<EdgeOrigin> find_on_edges(const Region& region, const Lines& own, const Lines& others,
                                        Operand operand, Cancellation& cancellation) {
  for (std::size_t ring = 0; ring < region.ring_count(); ++ring) {
    const IndexRange vertices = region.vertices_of(ring);
    for (const std::size_t v : vertices) {
      const bool last = v + 1 == vertices.front() + vertices.size();
      const Point& from = own.point(v);
      const Point& to = own.point(last ? vertices.front() : v + 1);
      cancellation.check(4 * work_of(from));
      if (from == to || own.line_of(from) != own.line_of(to)) continue;
      if (const auto vertex = others.first_on(from, to, cancellation)) {
        return EdgeOrigin{operand, static_cast<std::uint32_t>(v),
                          static_cast<std::uint32_t>(*vertex)};
      }
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<EdgeOrigin> find_contact(const Region& a, const Region& b, const Point& shift,
                                       const Point& along, Cancellation& cancellation) {
  const Lines first(a, {}, along, cancellation);
  const Lines second(b, shift, along, cancellation);
  const auto contact = find_on_edges(a, first, second, Operand::kFirst, cancellation);
  return contact ? contact : find_on_edges(b, second, first, Operand::kSecond, cancellation);
}

}  // namespace minksum
