// Reads and writes the `.poly` format of the paper's authors: chains of points, each followed by
// the order in which they are visited.
#include <utility>
#include <vector>

#include "io/formats.hpp"
#include "io/number.hpp"
#include "io/writer.hpp"

namespace minksum::io {

namespace {

class PolyReader {
 public:
  PolyReader(std::string_view text, GeometryBuilder& builder) : cursor_(text), builder_(builder) {
    builder_.follow(cursor_);
  }

  void read() {
    cursor_.skip_space_and_comments();
    const std::size_t chains = scan_count(cursor_, "the number of chains");
    for (chain_ = 0; chain_ < chains; ++chain_) {
      chain();
    }
    cursor_.skip_space_and_comments();
    if (!cursor_.at_end()) {
      cursor_.fail_expected("the end of the text after " + std::to_string(chains) + " chains");
    }
  }

 private:
  void chain() {
    cursor_.skip_space_and_comments();
    const std::size_t start = cursor_.position();
    const std::size_t count = scan_count(cursor_, "the number of points of " + name());
    if (const std::size_t fewest = fewest_vertices(builder_.rules()); count < fewest) {
      cursor_.fail(ErrorCode::kBadInput,
                   name() + " has " + counted_points(count) + ", a chain needs at least " +
                       std::to_string(fewest),
                   start);
    }
    begin_ring();
    points_.clear();
    while (points_.size() < count)
      points_.push_back({scan_lone_number(cursor_), scan_lone_number(cursor_)});
    order(count);
  }

  void begin_ring() {
    cursor_.skip_space_and_comments();
    const std::size_t start = cursor_.position();
    const std::string kind = cursor_.take_word();
    if (kind != "OUT" && kind != "IN") {
      cursor_.move_to(start);
      cursor_.fail_expected("'out' or 'in'");
    }
    if (kind == "OUT") {
      builder_.begin_polygon();
    } else if (builder_.polygon_count() == 0) {
      cursor_.fail(ErrorCode::kBadInput, name() + " is a hole, but no outer chain comes before it",
                   start);
    }
    builder_.begin_ring();
  }

  // Reads the permutation of 1 to `count` in which the points are visited.
  void order(std::size_t count) {
    seen_.assign(count, false);
    for (std::size_t visit = 0; visit < count; ++visit) {
      cursor_.skip_space_and_comments();
      const std::size_t start = cursor_.position();
      const std::size_t index = scan_count(cursor_, "the order of the points of " + name());
      end_of_token(cursor_);
      if (index < 1 || index > count || seen_[index - 1]) {
        cursor_.fail(ErrorCode::kBadInput,
                     "the order of the points of " + name() + " must name each of 1 to " +
                         std::to_string(count) + " once, found " + std::to_string(index),
                     start);
      }
      seen_[index - 1] = true;
      const auto& [x, y] = points_[index - 1];
      builder_.add_vertex(x, y);
    }
  }

  [[nodiscard]] std::string name() const { return "chain " + std::to_string(chain_ + 1); }

  TextCursor cursor_;
  GeometryBuilder& builder_;
  std::size_t chain_ = 0;
  std::vector<std::pair<Number, Number>> points_;
  std::vector<bool> seen_;
};

}  // namespace

void read_poly(std::string_view text, const ReadOptions&, GeometryBuilder& builder) {
  PolyReader(text, builder).read();
}

void write_poly(const Sink& out, const Region& region, const Coordinates& style) {
  Writer writer(out, style);
  writer.count(region.ring_count());
  writer.text('\n');
  for (const std::size_t polygon : region.polygons()) {
    bool outer = true;
    for (const std::size_t ring : region.rings_of(polygon)) {
      const IndexRange vertices = region.vertices_of(ring);
      writer.count(vertices.size());
      writer.text(outer ? " out\n" : " in\n");
      outer = false;
      for (const std::size_t vertex : vertices) {
        writer.point(region, vertex, ' ');
        writer.text('\n');
      }
      for (std::size_t i = 1; i <= vertices.size(); ++i) {
        if (i > 1) writer.text(' ');
        writer.count(i);
      }
      writer.text('\n');
    }
  }
  writer.flush();
}

}  // namespace minksum::io
