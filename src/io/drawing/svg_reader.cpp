// Reads the shapes of SVG documents.
#include <algorithm>
#include <map>

#include "io/drawing/svg_style.hpp"
#include "io/drawing/svg_values.hpp"
#include "io/formats.hpp"

namespace minksum::io {
namespace {

/// Elements that are drawn only where others refer to them, or that have no shape.
constexpr std::string_view kUndrawn[] = {
    "defs",         "symbol",         "clipPath", "mask",   "pattern",
    "marker",       "linearGradient", "filter",   "title",  "desc",
    "metadata",     "radialGradient", "style",    "script", "a11y",
    "cursor",       "view",           "animate",  "set",    "animateTransform",
    "animateMotion"};
constexpr std::string_view kGroups[] = {"g", "a", "switch"};

template <class List>
bool is_one_of(std::string_view name, const List& list) {
  return std::find(std::begin(list), std::end(list), name) != std::end(list);
}

/// An element with what its reader asks for.
struct Element {
  std::size_t index;
  std::string_view name;
  std::vector<XmlAttribute> attributes;

  [[nodiscard]] const XmlAttribute* find(std::string_view wanted) const {
    for (const XmlAttribute& attribute : attributes) {
      if (attribute.name == wanted) return &attribute;
    }
    return nullptr;
  }
};

struct State {
  NearAffine map;
  SvgStyle style;
  std::optional<Point> viewport;  ///< the size of the coordinate system around, if it is known
};

class SvgReader {
 public:
  SvgReader(std::string_view text, const ReadOptions& limits)
      : limits_(limits),
        options_{.cancel = limits.cancel},
        cancellation_(options_),
        document_(text, limits.max_depth, cancellation_),
        outlines_(document_.cursor(), limits) {}

  void read(GeometryBuilder& builder) {
    for (std::size_t i = 0; i < document_.elements().size(); ++i) {
      cancellation_.check(16);
      if (document_.name(i) == "style") add_sheet(i);
    }
    const Element root = element(0);
    State state;
    state.map = of_root(root);
    state.viewport = viewport_of_root(root);
    if (root.find("transform") != nullptr) ++ignored_["transform of the root"];
    state.style = styles_.style_of({}, root.name, root.attributes, ignored_);
    if (!state.style.removed) children(0, state, 0);
    finish(outlines_.take(), unit_, ignored_, {}, builder);
  }

 private:
  [[nodiscard]] Element element(std::size_t index) const {
    return {index, document_.name(index), document_.attributes(index)};
  }
  [[noreturn]] void fail(const std::string& message, std::size_t position) const {
    document_.cursor().fail(ErrorCode::kBadInput, message, position);
  }
  [[nodiscard]] std::size_t position_of(const Element& e) const {
    return document_.elements()[e.index].position;
  }

  void add_sheet(std::size_t index) {
    for (const XmlAttribute& attribute : document_.attributes(index)) {
      if (attribute.name != "media" || attribute.value == "all" || attribute.value == "screen") {
        continue;
      }
      ++ignored_["style sheet for other media"];
      return;
    }
    styles_.add(document_.content(index), ignored_);
  }

  /// Returns a length in units of the user: px, or millimetres as 96 px to the inch.
  [[nodiscard]] Rational length(const Element& e, std::string_view name,
                                const Rational& missing = {}) const {
    const XmlAttribute* const attribute = e.find(name);
    if (attribute == nullptr) return missing;
    const auto [value, unit] = take_length(document_.cursor_on(*attribute));
    if (unit.empty() || unit == "px") return value;
    const bool across = name.find('x') != std::string_view::npos || name == "width";
    const bool down = name.find('y') != std::string_view::npos || name == "height";
    if (unit == "%" && viewport_ && (across || down)) {
      return value / Rational(100) * (across ? viewport_->x : viewport_->y);
    }
    if (const auto size = millimetres(unit)) return value * *size * Rational(480, 127);
    fail("the unit '" + std::string(unit) + "' depends on what is around the element: use px or mm",
         attribute->position);
  }

  [[nodiscard]] Point point(const Element& e, std::string_view x, std::string_view y) const {
    return {length(e, x), length(e, y)};
  }
  [[nodiscard]] NearAffine moved_to(const Element& e, const NearAffine& map) const {
    const Point at = point(e, "x", "y");
    return map.after({Affine::translation(at.x, at.y)});
  }

