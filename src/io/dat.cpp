// Reads CGAL's `.dat` polygons, which are numbers alone in one of two layouts.
#include <optional>

#include "io/formats.hpp"
#include "io/number.hpp"

namespace minksum::io {

namespace {

enum class Layout {
  kSimple,     ///< each ring, a count and its points, is a polygon
  kWithHoles,  ///< a polygon is its outer ring, the number of holes, and each hole
};

class DatReader {
 public:
  DatReader(std::string_view text, const ReadOptions& options, Layout layout, Rules rules)
      : cursor_(text),
        options_{.cancel = options.cancel},
        cancellation_(options_),
        layout_(layout),
        fewest_(fewest_vertices(rules)) {}

  /// Reads to the end of the text, without storing anything. Throws ReadError.
  void try_to_read() { read(nullptr); }
  void read_into(GeometryBuilder& builder) {
    builder.follow(cursor_);
    read(&builder);
  }
  [[nodiscard]] std::size_t position() const { return cursor_.position(); }

 private:
  void read(GeometryBuilder* builder) {
    builder_ = builder;
    cursor_.skip_space_and_comments();
    do {
      if (builder_ != nullptr) builder_->begin_polygon();
      ring();
      if (layout_ == Layout::kWithHoles) {
        const std::size_t holes = count("the number of holes");
        for (std::size_t i = 0; i < holes; ++i) ring();
      }
      cursor_.skip_space_and_comments();
    } while (!cursor_.at_end());
  }

  void ring() {
    cursor_.skip_space_and_comments();
    const std::size_t start = cursor_.position();
    const std::size_t points = count("the number of points of a ring");
    if (points < fewest_) {
      cursor_.fail(
          ErrorCode::kBadInput,
          "a ring has " + counted_points(points) + ", it needs at least " + std::to_string(fewest_),
          start);
    }
    if (builder_ != nullptr) builder_->begin_ring();
    for (std::size_t i = 0; i < points; ++i) {
      const Number x = scan_lone_number(cursor_);
      const Number y = scan_lone_number(cursor_);
      cancellation_.check(16);
      if (builder_ != nullptr) builder_->add_vertex(x, y);
    }
  }

  std::size_t count(const char* what) {
    cursor_.skip_space_and_comments();
    const std::size_t result = scan_count(cursor_, what);
    end_of_token(cursor_);
    return result;
  }

  TextCursor cursor_;
  Options options_;  ///< of reading
  Cancellation cancellation_;
  Layout layout_;
  std::size_t fewest_;
  GeometryBuilder* builder_ = nullptr;
};

struct Attempt {
  Layout layout = Layout::kSimple;
  std::optional<ReadError> error;
  std::size_t reached = 0;
};

Attempt try_layout(std::string_view text, const ReadOptions& options, Layout layout, Rules rules) {
  DatReader reader(text, options, layout, rules);
  try {
    reader.try_to_read();
  } catch (const ReadError& error) {
    return {layout, error, reader.position()};
  }
  return {layout, std::nullopt, text.size()};
}

// Returns the layout that fits. If neither fits, the one that got further is the likelier meaning.
Attempt try_layouts(std::string_view text, const ReadOptions& options, Rules rules) {
  Attempt simple = try_layout(text, options, Layout::kSimple, rules);
  if (!simple.error) return simple;
  Attempt with_holes = try_layout(text, options, Layout::kWithHoles, rules);
  return !with_holes.error || with_holes.reached > simple.reached ? with_holes : simple;
}

}  // namespace

void read_dat(std::string_view text, const ReadOptions& options, GeometryBuilder& builder) {
  // The rules of regions come first: with rings of one or two vertices, the wrong layout may fit.
  Attempt attempt = try_layouts(text, options, Rules::kRegion);
  if (attempt.error && builder.rules() == Rules::kGeometry) {
    attempt = try_layouts(text, options, builder.rules());
  }
  if (attempt.error) throw *attempt.error;
  DatReader(text, options, attempt.layout, builder.rules()).read_into(builder);
}

}  // namespace minksum::io
