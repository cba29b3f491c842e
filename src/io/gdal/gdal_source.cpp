// Reads what GDAL has handed over. A file may pretend to be that, so lengths are checked.
#include <algorithm>
#include <cstring>

#include "io/formats.hpp"
#include "io/gdal/flattened.hpp"
#include "io/gdal/gdal.hpp"
#include "io/gdal/records.hpp"
#include "io/json_string.hpp"
#include "io/text_cursor.hpp"

namespace minksum::io {

namespace {

class GdalSource : public FeatureSource {
 public:
  GdalSource(std::string_view text, const ReadOptions& options, Rules rules)
      : FeatureSource(options, rules),
        cursor_(text, TextCursor::Counts::kBytes),
        options_(options) {
    builder_.follow(cursor_);
    cursor_.advance(gdal::kMark.size());
    take_system();
  }

  [[nodiscard]] std::string properties() const override { return std::string(properties_); }
  [[nodiscard]] std::string id() const override { return std::string(id_); }
  [[nodiscard]] bool has_lines() const override { return false; }

 private:
  bool read_next() override {
    if (cursor_.at_end()) return false;
    start_ = cursor_.position();
    ++count_;
    const auto lengths = take<gdal::Lengths>();
    id_ = take_text(lengths.id);
    properties_ = take_text(lengths.properties);
    const std::string_view wkb = take_text(lengths.wkb);
    is_null_ = wkb.empty();
    if (is_null_) return true;
    try {
      read_wkb(wkb, options_, builder_);
    } catch (const ReadError& error) {
      // The byte is one of the WKB, which the user never sees.
      std::string message = error.what();
      if (message.starts_with("byte ")) message.erase(0, message.find(": ") + 2);
      const auto names = [&message](std::string_view word) {
        return message.find(word) != std::string::npos;
      };
      const bool is_curve = names("CURVE") || names("CIRCULARSTRING") || names("MULTISURFACE");
      if (is_curve && names(gdal::kNotSupported)) message += gdal::kFlattenFirst;
      throw ReadError(error.code(), "feature " + std::to_string(count_) + ": " + message, 0, 0,
                      error.limit());
    }
    builder_.follow(cursor_);
    return true;
  }

  void take_system() {
    const auto system = take<gdal::System>();
    const std::string code(take_text(system.code));
    builder_.set_srid(std::max(system.number, 0), cursor_.position());
    if (system.number == gdal::System::kUnnamed) {
      builder_.source().remarks = "the reference system has no number, and no result names it";
    }
    if (code.empty()) return;
    if (!is_utf8(code)) cursor_.fail("the reference system is not UTF-8");
    builder_.set_crs(R"({"type": "name", "properties": {"name": )" +
                         json_string("urn:ogc:def:crs:" + code) + "}}",
                     cursor_.position());
  }

  template <class Value>
  Value take() {
    Value value;
    std::memcpy(&value, take_text(sizeof(Value)).data(), sizeof(Value));
    return value;
  }

  std::string_view take_text(std::uint64_t length) {
    if (length > cursor_.rest().size()) cursor_.fail("the features of a file are cut");
    const std::string_view text = cursor_.rest().substr(0, length);
    cursor_.advance(length);
    return text;
  }

  TextCursor cursor_;
  const ReadOptions& options_;
  std::string_view id_;
  std::string_view properties_;
  std::size_t count_ = 0;
};

}  // namespace

bool looks_like_gdal_features(std::string_view text) { return text.starts_with(gdal::kMark); }

std::unique_ptr<FeatureSource> gdal_source(std::string_view text, const ReadOptions& options,
                                           Rules rules) {
  return std::make_unique<GdalSource>(text, options, rules);
}

}  // namespace minksum::io