  /// The whole picture points upwards: y becomes -y. If its width has a unit, that is the unit.
  NearAffine of_root(const Element& root) {
    unit_ = "px";
    const NearAffine flipped{Affine{1, {}, {}, {}, -1, {}}};
    const XmlAttribute* const width = root.find("width");
    const XmlAttribute* const box = root.find("viewBox");
    std::optional<Length> size;
    if (width != nullptr && width->value != "auto") size = take_length(document_.cursor_on(*width));
    const auto physical = size ? millimetres(size->unit) : std::nullopt;
    if (!physical) return flipped;
    unit_ = size->unit;
    Rational x = Rational(127, 480) / *physical;  // of px
    Rational y = x;
    if (box != nullptr) {
      const std::vector<Rational> view = view_box(*box);
      if (size->value.sign() <= 0) fail("the width must be positive", width->position);
      x = y = size->value / view[2];
      if (const XmlAttribute* const height = root.find("height")) {
        const Length high = take_length(document_.cursor_on(*height));
        if (const auto millimetre = millimetres(high.unit)) {
          y = high.value * *millimetre / *physical / view[3];
          if (y.sign() <= 0) fail("the height must be positive", height->position);
          fit(root, x, y);
        }
      }
    }
    return NearAffine{Affine{x, {}, {}, {}, y, {}}}.after(flipped);
  }

  /// Makes both scales equal, unless the element says otherwise.
  static void fit(const Element& e, Rational& x, Rational& y) {
    const XmlAttribute* const how = e.find("preserveAspectRatio");
    const std::string_view said = how == nullptr ? "" : how->value;
    if (said.find("none") != std::string_view::npos) return;
    x = y = said.find("slice") != std::string_view::npos ? std::max(x, y) : std::min(x, y);
  }

  [[nodiscard]] std::vector<Rational> view_box(const XmlAttribute& attribute) const {
    std::vector<Rational> view = take_numbers(document_.cursor_on(attribute));
    if (view.size() != 4 || view[2].sign() <= 0 || view[3].sign() <= 0) {
      fail("a viewBox has four numbers, the last two of which are positive", attribute.position);
    }
    return view;
  }

  [[nodiscard]] std::optional<Point> viewport_of_root(const Element& root) const {
    if (const XmlAttribute* const box = root.find("viewBox")) {
      const std::vector<Rational> view = view_box(*box);
      return Point{view[2], view[3]};
    }
    const auto side = [&](std::string_view name) -> std::optional<Rational> {
      const XmlAttribute* const attribute = root.find(name);
      if (attribute == nullptr || attribute->value == "auto" || attribute->value.ends_with('%')) {
        return {};
      }
      return length(root, name);
    };
    const std::optional<Rational> wide = side("width");
    const std::optional<Rational> high = side("height");
    return wide && high ? std::optional(Point{*wide, *high}) : std::nullopt;
  }

  /// Returns a side of the frame of an inner `svg` or a `symbol`, which is that of the viewport
  /// around, unless something else is said by the element or by the `use` that draws it.
  [[nodiscard]] Rational side_of_frame(const Element& e, const Element* use, std::string_view name,
                                       const Rational* around) const {
    Rational share(1);
    for (const Element* const said : {use, &e}) {
      const XmlAttribute* const attribute = said == nullptr ? nullptr : said->find(name);
      if (attribute == nullptr || attribute->value == "auto") continue;
      const auto [value, unit] = take_length(document_.cursor_on(*attribute));
      if (value.sign() < 0) fail("the size of a frame is negative", attribute->position);
      if (unit != "%") return length(*said, name);
      share = value / Rational(100);
      break;
    }
    if (around != nullptr) return share * *around;
    fail("the size of the frame is not known: it needs a width and a height, or the root does",
         position_of(e));
  }

