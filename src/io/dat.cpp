// CGAL's `.dat` polygons: numbers alone, in one of two layouts.
#include <optional>
#include <utility>

#include "io/formats.hpp"
#include "io/number.hpp"

namespace minksum::io {

namespace {

enum class Layout {
  kSimple,     ///< rings one after the other, each a count and its points: each is a polygon
  kWithHoles,  ///< for each polygon the outer ring, the number of holes, and each hole
};

class DatReader {
 public:
  DatReader(std::string_view text, Layout layout, Region* region)
      : cursor_(text), layout_(layout), region_(region) {}

  /// Reads to the end of the text, into the region if there is one. Throws ReadError.
  void read() {
    cursor_.skip_space_and_comments();
    do {
      if (region_ != nullptr) region_->begin_polygon();
      ring();
      if (layout_ == Layout::kWithHoles) {
        const std::size_t holes = count("the number of holes");
        for (std::size_t i = 0; i < holes; ++i) ring();
      }
      cursor_.skip_space_and_comments();
    } while (!cursor_.at_end());
  }
  [[nodiscard]] std::size_t position() const { return cursor_.position(); }

 private:
  void ring() {
    cursor_.skip_space_and_comments();
    const std::size_t start = cursor_.position();
    const std::size_t points = count("the number of points of a ring");
    if (points < 3) {
      cursor_.fail(ErrorCode::kBadInput,
                   "a ring has " + std::to_string(points) + (points == 1 ? " point" : " points") +
                       ", it needs at least 3",
                   start);
    }
    if (region_ != nullptr) region_->begin_ring();
    for (std::size_t i = 0; i < points; ++i) {
      const Number x = coordinate();
      const Number y = coordinate();
      if (region_ != nullptr) add_vertex(*region_, x, y);
    }
  }

  std::size_t count(const char* what) {
    cursor_.skip_space_and_comments();
    const std::size_t result = scan_count(cursor_, what);
    end_of_token();
    return result;
  }

  Number coordinate() {
    cursor_.skip_space_and_comments();
    Number number = scan_number(cursor_, NumberSyntax::kLenient);
    end_of_token();
    return number;
  }

  void end_of_token() {
    if (!cursor_.at_end() && !is_space(cursor_.peek()) && cursor_.peek() != '#') {
      cursor_.fail_expected("a space");
    }
  }

  TextCursor cursor_;
  Layout layout_;
  Region* region_;
};

struct Attempt {
  std::optional<ReadError> error;
  std::size_t reached = 0;
};

Attempt try_layout(std::string_view text, Layout layout) {
  DatReader reader(text, layout, nullptr);
  try {
    reader.read();
  } catch (const ReadError& error) {
    return {error, reader.position()};
  }
  return {std::nullopt, text.size()};
}

}  // namespace

Region read_dat(std::string_view text) {
  const Attempt simple = try_layout(text, Layout::kSimple);
  Layout layout = Layout::kSimple;
  if (simple.error) {
    const Attempt with_holes = try_layout(text, Layout::kWithHoles);
    // Neither fits: the one that got further is the likelier meaning.
    if (with_holes.error) {
      throw with_holes.reached > simple.reached ? *with_holes.error : *simple.error;
    }
    layout = Layout::kWithHoles;
  }
  Region region;
  DatReader(text, layout, &region).read();
  return region;
}

}  // namespace minksum::io
