// Reads the shapes of DXF drawings.
#include <map>
#include <set>

#include "io/drawing/dxf_shapes.hpp"
#include "io/drawing/notes.hpp"
#include "io/formats.hpp"

namespace minksum::io {
namespace {

/// Names of layers and blocks mean the same in any case.
std::string upper(std::string_view name) {
  std::string result(name);
  for (char& c : result) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return result;
}

std::string unit_of(int code) {
  static const std::map<int, std::string> kUnits = {
      {1, "in"},  {2, "ft"},  {3, "mi"},   {4, "mm"},  {5, "cm"}, {6, "m"},
      {7, "km"},  {8, "uin"}, {9, "mil"},  {10, "yd"}, {11, "A"}, {12, "nm"},
      {13, "um"}, {14, "dm"}, {15, "dam"}, {16, "hm"}};
  const auto found = kUnits.find(code);
  return found == kUnits.end() ? "not stated" : found->second;
}

struct Block {
  Point base;
  std::size_t position = 0;  ///< of its first entity
};

class DxfReader {
 public:
  DxfReader(std::string_view text, const ReadOptions& options)
      : given_(options),
        options_{.cancel = options.cancel},
        cancellation_(options_),
        tags_(text, cancellation_),
        outlines_(tags_.cursor(), options),
        shapes_(tags_, outlines_, options.drop_z),
        wanted_(upper(options.drawing.layer)) {}

  void read(GeometryBuilder& builder) {
    for (;;) {
      while (tags_.peek().code == 9) header();  // some programs end the header twice
      const DxfTag tag = tags_.next();
      if (tag.code == 0 && tag.value == "EOF") break;
      if (tag.code == 0 && tag.value == "ENDSEC") continue;
      if (tag.code != 0 || tag.value != "SECTION") {
        tags_.fail("expected a section, or the end of the drawing (EOF)", tag.position);
      }
      section(tags_.next());
    }
    if (!wanted_.empty() && !layers_seen_.contains(wanted_)) fail_no_layer();
    std::string remarks;
    with_place(tags_.cursor(), 0, [&] {
      const Joined joined = add_joined(std::move(shapes_.open), std::move(shapes_.closed),
                                       given_.drawing.join_ends, outlines_);
      outlines_.end(FillRule::kEvenOdd);
      const auto remark = [&remarks](const char* what, std::size_t count) {
        if (count == 0) return;
        remarks += (remarks.empty() ? "" : "; ") + std::string(what) + std::to_string(count);
      };
      remark("open outlines, which are lines: ", joined.open);
      remark("lines that are drawn again, and count once: ", joined.repeated);
    });
    finish(outlines_.take(), unit_, ignored_, remarks, builder);
  }

 private:
  void section(const DxfTag& name) {
    if (name.code != 2) tags_.fail("expected the name of a section, code 2", name.position);
    if (name.value == "HEADER") return header();
    if (name.value == "TABLES") return tables();
    if (name.value == "BLOCKS") return blocks();
    if (name.value == "ENTITIES") return entities("ENDSEC", {}, "0", 0);
    for (;;) {
      const DxfTag tag = tags_.next();
      if (tag.code == 0 && tag.value == "ENDSEC") return;
    }
  }

  void header() {
    for (DxfTag tag = tags_.next(); tag.code != 0; tag = tags_.next()) {
      if (tag.code != 9 || tag.value != "$INSUNITS") continue;
      unit_ = unit_of(tags_.integer(tags_.next()));
    }
  }

  void tables() {
    DxfEntity entity;
    for (;;) {
      tags_.next(entity);
      if (entity.type.value == "ENDSEC") return;
      if (entity.type.value == "EOF") tags_.fail("a section has no end", entity.type.position);
      if (entity.type.value != "LAYER") continue;
      const DxfValues values(tags_, entity);
      const bool frozen = (values.integer(70) & 1) != 0;
      if (frozen || values.integer(62) < 0) hidden_.insert(upper(values.text(2)));
    }
  }

  void blocks() {
    DxfEntity entity;
    for (;;) {
      tags_.next(entity);
      const std::string_view type = entity.type.value;
      if (type == "ENDSEC") return;
      if (type == "EOF") tags_.fail("a section has no end", entity.type.position);
      if (type != "BLOCK") continue;
      const DxfValues values(tags_, entity);
      blocks_[upper(values.text(2))] = {{values.number(10, 0), values.number(20, 0)},
                                        tags_.position()};
    }
  }