  /// Places the content of an inner `svg` or a `symbol` into its frame. Returns false if there is
  /// nothing to draw.
  bool enter_frame(const Element& e, const Element* use, State& state) {
    if (e.name == "svg") state.map = moved_to(e, state.map);
    const XmlAttribute* const box = e.find("viewBox");
    // The size is needed for the scale alone.
    if (!state.viewport && box == nullptr) return true;
    const Point* const around = state.viewport ? &*state.viewport : nullptr;
    const Rational wide = side_of_frame(e, use, "width", around ? &around->x : nullptr);
    const Rational high = side_of_frame(e, use, "height", around ? &around->y : nullptr);
    state.viewport = Point{wide, high};
    if (wide.sign() == 0 || high.sign() == 0) return false;
    if (box == nullptr) return true;
    const std::vector<Rational> view = view_box(*box);
    Rational x = wide / view[2];
    Rational y = high / view[3];
    fit(e, x, y);
    // By default the content is in the middle of its frame.
    const XmlAttribute* const place = e.find("preserveAspectRatio");
    if (x == y && place != nullptr && place->value.find("xMidYMid") == std::string_view::npos) {
      ++ignored_["preserveAspectRatio"];
    }
    const Rational left = (wide - x * view[2]) / Rational(2) - x * view[0];
    const Rational top = (high - y * view[3]) / Rational(2) - y * view[1];
    state.map = state.map.after({Affine{x, {}, left, {}, y, top}});
    state.viewport = Point{view[2], view[3]};
    return true;
  }

  void children(std::size_t parent, const State& state, int depth) {
    const auto& elements = document_.elements();
    for (std::size_t i = parent + 1; i < elements[parent].next; i = elements[i].next) {
      // The first child that may be drawn is the only one of a switch.
      if (draw(i, state, depth) && document_.name(parent) == "switch") break;
    }
  }

  /// Draws an element in its place, or for the `user` that refers to it. Returns false if it is
  /// nothing that is drawn, or if its own conditions do not let it be.
  bool draw(std::size_t index, State state, int depth, const Element* user = nullptr) {
    constexpr std::size_t kMostUsed = 100'000;  // symbols in symbols multiply
    cancellation_.check(256);
    const Element e = element(index);
    const bool used_symbol = user != nullptr && e.name == "symbol";
    const bool is_foreign = e.name.find(':') != std::string_view::npos;
    if (is_foreign || (is_one_of(e.name, kUndrawn) && !used_symbol)) return false;
    for (const char* const condition : {"systemLanguage", "requiredExtensions"}) {
      if (e.find(condition) == nullptr) continue;
      ++ignored_[condition];
      return false;
    }
    if (depth > 0 && ++used_ > kMostUsed) {
      document_.cursor().fail(ErrorCode::kLimitExceeded,
                              "'use' draws more elements than the limit of 100000", position_of(e));
    }
    state.style = styles_.style_of(state.style, e.name, e.attributes, ignored_);
    if (state.style.removed) return true;
    viewport_ = state.viewport;
    const auto own = take_transform(document_, e.attributes);
    if (own) state.map = state.map.after(*own);
    if (e.name == "svg" || used_symbol) {
      if (enter_frame(e, user, state)) children(index, state, depth);
    } else if (is_one_of(e.name, kGroups)) {
      children(index, state, depth);
    } else if (e.name == "use") {
      use(e, state, depth);
    } else if (!state.style.hidden) {
      with_place(document_.cursor(), position_of(e), [&] { shape(e, state); });
    }
    return true;
  }

  void use(const Element& e, State state, int depth) {
    if (++depth > limits_.max_depth) {
      document_.cursor().fail(ErrorCode::kLimitExceeded,
                              "elements refer to each other deeper than the limit of " +
                                  std::to_string(limits_.max_depth),
                              position_of(e));
    }
    const auto is_link = [](const XmlAttribute& a) {  // of XLink, by whatever name, or of SVG 2
      return a.name == "href" || a.name.ends_with(":href");
    };
    const auto href = std::find_if(e.attributes.begin(), e.attributes.end(), is_link);
    if (href == e.attributes.end()) return;
    if (ids_.empty()) find_ids();
    const bool here = href->value.starts_with('#');
    const auto found = here ? ids_.find(href->value.substr(1)) : ids_.end();
    if (found == ids_.end()) {
      ++ignored_[here ? "use of an element that there is not" : "use of another document"];
      return;
    }
    state.map = moved_to(e, state.map);
    draw(found->second, state, depth, &e);
  }

  void find_ids() {
    for (std::size_t i = 0; i < document_.elements().size(); ++i) {
      for (const XmlAttribute& attribute : document_.attributes(i)) {
        cancellation_.check(64);
        if (attribute.name == "id") ids_.emplace(attribute.value, i);
      }
    }
  }

  void shape(const Element& e, const State& state) {
    outlines_.stand_at(position_of(e));
    outlines_.set_map(state.map);
    const bool filled = state.style.filled;
    if (e.name == "path") {
      if (const XmlAttribute* const d = e.find("d")) {
        take_path(document_.cursor_on(*d), filled, outlines_);
      }
    } else if (e.name == "rect") {
      box(e);
    } else if (e.name == "circle" || e.name == "ellipse") {
      const bool round = e.name == "circle";
      const Rational rx = round ? length(e, "r") : radius(e, "rx", "ry");
      const Rational ry = round ? rx : radius(e, "ry", "rx");
      if (rx.sign() < 0 || ry.sign() < 0) fail("a radius is negative", position_of(e));
      const Point at = point(e, "cx", "cy");
      if (rx.sign() > 0 && ry.sign() > 0) {
        add_rounded_box({at.x - rx, at.y - ry}, {at.x + rx, at.y + ry}, rx, ry, outlines_);
      }
    } else if (e.name == "line") {
      outlines_.move_to(point(e, "x1", "y1"));
      outlines_.line_to(point(e, "x2", "y2"));
      outlines_.end_polyline();
    } else if (e.name == "polygon" || e.name == "polyline") {
      points(e, filled);
    } else {
      ++ignored_[std::string(e.name.substr(0, 40))];
      return;
    }
    outlines_.end(state.style.even_odd ? FillRule::kEvenOdd : FillRule::kNonZero);
  }

  /// Returns a radius, which is the other one if it is not said.
  [[nodiscard]] Rational radius(const Element& e, std::string_view own,
                                std::string_view other) const {
    for (const std::string_view name : {own, other}) {
      const XmlAttribute* const found = e.find(name);
      if (found != nullptr && found->value != "auto") return length(e, name);
    }
    return {};
  }

  void box(const Element& e) {
    const auto [wide, high] = point(e, "width", "height");
    if (wide.sign() < 0 || high.sign() < 0) fail("a rectangle's size is negative", position_of(e));
    if (wide.sign() == 0 || high.sign() == 0) return;
    const Rational rx = std::min(radius(e, "rx", "ry"), wide / Rational(2));
    const Rational ry = std::min(radius(e, "ry", "rx"), high / Rational(2));
    if (rx.sign() < 0 || ry.sign() < 0) fail("a radius is negative", position_of(e));
    const Point low = point(e, "x", "y");
    add_rounded_box(low, {low.x + wide, low.y + high}, rx, ry, outlines_);
  }

  void points(const Element& e, bool filled) {
    const XmlAttribute* const attribute = e.find("points");
    if (attribute == nullptr) return;
    const std::vector<Rational> numbers = take_numbers(document_.cursor_on(*attribute));
    if (numbers.size() % 2 != 0) fail("an odd number of coordinates", attribute->position);
    const std::size_t count = numbers.size() / 2;
    for (std::size_t i = 0; i < count; ++i) {
      const Point point{numbers[2 * i], numbers[2 * i + 1]};
      if (i == 0) {
        outlines_.move_to(point);
      } else {
        outlines_.line_to(point);
      }
    }
    if (count == 0) return;
    const bool closed =
        e.name == "polygon" || filled ||
        (numbers[0] == numbers[2 * count - 2] && numbers[1] == numbers[2 * count - 1]);
    if (closed) {
      outlines_.end_ring();
    } else {
      outlines_.end_polyline();
    }
  }

  const ReadOptions& limits_;
  Options options_;
  Cancellation cancellation_;
  XmlDocument document_;
  Outlines outlines_;
  SvgStyles styles_;
  Ignored ignored_;
  std::string unit_;
  std::map<std::string_view, std::size_t> ids_;
  std::size_t used_ = 0;           ///< elements drawn by `use`
  std::optional<Point> viewport_;  ///< of which lengths in per cent are parts
};

}  // namespace

void read_svg(std::string_view text, const ReadOptions& options, GeometryBuilder& builder) {
  SvgReader(text, options).read(builder);
}

}  // namespace minksum::io