  /// Adds entities up to one of type `last`. Those on layer 0 of a block are on the layer of what
  /// inserts it.
  void entities(std::string_view last, const NearAffine& map, const std::string& layer, int depth) {
    DxfEntity entity;
    for (;;) {
      tags_.next(entity);
      const std::string_view type = entity.type.value;
      if (type == last) return;
      if (type == "EOF" || type == "ENDSEC") {
        tags_.fail("expected " + std::string(last), entity.type.position);
      }
      const std::size_t position = entity.type.position;
      outlines_.stand_at(position);
      with_place(tags_.cursor(), position, [&] { add(entity, map, layer, depth); });
    }
  }

  void add(const DxfEntity& entity, const NearAffine& map, const std::string& outer, int depth) {
    const std::string_view type = entity.type.value;
    if (type == "VERTEX" || type == "SEQEND" || type == "ENDBLK") return;
    const DxfValues values(tags_, entity);
    std::string layer = upper(values.text(8, "0"));
    if (layer == "0") layer = outer;
    layers_seen_.insert(layer);
    const bool is_insert = type == "INSERT";
    const char* skipped = nullptr;
    if (values.integer(67) == 1) skipped = "entities in paper space";
    if (values.integer(60) == 1 || hidden_.contains(layer)) skipped = "hidden entities";
    if (skipped != nullptr) {
      ++ignored_[skipped];
      return;
    }
    if (is_insert) return insert(values, entity, map, layer, depth);
    if (!wanted_.empty() && layer != wanted_) return;
    if (!shapes_.add(entity, map)) ++ignored_[std::string(type.substr(0, 40))];
  }

  void insert(const DxfValues& values, const DxfEntity& entity, const NearAffine& outer,
              const std::string& layer, int depth) {
    constexpr std::size_t kMostInserted = 1'000'000;  // blocks in blocks multiply
    const std::size_t position = entity.type.position;
    const auto found = blocks_.find(upper(values.text(2)));
    if (found == blocks_.end()) {
      tags_.fail("no block has the name '" + std::string(values.text(2).substr(0, 80)) + "'",
                 position);
    }
    const auto fail_limit = [&](const std::string& what) {
      tags_.cursor().fail(ErrorCode::kLimitExceeded, what, position);
    };
    if (depth >= given_.max_depth) {
      fail_limit("blocks are nested deeper than the limit of " + std::to_string(given_.max_depth));
    }
    shapes_.check_flat(entity);
    const Block& block = found->second;
    const auto scale = [&](int code) { return values.number(code, 1); };
    if (values.number(210, 0).sign() != 0 || values.number(220, 0).sign() != 0) {
      tags_.fail("an entity is not drawn in the plane of x and y", position);
    }
    const bool mirrored = values.number(230, 1).sign() < 0;
    const NearAffine own = mirrored ? NearAffine{Affine{-1, {}, {}, {}, 1, {}}} : NearAffine{};
    const NearAffine turn = NearAffine::rotation(values.number(50, 0));
    const NearAffine content = NearAffine{Affine{scale(41), {}, {}, {}, scale(42), {}}}.after(
        {Affine::translation(-block.base.x, -block.base.y)});
    const int columns = std::max(values.integer(70, 1), 1);
    const int rows = std::max(values.integer(71, 1), 1);
    const std::size_t here = tags_.position();
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        if (++inserted_ > kMostInserted) fail_limit("blocks are inserted more than 1000000 times");
        const NearAffine cell{Affine::translation(Rational(column) * values.number(44, 0),
                                                  Rational(row) * values.number(45, 0))};
        const NearAffine at{Affine::translation(values.number(10), values.number(20))};
        tags_.move_to(block.position);
        entities("ENDBLK", outer.after(own).after(at).after(turn).after(cell).after(content), layer,
                 depth + 1);
      }
    }
    tags_.move_to(here);
  }

  [[noreturn]] void fail_no_layer() const {
    constexpr std::size_t kMostNamed = 20;
    std::string names;
    std::size_t count = 0;
    for (const std::string& layer : layers_seen_) {
      if (++count > kMostNamed) break;
      names += (names.empty() ? "" : ", ") + layer.substr(0, 80);
    }
    if (layers_seen_.size() > kMostNamed) names += ", ...";
    throw ReadError(ErrorCode::kBadInput,
                    "nothing is drawn on the layer '" + given_.drawing.layer +
                        "' (io::DrawingOptions::layer); there are: " + names,
                    1, 1);
  }

  const ReadOptions& given_;
  Options options_;
  Cancellation cancellation_;
  DxfTags tags_;
  Outlines outlines_;
  DxfShapes shapes_;
  std::string wanted_;
  std::string unit_ = "not stated";
  std::map<std::string, Block> blocks_;
  std::set<std::string> hidden_;
  std::set<std::string> layers_seen_;
  Ignored ignored_;
  std::size_t inserted_ = 0;
};

}  // namespace

void read_dxf(std::string_view text, const ReadOptions& options, GeometryBuilder& builder) {
  DxfReader(text, options).read(builder);
}

}  // namespace minksum::io
